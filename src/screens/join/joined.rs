//! A pupil's seat in the class: the question, the vote and the result.

use std::time::Duration;

use ratatui::layout::Rect;

use crate::class::protocol::{PupilState, PupilStep};
use crate::class::{ClassStep, Said, Vote};
use crate::messages::{Key, Mouse};
use crate::quiz::{Form, Question, Response};
use crate::screens::Next;
use crate::widgets::hit::{HitPace, Reveal, Watch};
use crate::widgets::{AnswerInput, Asking};

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
                Doing::Vote(Asking::new(AnswerInput::saying(&question.form, said)))
            }
            PupilStep::Asked(ClassStep::Shot) if self.state.revealed.is_some() => {
                Doing::Watch(Box::new(Reveal::new(self.watch(question, pace))))
            }
            _ => Doing::Look,
        };
    }

    /// The true collision, with the pupil's answer; if the answer is a shot, the collision that it
    /// causes.
    fn watch(&self, question: &Question, pace: HitPace) -> Option<Watch> {
        let said = self.said().map(|said| said.response);
        match (&question.form, said) {
            (Form::Shot(aim), Some(Response::Shot(offset))) => {
                Some(Watch::new(aim.with(offset), None, pace).with_wanted(*aim))
            }
            _ => Watch::of_question(question, said, pace),
        }
    }

    /// The pupil's vote that the host has recorded and that applies at this step.
    pub(super) fn said(&self) -> Option<Said> {
        let form = &self.question.as_ref()?.form;
        let fits = |said: &Said| form.accepts(&said.response);
        let first = self.state.first.filter(fits);
        match self.state.step.vote() {
            Some(Vote::First) => first,
            _ => self.state.second.filter(fits).or(first),
        }
    }

    /// Whether the host has a vote that can be withdrawn.
    pub(super) fn has_voted(&self) -> bool {
        match self.state.step.vote() {
            Some(Vote::First) => self.state.first.is_some(),
            Some(Vote::Second) => self.state.second.is_some(),
            None => false,
        }
    }

    /// Handles the mouse over the picture.
    pub(super) fn point(&mut self, mouse: &Mouse, picture: Rect) -> Next {
        let pressed = mouse.presses(picture);
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
