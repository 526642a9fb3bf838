//! The value of a position for a team, in coins.

use glam::DVec2;

use super::hand::Hand;
use super::shots::{PocketPath, Unchecked, allowance, ghost, most_allowed, strike, to_the_pockets};
use super::sight::{ROUNDING, Sight};
use super::strength::Skill;
use super::wants::wants_from;
use crate::game::laws::Rules;
use crate::game::{BaseLines, Game, Seat, Team};

/// The value of a won board, without its points.
const BOARD: f64 = 20.0;
/// The value of the queen once she is covered.
const QUEEN: f64 = 2.5;
/// The value of a point in point carrom, in which a coin counts 1.5 points on average.
const POINT: f64 = 1.0 / 1.5;
/// The value of a sure coin to the side that strikes next: the coin falls, and the turn continues.
const TO_STRIKE: f64 = 1.6;
/// The value of a sure coin to the side that has to wait: the coin may still be there at that
/// side's next stroke.
const TO_WAIT: f64 = 0.5;
/// The board is evaluated from this number of striker positions between the base circles, and from
/// the two on the circles.
const PLACES: u16 = 7;

/// How a position is evaluated.
#[derive(Debug, Clone, Copy)]
pub(super) struct Judge {
    pub(super) team: Team,
    /// The assumed ability of both sides.
    pub(super) skill: Skill,
}

impl Judge {
    /// The value of `game` for the team.
    pub(super) fn worth(&self, game: &Game) -> f64 {
        if let Some(won) = game.play().won {
            return self.sign(won.winner) * (BOARD + f64::from(won.points));
        }
        if game.setup().rules.is_alone() {
            // There is no opponent: all coins belong to the player.
            return self.prospect(game, game.seat()) * TO_STRIKE - game.coins().len() as f64;
        }
        let play = game.play();
        let counted = |team| {
            if game.setup().rules == Rules::Points {
                return self.sign(team) * POINT * f64::from(play.points_taken(team));
            }
            let left = play.on_board(game.colour(team)) + play.owed[team];
            let queen = play.queen_covered_by == Some(team);
            self.sign(team) * (if queen { QUEEN } else { 0.0 } - f64::from(left))
        };
        counted(self.team) + counted(self.team.other()) + self.prospects(game)
    }

    /// 1 for the team whose value is computed, −1 for the other team.
    fn sign(&self, team: Team) -> f64 {
        if team == self.team { 1.0 } else { -1.0 }
    }

    /// The expected value of the next strokes of both sides.
    fn prospects(&self, game: &Game) -> f64 {
        let (seat, next) = (game.seat(), game.setup().hands.next(game.seat()));
        let sign = |seat| self.sign(game.team(seat));
        let first = self.prospect(game, seat);
        let queen = if game.play().queen_to_cover() {
            QUEEN * first
        } else {
            0.0
        };
        sign(seat) * (TO_STRIKE * first + queen) + sign(next) * TO_WAIT * self.prospect(game, next)
    }

    /// The probability, from 0 to 1, that the player at `seat` pockets something with the easiest
    /// direct shot.
    fn prospect(&self, game: &Game, seat: Seat) -> f64 {
        if !self.skill.looks_ahead {
            return 0.0;
        }
        let sight = Sight::of(game);
        let places = BaseLines::new(sight.set, seat, sight.coins).candidates(PLACES);
        let first = places.first().copied().unwrap_or_default();
        let across = seat.turn(DVec2::Y);
        let wanted = game.coins().iter().enumerate();
        let wanted = wanted.filter(|(_, coin)| wants_from(game, seat, coin.piece));
        let mut easiest = 0.0;
        for (coin, _) in wanted {
            for course in to_the_pockets(&sight, coin) {
                // All positions are on one line, and most courses are too hard from all of them.
                let near = |ghost: DVec2| (ghost - first).dot(across).abs();
                let ghost = ghost(&sight, &course.link).filter(|ghost| {
                    ROUNDING * most_allowed(&sight, &course.link, near(*ghost)) > easiest
                });
                if let Some(ghost) = ghost {
                    easiest = easiest_of(&sight, &course, ghost, &places, easiest);
                }
            }
        }
        likelihood(easiest, self.skill.hand)
    }
}

/// The tolerance of the easiest stroke that gives a coin this course from `ghost`, or `easiest` if
/// no stroke is easier. A stroke's path is checked only if the stroke is easier.
fn easiest_of(
    sight: &Sight,
    course: &Unchecked<PocketPath>,
    ghost: DVec2,
    places: &[DVec2],
    easiest: f64,
) -> f64 {
    let mut easiest = easiest;
    let mut open = None;
    for &from in places {
        if ROUNDING * allowance(sight, &course.link, from, ghost) <= easiest {
            continue;
        }
        let aim = strike(sight, &course.link, from, ghost);
        if let Some(aim) = aim.filter(|aim| aim.link.allowance > easiest)
            && *open.get_or_insert_with(|| course.is_clear(sight))
            && aim.is_clear(sight)
        {
            easiest = aim.link.allowance;
        }
    }
    easiest
}

/// The approximate probability that a normally distributed error is within `allowance`: 0.67 and
/// 0.89 at one and two standard deviations (the exact values are 0.68 and 0.95).
fn likelihood(allowance: f64, hand: Hand) -> f64 {
    let deviations = allowance / hand.direction;
    let square = deviations * deviations;
    if square.is_finite() {
        square / (square + 0.5)
    } else {
        1.0
    }
}
