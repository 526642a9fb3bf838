//! A store for a browser, which has no folder: it starts with files that the caller gives, and
//! returns all files as bytes for the caller to keep.

use super::memory::Memory;
use super::{CLASSES, Database, GAMES, Store, TEXT};
use crate::messages::FileKind;

/// A file: its path in the data folder, such as `games/game-1.toml`, and its bytes.
pub type FileBytes = (String, Vec<u8>);

/// The path of the database.
const PROGRESS: &str = "progress.db";
/// The start of the paths of damaged databases.
const ASIDE: &str = "progress-damaged";
/// The folder of the exported files, which the player downloads.
const EXPORTS: &str = "exports/";

impl Store {
    /// Replaces the saved games, class rounds and databases of an in-memory store with these files
    /// (the latest last), because another copy of carrom has changed them. Open games and rounds
    /// stay open. A damaged database is kept under another name, and its readable rows are copied
    /// into a new one.
    pub fn renew(&mut self, files: &[FileBytes]) {
        self.games.renew(Memory::holding(GAMES, TEXT, files));
        self.classes.renew(Memory::holding(CLASSES, TEXT, files));
        let aside = files.iter().filter(|(path, _)| path.starts_with(ASIDE));
        self.aside = aside.cloned().collect();
        self.progress = Database::in_memory();
        let Some((_, bytes)) = files.iter().find(|(path, _)| path == PROGRESS) else {
            return;
        };
        let name = format!("{ASIDE}-{}.db", self.aside.len() + 1);
        let is_sound = match Database::of_bytes(bytes, &name) {
            Ok((database, was_damaged)) => {
                self.progress = database;
                !was_damaged
            }
            Err(trouble) => {
                self.notice = Some(format!(
                    "{PROGRESS} cannot be used: {trouble}. It is kept as {name}, and what you do \
                     from now on is saved in a new file."
                ));
                false
            }
        };
        if !is_sound {
            self.aside.push((name, bytes.clone()));
        }
    }

    /// The saved games, the class rounds, the database and any damaged databases.
    ///
    /// # Errors
    /// The reason why they cannot be read.
    pub fn files(&mut self) -> Result<Vec<FileBytes>, String> {
        let mut files = self.aside.clone();
        files.extend(self.games.files()?);
        files.extend(self.classes.files()?);
        let progress = self.progress.bytes()?;
        files.extend(progress.map(|bytes| (PROGRESS.into(), bytes)));
        Ok(files)
    }

    /// The files exported since the last call: names and texts.
    pub fn take_exports(&mut self) -> Vec<(String, String)> {
        let mut taken = Vec::new();
        for store in [&mut self.exports, &mut self.tables, &mut self.pages] {
            for name in store.names().unwrap_or_default() {
                let place = store.place(&name);
                let bytes = store.read(&name).unwrap_or_default();
                let _ = store.remove(&name);
                let name_alone = place.strip_prefix(EXPORTS).unwrap_or(&place).to_owned();
                taken.push((name_alone, String::from_utf8_lossy(&bytes).into_owned()));
            }
        }
        taken
    }

    /// Adds the contents of another `progress.db`, given as bytes.
    ///
    /// # Errors
    /// The reason why the bytes cannot be used; then nothing is added.
    pub fn take_in_progress(&mut self, bytes: &[u8]) -> Result<(), String> {
        self.progress.take_in(bytes)
    }

    /// Adds a saved game or a class's round from a file with this name.
    ///
    /// # Errors
    /// The reason why the file cannot be used.
    pub fn take_in(&mut self, kind: FileKind, (name, bytes): &FileBytes) -> Result<(), String> {
        match kind {
            FileKind::Game => self.games.take_in(name, bytes),
            FileKind::Class => self.classes.take_in(name, bytes),
        }
    }
}
