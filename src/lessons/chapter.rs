//! A chapter: a header and its pages.

use super::header::{self, Shots};
use super::{ChapterPage, SourceLine};
use crate::files::{self, FileError, FileErrors, Source, all};

/// The maximum number of pages in a chapter.
const MOST_PAGES: usize = 60;

/// A chapter of Learn.
#[derive(Debug, Clone, PartialEq)]
pub struct Chapter {
    /// The number of the chapter in the book, from 1.
    pub number: u32,
    /// The name of the chapter on the command line and in stored progress.
    pub id: String,
    /// The title, which has at most 32 characters.
    pub title: String,
    /// A one-line description.
    pub about: String,
    /// The pages, of which there is at least one; no two pages have the same title.
    pub pages: Vec<ChapterPage>,
    /// The name of the file from which the chapter was read, for messages.
    pub file: String,
}

impl Chapter {
    /// Reads a chapter; the name of the file contains the chapter's number and id.
    ///
    /// # Errors
    /// Returns the errors in the file.
    pub fn read(file: &str, bytes: &[u8]) -> Result<Self, FileErrors> {
        let source = Source::of_bytes(file, bytes, files::LARGEST)?;
        let (number, id) = number_and_id(file).ok_or_else(|| {
            let message = "expected a file name such as 02-the-line-of-impact.md";
            FileError::of_file(file, message)
        })?;
        let control = |c: char| c.is_control() && c != '\n' && c != '\r';
        for (line, _) in source.lines().filter(|(_, line)| line.contains(control)) {
            source.refuse::<()>(line, "expected no control characters");
        }
        let made = header::read(&source).and_then(|header| {
            let pages = pages(&source, header.ends, &header.shots?);
            Some(Self {
                number,
                id: id.into(),
                title: header.title?,
                about: header.about?,
                pages: pages?,
                file: file.into(),
            })
        });
        source.finish(made)
    }

    /// The number of checkpoints on all pages.
    pub fn checkpoints(&self) -> usize {
        let pages = self.pages.iter();
        pages.filter(|page| page.checkpoint.is_some()).count()
    }

    /// An error on the given line of the chapter's file.
    pub fn fault(&self, line: usize, message: impl Into<String>) -> FileError {
        FileError::on_line(&self.file, line, message)
    }
}

/// Reads the pages that follow the header, starting at the line `first`.
fn pages(source: &Source, first: usize, shots: &Shots) -> Option<Vec<ChapterPage>> {
    let lines: Vec<SourceLine> = source.lines().skip(first - 1).collect();
    let is_heading = |(_, text): &SourceLine| text.starts_with("# ") || *text == "#";
    let start = lines.iter().position(is_heading).unwrap_or(lines.len());
    let (before, left) = lines.split_at(start);
    if let Some((line, _)) = before.iter().find(|(_, text)| !text.trim().is_empty()) {
        source.refuse::<()>(*line, "expected a page title (# Title)");
    } else if left.is_empty() {
        source.refuse::<()>(first, "expected a page title (# Title), found none");
    }
    let mut pages: Vec<Option<ChapterPage>> = Vec::new();
    for page in left.chunk_by(|_, next| !is_heading(next)) {
        let [(line, text), inside @ ..] = page else {
            continue;
        };
        let title = text.trim_start_matches('#').trim();
        let mut known = pages.iter().flatten();
        if let Some(other) = known.find(|other| other.title == title) {
            let message = format!(
                "expected a title that no other page has; the page at line {} has it already",
                other.line
            );
            source.refuse::<()>(*line, message);
        }
        if pages.len() == MOST_PAGES {
            return source.refuse(*line, format!("expected at most {MOST_PAGES} pages"));
        }
        pages.push(ChapterPage::read(source, (*line, title), inside, shots));
    }
    all(pages)
}

/// The number and the id in a path: `lessons/02-the-line-of-impact.md`.
fn number_and_id(path: &str) -> Option<(u32, &str)> {
    let name = path.rsplit(['/', '\\']).next()?;
    let (number, id) = name.strip_suffix(".md")?.split_once('-')?;
    let bare = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    let short = (1..=3).contains(&number.len()) && (1..=60).contains(&id.len());
    let digits = number.bytes().all(|b| b.is_ascii_digit());
    let number = number.parse().ok().filter(|number| *number > 0)?;
    (short && digits && id.chars().all(bare)).then_some((number, id))
}
