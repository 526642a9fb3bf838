//! The quiz, the lessons and a lab in plain lines: for screen readers, Braille displays, dumb
//! terminals and scripts.
//!
//! Nothing here draws, moves a cursor or waits for a time. A line is said, a line is
//! heard, and what a picture would show is said in words: all that is needed to answer,
//! and no more than the picture gives. Signs are spelt as they are read aloud.

mod answering;
mod by_words;
mod figure;
mod formula;
mod learn;
mod number;
mod own_shot;
mod picture;
mod quiz;
mod recorder;
mod solve;
mod spoken;
mod talk;
mod working;

pub use learn::learn;
pub use own_shot::lab;
pub use quiz::quiz;
pub use recorder::{AnswerRecorder, Keeper};
pub use solve::solve;
pub use spoken::spoken;
pub use talk::{Leave, Talk};

/// Makes sure that a line is in words, down to its last sign.
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
        // Nobody is told to do what only hands and eyes can.
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
    // A unit is not followed by a number that stands below a letter.
    for unit in ["metres ", "metre ", "grams ", "seconds "] {
        for (at, _) in line.match_indices(unit) {
            let next = line[at + unit.len()..].chars().next();
            assert!(!next.is_some_and(|c| c.is_ascii_digit()), "{line}");
        }
    }
}
