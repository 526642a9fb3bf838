//! Texts in memory.

use std::time::Duration;

use super::FileBytes;
use super::text_store::{TextStore, free_names};
use crate::files::FileError;

/// Texts in memory, the latest last.
pub(super) struct Memory {
    folder: &'static str,
    /// The suffix of the names.
    ending: &'static str,
    texts: Vec<(String, String)>,
}

impl Memory {
    /// A store with this folder name and suffix; it holds those of `files` whose paths have both,
    /// the latest last.
    pub(super) fn holding(folder: &'static str, ending: &'static str, files: &[FileBytes]) -> Self {
        let own = files.iter().filter_map(|(path, bytes)| {
            let name = path.strip_prefix(folder)?.strip_prefix('/')?;
            let name = name.strip_suffix(ending)?.to_owned();
            Some((name, String::from_utf8_lossy(bytes).into_owned()))
        });
        Self {
            folder,
            ending,
            texts: own.collect(),
        }
    }
}

impl TextStore for Memory {
    fn names(&self) -> Result<Vec<String>, String> {
        let names = self.texts.iter().rev().map(|(name, _)| name.clone());
        Ok(names.collect())
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, FileError> {
        let found = self.texts.iter().find(|(known, _)| known == name);
        let text = found.map(|(_, text)| text.clone().into_bytes());
        text.ok_or_else(|| FileError::of_file(&self.place(name), "is no longer there"))
    }

    fn age(&self, _name: &str) -> Option<Duration> {
        None
    }

    fn place(&self, name: &str) -> String {
        format!("{}/{name}{}", self.folder, self.ending)
    }

    fn add(&mut self, kind: &str, text: &str) -> Result<String, String> {
        let known: Vec<_> = self.texts.iter().map(|(name, _)| &**name).collect();
        let name = free_names(known.iter().copied(), kind)
            .find(|name| !known.contains(&name.as_str()))
            .ok_or("there are too many files")?;
        self.texts.push((name.clone(), text.to_owned()));
        Ok(name)
    }

    fn replace(&mut self, name: &str, old: &str, text: &str) -> Result<bool, String> {
        let there = |(known, now): &(String, String)| known == name && now == old;
        let Some(at) = self.texts.iter().position(there) else {
            return Ok(false);
        };
        self.texts.remove(at);
        self.texts.push((name.to_owned(), text.to_owned()));
        Ok(true)
    }

    fn append(&mut self, name: &str, old: &str, added: &str) -> Result<bool, String> {
        self.replace(name, old, &format!("{old}{added}"))
    }

    fn remove(&mut self, name: &str) -> Result<(), String> {
        self.texts.retain(|(known, _)| known != name);
        Ok(())
    }
}
