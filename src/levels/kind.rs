//! The kinds of disc.

use crate::physics::Disc;

/// The kind of a disc, which determines the mass and the size of the disc unless the file specifies
/// them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DiscKind {
    /// The disc that is flicked: 15 g and 41.3 mm in diameter, the maximum that the Laws allow.
    Striker,
    /// A white coin: 5.5 g and 31.8 mm in diameter, the maximum that the Laws allow.
    White,
    /// A black coin, with the same mass and size as a white coin.
    Black,
    /// The red queen, with the same mass and size as the other coins.
    Queen,
    /// A glass marble, as in textbook exercises: 20 g and 25 mm in diameter.
    Marble,
}

impl DiscKind {
    /// All kinds, with their names in a file.
    pub(super) const NAMED: [(&'static str, Self); 5] = [
        ("striker", Self::Striker),
        ("white", Self::White),
        ("black", Self::Black),
        ("queen", Self::Queen),
        ("marble", Self::Marble),
    ];

    /// The mass and the size of a disc of this kind.
    pub(crate) const fn disc(self) -> Disc {
        match self {
            Self::Striker => Disc::from_g_mm(15.0, 20.65),
            Self::White | Self::Black | Self::Queen => Disc::from_g_mm(5.5, 15.9),
            Self::Marble => Disc::from_g_mm(20.0, 12.5),
        }
    }

    /// The name of this kind of disc on the screen.
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
