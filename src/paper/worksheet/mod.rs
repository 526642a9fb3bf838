//! A round of the quiz on paper: a question sheet and its answer key.
//!
//! The two are separate documents, so that the sheet can be printed or passed on without the key.
//! Both show the code of the round, which opens it on a screen.

mod cards;
mod html;
mod markdown;
mod moodle;
mod pictures;
mod words;

use maud::Markup;

use crate::quiz::{CourseKind, Round};

pub use cards::cards;
pub(crate) use pictures::{WorksheetPicture, of_answer, on_screen};
pub(crate) use words::said;

use super::{Paper, clean, html_page};

/// The maximum number of columns in a heading.
const TITLE: usize = 120;
/// The default heading.
const HEADING: &str = "Glancing collisions";

/// A round of the quiz on paper.
///
/// The same round and options always give the same bytes.
#[derive(Debug)]
pub struct Worksheet<'a> {
    pub(crate) round: &'a Round,
    pub(crate) title: String,
    /// The letter of the version, if there are several. The code opens the questions of version A
    /// on a screen.
    pub(crate) version: Option<char>,
    /// The options that open the teacher's own questions, if the round cannot be opened on a screen
    /// without them: " --concepts my-folder".
    pub(crate) own: String,
    pub(crate) paper: Paper,
}

impl<'a> Worksheet<'a> {
    /// The worksheet of a round. A title that is too long for a heading is truncated; a missing
    /// title, or one without a visible letter, is replaced by a default.
    pub fn new(round: &'a Round, title: Option<&str>) -> Self {
        let usual = match &round.course().kind {
            CourseKind::Set(set) => &set.title,
            _ => HEADING,
        };
        let given = title.map(|it| clean(it, TITLE)).filter(|it| !it.is_empty());
        Self {
            round,
            title: given.unwrap_or_else(|| clean(usual, TITLE)),
            version: None,
            own: String::new(),
            paper: Paper::default(),
        }
    }

    /// The command that opens the same round on a screen; `None` for versions other than A, which
    /// have different numbers.
    fn command(&self) -> Option<String> {
        let is_first = self.version.is_none_or(|letter| letter == 'A');
        is_first.then(|| words::command(self.round.code(), &self.own))
    }

    /// The code with the version: "mixed-7", "mixed-7, version B".
    fn code(&self) -> String {
        self.with_version(&self.round.code().to_string())
    }

    fn with_version(&self, name: &str) -> String {
        match self.version {
            Some(letter) => format!("{name}, version {letter}"),
            None => name.to_owned(),
        }
    }

    /// The questions as HTML.
    pub fn sheet_html(&self) -> String {
        self.html(&self.title, [html::questions(self)])
    }

    /// The answers as HTML.
    pub fn key_html(&self) -> String {
        self.html(&self.key_title(), [html::answers(self)])
    }

    /// The questions as HTML, and the answers, which start on a new page.
    pub fn html_with_key(&self) -> String {
        self.html(&self.title, [html::questions(self), html::answers(self)])
    }

    fn html<const N: usize>(&self, title: &str, sheets: [Markup; N]) -> String {
        html_page(title, include_str!("worksheet.css"), self.paper, sheets)
    }

    fn key_title(&self) -> String {
        format!("Key: {}", self.title)
    }
}
