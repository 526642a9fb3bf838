//! A shelf of things that are saved again and again.

use std::collections::BTreeMap;

use super::shelf::Shelf;

/// A shelf of things of one kind that are saved again and again, each known by the
/// ticket of whoever works on it.
pub(super) struct Drawer {
    pub(super) shelf: Box<dyn Shelf>,
    /// What names begin with.
    kind: &'static str,
    /// What was last put or found under which name, by ticket.
    open: BTreeMap<u64, Open>,
}

/// A thing being worked on.
struct Open {
    name: String,
    text: String,
}

impl Drawer {
    /// A shelf of things of a kind, none of them being worked on.
    pub(super) fn new(shelf: impl Shelf + 'static, kind: &'static str) -> Self {
        Self {
            shelf: Box::new(shelf),
            kind,
            open: BTreeMap::new(),
        }
    }

    /// Saves a text in the place of what was saved or taken with this ticket before; in
    /// a new one if there is none, or if something else stands there now.
    pub(super) fn save(&mut self, ticket: u64, text: String) -> Result<(), String> {
        if let Some(open) = self.open.get_mut(&ticket)
            && self.shelf.replace(&open.name, &open.text, &text)?
        {
            open.text = text;
            return Ok(());
        }
        let name = self.shelf.add(self.kind, &text)?;
        self.open.insert(ticket, Open { name, text });
        Ok(())
    }

    /// Notes that what stands under a name was taken with this ticket.
    pub(super) fn taken(&mut self, ticket: u64, name: &str, text: String) {
        let name = name.to_owned();
        self.open.insert(ticket, Open { name, text });
    }
}
