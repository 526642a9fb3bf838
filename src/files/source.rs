//! The text of a file, and its errors with their positions.

use std::cell::RefCell;

use super::{FileError, FileErrors};

/// The byte order mark U+FEFF in UTF-8.
pub(crate) const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Once a file has this many errors, `Source::note` adds no more, because finding the line of each
/// takes time.
const MOST_NOTED: usize = 200;

/// A file's text, and all errors found while it is read.
#[derive(Debug)]
pub(crate) struct Source<'a> {
    name: &'a str,
    text: &'a str,
    /// The number of the text's first line in the file, from 1.
    first_line: usize,
    errors: RefCell<Vec<(Rank, FileError)>>,
}

/// The kind of an error: unknown fields are reported first, the others in the order of their lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    /// An unknown field, which is often a misspelt required one.
    UnknownField,
    /// Text that is not TOML. Further errors that it causes on the same line are not reported.
    Syntax,
    /// Anything else.
    Value,
}

impl<'a> Source<'a> {
    fn new(name: &'a str, text: &'a str, first_line: usize) -> Self {
        Self {
            name,
            text,
            first_line,
            errors: RefCell::default(),
        }
    }

    /// The text of a file with this name and these bytes.
    ///
    /// # Errors
    /// Returns an error if there are more than `most` bytes, or if they are not UTF-8.
    pub(crate) fn of_bytes(name: &'a str, bytes: &'a [u8], most: usize) -> Result<Self, FileError> {
        if bytes.len() > most {
            let message = format!("expected a file of at most {}, found more", size(most));
            return Err(Self::new(name, "", 1).error_at(0, "", message));
        }
        // Some editors begin a file with a byte order mark.
        let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        let Ok(text) = std::str::from_utf8(bytes) else {
            let good = bytes.utf8_chunks().next().map_or("", |it| it.valid());
            let source = Self::new(name, good, 1);
            let field = source.key_near(good.len());
            let message = "expected UTF-8 text, found other bytes";
            return Err(source.error_at(good.len(), field, message));
        };
        Ok(Self::new(name, text, 1))
    }

    pub(crate) fn text(&self) -> &'a str {
        self.text
    }

    /// The lines of the text with their numbers.
    pub(crate) fn lines(&self) -> impl Iterator<Item = (usize, &'a str)> + use<'a> {
        (self.first_line..).zip(self.text.lines())
    }

    /// A part of the text as a separate source, whose errors belong to the same file.
    pub(crate) fn part(&self, bytes: std::ops::Range<usize>) -> Self {
        let first_line = self.line_of(bytes.start);
        let text = self.text.get(bytes).unwrap_or_default();
        Self::new(self.name, text, first_line)
    }

    /// The error that `message` describes, at a byte of the text.
    pub(super) fn error_at(&self, at: usize, field: &str, message: impl Into<String>) -> FileError {
        FileError {
            field: (!field.is_empty()).then(|| field.into()),
            ..self.error_on(self.line_of(at), message)
        }
    }

    /// The error that `message` describes, at the given line.
    pub(crate) fn error_on(&self, line: usize, message: impl Into<String>) -> FileError {
        FileError::on_line(self.name, line, message)
    }

    /// Notes an error at a byte of the text.
    pub(super) fn note(&self, rank: Rank, at: usize, field: &str, message: impl Into<String>) {
        let mut errors = self.errors.borrow_mut();
        if errors.len() < MOST_NOTED {
            errors.push((rank, self.error_at(at, field, message)));
        }
    }

    /// Notes an error at the given line; always returns `None`, for the caller to return.
    pub(crate) fn refuse<T>(&self, line: usize, message: impl Into<String>) -> Option<T> {
        let error = self.error_on(line, message);
        self.errors.borrow_mut().push((Rank::Value, error));
        None
    }

    /// Discards the errors found so far.
    pub(super) fn forget(&self) {
        self.errors.borrow_mut().clear();
    }

    /// The value made from a line; on an error, notes the message and returns `None`.
    pub(crate) fn accept<T>(&self, line: usize, made: Result<T, String>) -> Option<T> {
        match made {
            Ok(made) => Some(made),
            Err(message) => self.refuse(line, message),
        }
    }

    /// Adds the errors of a [part](Self::part).
    pub(crate) fn absorb(&self, part: Self) {
        let mut errors = self.errors.borrow_mut();
        errors.extend(part.errors.into_inner());
    }

    /// The result, unless the text has errors.
    ///
    /// # Errors
    /// Returns all errors that were found.
    pub(crate) fn finish<T>(self, made: Option<T>) -> Result<T, FileErrors> {
        let mut errors = self.errors.into_inner();
        let broken = errors.iter().filter(|(rank, _)| *rank == Rank::Syntax);
        let broken: Vec<_> = broken.map(|(_, error)| error.line).collect();
        errors.retain(|(rank, error)| *rank != Rank::Value || !broken.contains(&error.line));
        errors.sort_by_key(|(rank, error)| (*rank != Rank::UnknownField, error.line));
        let mut errors: Vec<_> = errors.into_iter().map(|(_, error)| error).collect();
        errors.dedup();
        match (FileErrors::of(self.name, errors), made) {
            (None, Some(made)) => Ok(made),
            (Some(errors), _) => Err(errors),
            // This cannot happen: if there is no result, an error has been noted.
            (None, None) => Err(FileError::of_file(self.name, "cannot be understood").into()),
        }
    }

    pub(super) fn line_of(&self, at: usize) -> usize {
        let before = self.text.as_bytes().iter().take(at);
        self.first_line + before.filter(|&&byte| byte == b'\n').count()
    }

    /// The line that contains a byte.
    pub(super) fn line_near(&self, at: usize) -> &'a str {
        let before = self.text.get(..at).unwrap_or_default();
        let start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = self.text.get(start..).unwrap_or_default();
        line.lines().next().unwrap_or_default()
    }

    /// The key that is set on the line that contains a byte; empty if there is none.
    pub(super) fn key_near(&self, at: usize) -> &'a str {
        let key = self.line_near(at).split_once('=');
        let key = key.map_or("", |(key, _)| key.trim());
        let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        if key.chars().all(bare) { key } else { "" }
    }
}

/// A number of bytes in a suitable unit.
fn size(bytes: usize) -> String {
    match bytes {
        0..1024 => format!("{bytes} bytes"),
        1024..0x10_0000 => format!("{} KiB", bytes >> 10),
        _ => format!("{} MiB", bytes >> 20),
    }
}
