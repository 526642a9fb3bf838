//! The store, whose files the browser keeps.
//!
//! What is asked is done at once in memory. An answer is handed on only when the browser has
//! the files safe: it asks which have changed, puts them into its database in one
//! transaction, and says how that went. Another tab may have changed them meanwhile; then
//! the browser hands them over first, and what is not yet safe is done once more upon them.
//!
//! What the browser could not keep stays here until it can, also when the page opens another
//! carrom: it is handed on to that one.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use carrom::messages::{StoreAnswer, StoreCall, StoreReply, StoreRequest};
use carrom::quiz::concepts::Library;
use carrom::screens::KeptSettings;
use carrom::store::{FileBytes, Store};

/// The folder of a teacher's own files.
pub(crate) const OWN: &str = "own/";

/// The ticket of what no request of the app's asked for.
const NO_TICKET: u64 = 0;

/// Something that changes the store.
#[derive(Debug, Clone)]
pub(crate) enum Change {
    /// A request of the app's.
    Asked(StoreCall),
    /// A `progress.db` was opened.
    Progress(Vec<u8>),
    /// A saved game was opened.
    Game(FileBytes),
    /// The round of a class was opened.
    Class(FileBytes),
    /// A file of a teacher's own was opened.
    Own(FileBytes),
}

/// A change that the browser has not yet kept.
struct Pending {
    change: Change,
    /// What is told once it is safe.
    answer: StoreAnswer,
    /// Whether it was told that the browser could not keep it.
    is_refused: bool,
}

/// The store and what is not yet safe of it.
pub(crate) struct PageStorage {
    store: Store,
    /// Whether the files that were there before are known.
    begun: bool,
    /// What was asked before that.
    early: Vec<StoreCall>,
    /// What was done and is not yet safe, in its order.
    pending: Vec<Pending>,
    /// How many of them stand in the files that are being kept just now.
    under_way: usize,
    /// A teacher's own files, and the settings.
    own: Vec<FileBytes>,
    /// What the browser has, by path.
    safe: BTreeMap<String, Vec<u8>>,
    /// What it is to have once it has kept the files it was given.
    given: BTreeMap<String, Vec<u8>>,
}

/// Files to be put, and paths of those to be removed.
pub(crate) type ChangedFiles = (Vec<FileBytes>, Vec<String>);

impl PageStorage {
    /// A store that waits for its files, or without a browser one that has none.
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

    /// Takes over what a carrom that is left could not have kept. It is done once its files
    /// are known.
    pub(crate) fn taking_over(mut self, left: Vec<Change>) -> Self {
        self.pending = left.into_iter().map(Pending::unasked).collect();
        self
    }

    /// What is not yet safe, for the carrom that comes next. Its tickets are no longer those of
    /// an app, so that nothing the next one saves takes the place of what this one saved.
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

    /// The store.
    pub(crate) fn store(&mut self) -> &mut Store {
        &mut self.store
    }

    /// Does what is asked; the answer, if it can be given at once.
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

    /// Takes in a file that was opened.
    ///
    /// # Errors
    /// What is wrong with it, in words; then nothing has changed.
    pub(crate) fn take_in(&mut self, change: Change) -> Result<(), String> {
        self.make(&change)?;
        self.pending.push(Pending::unasked(change));
        Ok(())
    }

    /// Makes a change to what is in memory.
    fn make(&mut self, change: &Change) -> Result<(), String> {
        match change {
            Change::Asked(call) => drop(self.answer(call)),
            Change::Progress(bytes) => self.store.take_in_progress(bytes)?,
            Change::Game((name, bytes)) => self.store.take_in_game(name, bytes)?,
            Change::Class((name, bytes)) => self.store.take_in_class(name, bytes)?,
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

    /// Whether something is to be kept that the browser has not been asked to keep before.
    pub(crate) fn is_to_keep(&self) -> bool {
        let mut next = self.pending.iter().skip(self.under_way);
        next.any(|it| !it.is_refused)
    }

    /// The tickets of what is not yet safe.
    pub(crate) fn tickets(&self) -> Vec<u64> {
        let waits = self.pending.iter().filter(|it| !it.is_refused);
        waits.map(|it| it.answer.ticket).collect()
    }

    /// How many things the browser could not keep so far. Something that was saved again and
    /// again is one.
    pub(crate) fn unsaved(&self) -> usize {
        let mut saved = BTreeSet::new();
        let mut is_another = |change: &Change| match change {
            Change::Asked(call) => match &call.request {
                StoreRequest::Retry => false,
                StoreRequest::KeepSettings(_) => saved.insert(NO_TICKET),
                StoreRequest::Save(_)
                | StoreRequest::SaveClass(_)
                | StoreRequest::NoteClass { .. } => saved.insert(call.ticket),
                _ => true,
            },
            _ => true,
        };
        let refused = self.pending.iter().filter(|it| it.is_refused);
        refused.filter(|it| is_another(&it.change)).count()
    }

    /// Takes the files that the browser has, at the beginning and when another tab has
    /// changed them; gives the answers to what was asked before.
    pub(crate) fn take_files(&mut self, files: &[FileBytes]) -> Vec<StoreAnswer> {
        self.store.renew(files);
        let is_own = |path: &str| path.starts_with(OWN) || path == KeptSettings::FILE;
        let own = files.iter().filter(|(path, _)| is_own(path));
        self.own = own.cloned().collect();
        self.safe = files.iter().cloned().collect();
        let pending = std::mem::take(&mut self.pending);
        for it in &pending {
            // It was good when it was first made.
            let _ = self.make(&it.change);
        }
        self.pending = pending;
        self.begun = true;
        let early = std::mem::take(&mut self.early);
        early.iter().filter_map(|call| self.ask(call)).collect()
    }

    /// What has changed since the browser kept it.
    pub(crate) fn changes(&mut self) -> Result<ChangedFiles, String> {
        self.given = self.store.files()?.into_iter().collect();
        self.given.extend(self.own.iter().cloned());
        self.under_way = self.pending.len();
        let is_new = |(path, bytes): &(&String, &Vec<u8>)| self.safe.get(*path) != Some(*bytes);
        let put = self.given.iter().filter(is_new);
        let put = put.map(|(path, bytes)| (path.clone(), bytes.clone()));
        let gone = self
            .safe
            .keys()
            .filter(|path| !self.given.contains_key(*path));
        Ok((put.collect(), gone.cloned().collect()))
    }

    /// Takes that the browser has kept what it was given, or why not; gives the answers. What
    /// could not be kept stays in memory, and is kept with what comes next if it can be.
    pub(crate) fn kept(&mut self, failed: Option<&str>) -> Vec<StoreAnswer> {
        let under_way = std::mem::take(&mut self.under_way);
        let Some(reason) = failed else {
            self.safe = std::mem::take(&mut self.given);
            let safe = self.pending.drain(..under_way);
            // What was refused before is told as well: it is safe after all.
            return safe.map(|it| it.answer).collect();
        };
        // A browser that keeps nothing at all, or a fault, and nothing has been given.
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
        // A try in vain is followed by another.
        self.pending.retain(|it| !(it.is_refused && it.is_retry()));
        let unsaved = self.unsaved();
        for answer in &mut refused {
            answer.unsaved = unsaved;
        }
        refused
    }
}

impl Pending {
    /// A change that nobody waits for.
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
            Change::Asked(call) => call.refused(reason),
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

/// Whether a request changes anything that is kept.
fn changes(request: &StoreRequest) -> bool {
    use StoreRequest as R;
    match request {
        R::Save(_)
        | R::Remove(_)
        | R::SaveClass(_)
        | R::NoteClass { .. }
        | R::RemoveClass(_)
        | R::Record(_)
        | R::Star(..)
        | R::Mark { .. }
        | R::Forget(..)
        | R::KeepSettings(_)
        | R::Retry => true,
        R::List
        | R::Load(_)
        | R::Export(_)
        | R::ListClasses
        | R::LoadClass(_)
        | R::ExportClass(_)
        | R::KeepHandIn(_)
        | R::Recall(_)
        | R::Stars(_)
        | R::Players
        | R::Marks(_) => false,
    }
}

#[cfg(test)]
mod tests {
    use carrom::class::ClassRound;
    use carrom::levels::Starred;

    use super::*;

    const ROUND: &[u8] = include_bytes!("../../tests/saves/class-3.toml");

    /// A browser's files, and a carrom that has them.
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

        /// Hands its files to the carrom.
        fn hand_over(&mut self) {
            let files: Vec<_> = self.files.clone().into_iter().collect();
            self.keeping.take_files(&files);
        }

        /// Asks for something, which is tried to be kept at once.
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
                "it would be tried without a pause"
            );
            answers
        }

        /// The levels that are won, as the files have it.
        fn won(&self) -> Vec<String> {
            let files: Vec<_> = self.files.clone().into_iter().collect();
            let request = StoreRequest::Stars("Ada".into());
            let answer = Store::of_files(&files).answer(&StoreCall { ticket: 1, request });
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
        StoreRequest::Star("Ada".into(), starred)
    }

    fn save_class() -> StoreRequest {
        let round = ClassRound::read("class-3.toml", ROUND, &Arc::default()).unwrap();
        StoreRequest::SaveClass(Arc::new(round))
    }

    #[test]
    fn what_was_refused_is_owed_until_a_try_keeps_it_and_is_then_told_as_safe() {
        let mut browser = Browser::new();
        let refused = browser.ask(1, star("one"), Some("full"));
        assert_eq!(refused.len(), 1);
        assert_eq!(refused[0].done, StoreReply::Noted(Err("full".into())));
        assert_eq!(refused[0].unsaved, 1);
        // Saved twice in vain, it is one thing.
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
    fn what_could_not_be_kept_is_not_lost_when_another_carrom_is_opened() {
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
        // What the next one saves is another round, though its ticket is the same.
        browser.ask(3, save_class(), None);
        assert_eq!(browser.won(), ["one", "two"]);
        let rounds = browser.files.keys().filter(|it| it.starts_with("classes/"));
        assert_eq!(rounds.count(), 2);
        assert_eq!(browser.files[KeptSettings::FILE], b"theme = 1");
    }

    #[test]
    fn an_opened_file_that_could_not_be_kept_is_kept_later() {
        let mut other = Browser::new();
        other.ask(1, star("elsewhere"), None);
        let progress = other.files.remove("progress.db").unwrap();
        let mut browser = Browser::new();
        let level = ("own/levels/own/mine.toml".to_owned(), b"mine".to_vec());
        let round = ("class-9.toml".to_owned(), ROUND.to_vec());
        for change in [
            Change::Progress(progress),
            Change::Own(level.clone()),
            Change::Class(round),
        ] {
            browser.keeping.take_in(change).unwrap();
        }
        let refused = browser.keep(Some("full"));
        assert!(refused.iter().all(|it| it.unsaved == 3), "{refused:?}");
        // Another tab keeps something meanwhile.
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
    fn a_fault_before_anything_is_given_refuses_all_that_waits() {
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
