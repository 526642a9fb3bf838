//! The kinds of disc.

use crate::physics::Disc;

/// The kind of a disc, which determines its mass and size unless the file gives them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DiscKind {
    /// The disc that is flicked: 15 g and 41.3 mm across, the most the Laws allow.
    Striker,
    /// A white coin: 5.5 g and 31.8 mm across, the most the Laws allow.
    White,
    /// A black coin, as heavy and large as a white one.
    Black,
    /// The red queen, as heavy and large as the other coins.
    Queen,
    /// A glass marble, as in the textbook's exercises: 20 g, 25 mm across.
    Marble,
}

impl DiscKind {
    /// All kinds with their names in a file.
    pub(super) const NAMED: [(&'static str, Self); 5] = [
        ("striker", Self::Striker),
        ("white", Self::White),
        ("black", Self::Black),
        ("queen", Self::Queen),
        ("marble", Self::Marble),
    ];

    /// Mass and size of this kind.
    pub(crate) const fn disc(self) -> Disc {
        match self {
            Self::Striker => Disc::from_g_mm(15.0, 20.65),
            Self::White | Self::Black | Self::Queen => Disc::from_g_mm(5.5, 15.9),
            Self::Marble => Disc::from_g_mm(20.0, 12.5),
        }
    }

    /// The name of a disc of this kind on the screen.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Striker => "striker",
            Self::White => "white coin",
            Self::Black => "black coin",
            Self::Queen => "queen",
            Self::Marble => "marble",
        }
    }
}
