//! How sure a player is, and the points that depend on this.

use serde::{Deserialize, Serialize};
use strum::{EnumString, IntoStaticStr};

/// How sure the player is. The points are in [`Confidence::points`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumString, IntoStaticStr, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Confidence {
    /// The player has no idea.
    Guess,
    /// The answer is more likely right than wrong.
    ThinkSo,
    /// The player would bet on the answer.
    Sure,
}

impl Confidence {
    /// All three levels, the least sure first.
    pub const ALL: [Self; 3] = [Self::Guess, Self::ThinkSo, Self::Sure];

    /// The name as shown.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Guess => "guess",
            Self::ThinkSo => "think so",
            Self::Sure => "sure",
        }
    }

    /// The name in files.
    pub fn id(self) -> &'static str {
        self.into()
    }

    /// The confidence level with this `id`.
    pub fn with_id(id: &str) -> Option<Self> {
        id.parse().ok()
    }

    /// The points for an answer with this confidence and this `credit`, 0 to 1.
    ///
    /// | | credit 0 | credit 1 |
    /// |---|---|---|
    /// | guess | 0 | 7 |
    /// | think so | −2 | 9 |
    /// | sure | −6 | 10 |
    ///
    /// The points are linear between a credit of 0 and a credit of 1. The lines cross at a credit
    /// of 0.5 (guess and think so) and at 0.8 (think so and sure), so "guess" earns the most points
    /// if the expected credit is below a half, and "sure" only if it is above four fifths: honesty
    /// earns the most points. This is the idea of certainty-based marking (A. R. Gardner-Medwin,
    /// 1995) with other numbers.
    pub fn points(self, credit: f64) -> f64 {
        let (worst, best) = match self {
            Self::Guess => (0.0, 7.0),
            Self::ThinkSo => (-2.0, 9.0),
            Self::Sure => (-6.0, 10.0),
        };
        worst + (best - worst) * credit
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn honest_confidence_earns_the_most_points() {
        for percent in 0..=100 {
            let expected = f64::from(percent) / 100.0;
            let honest = match percent {
                0..50 => Confidence::Guess,
                50..80 => Confidence::ThinkSo,
                _ => Confidence::Sure,
            };
            for other in Confidence::ALL {
                assert!(honest.points(expected) >= other.points(expected) - 1e-12);
            }
        }
    }
}
