//! Parallel forms: questions before a unit, and different ones after it that test the same ideas.

use std::collections::BTreeSet;
use std::mem::discriminant;

use super::even;
use crate::quiz::question::{Dice, Family, Form, Misconception, Question, Rays, Response};

/// How many questions are drawn in search of one that is parallel to another.
const DRAWS: usize = 1500;
/// How many questions are tried in search of one that has a parallel question.
const TRIES: usize = 30;

/// The questions of both forms. The questions are mixed, so that every common misconception is
/// tested. The family of questions in words is left out; most questions of the other families have
/// many parallel ones.
pub(super) fn pairs(families: &[Family], count: usize, dice: &mut Dice) -> [Vec<Question>; 2] {
    let mut families = families.to_vec();
    families.retain(|family| *family != Family::Concept);
    let drawn = even::questions(&families, count, dice);
    let mut forms: [Vec<Question>; 2] = Default::default();
    for asked in &drawn {
        let mut asked = asked.clone();
        let mut other = None;
        for _ in 0..TRIES {
            other = parallel(&asked, &forms, dice);
            if other.is_some() {
                break;
            }
            // A question that is the only one of its kind is replaced.
            let next = dice.pick(&families);
            let next = next.and_then(|family| family.ask(asked.difficulty, dice));
            let is_new = |it: &Question| {
                let mut all = forms.iter().flatten().chain(&drawn);
                !all.any(|old| is_alike(old, it))
            };
            asked = next.map(|(it, _)| it).filter(is_new).unwrap_or(asked);
        }
        let other = other.unwrap_or_else(|| asked.clone());
        for (form, question) in forms.iter_mut().zip([asked, other]) {
            form.push(question);
        }
    }
    forms
}

/// A question of the same family, topic, difficulty and form that asks for the same quantity and
/// can show the same misconceptions, but with other numbers.
fn parallel(asked: &Question, forms: &[Vec<Question>; 2], dice: &mut Dice) -> Option<Question> {
    (0..DRAWS).find_map(|_| {
        let (drawn, _) = asked.family.ask(asked.difficulty, dice)?;
        let mut others = forms.iter().flatten().chain([asked]);
        let is_parallel = drawn.topic == asked.topic
            && discriminant(&drawn.form) == discriminant(&asked.form)
            && drawn.figures.get("asked") == asked.figures.get("asked")
            && held(&drawn) == held(asked)
            && !others.any(|it| is_alike(it, &drawn));
        is_parallel.then_some(drawn)
    })
}

/// Whether two questions have the same text, or the same family, topic, quantity and answer (within
/// the tolerance and apart from its side).
fn is_alike(one: &Question, other: &Question) -> bool {
    if one.text == other.text {
        return true;
    }
    let [truth, answer] = [one, other].map(|it| on_one_side(it.form.truth()));
    (one.family, &one.topic) == (other.family, &other.topic)
        && one.figures.get("asked") == other.figures.get("asked")
        && !matches!(one.form, Form::Choice { .. })
        && one.form.accepts(&answer)
        && one.form.distance(&answer, &truth) <= 1.0
}

/// An answer without its side.
fn on_one_side(answer: Response) -> Response {
    match answer {
        Response::Rays(Rays { striker, target }) => Response::Rays(Rays {
            striker: striker.map(f64::abs),
            target: target.map(f64::abs),
        }),
        answer => answer,
    }
}

/// The misconceptions that a question can show, classified as when the codes of rounds were fixed:
/// see `WrongAnswer::in_codes`.
fn held(question: &Question) -> BTreeSet<&'static str> {
    let held = question.beliefs.iter().filter_map(|it| it.in_codes());
    held.map(Misconception::id).collect()
}
