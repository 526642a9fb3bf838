//! A page of a chapter.

use super::{Checkpoint, Figure, SourceLine, TextBlock, block};
use super::{header::Shots, inline::PageSource};
use crate::files::Source;

/// The maximum length of a title, in characters.
const TITLE: usize = 40;

/// A page, which may have a figure, followed by text, a checkpoint or both.
#[derive(Debug, Clone, PartialEq)]
pub struct ChapterPage {
    /// The title, which is unique in its chapter.
    pub title: String,
    /// The figure above or beside the text.
    pub figure: Option<Figure>,
    /// The text before the checkpoint.
    pub text: Vec<TextBlock>,
    /// The question at the end of the page.
    pub checkpoint: Option<Checkpoint>,
    /// The line that contains the title in the file, from 1.
    pub line: usize,
}

impl ChapterPage {
    /// Reads a page, given its title and the lines up to the next page.
    pub(super) fn read(
        source: &Source,
        (line, title): SourceLine,
        lines: &[SourceLine],
        shots: &Shots,
    ) -> Option<Self> {
        if title.is_empty() || title.chars().count() > TITLE {
            let message = format!("expected a title of 1 to {TITLE} letters after #");
            source.refuse::<()>(line, message);
        }
        let figure = figure(source, lines, shots)?;
        let page = PageSource {
            source,
            shots,
            figure,
        };
        let is_checkpoint = |(_, text): &SourceLine| text.starts_with(":::");
        let start = lines.iter().position(is_checkpoint).unwrap_or(lines.len());
        let (before, asked) = lines.split_at(start);
        let text = before.iter().copied().filter(|line| !is_figure(*line));
        let text = block::read(&text.collect::<Vec<_>>(), &page);
        let checkpoint = match asked {
            [] => None,
            [head, rest @ ..] => Some(checkpoint(*head, rest, &page)?),
        };
        let text = text?;
        if text.is_empty() && checkpoint.is_none() {
            return source.refuse(line, "expected text or a checkpoint on the page");
        }
        Some(Self {
            title: title.into(),
            figure,
            text,
            checkpoint,
            line,
        })
    }
}

/// Reads a checkpoint, and checks that nothing comes after the checkpoint.
fn checkpoint(head: SourceLine, rest: &[SourceLine], page: &PageSource) -> Option<Checkpoint> {
    let (source, (line, words)) = (page.source, head);
    let end = rest.iter().position(|(_, text)| text.trim_end() == ":::");
    let Some(end) = end else {
        return source.refuse(line, "expected ::: at the end of the checkpoint");
    };
    let (inside, after) = rest.split_at(end);
    let mut more = after.iter().skip(1);
    if let Some((line, _)) = more.find(|(_, text)| !text.trim().is_empty()) {
        let message = "expected the next page: a checkpoint ends its page";
        source.refuse::<()>(*line, message);
    }
    let head = (line, words.trim_start_matches(':'));
    Checkpoint::read(head, inside, page)
}

fn is_figure((_, text): SourceLine) -> bool {
    text.starts_with("::") && !text.starts_with(":::")
}

/// The figure of a page, if there is one; `None` if the figure is invalid.
fn figure(source: &Source, lines: &[SourceLine], shots: &Shots) -> Option<Option<Figure>> {
    let mut figures = lines.iter().copied().filter(|line| is_figure(*line));
    let Some((line, text)) = figures.next() else {
        return Some(None);
    };
    for (line, _) in figures {
        source.refuse::<()>(line, "expected one figure on a page, found another");
    }
    let figure = Figure::read(text.trim_start_matches(':'), shots);
    source.accept(line, figure).map(Some)
}
