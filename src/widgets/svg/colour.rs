//! The colours of a picture.

use std::fmt;

use ratatui::buffer::Cell;
use ratatui::style::{Color, Modifier};

/// A colour in red, green and blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Rgb(u8, u8, u8);

/// What is behind everything, as in a dark terminal.
pub(super) const PAPER: Rgb = Rgb(0x10, 0x14, 0x18);
/// What text is written in unless it says otherwise.
const INK: Rgb = Rgb(0xd0, 0xd0, 0xd0);

/// The first sixteen colours, as xterm and its kin show them.
const SIXTEEN: [Rgb; 16] = [
    Rgb(0x00, 0x00, 0x00),
    Rgb(0xcd, 0x00, 0x00),
    Rgb(0x00, 0xcd, 0x00),
    Rgb(0xcd, 0xcd, 0x00),
    Rgb(0x3b, 0x6e, 0xea),
    Rgb(0xcd, 0x00, 0xcd),
    Rgb(0x00, 0xcd, 0xcd),
    Rgb(0xe5, 0xe5, 0xe5),
    Rgb(0x7f, 0x7f, 0x7f),
    Rgb(0xff, 0x55, 0x55),
    Rgb(0x55, 0xff, 0x55),
    Rgb(0xff, 0xff, 0x55),
    Rgb(0x7a, 0x9c, 0xff),
    Rgb(0xff, 0x55, 0xff),
    Rgb(0x55, 0xff, 0xff),
    Rgb(0xff, 0xff, 0xff),
];

impl fmt::Display for Rgb {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

impl Rgb {
    /// This colour laid over another, covering the given share of it.
    pub(super) fn over(self, ground: Self, share: f64) -> Self {
        let mix = |over: u8, under: u8| {
            (f64::from(over) * share + f64::from(under) * (1.0 - share)).round() as u8
        };
        Self(
            mix(self.0, ground.0),
            mix(self.1, ground.1),
            mix(self.2, ground.2),
        )
    }

    /// One of the 256 colours: sixteen, a cube of six by six by six, and greys.
    fn indexed(index: u8) -> Self {
        match index {
            0..16 => SIXTEEN[usize::from(index)],
            16..232 => {
                let level = |step: u8| if step == 0 { 0 } else { 55 + 40 * step };
                let i = index - 16;
                Self(level(i / 36), level(i / 6 % 6), level(i % 6))
            }
            232.. => {
                let grey = 8 + 10 * (index - 232);
                Self(grey, grey, grey)
            }
        }
    }

    /// The colour a cell names; `otherwise` where it names none.
    fn of(colour: Color, otherwise: Self) -> Self {
        let index = match colour {
            Color::Reset => return otherwise,
            Color::Rgb(red, green, blue) => return Self(red, green, blue),
            Color::Indexed(index) => index,
            Color::Black => 0,
            Color::Red => 1,
            Color::Green => 2,
            Color::Yellow => 3,
            Color::Blue => 4,
            Color::Magenta => 5,
            Color::Cyan => 6,
            Color::Gray => 7,
            Color::DarkGray => 8,
            Color::LightRed => 9,
            Color::LightGreen => 10,
            Color::LightYellow => 11,
            Color::LightBlue => 12,
            Color::LightMagenta => 13,
            Color::LightCyan => 14,
            Color::White => 15,
        };
        Self::indexed(index)
    }
}

/// The two colours of a cell as they are seen.
pub(super) struct Look {
    /// The colour of what is drawn.
    pub(super) ink: Rgb,
    /// The colour behind it.
    pub(super) ground: Rgb,
}

impl Look {
    /// How a cell looks, with reverse and dim taken into account.
    pub(super) fn of(cell: &Cell) -> Self {
        let (mut ink, mut ground) = (Rgb::of(cell.fg, INK), Rgb::of(cell.bg, PAPER));
        if cell.modifier.contains(Modifier::REVERSED) {
            (ink, ground) = (ground, ink);
        }
        if cell.modifier.contains(Modifier::DIM) {
            ink = ink.over(ground, 0.6);
        }
        Self { ink, ground }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cube_and_the_greys_are_xterm_s() {
        assert_eq!(Rgb::indexed(16), Rgb(0, 0, 0));
        assert_eq!(Rgb::indexed(21), Rgb(0, 0, 255));
        assert_eq!(Rgb::indexed(110), Rgb(135, 175, 215));
        assert_eq!(Rgb::indexed(231), Rgb(255, 255, 255));
        assert_eq!(Rgb::indexed(255), Rgb(238, 238, 238));
    }
}
