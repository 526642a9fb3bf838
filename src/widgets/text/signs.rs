//! Superscript characters, which are spelt out on ASCII screens and in plain mode.

use crate::numbers::RAISED_DIGITS;

/// The digit or sign that corresponds to a superscript character.
pub(crate) fn superscript(letter: char) -> Option<char> {
    let digit = |letter| (0..10).zip(RAISED_DIGITS).find(|(_, it)| *it == letter);
    match letter {
        '⁻' => Some('-'),
        _ => char::from_digit(digit(letter)?.0, 10),
    }
}
