//! What really happens, and why.

use std::time::Duration;

use crate::class::{ClassRound, Vote};
use crate::messages::Key;
use crate::quiz::{
    Answer, Confidence, Form, Misconception, Question, Said, explain, misconceptions,
};
use crate::widgets::hit::Watch;

/// What really happens, and why.
#[derive(Debug, Clone)]
pub(super) struct Shown {
    /// The hit, where the question is about one.
    pub(super) watch: Option<Watch>,
    /// Whether the outcome has been told; it stays so while the hit is seen again.
    pub(super) told: bool,
    /// What most teams that were wrong alike believed, and how many of them.
    pub(super) held: Option<(&'static Misconception, usize)>,
    /// Why it is as it is.
    pub(super) why: String,
}

impl Shown {
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
        let watch = watch(question, said, reduced);
        Some(Self {
            told: watch.as_ref().is_none_or(Watch::is_told),
            watch,
            held: held.map(|(misconception, count, _)| (misconception, count)),
            why,
        })
    }

    /// Takes a key of the hit's; says whether it was one.
    pub(super) fn update(&mut self, key: Key) -> bool {
        let Some(watch) = &mut self.watch else {
            return false;
        };
        let key = match key {
            Key::Char(' ') if watch.clock().is_over() => Key::Char('a'),
            key => key,
        };
        let taken = watch.update(key);
        self.told |= watch.is_told();
        taken
    }

    /// Lets time pass.
    pub(super) fn advance(&mut self, passed: Duration) {
        if let Some(watch) = &mut self.watch {
            watch.advance(passed);
            self.told |= watch.is_told();
        }
    }

    /// Tells what happened at once.
    pub(super) fn tell(&mut self) {
        if let Some(watch) = &mut self.watch {
            watch.tell();
        }
        self.told = true;
    }
}

/// The hit as it really goes, with what was said beside it. What is to be answered by
/// shooting is shot as it should be.
fn watch(question: &Question, said: Option<Said>, reduced: bool) -> Option<Watch> {
    let collision = match &question.form {
        Form::Shot(aim) => Some(aim.with(aim.offset)),
        _ => question.picture.collision().copied(),
    };
    let rays = match said {
        Some(Said::Rays(rays)) => Some(rays),
        _ => None,
    };
    collision.map(|collision| Watch::new(collision, rays, reduced))
}

/// The misconception that most of these votes fit, how many do, and one of them; a
/// second vote that was not given is the first one. Of equals the first of all.
fn commonest(
    round: &ClassRound,
    question: usize,
    vote: Vote,
) -> Option<(&'static Misconception, usize, Said)> {
    let votes = (0..round.teams().len()).filter_map(|team| {
        let ballot = round.ballot(question, team);
        match vote {
            Vote::First => ballot.first,
            Vote::Second => ballot.counts(),
        }
    });
    let held: Vec<_> = votes
        .filter_map(|said| {
            let diagnosis = round.diagnose(question, Some(said))?;
            Some((diagnosis.misconception, said))
        })
        .collect();
    let mut counted: Vec<_> = misconceptions::all()
        .filter_map(|it| {
            let mut votes = held.iter().filter(|(other, _)| *other == it);
            let (_, said) = votes.next()?;
            Some((it, 1 + votes.count(), *said))
        })
        .collect();
    counted.sort_by_key(|(_, count, _)| std::cmp::Reverse(*count));
    counted.first().copied()
}
