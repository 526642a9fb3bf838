//! The questions in words: one idea each.

use super::outline::Outline;
use crate::quiz::concepts::{self, Concept};
use crate::quiz::question::{Dice, Difficulty, Illustration, Markings, Question};

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let concepts = concepts::all().iter();
    let concepts: Vec<&Concept> = concepts.filter(|it| it.difficulty == difficulty).collect();
    question(dice.pick(&concepts)?, dice)
}

/// The question made from a concept, its choices shuffled unless they have an order of their own.
pub(in crate::quiz) fn question(concept: &Concept, dice: &mut Dice) -> Option<Question> {
    let picture = match concept.hit {
        Some(collision) => Illustration::before(collision, Markings::default()),
        None => Illustration::Nothing,
    };
    let choices = concept.choices();
    let right = choices.iter().position(|(_, wrong)| wrong.is_none());
    let mut draft = Outline::new(&concept.ask, picture)
        .topic(concept.topic())
        .figure("id", concept.id.as_str())
        .options(choices.iter().map(|(text, _)| *text), right?);
    for (place, (_, wrong)) in choices.iter().enumerate() {
        if let Some(wrong) = wrong {
            draft = draft.chooses(wrong.misconception, place).says(&wrong.says);
        }
    }
    if !concept.ordered {
        draft = draft.shuffled(dice);
    }
    Some(Question {
        family: super::Family::Concept,
        difficulty: concept.difficulty,
        ..draft.why(&concept.why)?
    })
}
