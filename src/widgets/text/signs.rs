//! Superscript characters, which are spelt out on ASCII screens and in plain mode.

use crate::lessons::formula::raised;

/// The digit or sign that corresponds to a superscript character.
pub(crate) fn superscript(letter: char) -> Option<char> {
    // Most letters are ASCII, and this is asked for each letter of each text.
    let mut signs = "-0123456789".chars().filter(|_| !letter.is_ascii());
    signs.find(|it| raised(*it) == Some(letter))
}
