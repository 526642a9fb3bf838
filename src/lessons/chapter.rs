//! A chapter: a header and its pages.

use super::header::{self, Header};
use super::page::ChapterPage;
use super::source::{Source, SourceLine};
use crate::files::FileError;

/// Most pages of a chapter.
const MOST_PAGES: usize = 60;

/// A chapter.
#[derive(Debug, Clone, PartialEq)]
pub struct Chapter {
    /// Its number in the book, from 1.
    pub number: u32,
    /// Its name, by which it is opened and under which progress is kept.
    pub id: String,
    /// Its title.
    pub title: String,
    /// What it is about, in one line.
    pub about: String,
    /// Its pages, at least one; no two have the same title.
    pub pages: Vec<ChapterPage>,
    /// The file it was read from, for messages.
    pub file: String,
}

impl Chapter {
    /// Reads a chapter; its number and its id are in the name of the file.
    ///
    /// # Errors
    /// The first thing that is wrong with the file.
    pub fn read(file: &str, bytes: &[u8]) -> Result<Self, FileError> {
        let source = Source::new(file, bytes)?;
        let (number, id) = number_and_id(file).ok_or_else(|| {
            let message = "expected a file name such as 02-the-line-of-impact.md";
            FileError::of_file(file, message)
        })?;
        let Header {
            title,
            about,
            shots,
            ends,
        } = header::read(&source)?;
        let lines: Vec<SourceLine> = source.lines().skip(ends - 1).collect();
        let is_heading = |(_, text): &SourceLine| text.starts_with("# ") || *text == "#";
        let mut pages: Vec<ChapterPage> = Vec::new();
        let mut left = lines.as_slice();
        while let [(number, text), rest @ ..] = left {
            if !is_heading(&(*number, text)) {
                if text.trim().is_empty() {
                    left = rest;
                    continue;
                }
                return Err(source.fault(*number, "expected a page: # and its title"));
            }
            let length = rest.iter().position(is_heading).unwrap_or(rest.len());
            let (inside, after) = rest.split_at(length);
            let title = text.trim_start_matches('#');
            let page = ChapterPage::read(&source, (*number, title), inside, &shots)?;
            if let Some(other) = pages.iter().find(|other| other.title == page.title) {
                let message = format!(
                    "expected a title of its own; the page at line {} has it already",
                    other.line
                );
                return Err(source.fault(*number, message));
            }
            pages.push(page);
            if pages.len() > MOST_PAGES {
                let message = format!("expected at most {MOST_PAGES} pages");
                return Err(source.fault(*number, message));
            }
            left = after;
        }
        if pages.is_empty() {
            return Err(source.fault(ends, "expected a page: # and its title, found none"));
        }
        Ok(Self {
            number,
            id: id.into(),
            title,
            about,
            pages,
            file: file.into(),
        })
    }

    /// How many checkpoints it has.
    pub fn checkpoints(&self) -> usize {
        let pages = self.pages.iter();
        pages.filter(|page| page.checkpoint.is_some()).count()
    }

    /// A fault at a line of its file.
    pub fn fault(&self, line: usize, message: impl Into<String>) -> FileError {
        FileError {
            line: Some(line),
            ..FileError::of_file(&self.file, message)
        }
    }
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
