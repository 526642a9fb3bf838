//! A round of the quiz on paper: a sheet of questions, and the key to it.
//!
//! The two are documents of their own, so that the sheet can be printed or handed on
//! without the key. Both have the code of the round on them, which opens it on a screen.

mod html;
mod key;
mod markdown;
mod pictures;
mod words;

use crate::quiz::Round;

pub use pictures::WorksheetPicture;

use super::clean;

/// Columns of a heading.
const TITLE: usize = 120;
/// The heading where none is given.
const HEADING: &str = "Glancing collisions";

/// A round of the quiz on paper.
///
/// Everything follows from the round and the title: the same two give the same bytes.
#[derive(Debug)]
pub struct Worksheet<'a> {
    round: &'a Round,
    title: String,
}

impl<'a> Worksheet<'a> {
    /// The worksheet of a round. A title that is too long for a heading is cut; without
    /// one, or with one that has no visible letter, it is of glancing collisions.
    #[must_use]
    pub fn new(round: &'a Round, title: Option<&str>) -> Self {
        let title = clean(title.unwrap_or_default(), TITLE);
        let title = if title.is_empty() {
            HEADING.into()
        } else {
            title
        };
        Self { round, title }
    }

    /// The questions as HTML.
    #[must_use]
    pub fn sheet_html(&self) -> String {
        html::document(&self.title, [html::questions(self)])
    }

    /// The answers as HTML.
    #[must_use]
    pub fn key_html(&self) -> String {
        html::document(&self.key_title(), [key::answers(self)])
    }

    /// The questions as HTML, and the answers from a new page on.
    #[must_use]
    pub fn html_with_key(&self) -> String {
        html::document(&self.title, [html::questions(self), key::answers(self)])
    }

    /// The questions in Markdown; the [pictures](Self::pictures) are looked for in
    /// `folder`, beside the document.
    #[must_use]
    pub fn sheet_markdown(&self, folder: &str) -> String {
        markdown::questions(self, folder)
    }

    /// The answers in Markdown; the [pictures](Self::pictures) are looked for in
    /// `folder`, beside the document.
    #[must_use]
    pub fn key_markdown(&self, folder: &str) -> String {
        markdown::answers(self, folder)
    }

    /// All pictures of the documents in Markdown.
    #[must_use]
    pub fn pictures(&self) -> Vec<WorksheetPicture> {
        pictures::all(self.round)
    }

    fn key_title(&self) -> String {
        format!("Key: {}", self.title)
    }
}
