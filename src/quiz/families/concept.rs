//! Questions in words, each about one idea.

use super::outline::Outline;
use crate::quiz::concepts::{self, Concept};
use crate::quiz::question::{Dice, Difficulty, Family, Illustration, Markings, Question};

/// A random question in words from this family, of this difficulty.
pub(super) fn ask(family: Family, difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let mut concepts = concepts::of(family);
    concepts.retain(|it| it.difficulty == difficulty);
    question(dice.pick(&concepts)?, dice)
}

/// The question of a concept, with its choices shuffled unless they have a natural order.
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
        family: concept.family,
        difficulty: concept.difficulty,
        ..draft.why(&concept.why)?
    })
}
