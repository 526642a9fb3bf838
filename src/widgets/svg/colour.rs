//! The colours of a screen.

use ratatui::buffer::Cell;
use ratatui::style::{Color, Modifier};

use crate::widgets::theme::Rgb;

/// What is behind everything, as in a dark terminal.
pub(super) const PAPER: Rgb = Rgb::hex(0x101418);
/// What text is written in unless it says otherwise.
const INK: Rgb = Rgb::hex(0xd0d0d0);

/// The first sixteen colours, as xterm and its kin show them.
const SIXTEEN: [u32; 16] = [
    0x000000, 0xcd0000, 0x00cd00, 0xcdcd00, 0x3b6eea, 0xcd00cd, 0x00cdcd, 0xe5e5e5, 0x7f7f7f,
    0xff5555, 0x55ff55, 0xffff55, 0x7a9cff, 0xff55ff, 0x55ffff, 0xffffff,
];

/// One of the 256 colours: sixteen, a cube of six by six by six, and greys.
fn indexed(index: u8) -> Rgb {
    match index {
        0..16 => Rgb::hex(SIXTEEN[usize::from(index)]),
        16..232 => {
            let level = |step: u8| if step == 0 { 0 } else { 55 + 40 * step };
            let i = index - 16;
            Rgb(level(i / 36), level(i / 6 % 6), level(i % 6))
        }
        232.. => {
            let grey = 8 + 10 * (index - 232);
            Rgb(grey, grey, grey)
        }
    }
}

/// The colour a cell names; `otherwise` where it names none.
fn colour_of(colour: Color, otherwise: Rgb) -> Rgb {
    let index = match colour {
        Color::Reset => return otherwise,
        Color::Rgb(red, green, blue) => return Rgb(red, green, blue),
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
    indexed(index)
}

/// The two colours of a cell as they are seen.
pub(super) struct CellColours {
    /// The colour of what is drawn.
    pub(super) ink: Rgb,
    /// The colour behind it.
    pub(super) ground: Rgb,
}

impl CellColours {
    /// How a cell looks, with reverse and dim taken into account.
    pub(super) fn of(cell: &Cell) -> Self {
        let (mut ink, mut ground) = (colour_of(cell.fg, INK), colour_of(cell.bg, PAPER));
        if cell.modifier.contains(Modifier::REVERSED) {
            (ink, ground) = (ground, ink);
        }
        if cell.modifier.contains(Modifier::DIM) {
            ink = ground.mixed(ink, 0.6);
        }
        Self { ink, ground }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cube_and_the_greys_are_xterm_s() {
        assert_eq!(indexed(16), Rgb(0, 0, 0));
        assert_eq!(indexed(21), Rgb(0, 0, 255));
        assert_eq!(indexed(110), Rgb(135, 175, 215));
        assert_eq!(indexed(231), Rgb(255, 255, 255));
        assert_eq!(indexed(255), Rgb(238, 238, 238));
    }
}
