//! The kinds of hit in questions that ask "where will they go?", from easy to hard.

use std::sync::OnceLock;

use strum::VariantArray;

use super::hit_draws::{ALL, EQUAL, NO_LOSS, direction_deg};
use crate::numbers::tenths;
use crate::physics::ImpactPoint;
use crate::physics::units::{deg_from_rad, rad_from_deg};
use crate::quiz::misconceptions::OF_RAYS;
use crate::quiz::question::{
    Dice, Difficulty, Hit, MIN_SEPARATION, Pieces, RIGHT_DEG, Rays, nearest,
};

#[derive(Debug, Clone, Copy, PartialEq, Eq, VariantArray)]
pub(super) enum HitKind {
    /// Equal masses, α given.
    EqualAngle,
    /// Equal masses, offset given.
    EqualOffset,
    /// Heavier striker, α given.
    TournamentAngle,
    /// Heavier target, α given.
    MarblesAngle,
    /// Equal masses and e < 1, α given.
    LossyAngle,
    /// Head-on, with any pieces.
    HeadOn,
    /// Heavier striker, offset given.
    TournamentOffset,
    /// Heavier target, offset given.
    MarblesOffset,
    /// Heavier target and e < 1, α given.
    LossyMarbles,
}

/// The kinds of hit in a round at each difficulty. The more often a kind is listed, the more often
/// it occurs.
pub(super) const KINDS: [&[HitKind]; 3] = {
    use HitKind::*;
    [
        &[EqualAngle, EqualAngle, EqualOffset],
        &[TournamentAngle, MarblesAngle, LossyAngle, HeadOn],
        &[TournamentOffset, MarblesOffset, LossyMarbles],
    ]
};

impl HitKind {
    /// All hits of this kind that give a clear question, in a fixed order, each with the direction
    /// 0° and a speed of 1 m/s; unless the hit is head-on, the target lies on the right of the
    /// striker's path. The list is cached, because hundreds of hits are searched to find these.
    pub(super) fn candidates(self) -> &'static [Hit] {
        const COUNT: usize = HitKind::VARIANTS.len();
        static FOUND: [OnceLock<Vec<Hit>>; COUNT] = [const { OnceLock::new() }; COUNT];
        FOUND[self as usize].get_or_init(|| self.find())
    }

    fn find(self) -> Vec<Hit> {
        use HitKind::*;
        use Pieces::{Equal, Marbles, Tournament};
        let fives: Vec<_> = (15..=75).step_by(5).map(at_angle).collect();
        let degrees: Vec<_> = (10..=80).map(at_angle).collect();
        match self {
            EqualAngle => every(EQUAL, &fives, NO_LOSS),
            EqualOffset => every(EQUAL, &offsets(Equal), NO_LOSS),
            TournamentAngle => every(&[Tournament], &degrees, NO_LOSS),
            MarblesAngle => every(&[Marbles], &degrees, NO_LOSS),
            LossyAngle => every(EQUAL, &fives, &[0.4, 0.5, 0.6, 0.7, 0.8]),
            HeadOn => every(ALL, &[at_angle(0)], NO_LOSS),
            TournamentOffset => every(&[Tournament], &offsets(Tournament), NO_LOSS),
            MarblesOffset => every(&[Marbles], &offsets(Marbles), NO_LOSS),
            LossyMarbles => every(&[Marbles], &fives, &[0.4, 0.5, 0.6]),
        }
    }

    /// Draws a hit of this kind that is not in `asked`; returns `None` only if all hits have been
    /// asked.
    pub(super) fn draw(
        self,
        difficulty: Difficulty,
        asked: &[Hit],
        dice: &mut Dice,
    ) -> Option<Hit> {
        let mut fresh = self.candidates().to_vec();
        fresh.retain(|candidate| !asked.iter().any(|old| same_hit(old, candidate)));
        let hit = *dice.pick(&fresh)?;
        let left = dice.coin();
        let speed = f64::from(2 + dice.below(3));
        Some(Hit {
            given: if left { mirrored(hit.given) } else { hit.given },
            speed,
            direction_deg: direction_deg(difficulty, dice),
            ..hit
        })
    }
}

/// A hit with the direction 0° and a speed of 1 m/s.
fn plain(pieces: Pieces, given: ImpactPoint, restitution: f64) -> Hit {
    Hit {
        pieces,
        given,
        restitution,
        speed: 1.0,
        direction_deg: 0.0,
    }
}

fn at_angle(alpha_deg: u32) -> ImpactPoint {
    let alpha_deg = f64::from(alpha_deg);
    ImpactPoint::Angle { alpha_deg }
}

/// Offsets in millimetres, in steps of a tenth.
fn offsets(pieces: Pieces) -> Vec<ImpactPoint> {
    let tenths = 10.0 * plain(pieces, at_angle(0), 1.0).reach_mm();
    let offset = |tenths| ImpactPoint::Offset {
        offset_mm: f64::from(tenths) / 10.0,
    };
    (1..=tenths as u32).map(offset).collect()
}

/// All hits with these pieces, points of impact and values of e that give a clear question.
fn every(pieces: &[Pieces], places: &[ImpactPoint], restitutions: &[f64]) -> Vec<Hit> {
    let mut hits = Vec::new();
    for &it in pieces {
        for &given in places {
            hits.extend(restitutions.iter().map(|&e| plain(it, given, e)));
        }
    }
    hits.retain(|hit| {
        within_reason(hit)
            && adds_up(hit)
            && clearance(hit) > rad_from_deg(MIN_SEPARATION * RIGHT_DEG)
    });
    hits
}

fn mirrored(given: ImpactPoint) -> ImpactPoint {
    match given {
        // This is 0.0 - x, because -x would be -0.0 for a head-on hit, which has no side.
        ImpactPoint::Angle { alpha_deg } => ImpactPoint::Angle {
            alpha_deg: 0.0 - alpha_deg,
        },
        ImpactPoint::Offset { offset_mm } => ImpactPoint::Offset {
            offset_mm: 0.0 - offset_mm,
        },
    }
}

/// Whether two hits are the same apart from their side, speed and direction.
fn same_hit(a: &Hit, b: &Hit) -> bool {
    let close = |x: f64, y: f64| (x - y).abs() < 1e-9;
    a.pieces == b.pieces
        && close(a.restitution, b.restitution)
        && close(a.alpha().abs(), b.alpha().abs())
}

/// Whether a hit can be used: it must be either head-on, or far enough from a head-on hit and from
/// a graze to be drawn clearly. It must not be at 45°, where "half and half" and a copied angle
/// give the same answer (for equal masses without loss, even the right one).
fn within_reason(hit: &Hit) -> bool {
    let alpha_deg = deg_from_rad(hit.alpha());
    let drawable = (9.5..80.5).contains(&alpha_deg) && (alpha_deg - 45.0).abs() > 0.5;
    hit.head_on() || drawable
}

/// The smallest distance, in radians, between two outcomes of a hit, whether true or predicted.
/// This is like [`Question::clearance`](crate::quiz::Question::clearance), but without generating
/// the text of a question, because hundreds of hits are searched.
fn clearance(hit: &Hit) -> f64 {
    let held = OF_RAYS
        .into_iter()
        .filter_map(|it| Some(it.predict(hit)?.0));
    let rays: Vec<Rays> = held.chain([hit.truth()]).collect();
    nearest(&rays, Rays::gap)
}

/// Whether the two printed angles add up exactly to the printed angle between the paths.
fn adds_up(hit: &Hit) -> bool {
    let outcome = hit.outcome();
    match (outcome.theta1, outcome.theta2, outcome.separation) {
        (Some(theta1), Some(theta2), Some(separation)) => {
            tenths(theta1) + tenths(theta2) == tenths(separation)
        }
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_enough_hits() {
        for &kind in HitKind::VARIANTS {
            let least = if kind == HitKind::HeadOn { 3 } else { 8 };
            let n = kind.candidates().len();
            assert!(n >= least, "{kind:?}: {n}");
        }
    }

    /// The last bit of a sine may differ between machines, so no hit may depend on it.
    #[test]
    fn no_choice_depends_on_the_last_bit() {
        let near_tie = |angle: f64| {
            let tenths = angle.to_degrees() * 10.0;
            (tenths - tenths.floor() - 0.5).abs() < 1e-7
        };
        for &kind in HitKind::VARIANTS {
            for hit in kind.candidates() {
                let outcome = hit.outcome();
                let printed = [outcome.theta1, outcome.theta2, outcome.separation];
                assert!(!printed.into_iter().flatten().any(near_tie), "{hit:?}");
                let margin = clearance(hit).to_degrees() - MIN_SEPARATION * RIGHT_DEG;
                assert!(margin > 1e-7, "{hit:?}");
            }
        }
    }
}
