//! The glyphs that best show a pattern of ink.

pub(super) mod ascii;
pub(super) mod block;

use crate::widgets::text::blocks::BRAILLE;

/// The braille character with the given dots, numbered row by row from the top
/// left in a grid of 2 × 4 (bit 0 first).
pub(super) fn braille(dots: u16) -> char {
    let code = BRAILLE
        .iter()
        .enumerate()
        .filter(|(dot, _)| dots >> dot & 1 == 1)
        .fold(0x2800, |code, (_, bit)| code | bit);
    char::from_u32(code).unwrap_or(' ')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn braille_dots_are_where_unicode_defines_them() {
        assert_eq!(braille(0), '\u{2800}');
        assert_eq!(braille(0b1111_1111), '⣿');
        assert_eq!(braille(0b0000_1111), '⠛');
        assert_eq!(braille(0b0101_0101), '⡇');
        assert_eq!(braille(0b1100_0000), '⣀');
    }
}
