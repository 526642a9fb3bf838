//! Lessons: chapters as Markdown files, with figures, checkpoints and checked numbers.
//!
//! A [`Chapter`] consists of a header and pages; a [`ChapterPage`] has at most one [`Figure`], text
//! in [`TextBlock`]s, and at most one [`Checkpoint`]. A file is read and checked when it is opened:
//! each directive, each formula, and each number in braces, which the engine computes again. A file
//! with any [`FileError`] is left out; each error states the file, the line (unless it concerns the
//! whole file) and what was expected. `docs/lessons.md` describes the format.
//!
//! This module draws nothing.

mod answer;
mod block;
mod book;
mod bookmark;
mod chapter;
mod checkpoint;
mod figure;
pub(crate) mod formula;
mod glossary;
mod header;
mod inline;
mod library;
mod page;
#[cfg(test)]
mod tests;
mod words;
mod written;

pub(crate) use answer::{AFTER_HINT, answer_json, given_json, tries_of_json};
pub(crate) use block::Tone;
pub use block::{Inline, TextBlock};
pub use book::{Book, Forget};
pub use bookmark::{Bookmark, GivenAnswer};
pub use chapter::Chapter;
pub(crate) use checkpoint::Expected;
pub use checkpoint::{Checkpoint, CheckpointKind};
pub use figure::{Figure, FigureKind, FilmSetting, Filming};
pub use formula::{Formula, Node};
pub use glossary::GlossaryEntry;
pub use library::ChapterLibrary;
pub use page::ChapterPage;

pub use crate::files::FileError;
pub(crate) use crate::physics::CollisionSpec;
pub(crate) use crate::physics::named::{Constant, Quantity};

/// A line of a file, with its number from 1.
type SourceLine<'a> = (usize, &'a str);
