//! A shelf of things that are saved again and again.

use std::collections::BTreeMap;
use std::time::Duration;

use super::shelf::Shelf;
use crate::files::FileErrors;

/// A shelf of things of one kind that are saved again and again, each known by the
/// ticket of whoever works on it.
pub(super) struct Drawer<T> {
    shelf: Box<dyn Shelf>,
    /// What names begin with.
    kind: &'static str,
    /// Makes a thing of the bytes of a file of this name.
    read: Read<T>,
    /// What was last put or found under which name, by ticket.
    open: BTreeMap<u64, Open>,
    notice: Option<String>,
}

/// Makes a thing of the bytes of a file of a name.
type Read<T> = Box<dyn Fn(&str, &[u8]) -> Result<T, FileErrors> + Send>;

/// A thing being worked on.
struct Open {
    name: String,
    text: String,
}

/// Something in a drawer.
pub(super) struct Found<T> {
    pub(super) name: String,
    /// How long ago it was put there; `None` where nobody knows the time.
    pub(super) age: Option<Duration>,
    /// The thing, or why it cannot be read. Where it is, is not said once more.
    pub(super) thing: Result<T, String>,
}

impl<T> Drawer<T> {
    /// A shelf of things of a kind, none of them being worked on.
    pub(super) fn new(
        shelf: impl Shelf + 'static,
        kind: &'static str,
        read: impl Fn(&str, &[u8]) -> Result<T, FileErrors> + Send + 'static,
    ) -> Self {
        Self {
            shelf: Box::new(shelf),
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

    /// Saves a text in the place of what was saved or loaded with this ticket before; in
    /// a new one if there is none, or if something else stands there now.
    pub(super) fn save(&mut self, ticket: u64, text: String) -> Result<(), String> {
        if let Some(open) = self.open.get_mut(&ticket)
            && self.shelf.replace(&open.name, &open.text, &text)?
        {
            open.text = text;
            return Ok(());
        }
        let name = self.shelf.add(self.kind, &text)?;
        let place = self.shelf.place(&name);
        if let Some(before) = self.open.insert(ticket, Open { name, text }) {
            self.notice = Some(format!(
                "{} is no longer as it was saved here; another carrom may have it open. \
                 From now on this is saved in {place}.",
                self.shelf.place(&before.name),
            ));
        }
        Ok(())
    }

    /// What the player should know of it, once.
    pub(super) fn take_notice(&mut self) -> Option<String> {
        self.notice.take()
    }

    /// All there is, the latest first.
    pub(super) fn list(&self) -> Result<Vec<Found<T>>, String> {
        let names = self.shelf.names()?.into_iter();
        let found = names.map(|name| Found {
            age: self.shelf.age(&name),
            thing: match self.read(&name) {
                Ok((_, thing)) => Ok(thing),
                Err(fault) => Err(fault.without_file()),
            },
            name,
        });
        Ok(found.collect())
    }

    /// The thing of a name, to be saved with this ticket from now on.
    pub(super) fn load(&mut self, ticket: u64, name: &str) -> Result<T, String> {
        let (text, thing) = self.read(name).map_err(|fault| fault.to_string())?;
        let name = name.to_owned();
        self.open.insert(ticket, Open { name, text });
        Ok(thing)
    }

    /// Removes the thing of a name.
    pub(super) fn remove(&mut self, name: &str) -> Result<(), String> {
        self.shelf.remove(name)
    }

    /// The text under a name, and the thing that it makes.
    fn read(&self, name: &str) -> Result<(String, T), FileErrors> {
        let bytes = self.shelf.read(name)?;
        let thing = (self.read)(&self.shelf.place(name), &bytes)?;
        Ok((String::from_utf8_lossy(&bytes).into_owned(), thing))
    }
}
