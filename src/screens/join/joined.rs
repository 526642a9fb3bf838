//! A pupil's seat in the class: the question, the vote and the result.

use std::time::Duration;

use ratatui::layout::Rect;

use super::link::Link;
use crate::class::protocol::{PupilState, PupilStep};
use crate::class::{ClassStep, Said, Vote};
use crate::messages::{Key, Mouse};
use crate::quiz::{Form, Question, Response};
use crate::screens::{Context, Next};
use crate::widgets::hit::{HitPace, Reveal, Watch};
use crate::widgets::{AnswerInput, Asking, AskingAction, Outcome};

/// A pupil's seat in the class.
#[derive(Debug, Clone)]
pub(super) struct JoinedClass {
    /// The latest state from the host.
    pub(super) state: PupilState,
    /// The current question, with the true answer once it is revealed.
    pub(super) question: Option<Question>,
    pub(super) doing: Doing,
}

/// What the pupil is currently doing.
#[derive(Debug, Clone)]
pub(super) enum Doing {
    Look,
    Vote(Asking),
    Watch(Box<Reveal>),
}

impl JoinedClass {
    /// The seat in the given state, which the host has sent.
    pub(super) fn new(state: PupilState, pace: HitPace) -> Self {
        let question = state.question.as_ref().and_then(|asked| asked.question());
        let question = match (&state.revealed, question) {
            (Some(revealed), Some(question)) => revealed.revealed(question),
            (_, question) => question,
        };
        let mut joined = Self {
            doing: Doing::Look,
            question,
            state,
        };
        joined.begin(pace);
        joined
    }

    /// Applies a new state. An answer that is being typed is kept as long as the class stays at the
    /// same step.
    pub(super) fn take(&mut self, state: PupilState, pace: HitPace) {
        let same = (self.state.q, self.state.step) == (state.q, state.step);
        let stays = same && self.question.is_some() && self.state.question == state.question;
        match stays {
            true => self.state = state,
            false => *self = Self::new(state, pace),
        }
    }

    fn begin(&mut self, pace: HitPace) {
        let Some(question) = &self.question else {
            return;
        };
        self.doing = match self.state.step {
            step if step.vote().is_some() => {
                let said = self.said().map(|said| said.response);
                Doing::Vote(Asking::new(match said {
                    Some(said) => AnswerInput::saying(&question.form, &said),
                    None => AnswerInput::new(&question.form),
                }))
            }
            PupilStep::Asked(ClassStep::Shot) if self.state.revealed.is_some() => {
                Doing::Watch(Box::new(Reveal::new(self.watch(question, pace))))
            }
            _ => Doing::Look,
        };
    }

    /// The true collision, with the pupil's answer.
    fn watch(&self, question: &Question, pace: HitPace) -> Option<Watch> {
        let said = self.said().map(|said| said.response);
        let collision = match (&question.form, said) {
            (Form::Shot(aim), Some(Response::Shot(offset))) => {
                let shot = aim.with(offset);
                return Some(Watch::new(shot, None, pace).with_wanted(*aim));
            }
            (Form::Shot(aim), _) => Some(aim.with(aim.offset)),
            _ => question.picture.collision().copied(),
        };
        let rays = said.and_then(Response::rays);
        let frame = question.seen_from();
        collision.map(|collision| Watch::new(collision, rays, pace).seen_from(frame))
    }

    /// The pupil's vote that the host has recorded and that applies at this step.
    pub(super) fn said(&self) -> Option<Said> {
        let form = &self.question.as_ref()?.form;
        let parse = |text: &str| Said::parse(text).filter(|said| form.accepts(&said.response));
        match self.state.step.vote() {
            Some(Vote::First) => parse(&self.state.first),
            _ => parse(&self.state.second).or_else(|| parse(&self.state.first)),
        }
    }

    /// Whether the host has a vote that can be withdrawn.
    pub(super) fn has_voted(&self) -> bool {
        match self.state.step.vote() {
            Some(Vote::First) => !self.state.first.is_empty(),
            Some(Vote::Second) => !self.state.second.is_empty(),
            None => false,
        }
    }

    /// Carries out an action on the vote, which is cast once its confidence is chosen.
    pub(super) fn ask(&mut self, action: AskingAction, link: &mut Link, cx: &mut Context) {
        let Doing::Vote(asking) = &mut self.doing else {
            return;
        };
        if let Outcome::Done((response, sure)) = asking.act(action) {
            asking.back();
            if let Some(vote) = self.state.step.vote() {
                let sure = Some(sure);
                link.vote(self.state.q, vote, Some(Said { response, sure }), cx);
            }
        }
    }

    pub(super) fn take_back(&mut self, link: &mut Link, cx: &mut Context) {
        if let Some(vote) = self.state.step.vote() {
            link.vote(self.state.q, vote, None, cx);
        }
        if let (Doing::Vote(asking), Some(question)) = (&mut self.doing, &self.question) {
            *asking = Asking::new(AnswerInput::new(&question.form));
        }
    }

    /// Handles the mouse over the picture.
    pub(super) fn point(&mut self, mouse: &Mouse, picture: Rect, pressed: bool) -> Next {
        match (&mut self.doing, &self.question) {
            (Doing::Vote(asking), Some(question)) if mouse.is_held() => {
                let input = asking.input_mut();
                Next::after(
                    input.is_some_and(|input| {
                        input.point(question, picture, mouse.place(), pressed)
                    }),
                )
            }
            (Doing::Watch(reveal), _) if pressed => {
                if let Some(action) = reveal.keys().find(Key::Char(' ')) {
                    reveal.act(action);
                }
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    pub(super) fn advance(&mut self, passed: Duration, pace: HitPace) {
        if let Doing::Watch(reveal) = &mut self.doing {
            reveal.advance(passed, pace);
        }
    }

    pub(super) fn wake(&self, pace: HitPace) -> Option<Duration> {
        match &self.doing {
            Doing::Watch(reveal) => reveal.wake(pace),
            _ => None,
        }
    }
}
