//! Superscript characters, which are spelt out on ASCII screens and in plain mode.

use crate::lessons::formula::raised;

/// The digit or sign that corresponds to a superscript character.
pub(crate) fn superscript(letter: char) -> Option<char> {
    // Most letters of a text are ASCII, and the search below is slow.
    if letter.is_ascii() {
        return None;
    }
    "-0123456789".chars().find(|it| raised(*it) == Some(letter))
}
