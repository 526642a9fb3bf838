//! What is wrong with a file, in one message.

use std::fmt;

use super::is_invisible;

/// The first thing that is wrong with a file.
///
/// Shown as `my.toml:7: disc.mass_g: expected a mass from 0.001 to 100000 g, found -3`.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub struct FileError {
    /// Name of the file, as it was given.
    pub file: String,
    /// The line, counted from 1; `None` where the file could not be read at all.
    pub line: Option<usize>,
    /// The field with the path of its tables; `None` where no field is to blame.
    pub field: Option<String>,
    /// What was expected and what was found.
    pub message: String,
}

impl FileError {
    /// A fault of a whole file.
    pub fn of_file(file: &str, message: impl Into<String>) -> Self {
        Self {
            file: file.into(),
            line: None,
            field: None,
            message: message.into(),
        }
    }

    /// What is wrong and where in the file, for those who know which file it is.
    pub fn without_file(&self) -> String {
        match self.line {
            Some(line) => format!("line {line}: {}", self.what()),
            None => self.what(),
        }
    }

    fn what(&self) -> String {
        let message = escape_control(&self.message, 400);
        match &self.field {
            Some(field) => format!("{}: {message}", escape_control(field, 80)),
            None => message,
        }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&escape_control(&self.file, 200))?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        write!(f, ": {}", self.what())
    }
}

/// A message of one or more lines that may quote anything, likewise without control
/// characters: what is written to the terminal outside of its screen goes through this.
pub fn escape_control_lines(text: &str) -> String {
    let lines = text.lines().map(|line| escape_control(line, usize::MAX));
    lines.collect::<Vec<_>>().join("\n")
}

/// Text from outside on one line, without control characters and not endless, so
/// that a message cannot play tricks on the terminal that shows it.
pub fn escape_control(text: &str, most: usize) -> String {
    let mut kept = String::new();
    let mut characters = text.chars();
    for c in characters.by_ref().take(most) {
        if is_invisible(c) {
            kept.extend(c.escape_default());
        } else {
            kept.push(c);
        }
    }
    if characters.next().is_some() {
        kept.push_str("...");
    }
    kept
}
