//! The strength of an opponent: how thoroughly the opponent searches and how steady its hand is.

use serde::{Deserialize, Serialize};
use strum::{Display, IntoStaticStr};

use super::hand::Hand;

/// The five strengths, weakest first.
///
/// They differ in the kinds of shot they consider, in the number of shots they simulate before a
/// stroke, and in the [errors](Hand) of their hand:
///
/// | strength | direction | speed | shots | looks ahead |
/// |---|---|---|---|---|
/// | beginner | 2.9° | 20 % | cuts | no |
/// | regular | 1.7° | 15 % | cuts | no |
/// | club player | 1.0° | 10 % | cuts, combinations | yes |
/// | expert | 0.55° | 7 % | all | yes |
/// | champion | 0.3° | 4 % | all | yes |
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Default, Display, Serialize, Deserialize,
)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "lowercase")]
pub enum Strength {
    /// Considers only plain cuts and has an unsteady hand.
    Beginner,
    /// Considers more positions and has a steadier hand.
    #[default]
    Regular,
    /// Also considers the next stroke and combinations, and tries the best strokes with an unsteady
    /// hand.
    #[strum(to_string = "club player")]
    Club,
    /// Also considers cushion shots, and tries more of the best strokes with an unsteady hand.
    Expert,
    /// Considers the same kinds of shot as an expert, tries more strokes and makes smaller errors.
    Champion,
}

/// The abilities of an opponent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Skill {
    pub(super) hand: Hand,
    /// The number of evenly spaced positions that are considered between the base circles.
    pub(super) places: u16,
    /// Whether combinations are considered.
    pub(super) combinations: bool,
    /// Whether cushion shots are considered.
    pub(super) cushions: bool,
    /// The maximum number of aims that are tried: those with the largest tolerance.
    pub(super) aims: usize,
    /// Speeds at which each aim is tried, as multiples of the minimum speed.
    pub(super) speeds: &'static [f64],
    /// The number of strokes that are tried without aiming for a pocket.
    pub(super) knocks: usize,
    /// How many of the best strokes are tried with an unsteady hand.
    pub(super) finalists: usize,
    /// How many times each of these strokes is tried, with different random errors.
    pub(super) slips: usize,
    /// The number of small changes to the best stroke that are tried in the same way.
    pub(super) refinements: usize,
    /// Whether the position after the stroke is evaluated.
    pub(super) looks_ahead: bool,
    /// Whether the first of the `slips` tries of each stroke is made without an error.
    pub(super) is_exact: bool,
    /// Whether strokes must be on the [steps](crate::game::steps) in which a player sets them, and
    /// must not be fouls when played exactly.
    pub(super) on_steps: bool,
}

impl Strength {
    /// All strengths, weakest first.
    pub const ALL: [Self; 5] = [
        Self::Beginner,
        Self::Regular,
        Self::Club,
        Self::Expert,
        Self::Champion,
    ];

    /// How unsteady the opponent's hand is.
    pub fn hand(self) -> Hand {
        self.skill().hand
    }

    /// The maximum number of shots that the opponent simulates before one stroke.
    pub fn most_rehearsals(self) -> usize {
        let skill = self.skill();
        let first_look = skill.aims * skill.speeds.len() + skill.knocks;
        // One more for the exact stroke, which the comment afterwards describes.
        first_look + (skill.finalists + skill.refinements) * skill.slips + 1
    }

    pub(super) fn skill(self) -> Skill {
        match self {
            Self::Beginner => Skill {
                hand: Hand::new(0.05, 0.20),
                places: 5,
                combinations: false,
                cushions: false,
                aims: 4,
                speeds: &[1.5],
                knocks: 3,
                finalists: 0,
                slips: 0,
                refinements: 0,
                looks_ahead: false,
                is_exact: false,
                on_steps: false,
            },
            Self::Regular => Skill {
                hand: Hand::new(0.03, 0.15),
                places: 9,
                aims: 10,
                speeds: &[1.5],
                knocks: 6,
                ..Self::Beginner.skill()
            },
            Self::Club => Skill {
                hand: Hand::new(0.0175, 0.10),
                places: 13,
                combinations: true,
                aims: 16,
                speeds: &[1.3, 1.8],
                knocks: 12,
                finalists: 4,
                slips: 4,
                looks_ahead: true,
                ..Self::Regular.skill()
            },
            Self::Expert => Skill {
                hand: Hand::new(0.0096, 0.07),
                places: 17,
                cushions: true,
                aims: 40,
                speeds: &[1.2, 1.6, 2.2],
                knocks: 24,
                finalists: 8,
                slips: 8,
                refinements: 4,
                ..Self::Club.skill()
            },
            Self::Champion => Skill {
                hand: Hand::new(0.0052, 0.04),
                places: 25,
                aims: 80,
                speeds: &[1.15, 1.5, 2.0, 2.8],
                knocks: 40,
                finalists: 16,
                slips: 16,
                refinements: 16,
                ..Self::Expert.skill()
            },
        }
    }
}

/// How steady the players at the keyboard are; as text, one word such as "club".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, IntoStaticStr)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "lowercase")]
pub enum PlayerHand {
    /// Each stroke is played exactly as it was aimed.
    #[default]
    Exact,
    /// The errors of an expert.
    Steady,
    /// The errors of a club player.
    Club,
}

impl PlayerHand {
    /// All hands, the steadiest first.
    pub const ALL: [Self; 3] = [Self::Exact, Self::Steady, Self::Club];

    /// The size of the errors; `None` if there are none.
    pub fn errors(self) -> Option<Hand> {
        match self {
            Self::Exact => None,
            Self::Steady => Some(Strength::Expert.hand()),
            Self::Club => Some(Strength::Club.hand()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_strength_searches_more_and_has_a_steadier_hand() {
        for pair in Strength::ALL.windows(2) {
            let (weak, strong) = (pair[0], pair[1]);
            assert!(weak < strong);
            assert!(weak.hand().direction > strong.hand().direction);
            assert!(weak.hand().speed > strong.hand().speed);
            assert!(weak.most_rehearsals() < strong.most_rehearsals());
        }
    }
}
