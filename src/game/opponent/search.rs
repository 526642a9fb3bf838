//! Chooses a stroke: geometry proposes strokes, the engine plays them, and the value of the result
//! decides.

use std::ops::Range;

use glam::DVec2;
use rand::RngExt;
use rand_pcg::Pcg64;

use super::hand::{FASTEST, Slip};
use super::rehearsal::Rehearsal;
use super::shots::{
    PocketPath, ProposedStroke, combinations, kicks, knocks, off_a_cushion, straight, strikes,
};
use super::sight::Sight;
use super::story::Chance;
use super::strength::Skill;
use super::wants::wants;
use super::worth::Judge;
use crate::game::Game;
use crate::game::steps::on_steps;
use crate::physics::Motion;

/// The number of aims kept for one course: neighbouring positions give nearly the same shot.
const AIMS_A_COURSE: usize = 4;
/// The number of courses for which combinations are sought.
const DRIVEN: usize = 12;
/// Speeds of a break in m/s.
const BREAK: Range<f64> = 2.8..FASTEST;
/// Speeds of all other strokes that are not aimed at a pocket, in m/s.
const KNOCK: Range<f64> = 0.6..3.0;

/// A stroke, its expected value, and how often it worked in the rehearsals.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Candidate {
    pub(super) motion: Motion,
    worth: f64,
    pub(super) chance: Chance,
    /// Whether the striker falls if the stroke is exact; false if the exact stroke was not tried.
    pub(super) fouls: bool,
    /// The minimum range of directions, in radians, that the search for a better stroke covers.
    allowance: f64,
}

/// The search for one stroke.
pub(super) struct Search<'a> {
    pub(super) game: &'a Game,
    pub(super) skill: Skill,
    pub(super) judge: Judge,
    pub(super) rehearsal: Rehearsal<'a>,
    pub(super) chance: Pcg64,
}

impl Search<'_> {
    /// The best stroke from a legal position; `None` if coins block all legal positions.
    pub(super) fn best(&mut self) -> Option<Candidate> {
        let places = self.places();
        let resort = Motion::new(*places.first()?, self.game.seat().turn(DVec2::Y));
        let mut choices = self.first_look(&places);
        choices.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        if self.skill.on_steps && choices.iter().any(|choice| !choice.fouls) {
            choices.retain(|choice| !choice.fouls);
        }
        Some(self.finalist(&choices).unwrap_or(Candidate {
            motion: resort,
            ..Candidate::default()
        }))
    }

    /// Positions along the base lines; if coins block all of them, the free position nearest to the
    /// middle.
    fn places(&self) -> Vec<DVec2> {
        let lines = self.game.base_lines();
        let mut places = lines.candidates(self.skill.places);
        if self.skill.on_steps {
            let on_steps = places.iter().filter_map(|at| lines.nearest_on_steps(*at));
            places = on_steps.collect();
            places.dedup();
        }
        if places.is_empty() {
            places.extend(lines.nearest(lines.at(0.0)));
        }
        places
    }

    /// The strokes that geometry proposes, each tried once without errors.
    fn first_look(&mut self, places: &[DVec2]) -> Vec<Candidate> {
        let mut proposed: Vec<(Motion, f64)> = Vec::new();
        for aim in self.aims(places) {
            let speeds = self.skill.speeds.iter();
            let strokes = speeds.map(|times| (aim.motion(*times), aim.allowance));
            let playable = strokes.filter(|(motion, _)| motion.velocity.length() <= FASTEST);
            proposed.extend(playable);
        }
        let sight = Sight::of(self.game);
        let speeds = if self.game.play().is_unbroken() {
            BREAK
        } else {
            KNOCK
        };
        let knocks = knocks(&sight, places, self.skill.knocks, &speeds, &mut self.chance);
        proposed.extend(knocks.into_iter().map(|motion| (motion, 0.0)));
        proposed
            .into_iter()
            .filter_map(|(motion, allowance)| self.tried(motion, allowance, &[Slip::default()]))
            .collect()
    }

    /// The aims with the largest tolerance, the largest first; of each course, those that are not
    /// blocked and have the largest tolerances.
    fn aims(&self, places: &[DVec2]) -> Vec<ProposedStroke> {
        let sight = Sight::of(self.game);
        let mut aims = Vec::new();
        for course in self.courses(&sight) {
            let mut own: Vec<_> = strikes(&sight, &course, places).collect();
            let behind = self.straight_place(&course);
            own.extend(strikes(&sight, &course, behind.as_slice()));
            if self.skill.cushions {
                own.extend(kicks(&sight, &course, places));
            }
            own.sort_by(|a, b| b.link.allowance.total_cmp(&a.link.allowance));
            let clear = own.into_iter().filter_map(|aim| aim.if_clear(&sight));
            aims.extend(clear.take(AIMS_A_COURSE));
        }
        aims.sort_by(|a, b| b.allowance.total_cmp(&a.allowance));
        aims.truncate(self.skill.aims);
        aims
    }

    fn courses(&self, sight: &Sight) -> Vec<PocketPath> {
        let coins = self.game.coins().iter().enumerate();
        let wanted = coins.filter(|(_, coin)| wants(self.game, coin.piece));
        let mut courses = Vec::new();
        for (i, _) in wanted {
            courses.extend(straight(sight, i));
            if self.skill.cushions {
                courses.extend(off_a_cushion(sight, i));
            }
        }
        if self.skill.combinations {
            courses.sort_by(|a, b| b.allowance.total_cmp(&a.allowance));
            let driven = courses.iter().take(DRIVEN);
            let driving: Vec<PocketPath> = driven.flat_map(|c| combinations(sight, c)).collect();
            courses.extend(driving);
        }
        courses
    }

    /// The position from which a course requires a full, straight hit, or the legal position
    /// nearest to it.
    fn straight_place(&self, course: &PocketPath) -> Option<DVec2> {
        let lines = self.game.base_lines();
        let seat = self.game.seat();
        let coin = seat.turn_back(self.game.coins().get(course.coin)?.at);
        let way = seat.turn_back(course.toward);
        let back = (coin.y - lines.middle()) / way.y;
        let along = coin.x - way.x * back;
        let there = (back > 0.0 && along.is_finite()).then(|| lines.at(along))?;
        if self.skill.on_steps {
            lines.nearest_on_steps(there)
        } else {
            lines.nearest(there)
        }
    }

    /// The best of the sorted choices for an unsteady hand; all are tried with the same errors, so
    /// that luck does not decide.
    fn finalist(&mut self, choices: &[Candidate]) -> Option<Candidate> {
        let count = self.skill.slips;
        let mut slips: Vec<Slip> = (0..count)
            .map(|_| self.skill.hand.slip(&mut self.chance))
            .collect();
        if self.skill.is_exact {
            // A player with an exact hand plays the stroke exactly as it is set.
            slips[..1.min(count)].fill(Slip::default());
        }
        let finalists = choices.iter().take(self.skill.finalists);
        let tried = finalists.filter_map(|c| self.tried(c.motion, c.allowance, &slips));
        let best = tried.max_by(|a, b| a.worth.total_cmp(&b.worth));
        let mut best = best.or_else(|| choices.first().copied())?;
        for _ in 0..self.skill.refinements {
            let allowance = best.allowance.max(self.skill.hand.direction);
            let change = Slip {
                turn: allowance * (self.chance.random::<f64>() - 0.5),
                push: 0.5 * (self.chance.random::<f64>() - 0.4),
            };
            let changed = self.tried(change.applied_to(best.motion), best.allowance, &slips);
            let is_better = |changed: &Candidate| {
                changed.worth > best.worth && !(self.skill.on_steps && changed.fouls)
            };
            if let Some(better) = changed.filter(is_better) {
                best = better;
            }
        }
        Some(best)
    }

    /// The average value of a stroke over these errors.
    fn tried(&mut self, motion: Motion, allowance: f64, slips: &[Slip]) -> Option<Candidate> {
        let motion = if self.skill.on_steps {
            on_steps(motion, self.game.seat())?
        } else {
            motion
        };
        let mut sum = 0.0;
        let mut chance = Chance::default();
        let mut fouls = false;
        for slip in slips {
            let tried = self.rehearsal.play(slip.applied_to(motion))?;
            sum += self.judge.worth(&tried.after);
            chance.count(tried.pocketed);
            fouls |= tried.fouled && *slip == Slip::default();
        }
        if self.skill.on_steps && !slips.contains(&Slip::default()) {
            fouls = self.rehearsal.play(motion)?.fouled;
        }
        (chance.of > 0).then(|| Candidate {
            motion,
            worth: sum / f64::from(chance.of),
            chance,
            fouls,
            allowance,
        })
    }
}
