//! What really happens, and why.

use crate::class::{ClassRound, Vote};
use crate::quiz::misconceptions::most_held;
use crate::quiz::{Answer, Confidence, Form, Misconception, Question, Response, explain};
use crate::widgets::hit::{Reveal, Watch};

/// What really happens, and why.
#[derive(Debug, Clone)]
pub(super) struct ClassReveal {
    /// The hit, where the question is about one.
    pub(super) reveal: Reveal,
    /// What most teams that were wrong alike believed, and how many of them.
    pub(super) held: Option<(Misconception, usize)>,
    /// Why it is as it is.
    pub(super) why: String,
}

impl ClassReveal {
    /// The truth of a question, told from what the class said.
    pub(super) fn new(round: &ClassRound, number: usize, reduced: bool) -> Option<Self> {
        let question = round.questions().get(number)?;
        // What they say after talking, or what they said before it.
        let held = commonest(round, number, Vote::Second)
            .or_else(|| commonest(round, number, Vote::First));
        let said = held.map(|(_, _, said)| said);
        let why = match said {
            Some(said) => {
                let answer = Answer::new(said, Confidence::ThinkSo);
                explain(question, &answer).text
            }
            None => question.why.clone(),
        };
        Some(Self {
            reveal: Reveal::new(watch(question, said, reduced)),
            held: held.map(|(misconception, count, _)| (misconception, count)),
            why,
        })
    }
}

/// The hit as it really goes, with what was said beside it. What is to be answered by
/// shooting is shot as it should be.
fn watch(question: &Question, said: Option<Response>, reduced: bool) -> Option<Watch> {
    let collision = match &question.form {
        Form::Shot(aim) => Some(aim.with(aim.offset)),
        _ => question.picture.collision().copied(),
    };
    let rays = match said {
        Some(Response::Rays(rays)) => Some(rays),
        _ => None,
    };
    collision.map(|collision| Watch::new(collision, rays, reduced))
}

/// The misconception that most votes fit, how many do, and one of them. Of equals the
/// first of all.
fn commonest(
    round: &ClassRound,
    question: usize,
    vote: Vote,
) -> Option<(Misconception, usize, Response)> {
    let (held, said): (Vec<_>, Vec<_>) = round.held(question, vote).unzip();
    let (misconception, count) = most_held(&held)?;
    let first = held.iter().position(|it| *it == misconception)?;
    Some((misconception, count, said[first]))
}
