//! Choices, and what each wrong one gives away.

use std::collections::BTreeMap;

use crate::quiz::dice::Dice;
use crate::quiz::{Form, Misconception, Response, WrongAnswer};

/// One of the choices of a question.
pub(super) struct Choice {
    text: String,
    stands_for: StandsFor,
}

enum StandsFor {
    Truth,
    Nobody(String),
    WrongAnswer(&'static Misconception, String),
}

impl Choice {
    /// The right one.
    pub(super) fn right(text: impl Into<String>) -> Self {
        Self::new(text, StandsFor::Truth)
    }

    /// One that is wrong and follows no known misconception, with what to say to it.
    pub(super) fn wrong(text: impl Into<String>, says: impl Into<String>) -> Self {
        Self::new(text, StandsFor::Nobody(says.into()))
    }

    /// One that follows a misconception, with what to say to whoever takes it.
    pub(super) fn of(
        misconception: &'static Misconception,
        text: impl Into<String>,
        says: impl Into<String>,
    ) -> Self {
        Self::new(text, StandsFor::WrongAnswer(misconception, says.into()))
    }

    fn new(text: impl Into<String>, stands_for: StandsFor) -> Self {
        Self {
            text: text.into(),
            stands_for,
        }
    }
}

/// Choices as they will stand.
pub(super) struct Choices {
    /// The choices, with the right one.
    pub(super) form: Form,
    /// Those that follow a misconception.
    pub(super) beliefs: Vec<WrongAnswer>,
    /// What to say to the other wrong ones.
    pub(super) replies: BTreeMap<usize, String>,
}

/// These choices in any order; `None` if none is right.
pub(super) fn shuffled(mut choices: Vec<Choice>, dice: &mut Dice) -> Option<Choices> {
    dice.shuffle(&mut choices);
    ordered(choices)
}

/// These choices as they stand; `None` if none is right.
pub(super) fn ordered(choices: Vec<Choice>) -> Option<Choices> {
    let mut right = None;
    let mut options = Vec::with_capacity(choices.len());
    let mut beliefs = Vec::new();
    let mut replies = BTreeMap::new();
    for (i, choice) in choices.into_iter().enumerate() {
        options.push(choice.text);
        match choice.stands_for {
            StandsFor::Truth => right = Some(i),
            StandsFor::Nobody(says) => {
                replies.insert(i, says);
            }
            StandsFor::WrongAnswer(misconception, says) => {
                beliefs.push(WrongAnswer::new(misconception, Response::Choice(i), says));
            }
        }
    }
    Some(Choices {
        form: Form::Choice {
            options,
            right: right?,
        },
        beliefs,
        replies,
    })
}
