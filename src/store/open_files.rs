//! Files that are saved repeatedly.

use std::collections::BTreeMap;

use super::text_store::TextStore;
use crate::files::FileErrors;
use crate::messages::Kept;
use crate::progress::Calendar;

/// Items of one kind that are saved repeatedly; each open item is identified by a ticket.
pub(super) struct OpenFiles<T> {
    texts: Box<dyn TextStore>,
    /// The start of the names.
    kind: &'static str,
    /// Reads an item from a file's name and bytes.
    pub(super) read: ReadBytes<T>,
    /// The name and the last known text of each open item, by ticket.
    open: BTreeMap<u64, OpenFile>,
    /// The pending notice for the player.
    pub(super) notice: Option<String>,
}

/// A function that reads an item from a file's name and bytes.
pub(super) type ReadBytes<T> = Box<dyn Fn(&str, &[u8]) -> Result<T, FileErrors> + Send>;

/// An item that is open for saving.
struct OpenFile {
    name: String,
    text: String,
}

impl<T> OpenFiles<T> {
    /// The items of one kind in a store of texts; none of them is open.
    pub(super) fn new(texts: Box<dyn TextStore>, kind: &'static str, read: ReadBytes<T>) -> Self {
        Self {
            texts,
            kind,
            read,
            open: BTreeMap::new(),
            notice: None,
        }
    }

    /// Replaces all texts, because another copy of carrom has changed them. Open items stay open.
    pub(super) fn renew(&mut self, texts: impl TextStore + 'static) {
        self.texts = Box::new(texts);
    }

    /// All texts with their paths, the latest last.
    pub(super) fn files(&self) -> Result<Vec<(String, Vec<u8>)>, String> {
        let names = self.texts.names()?.into_iter().rev();
        let file = |name: String| Some((self.texts.place(&name), self.texts.read(&name).ok()?));
        Ok(names.filter_map(file).collect())
    }

    /// Adds an item from a file's bytes; `name` is for error messages.
    pub(super) fn take_in(&mut self, name: &str, bytes: &[u8]) -> Result<(), String> {
        (self.read)(name, bytes).map_err(|fault| fault.to_string())?;
        let text = String::from_utf8_lossy(bytes);
        self.texts.add(self.kind, &text).map(drop)
    }

    /// Saves a text over the one that was last saved or loaded with this ticket. If there is none,
    /// or it has changed since, a new file is created.
    pub(super) fn save(&mut self, ticket: u64, text: String) -> Result<(), String> {
        if let Some(open) = self.open.get_mut(&ticket)
            && self.texts.replace(&open.name, &open.text, &text)?
        {
            open.text = text;
            return Ok(());
        }
        let name = self.texts.add(self.kind, &text)?;
        let place = self.texts.place(&name);
        if let Some(before) = self.open.insert(ticket, OpenFile { name, text }) {
            self.notice = Some(format!(
                "{} has changed since it was saved here; another copy of carrom may have it \
                 open. From now on, your version is saved in {place}.",
                self.texts.place(&before.name),
            ));
        }
        Ok(())
    }

    /// Appends to the text that was last saved or loaded with this ticket; returns `false` if there
    /// is none, or if it has changed since.
    pub(super) fn append(&mut self, ticket: u64, added: &str) -> Result<bool, String> {
        let Some(open) = self.open.get_mut(&ticket) else {
            return Ok(false);
        };
        let appended = self.texts.append(&open.name, &open.text, added)?;
        if appended {
            open.text.push_str(added);
        }
        Ok(appended)
    }

    /// All items, the latest first; if a calendar is given, each with its age and the day on which
    /// it was saved.
    pub(super) fn list(&self, calendar: Option<&Calendar>) -> Result<Vec<Kept<T>>, String> {
        let names = self.texts.names()?.into_iter();
        let found = names.map(|name| {
            let age = calendar.and_then(|_| self.texts.age(&name));
            let day = age.zip(calendar).and_then(|(age, calendar)| {
                let age_s = i64::try_from(age.as_secs()).ok()?;
                calendar.day(calendar.now_s?.checked_sub(age_s)?)
            });
            Kept {
                age,
                day,
                content: match self.read(&name) {
                    Ok((_, thing)) => Ok(Box::new(thing)),
                    Err(fault) => Err(fault.without_file()),
                },
                name,
            }
        });
        Ok(found.collect())
    }

    /// Reads the item with this name and opens it under this ticket.
    pub(super) fn load(&mut self, ticket: u64, name: &str) -> Result<T, String> {
        let (text, thing) = self.read(name).map_err(|fault| fault.to_string())?;
        let name = name.to_owned();
        self.open.insert(ticket, OpenFile { name, text });
        Ok(thing)
    }

    /// Removes the item with this name.
    pub(super) fn remove(&mut self, name: &str) -> Result<(), String> {
        self.texts.remove(name)
    }

    /// The text with this name, and the item read from it.
    fn read(&self, name: &str) -> Result<(String, T), FileErrors> {
        let bytes = self.texts.read(name)?;
        let thing = (self.read)(&self.texts.place(name), &bytes)?;
        Ok((String::from_utf8_lossy(&bytes).into_owned(), thing))
    }
}
