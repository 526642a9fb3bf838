//! Characters that fill part of a cell.

use strum::{EnumString, VariantNames};

/// The finest block elements that a screen may use. Each set includes the coarser sets, and the
/// eighths from below and from the left.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, EnumString, VariantNames,
)]
#[strum(serialize_all = "lowercase")]
pub enum Blocks {
    /// Two columns and two rows in each cell. Most fonts have these characters.
    #[default]
    Quadrants,
    /// Two columns and three rows in each cell, from Unicode 13.
    Sextants,
    /// Two columns and four rows in each cell, from Unicode 16.
    Octants,
}

/// Quarters of a cell. The bits of the index, from the lowest: upper left, upper right, lower left,
/// lower right.
pub(crate) const QUARTERS: [char; 16] = [
    ' ', '▘', '▝', '▀', '▖', '▌', '▞', '▛', '▗', '▚', '▐', '▜', '▄', '▙', '▟', '█',
];

/// One to seven eighths of a cell, filled from below.
pub(crate) const LOWER: [char; 7] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇'];

/// One to seven eighths of a cell, filled from the left.
pub(crate) const LEFT: [char; 7] = ['▏', '▎', '▍', '▌', '▋', '▊', '▉'];

/// The bit of each braille dot in the code point of its character, row by row from the top left in
/// a grid of 2 × 4. Unicode numbers dots 1-3 down the left, 4-6 down the right, then 7 and 8.
pub(crate) const BRAILLE: [u32; 8] = [0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80];

/// The braille character with the given dots, numbered row by row from the top left in a grid of
/// 2 × 4 (bit 0 first).
pub(crate) fn braille(dots: u16) -> char {
    let bits = { BRAILLE.iter().enumerate() }.filter(|(dot, _)| dots >> dot & 1 == 1);
    let code = bits.fold(0x2800, |code, (_, bit)| code | bit);
    char::from_u32(code).unwrap_or(' ')
}

/// The sextants and their parts as bits, numbered row by row from the top left as in the name BLOCK
/// SEXTANT-1346. The sextants are sorted by their bits; the left half and the right half are left
/// out because they are older characters.
pub(crate) fn sextants() -> impl Iterator<Item = (char, u8)> {
    let own = (1..63).filter(|parts| ![0b01_01_01, 0b10_10_10].contains(parts));
    ('\u{1fb00}'..='\u{1fb3b}').zip(own)
}

/// The octants and their parts, like [`sextants`]. Octants that consist of quadrants are left out,
/// as are those not named BLOCK OCTANT, such as UPPER ONE QUARTER BLOCK and the single corners: all
/// these have code points elsewhere.
pub(crate) fn octants() -> impl Iterator<Item = (char, u8)> {
    const OTHERS: [u8; 10] = [0x01, 0x02, 0x03, 0x14, 0x28, 0x3f, 0x40, 0x80, 0xc0, 0xfc];
    let consists_of_quadrants = |parts: u8| (parts ^ parts >> 2) & 0b00_11_00_11 == 0;
    let own = (0..=u8::MAX)
        .filter(move |parts| !consists_of_quadrants(*parts) && !OTHERS.contains(parts));
    ('\u{1cd00}'..='\u{1cde5}').zip(own)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bits of the parts listed in a Unicode name.
    fn named(parts: &str) -> u8 {
        let digits = parts.bytes().map(|digit| digit - b'1');
        digits.fold(0, |bits, part| bits | 1 << part)
    }

    /// The names are from the Unicode Character Database (16.0).
    #[test]
    fn sextants_and_octants_have_the_parts_in_their_names() {
        for (symbol, name) in [
            ('\u{1fb00}', "1"),
            ('\u{1fb13}', "35"),
            ('\u{1fb14}', "235"),
            ('\u{1fb27}', "146"),
            ('\u{1fb28}', "1246"),
            ('\u{1fb3b}', "23456"),
        ] {
            assert!(sextants().any(|it| it == (symbol, named(name))), "{name}");
        }
        for (symbol, name) in [
            ('\u{1cd00}', "3"),
            ('\u{1cd01}', "23"),
            ('\u{1cd03}', "4"),
            ('\u{1cd09}', "5"),
            ('\u{1cd24}', "1346"),
            ('\u{1cd36}', "17"),
            ('\u{1cd71}', "18"),
            ('\u{1cd98}', "12468"),
            ('\u{1cdb8}', "13478"),
            ('\u{1cde5}', "2345678"),
        ] {
            assert!(octants().any(|it| it == (symbol, named(name))), "{name}");
        }
        assert_eq!((sextants().count(), octants().count()), (60, 230));
    }

    #[test]
    fn braille_dots_are_where_unicode_defines_them() {
        assert_eq!(braille(0), '\u{2800}');
        assert_eq!(braille(0b1111_1111), '⣿');
        assert_eq!(braille(0b0000_1111), '⠛');
        assert_eq!(braille(0b0101_0101), '⡇');
        assert_eq!(braille(0b1100_0000), '⣀');
    }
}
