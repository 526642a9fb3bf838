//! Files that are saved repeatedly.

use std::collections::BTreeMap;

use super::text_store::TextStore;
use crate::files::FileErrors;
use crate::messages::Kept;
use crate::progress::Calendar;

/// Items of one kind that are saved repeatedly, each identified by a ticket.
pub(super) struct OpenFiles<T> {
    texts: Box<dyn TextStore>,
    /// What names begin with.
    kind: &'static str,
    /// Makes a thing of the bytes of a file of this name.
    read: ReadBytes<T>,
    /// What was last put or found under which name, by ticket.
    open: BTreeMap<u64, OpenFile>,
    notice: Option<String>,
}

/// Makes a thing of the bytes of a file of a name.
type ReadBytes<T> = Box<dyn Fn(&str, &[u8]) -> Result<T, FileErrors> + Send>;

/// A thing being worked on.
struct OpenFile {
    name: String,
    text: String,
}

impl<T> OpenFiles<T> {
    /// The things of a kind that a store of texts holds, none of them being worked on.
    pub(super) fn new(
        texts: Box<dyn TextStore>,
        kind: &'static str,
        read: impl Fn(&str, &[u8]) -> Result<T, FileErrors> + Send + 'static,
    ) -> Self {
        Self {
            texts,
            kind,
            read: Box::new(read),
            open: BTreeMap::new(),
            notice: None,
        }
    }

    /// Has the things made of bytes in another way from now on.
    pub(super) fn read_by(
        &mut self,
        read: impl Fn(&str, &[u8]) -> Result<T, FileErrors> + Send + 'static,
    ) {
        self.read = Box::new(read);
    }

    /// Takes other texts in place of those there were: another carrom has changed them. What
    /// is open stays so.
    pub(super) fn renew(&mut self, texts: Box<dyn TextStore>) {
        self.texts = texts;
    }

    /// All texts by their places, the latest last.
    pub(super) fn files(&self) -> Result<Vec<(String, Vec<u8>)>, String> {
        let names = self.texts.names()?.into_iter().rev();
        let file = |name: String| Some((self.texts.place(&name), self.texts.read(&name).ok()?));
        Ok(names.filter_map(file).collect())
    }

    /// Adds what the bytes of a file of that name make.
    pub(super) fn take_in(&mut self, name: &str, bytes: &[u8]) -> Result<(), String> {
        (self.read)(name, bytes).map_err(|fault| fault.to_string())?;
        let text = String::from_utf8_lossy(bytes);
        self.texts.add(self.kind, &text).map(drop)
    }

    /// Saves a text in the place of what was saved or loaded with this ticket before; in
    /// a new one if there is none, or if something else stands there now.
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
                "{} is no longer as it was saved here; another carrom may have it open. \
                 From now on this is saved in {place}.",
                self.texts.place(&before.name),
            ));
        }
        Ok(())
    }

    /// Appends a text to what was saved or loaded with this ticket before; says `false` if
    /// there is none, or if something else stands there now.
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

    /// What the player should know of it, once.
    pub(super) fn take_notice(&mut self) -> Option<String> {
        self.notice.take()
    }

    /// All there is, the latest first, with their ages and days where a calendar knows them.
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

    /// The thing of a name, to be saved with this ticket from now on.
    pub(super) fn load(&mut self, ticket: u64, name: &str) -> Result<T, String> {
        let (text, thing) = self.read(name).map_err(|fault| fault.to_string())?;
        let name = name.to_owned();
        self.open.insert(ticket, OpenFile { name, text });
        Ok(thing)
    }

    /// Removes the thing of a name.
    pub(super) fn remove(&mut self, name: &str) -> Result<(), String> {
        self.texts.remove(name)
    }

    /// The text under a name, and the thing that it makes.
    fn read(&self, name: &str) -> Result<(String, T), FileErrors> {
        let bytes = self.texts.read(name)?;
        let thing = (self.read)(&self.texts.place(name), &bytes)?;
        Ok((String::from_utf8_lossy(&bytes).into_owned(), thing))
    }
}
