//! The states that pupils on devices receive.

use super::asked::{AskedQuestion, RevealedTruth};
use super::ballot::{Vote, feedback};
use super::protocol::{PupilState, PupilStep, VERSION};
use super::round::{ClassRound, Participant};
use super::scores::standings;
use super::step::ClassStep;
use crate::quiz::{Form, Question, Response};

/// The part of the state that is the same for all pupils.
pub(super) struct PupilView<'r> {
    round: &'r ClassRound,
    step: PupilStep,
    question: Option<&'r Question>,
    asked: Option<AskedQuestion>,
    spread: Vec<u32>,
    /// The points and the rank of each participant, at the scoreboard and at the end.
    scores: Vec<Option<(f64, usize)>>,
}

impl<'r> PupilView<'r> {
    /// The common state at a step; `with_points` is the number of questions with points so far.
    pub(super) fn new(round: &'r ClassRound, step: PupilStep, with_points: usize) -> Self {
        let number = round.place().question;
        let question = round.questions().get(number);
        let is = |steps: [ClassStep; 2]| steps.map(PupilStep::Asked).contains(&step);
        let mut spread = Vec::new();
        if let Some(Form::Choice { options, .. }) = question.map(|it| &it.form)
            && is([ClassStep::Talk, ClassStep::SecondVote])
        {
            let choices = (0..options.len()).map(Response::Choice);
            let counts = choices.map(|it| round.votes_for(number, Vote::First, it) as u32);
            spread = counts.collect();
        }
        let mut scores = vec![None; round.participants().len()];
        if [PupilStep::Asked(ClassStep::Scores), PupilStep::End].contains(&step) {
            for it in standings(round, with_points) {
                if let Some(score) = scores.get_mut(it.team) {
                    *score = Some((it.points, it.place));
                }
            }
        }
        let asked = question.filter(|_| matches!(step, PupilStep::Asked(_)));
        Self {
            round,
            step,
            question: question.filter(|_| is([ClassStep::Shot, ClassStep::Scores])),
            asked: asked.map(AskedQuestion::new),
            spread,
            scores,
        }
    }

    pub(super) fn state(&self, person: usize, one: &Participant) -> Option<PupilState> {
        let q = self.round.place().question;
        let ballot = one.ballot(q);
        let open = self.step.vote();
        Some(PupilState {
            v: VERSION,
            rev: one.device.rev,
            seat: one.seat?,
            name: one.name().to_owned(),
            q,
            of: self.round.questions().len(),
            step: self.step,
            n: one.device.n,
            misfit: open.is_some_and(|vote| one.device.misfit == Some((q, vote))),
            first: ballot.given(Vote::First),
            second: ballot.given(Vote::Second),
            question: self.asked.clone(),
            spread: self.spread.clone(),
            revealed: self.question.map(|it| self.truth(it, person, one)),
            score: self.scores.get(person).copied().flatten(),
            handed: one.device.handed,
        })
    }

    /// The right answer, with the feedback on this pupil's answer.
    fn truth(&self, question: &Question, person: usize, one: &Participant) -> RevealedTruth {
        let number = self.round.place().question;
        let said = one.ballot(number).counts();
        let points = said.map(|_| self.round.points(number, person));
        RevealedTruth::new(question, feedback(question, said), points)
    }
}
