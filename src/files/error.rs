//! Error messages about files.

use std::fmt;

use unicode_segmentation::UnicodeSegmentation;

use super::is_invisible;
use super::letters::{hides, is_picture};

/// The maximum number of errors that are reported for one file. A file of another kind could cause
/// any number of errors.
const MOST_TOLD: usize = 20;

/// The maximum length of one message in characters.
const LONGEST_MESSAGE: usize = 400;
/// The words before the quoted part of a message.
const FOUND: &str = ", found ";

/// The maximum number of characters that a message quotes from external text.
pub const LONGEST_QUOTE: usize = 200;

/// An error in a file.
///
/// Shown as `my.toml:7: disc.mass_g: expected a mass from 0.001 to 100000 g, found -3`.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub struct FileError {
    /// The name of the file, as given.
    pub file: String,
    /// The line, from 1; `None` if the error concerns the whole file.
    pub line: Option<usize>,
    /// The field, preceded by the tables that contain it, as in `disc.mass_g`; `None` if no field
    /// is at fault.
    pub field: Option<String>,
    /// What was expected and what was found.
    pub message: String,
}

impl FileError {
    /// An error that concerns a whole file.
    pub(crate) fn of_file(file: &str, message: impl Into<String>) -> Self {
        Self {
            file: file.into(),
            line: None,
            field: None,
            message: message.into(),
        }
    }

    pub(crate) fn on_line(file: &str, line: usize, message: impl Into<String>) -> Self {
        Self {
            line: Some(line),
            ..Self::of_file(file, message)
        }
    }

    /// The error and its position, without the name of the file.
    pub(crate) fn without_file(&self) -> String {
        match self.line {
            Some(line) => format!("line {line}: {}", self.what()),
            None => self.what(),
        }
    }

    fn what(&self) -> String {
        let message = brief(&self.message);
        match &self.field {
            Some(field) => format!("{}: {message}", escape_control(field, 80)),
            None => message,
        }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&escape_control(&self.file, LONGEST_QUOTE))?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        write!(f, ": {}", self.what())
    }
}

/// The errors of a file, at least one, shown one per line.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub struct FileErrors(Vec<FileError>);

impl FileErrors {
    /// The first few errors of a `file`, in the order of reporting; `None` if there are none.
    pub(super) fn of(file: &str, mut errors: Vec<FileError>) -> Option<Self> {
        if errors.len() > MOST_TOLD {
            errors.truncate(MOST_TOLD);
            errors.push(FileError::of_file(file, "there are more errors"));
        }
        (!errors.is_empty()).then_some(Self(errors))
    }

    /// The errors and their positions, without the name of the file.
    pub(crate) fn without_file(&self) -> String {
        let errors: Vec<_> = self.0.iter().map(FileError::without_file).collect();
        errors.join("; ")
    }
}

impl From<FileError> for FileErrors {
    fn from(error: FileError) -> Self {
        Self(vec![error])
    }
}

impl IntoIterator for FileErrors {
    type Item = FileError;
    type IntoIter = std::vec::IntoIter<FileError>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl fmt::Display for FileErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let errors: Vec<_> = self.0.iter().map(ToString::to_string).collect();
        f.write_str(&errors.join("\n"))
    }
}

/// A message that may quote anything, on one or more lines and without control characters, to print
/// outside the game's screen.
pub fn escape_control_lines(text: &str) -> String {
    let lines = text.lines().map(|line| escape_control(line, usize::MAX));
    lines.collect::<Vec<_>>().join("\n")
}

/// A message with carrom's text about what was expected, and a quotation of what was found. The
/// result is one line without control characters, and quotes at most [`LONGEST_QUOTE`] characters.
pub(crate) fn brief(message: &str) -> String {
    let message = match message.split_once(FOUND) {
        Some((expected, found)) => {
            format!("{expected}{FOUND}{}", escape_control(found, LONGEST_QUOTE))
        }
        None => message.to_owned(),
    };
    escape_control(&message, LONGEST_MESSAGE)
}

/// External text in quotation marks, for a message: without control characters, and at most its
/// first [`LONGEST_QUOTE`] characters.
pub fn quoted(text: &str) -> String {
    match text.char_indices().nth(LONGEST_QUOTE) {
        Some((end, _)) => format!("{:?}...", text.get(..end).unwrap_or_default()),
        None => format!("{text:?}"),
    }
}

/// External text on one line, truncated and without control characters, so that a message
/// cannot control the terminal.
pub fn escape_control(text: &str, most: usize) -> String {
    let mut kept = String::new();
    let mut left = most;
    for letter in text.graphemes(true) {
        let characters = letter.chars().count();
        let is_whole = is_picture(letter);
        if is_whole && characters <= left {
            kept.push_str(letter);
        } else {
            for c in letter.chars().take(left) {
                if is_invisible(c) || hides(c) {
                    kept.extend(c.escape_default());
                } else {
                    kept.push(c);
                }
            }
        }
        if characters > left {
            kept.push_str("...");
            break;
        }
        left -= characters;
    }
    kept
}
