//! The lines of a file, and faults at them.

use crate::files::{self, FileError};

/// The format of chapters that this program reads.
pub const FORMAT: u32 = 1;

/// A file's name and lines.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source<'a> {
    name: &'a str,
    pub(super) text: &'a str,
}

/// A line and its number, from 1.
pub(super) type SourceLine<'a> = (usize, &'a str);

impl<'a> Source<'a> {
    /// The text of a file.
    ///
    /// # Errors
    /// If it is too large, or no text.
    pub(super) fn new(name: &'a str, bytes: &'a [u8]) -> Result<Self, FileError> {
        let text = files::Source::of_bytes(name, bytes, files::LARGEST)?.text();
        let source = Self { name, text };
        let control = |c: char| c.is_control() && c != '\n' && c != '\r';
        match source.lines().find(|(_, line)| line.contains(control)) {
            None => Ok(source),
            Some((line, _)) => Err(source.fault(line, "expected no control characters")),
        }
    }

    /// Its lines.
    pub(super) fn lines(&self) -> impl Iterator<Item = SourceLine<'a>> + use<'a> {
        (1..).zip(self.text.lines())
    }

    /// The fault that `message` describes, at a line.
    pub(super) fn fault(&self, line: usize, message: impl Into<String>) -> FileError {
        FileError {
            file: self.name.into(),
            line: Some(line),
            field: None,
            message: message.into(),
        }
    }
}
