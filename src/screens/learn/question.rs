//! A question being answered.

use strum::{EnumMessage, IntoStaticStr};

use super::prose;
use crate::lessons::{Checkpoint, CheckpointKind};
use crate::messages::Key;
use crate::physics::Collision;
use crate::quiz::{Ray, Response, letter};
use crate::widgets::hit::side;
use crate::widgets::input::{EntryAction, KeyTable, RayAction};
use crate::widgets::panel::written;
use crate::widgets::{
    AnswerAction, AnswerInput, Charset, Lines, NumberEntry, Outcome, RayInput, Role, Words,
};

/// An answer in the making.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum CheckpointInput {
    /// Two rays to turn, or a line to choose.
    Given(AnswerInput),
    /// A number to type.
    Number(NumberEntry),
}

/// What keys do to an answer at a checkpoint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum CheckpointAction {
    /// give an answer
    Given(AnswerAction),
    /// type a number
    Number(EntryAction),
}

impl CheckpointInput {
    /// An answer to be made; `figure` is the collision of the page's figure.
    pub(super) fn new(checkpoint: &Checkpoint, figure: Option<&Collision>) -> Self {
        match &checkpoint.asked {
            CheckpointKind::Rays => {
                let rays = RayInput::new(figure.map_or(1.0, side));
                Self::Given(AnswerInput::Rays(rays))
            }
            CheckpointKind::Number { .. } => Self::Number(NumberEntry::default()),
            CheckpointKind::Choice(choices) => Self::Given(AnswerInput::Choice {
                chosen: None,
                count: choices.len(),
            }),
        }
    }

    /// The same to be answered once more: rays stay as they were said, to be changed.
    pub(super) fn anew(&self, checkpoint: &Checkpoint, figure: Option<&Collision>) -> Self {
        match (
            Self::new(checkpoint, figure),
            self.rays().and_then(RayInput::said),
        ) {
            (Self::Given(AnswerInput::Rays(rays)), Some(said)) => {
                Self::Given(AnswerInput::Rays(rays.saying(&said)))
            }
            (new, _) => new,
        }
    }

    /// The rays that are turned.
    pub(super) fn rays(&self) -> Option<&RayInput> {
        match self {
            Self::Given(input) => input.rays(),
            Self::Number(_) => None,
        }
    }

    /// The same, to be turned by hand.
    pub(super) fn rays_mut(&mut self) -> Option<&mut RayInput> {
        match self {
            Self::Given(AnswerInput::Rays(rays)) => Some(rays),
            _ => None,
        }
    }

    /// The line that keys change, from 0.
    pub(super) fn line(&self) -> usize {
        match self {
            Self::Given(AnswerInput::Rays(rays)) => usize::from(rays.is_last()),
            Self::Given(AnswerInput::Choice { chosen, .. }) => chosen.unwrap_or(0),
            _ => 0,
        }
    }

    /// The keys that give it. The other ray is chosen by Enter: Tab goes to the figure.
    pub(super) fn keys(&self) -> KeyTable<CheckpointAction> {
        match self {
            Self::Given(input) => {
                // What leads back to the contents is worth more on a small screen.
                let spare = |action| {
                    use AnswerAction::{Choose, Ray};
                    matches!(action, Choose(_) | Ray(RayAction::StaysStill))
                };
                let keys = input.keys().renamed("", spare);
                let keys = keys.map(CheckpointAction::Given);
                keys.without_keys(&[Key::Tab, Key::BackTab])
            }
            Self::Number(entry) => entry.keys().map(CheckpointAction::Number),
        }
    }

    /// Does what a key stands for; done with the answer once it is given.
    pub(super) fn act(&mut self, action: CheckpointAction) -> Outcome<Response> {
        match (self, action) {
            (Self::Number(entry), CheckpointAction::Number(action)) => {
                entry.act(action).map(Response::Number)
            }
            (Self::Given(input), CheckpointAction::Given(action)) => {
                match (input.act(action), input.said()) {
                    (Outcome::Done(()), Some(said)) => Outcome::Done(said),
                    (Outcome::Ignored, _) => Outcome::Ignored,
                    _ => Outcome::Used,
                }
            }
            _ => Outcome::Ignored,
        }
    }

    /// Chooses a line by hand; says whether it was chosen already.
    pub(super) fn choose(&mut self, line: usize) -> bool {
        match self {
            Self::Given(AnswerInput::Choice { chosen, .. }) => chosen.replace(line) == Some(line),
            _ => false,
        }
    }

    /// Writes the answer in the making. `rows` is told the first row of each of its
    /// lines in turn: of a choice, of a ray, of the number.
    pub(super) fn write(
        &self,
        checkpoint: &Checkpoint,
        lines: &mut Lines,
        mut rows: impl FnMut(u16),
    ) {
        match (self, &checkpoint.asked) {
            (Self::Given(AnswerInput::Rays(rays)), _) => {
                for ray in 0..Ray::BOTH.len() {
                    rows(lines.written() + ray as u16);
                }
                written(lines, |panel| rays.write(panel, "coin"));
            }
            (Self::Number(entry), CheckpointKind::Number { expected, .. }) => {
                let (sign, unit) = expected.sign_and_unit();
                let shown = format!("{}_ {unit}", entry.text());
                rows(lines.written());
                let name = format!("{sign} =");
                let recorded = |charset: Charset| Words::Field {
                    name: charset.text(&name).into_owned(),
                    value: charset.text(&shown).into_owned(),
                    locked: false,
                };
                lines.clicked_as(recorded, Some(true), |lines| {
                    let name = format!("> {name}");
                    lines.pair(&name, &shown, Role::Selected, Role::Selected);
                });
            }
            (Self::Given(AnswerInput::Choice { chosen, .. }), CheckpointKind::Choice(choices)) => {
                for (i, choice) in choices.iter().enumerate() {
                    rows(lines.written());
                    lines.choice(Some(i) == *chosen, Role::Text, |lines, mark, role| {
                        let mark = format!("{mark}{}", letter(i));
                        lines.flowing(&mark, 3, &prose::runs(&choice.text, role, None));
                    });
                }
            }
            _ => {}
        }
    }

    /// What to do next, in a few words.
    pub(super) fn hint(&self) -> &'static str {
        match self {
            Self::Given(AnswerInput::Rays(rays)) => {
                match (rays.is_said(rays.turning()), rays.is_last()) {
                    (false, _) => "Turn the ray with the arrows, or type its angle.",
                    (true, false) => "Enter: the other ray.",
                    (true, true) => "Enter: watch.",
                }
            }
            Self::Number(entry) if entry.is_open() => "Enter: say it.",
            Self::Number(_) => "Type a number.",
            Self::Given(input) if input.said().is_some() => "Enter: say it.",
            Self::Given(_) => "Choose with the arrows, or with the letter.",
        }
    }
}
