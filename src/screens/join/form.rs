//! The form for joining: the address of the class, its code and the pupil's name.

use strum::IntoStaticStr;

use crate::class::protocol::PORT;
use crate::class::{JoinCode, LONGEST_NAME};
use crate::messages::Key;
use crate::screens::{Context, Route};
use crate::widgets::input::{KeyTable, ListAction, ListView, TextField};
use crate::widgets::panel::Panel;
use crate::widgets::{Outcome, Role};

/// The maximum number of characters in an address.
const LONGEST_ADDRESS: usize = 80;

/// The form for joining a class.
#[derive(Debug, Clone)]
pub(super) struct JoinForm {
    /// The fields, from top to bottom; there is no address if the host has served the page.
    fields: Vec<(JoinField, TextField)>,
    /// The fields; after the last comes the row that joins.
    list: ListView,
    /// Why joining failed.
    pub(super) trouble: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
enum JoinField {
    Address,
    Code,
    Name,
}

/// A completed form.
#[derive(Debug, Clone, Default)]
pub(super) struct Entry {
    pub(super) address: String,
    pub(super) code: String,
    pub(super) name: String,
}

impl JoinForm {
    /// The form with the known values filled in.
    pub(super) fn new(address: Option<&str>, code: Option<JoinCode>, name: &str) -> Self {
        let code = code.map(|code| code.to_string()).unwrap_or_default();
        let address = address.map(|it| (JoinField::Address, TextField::new(it, LONGEST_ADDRESS)));
        let others = [
            (JoinField::Code, TextField::new(&code, LONGEST_ADDRESS)),
            (JoinField::Name, TextField::new(name, 2 * LONGEST_NAME)),
        ];
        let fields: Vec<_> = address.into_iter().chain(others).collect();
        let mut list = ListView::default();
        let missing = { fields.iter() }.position(|(_, field)| field.text().trim().is_empty());
        list.choose(missing.unwrap_or(fields.len()));
        Self {
            fields,
            list,
            trouble: None,
        }
    }

    /// The route by which the pupil can rejoin the class that is entered in the form.
    pub(super) fn route(&self) -> Route {
        Route::Join {
            address: self.text(JoinField::Address).map(str::to_owned),
            code: self.code(),
            again: true,
        }
    }

    /// The text of a field; `None` if the form does not have it.
    fn text(&self, field: JoinField) -> Option<&str> {
        let found = self.fields.iter().find(|(it, _)| *it == field);
        found.map(|(_, it)| it.text())
    }

    /// The chosen row: the index of a field, or the number of fields for the row that joins.
    fn at(&self) -> usize {
        self.list.chosen(self.fields.len() + 1)
    }

    fn field(&mut self) -> Option<&mut TextField> {
        let at = self.at();
        self.fields.get_mut(at).map(|(_, field)| field)
    }

    pub(super) fn keys(&self) -> KeyTable<ListAction> {
        let is_text = self.at() < self.fields.len();
        ListView::keys_of_form(if is_text { "next" } else { "join" }, is_text)
    }

    /// Handles a key that edits text; returns whether the key was used.
    pub(super) fn typed(&mut self, key: Key) -> bool {
        let typed = self.field().is_some_and(|field| field.update(key));
        if typed {
            self.trouble = None;
        }
        typed
    }

    pub(super) fn paste(&mut self, text: &str) {
        if let Some(field) = self.field() {
            field.paste(text);
        }
    }

    /// Carries out an action; returns the entry once it is complete.
    pub(super) fn act(&mut self, action: ListAction) -> Option<Entry> {
        let join = self.fields.len();
        match (action, self.list.act(action, join + 1)) {
            // One click is enough to join.
            (ListAction::Point(at), _) if at == join => self.entry(),
            (ListAction::Point(_), _) => None,
            (_, Outcome::Done(at)) if at == join => self.entry(),
            (_, Outcome::Done(at)) => {
                self.list.choose(at + 1);
                None
            }
            _ => None,
        }
    }

    /// The typed code, once it is valid.
    pub(super) fn code(&self) -> Option<JoinCode> {
        self.text(JoinField::Code)?.parse().ok()
    }

    /// The entry, if it is complete.
    pub(super) fn entry(&mut self) -> Option<Entry> {
        let Some(address) = self
            .text(JoinField::Address)
            .map_or(Some(String::new()), host_of)
        else {
            let words = "The address is on the board, such as 192.168.43.117:8090.";
            return self.refuse(JoinField::Address, words);
        };
        let Some(code) = self.code() else {
            let words = "The code is the six letters on the board, such as BCDFGH.";
            return self.refuse(JoinField::Code, words);
        };
        // A round that gives nicknames requires no name.
        let name = self.text(JoinField::Name).unwrap_or_default();
        Some(Entry {
            address,
            code: code.to_string(),
            name: name.trim().to_owned(),
        })
    }

    /// Adopts the nickname that the class has given to this device. On a page that the host has
    /// served, it also becomes the player's name.
    pub(super) fn take_nickname(&mut self, name: &str, cx: &mut Context) {
        for (field, text) in &mut self.fields {
            if *field == JoinField::Name {
                *text = TextField::new(name, 2 * LONGEST_NAME);
            }
        }
        if self.text(JoinField::Address).is_none() {
            cx.change_player(name.to_owned());
        }
    }

    fn refuse<T>(&mut self, field: JoinField, words: &str) -> Option<T> {
        let at = self.fields.iter().position(|(it, _)| *it == field);
        self.list.choose(at.unwrap_or(0));
        self.trouble = Some(words.into());
        None
    }

    pub(super) fn write(&self, panel: &mut Panel<ListAction>) {
        let at = self.at();
        panel.paragraph("Your class is playing a round.", Role::Title);
        panel.gap();
        for (i, (name, field)) in self.fields.iter().enumerate() {
            let typed = match i == at {
                true => field.around_cursor(),
                false => (field.text(), ""),
            };
            let name: &str = name.into();
            panel.text_field(name, typed, i == at, Some(ListAction::Point(i)));
            panel.gap();
        }
        let join = self.fields.len();
        let name = ("Join the class", Role::Text);
        panel.row(name, ("", Role::Text), at == join, ListAction::Point(join));
        panel.gap();
        if let Some(trouble) = &self.trouble {
            panel.paragraph(trouble, Role::Warn);
            panel.gap();
        }
        let openly = "Everyone on this network can see names and votes. A nickname is fine. If the \
                      class gives nicknames, leave the name empty.";
        panel.paragraph(openly, Role::Dim);
    }
}

/// Host and port of an address as people write it: `192.168.43.117`, or the link of a QR code.
pub(crate) fn host_of(address: &str) -> Option<String> {
    let address = address.trim();
    let address = address.strip_prefix("http://").unwrap_or(address);
    let host = address.split(['/', '#', '?']).next()?;
    let good = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | ':' | '-' | '[' | ']');
    if host.is_empty() || !host.chars().all(good) {
        return None;
    }
    match host.rsplit_once(':') {
        Some((_, port)) if !host.ends_with(']') => {
            port.parse::<u16>().ok()?;
            Some(host.to_owned())
        }
        _ => Some(format!("{host}:{PORT}")),
    }
}

#[cfg(not(target_family = "wasm"))]
/// The code in the link of a QR code.
pub(crate) fn code_of(address: &str) -> Option<JoinCode> {
    address.split_once("#code=")?.1.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_click_joins_whichever_row_is_marked() {
        let code = "BCDFGH".parse().ok();
        let mut form = JoinForm::new(None, code, "Ada");
        for at in [2, 1] {
            form.list.choose(at);
            let entry = form.act(ListAction::Point(2));
            assert_eq!(
                entry.map(|it| it.name).as_deref(),
                Some("Ada"),
                "from row {at}"
            );
        }
    }

    #[test]
    fn an_address_is_read_as_people_write_it() {
        for (text, host) in [
            ("192.168.43.117", Some("192.168.43.117:8090")),
            (" 192.168.43.117:9000 ", Some("192.168.43.117:9000")),
            (
                "http://192.168.43.117:8090/#code=BCDFGH",
                Some("192.168.43.117:8090"),
            ),
            ("localhost", Some("localhost:8090")),
            ("[::1]:8090", Some("[::1]:8090")),
            ("", None),
            ("host:port", None),
            ("a b", None),
            ("<script>", None),
        ] {
            assert_eq!(host_of(text).as_deref(), host, "{text}");
        }
        let code = code_of("http://192.168.43.117:8090/#code=BCDFGH");
        assert_eq!(code.unwrap().to_string(), "BCDFGH");
        assert_eq!(code_of("192.168.43.117:8090"), None);
    }
}
