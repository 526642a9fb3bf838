//! Trigonometric functions, including the arc sine, in spoken form.

use super::signs::power;

/// The written and the spoken names of functions.
const FUNCTIONS: [(&str, &str); 5] = [
    ("arcsin", "arc sine"),
    ("sin", "sine"),
    ("cos", "cosine"),
    ("tan", "tangent"),
    ("cot", "cotangent"),
];

/// The function at a position in the text, in words ("times the sine squared of"), and the number
/// of characters that it replaces; `None` if there is no function at this position.
pub(super) fn at(letters: &[char], place: usize) -> Option<(String, usize)> {
    let (before, here) = letters.split_at_checked(place)?;
    if before.last().is_some_and(char::is_ascii_alphabetic) {
        return None;
    }
    let (written, name) = FUNCTIONS.iter().find(|(written, _)| {
        let mut signs = here.iter();
        written.chars().all(|c| signs.next() == Some(&c))
    })?;
    let rest = &here[written.len()..];
    let (raised, signs) = power(rest).unwrap_or_default();
    let rest = &rest[signs..];
    if signs == 0 && rest.first().is_some_and(char::is_ascii_alphabetic) {
        return None;
    }
    let blanks = rest.iter().take_while(|c| **c == ' ').count();
    let has_argument = starts_argument(&rest[blanks..]);
    if !has_argument && signs == 0 {
        return None;
    }
    let times = if is_factor(before) { " times" } else { "" };
    let of = if has_argument { " of " } else { "" };
    let taken = written.len() + signs + if has_argument { blanks } else { 0 };
    Some((format!("{times} the {name}{raised}{of}"), taken))
}

/// Whether a word is the name of a function.
pub(in crate::shells::plain) fn is_function(word: &str) -> bool {
    FUNCTIONS.iter().any(|(written, _)| *written == word)
}

/// Whether an argument begins here: a number, a bracket or a symbol, but not a word.
fn starts_argument(letters: &[char]) -> bool {
    match letters {
        ['(' | '√' | '½', ..] => true,
        ['-' | '−', next, ..] => *next != ' ',
        [one, next, ..] if one.is_ascii_alphabetic() => !next.is_ascii_alphabetic(),
        [one, ..] => one.is_alphanumeric(),
        [] => false,
    }
}

/// Whether the text ends in a factor before a function: a number, a bracket, or the symbol of a
/// quantity.
fn is_factor(letters: &[char]) -> bool {
    let end = letters.iter().rposition(|c| *c != ' ');
    let Some((last, before)) = end.and_then(|end| letters[..=end].split_last()) else {
        return false;
    };
    match last {
        'a' | 'A' | 'I' => false,
        c if c.is_ascii_alphabetic() => !before.last().is_some_and(char::is_ascii_alphabetic),
        ')' | '°' | '½' => true,
        c => c.is_alphanumeric(),
    }
}
