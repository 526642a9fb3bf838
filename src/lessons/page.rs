//! A page of a chapter.

use super::block::{self, TextBlock};
use super::checkpoint::Checkpoint;
use super::figure::Figure;
use super::header::Shots;
use super::inline::Meaning;
use super::source::{Source, SourceLine};
use crate::files::FileError;

/// Most letters of a page's title.
const TITLE: usize = 40;

/// A page: a figure, text, and a checkpoint at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct ChapterPage {
    /// Its title.
    pub title: String,
    /// Its figure.
    pub figure: Option<Figure>,
    /// Its text.
    pub text: Vec<TextBlock>,
    /// What it asks.
    pub checkpoint: Option<Checkpoint>,
    /// Its line in the file.
    pub line: usize,
}

impl ChapterPage {
    /// Reads a page: its heading and the lines up to the next one.
    ///
    /// # Errors
    /// The first thing that is wrong with it.
    pub(super) fn read(
        source: &Source,
        (line, title): SourceLine,
        lines: &[SourceLine],
        shots: &Shots,
    ) -> Result<Self, FileError> {
        let title = title.trim();
        if title.is_empty() || title.chars().count() > TITLE {
            let message = format!("expected a title of 1 to {TITLE} letters after #");
            return Err(source.fault(line, message));
        }
        let figure = figure(source, lines, shots)?;
        let meaning = Meaning {
            shots,
            figure: figure.map(|figure| figure.shot),
        };
        let is_checkpoint = |(_, text): &SourceLine| text.starts_with(":::");
        let start = lines.iter().position(is_checkpoint).unwrap_or(lines.len());
        let (before, asked) = lines.split_at(start);
        let text: Vec<_> = before
            .iter()
            .copied()
            .filter(|line| !is_figure(*line))
            .collect();
        let checkpoint = match asked {
            [] => None,
            [(number, words), rest @ ..] => {
                let end = rest.iter().position(|(_, text)| text.trim_end() == ":::");
                let Some(end) = end else {
                    return Err(source.fault(*number, "expected ::: at the end of the checkpoint"));
                };
                let (inside, after) = rest.split_at(end);
                let more = after
                    .iter()
                    .skip(1)
                    .find(|(_, text)| !text.trim().is_empty());
                if let Some((number, _)) = more {
                    let message = "expected the next page: a checkpoint ends its page";
                    return Err(source.fault(*number, message));
                }
                let head = (*number, words.trim_start_matches(':'));
                Some(Checkpoint::read(
                    source,
                    head,
                    inside,
                    figure.as_ref(),
                    &meaning,
                )?)
            }
        };
        let page = Self {
            title: title.into(),
            figure,
            text: block::read(source, &text, &meaning)?,
            checkpoint,
            line,
        };
        if page.text.is_empty() && page.checkpoint.is_none() {
            return Err(source.fault(line, "expected a text or a checkpoint on the page"));
        }
        Ok(page)
    }
}

fn is_figure((_, text): SourceLine) -> bool {
    text.starts_with("::") && !text.starts_with(":::")
}

fn figure(
    source: &Source,
    lines: &[SourceLine],
    shots: &Shots,
) -> Result<Option<Figure>, FileError> {
    let mut figures = lines.iter().copied().filter(|line| is_figure(*line));
    let Some((line, text)) = figures.next() else {
        return Ok(None);
    };
    if let Some((line, _)) = figures.next() {
        return Err(source.fault(line, "expected one figure on a page, found another"));
    }
    let figure = Figure::read(text.trim_start_matches(':'), shots);
    figure
        .map(Some)
        .map_err(|message| source.fault(line, message))
}
