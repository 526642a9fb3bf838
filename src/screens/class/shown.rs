//! What really happens, and why.

use crate::class::{ClassRound, Vote};
use crate::quiz::{Answer, Confidence, Form, Question, Response, evidence, explain, letter};
use crate::widgets::hit::{HitPace, Reveal, Watch};

/// What really happens, and why.
#[derive(Debug, Clone)]
pub(super) struct ClassReveal {
    /// The hit, where the question is about one.
    pub(super) reveal: Reveal,
    /// What most teams that were wrong in the same way said, and how many of them: the name of
    /// the misconception that fits, or else the letter of their choice.
    pub(super) held: Option<(String, usize)>,
    /// Why it is as it is.
    pub(super) why: String,
}

impl ClassReveal {
    /// The truth of a question, told from what the class said.
    pub(super) fn new(round: &ClassRound, number: usize, pace: HitPace) -> Option<Self> {
        let question = round.questions().get(number)?;
        // What they say after talking, or what they said before it.
        let held = commonest(round, number, Vote::Second)
            .or_else(|| commonest(round, number, Vote::First));
        let said = held.as_ref().map(|shared| shared.said);
        let why = match said {
            Some(said) => {
                let answer = Answer::new(said, Confidence::ThinkSo);
                explain(question, &answer).text
            }
            None => question.why.clone(),
        };
        Some(Self {
            reveal: Reveal::new(watch(question, said, pace)),
            held: held.map(|shared| (shared.name, shared.count)),
            why,
        })
    }
}

/// The hit as it really goes, with what was said beside it. What is to be answered by
/// shooting is shot as it should be.
fn watch(question: &Question, said: Option<Response>, pace: HitPace) -> Option<Watch> {
    let collision = match &question.form {
        Form::Shot(aim) => Some(aim.with(aim.offset)),
        _ => question.picture.collision().copied(),
    };
    let rays = match said {
        Some(Response::Rays(rays)) => Some(rays),
        _ => None,
    };
    let frame = question.seen_from();
    collision.map(|collision| Watch::new(collision, rays, pace).seen_from(frame))
}

/// What several votes that were wrong have in common.
struct SharedAnswer {
    name: String,
    count: usize,
    /// One of the votes.
    said: Response,
}

/// The commonest of what wrong votes have in common; of equals a misconception.
fn commonest(round: &ClassRound, question: usize, vote: Vote) -> Option<SharedAnswer> {
    let shared = [
        commonest_reply(round, question, vote),
        commonest_belief(round, question, vote),
    ];
    shared.into_iter().flatten().max_by_key(|it| it.count)
}

/// The misconception for which the votes speak most.
fn commonest_belief(round: &ClassRound, question: usize, vote: Vote) -> Option<SharedAnswer> {
    let all = evidence(&round.clues(question, vote));
    let most = all.into_iter().find(|it| it.times > 0)?;
    let mut held = round.held(question, vote);
    let (misconception, said) = held.find(|(held, _)| *held == most.misconception)?;
    Some(SharedAnswer {
        name: misconception.name().into(),
        count: most.times,
        said,
    })
}

/// The wrong choice of most votes among those that fit no misconception and yet have something
/// to be told. Of equals the first.
fn commonest_reply(round: &ClassRound, question: usize, vote: Vote) -> Option<SharedAnswer> {
    let replies = &round.questions().get(question)?.replies;
    let said: Vec<Response> = round.said(question, vote).collect();
    let chosen = |choice| {
        said.iter()
            .filter(|it| **it == Response::Choice(choice))
            .count()
    };
    let counts = replies
        .keys()
        .rev()
        .map(|choice| (*choice, chosen(*choice)));
    let (choice, count) = counts.max_by_key(|(_, count)| *count)?;
    (count > 0).then(|| SharedAnswer {
        name: format!("answer {}", letter(choice)),
        count,
        said: Response::Choice(choice),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::Code;

    /// A wrong choice that fits no known misconception is told what the question has to say to it.
    #[test]
    fn a_choice_without_a_misconception_is_answered_too() {
        let teams = || ["Ants", "Bees", "Cats"].map(Into::into).to_vec();
        let mut rounds = (0..200).filter_map(|seed| {
            let code = Code::parse(&format!("concept1-{seed}"))?;
            Some(ClassRound::new(code, teams()))
        });
        let found = rounds.find(|round| !round.questions()[0].replies.is_empty());
        let mut round = found.unwrap();
        let question = round.questions()[0].clone();
        let (choice, reply) = question.replies.iter().next().unwrap();
        let votes = [
            Response::Choice(*choice),
            Response::Choice(*choice),
            question.form.truth(),
        ];
        for (team, vote) in votes.into_iter().enumerate() {
            round.vote(0, team, Vote::First, Some(vote));
        }
        let shown = ClassReveal::new(&round, 0, HitPace::default()).unwrap();
        assert_eq!(shown.held, Some((format!("answer {}", letter(*choice)), 2)));
        assert!(shown.why.contains(reply), "{}", shown.why);
    }
}
