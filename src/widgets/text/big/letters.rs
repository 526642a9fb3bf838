//! The pixels of letters: the letters of the font "8x8", and letters that this font lacks.

use font8x8::{BASIC_FONTS, GREEK_FONTS, LATIN_FONTS, UnicodeFonts};

use super::{GAP, HEIGHT};
use crate::lessons::formula::lowered;
use crate::widgets::Charset;
use crate::widgets::text::signs::superscript;

/// The height of a subscript or an exponent, in pixels.
const RAISED: usize = 5;

/// The columns of pixels in a word; `None` if any character has no letter.
pub(super) fn pixels_of(word: &str) -> Option<Vec<u8>> {
    let letters: Option<Vec<_>> = word.chars().map(letter_columns).collect();
    Some(letters?.join(&[0; GAP][..]))
}

/// The columns of pixels in a letter, without the empty columns at its sides; `None` if there is no
/// such letter.
fn letter_columns(letter: char) -> Option<Vec<u8>> {
    if letter.is_control() {
        return None;
    }
    let rows = BASIC_FONTS
        .get(letter)
        .or_else(|| LATIN_FONTS.get(letter))
        .or_else(|| own(letter))
        .or_else(|| GREEK_FONTS.get(letter))
        .or_else(|| {
            // The ASCII spelling of the letter is used if it is a single unambiguous letter.
            let text = letter.to_string();
            let plain = Charset::Ascii.text(&text);
            match plain.as_bytes() {
                [plain] if *plain != b'?' => BASIC_FONTS.get(char::from(*plain)),
                _ => None,
            }
        })?;
    let column = |x: usize| {
        let bits = rows.iter().enumerate();
        bits.fold(0, |column, (y, row)| column | (row >> x & 1) << y)
    };
    let columns: Vec<u8> = (0..HEIGHT).map(column).collect();
    let first = columns.iter().position(|it| *it != 0)?;
    let last = columns.iter().rposition(|it| *it != 0)?;
    Some(columns[first..=last].to_vec())
}

/// Letters that the font lacks, and a theta, because the font's theta looks like an e. The lowest
/// bit of a row is its left pixel.
fn own(letter: char) -> Option<[u8; HEIGHT]> {
    match letter {
        'θ' => return Some([0x1e, 0x33, 0x33, 0x3f, 0x33, 0x33, 0x1e, 0]),
        '√' => return Some([0x78, 0x08, 0x08, 0x09, 0x0b, 0x0e, 0x04, 0]),
        _ => {}
    }
    let index = ('0'..='z').find(|it| lowered(*it) == Some(letter));
    let from = index.map_or(0, |_| HEIGHT - RAISED);
    let small = small_letter(index.or_else(|| superscript(letter))?)?;
    let mut rows = [0; HEIGHT];
    rows[from..from + RAISED].copy_from_slice(&small);
    Some(rows)
}

/// The rows of a subscript or an exponent, three pixels wide.
fn small_letter(letter: char) -> Option<[u8; RAISED]> {
    // Each octal digit is a row.
    let rows: u32 = match letter {
        '0' => 0o75557,
        '1' => 0o23227,
        '2' => 0o74717,
        '3' => 0o74747,
        '4' => 0o55744,
        '5' => 0o71747,
        '6' => 0o71757,
        '7' => 0o74422,
        '8' => 0o75757,
        '9' => 0o75747,
        'n' => 0o00355,
        'r' => 0o00531,
        's' => 0o61243,
        't' => 0o27226,
        'x' => 0o00525,
        'y' => 0o05643,
        '-' => 0o00700,
        _ => return None,
    };
    Some(std::array::from_fn(|row| {
        (rows >> (3 * (RAISED - 1 - row)) & 7) as u8
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In earlier versions, large letters showed "θ₁" as "e1" and "uₙ" as "u_n".
    #[test]
    fn symbols_of_physics_have_letters_of_their_own() {
        for symbol in ["θ₁", "uₙ", "v₂ₜ", "√2", "1.14⁴", "Θ", "10⁻²⁷"] {
            assert!(pixels_of(symbol).is_some(), "{symbol}");
        }
        for (symbol, like) in [("θ", "e"), ("θ", "Θ"), ("₁", "1"), ("⁴", "4"), ("ₙ", "n")]
        {
            assert_ne!(pixels_of(symbol), pixels_of(like), "{symbol}");
        }
        // A subscript is at the bottom of the line, an exponent at the top.
        let pixels = |letter| pixels_of(letter).unwrap();
        assert!(pixels("₄").iter().all(|column| column & 0b111 == 0));
        assert!(pixels("⁴").iter().all(|column| column >> RAISED == 0));
    }
}
