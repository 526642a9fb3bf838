//! A list of saved files, the newest first, each of which can be opened or deleted.

use strum::{EnumMessage, IntoStaticStr};

use super::{Confirmation, Context, Next};
use crate::messages::{FileKind, Kept, Key, StoreRequest};
use crate::widgets::input::{KeyTable, ListAction, ListView};
use crate::widgets::panel::Panel;
use crate::widgets::{Outcome, Role, text};

/// What the keys do on a list of saved files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum KeptAction {
    /// choose a file, or open it
    List(ListAction),
    /// delete the chosen file permanently
    Remove,
}

/// A kind of file, with its names.
#[derive(Debug, Clone, Copy)]
pub(super) struct KeptKind {
    pub(super) file: FileKind,
    /// The singular: "game".
    pub(super) one: &'static str,
    /// The plural: "saved games".
    pub(super) all: &'static str,
    /// A sentence that says when carrom saves files of this kind.
    pub(super) saved: &'static str,
}

/// The saved files of one kind.
#[derive(Debug, Clone)]
pub(super) struct KeptFiles<T> {
    kind: KeptKind,
    /// `None` until the list is loaded; an error if the files cannot be listed.
    files: Result<Option<Vec<Kept<T>>>, String>,
    list: ListView,
    /// The ticket of a file that is being loaded.
    loading: Option<u64>,
    /// The file that is deleted if the player agrees. The list may change in the meantime.
    removing: Option<String>,
    /// The result of the last request.
    pub(super) notice: Option<String>,
}

impl<T> KeptFiles<T> {
    /// Requests the files; the list is empty until they arrive.
    pub(super) fn ask(kind: KeptKind, cx: &mut Context) -> Self {
        cx.ask(StoreRequest::List(kind.file));
        Self {
            kind,
            files: Ok(None),
            list: ListView::default(),
            loading: None,
            removing: None,
            notice: None,
        }
    }

    fn known(&self) -> &[Kept<T>] {
        match &self.files {
            Ok(Some(files)) => files,
            _ => &[],
        }
    }

    pub(super) fn chosen(&self) -> Option<&Kept<T>> {
        self.known().get(self.list.chosen(self.known().len()))
    }

    /// The contents of the chosen file, if it can be read.
    pub(super) fn content(&self) -> Option<&T> {
        self.chosen()?.content.as_deref().ok()
    }

    /// Handles the list of files, or the reason why it cannot be loaded.
    pub(super) fn listed(&mut self, files: Result<Vec<Kept<T>>, String>) {
        self.files = files.map(Some);
    }

    /// Handles the result of deleting a file, and requests the list again.
    pub(super) fn removed(&mut self, result: &Result<(), String>, cx: &mut Context) {
        let reason = result.as_ref().err();
        let one = self.kind.one;
        self.notice = reason.map(|reason| format!("The {one} cannot be deleted: {reason}."));
        cx.ask(StoreRequest::List(self.kind.file));
    }

    /// Requests the chosen file; returns the ticket.
    pub(super) fn load(&mut self, cx: &mut Context) -> Option<u64> {
        let name = self.chosen()?.name.clone();
        self.loading = Some(cx.ask(StoreRequest::Load(self.kind.file, name)));
        self.loading
    }

    /// Whether the answer with this ticket is the file that was requested last.
    pub(super) fn take_loaded(&mut self, ticket: u64) -> bool {
        self.loading.take_if(|it| *it == ticket).is_some()
    }

    /// Requests the deletion to which the player has agreed.
    pub(super) fn remove(&mut self, cx: &mut Context) {
        if let Some(name) = self.removing.take() {
            cx.ask(StoreRequest::Remove(self.kind.file, name));
        }
    }

    /// The keys of the list; `open` is the label for opening a file.
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
            .on('d', KeptAction::Remove, "remove")
            .or([(Key::Delete, KeptAction::Remove)])
    }

    pub(super) fn act(&mut self, action: KeptAction, cx: &mut Context) -> Next {
        let KeptAction::List(action) = action else {
            self.removing = self.chosen().map(|kept| kept.name.clone());
            let text = format!("Delete this {} permanently?", self.kind.one);
            return Next::Confirm(Confirmation::new(text, "delete it", "keep it"));
        };
        self.notice = None;
        match self.list.act(action, self.known().len()) {
            Outcome::Ignored => return Next::Ignored,
            Outcome::Done(_) if self.content().is_some() => {
                self.load(cx);
            }
            _ => {}
        }
        Next::Stay
    }

    /// Moves through the list with the mouse wheel.
    pub(super) fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        self.act(KeptAction::List(ListAction::Choose(by.into())), cx)
    }

    /// Writes the list, or the reason why it cannot be loaded.
    pub(super) fn write_list(
        &self,
        title: impl Fn(&Kept<T>) -> String,
        panel: &mut Panel<KeptAction>,
    ) {
        let KeptKind { all, saved, .. } = self.kind;
        match &self.files {
            Ok(None) => panel.paragraph("Loading …", Role::Text),
            Err(reason) => {
                let message = format!("The {all} cannot be listed: {reason}.");
                panel.paragraph(message, Role::Warn);
            }
            Ok(Some(files)) if files.is_empty() => {
                panel.paragraph(format!("There are none yet. {saved}"), Role::Text);
            }
            Ok(Some(files)) => {
                let chosen = self.list.chosen(files.len());
                for (i, kept) in files.iter().enumerate() {
                    let age = kept.age.map(text::ago).unwrap_or_default();
                    let action = KeptAction::List(ListAction::Point(i));
                    let name = (title(kept), Role::Text);
                    panel.row(name, (age, Role::Dim), i == chosen, action);
                }
            }
        }
    }

    /// Writes the notice, if there is one, then the text of `about` or why the chosen file cannot
    /// be read.
    pub(super) fn write_chosen<A>(
        &self,
        panel: &mut Panel<A>,
        about: impl FnOnce(&T, &mut Panel<A>),
    ) {
        if let Some(notice) = &self.notice {
            panel.paragraph(notice, Role::Warn);
            panel.gap();
        }
        match self.chosen().map(|kept| &kept.content) {
            Some(Ok(content)) => about(content, panel),
            Some(Err(reason)) => {
                panel.paragraph(format!("This file cannot be read. {reason}."), Role::Warn);
                panel.gap();
                panel.paragraph("It is left unchanged.", Role::Text);
            }
            None => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::messages::Effect;
    use crate::screens::Settings;

    #[test]
    fn the_file_that_was_chosen_when_the_question_was_asked_is_deleted() {
        let kind = KeptKind {
            file: FileKind::Game,
            one: "game",
            all: "saved games",
            saved: "",
        };
        let kept = |name: &str| Kept {
            name: name.to_owned(),
            age: None,
            day: None,
            content: Ok(Box::new(())),
        };
        let mut cx = Context::new(Settings::default(), 1);
        let mut files = KeptFiles::ask(kind, &mut cx);
        files.listed(Ok(["first", "second", "third"].map(kept).into()));
        files.act(KeptAction::Remove, &mut cx);
        // The deletion of an earlier file ends while the question is open.
        files.listed(Ok(["second", "third"].map(kept).into()));
        files.remove(&mut cx);
        let removed = cx.take_asked().into_iter().find_map(|effect| match effect {
            Effect::Keep(call) => match call.request {
                StoreRequest::Remove(_, name) => Some(name),
                _ => None,
            },
            _ => None,
        });
        assert_eq!(removed.as_deref(), Some("first"));
    }
}
