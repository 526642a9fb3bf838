//! What a thing on screen is, and its colour in each palette.

use ratatui::style::{Color, Modifier};

use super::{Palette, colour::Rgb};

/// What a thing on screen is. The theme turns it into a colour and a weight.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// What everything lies on.
    Background,
    /// Running text and numbers.
    Text,
    /// Text of second rank: units, hints, what is switched off.
    Dim,
    /// A title.
    Title,
    /// The name of a key in a hint.
    Key,
    /// The frame of a panel.
    Border,
    /// The chosen one of several.
    Selected,
    /// Right, won, near the truth.
    Good,
    /// A mistake, a foul, a warning.
    Warn,
    /// The striker.
    Striker,
    /// The struck or white coin.
    Coin,
    /// A black coin.
    Black,
    /// The queen.
    Queen,
    /// A marble.
    Marble,
    /// The striker's velocity before the hit, u.
    Incoming,
    /// Its part along the line of impact, uₙ.
    NormalPart,
    /// Its part along the tangent, uₜ.
    TangentPart,
    /// The striker's velocity after the hit, v₁.
    StrikerOut,
    /// The coin's velocity after the hit, v₂.
    CoinOut,
    /// The line through both centres at contact.
    LineOfImpact,
    /// The common tangent at the point of contact.
    TangentLine,
    /// The arc of an angle.
    Arc,
    /// The square corner of a right angle.
    SquareCorner,
    /// The point where two discs touch.
    Contact,
    /// What the player said would happen.
    Predicted,
    /// Where a disc has been.
    Trail,
    /// Where the player aims.
    Aim,
    /// The lines and the frame of a board.
    BoardLine,
    /// A pocket.
    Pocket,
    /// The axes of a plot.
    Axis,
}

use Role as R;

impl Role {
    /// Every role.
    pub const ALL: [Self; 30] = [
        R::Background,
        R::Text,
        R::Dim,
        R::Title,
        R::Key,
        R::Border,
        R::Selected,
        R::Good,
        R::Warn,
        R::Striker,
        R::Coin,
        R::Black,
        R::Queen,
        R::Marble,
        R::Incoming,
        R::NormalPart,
        R::TangentPart,
        R::StrikerOut,
        R::CoinOut,
        R::LineOfImpact,
        R::TangentLine,
        R::Arc,
        R::SquareCorner,
        R::Contact,
        R::Predicted,
        R::Trail,
        R::Aim,
        R::BoardLine,
        R::Pocket,
        R::Axis,
    ];

    /// The colour in a palette (monochrome has the dark one's, unused).
    pub(super) const fn rgb(self, palette: Palette) -> Rgb {
        Rgb::hex(match palette {
            Palette::Light => self.on_light(),
            Palette::Dark | Palette::Mono => self.on_dark(),
        })
    }

    const fn on_dark(self) -> u32 {
        match self {
            R::Background => 0x10141a,
            R::Text => 0xd8dde6,
            R::Dim => 0x8b94a5,
            R::Title => 0xffffff,
            R::Key => 0xf0e442,
            R::Border => 0x4a5364,
            R::Selected => 0x56b4e9,
            R::Good => 0x2cc295,
            R::Warn => 0xf0783c,
            R::Striker => 0x56b4e9,
            R::Coin => 0xf2d7a0,
            R::Black => 0x746a80,
            R::Queen => 0xe0526a,
            R::Marble => 0x2cc295,
            R::Incoming => 0xf0e442,
            R::NormalPart => 0x2cc295,
            R::TangentPart => 0xa9b7f5,
            R::StrikerOut => 0x74c7f7,
            R::CoinOut => 0xf5a623,
            R::LineOfImpact => 0x9aa5b8,
            R::TangentLine => 0x7f899b,
            R::Arc => 0x9aa5b8,
            R::SquareCorner => 0x2cc295,
            R::Contact => 0xffffff,
            R::Predicted => 0xdd8ab8,
            R::Trail => 0x8b94a5,
            R::Aim => 0xc3cad6,
            R::BoardLine => 0x59606e,
            R::Pocket => 0x7a8294,
            R::Axis => 0x7f899b,
        }
    }

    const fn on_light(self) -> u32 {
        match self {
            R::Background => 0xfbfaf6,
            R::Text => 0x1c2230,
            R::Dim => 0x646c7b,
            R::Title => 0x000000,
            R::Key => 0x0063a0,
            R::Border => 0xb4b8c0,
            R::Selected => 0x0072b2,
            R::Good => 0x007a59,
            R::Warn => 0xb84a00,
            R::Striker => 0x0072b2,
            R::Coin => 0xe0b060,
            R::Black => 0x3a3440,
            R::Queen => 0xb3203a,
            R::Marble => 0x009e73,
            R::Incoming => 0x5a4a00,
            R::NormalPart => 0x007a59,
            R::TangentPart => 0x5a4fc0,
            R::StrikerOut => 0x00609c,
            R::CoinOut => 0x9a4a00,
            R::LineOfImpact => 0x707887,
            R::TangentLine => 0x858d9b,
            R::Arc => 0x707887,
            R::SquareCorner => 0x007a59,
            R::Contact => 0x000000,
            R::Predicted => 0xa03a7c,
            R::Trail => 0x7c8494,
            R::Aim => 0x4a5261,
            R::BoardLine => 0xaaaeb6,
            R::Pocket => 0x858d9b,
            R::Axis => 0x707887,
        }
    }

    /// The colour among the sixteen named ones.
    pub(super) const fn ansi(self, palette: Palette) -> Color {
        match palette {
            Palette::Light => self.ansi_on_light(),
            Palette::Dark | Palette::Mono => self.ansi_on_dark(),
        }
    }

    const fn ansi_on_dark(self) -> Color {
        match self {
            R::Background => Color::Black,
            R::Text | R::LineOfImpact | R::Arc | R::Aim => Color::Gray,
            R::Title | R::Contact | R::Coin => Color::White,
            R::Dim | R::Border | R::BoardLine | R::TangentLine | R::Trail | R::Axis | R::Black => {
                Color::DarkGray
            }
            R::Key | R::Incoming => Color::LightYellow,
            R::Selected | R::Striker | R::StrikerOut => Color::LightCyan,
            R::Good | R::NormalPart | R::SquareCorner | R::Marble => Color::LightGreen,
            R::TangentPart | R::Pocket => Color::LightBlue,
            R::CoinOut => Color::Yellow,
            R::Warn | R::Queen => Color::LightRed,
            R::Predicted => Color::LightMagenta,
        }
    }

    const fn ansi_on_light(self) -> Color {
        match self {
            R::Background => Color::White,
            R::Text | R::Title | R::Contact | R::Incoming | R::Aim | R::Black => Color::Black,
            R::Dim | R::LineOfImpact | R::TangentLine | R::Arc | R::Trail | R::Axis | R::Pocket => {
                Color::DarkGray
            }
            R::Border | R::BoardLine => Color::Gray,
            R::Key | R::Selected | R::Striker | R::StrikerOut => Color::Blue,
            R::Good | R::NormalPart | R::SquareCorner | R::Marble => Color::Green,
            R::TangentPart => Color::Cyan,
            R::CoinOut | R::Warn | R::Queen => Color::Red,
            R::Coin => Color::Yellow,
            R::Predicted => Color::Magenta,
        }
    }

    /// The named colour of a letter upon a disc of this role.
    pub(super) const fn ansi_ink(self, palette: Palette) -> Color {
        match self.ansi(palette) {
            Color::Black | Color::DarkGray | Color::Blue | Color::Red | Color::Magenta => {
                Color::White
            }
            _ => Color::Black,
        }
    }

    /// The weight beside the colour.
    pub(super) const fn modifier(self) -> Modifier {
        match self {
            R::Title | R::Key | R::Warn | R::StrikerOut | R::CoinOut | R::Contact => Modifier::BOLD,
            _ => Modifier::empty(),
        }
    }

    /// The weight where there is no colour.
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
            | R::Axis
            | R::LineOfImpact
            | R::Arc => Modifier::DIM,
            _ => Modifier::empty(),
        }
    }
}
