//! How a question looks while it is read out and while everyone thinks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::heading::Heading;
use super::play::ClassPlay;
use super::view::{Text, column};
use crate::class::ClassStep;
use crate::quiz::{Form, Illustration, Question, letter};
use crate::widgets::big::{Align, Big};
use crate::widgets::{Lines, Look, Role, SplitLayout, draw_question};

/// The place of the question's words, and of its picture if it is to be seen.
struct WordsPlace {
    words: Rect,
    beside: Option<SplitLayout>,
}

fn heading_and(play: &ClassPlay, then: impl FnOnce(Heading)) {
    let number = format!("Question {}", play.number() + 1);
    match play.step() {
        ClassStep::Predict => then(Heading::new(
            &["Predict in silence", "In silence"],
            "Everyone writes down an answer. Nobody speaks.",
        )),
        _ => then(Heading::new(&[&number], "")),
    }
}

fn layout(play: &ClassPlay, question: &Question, area: Rect, look: &Look) -> WordsPlace {
    if play.words_alone {
        return WordsPlace {
            words: area,
            beside: None,
        };
    }
    let mut rest = area;
    heading_and(play, |heading| rest = heading.rest(area, look));
    if question.picture == Illustration::Nothing {
        return WordsPlace {
            words: column(rest),
            beside: None,
        };
    }
    let beside = SplitLayout::square(rest);
    WordsPlace {
        words: beside.panel,
        beside: Some(beside),
    }
}

/// Draws the question: its picture, and its words where there is room for large type.
pub(super) fn draw(play: &ClassPlay, area: Rect, buf: &mut Buffer, look: &Look) {
    let Some(question) = play.question() else {
        return;
    };
    if !play.words_alone {
        heading_and(play, |heading| {
            heading.draw(area, buf, look);
        });
    }
    let layout = layout(play, question, area, look);
    if let Some(beside) = &layout.beside {
        let aside = match play.step() {
            ClassStep::Predict => "what will happen?",
            _ => "the question",
        };
        beside.draw(buf, look, question.family.name(), aside);
        draw_question(beside.picture, buf, look, question, None);
    }
    let place = inner(layout.words);
    let mut row = place.y;
    for block in large(question, place, look).0 {
        let left = Rect {
            y: row,
            height: place.bottom().saturating_sub(row),
            ..place
        };
        block.draw(left, buf, look, Role::Title, Align::Left);
        row += block.rows() + GAP;
    }
}

/// Empty rows between the question and its choices in large type.
const GAP: u16 = 1;

/// A column of margin on both sides.
fn inner(area: Rect) -> Rect {
    let margin = 1.min(area.width / 2);
    Rect {
        x: area.x + margin,
        width: area.width - 2 * margin,
        ..area
    }
}

/// What of the words fits in large type, and what is left in plain type: nothing; the
/// choices, below the question; or all.
fn large(question: &Question, place: Rect, look: &Look) -> (Vec<Big>, Plain) {
    let fit = |texts: &[&str], rows| Big::fit_all(texts, GAP, place.width, rows, look.charset);
    let mut texts = vec![question.text.clone()];
    let options = options(question);
    let lettered = options.iter().enumerate();
    texts.extend(lettered.map(|(i, option)| format!("{}: {option}", letter(i))));
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    if let Some(all) = fit(&texts, place.height) {
        return (all, Plain::Nothing);
    }
    let below = rows_of_choices(question, place, look) + GAP;
    match fit(&texts[..1], place.height.saturating_sub(below)) {
        Some(text) if !options.is_empty() => (text, Plain::Choices),
        _ => (Vec::new(), Plain::All),
    }
}

/// What of a question is in plain type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Plain {
    Nothing,
    Choices,
    All,
}

/// The choices of a question that has any.
fn options(question: &Question) -> &[String] {
    match &question.form {
        Form::Choice { options, .. } => options,
        _ => &[],
    }
}

/// Rows that the choices take in plain type.
fn rows_of_choices(question: &Question, place: Rect, look: &Look) -> u16 {
    let mut scratch = Buffer::empty(place);
    let mut lines = Lines::new(place, &mut scratch, *look);
    write_choices(question, &mut lines);
    lines.written()
}

/// The words that are not in large type.
pub(super) fn text<'a>(play: &'a ClassPlay, area: Rect, look: &Look) -> Option<Text<'a>> {
    let question = play.question()?;
    let layout = layout(play, question, area, look);
    let place = inner(layout.words);
    let (blocks, plain) = large(question, place, look);
    match plain {
        Plain::Nothing => None,
        Plain::All => {
            let write = move |lines: &mut Lines| write(question, lines);
            Some((layout.words, Box::new(write)))
        }
        Plain::Choices => {
            let high = blocks.iter().map(Big::rows).sum::<u16>() + GAP;
            let below = Rect {
                y: place.y + high,
                height: place.height.saturating_sub(high),
                ..place
            };
            let write = move |lines: &mut Lines| write_choices(question, lines);
            Some((below, Box::new(write)))
        }
    }
}

/// Writes a question with its choices.
pub(super) fn write(question: &Question, lines: &mut Lines) {
    lines.paragraph(&question.text, Role::Title);
    write_choices(question, lines);
}

fn write_choices(question: &Question, lines: &mut Lines) {
    for (i, option) in options(question).iter().enumerate() {
        lines.gap();
        lines.hanging(&format!("{}  ", letter(i)), option, Role::Text);
    }
}
