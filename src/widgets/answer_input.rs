//! Answering a question, in whichever form it asks for.

use ratatui::layout::Rect;

use super::hit::{drag_offset, point_at};
use super::number_input::NumberInput;
use super::{Lines, RayInput, Role, Turned};
use crate::messages::Key;
use crate::physics::units::{m_from_mm, mm_from_m};
use crate::quiz::{AimTask, Form, Measure, Question, Response, letter};

/// An answer in the making.
#[derive(Debug, Clone, PartialEq)]
pub enum AnswerInput {
    /// Two rays to turn.
    Rays(RayInput),
    /// A number to type or to dial.
    Number(NumberInput),
    /// Choices to choose from: the one chosen, and how many there are.
    Choice {
        /// The one the mark is at, counted from 0.
        chosen: usize,
        /// How many there are.
        count: usize,
    },
    /// An offset in millimetres to type or to dial.
    Shot(NumberInput),
}

impl AnswerInput {
    /// The letters of a choice, as keys; of none for other answers.
    pub fn letters(&self) -> &'static str {
        const LETTERS: &str = "a b c d e f";
        let Self::Choice { count, .. } = self else {
            return "";
        };
        let taken = (2 * count).saturating_sub(1);
        LETTERS.get(..taken).unwrap_or(LETTERS)
    }

    /// Nothing said yet.
    pub fn new(form: &Form) -> Self {
        match form {
            Form::Rays { side, .. } => Self::Rays(RayInput::new(*side)),
            Form::Number { quantity, .. } => Self::Number(NumberInput::new(*quantity)),
            Form::Choice { options, .. } => Self::Choice {
                chosen: 0,
                count: options.len(),
            },
            Form::Shot(aim) => Self::Shot(NumberInput::within(
                Measure::Length,
                -most_mm(aim),
                most_mm(aim),
            )),
        }
    }

    /// What was said before, to be changed.
    pub fn saying(form: &Form, said: &Response) -> Self {
        let mut input = Self::new(form);
        match (&mut input, said) {
            (Self::Rays(input), Response::Rays(rays)) => *input = input.clone().saying(rays),
            (Self::Number(number), Response::Number(x)) => number.set(*x),
            (Self::Choice { chosen, count }, Response::Choice(i)) if i < count => *chosen = *i,
            (Self::Shot(offset), Response::Shot(x)) => {
                offset.set((mm_from_m(*x) * 1e6).round() / 1e6);
            }
            _ => {}
        }
        input
    }

    /// What has been said so far; `None` while no number has been given.
    pub fn said(&self) -> Option<Response> {
        Some(match self {
            Self::Rays(rays) => Response::Rays(rays.said()),
            Self::Number(number) => Response::Number(number.value()?),
            Self::Choice { chosen, .. } => Response::Choice(*chosen),
            Self::Shot(offset) => Response::Shot(m_from_mm(offset.value().unwrap_or(0.0))),
        })
    }

    /// The rays, if it is they.
    pub fn rays(&self) -> Option<&RayInput> {
        match self {
            Self::Rays(rays) => Some(rays),
            _ => None,
        }
    }

    /// Takes a key. What is done with Enter needs something said.
    pub fn update(&mut self, key: Key) -> Turned {
        match self {
            Self::Rays(rays) => rays.update(key),
            Self::Number(number) => number.update(key),
            Self::Shot(offset) => match offset.update(key) {
                Turned::Ignored if key == Key::Enter => Turned::Done,
                turned => turned,
            },
            Self::Choice { chosen, count } => match key {
                Key::Up | Key::BackTab => {
                    *chosen = chosen.saturating_sub(1);
                    Turned::Turning
                }
                Key::Down | Key::Tab => {
                    *chosen = (*chosen + 1).min(count.saturating_sub(1));
                    Turned::Turning
                }
                Key::Char(c) => match choice_of(c).filter(|i| i < count) {
                    Some(i) => {
                        *chosen = i;
                        Turned::Turning
                    }
                    None => Turned::Ignored,
                },
                Key::Enter => Turned::Done,
                _ => Turned::Ignored,
            },
        }
    }

    /// Points at a cell of the question's picture with the button down, just now
    /// (`pressed`) or for some time: turns a ray, or drags the coin sideways. Says
    /// whether there is anything to point at.
    pub fn point(
        &mut self,
        question: &Question,
        picture: Rect,
        cell: (u16, u16),
        pressed: bool,
    ) -> bool {
        if !picture.contains(cell.into()) {
            return false;
        }
        match (self, &question.form, question.picture.collision()) {
            (Self::Rays(rays), _, Some(collision)) => {
                point_at(picture, collision, rays, cell, pressed);
            }
            (Self::Shot(offset), Form::Shot(aim), _) => {
                let now = aim.with(m_from_mm(offset.value().unwrap_or(0.0)));
                let dragged = mm_from_m(drag_offset(picture, &now, cell));
                offset.set((2.0 * dragged).round() / 2.0);
            }
            _ => return false,
        }
        true
    }

    /// Writes what is said so far, with all there is to choose from.
    pub fn write(&self, form: &Form, lines: &mut Lines) {
        match (self, form) {
            (Self::Rays(rays), Form::Rays { target, .. }) => rays.write(lines, target),
            (Self::Number(number), _) => number.write("your answer", lines),
            (Self::Shot(offset), _) => offset.write("offset", lines),
            (Self::Choice { chosen, .. }, Form::Choice { options, .. }) => {
                let apart = Self::choice_gap(options, lines, lines.left());
                for (i, option) in options.iter().enumerate() {
                    let (mark, role) = if i == *chosen {
                        (">", Role::Selected)
                    } else {
                        (" ", Role::Text)
                    };
                    if i > 0 && apart > 0 {
                        lines.gap();
                    }
                    lines.hanging(&format!("{mark} {} ", letter(i)), option, role);
                }
            }
            _ => {}
        }
    }

    /// Empty rows between two choices: one, where `left` rows leave room for it.
    fn choice_gap(options: &[String], lines: &Lines, left: u16) -> u16 {
        let rows: u16 = options.iter().map(|it| choice_rows(it, lines)).sum();
        u16::from(rows + options.len() as u16 + ROOM <= left)
    }

    /// Rows that [`AnswerInput::write`] takes where `left` rows are left.
    pub fn rows(form: &Form, lines: &Lines, left: u16) -> u16 {
        match form {
            Form::Rays { .. } => 2,
            Form::Number { .. } | Form::Shot(_) => 1,
            Form::Choice { options, .. } => {
                let gaps = options.len().saturating_sub(1) as u16;
                let rows: u16 = options.iter().map(|it| choice_rows(it, lines)).sum();
                rows + gaps * Self::choice_gap(options, lines, left)
            }
        }
    }

    /// The choice in this row of what [`AnswerInput::write`] writes, where `left` rows
    /// are left.
    pub fn choice_at(form: &Form, lines: &Lines, left: u16, row: u16) -> Option<usize> {
        let Form::Choice { options, .. } = form else {
            return None;
        };
        let apart = Self::choice_gap(options, lines, left);
        let mut first = 0;
        options.iter().position(|option| {
            let rows = choice_rows(option, lines);
            let here = (first..first + rows).contains(&row);
            first += rows + apart;
            here
        })
    }

    /// How it is answered, in a sentence or two.
    pub fn about(&self, form: &Form) -> String {
        match (self, form) {
            (Self::Rays(rays), Form::Rays { target, .. }) => rays.about(target),
            (Self::Number(number), _) => number.about(),
            (Self::Shot(_), _) => {
                "The offset: millimetres from the striker's path to the coin's centre, a minus for the left.".into()
            }
            _ => "Choose with the arrows, or with the letter.".into(),
        }
    }
}

/// What stands before a choice, as far as its room goes.
const MARK: &str = "> A ";

/// Rows that are worth more below choices than gaps between them.
const ROOM: u16 = 5;

/// Rows of a choice.
fn choice_rows(option: &str, lines: &Lines) -> u16 {
    lines.rows_of_hanging(MARK, option)
}

/// The choice of a letter or a digit from 1, counted from 0.
fn choice_of(c: char) -> Option<usize> {
    let c = c.to_ascii_lowercase();
    let start = match c {
        'a'..='e' => 'a',
        '1'..='5' => '1',
        _ => return None,
    };
    Some(c as usize - start as usize)
}

/// The largest offset that can be set, in millimetres: a little more than still hits.
fn most_mm(aim: &AimTask) -> f64 {
    (1.1 * mm_from_m(aim.collision.reach())).ceil()
}
