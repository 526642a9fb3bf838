//! The sets of pieces used in questions.

use crate::physics::Disc;

/// A striker and its target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pieces {
    /// Two equal discs of 15 g each.
    Equal,
    /// The heaviest striker and the heaviest coin that tournaments allow: 15 g on 5.5 g.
    Tournament,
    /// Two glass marbles, 20 g on 40 g.
    Marbles,
    /// Any two discs, as set in the lab.
    Own {
        /// The first disc (body 1).
        striker: Disc,
        /// The second disc (body 2).
        target: Disc,
    },
}

impl Pieces {
    /// The striker (body 1) and the target (body 2).
    pub const fn discs(self) -> [Disc; 2] {
        match self {
            Self::Equal => [Disc::from_g_mm(15.0, 15.0); 2],
            Self::Tournament => [Disc::from_g_mm(15.0, 20.65), Disc::from_g_mm(5.5, 15.9)],
            Self::Marbles => [Disc::from_g_mm(20.0, 12.4), Disc::from_g_mm(40.0, 15.6)],
            Self::Own { striker, target } => [striker, target],
        }
    }

    /// The name of the target; body 1 is always called "striker".
    pub(crate) const fn target_name(self) -> &'static str {
        match self {
            Self::Equal | Self::Tournament | Self::Own { .. } => "coin",
            Self::Marbles => "marble",
        }
    }
}
