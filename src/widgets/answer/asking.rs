//! Answering a question, then choosing a confidence level; shared by all screens that ask questions
//! this way.

use strum::{EnumMessage, IntoStaticStr};

use super::{AnswerAction, AnswerInput};
use crate::messages::Key;
use crate::physics::Collision;
use crate::quiz::{Confidence, Form, Response, letter};
use crate::widgets::input::KeyTable;
use crate::widgets::panel::Panel;
use crate::widgets::panels::said_and_true;
use crate::widgets::{Outcome, Role};

/// A question being answered.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Asking {
    input: AnswerInput,
    /// The confidence; `None` until the answer is given.
    sure: Option<Confidence>,
}

/// What the keys do while a question is being answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum AskingAction {
    /// give an answer
    Answer(AnswerAction),
    /// guess, think so, sure
    Sure(usize),
    /// choose how sure you are
    MoreSure(isize),
    /// confirm how sure you are
    Take,
}

impl Asking {
    /// A question whose answer is being entered.
    pub(crate) fn new(input: AnswerInput) -> Self {
        Self { input, sure: None }
    }

    /// The answer being entered.
    pub(crate) fn input(&self) -> &AnswerInput {
        &self.input
    }

    /// The answer being entered; `None` once it has been given.
    pub(crate) fn input_mut(&mut self) -> Option<&mut AnswerInput> {
        self.sure.is_none().then_some(&mut self.input)
    }

    /// The confidence chosen so far; `None` until the answer is given.
    pub(crate) fn sure(&self) -> Option<Confidence> {
        self.sure
    }

    /// Goes back from the confidence level to the answer; returns whether that was possible.
    pub(crate) fn back(&mut self) -> bool {
        self.sure.take().is_some()
    }

    /// The keys, in the screen's group; `next` is the label for confirming the confidence level.
    pub(crate) fn keys(&self, group: &'static str, next: &'static str) -> KeyTable<AskingAction> {
        use AskingAction::{Answer, MoreSure, Sure, Take};
        let keys = KeyTable::new(group);
        if self.sure.is_none() {
            return keys.with(self.input.keys(), Answer);
        }
        let sure = ('1'..).zip((0..Confidence::ALL.len()).map(Sure));
        keys.each(sure, "how sure")
            .by([Key::Up, Key::Down], MoreSure, [-1, 1], "choose")
            .or([(Key::Left, MoreSure(-1)), (Key::Right, MoreSure(1))])
            .or([(Key::BackTab, MoreSure(-1)), (Key::Tab, MoreSure(1))])
            .on(Key::Enter, Take, next)
            .or([(Key::Char(' '), Take)])
    }

    /// Whether the screen may use Escape; while a number is being typed, Escape cancels the number
    /// instead.
    pub(crate) fn leaves_escape(&self) -> bool {
        self.sure.is_some() || self.input.keys().exact(Key::Escape).is_none()
    }

    /// Carries out an action; returns `Done` with the answer and the confidence once both are
    /// given.
    pub(crate) fn act(&mut self, action: AskingAction) -> Outcome<(Response, Confidence)> {
        let chosen = match (action, self.sure) {
            (AskingAction::Answer(action), None) => {
                let outcome = self.input.act(action);
                if outcome == Outcome::Done(()) {
                    self.sure = Some(Confidence::ThinkSo);
                }
                return match outcome {
                    Outcome::Ignored => Outcome::Ignored,
                    _ => Outcome::Used,
                };
            }
            (AskingAction::MoreSure(by), Some(sure)) => {
                let last = Confidence::ALL.len() - 1;
                let at = (sure as usize).saturating_add_signed(by).min(last);
                self.sure = Some(Confidence::ALL[at]);
                return Outcome::Used;
            }
            (AskingAction::Sure(at), Some(_)) => Confidence::ALL.get(at).copied(),
            (AskingAction::Take, sure) => sure,
            _ => None,
        };
        let said = chosen.and_then(|sure| Some((self.input.said()?, sure)));
        said.map_or(Outcome::Ignored, Outcome::Done)
    }

    /// Writes the confidence levels, each followed by its values in the columns headed `heads`.
    pub(crate) fn write_confidence(
        &self,
        heads: &[&str],
        beside: impl Fn(Confidence) -> Vec<String>,
        panel: &mut Panel<AskingAction>,
    ) {
        panel.heading("How sure are you?");
        if let Some((first, heads)) = heads.split_first() {
            let heads = heads.iter().map(|head| (*head, Role::Dim));
            panel.columns((*first, Role::Dim), heads);
        }
        for (at, confidence) in Confidence::ALL.into_iter().enumerate() {
            let name = format!("{} {}", at + 1, confidence.name());
            let chosen = self.sure == Some(confidence);
            panel.choice_columns(name, beside(confidence), chosen, AskingAction::Sure(at));
        }
    }

    /// Writes the answer so far.
    pub(crate) fn write_said<A>(&self, form: &Form, panel: &mut Panel<A>) {
        if let (AnswerInput::Rays(rays), Form::Rays { target, .. }) = (&self.input, form) {
            return rays.write_said(target, panel);
        }
        if let Some(said) = self.input.said() {
            panel.paragraph(lettered(form, &said), Role::Predicted);
        }
    }
}

/// Writes an answer, if there is one, beside the true one: the rays of a collision in a table, other
/// answers as text.
pub(crate) fn write_beside_truth<A>(
    form: &Form,
    hit: Option<&Collision>,
    said: Option<Response>,
    panel: &mut Panel<A>,
) {
    match (form, hit, said) {
        (Form::Rays { target, .. }, Some(hit), Some(Response::Rays(said))) => {
            said_and_true(hit, &said, ["striker", target].map(Some), true, panel);
        }
        // Without a collision to define the coin's side, rays are written as text.
        _ => {
            let said = said.map_or("nothing".into(), |said| lettered(form, &said));
            panel.marked("you    ", said, Role::Predicted);
            panel.marked("truth  ", lettered(form, &form.truth()), Role::Good);
        }
    }
}

/// An answer as text; a choice is preceded by its letter.
pub(crate) fn lettered(form: &Form, said: &Response) -> String {
    match said {
        Response::Choice(i) => format!("{}: {}", letter(*i), form.words(said)),
        _ => form.words(said),
    }
}
