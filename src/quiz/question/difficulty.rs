//! How hard a question is.

use strum::IntoStaticStr;

/// How hard a question is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Difficulty {
    /// The question needs one idea, in the simplest setting.
    Easy,
    /// The question needs one idea, in any setting.
    Middle,
    /// The question needs two ideas at once, or one idea in reverse.
    Hard,
}

impl Difficulty {
    /// All three levels, the easiest first.
    pub const ALL: [Self; 3] = [Self::Easy, Self::Middle, Self::Hard];

    /// The name in files and on the screen.
    pub fn id(self) -> &'static str {
        self.into()
    }

    /// The difficulty of question `i` (counted from 0) in a round of `count` questions that become
    /// harder.
    pub(crate) fn rising(i: usize, count: usize) -> Self {
        let third = (3 * i).checked_div(count).unwrap_or(0);
        Self::ALL[third.min(2)]
    }
}
