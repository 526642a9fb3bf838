//! The store, whose files the browser keeps.
//!
//! What is asked is done at once in memory. An answer is handed on only when the browser has
//! the files safe: it asks which have changed, puts them into its database in one
//! transaction, and says how that went. Another tab may have changed them meanwhile; then
//! the browser hands them over first, and what is not yet safe is done once more upon them.

use std::collections::BTreeMap;
use std::sync::Arc;

use carrom::messages::{StoreAnswer, StoreCall, StoreRequest};
use carrom::quiz::concepts::Library;
use carrom::screens::KeptSettings;
use carrom::store::{FileBytes, Store};

/// The folder of a teacher's own files.
pub(crate) const OWN: &str = "own/";

/// The store and what is not yet safe of it.
pub(crate) struct Keeping {
    store: Store,
    /// Whether the files that were there before are known.
    begun: bool,
    /// What was asked before that.
    early: Vec<StoreCall>,
    /// What was done, and is not yet safe.
    unsafe_yet: Vec<StoreCall>,
    /// Its answers that nobody has heard.
    waiting: Vec<StoreAnswer>,
    /// How many of them stand in the files that are being kept just now.
    under_way: usize,
    /// A teacher's own files, and the settings.
    own: Vec<FileBytes>,
    /// Whether a file was opened that is not kept yet.
    taken_in: bool,
    /// What the browser has, by path.
    safe: BTreeMap<String, Vec<u8>>,
    /// What it is to have once it has kept the files it was given.
    given: BTreeMap<String, Vec<u8>>,
}

/// Files to be put, and paths of those to be removed.
pub(crate) type Changes = (Vec<FileBytes>, Vec<String>);

impl Keeping {
    /// A store that waits for its files, or without a browser one that has none.
    pub(crate) fn new(own: &Arc<Library>, simulated: bool) -> Self {
        let store = Store::in_memory().with_own(own);
        Self {
            store: if simulated { store.timeless() } else { store },
            begun: simulated,
            early: Vec::new(),
            unsafe_yet: Vec::new(),
            waiting: Vec::new(),
            under_way: 0,
            own: Vec::new(),
            taken_in: false,
            safe: BTreeMap::new(),
            given: BTreeMap::new(),
        }
    }

    /// The store.
    pub(crate) fn store(&mut self) -> &mut Store {
        &mut self.store
    }

    /// Does what is asked; the answer, if it can be given at once.
    pub(crate) fn ask(&mut self, call: &StoreCall) -> Option<StoreAnswer> {
        if let StoreRequest::KeepSettings(text) = &call.wish {
            self.add_own(KeptSettings::FILE.into(), text.as_bytes());
        }
        if !self.begun {
            self.early.push(call.clone());
            return None;
        }
        let answer = self.store.answer(call);
        if !changes(&call.wish) {
            return Some(answer);
        }
        self.unsafe_yet.push(call.clone());
        self.waiting.push(answer);
        None
    }

    /// Does what a talk in lines asks, which goes on at once.
    pub(crate) fn do_at_once(&mut self, call: &StoreCall) -> StoreAnswer {
        let answer = self.store.answer(call);
        if changes(&call.wish) {
            self.unsafe_yet.push(call.clone());
            self.waiting.push(answer.clone());
        }
        answer
    }

    /// Adds what was done elsewhere, in the bytes of a `progress.db`.
    pub(crate) fn take_in_progress(&mut self, bytes: &[u8]) -> Result<(), String> {
        self.store.take_in_progress(bytes)?;
        self.taken_in = true;
        Ok(())
    }

    /// Adds the saved game of a file.
    pub(crate) fn take_in_game(&mut self, name: &str, bytes: &[u8]) -> Result<(), String> {
        self.store.take_in_game(name, bytes)?;
        self.taken_in = true;
        Ok(())
    }

    /// Adds the round of a class of a file.
    pub(crate) fn take_in_class(&mut self, name: &str, bytes: &[u8]) -> Result<(), String> {
        self.store.take_in_class(name, bytes)?;
        self.taken_in = true;
        Ok(())
    }

    /// Adds a file of a teacher's own, to be there from the next time on.
    pub(crate) fn add_own(&mut self, path: String, bytes: &[u8]) {
        self.own.retain(|(known, _)| *known != path);
        self.own.push((path, bytes.to_vec()));
        self.taken_in = true;
    }

    /// Whether something is to be kept.
    pub(crate) fn is_to_keep(&self) -> bool {
        self.waiting.len() > self.under_way || self.taken_in
    }

    /// The tickets of what is not yet safe.
    pub(crate) fn tickets(&self) -> Vec<u64> {
        self.waiting.iter().map(|answer| answer.ticket).collect()
    }

    /// Takes the files that the browser has, at the beginning and when another tab has
    /// changed them; gives the answers to what was asked before.
    pub(crate) fn take_files(&mut self, files: &[FileBytes]) -> Vec<StoreAnswer> {
        self.store.renew(files);
        let is_own = |path: &str| path.starts_with(OWN) || path == KeptSettings::FILE;
        let own = files.iter().filter(|(path, _)| is_own(path));
        if !self.taken_in {
            self.own = own.cloned().collect();
        }
        self.safe = files.iter().cloned().collect();
        for call in &self.unsafe_yet {
            self.store.answer(call);
        }
        self.begun = true;
        let early = std::mem::take(&mut self.early);
        early.iter().filter_map(|call| self.ask(call)).collect()
    }

    /// What has changed since the browser kept it.
    pub(crate) fn changes(&mut self) -> Result<Changes, String> {
        self.given = self.store.files()?.into_iter().collect();
        self.given.extend(self.own.iter().cloned());
        self.taken_in = false;
        self.under_way = self.waiting.len();
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
        let mut under_way = std::mem::take(&mut self.under_way);
        if failed.is_some() && under_way == 0 {
            // A browser that keeps nothing at all has not even been given it.
            under_way = self.waiting.len();
            self.taken_in = false;
        }
        let answers: Vec<_> = self.waiting.drain(..under_way).collect();
        match failed {
            None => {
                self.safe = std::mem::take(&mut self.given);
                let done = self.unsafe_yet.len() - self.waiting.len();
                self.unsafe_yet.drain(..done);
                answers
            }
            Some(reason) => {
                let first = self.unsafe_yet.len() - self.waiting.len() - under_way;
                let owed = self.unsafe_yet.iter().filter(|call| is_owed(&call.wish));
                let owed = owed.count();
                let calls = &self.unsafe_yet[first..first + under_way];
                let refused = calls.iter().map(|call| StoreAnswer {
                    owed,
                    ..call.refused(reason)
                });
                refused.collect()
            }
        }
    }
}

/// Whether a request is for something done that the player is told of until it is kept.
fn is_owed(wish: &StoreRequest) -> bool {
    use StoreRequest as R;
    matches!(
        wish,
        R::Record(_) | R::Star(..) | R::Mark { .. } | R::Forget(..)
    )
}

/// Whether a request changes anything that is kept.
fn changes(wish: &StoreRequest) -> bool {
    use StoreRequest as R;
    match wish {
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
        | R::Marks(_) => false,
    }
}
