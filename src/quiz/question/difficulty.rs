//! How hard a question is.

use strum::IntoStaticStr;

/// How hard a question is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Difficulty {
    /// One idea, in the plainest setting.
    Easy,
    /// One idea, in any setting.
    Middle,
    /// Two ideas at once, or one in reverse.
    Hard,
}

impl Difficulty {
    /// All three, the easiest first.
    pub const ALL: [Self; 3] = [Self::Easy, Self::Middle, Self::Hard];

    /// Its name in files and on screen.
    pub fn id(self) -> &'static str {
        self.into()
    }

    /// The difficulty of question `i` (from 0) of `count` in a round that gets harder.
    pub(crate) fn rising(i: usize, count: usize) -> Self {
        let third = (3 * i).checked_div(count).unwrap_or(0);
        Self::ALL[third.min(2)]
    }
}
