//! Inline text: words that may be emphasized, formulas and numbers.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use super::{CollisionSpec, Figure, Formula, Inline, Quantity, Tone};
use super::{header::Shots, words::Words, written::WrittenFigure};
use crate::files::{Source, all};

/// A page that is being read: where its errors are reported, and what its names refer to.
pub(super) struct PageSource<'a> {
    pub(super) source: &'a Source<'a>,
    /// The shots of the chapter.
    pub(super) shots: &'a Shots,
    pub(super) figure: Option<Figure>,
}

impl PageSource<'_> {
    /// The shot of the page's figure.
    pub(super) fn shot(&self) -> Option<CollisionSpec> {
        self.figure.map(|figure| figure.shot)
    }
}

/// The first of the placeholders that replace formulas and numbers while the Markdown is being
/// read. They are private-use characters of Unicode, which no text should contain.
const STAND_IN: u32 = 0xe000;

/// Reads a paragraph that begins at the given line of the file.
pub(super) fn read(line: usize, text: &str, page: &PageSource) -> Option<Vec<Inline>> {
    let source = page.source;
    let mut kept: Vec<Option<Inline>> = Vec::new();
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(['$', '{', '}']) {
        let here = line + text[..text.len() - rest.len() + at].matches('\n').count();
        plain.push_str(&rest[..at]);
        let opening = &rest[at..=at];
        let inside = &rest[at + 1..];
        let closing = match opening {
            "$" => "$",
            "{" => "}",
            _ => return source.refuse(here, "expected { before }"),
        };
        let Some((inner, after)) = inside.split_once(closing) else {
            return source.refuse(here, format!("expected {closing} after {opening}"));
        };
        let inner = inner.replace('\n', " ");
        let piece = match opening {
            "$" => Formula::read(&inner).map(Inline::Formula),
            _ => number(&inner, page),
        };
        let Some(letter) = stand_in(kept.len()) else {
            return source.refuse(here, "expected fewer formulas");
        };
        plain.push(letter);
        kept.push(source.accept(here, piece));
        rest = after;
    }
    plain.push_str(rest);
    source.accept(line, markdown(&plain, &all(kept)?))
}

fn stand_in(number: usize) -> Option<char> {
    char::from_u32(STAND_IN + u32::try_from(number).ok()?).filter(|c| *c <= '\u{f8ff}')
}

/// Reads a number: `v1 carrom alpha_deg=40: 2.57`, or `v1` for a number that changes with the
/// figure.
fn number(text: &str, page: &PageSource) -> Result<Inline, String> {
    let (what, written) = match text.split_once(':') {
        Some((what, written)) => (what, Some(WrittenFigure::read(written)?)),
        None => (text, None),
    };
    let mut words = Words::of(what)?;
    let name = words.first().unwrap_or_default();
    if let Some(constant) = words.constant(&name)? {
        words.finish()?;
        let written = written.ok_or_else(|| format!("expected {name}: and its figure"))?;
        return agreed(&name, &written, constant.value());
    }
    let Some(quantity) = Quantity::named(&name) else {
        return Err(format!("expected the name of a number, found {name}"));
    };
    let Some(written) = written else {
        words.finish()?;
        let live = page.figure.map(|_| Inline::Live(quantity));
        return live.ok_or_else(|| format!("expected a figure on the page for {name} to follow"));
    };
    let shot = page.shots.take(&mut words, page.shot())?;
    words.finish()?;
    let shot = shot.ok_or_else(|| no_shot(&name))?;
    agreed(&name, &written, quantity.of(&shot.collision()))
}

/// The message about a quantity without the shot to which it belongs.
pub(super) fn no_shot(name: &str) -> String {
    format!("expected a shot after {name}: the page has no figure")
}

fn agreed(name: &str, written: &WrittenFigure, truth: Option<f64>) -> Result<Inline, String> {
    let shown = &written.shown;
    match truth {
        Some(truth) if written.agrees(truth) => Ok(Inline::Text(shown.clone(), Tone::Plain)),
        Some(truth) => {
            let corrected = written.corrected(truth);
            Err(format!("{name} is {corrected}, found {shown}"))
        }
        None => Err(format!("{name} is undefined here, found {shown}")),
    }
}

const OTHER_MARKDOWN: &str =
    "expected plain text with *emphasis*, **strong** and `keys`, found other Markdown";

/// Splits the text into pieces; placeholders stand for formulas and numbers.
fn markdown(text: &str, kept: &[Inline]) -> Result<Vec<Inline>, String> {
    let mut pieces = Vec::new();
    let mut tones = vec![Tone::Plain];
    for event in Parser::new_ext(text, Options::empty()) {
        let tone = tones.last().copied().unwrap_or(Tone::Plain);
        match event {
            Event::Text(words) => substitute(&words, tone, kept, &mut pieces),
            Event::Code(words) => pieces.push(Inline::Text(words.to_string(), Tone::Key)),
            Event::SoftBreak | Event::HardBreak => pieces.push(Inline::Text(" ".into(), tone)),
            Event::Start(Tag::Emphasis) => tones.push(Tone::Emphasis),
            Event::Start(Tag::Strong) => tones.push(Tone::Strong),
            Event::End(TagEnd::Emphasis | TagEnd::Strong) => {
                tones.pop();
            }
            Event::Start(Tag::Paragraph) | Event::End(TagEnd::Paragraph) => {}
            _ => return Err(OTHER_MARKDOWN.into()),
        }
    }
    Ok(pieces)
}

/// Adds text after replacing its placeholders.
fn substitute(text: &str, tone: Tone, kept: &[Inline], pieces: &mut Vec<Inline>) {
    let mut words = String::new();
    for letter in text.chars() {
        let number = (letter as u32).checked_sub(STAND_IN);
        match number.and_then(|number| kept.get(number as usize)) {
            None => words.push(letter),
            // A number takes on the emphasis of the text around it.
            Some(Inline::Text(figure, _)) => words.push_str(figure),
            Some(piece) => {
                if !words.is_empty() {
                    pieces.push(Inline::Text(std::mem::take(&mut words), tone));
                }
                pieces.push(piece.clone());
            }
        }
    }
    if !words.is_empty() {
        pieces.push(Inline::Text(words, tone));
    }
}
