//! The form for joining: the address of the class, its code and the pupil's name.

use crate::class::{JoinCode, LONGEST_NAME};
use crate::messages::Key;
use crate::screens::{Context, Route};
use crate::widgets::input::{KeyTable, ListAction, ListView, TextField};
use crate::widgets::panel::Panel;
use crate::widgets::{Outcome, Role};

/// The port of a class if the address has none.
pub(crate) const PORT: u16 = 8090;
/// The maximum number of letters in an address.
const LONGEST_ADDRESS: usize = 80;

/// The form for joining a class.
#[derive(Debug, Clone)]
pub(super) struct JoinForm {
    /// The address of the class; `None` if the host has served the page.
    address: Option<TextField>,
    code: TextField,
    name: TextField,
    list: ListView,
    /// Why joining failed.
    pub(super) trouble: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum JoinRow {
    Address,
    Code,
    Name,
    Enter,
}

/// A completed form.
pub(super) struct Entry {
    pub(super) address: String,
    pub(super) code: String,
    pub(super) name: String,
}

impl JoinForm {
    /// The form with the known values filled in.
    pub(super) fn new(address: Option<&str>, code: Option<JoinCode>, name: &str) -> Self {
        let code = code.map(|code| code.to_string()).unwrap_or_default();
        let mut form = Self {
            address: address.map(|it| TextField::new(it, LONGEST_ADDRESS)),
            code: TextField::new(&code, LONGEST_ADDRESS),
            name: TextField::new(name, 2 * LONGEST_NAME),
            list: ListView::default(),
            trouble: None,
        };
        let rows = form.rows();
        let missing = rows.iter().position(|row| {
            let field = form.field_of(*row);
            field.is_none_or(|field| field.text().trim().is_empty())
        });
        form.list.choose(missing.unwrap_or(rows.len()));
        form
    }

    /// The route by which the pupil can rejoin the class that is entered in the form.
    pub(super) fn route(&self) -> Route {
        Route::Join {
            address: self.address.as_ref().map(|it| it.text().to_owned()),
            code: self.code.text().parse().ok(),
            again: true,
        }
    }

    fn rows(&self) -> Vec<JoinRow> {
        let mut rows = vec![
            JoinRow::Address,
            JoinRow::Code,
            JoinRow::Name,
            JoinRow::Enter,
        ];
        rows.retain(|row| *row != JoinRow::Address || self.address.is_some());
        rows
    }

    fn at(&self) -> JoinRow {
        let rows = self.rows();
        rows[self.list.chosen(rows.len())]
    }

    fn field_of(&self, row: JoinRow) -> Option<&TextField> {
        match row {
            JoinRow::Address => self.address.as_ref(),
            JoinRow::Code => Some(&self.code),
            JoinRow::Name => Some(&self.name),
            JoinRow::Enter => None,
        }
    }

    fn field(&mut self) -> Option<&mut TextField> {
        match self.at() {
            JoinRow::Address => self.address.as_mut(),
            JoinRow::Code => Some(&mut self.code),
            JoinRow::Name => Some(&mut self.name),
            JoinRow::Enter => None,
        }
    }

    pub(super) fn keys(&self) -> KeyTable<ListAction> {
        let enter = match self.at() {
            JoinRow::Enter => "join",
            _ => "next",
        };
        let ends: &[Key] = match self.at() {
            JoinRow::Enter => &[],
            _ => &[Key::Home, Key::End, Key::Char(' ')],
        };
        ListView::keys(enter).without_keys(ends)
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
        let rows = self.rows();
        let outcome = match (action, self.list.act(action, rows.len())) {
            // One click is enough to join.
            (ListAction::Point(at), _) if rows.get(at) == Some(&JoinRow::Enter) => {
                Outcome::Done(at)
            }
            (ListAction::Point(_), _) => Outcome::Used,
            (_, outcome) => outcome,
        };
        match outcome {
            Outcome::Done(at) if rows[at] == JoinRow::Enter => self.entry(),
            Outcome::Done(at) => {
                self.list.choose(at + 1);
                None
            }
            _ => None,
        }
    }

    /// The typed code, once it is valid.
    pub(super) fn code(&self) -> Option<JoinCode> {
        self.code.text().parse().ok()
    }

    /// The entry, if it is complete.
    pub(super) fn entry(&mut self) -> Option<Entry> {
        let address = match &self.address {
            Some(field) => match host_of(field.text()) {
                Some(address) => address,
                None => {
                    return self.refuse(
                        JoinRow::Address,
                        "The address is on the board, such as 192.168.43.117:8090.",
                    );
                }
            },
            None => String::new(),
        };
        let Some(code) = self.code() else {
            return self.refuse(
                JoinRow::Code,
                "The code is the six letters on the board, such as BCDFGH.",
            );
        };
        // A round that gives nicknames requires no name.
        let name = self.name.text().trim().to_owned();
        let code = code.to_string();
        Some(Entry {
            address,
            code,
            name,
        })
    }

    /// Adopts the nickname that the class has given to this device. On a page that the host has
    /// served, it also becomes the player's name.
    pub(super) fn take_nickname(&mut self, name: &str, cx: &mut Context) {
        self.name = TextField::new(name, 2 * LONGEST_NAME);
        if self.address.is_none() {
            cx.change_player(name.to_owned());
        }
    }

    fn refuse<T>(&mut self, row: JoinRow, words: &str) -> Option<T> {
        let at = self.rows().iter().position(|it| *it == row);
        self.list.choose(at.unwrap_or(0));
        self.trouble = Some(words.into());
        None
    }

    pub(super) fn write(&self, panel: &mut Panel<ListAction>) {
        let at = self.at();
        panel.paragraph("Your class is playing a round.", Role::Title);
        panel.gap();
        for (i, row) in self.rows().into_iter().enumerate() {
            let name = match row {
                JoinRow::Address => "address",
                JoinRow::Code => "code",
                JoinRow::Name => "name",
                JoinRow::Enter => "Join the class",
            };
            let (chosen, point) = (row == at, ListAction::Point(i));
            match self.field_of(row) {
                Some(field) if chosen => {
                    panel.text_field(name, field.around_cursor(), true, Some(point));
                }
                Some(field) => panel.text_field(name, (field.text(), ""), false, Some(point)),
                None => panel.row((name, Role::Text), ("", Role::Text), chosen, point),
            }
            panel.gap();
        }
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
