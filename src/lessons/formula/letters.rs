//! The names of letters and signs, and the superscript and subscript characters of formulas.

use crate::numbers::{RAISED_DIGITS, greek};

/// The Greek letters of formulas.
const GREEK: &str = "αβγδεηθλμνπρστφψωΔΘΣΦΩ";

/// The letter or sign that a word stands for in a formula; `None` for any other word.
pub(super) fn letter(word: &str) -> Option<char> {
    match word {
        "times" => Some('×'),
        "dot" => Some('·'),
        "approx" => Some('≈'),
        "perp" => Some('⟂'),
        "infinity" => Some('∞'),
        "deg" => Some('°'),
        // The spelling of Δ ends in a space.
        _ => GREEK
            .chars()
            .find(|it| greek(*it).map(str::trim_end) == Some(word)),
    }
}

/// The subscript form of a letter.
pub(crate) fn lowered(letter: char) -> Option<char> {
    Some(match letter {
        '0'..='9' => char::from_u32('₀' as u32 + (letter as u32 - '0' as u32))?,
        'n' => 'ₙ',
        't' => 'ₜ',
        'x' => 'ₓ',
        'y' => 'ᵧ',
        's' => 'ₛ',
        'r' => 'ᵣ',
        '⟂' => '⟂',
        _ => return None,
    })
}

/// The superscript form of a letter.
pub(crate) fn raised(letter: char) -> Option<char> {
    Some(match letter {
        '-' | '−' => '⁻',
        _ => RAISED_DIGITS[letter.to_digit(10)? as usize],
    })
}
