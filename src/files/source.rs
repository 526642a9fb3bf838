//! The text of a file, and what is wrong with it where.

use super::error::FileError;

/// U+FEFF in UTF-8.
pub const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// A file's text and its name, for messages.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    name: &'a str,
    text: &'a str,
}

impl<'a> Source<'a> {
    /// The bytes of a file of this name, as text.
    ///
    /// # Errors
    /// If there are more than `most` of them, or they are no UTF-8.
    pub fn of_bytes(name: &'a str, bytes: &'a [u8], most: usize) -> Result<Self, FileError> {
        let empty = Source { name, text: "" };
        if bytes.len() > most {
            let message = format!("expected a file of at most {} MiB, found more", most >> 20);
            return Err(empty.fault(0, "", message));
        }
        // Some editors begin with a mark that says nothing about UTF-8.
        let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        std::str::from_utf8(bytes)
            .map(|text| Source { name, text })
            .map_err(|error| {
                let good = bytes.get(..error.valid_up_to()).unwrap_or_default();
                let text = std::str::from_utf8(good).unwrap_or_default();
                let source = Source { name, text };
                let field = source.key_near(text.len());
                source.fault(text.len(), field, "expected UTF-8 text, found other bytes")
            })
    }

    /// Its text.
    pub fn text(&self) -> &'a str {
        self.text
    }

    /// The fault that `message` describes, at a byte of the text.
    pub fn fault(&self, at: usize, field: &str, message: impl Into<String>) -> FileError {
        let before = self.text.as_bytes().iter().take(at);
        FileError {
            file: self.name.into(),
            line: Some(1 + before.filter(|&&byte| byte == b'\n').count()),
            field: (!field.is_empty()).then(|| field.into()),
            message: message.into(),
        }
    }

    /// The key that the line around a byte sets, if it sets one.
    pub fn key_near(&self, at: usize) -> &'a str {
        let start = self
            .text
            .get(..at)
            .and_then(|before| before.rfind('\n'))
            .map_or(0, |newline| newline + 1);
        let line = self.text.get(start..).unwrap_or_default();
        let line = line.lines().next().unwrap_or_default();
        let key = line.split_once('=').map_or("", |(key, _)| key.trim());
        let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        if key.chars().all(bare) { key } else { "" }
    }
}
