//! The written questions: one idea each, in words.

use serde_json::json;

use super::choices::{Choice, ordered, shuffled};
use super::setting::more;
use crate::quiz::concepts::{self, Concept};
use crate::quiz::dice::Dice;
use crate::quiz::{Difficulty, Family, Illustration, Markings, Question};

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let items: Vec<&Concept> = concepts::all()
        .iter()
        .filter(|concept| concept.difficulty == difficulty)
        .collect();
    question(dice.pick(&items)?, dice)
}

/// The question of a written one: its choices in their order, or in any.
pub(in crate::quiz) fn question(concept: &Concept, dice: &mut Dice) -> Option<Question> {
    let choices = concept.choices().into_iter().map(|choice| match choice {
        concepts::Choice::Right(text) => Choice::right(text),
        concepts::Choice::Wrong(wrong) => match wrong.misconception {
            Some(misconception) => Choice::of(misconception, &wrong.choice, &wrong.says),
            None => Choice::wrong(&wrong.choice, &wrong.says),
        },
    });
    let choices = choices.collect();
    let choices = if concept.ordered {
        ordered(choices)
    } else {
        shuffled(choices, dice)
    }?;
    let picture = match concept.hit {
        Some(collision) => Illustration::Before {
            collision,
            shown: Markings::default(),
        },
        None => Illustration::Nothing,
    };
    Some(Question {
        family: Family::Concept,
        difficulty: concept.difficulty,
        topic: concept.topic(),
        text: concept.ask.clone(),
        picture,
        form: choices.form,
        beliefs: choices.beliefs,
        replies: choices.replies,
        why: concept.why.clone(),
        figures: more([("id", json!(concept.id))]),
    })
}
