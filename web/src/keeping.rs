//! The store, whose files the browser saves.
//!
//! Requests are carried out in memory. If one changes something, its answer is passed on only when
//! the browser has tried to save the files: the page asks which files have changed, writes them to
//! the browser's database in one transaction, and reports the result. If another tab has changed
//! files in the meantime, the page first passes those files to the store, and all unsaved changes
//! are then made again on top of them.
//!
//! Changes that the browser could not save stay here until it can save them. If the page opens
//! another carrom, they are passed to that one.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use carrom::messages::{FileKind, StoreAnswer, StoreCall, StoreReply, StoreRequest};
use carrom::quiz::concepts::Library;
use carrom::screens::KeptSettings;
use carrom::store::{FileBytes, Store};

/// The folder of a teacher's own files.
pub(crate) const OWN: &str = "own/";

/// The ticket of a change that the app did not request.
const NO_TICKET: u64 = 0;

/// Something that changes the store.
#[derive(Debug, Clone)]
pub(crate) enum Change {
    /// The app made a request.
    Asked(StoreCall),
    /// A `progress.db` was opened.
    Progress(Vec<u8>),
    /// A saved game or the round of a class was opened.
    File(FileKind, FileBytes),
    /// A teacher's own file was opened.
    Own(FileBytes),
}

/// A change that the browser has not saved yet.
struct Pending {
    change: Change,
    /// The answer to pass on once the change is saved.
    answer: StoreAnswer,
    /// Whether the app has been notified that the browser could not save the change.
    is_refused: bool,
}

/// The store, and its unsaved changes.
pub(crate) struct PageStorage {
    store: Store,
    /// Whether the browser's files have been received.
    begun: bool,
    /// Requests made before the browser's files were received.
    early: Vec<StoreCall>,
    /// Unsaved changes, in the order in which they were made.
    pending: Vec<Pending>,
    /// How many of the unsaved changes are in the files that the browser is currently saving.
    under_way: usize,
    /// A teacher's own files, and the settings.
    own: Vec<FileBytes>,
    /// The files that the browser has saved, by path.
    safe: BTreeMap<String, Vec<u8>>,
    /// The files that the browser will have once the current save succeeds, by path.
    given: BTreeMap<String, Vec<u8>>,
}

/// Files to write, and paths of files to remove.
pub(crate) type ChangedFiles = (Vec<FileBytes>, Vec<String>);

impl PageStorage {
    /// A store that waits for the browser's files; if `simulated`, a store that begins without
    /// files.
    pub(crate) fn new(own: &Arc<Library>, simulated: bool) -> Self {
        let store = Store::in_memory().with_own(own);
        Self {
            store: if simulated { store.timeless() } else { store },
            begun: simulated,
            early: Vec::new(),
            pending: Vec::new(),
            under_way: 0,
            own: Vec::new(),
            safe: BTreeMap::new(),
            given: BTreeMap::new(),
        }
    }

    /// Takes over the unsaved changes of the previous carrom. These changes are made once the files
    /// have been received.
    pub(crate) fn taking_over(mut self, left: Vec<Change>) -> Self {
        self.pending = left.into_iter().map(Pending::unasked).collect();
        self
    }

    /// The unsaved changes, for the next carrom. They get new tickets, so that nothing that the
    /// next carrom saves replaces what this carrom saved.
    pub(crate) fn left(self) -> Vec<Change> {
        let mut tickets = BTreeMap::new();
        let mut left: Vec<_> = self.pending.into_iter().map(|it| it.change).collect();
        for change in &mut left {
            if let Change::Asked(call) = change {
                let next = u64::MAX - tickets.len() as u64;
                call.ticket = *tickets.entry(call.ticket).or_insert(next);
            }
        }
        left
    }

    pub(crate) fn store(&mut self) -> &mut Store {
        &mut self.store
    }

    /// Carries out a request; returns the answer if it can be given at once.
    pub(crate) fn ask(&mut self, call: &StoreCall) -> Option<StoreAnswer> {
        if !self.begun {
            self.early.push(call.clone());
            return None;
        }
        let answer = self.answer(call);
        if !changes(&call.request) {
            return Some(answer);
        }
        self.pending.push(Pending {
            change: Change::Asked(call.clone()),
            answer,
            is_refused: false,
        });
        None
    }

    /// Adds a file that was opened.
    ///
    /// # Errors
    /// The error in the file, in words; in that case nothing has changed.
    pub(crate) fn take_in(&mut self, change: Change) -> Result<(), String> {
        self.make(&change)?;
        self.pending.push(Pending::unasked(change));
        Ok(())
    }

    /// Makes a change in memory.
    fn make(&mut self, change: &Change) -> Result<(), String> {
        match change {
            Change::Asked(call) => drop(self.answer(call)),
            Change::Progress(bytes) => self.store.take_in_progress(bytes)?,
            Change::File(kind, file) => self.store.take_in(*kind, file)?,
            Change::Own(file) => self.put_own(file.clone()),
        }
        Ok(())
    }

    fn answer(&mut self, call: &StoreCall) -> StoreAnswer {
        if let StoreRequest::KeepSettings(text) = &call.request {
            self.put_own((KeptSettings::FILE.into(), text.as_bytes().to_vec()));
        }
        self.store.answer(call)
    }

    fn put_own(&mut self, file: FileBytes) {
        self.own.retain(|(known, _)| *known != file.0);
        self.own.push(file);
    }

    /// Whether there are changes that the page has not yet asked the browser to save.
    pub(crate) fn is_to_keep(&self) -> bool {
        let mut next = self.pending.iter().skip(self.under_way);
        next.any(|it| !it.is_refused)
    }

    /// The tickets of the unsaved changes, without those that the browser has failed to save.
    pub(crate) fn tickets(&self) -> Vec<u64> {
        let waits = self.pending.iter().filter(|it| !it.is_refused);
        waits.map(|it| it.answer.ticket).collect()
    }

    /// The number of things that the browser could not save so far. Each game, each round and the
    /// settings count as one thing, however often saving them failed.
    pub(crate) fn unsaved(&self) -> usize {
        let mut saved = BTreeSet::new();
        let mut is_another = |change: &Change| match change {
            Change::Asked(call) => match &call.request {
                StoreRequest::Retry => false,
                StoreRequest::KeepSettings(_) => saved.insert(NO_TICKET),
                StoreRequest::Save(_) | StoreRequest::NoteClass { .. } => saved.insert(call.ticket),
                _ => true,
            },
            _ => true,
        };
        let refused = self.pending.iter().filter(|it| it.is_refused);
        refused.filter(|it| is_another(&it.change)).count()
    }

    /// Receives the browser's files, at the beginning and when another tab has changed them;
    /// returns the answers to earlier requests.
    pub(crate) fn take_files(&mut self, files: &[FileBytes]) -> Vec<StoreAnswer> {
        self.store.renew(files);
        let is_own = |path: &str| path.starts_with(OWN) || path == KeptSettings::FILE;
        let own = files.iter().filter(|(path, _)| is_own(path));
        self.own = own.cloned().collect();
        self.safe = files.iter().cloned().collect();
        let pending = std::mem::take(&mut self.pending);
        for it in &pending {
            // The change was valid when it was first made.
            let _ = self.make(&it.change);
        }
        self.pending = pending;
        self.begun = true;
        let early = std::mem::take(&mut self.early);
        early.iter().filter_map(|call| self.ask(call)).collect()
    }

    /// The files that have changed since the browser last saved them.
    pub(crate) fn changes(&mut self) -> Result<ChangedFiles, String> {
        self.given = self.store.files()?.into_iter().collect();
        self.given.extend(self.own.iter().cloned());
        self.under_way = self.pending.len();
        let is_new = |(path, bytes): &(&String, &Vec<u8>)| self.safe.get(*path) != Some(*bytes);
        let put = self.given.iter().filter(is_new);
        let put = put.map(|(path, bytes)| (path.clone(), bytes.clone()));
        let gone = self.safe.keys().cloned();
        let gone = gone.filter(|path| !self.given.contains_key(path));
        Ok((put.collect(), gone.collect()))
    }

    /// Receives the result of a save, with the reason if it failed; returns the answers. Changes
    /// that could not be saved stay in memory, and the next save includes them.
    pub(crate) fn kept(&mut self, failed: Option<&str>) -> Vec<StoreAnswer> {
        let under_way = std::mem::take(&mut self.under_way);
        let Some(reason) = failed else {
            self.safe = std::mem::take(&mut self.given);
            let safe = self.pending.drain(..under_way);
            // This includes changes that could not be saved before: now they are saved.
            return safe.map(|it| it.answer).collect();
        };
        // With 0, nothing was being saved: the browser saves nothing at all, or there was an error
        // before the save began.
        let tried = match under_way {
            0 => self.pending.len(),
            under_way => under_way,
        };
        let mut refused = Vec::new();
        for it in &mut self.pending[..tried] {
            if !std::mem::replace(&mut it.is_refused, true) {
                refused.push(it.refused(reason));
            }
        }
        // After a failed retry the app requests another.
        self.pending.retain(|it| !(it.is_refused && it.is_retry()));
        let unsaved = self.unsaved();
        for answer in &mut refused {
            answer.unsaved = unsaved;
        }
        refused
    }
}

impl Pending {
    /// A change whose answer nobody waits for.
    fn unasked(change: Change) -> Self {
        Self {
            change,
            answer: StoreAnswer {
                ticket: NO_TICKET,
                done: StoreReply::Noted(Ok(())),
                unsaved: 0,
                notice: None,
            },
            is_refused: false,
        }
    }

    fn refused(&self, reason: &str) -> StoreAnswer {
        match &self.change {
            Change::Asked(call) => Store::refused(call, reason),
            _ => StoreAnswer {
                done: StoreReply::Noted(Err(reason.to_owned())),
                ..self.answer.clone()
            },
        }
    }

    fn is_retry(&self) -> bool {
        matches!(&self.change, Change::Asked(call) if call.request == StoreRequest::Retry)
    }
}

/// Whether a request changes anything that is saved.
fn changes(request: &StoreRequest) -> bool {
    use StoreRequest as R;
    match request {
        R::Save(_)
        | R::NoteClass { .. }
        | R::Remove(..)
        | R::Note(_)
        | R::KeepSettings(_)
        | R::Retry => true,
        R::List(_)
        | R::Load(..)
        | R::Export(_)
        | R::KeepHandIn(_)
        | R::Gather(_)
        | R::Recall(_)
        | R::Notebook(_)
        | R::Stars(_)
        | R::Players
        | R::Today
        | R::Marks(_) => false,
    }
}

#[cfg(test)]
mod tests {
    use carrom::class::ClassRound;
    use carrom::levels::Starred;
    use carrom::messages::{FileContent, PlayerAction};

    use super::*;

    const ROUND: &[u8] = include_bytes!("../../tests/saves/class-3.toml");

    /// A browser's files, and the page that uses them.
    struct Browser {
        keeping: PageStorage,
        files: BTreeMap<String, Vec<u8>>,
    }

    impl Browser {
        fn new() -> Self {
            let mut browser = Self {
                keeping: PageStorage::new(&Arc::default(), false),
                files: BTreeMap::new(),
            };
            browser.hand_over();
            browser
        }

        /// Passes the browser's files to carrom.
        fn hand_over(&mut self) {
            let files: Vec<_> = self.files.clone().into_iter().collect();
            self.keeping.take_files(&files);
        }

        /// Makes a request and tries to save the result at once.
        fn ask(
            &mut self,
            ticket: u64,
            request: StoreRequest,
            failed: Option<&str>,
        ) -> Vec<StoreAnswer> {
            assert_eq!(self.keeping.ask(&StoreCall { ticket, request }), None);
            self.keep(failed)
        }

        fn keep(&mut self, failed: Option<&str>) -> Vec<StoreAnswer> {
            assert!(self.keeping.is_to_keep());
            let (put, gone) = self.keeping.changes().unwrap();
            if failed.is_none() {
                self.files.extend(put);
                self.files.retain(|path, _| !gone.contains(path));
            }
            let answers = self.keeping.kept(failed);
            assert!(
                !self.keeping.is_to_keep(),
                "it would be tried again without a pause"
            );
            answers
        }

        /// The levels won, according to the files.
        fn won(&self) -> Vec<String> {
            let files: Vec<_> = self.files.clone().into_iter().collect();
            let request = StoreRequest::Stars("Ada".into());
            let mut store = Store::in_memory();
            store.renew(&files);
            let answer = store.answer(&StoreCall { ticket: 1, request });
            let StoreReply::Stars(Ok(stars)) = answer.done else {
                panic!("{answer:?}");
            };
            stars.into_iter().map(|it| it.level).collect()
        }
    }

    fn star(level: &str) -> StoreRequest {
        let starred = Starred {
            pack: "first".into(),
            level: level.into(),
            stars: 1,
        };
        StoreRequest::Note(PlayerAction::Star("Ada".into(), starred))
    }

    fn save_class() -> StoreRequest {
        let round = ClassRound::read("class-3.toml", ROUND, &Arc::default()).unwrap();
        StoreRequest::Save(FileContent::Class(Arc::new(round)))
    }

    #[test]
    fn unsaved_changes_are_retried_until_saved_and_then_reported_as_saved() {
        let mut browser = Browser::new();
        let refused = browser.ask(1, star("one"), Some("full"));
        assert_eq!(refused.len(), 1);
        assert_eq!(refused[0].done, StoreReply::Noted(Err("full".into())));
        assert_eq!(refused[0].unsaved, 1);
        // A round whose saving failed twice counts as one thing.
        browser.ask(2, save_class(), Some("full"));
        let refused = browser.ask(2, save_class(), Some("full"));
        assert_eq!(refused[0].done, StoreReply::Saved(Err("full".into())));
        assert_eq!((refused.len(), refused[0].unsaved), (1, 2));
        for ticket in 3..9 {
            let refused = browser.ask(ticket, StoreRequest::Retry, Some("full"));
            assert_eq!((refused.len(), refused[0].ticket), (1, ticket));
            assert_eq!(refused[0].unsaved, 2);
        }
        let safe = browser.ask(9, StoreRequest::Retry, None);
        let tickets: Vec<_> = safe.iter().map(|it| it.ticket).collect();
        assert_eq!(tickets, [1, 2, 2, 9]);
        assert!(safe.iter().all(|it| it.unsaved == 0), "{safe:?}");
        assert_eq!(safe[2].done, StoreReply::Saved(Ok(())));
        assert_eq!(browser.won(), ["one"]);
        assert_eq!(browser.keeping.unsaved(), 0);
    }

    #[test]
    fn unsaved_changes_are_not_lost_when_another_carrom_is_opened() {
        let mut browser = Browser::new();
        browser.ask(1, star("one"), None);
        browser.ask(2, star("two"), Some("full"));
        browser.ask(3, save_class(), Some("full"));
        browser.ask(
            4,
            StoreRequest::KeepSettings("theme = 1".into()),
            Some("full"),
        );
        for _ in 0..2 {
            let left = std::mem::replace(
                &mut browser.keeping,
                PageStorage::new(&Arc::default(), false),
            );
            browser.keeping = PageStorage::new(&Arc::default(), false).taking_over(left.left());
            browser.hand_over();
            let refused = browser.keep(Some("full"));
            assert!(refused.iter().all(|it| it.unsaved == 3), "{refused:?}");
        }
        // The next carrom saves another round beside the first, although the ticket is the same.
        browser.ask(3, save_class(), None);
        assert_eq!(browser.won(), ["one", "two"]);
        let rounds = browser.files.keys().filter(|it| it.starts_with("classes/"));
        assert_eq!(rounds.count(), 2);
        assert_eq!(browser.files[KeptSettings::FILE], b"theme = 1");
    }

    #[test]
    fn an_opened_file_that_could_not_be_saved_is_saved_later() {
        let mut other = Browser::new();
        other.ask(1, star("elsewhere"), None);
        let progress = other.files.remove("progress.db").unwrap();
        let mut browser = Browser::new();
        let level = ("own/levels/own/mine.toml".to_owned(), b"mine".to_vec());
        let round = ("class-9.toml".to_owned(), ROUND.to_vec());
        for change in [
            Change::Progress(progress),
            Change::Own(level.clone()),
            Change::File(FileKind::Class, round),
        ] {
            browser.keeping.take_in(change).unwrap();
        }
        let refused = browser.keep(Some("full"));
        assert!(refused.iter().all(|it| it.unsaved == 3), "{refused:?}");
        // Another tab saves something in the meantime.
        let mut tab = Browser::new();
        tab.ask(1, star("in another tab"), None);
        browser.files = tab.files;
        browser.hand_over();
        browser.ask(1, StoreRequest::Retry, None);
        assert_eq!(browser.won(), ["elsewhere", "in another tab"]);
        assert_eq!(browser.files[&level.0], level.1);
        assert!(browser.files.keys().any(|it| it.starts_with("classes/")));
    }

    #[test]
    fn an_error_before_saving_refuses_all_pending_changes() {
        let mut browser = Browser::new();
        assert_eq!(browser.keeping.tickets(), [0; 0]);
        for ticket in 1..=3 {
            let request = star(&ticket.to_string());
            browser.keeping.ask(&StoreCall { ticket, request });
        }
        assert_eq!(browser.keeping.tickets(), [1, 2, 3]);
        let refused = browser.keeping.kept(Some("a fault"));
        let reply: Vec<_> = refused.iter().map(|it| (it.ticket, it.unsaved)).collect();
        assert_eq!(reply, [(1, 3), (2, 3), (3, 3)]);
        assert!(!browser.keeping.is_to_keep());
        browser.ask(4, StoreRequest::Retry, None);
        assert_eq!(browser.won(), ["1", "2", "3"]);
    }
}
