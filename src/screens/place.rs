//! Where one can go.

/// A screen to open, with what it is to show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// The first screen.
    Home,
    /// The lab.
    Lab,
    /// A round of the quiz; the code fixes its questions.
    Quiz {
        /// The code of the round; `None` takes the app's next.
        seed: Option<u64>,
    },
    /// The table: carrom itself.
    Table,
    /// What the player has done so far.
    Progress,
    /// The list of levels.
    Levels,
    /// A level.
    Level {
        /// Its place among all levels, from 0.
        number: usize,
    },
}
