//! The app in plain lines: for screen readers, Braille displays, dumb terminals and scripts.
//!
//! The blocks of the screen are recorded while it is drawn and then written line by line. An input
//! line replaces keys and clicks. The output never moves a cursor and never waits for a fixed time,
//! and symbols are written as they are read aloud.

mod by_words;
mod formula;
mod number;
mod page;
mod reader;
#[cfg(not(target_family = "wasm"))]
mod run;
mod solve;
mod spoken;
mod talk;
#[cfg(test)]
mod tests;
mod working;

pub use reader::PlainReader;
#[cfg(not(target_family = "wasm"))]
pub use run::run;
pub use solve::solve;
pub use spoken::spoken;
pub use talk::{Leave, Talk};

/// Asserts that a line contains only words.
#[cfg(test)]
fn assert_spoken(line: &str) {
    let plain = |c: char| c.is_ascii_alphanumeric() || " .,;:?!'\"()-/".contains(c);
    assert!(line.chars().all(plain), "{line}");
    let words = line.split(|c: char| !c.is_ascii_alphanumeric());
    for word in words {
        assert!(!spoken::is_function(word), "{word}: {line}");
    }
    for never in [
        "?.",
        "!.",
        "  ",
        " 1 metres",
        " 1 grams",
        " 1 degrees",
        "the the ",
        // No instruction may require a mouse or sight.
        "Drag the ",
        "drag the ",
        "Press ",
        "ook at the picture",
        "ook at the figure",
        "ook again",
        " click ",
        "the mouse",
    ] {
        assert!(!line.contains(never), "{never}: {line}");
    }
    // A subscript must not follow a unit.
    for unit in ["metres ", "metre ", "grams ", "seconds "] {
        for (at, _) in line.match_indices(unit) {
            let next = line[at + unit.len()..].chars().next();
            assert!(!next.is_some_and(|c| c.is_ascii_digit()), "{line}");
        }
    }
}
