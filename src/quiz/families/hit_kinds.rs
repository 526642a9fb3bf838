//! The kinds of hit that "where will they go?" asks about, from easy to hard.

use std::sync::OnceLock;

use crate::physics::units::{deg_from_rad, rad_from_deg};

use crate::numbers::tenths;
use crate::physics::ImpactPoint;
use crate::quiz::misconceptions::OF_RAYS;
use crate::quiz::question::{Dice, Difficulty, Hit, MIN_SEPARATION, Pieces, RIGHT_DEG, Rays};

/// A kind of hit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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

/// What a round of hits is made of, by difficulty: the ideas, and the turns.
impl Difficulty {
    /// The kinds that a round asks at this difficulty, each as often as it stands
    /// here.
    pub(super) const fn kinds(self) -> &'static [HitKind] {
        match self {
            Self::Easy => &[
                HitKind::EqualAngle,
                HitKind::EqualAngle,
                HitKind::EqualOffset,
            ],
            Self::Middle => &[
                HitKind::TournamentAngle,
                HitKind::MarblesAngle,
                HitKind::LossyAngle,
                HitKind::HeadOn,
            ],
            Self::Hard => &[
                HitKind::TournamentOffset,
                HitKind::MarblesOffset,
                HitKind::LossyMarbles,
            ],
        }
    }

    /// The striker's directions are multiples of this, in degrees.
    pub(super) const fn turn_deg(self) -> u32 {
        match self {
            Self::Easy => 360,
            Self::Middle => 90,
            Self::Hard => 30,
        }
    }
}

impl HitKind {
    /// How many kinds there are.
    const COUNT: usize = 1 + Self::LossyMarbles as usize;

    /// All hits of this kind that are good to ask, in a fixed order, with the
    /// target on the right and the striker moving to the right at 1 m/s. They are looked
    /// for once, for it takes thousands of hits to find them.
    pub(super) fn candidates(self) -> &'static [Hit] {
        static FOUND: [OnceLock<Vec<Hit>>; HitKind::COUNT] =
            [const { OnceLock::new() }; HitKind::COUNT];
        FOUND[self as usize].get_or_init(|| self.find())
    }

    fn find(self) -> Vec<Hit> {
        let angles = |pieces, steps: std::ops::RangeInclusive<u32>, step: u32, losses: &[f64]| {
            let given = steps
                .map(|i| ImpactPoint::Angle {
                    alpha_deg: f64::from(i * step),
                })
                .collect::<Vec<_>>();
            every(pieces, &given, losses)
        };
        let offsets = |pieces: Pieces| {
            let head_on = plain(pieces, ImpactPoint::Angle { alpha_deg: 0.0 }, 1.0);
            let given = (1..=(10.0 * head_on.reach_mm()) as u32)
                .map(|tenths| ImpactPoint::Offset {
                    offset_mm: f64::from(tenths) / 10.0,
                })
                .collect::<Vec<_>>();
            every(pieces, &given, &[1.0])
        };
        let all = match self {
            Self::EqualAngle => angles(Pieces::Equal, 3..=15, 5, &[1.0]),
            Self::EqualOffset => offsets(Pieces::Equal),
            Self::TournamentAngle => angles(Pieces::Tournament, 10..=80, 1, &[1.0]),
            Self::MarblesAngle => angles(Pieces::Marbles, 10..=80, 1, &[1.0]),
            Self::LossyAngle => angles(Pieces::Equal, 3..=15, 5, &[0.4, 0.5, 0.6, 0.7, 0.8]),
            Self::HeadOn => [Pieces::Equal, Pieces::Tournament, Pieces::Marbles]
                .into_iter()
                .flat_map(|pieces| angles(pieces, 0..=0, 1, &[1.0]))
                .collect(),
            Self::TournamentOffset => offsets(Pieces::Tournament),
            Self::MarblesOffset => offsets(Pieces::Marbles),
            Self::LossyMarbles => angles(Pieces::Marbles, 3..=15, 5, &[0.4, 0.5, 0.6]),
        };
        all.into_iter()
            .filter(|hit| {
                within_reason(hit)
                    && adds_up(hit)
                    && clearance(hit) > rad_from_deg(MIN_SEPARATION * RIGHT_DEG)
            })
            .collect()
    }

    /// Draws a hit of this kind, none of `asked` again; `None` only if all have
    /// been asked.
    pub(super) fn draw(
        self,
        difficulty: Difficulty,
        asked: &[Hit],
        dice: &mut Dice,
    ) -> Option<Hit> {
        let fresh: Vec<Hit> = self
            .candidates()
            .iter()
            .filter(|candidate| !asked.iter().any(|old| same_hit(old, candidate)))
            .copied()
            .collect();
        let hit = *dice.pick(&fresh)?;
        let left = dice.coin();
        let speed = f64::from(2 + dice.below(3));
        let turn = difficulty.turn_deg();
        let direction_deg = f64::from(turn * dice.below(360 / turn));
        Some(Hit {
            given: if left { mirrored(hit.given) } else { hit.given },
            speed,
            direction_deg,
            ..hit
        })
    }
}

/// A hit with the target on the right and nothing else about it.
fn plain(pieces: Pieces, given: ImpactPoint, restitution: f64) -> Hit {
    Hit {
        pieces,
        given,
        restitution,
        speed: 1.0,
        direction_deg: 0.0,
    }
}

fn every(pieces: Pieces, given: &[ImpactPoint], losses: &[f64]) -> Vec<Hit> {
    given
        .iter()
        .flat_map(|&given| losses.iter().map(move |&e| plain(pieces, given, e)))
        .collect()
}

fn mirrored(given: ImpactPoint) -> ImpactPoint {
    match given {
        // 0.0 - x, not -x: a head-on hit has no side.
        ImpactPoint::Angle { alpha_deg } => ImpactPoint::Angle {
            alpha_deg: 0.0 - alpha_deg,
        },
        ImpactPoint::Offset { offset_mm } => ImpactPoint::Offset {
            offset_mm: 0.0 - offset_mm,
        },
    }
}

/// Whether two hits ask about the same hit, but for side, speed and direction.
fn same_hit(a: &Hit, b: &Hit) -> bool {
    let close = |x: f64, y: f64| (x - y).abs() < 1e-9;
    a.pieces == b.pieces
        && close(a.restitution, b.restitution)
        && close(a.alpha().abs(), b.alpha().abs())
}

/// Head-on, or far enough from both head-on and a graze to be drawn. Not at 45°
/// either, where "half and half" and a copied angle would be right by accident.
fn within_reason(hit: &Hit) -> bool {
    let alpha_deg = deg_from_rad(hit.alpha());
    let drawable = (9.5..80.5).contains(&alpha_deg) && (alpha_deg - 45.0).abs() > 0.5;
    hit.head_on() || drawable
}

/// How far apart the two nearest of the truth and all predictions for a hit are, in
/// radians: as [`Question::clearance`](crate::quiz::Question::clearance) has it, without
/// the words of a question, for thousands of hits are looked through.
fn clearance(hit: &Hit) -> f64 {
    let mut rays: Vec<Rays> = OF_RAYS
        .into_iter()
        .filter_map(|misconception| Some(misconception.predict(hit)?.0))
        .collect();
    rays.push(hit.truth());
    let pairs = rays
        .iter()
        .enumerate()
        .flat_map(|(i, a)| rays.iter().skip(i + 1).map(move |b| a.gap(b)));
    pairs.fold(f64::INFINITY, f64::min)
}

/// Whether the angles that are printed add up to the printed separation, to the last
/// place.
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

    const KINDS: [HitKind; HitKind::COUNT] = [
        HitKind::EqualAngle,
        HitKind::EqualOffset,
        HitKind::TournamentAngle,
        HitKind::MarblesAngle,
        HitKind::LossyAngle,
        HitKind::HeadOn,
        HitKind::TournamentOffset,
        HitKind::MarblesOffset,
        HitKind::LossyMarbles,
    ];

    #[test]
    fn every_kind_has_hits_enough() {
        for kind in KINDS {
            let least = if kind == HitKind::HeadOn { 3 } else { 8 };
            let n = kind.candidates().len();
            assert!(n >= least, "{kind:?}: {n}");
        }
    }

    /// Machines may differ in the last bit of a sine. No hit may hang on it.
    #[test]
    fn no_choice_hangs_on_the_last_bit() {
        let near_tie = |angle: f64| {
            let tenths = angle.to_degrees() * 10.0;
            (tenths - tenths.floor() - 0.5).abs() < 1e-7
        };
        for kind in KINDS {
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
