//! A store whose files the caller keeps: it returns them all as bytes, and begins with given ones.
//! A browser has no folder.

use super::memory::Memory;
use super::text_store::TextStore;
use super::{Database, Store, TABLE, TEXT};

/// A file by its path in the folder for data: `games/game-1.toml`.
pub type FileBytes = (String, Vec<u8>);

/// The path of the database.
const PROGRESS: &str = "progress.db";
/// How the paths of databases begin that were damaged.
const ASIDE: &str = "progress-damaged";
/// The folder of what is exported, which is for the player to take away.
const EXPORTS: &str = "exports/";

impl Store {
    /// A store in memory that begins with these files, the latest last. A damaged database is
    /// set aside under another name, and what can be read of it goes into a new one.
    #[must_use]
    pub fn of_files(files: &[FileBytes]) -> Self {
        let mut store = Self::in_memory();
        store.renew(files);
        store
    }

    /// Takes these files in place of what there was: another carrom has changed them. What
    /// is being worked on stays known.
    pub fn renew(&mut self, files: &[FileBytes]) {
        self.games.renew(texts("games", files));
        self.classes.renew(texts("classes", files));
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

    /// All its files but those that were exported.
    ///
    /// # Errors
    /// If they cannot be read, the reason in words.
    pub fn files(&mut self) -> Result<Vec<FileBytes>, String> {
        let mut files = self.aside.clone();
        files.extend(self.games.files()?);
        files.extend(self.classes.files()?);
        let progress = self.progress.bytes()?;
        files.extend(progress.map(|bytes| (PROGRESS.into(), bytes)));
        Ok(files)
    }

    /// What was exported since the last call: names and texts.
    pub fn take_exports(&mut self) -> Vec<(String, String)> {
        let mut taken = Vec::new();
        for store in [&mut self.exports, &mut self.tables] {
            for name in store.names().unwrap_or_default() {
                let place = store.place(&name);
                let bytes = store.read(&name).unwrap_or_default();
                let name_alone = place.strip_prefix(EXPORTS).unwrap_or(&place).to_owned();
                taken.push((name_alone, String::from_utf8_lossy(&bytes).into_owned()));
            }
        }
        self.exports = texts("exports", &[]);
        self.tables = Box::new(Memory::new("exports", TABLE));
        taken
    }

    /// Adds what is in the bytes of another `progress.db` to its own.
    ///
    /// # Errors
    /// If they are no good, in words; then nothing is added.
    pub fn take_in_progress(&mut self, bytes: &[u8]) -> Result<(), String> {
        self.progress.take_in(bytes)
    }

    /// Adds a saved game from a file of that name.
    ///
    /// # Errors
    /// If it is none, in words.
    pub fn take_in_game(&mut self, name: &str, bytes: &[u8]) -> Result<(), String> {
        self.games.take_in(name, bytes)
    }

    /// Adds a round of a class from a file of that name.
    ///
    /// # Errors
    /// If it is none, in words.
    pub fn take_in_class(&mut self, name: &str, bytes: &[u8]) -> Result<(), String> {
        self.classes.take_in(name, bytes)
    }
}

fn texts(folder: &'static str, files: &[FileBytes]) -> Box<dyn TextStore> {
    Box::new(Memory::new(folder, TEXT).holding(files))
}
