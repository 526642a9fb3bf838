//! A question being answered.

use super::prose;
use crate::lessons::{Checkpoint, CheckpointAnswer, CheckpointKind};
use crate::messages::Key;
use crate::physics::Collision;
use crate::quiz::Ray;
use crate::widgets::hit::side;
use crate::widgets::{Lines, NumberEntry, Outcome, RayInput, Role};

/// An answer in the making.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Question {
    /// Two rays to turn.
    Rays(RayInput),
    /// A number to type.
    Number(NumberEntry),
    /// A line to choose, of so many.
    Choice(usize, usize),
}

/// What a key said to a [`Question`].
pub(super) enum Said {
    /// Nothing: it is somebody else's key.
    Nothing,
    /// A part of the answer.
    Part,
    /// This is the answer.
    Answer(CheckpointAnswer),
}

impl Question {
    /// An answer to be made; `figure` is the collision of the page's figure.
    pub(super) fn new(checkpoint: &Checkpoint, figure: Option<&Collision>) -> Self {
        match &checkpoint.asked {
            CheckpointKind::Rays => Self::Rays(RayInput::new(figure.map_or(1.0, side))),
            CheckpointKind::Number { .. } => Self::Number(NumberEntry::default()),
            CheckpointKind::Choice(choices) => Self::Choice(0, choices.len()),
        }
    }

    /// The rays that are turned.
    pub(super) fn rays(&self) -> Option<&RayInput> {
        match self {
            Self::Rays(rays) => Some(rays),
            _ => None,
        }
    }

    /// The line that keys change, from 0.
    pub(super) fn line(&self) -> usize {
        match self {
            Self::Rays(rays) if rays.is_last() => 1,
            Self::Rays(_) | Self::Number(_) => 0,
            Self::Choice(chosen, _) => *chosen,
        }
    }

    /// Takes a key.
    pub(super) fn update(&mut self, key: Key) -> Said {
        match self {
            // The other ray is chosen by Enter; Tab goes to the figure.
            Self::Rays(_) if matches!(key, Key::Tab | Key::BackTab) => Said::Nothing,
            Self::Rays(rays) => match rays.update(key) {
                Outcome::Ignored => Said::Nothing,
                Outcome::Used => Said::Part,
                Outcome::Done(()) => Said::Answer(CheckpointAnswer::Rays(rays.so_far())),
            },
            Self::Number(entry) => match entry.update(key) {
                Outcome::Ignored => Said::Nothing,
                Outcome::Used => Said::Part,
                Outcome::Done(number) => Said::Answer(CheckpointAnswer::Number(number)),
            },
            Self::Choice(chosen, count) => match key {
                Key::Up => Self::step(chosen, *count - 1, *count),
                Key::Down => Self::step(chosen, 1, *count),
                Key::Enter => Said::Answer(CheckpointAnswer::Choice(*chosen)),
                Key::Char(digit @ '1'..='9') => {
                    let line = usize::from(digit as u8 - b'1');
                    if line >= *count {
                        return Said::Nothing;
                    }
                    *chosen = line;
                    Said::Part
                }
                _ => Said::Nothing,
            },
        }
    }

    fn step(chosen: &mut usize, by: usize, count: usize) -> Said {
        *chosen = (*chosen + by) % count.max(1);
        Said::Part
    }

    /// Chooses a line by hand; says whether it was chosen already.
    pub(super) fn choose(&mut self, line: usize) -> bool {
        match self {
            Self::Choice(chosen, _) => std::mem::replace(chosen, line) == line,
            _ => false,
        }
    }

    /// Writes the answer in the making. `rows` is told the first row of each of its
    /// lines: of a choice, of a ray, of the number.
    pub(super) fn write(
        &self,
        checkpoint: &Checkpoint,
        lines: &mut Lines,
        mut rows: impl FnMut(usize, u16),
    ) {
        match (self, &checkpoint.asked) {
            (Self::Rays(rays), _) => {
                for ray in 0..Ray::BOTH.len() {
                    rows(ray, lines.written() + ray as u16);
                }
                rays.write(lines, "coin");
            }
            (Self::Number(entry), CheckpointKind::Number { expected, .. }) => {
                let (sign, unit) = expected.sign_and_unit();
                let shown = format!("{}_ {unit}", entry.text());
                rows(0, lines.written());
                lines.pair(
                    &format!("> {sign} ="),
                    &shown,
                    Role::Selected,
                    Role::Selected,
                );
            }
            (Self::Choice(chosen, _), CheckpointKind::Choice(choices)) => {
                for (i, choice) in choices.iter().enumerate() {
                    rows(i, lines.written());
                    let (mark, role) = if i == *chosen {
                        (format!(">{}", i + 1), Role::Selected)
                    } else {
                        (format!(" {}", i + 1), Role::Text)
                    };
                    lines.flowing(&mark, 3, &prose::runs(&choice.text, role, None));
                }
            }
            _ => {}
        }
    }

    /// What to do next, in a few words.
    pub(super) fn hint(&self) -> &'static str {
        match self {
            Self::Rays(rays) if rays.is_last() => "Enter: watch.",
            Self::Rays(_) => "Turn the striker's ray; Enter: the other.",
            Self::Number(entry) if entry.is_open() => "Enter: say it.",
            Self::Number(_) => "Type a number.",
            Self::Choice(..) => "Up Down, then Enter: say it.",
        }
    }
}
