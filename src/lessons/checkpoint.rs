//! Checkpoints: questions that are asked before the outcome is shown.

use super::inline::{self, PageSource, no_shot};
use super::words::Words;
use super::{CollisionSpec, Figure, Inline, Quantity, SourceLine, TextBlock, block};
use crate::files::all;
use crate::physics::Collision;
use crate::quiz::{Form, Measure, Rays, Response};

/// The permitted numbers of options.
const CHOICES: std::ops::RangeInclusive<usize> = 2..=5;
/// The maximum number of letters in a unit.
const UNIT: usize = 8;

/// A question on a page, and the text that follows the answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoint {
    /// The kind of answer, with the correct answer unless the figure determines it.
    pub asked: CheckpointKind,
    /// The question.
    pub question: Vec<TextBlock>,
    /// The hint after a wrong answer; it does not reveal the right answer. If it is empty, the
    /// feedback on a wrong choice serves as the hint.
    pub hint: Vec<TextBlock>,
    /// The text that follows the answer.
    pub after: Vec<TextBlock>,
    /// The source text, by which stored answers identify their question.
    pub written: String,
    /// The line in the file, from 1.
    pub line: usize,
}

/// What the student has to enter at a checkpoint.
#[derive(Debug, Clone, PartialEq)]
pub enum CheckpointKind {
    /// The directions of both discs in the figure.
    Rays,
    /// A number.
    Number {
        /// The correct number.
        expected: Expected,
        /// The largest error with which an answer counts as right, in the same unit as the number.
        tolerance: f64,
    },
    /// One of several options, which the student chooses.
    Choice(Vec<CheckpointChoice>),
}

/// The correct number.
#[derive(Debug, Clone, PartialEq)]
pub enum Expected {
    /// A quantity of a given shot.
    Of(Quantity, CollisionSpec),
    /// A quantity of the figure, with the settings that the student has chosen.
    Figure(Quantity),
    /// A number given in the file, with its unit, or the value of a constant.
    Fixed(f64, String),
}

impl Expected {
    /// The correct number. `figure` is the collision that the page's figure shows.
    pub(crate) fn value(&self, figure: Option<&Collision>) -> Option<f64> {
        match self {
            Self::Of(quantity, shot) => quantity.of(&shot.collision()),
            Self::Figure(quantity) => quantity.of(figure?),
            Self::Fixed(value, _) => Some(*value),
        }
    }

    /// The kind of number that the student enters: its symbol, or "your answer" if the number is
    /// fixed, its unit and the permitted range.
    fn measure(&self, tolerance: f64) -> Measure {
        let (sign, unit, is_share) = match self {
            Self::Of(it, _) | Self::Figure(it) => (it.symbol, it.unit, it.is_part_of_whole()),
            Self::Fixed(_, unit) => ("your answer", unit.as_str(), false),
        };
        Measure::Own {
            sign: sign.into(),
            unit: unit.into(),
            tolerance,
            range: if is_share { (0.0, 1.0) } else { (-1e9, 1e9) },
        }
    }
}

/// One option to choose from.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckpointChoice {
    /// The text of the option.
    pub text: Vec<Inline>,
    /// The feedback for a student who chose this option.
    pub why: Vec<Inline>,
    /// Whether the option is right.
    pub right: bool,
}

impl Checkpoint {
    /// The question in the form used by the quiz, with the correct answer for the collision in the
    /// page's figure.
    pub fn form(&self, figure: Option<&Collision>) -> Form {
        match &self.asked {
            CheckpointKind::Rays => Form::Rays {
                truth: figure.map_or_else(Rays::default, |it| Rays::from(&it.outcome())),
                side: figure.map_or(1.0, Collision::side),
                target: "coin",
            },
            CheckpointKind::Number {
                expected,
                tolerance,
            } => Form::Number {
                quantity: expected.measure(*tolerance),
                truth: expected.value(figure).unwrap_or(f64::INFINITY),
            },
            CheckpointKind::Choice(choices) => {
                let option = |choice: &CheckpointChoice| Inline::plain(&choice.text, figure);
                Form::Choice {
                    options: choices.iter().map(option).collect(),
                    right: choices.iter().position(|it| it.right).unwrap_or(0),
                }
            }
        }
    }

    /// Whether the student gets a hint and a second try after a first answer: the answer must be
    /// wrong, there must be a hint, and more than one other answer must be possible.
    pub(crate) fn offers_second_try(&self, form: &Form, said: &Response) -> bool {
        let has_hint = match form {
            Form::Choice { options, .. } => options.len() > 2,
            _ => !self.hint.is_empty(),
        };
        has_hint && !form.is_right(said)
    }

    /// The hint after a first wrong answer; if the checkpoint has no hint, this is the feedback on
    /// the choice.
    pub(crate) fn hint_to(&self, said: &Response) -> Vec<TextBlock> {
        match (said, &self.asked) {
            (Response::Choice(chosen), CheckpointKind::Choice(choices)) if self.hint.is_empty() => {
                let why = choices.get(*chosen).map(|it| it.why.clone());
                Vec::from_iter(why.map(TextBlock::Paragraph))
            }
            _ => self.hint.clone(),
        }
    }

    /// Reads a checkpoint, given the words after the three colons and the lines up to the end.
    pub(super) fn read(head: SourceLine, inside: &[SourceLine], page: &PageSource) -> Option<Self> {
        let (source, (line, words)) = (page.source, head);
        let mut parts = inside.splitn(2, |(_, text)| text.trim() == "---");
        let (asking, answered) = (parts.next().unwrap_or_default(), parts.next());
        let mut parts = asking.splitn(2, |(_, text)| text.trim() == "--- hint");
        let (asking, hint) = (parts.next().unwrap_or_default(), parts.next());
        let texts = asking.iter().map(|(_, text)| text.trim());
        let written: Vec<_> = std::iter::once(words.trim()).chain(texts).collect();
        let mut words = source.accept(line, Words::of(words))?;
        let name = words.first().unwrap_or_default();
        let first_choice = asking.iter().position(|(_, text)| text.starts_with("- ["));
        let (question, choices) = match name.as_str() {
            "choice" => asking.split_at(first_choice.unwrap_or(asking.len())),
            _ => (asking, &[][..]),
        };
        let asked = match name.as_str() {
            "rays" => source.accept(line, rays(page.figure)),
            "number" => source.accept(line, number(&mut words, page)),
            "choice" => choice(line, choices, page),
            other => {
                let message = format!("expected :::rays, :::number or :::choice, found {other}");
                return source.refuse(line, message);
            }
        };
        // After an invalid word, any words left over may belong to it, so they are not reported.
        if asked.is_some() {
            source.accept(line, words.finish());
        }
        let question = block::read(question, page);
        let has_hint = hint.is_some();
        let hint = block::read(hint.unwrap_or_default(), page);
        let after = block::read(answered.unwrap_or_default(), page);
        if has_hint && hint.as_ref().is_some_and(Vec::is_empty) {
            source.refuse::<()>(line, "expected a hint after --- hint, found none");
        }
        if question.as_ref().is_some_and(Vec::is_empty) {
            source.refuse::<()>(line, "expected a question, found none");
        }
        if name == "number" && after.as_ref().is_some_and(Vec::is_empty) {
            source.refuse::<()>(line, "expected an explanation after ---, found none");
        }
        Some(Self {
            question: question?,
            hint: hint?,
            after: after?,
            asked: asked?,
            written: written.join("\n").trim().to_owned(),
            line,
        })
    }
}

fn rays(figure: Option<Figure>) -> Result<CheckpointKind, String> {
    match figure {
        Some(figure) if figure.kind.is_hit() && figure.shot.collision().outcome().hit() => {
            Ok(CheckpointKind::Rays)
        }
        _ => Err(NO_HIT.into()),
    }
}

const NO_HIT: &str =
    "expected a figure of a collision on the page (lab or split), for turning the rays";

fn number(words: &mut Words, page: &PageSource) -> Result<CheckpointKind, String> {
    let tolerance = words.number("tolerance", 1e-9, 1e6)?;
    let tolerance =
        tolerance.ok_or("expected tolerance= and the largest error of a right answer")?;
    let expected = match words.field("answer") {
        Some(answer) => {
            let wrong = || format!("answer: expected a number, found {answer}");
            let value = answer.parse().ok().filter(|value: &f64| value.abs() < 1e9);
            let value = value.ok_or_else(wrong)?;
            let unit = words.field("unit").unwrap_or_default();
            if unit.chars().count() > UNIT {
                return Err(format!("unit: expected at most {UNIT} letters"));
            }
            Expected::Fixed(value, unit)
        }
        None => named(words, page)?,
    };
    Ok(CheckpointKind::Number {
        expected,
        tolerance,
    })
}

/// Reads the name of a number: a constant, a quantity of a given shot, or a quantity of the page's
/// figure.
fn named(words: &mut Words, page: &PageSource) -> Result<Expected, String> {
    let name = words.first().unwrap_or_default();
    let undefined = || format!("{name} is undefined here");
    if let Some(constant) = words.constant(&name)? {
        let value = constant.value().ok_or_else(undefined)?;
        return Ok(Expected::Fixed(value, String::new()));
    }
    let quantity = Quantity::named(&name)
        .ok_or_else(|| format!("expected the name of a number or answer=, found {name}"))?;
    let shot = page.shots.take(words, None)?;
    let right = shot.or(page.shot()).ok_or_else(|| no_shot(&name))?;
    quantity.of(&right.collision()).ok_or_else(undefined)?;
    Ok(match shot {
        Some(shot) => Expected::Of(quantity, shot),
        None => Expected::Figure(quantity),
    })
}

fn choice(line: usize, lines: &[SourceLine], page: &PageSource) -> Option<CheckpointKind> {
    let source = page.source;
    let mut choices = Vec::new();
    let mut right_ones = 0;
    let mut left = lines;
    while let [(number, first), rest @ ..] = left {
        if first.trim().is_empty() {
            left = rest;
            continue;
        }
        let right = first.strip_prefix("- [x] ");
        let Some(text) = right.or_else(|| first.strip_prefix("- [ ] ")) else {
            let message = "expected - [ ] or - [x] and an option, and indented lines after it";
            return source.refuse(*number, message);
        };
        let is_indented = |(_, text): &&SourceLine| text.starts_with("  ");
        let (why, after) = rest.split_at(rest.iter().take_while(is_indented).count());
        let shown: Vec<_> = why.iter().map(|(_, text)| text.trim()).collect();
        if shown.is_empty() {
            let message = "expected indented lines of feedback for this choice";
            source.refuse::<()>(*number, message);
        }
        let text = inline::read(*number, text, page);
        let why = inline::read(number + 1, &shown.join("\n"), page);
        let right = right.is_some();
        right_ones += usize::from(right);
        let choice = text.zip(why);
        choices.push(choice.map(|(text, why)| CheckpointChoice { text, why, right }));
        left = after;
    }
    if !CHOICES.contains(&choices.len()) || right_ones != 1 {
        let message = format!(
            "expected 2 to 5 choices, one of them right, found {} with {right_ones} right",
            choices.len()
        );
        return source.refuse(line, message);
    }
    all(choices).map(CheckpointKind::Choice)
}
