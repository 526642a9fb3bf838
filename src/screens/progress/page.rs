//! The pages of the screen.

use strum::VariantArray;

#[derive(Debug, Clone, Copy, PartialEq, Eq, VariantArray)]
pub(super) enum ProgressPage {
    /// The errors of the answers over time.
    OverTime,
    Topics,
    /// Whether confidence matches the answers.
    Sure,
    /// The same over time.
    SureOverTime,
    /// The player's misconceptions.
    Beliefs,
}

impl ProgressPage {
    pub(super) const ALL: &[Self] = Self::VARIANTS;

    /// The page this many after this one, cyclically.
    pub(super) fn beside(self, steps: isize) -> Self {
        let count = Self::ALL.len() as isize;
        let at = (self as isize + steps).rem_euclid(count);
        Self::ALL[at as usize]
    }

    /// Titles of the picture and of the panel.
    pub(super) const fn titles(self) -> (&'static str, &'static str) {
        match self {
            Self::OverTime => ("1 how far off, over time", "summary"),
            Self::Topics => ("2 topics", "what is due"),
            Self::Sure => ("3 how sure, and how right", "what it shows"),
            Self::SureOverTime => ("4 how sure, over time", "how to read it"),
            Self::Beliefs => ("5 what you believed", "what helps"),
        }
    }
}
