//! Files of TOML whose first word is their format.

use serde::Deserialize;
use toml::Spanned;

use super::{FileError, Source};

/// What stands in a file of any format.
#[derive(Debug, Deserialize)]
struct AnyFormat {
    format: Option<Spanned<toml::Value>>,
}

impl<'a> Source<'a> {
    /// What stands in it, if it says `format = FORMAT`; `what` it is to be stands in
    /// messages, as "a saved game".
    ///
    /// # Errors
    /// The first thing that is wrong with it: that it is no TOML, of no format, of another
    /// or a newer one, or that its fields are not those of `T`.
    pub fn tables<T: Deserialize<'a>>(self, what: &str, format: u32) -> Result<T, FileError> {
        self.check_format(what, format)?;
        self.parse()
    }

    fn check_format(self, what: &str, format: u32) -> Result<(), FileError> {
        let expected = format!("expected {what} with `format = {format}`");
        if self.text().trim().is_empty() {
            return Err(self.fault(0, "", format!("{expected}, found an empty file")));
        }
        let any: AnyFormat = self.parse()?;
        let Some(found) = any.format else {
            return Err(self.fault(0, "format", format!("{expected}, found none")));
        };
        let message = match found.get_ref().as_integer() {
            Some(number) if number == i64::from(format) => return Ok(()),
            Some(number) if number > i64::from(format) => newer(number, format),
            _ => format!("{expected}, found {}", found.get_ref()),
        };
        Err(self.fault(found.span().start, "format", message))
    }

    fn parse<T: Deserialize<'a>>(self) -> Result<T, FileError> {
        toml::from_str(self.text()).map_err(|error| self.fault_of(&error))
    }

    /// What a reader of TOML found wrong with it.
    pub fn fault_of(self, error: &toml::de::Error) -> FileError {
        let at = error.span().map_or(0, |span| span.start);
        self.fault(at, self.key_near(at), error.message().trim())
    }
}

/// What is said of a file of a newer format than the one that is read.
pub fn newer(found: impl std::fmt::Display, format: u32) -> String {
    format!(
        "{found} is newer than the {format} this carrom reads; a newer carrom may open the file"
    )
}
