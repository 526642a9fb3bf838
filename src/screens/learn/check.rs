//! Checks page by page whether a chapter fits the smallest usual screen.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::reading::Reading;
use crate::lessons::{Chapter, ChapterPage, CheckpointKind, FileError, TextBlock};
use crate::quiz::{Rays, Response};
use crate::screens::{AnyScreen, Context, Hosted, Settings};
use crate::widgets::{Charset, SplitLayout, formula, text};

/// The body of a screen of 80×24, below the title and above the keys.
const BODY: Rect = Rect::new(0, 1, 80, 22);

/// An error for each page, hint, feedback or formula that does not fit at 80×24 without scrolling,
/// in either charset; empty if the chapter fits.
pub fn check(chapter: &Chapter) -> Vec<FileError> {
    let mut faults = Vec::new();
    for (at, page) in chapter.pages.iter().enumerate() {
        for charset in [Charset::Ascii, Charset::Unicode] {
            faults.extend(formulas(chapter, page, charset));
            let checkpoint = page.checkpoint.as_ref();
            let revealed = checkpoint.map_or(vec![], |it| answers(&it.asked));
            let hit = page.figure.map(|figure| figure.shot.collision());
            let hinted = |it: &&Response| {
                checkpoint.is_some_and(|asks| asks.offers_second_try(&asks.form(hit.as_ref()), it))
            };
            let hinted = revealed.iter().filter(hinted).map(|it| (Some(*it), None));
            let answered = revealed.iter().map(|it| (None, Some(*it)));
            let states = std::iter::once((None, None)).chain(hinted).chain(answered);
            for (first, answer) in states {
                let reading = Hosted::new(Reading::of_page(chapter, at, first, answer));
                if let Some(message) = too_long(&reading, first, answer, charset) {
                    let said = first.or(answer).and(checkpoint);
                    let line = said.map_or(page.line, |checkpoint| checkpoint.line);
                    faults.push(chapter.fault(line, message));
                }
            }
        }
    }
    faults.dedup();
    faults
}

/// The answers whose feedback is checked.
fn answers(asked: &CheckpointKind) -> Vec<Response> {
    match asked {
        // Straight ahead, at 45° and backwards: each has a long explanation.
        CheckpointKind::Rays => {
            let rays = |degrees: f64| Rays::new(degrees.to_radians(), degrees.to_radians());
            let rays = [0.0, 45.0, 150.0].map(rays);
            rays.map(Response::Rays).to_vec()
        }
        CheckpointKind::Number { .. } => vec![Response::Number(-123.0)],
        CheckpointKind::Choice(choices) => (0..choices.len()).map(Response::Choice).collect(),
    }
}

fn too_long(
    reading: &Hosted<Reading>,
    first: Option<Response>,
    answer: Option<Response>,
    charset: Charset,
) -> Option<String> {
    let settings = Settings {
        charset,
        ..Settings::default()
    };
    let mut cx = Context::new(settings, 0);
    cx.body = BODY;
    let (rows, room) = reading.rows(&cx);
    // The page is drawn too, so that a panic or a missing figure is detected.
    let mut buf = Buffer::empty(Rect::new(0, 0, 80, 24));
    reading.draw(&mut buf, &cx);
    let what = match answer {
        None if first.is_some() => format!("the hint{}", line_of(first)),
        None => "the page".to_owned(),
        Some(Response::Choice(_)) => format!("the feedback{}", line_of(answer)),
        Some(_) => "the feedback on the answer".to_owned(),
    };
    let charset = name(charset);
    let message = format!("{what} takes {rows} rows, expected at most {room} (80x24, {charset})");
    (rows > room).then_some(message)
}

/// The end of an error message, which names the choice at fault; empty for other answers.
fn line_of(said: Option<Response>) -> String {
    match said {
        Some(Response::Choice(line)) => format!(" on choice {}", line + 1),
        _ => String::new(),
    }
}

fn name(charset: Charset) -> &'static str {
    match charset {
        Charset::Ascii => "ASCII",
        Charset::Unicode => "Unicode",
    }
}

/// Formulas that are wider than the text.
fn formulas(chapter: &Chapter, page: &ChapterPage, charset: Charset) -> Vec<FileError> {
    let layout = match page.figure {
        Some(_) => SplitLayout::square(BODY),
        None => SplitLayout::text_alone(BODY),
    };
    // The width available to a formula: that of the text without the margin and the indentation.
    let room = usize::from(layout.panel.width).saturating_sub(3);
    let checkpoint = page.checkpoint.iter();
    let asked = checkpoint.flat_map(|it| it.question.iter().chain(&it.hint).chain(&it.after));
    let blocks = page.text.iter().chain(asked);
    let fault = |block: &TextBlock| {
        let TextBlock::Formula(formula) = block else {
            return None;
        };
        let rows = formula::set(formula, charset);
        let width = rows.iter().map(|row| text::width(row)).max().unwrap_or(0);
        let message = format!(
            "the formula {} is {width} columns wide, expected at most {room} ({})",
            formula.inline(),
            name(charset)
        );
        (width > room).then(|| chapter.fault(page.line, message))
    };
    blocks.filter_map(fault).collect()
}
