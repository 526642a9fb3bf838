//! A store of named texts.

use std::time::Duration;

use crate::files::FileError;

/// A store of named texts. Errors are messages for the player.
pub(super) trait TextStore: Send {
    /// The names of all texts, the latest first.
    fn names(&self) -> Result<Vec<String>, String>;

    /// The text with this name. A text that is too large is cut off one byte beyond the limit.
    fn read(&self, name: &str) -> Result<Vec<u8>, FileError>;

    /// The time since the text was last written.
    fn age(&self, name: &str) -> Option<Duration>;

    /// The text's location, for messages.
    fn place(&self, name: &str) -> String;

    /// Adds a text under an unused name: `kind` with a number. Returns the name.
    fn add(&mut self, kind: &str, text: &str) -> Result<String, String>;

    /// Adds a text like [`Self::add`]; returns its location.
    fn export(&mut self, kind: &str, text: &str) -> Result<String, String> {
        let name = self.add(kind, text)?;
        Ok(self.place(&name))
    }

    /// Replaces a text. If its content is not `old`, returns `false` and does nothing.
    fn replace(&mut self, name: &str, old: &str, text: &str) -> Result<bool, String>;

    /// Appends to a text. If its content is not `old`, returns `false` and does nothing. If carrom
    /// is killed meanwhile, part of the added text may remain.
    fn append(&mut self, name: &str, old: &str, added: &str) -> Result<bool, String>;

    /// Removes the text with this name.
    fn remove(&mut self, name: &str) -> Result<(), String>;
}

/// The number in a name that [`TextStore::add`] made: 7 in `game-7`.
pub(super) fn number(name: &str) -> Option<u32> {
    name.rsplit_once('-')?.1.parse().ok()
}

/// Names of this kind, beginning with a number that is larger than that in any known name. If
/// somebody has chosen a number that is too large, the first few may still be known.
pub(super) fn free_names<'a>(
    known: impl IntoIterator<Item = &'a str>,
    kind: &str,
) -> impl Iterator<Item = String> {
    let of_kind = |name: &&str| {
        let number = name.strip_prefix(kind);
        number.is_some_and(|rest| rest.starts_with('-'))
    };
    let numbers = known.into_iter().filter(of_kind).filter_map(number);
    let last = numbers.max().unwrap_or(0);
    (u64::from(last) + 1..).map(move |number| format!("{kind}-{number}"))
}
