//! The roles of things on the screen, and the colours of each role in each palette.

use ratatui::style::{Color, Modifier};
use serde::Serialize;
use strum::VariantArray;

use super::{Palette, colour::Rgb};

/// The role of a thing on the screen; the theme turns the role into a colour and a weight.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, VariantArray)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// The background.
    Background,
    /// Running text and numbers.
    Text,
    /// Less important text: units, hints, options that are switched off.
    Dim,
    /// A title.
    Title,
    /// The name of a key in a hint.
    Key,
    /// The frame of a panel.
    Border,
    /// The selected item among several.
    Selected,
    /// Something right, won, or close to the truth.
    Good,
    /// A mistake, a foul or a warning.
    Warn,
    /// The striker.
    Striker,
    /// The coin that is struck, or a white coin.
    Coin,
    /// A black coin.
    Black,
    /// The queen.
    Queen,
    /// A marble.
    Marble,
    /// The striker's initial velocity, u.
    Incoming,
    /// The component of the striker's initial velocity along the line of impact, u₁ₙ.
    NormalPart,
    /// The component of the striker's initial velocity along the tangent, u₁ₜ.
    TangentPart,
    /// The striker's final velocity, v₁.
    StrikerOut,
    /// The coin's final velocity, v₂.
    CoinOut,
    /// The line through both centres at contact.
    LineOfImpact,
    /// The common tangent at the point of contact.
    TangentLine,
    /// The arc of an angle.
    Arc,
    /// The mark of a right angle.
    SquareCorner,
    /// The point where two discs touch.
    Contact,
    /// The player's prediction.
    Predicted,
    /// The path that a disc has taken so far.
    Trail,
    /// The direction in which the player aims.
    Aim,
    /// The lines of a board.
    BoardLine,
    /// The outline of a pocket.
    Pocket,
    /// The surface of a board.
    Surface,
    /// The frame of a board.
    Rail,
    /// The dark inside of a pocket.
    Hole,
    /// The red circle at the end of a base line.
    BaseCircle,
    /// The axes of a plot.
    Axis,
}

use Color as C;
use Role as R;

impl Role {
    /// Every role.
    pub const ALL: &'static [Self] = Self::VARIANTS;

    /// The mark and the role of a row in a list; the role is `self` unless the row is `chosen`.
    pub(crate) const fn of_choice(self, chosen: bool) -> (&'static str, Self) {
        match chosen {
            true => (">", Self::Selected),
            false => (" ", self),
        }
    }

    /// The colours of the role on a dark and on a light background: first as 24-bit values, then as
    /// two of the sixteen named colours.
    const fn colours(self) -> (u32, u32, Color, Color) {
        match self {
            R::Background => (0x10141a, 0xfbfaf6, C::Black, C::White),
            R::Text => (0xd8dde6, 0x1c2230, C::Gray, C::Black),
            R::Dim => (0x8b94a5, 0x646c7b, C::DarkGray, C::DarkGray),
            R::Title => (0xffffff, 0x000000, C::White, C::Black),
            R::Key => (0xf0e442, 0x0063a0, C::LightYellow, C::Blue),
            R::Border => (0x4a5364, 0xb4b8c0, C::DarkGray, C::Gray),
            R::Selected => (0x56b4e9, 0x0072b2, C::LightCyan, C::Blue),
            R::Good => (0x2cc295, 0x007a59, C::LightGreen, C::Green),
            R::Warn => (0xf0783c, 0xb84a00, C::LightRed, C::Red),
            R::Striker => (0x56b4e9, 0x0072b2, C::LightCyan, C::Blue),
            R::Coin => (0xf2d7a0, 0xb87a2c, C::White, C::Yellow),
            R::Black => (0x746a80, 0x3a3440, C::DarkGray, C::Black),
            R::Queen => (0xe0526a, 0xb3203a, C::LightRed, C::Red),
            R::Marble => (0x2cc295, 0x00966d, C::LightGreen, C::Green),
            R::Incoming => (0xf0e442, 0x5a4a00, C::LightYellow, C::Black),
            R::NormalPart => (0x2cc295, 0x007a59, C::LightGreen, C::Green),
            R::TangentPart => (0xa9b7f5, 0x5a4fc0, C::LightBlue, C::Cyan),
            R::StrikerOut => (0x74c7f7, 0x00609c, C::LightCyan, C::Blue),
            R::CoinOut => (0xf5a623, 0x9a4a00, C::Yellow, C::Red),
            R::LineOfImpact => (0x9aa5b8, 0x707887, C::Gray, C::DarkGray),
            R::TangentLine => (0x7f899b, 0x858d9b, C::DarkGray, C::DarkGray),
            R::Arc => (0x9aa5b8, 0x707887, C::Gray, C::DarkGray),
            R::SquareCorner => (0x2cc295, 0x007a59, C::LightGreen, C::Green),
            R::Contact => (0xffffff, 0x000000, C::White, C::Black),
            R::Predicted => (0xdd8ab8, 0xa03a7c, C::LightMagenta, C::Magenta),
            R::Trail => (0x8b94a5, 0x7c8494, C::DarkGray, C::DarkGray),
            R::Aim => (0xc3cad6, 0x4a5261, C::Gray, C::Black),
            R::BoardLine => (0x6b6259, 0xb5a68e, C::DarkGray, C::Gray),
            R::Pocket => (0x7a8294, 0x858d9b, C::LightBlue, C::DarkGray),
            R::Surface => (0x2a1f14, 0xf6ecd8, C::Black, C::White),
            R::Rail => (0x744a24, 0xc9a06a, C::Gray, C::DarkGray),
            R::Hole => (0x060403, 0x4a3b2c, C::Black, C::DarkGray),
            R::BaseCircle => (0x5a1f1a, 0xeebfb2, C::Red, C::LightRed),
            R::Axis => (0x7f899b, 0x707887, C::DarkGray, C::DarkGray),
        }
    }

    /// The role's colour in a palette (for monochrome, its colour in the dark palette).
    pub(super) const fn rgb(self, palette: Palette) -> Rgb {
        let (dark, light, ..) = self.colours();
        Rgb::hex(match palette {
            Palette::Light => light,
            Palette::Dark | Palette::Mono => dark,
        })
    }

    /// The role's colour among the sixteen named colours.
    pub(super) const fn ansi(self, palette: Palette) -> Color {
        let (.., dark, light) = self.colours();
        match palette {
            Palette::Light => light,
            Palette::Dark | Palette::Mono => dark,
        }
    }

    /// The named colour of a letter on a disc of this role.
    pub(super) const fn ansi_ink(self, palette: Palette) -> Color {
        match self.ansi(palette) {
            Color::Black | Color::DarkGray | Color::Blue | Color::Red | Color::Magenta => {
                Color::White
            }
            _ => Color::Black,
        }
    }

    /// The weight that is added to the colour.
    pub(super) const fn modifier(self) -> Modifier {
        match self {
            R::Title | R::Key | R::Warn | R::StrikerOut | R::CoinOut | R::Contact => Modifier::BOLD,
            _ => Modifier::empty(),
        }
    }

    /// The weight that is used if there is no colour.
    pub(super) const fn mono_modifier(self) -> Modifier {
        match self {
            R::Title | R::Good | R::StrikerOut | R::CoinOut | R::Contact | R::Key => Modifier::BOLD,
            R::Warn => Modifier::BOLD.union(Modifier::UNDERLINED),
            R::Selected => Modifier::REVERSED,
            R::Dim
            | R::Border
            | R::TangentLine
            | R::Trail
            | R::BoardLine
            | R::Rail
            | R::BaseCircle
            | R::Axis
            | R::LineOfImpact
            | R::Arc => Modifier::DIM,
            _ => Modifier::empty(),
        }
    }
}
