//! Answering a question, in any form.

use glam::DVec2;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use crate::messages::Key;
use crate::physics::units::{m_from_mm, mm_from_m};
use crate::quiz::{Form, Measure, Question, Ray, Response, letter};
use crate::widgets::flow::Run;
use crate::widgets::hit::{drag_offset, point_at};
use crate::widgets::input::{KeyTable, NumberAction, RayAction};
use crate::widgets::panel::Panel;
use crate::widgets::{NumberInput, Outcome, RayInput, Role};

/// An answer being entered.
#[derive(Debug, Clone, PartialEq)]
pub enum AnswerInput {
    /// Two rays, which the player turns.
    Rays(RayInput),
    /// A number, typed or set with the arrow keys.
    Number(NumberInput),
    /// A choice from a list.
    Choice {
        /// The index of the chosen option; `None` until one is chosen.
        chosen: Option<usize>,
        /// The number of choices.
        count: usize,
    },
    /// An offset in millimetres, typed or set with the arrow keys.
    Shot(NumberInput),
}

/// What the keys do while an answer is being entered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum AnswerAction {
    /// turn a ray
    Ray(RayAction),
    /// enter a number
    Number(NumberAction),
    /// choose the answer above or below
    Move(isize),
    /// choose an answer by its letter or number
    Choose(usize),
    /// choose and give an answer
    Give(usize),
    /// give the chosen answer
    Enter,
}

impl AnswerInput {
    /// Creates an input that contains no answer yet.
    pub(crate) fn new(form: &Form) -> Self {
        match form {
            Form::Rays { side, .. } => Self::Rays(RayInput::new(*side)),
            Form::Number { quantity, .. } => Self::Number(NumberInput::new(quantity.clone())),
            Form::Choice { options, .. } => Self::Choice {
                chosen: None,
                count: options.len(),
            },
            Form::Shot(aim) => {
                let most_mm = aim.furthest_offset_mm();
                Self::Shot(NumberInput::within(Measure::Length, -most_mm, most_mm))
            }
        }
    }

    /// Creates an input that contains an earlier answer, if there is one, which the player can
    /// change.
    pub(crate) fn saying(form: &Form, said: Option<Response>) -> Self {
        let mut input = Self::new(form);
        match (&mut input, said) {
            (Self::Rays(input), Some(Response::Rays(rays))) => *input = input.clone().saying(&rays),
            (Self::Number(number), Some(Response::Number(x))) => number.set(x),
            (Self::Choice { chosen, count }, Some(Response::Choice(i))) if i < *count => {
                *chosen = Some(i);
            }
            (Self::Shot(offset), Some(Response::Shot(x))) => {
                offset.set((mm_from_m(x) * 1e6).round() / 1e6);
            }
            _ => {}
        }
        input
    }

    /// The answer; `None` until it is complete.
    pub(crate) fn said(&self) -> Option<Response> {
        Some(match self {
            Self::Rays(rays) => Response::Rays(rays.said()?),
            Self::Number(number) => Response::Number(number.value()?),
            Self::Choice { chosen, .. } => Response::Choice((*chosen)?),
            Self::Shot(offset) => Response::Shot(m_from_mm(offset.value()?)),
        })
    }

    /// The rays, if the answer consists of rays.
    pub(crate) fn rays(&self) -> Option<&RayInput> {
        match self {
            Self::Rays(rays) => Some(rays),
            _ => None,
        }
    }

    /// The keys for entering an answer in this form.
    pub(crate) fn keys(&self) -> KeyTable<AnswerAction> {
        use AnswerAction::{Choose, Enter, Move, Number, Ray};
        match self {
            Self::Rays(rays) => rays.keys("next").map(Ray),
            Self::Number(number) | Self::Shot(number) => number.keys().map(Number),
            Self::Choice { count, .. } => {
                let each = |first: char| (first..).zip((0..*count).map(Choose));
                KeyTable::new("answer")
                    .by([Key::Up, Key::Down], Move, [-1, 1], "choose")
                    .or([(Key::BackTab, Move(-1)), (Key::Tab, Move(1))])
                    .each(each('a'), "pick")
                    .or(each('1'))
                    .on(Key::Enter, Enter, "next")
            }
        }
    }

    /// Carries out an action; `Done` once the answer is complete.
    pub(crate) fn act(&mut self, action: AnswerAction) -> Outcome {
        match (self, action) {
            (Self::Rays(rays), AnswerAction::Ray(action)) => return rays.act(action),
            (Self::Number(number) | Self::Shot(number), AnswerAction::Number(action)) => {
                return number.act(action);
            }
            (Self::Choice { chosen, count }, AnswerAction::Move(by)) => {
                let last = count.saturating_sub(1);
                let from = |at: usize| at.saturating_add_signed(by).min(last);
                *chosen = Some(chosen.map_or(if by < 0 { last } else { 0 }, from));
            }
            (Self::Choice { chosen, count }, AnswerAction::Choose(i)) if i < *count => {
                *chosen = Some(i);
            }
            (Self::Choice { chosen, count }, AnswerAction::Give(i)) if i < *count => {
                *chosen = Some(i);
                return Outcome::Done(());
            }
            (Self::Choice { chosen, .. }, AnswerAction::Enter) if chosen.is_some() => {
                return Outcome::Done(());
            }
            (Self::Choice { .. }, AnswerAction::Enter) => {}
            _ => return Outcome::Ignored,
        }
        Outcome::Used
    }

    /// Handles the mouse button at a cell of the question's picture, where it has just been pressed
    /// (`pressed`) or is held down: turns a ray, or moves the coin sideways. Returns `false` if the
    /// cell is outside the picture or the picture cannot be used for the answer.
    pub(crate) fn point(
        &mut self,
        question: &Question,
        picture: Rect,
        place: DVec2,
        pressed: bool,
    ) -> bool {
        if !picture.contains((place.x as u16, place.y as u16).into()) {
            return false;
        }
        match (self, &question.form, question.picture.collision()) {
            (Self::Rays(rays), _, Some(collision)) => {
                point_at(picture, collision, rays, place, pressed);
            }
            (Self::Shot(offset), Form::Shot(aim), _) => {
                let now = aim.with(m_from_mm(offset.value().unwrap_or(0.0)));
                let dragged = mm_from_m(drag_offset(picture, &now, place));
                offset.set((2.0 * dragged).round() / 2.0);
            }
            _ => return false,
        }
        true
    }

    /// A sentence that says what can be dragged in the question's picture.
    pub(crate) fn drag(&self, question: &Question) -> Option<&'static str> {
        match (self, question.picture.collision()) {
            (Self::Rays(_), Some(_)) => Some(RayInput::DRAG),
            (Self::Shot(_), _) => Some("Drag the coin sideways to aim at it."),
            _ => None,
        }
    }

    /// Writes the answer entered so far, including all the choices. Gaps between choices have the
    /// priority `apart`.
    pub(crate) fn write(&self, form: &Form, apart: Option<u8>, panel: &mut Panel<AnswerAction>) {
        match (self, form) {
            (Self::Rays(rays), Form::Rays { target, .. }) => {
                panel.part(AnswerAction::Ray, |panel| rays.write(panel, target));
            }
            (Self::Number(number), _) => number.write("your answer", panel),
            (Self::Shot(offset), _) => offset.write("offset", panel),
            (Self::Choice { chosen, .. }, Form::Choice { options, .. }) => {
                for (i, option) in options.iter().enumerate() {
                    if let (1.., Some(apart)) = (i, apart) {
                        panel.worth(apart, Panel::gap);
                    }
                    let text = vec![Run::new(option, Role::Text)];
                    let pick = AnswerAction::Choose(i);
                    panel.choice(letter(i), text, Some(i) == *chosen, pick);
                }
            }
            _ => {}
        }
    }

    /// The label and the action of the next prompt: entering the typed number, switching to the
    /// other ray, or submitting the answer, for which `last` is the label.
    pub(crate) fn next(&self, form: &Form, last: &str) -> (String, AnswerAction) {
        let words = match (self, form) {
            (Self::Rays(rays), Form::Rays { target, .. }) if rays.turning == Ray::Striker => {
                format!("next, the {target}")
            }
            _ => last.to_owned(),
        };
        let action = match self {
            Self::Rays(rays) => AnswerAction::Ray(rays.go_on()),
            Self::Number(number) | Self::Shot(number) => AnswerAction::Number(number.enter()),
            Self::Choice { .. } => AnswerAction::Enter,
        };
        (words, action)
    }

    /// A sentence on how to enter the answer.
    pub(crate) fn about(&self, form: &Form) -> String {
        match (self, form) {
            (Self::Rays(rays), Form::Rays { target, .. }) => rays.about(target),
            (Self::Number(number), _) => number.about(),
            (Self::Shot(_), _) => {
                "The offset is the distance in millimetres from the striker's path to the coin's centre, negative to the left.".into()
            }
            _ => "Choose one answer.".into(),
        }
    }
}
