//! The colours of a screen.

use ratatui::buffer::Cell;
use ratatui::style::{Color, Modifier};

use crate::widgets::theme::Rgb;

/// The background colour, as in a dark terminal.
pub(super) const PAPER: Rgb = Rgb::hex(0x101418);
/// The default colour of text.
const INK: Rgb = Rgb::hex(0xd0d0d0);

/// The first sixteen colours, similar to those of xterm.
const SIXTEEN: [(Color, u32); 16] = [
    (Color::Black, 0x000000),
    (Color::Red, 0xcd0000),
    (Color::Green, 0x00cd00),
    (Color::Yellow, 0xcdcd00),
    (Color::Blue, 0x3b6eea),
    (Color::Magenta, 0xcd00cd),
    (Color::Cyan, 0x00cdcd),
    (Color::Gray, 0xe5e5e5),
    (Color::DarkGray, 0x7f7f7f),
    (Color::LightRed, 0xff5555),
    (Color::LightGreen, 0x55ff55),
    (Color::LightYellow, 0xffff55),
    (Color::LightBlue, 0x7a9cff),
    (Color::LightMagenta, 0xff55ff),
    (Color::LightCyan, 0x55ffff),
    (Color::White, 0xffffff),
];

/// One of the 256 indexed colours: one of the first sixteen, or one of the fixed colours after
/// them.
fn indexed(index: u8) -> Rgb {
    let named = SIXTEEN.get(usize::from(index));
    named.map_or_else(|| Rgb::fixed(index), |(_, code)| Rgb::hex(*code))
}

/// The colour specified by a cell, or `otherwise` if the cell does not specify one.
fn colour_of(colour: Color, otherwise: Rgb) -> Rgb {
    match colour {
        Color::Rgb(red, green, blue) => Rgb(red, green, blue),
        Color::Indexed(index) => indexed(index),
        _ => {
            let named = SIXTEEN.iter().find(|(name, _)| *name == colour);
            named.map_or(otherwise, |(_, code)| Rgb::hex(*code))
        }
    }
}

/// The foreground and the background colour of a cell, after applying the reverse and dim
/// modifiers.
pub(super) fn colours(cell: &Cell) -> [Rgb; 2] {
    let (mut ink, mut ground) = (colour_of(cell.fg, INK), colour_of(cell.bg, PAPER));
    if cell.modifier.contains(Modifier::REVERSED) {
        (ink, ground) = (ground, ink);
    }
    if cell.modifier.contains(Modifier::DIM) {
        ink = ground.mixed(ink, 0.6);
    }
    [ink, ground]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cube_and_the_greys_are_those_of_xterm() {
        assert_eq!(indexed(16), Rgb(0, 0, 0));
        assert_eq!(indexed(21), Rgb(0, 0, 255));
        assert_eq!(indexed(110), Rgb(135, 175, 215));
        assert_eq!(indexed(231), Rgb(255, 255, 255));
        assert_eq!(indexed(255), Rgb(238, 238, 238));
    }
}
