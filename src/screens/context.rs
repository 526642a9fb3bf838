//! What all screens share: settings, the seed, the room there is to draw in.

use std::sync::Arc;

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use ratatui::layout::Rect;

use super::lab::LabSettings;
use super::place::Place;
use super::settings::{KeptSettings, Settings};
use crate::lessons::{Book, Bookmark, Forget};
use crate::levels::{Shelf, Win};
use crate::messages::{Effect, HostCall, JoinCall, StoreCall, StoreRequest};
use crate::progress::Attempt;
use crate::quiz::concepts::Library;
use crate::widgets::{PictureSizes, Room};

/// Shared state, lent to a screen for the length of a call.
#[derive(Debug, Clone)]
pub struct Context {
    /// How things look and behave.
    pub settings: Settings,
    /// The part of the screen that belongs to the screen on top: all but the
    /// title line and the line of keys.
    pub body: Rect,
    /// How large pictures are in it, where that does not follow from its size.
    pub pictures: Option<PictureSizes>,
    /// The levels.
    pub shelf: Shelf,
    /// The chapters.
    pub book: Book,
    /// Written questions of a teacher's own.
    pub own: Arc<Library>,
    /// The class that was left, to come back to.
    pub(in crate::screens) class: Option<Place>,
    /// How the lab was left.
    pub(in crate::screens) lab: Option<LabSettings>,
    /// The folder where all is kept, in words; `None` where nothing is.
    pub folder: Option<String>,
    /// What is kept of the settings; `None` where that cannot be read, and is left alone.
    pub kept: Option<KeptSettings>,
    seed: u64,
    rounds: u64,
    tickets: u64,
    asked: Vec<Effect>,
    told: Option<String>,
}

impl Context {
    /// A context whose every random choice follows from `seed`.
    pub fn new(settings: Settings, seed: u64) -> Self {
        Self {
            settings,
            body: Rect::default(),
            pictures: None,
            shelf: Shelf::default(),
            book: Book::default(),
            own: Arc::default(),
            class: None,
            lab: None,
            folder: None,
            kept: Some(KeptSettings::default()),
            seed,
            rounds: 0,
            tickets: 0,
            asked: Vec::new(),
            told: None,
        }
    }

    /// The place of the screen on top, for what has pictures.
    pub fn room(&self) -> Room {
        Room {
            area: self.body,
            pictures: self.pictures,
        }
    }

    /// Asks for something to be done with what is kept. The
    /// [`StoreAnswer`](crate::messages::StoreAnswer) will bear the ticket, which for a game
    /// that is saved again and again is always the same.
    pub fn keep(&mut self, ticket: u64, wish: StoreRequest) {
        self.asked.push(Effect::Keep(StoreCall { ticket, wish }));
    }

    /// The same with a ticket of its own, which it gives.
    pub fn ask(&mut self, wish: StoreRequest) -> u64 {
        let ticket = self.ticket();
        self.keep(ticket, wish);
        ticket
    }

    /// Notes that a level was won, and has that kept.
    pub fn won(&mut self, number: usize, win: Win) {
        if let Some(starred) = self.shelf.won(number, win) {
            self.ask(StoreRequest::Star(self.settings.player.clone(), starred));
        }
    }

    /// Has what was changed of the settings since `before` kept.
    pub fn keep_settings(&mut self, before: &Settings) {
        if let Some(kept) = &mut self.kept
            && kept.note(before, &self.settings)
        {
            let text = kept.text();
            self.ask(StoreRequest::KeepSettings(text));
        }
    }

    /// Lets someone else play: what is known of the one before is forgotten here.
    pub fn change_player(&mut self, name: String) {
        if name != self.settings.player {
            self.settings.player = name;
            self.settings.foretold = 0;
            self.book.close();
            self.shelf.forget();
        }
    }

    /// Asks how far the chapters have been read, unless that is known.
    pub fn ask_for_marks(&mut self) {
        if !self.book.is_known() {
            self.ask(StoreRequest::Marks(self.settings.player.clone()));
        }
    }

    /// Notes what was done in the chapter of this id, and has that kept.
    pub fn mark(&mut self, chapter: &str, later: Bookmark) {
        self.book.merge(chapter, later.clone());
        self.ask(StoreRequest::Mark {
            player: self.settings.player.clone(),
            chapter: chapter.to_owned(),
            later: Box::new(later),
        });
    }

    /// Forgets what was done in chapters, here and where it is kept.
    pub fn forget(&mut self, what: Forget) {
        self.book.forget(&what);
        self.ask(StoreRequest::Forget(self.settings.player.clone(), what));
    }

    /// A ticket that no request has had.
    pub fn ticket(&mut self) -> u64 {
        self.tickets += 1;
        self.tickets
    }

    /// Has an answer kept, before anything that follows from it is seen.
    pub fn record(&mut self, attempt: Attempt) {
        self.ask(StoreRequest::Record(Box::new(attempt)));
    }

    /// Asks for a text to be written to a file of this name.
    pub fn export(&mut self, name: String, content: String) {
        self.asked.push(Effect::Export { name, content });
    }

    /// Asks something of whoever serves a class.
    pub fn host(&mut self, call: HostCall) {
        self.asked.push(Effect::Host(call));
    }

    /// Asks something of whoever reaches the host of a class.
    pub fn join(&mut self, call: JoinCall) {
        self.asked.push(Effect::Join(call));
    }

    /// Shows a notice over the screen until a key is pressed.
    pub fn tell(&mut self, words: String) {
        self.told = Some(words);
    }

    /// Tells the player where an export is, or why there is none; `what` is exported.
    pub fn tell_of_export(&mut self, what: &str, exported: &Result<String, String>) {
        self.tell(match exported {
            Ok(place) => format!("The {what} is in {place}"),
            Err(reason) => format!("The {what} could not be written: {reason}"),
        });
    }

    /// What the player is to be told.
    pub fn take_told(&mut self) -> Option<String> {
        self.told.take()
    }

    /// What the screens have asked of the shell since the last call.
    pub fn take_asked(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.asked)
    }

    /// The app's own seed.
    pub const fn seed(&self) -> u64 {
        self.seed
    }

    /// The seed of the next round: the app's own seed first, then others that
    /// follow from it.
    pub fn next_seed(&mut self) -> u64 {
        let seed = if self.rounds == 0 {
            self.seed
        } else {
            use rand::Rng;
            let mut generator = Pcg64Mcg::seed_from_u64(self.seed);
            (0..self.rounds).fold(0, |_, _| generator.next_u64()) % 1_000_000
        };
        self.rounds += 1;
        seed
    }
}
