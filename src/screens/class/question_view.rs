//! How a question looks while it is read out and while everyone thinks.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::heading::below;
use super::play::ClassPlay;
use super::view::{Text, column};
use crate::class::ClassStep;
use crate::quiz::{Form, Illustration, Question, letter};
use crate::widgets::big::{Align, Big};
use crate::widgets::{Lines, Look, Role, SplitLayout, draw_question, rehearsed};

/// Draws the question: its picture, and its words where there is room for large type;
/// gives the words that are in plain type.
pub(super) fn draw<'a>(
    play: &ClassPlay,
    question: &'a Question,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> Option<Text<'a>> {
    let words = if play.words_alone {
        area
    } else if question.picture == Illustration::Nothing {
        column(area)
    } else {
        let beside = SplitLayout::square(area);
        let aside = match play.step() {
            ClassStep::Predict => "what will happen?",
            _ => "the question",
        };
        beside.draw(buf, look, question.family.name(), aside);
        draw_question(beside.picture, buf, look, question, None);
        beside.panel
    };
    // A column of margin on both sides.
    let mut place = words.inner(Margin::new(1, 0));
    let (blocks, plain) = large(question, place, look);
    for block in &blocks {
        block.draw(place, buf, look, Role::Title, Align::Left);
        place = below(place, block.rows() + GAP);
    }
    let plain = plain?;
    let place = if blocks.is_empty() { words } else { place };
    Some((place, Box::new(move |lines| plain(question, lines))))
}

/// Empty rows between the question and its choices in large type.
const GAP: u16 = 1;

/// What writes those words of a question that are in plain type.
type Plain = fn(&Question, &mut Lines);

/// What of the words fits in large type, and what writes the rest, if there is any: the
/// choices, below the question; or all.
fn large(question: &Question, place: Rect, look: &Look) -> (Vec<Big>, Option<Plain>) {
    let fit = |texts: &[&str], rows| Big::fit_all(texts, GAP, place.width, rows, look.charset);
    let mut texts = vec![question.text.clone()];
    let options = options(question);
    let lettered = options.iter().enumerate();
    texts.extend(lettered.map(|(i, option)| format!("{}: {option}", letter(i))));
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    if let Some(all) = fit(&texts, place.height) {
        return (all, None);
    }
    let below = rows_of_choices(question, place, look) + GAP;
    match fit(&texts[..1], place.height.saturating_sub(below)) {
        Some(text) if !options.is_empty() => (text, Some(write_choices)),
        _ => (Vec::new(), Some(write)),
    }
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
    rehearsed(place, *look, |lines| {
        write_choices(question, lines);
        lines.written()
    })
}

/// Writes a question with its choices.
fn write(question: &Question, lines: &mut Lines) {
    lines.paragraph(&question.text, Role::Title);
    write_choices(question, lines);
}

fn write_choices(question: &Question, lines: &mut Lines) {
    for (i, option) in options(question).iter().enumerate() {
        lines.gap();
        lines.hanging(&format!("{}  ", letter(i)), option, Role::Text);
    }
}
