//! Choices, and what each wrong one gives away.

use crate::quiz::dice::Dice;
use crate::quiz::{Belief, Form, Misconception, Said};

/// One of the choices of a question.
pub(super) struct Choice {
    text: String,
    stands_for: StandsFor,
}

enum StandsFor {
    Truth,
    Nobody,
    Belief(&'static Misconception, String),
}

impl Choice {
    /// The right one.
    pub(super) fn right(text: impl Into<String>) -> Self {
        Self::new(text, StandsFor::Truth)
    }

    /// One that is wrong and follows no known misconception.
    pub(super) fn wrong(text: impl Into<String>) -> Self {
        Self::new(text, StandsFor::Nobody)
    }

    /// One that follows a misconception, with what to say to whoever takes it.
    pub(super) fn of(
        misconception: &'static Misconception,
        text: impl Into<String>,
        says: impl Into<String>,
    ) -> Self {
        Self::new(text, StandsFor::Belief(misconception, says.into()))
    }

    fn new(text: impl Into<String>, stands_for: StandsFor) -> Self {
        Self {
            text: text.into(),
            stands_for,
        }
    }
}

/// The form and the beliefs of these choices, in any order.
pub(super) fn shuffled(mut choices: Vec<Choice>, dice: &mut Dice) -> Option<(Form, Vec<Belief>)> {
    dice.shuffle(&mut choices);
    ordered(choices)
}

/// The form and the beliefs of these choices as they stand; `None` if none is right.
pub(super) fn ordered(choices: Vec<Choice>) -> Option<(Form, Vec<Belief>)> {
    let mut right = None;
    let mut options = Vec::with_capacity(choices.len());
    let mut beliefs = Vec::new();
    for (i, choice) in choices.into_iter().enumerate() {
        options.push(choice.text);
        match choice.stands_for {
            StandsFor::Truth => right = Some(i),
            StandsFor::Nobody => {}
            StandsFor::Belief(misconception, says) => {
                beliefs.push(Belief::new(misconception, Said::Choice(i), says));
            }
        }
    }
    let form = Form::Choice {
        options,
        right: right?,
    };
    Some((form, beliefs))
}
