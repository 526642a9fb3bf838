//! A store of named texts.

use std::time::Duration;

use crate::files::FileError;

/// A store of named texts. What fails is said in words.
pub(super) trait TextStore: Send {
    /// The names there are, the latest first.
    fn names(&self) -> Result<Vec<String>, String>;

    /// What stands under a name; of what is too large one byte more than may be read.
    fn read(&self, name: &str) -> Result<Vec<u8>, FileError>;

    /// How long ago it was put there.
    fn age(&self, name: &str) -> Option<Duration>;

    /// Where it is, for people.
    fn place(&self, name: &str) -> String;

    /// Puts a text under a name that nothing else has: `kind` with a number.
    fn add(&mut self, kind: &str, text: &str) -> Result<String, String>;

    /// Puts a text in the place of another; says `false`, and does nothing, if that
    /// is not what stands there.
    fn replace(&mut self, name: &str, old: &str, text: &str) -> Result<bool, String>;

    /// Puts a text behind another; says `false`, and does nothing, if that is not what stands
    /// there. If carrom is killed meanwhile, part of the added text may remain.
    fn append(&mut self, name: &str, old: &str, added: &str) -> Result<bool, String>;

    /// Removes what stands under a name.
    fn remove(&mut self, name: &str) -> Result<(), String>;
}

/// The number in a name that [`TextStore::add`] made: 7 in `game-7`.
pub(super) fn number(name: &str) -> Option<u64> {
    name.rsplit_once('-')?.1.parse().ok()
}

/// A number larger than those of all names of that kind.
pub(super) fn free_number<'a>(names: impl IntoIterator<Item = &'a str>, kind: &str) -> u64 {
    let of_kind = |name: &&str| {
        let number = name.strip_prefix(kind);
        number.is_some_and(|rest| rest.starts_with('-'))
    };
    let numbers = names.into_iter().filter(of_kind).filter_map(number);
    numbers.max().unwrap_or(0).saturating_add(1)
}
