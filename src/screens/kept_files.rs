//! A list of kept files, the newest first: to open one, or to remove it.

use strum::{EnumMessage, IntoStaticStr};

use super::Confirmation;
use crate::messages::{Kept, Key, Mouse};
use crate::widgets::input::{KeyTable, ListAction, ListView};
use crate::widgets::{Lines, Outcome, Role, text};

/// What keys do to a list of kept files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum KeptAction {
    /// choose a file, or open it
    List(ListAction),
    /// remove the chosen file for good
    Remove,
}

/// The files of one kind that there are.
#[derive(Debug, Clone)]
pub(super) struct KeptFiles<T> {
    /// `None` until they are known; where nobody can say, why.
    files: Result<Option<Vec<Kept<T>>>, String>,
    list: ListView,
    /// The ticket of a file that is on its way.
    loading: Option<u64>,
    /// What came of the last request.
    pub(super) notice: Option<String>,
}

impl<T> Default for KeptFiles<T> {
    fn default() -> Self {
        Self {
            files: Ok(None),
            list: ListView::default(),
            loading: None,
            notice: None,
        }
    }
}

impl<T> KeptFiles<T> {
    /// All that are known.
    pub(super) fn known(&self) -> &[Kept<T>] {
        match &self.files {
            Ok(Some(files)) => files,
            _ => &[],
        }
    }

    /// The chosen one.
    pub(super) fn chosen(&self) -> Option<&Kept<T>> {
        self.known().get(self.list.chosen(self.known().len()))
    }

    /// What the chosen one holds, if it can be read.
    pub(super) fn content(&self) -> Option<&T> {
        self.chosen()?.content.as_deref().ok()
    }

    /// Takes in the files there are, or why nobody can say.
    pub(super) fn listed(&mut self, files: Result<Vec<Kept<T>>, String>) {
        self.files = files.map(Some);
    }

    /// Takes in what came of removing one; the list is to be asked for again.
    pub(super) fn removed(&mut self, result: &Result<(), String>) {
        let reason = result.as_ref().err();
        self.notice = reason.map(|reason| format!("It cannot be removed: {reason}."));
    }

    /// Notes that the chosen one was asked for with a ticket.
    pub(super) fn load(&mut self, ticket: u64) {
        self.loading = Some(ticket);
    }

    /// Whether an answer is the file that was asked for last.
    pub(super) fn take_loaded(&mut self, ticket: u64) -> bool {
        self.loading.take_if(|it| *it == ticket).is_some()
    }

    /// The keys of the list; `open` is what opening a file is called.
    pub(super) fn keys(&self, open: &'static str) -> KeyTable<KeptAction> {
        let mut list = ListView::keys(open);
        if self.content().is_none() {
            list = list.without_keys(&[Key::Enter, Key::Char(' ')]);
        }
        if self.chosen().is_none() {
            return KeyTable::new("list");
        }
        KeyTable::new("list")
            .with(list, KeptAction::List)
            .on(Key::Char('d'), KeptAction::Remove, "remove")
            .or([(Key::Delete, KeptAction::Remove)])
    }

    /// Moves the mark; done once the chosen file is to be opened.
    pub(super) fn act(&mut self, action: ListAction) -> Outcome {
        self.notice = None;
        self.opened(|list, count| list.act(action, count))
    }

    /// The mouse, with the line that it points at.
    pub(super) fn mouse(&mut self, mouse: &Mouse, line: Option<usize>) -> Outcome {
        let line = line.filter(|line| *line < self.known().len());
        self.opened(|list, count| list.mouse(mouse, count, line))
    }

    fn opened(&mut self, act: impl FnOnce(&mut ListView, usize) -> Outcome<usize>) -> Outcome {
        let count = self.known().len();
        match act(&mut self.list, count) {
            Outcome::Ignored => Outcome::Ignored,
            Outcome::Done(_) if self.content().is_some() => Outcome::Done(()),
            _ => Outcome::Used,
        }
    }

    /// Asks whether the chosen one is to be removed; `what` it is: "game".
    pub(super) fn ask_to_remove(what: &str) -> Confirmation {
        Confirmation::new(
            format!("Remove this {what} for good?"),
            "remove it",
            "keep it",
        )
    }

    /// The first file that is shown in so many rows.
    pub(super) fn first_row(&self, rows: usize) -> usize {
        let count = self.known().len();
        ListView::first_shown(self.list.chosen(count), count, rows as u16)
    }

    /// Writes at most so many rows of the list, or why there is none: `what` the files
    /// are ("saved games"), and when one is `saved`.
    pub(super) fn write(
        &self,
        rows: usize,
        (what, saved): (&str, &str),
        title: impl Fn(&Kept<T>) -> String,
        lines: &mut Lines,
    ) {
        match &self.files {
            Ok(None) => lines.paragraph("Looking …", Role::Text),
            Err(reason) => {
                let message = format!("The {what} cannot be looked at: {reason}.");
                lines.paragraph(&message, Role::Warn);
            }
            Ok(Some(files)) if files.is_empty() => {
                lines.paragraph(&format!("There are none yet. {saved}"), Role::Text);
            }
            Ok(Some(files)) => {
                let chosen = self.list.chosen(files.len());
                let shown = files.iter().enumerate().skip(self.first_row(rows));
                for (i, kept) in shown.take(rows) {
                    let (mark, role) = match i == chosen {
                        true => (">", Role::Selected),
                        false => (" ", Role::Text),
                    };
                    let age = kept.age.map(text::ago).unwrap_or_default();
                    lines.pair(&format!("{mark} {}", title(kept)), &age, role, Role::Dim);
                }
            }
        }
        lines.gap();
    }

    /// Writes what is to be said of the chosen file: the notice, that it cannot be read,
    /// or what `about` says.
    pub(super) fn write_about(&self, lines: &mut Lines, about: impl FnOnce(&T, &mut Lines)) {
        if let Some(notice) = &self.notice {
            lines.paragraph(notice, Role::Warn);
            lines.gap();
        }
        match self.chosen().map(|kept| &kept.content) {
            Some(Ok(content)) => about(content, lines),
            Some(Err(reason)) => {
                lines.paragraph(&format!("It cannot be read. {reason}."), Role::Warn);
                lines.gap();
                lines.paragraph("The file is left as it is.", Role::Text);
            }
            None => {}
        }
    }
}
