//! The state that all screens share: settings, the seed, the area for drawing.

use std::sync::Arc;

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use ratatui::layout::Rect;

use super::lab::LabSettings;
use super::route::Route;
use super::settings::{KeptSettings, Settings};
use crate::lessons::{Book, Bookmark, Forget};
use crate::levels::{Shelf, Win};
use crate::messages::{Effect, History, HostCall, JoinCall, PlayerAction, StoreCall, StoreRequest};
use crate::path::PathSoFar;
use crate::progress::{Attempt, Observation, ObservationPlace};
use crate::quiz::concepts::Library;
use crate::quiz::{Code, Course, Rays};
use crate::widgets::{PictureSizes, Room};

/// Shared state, passed to a screen during a call.
#[derive(Debug, Clone, Default)]
pub struct Context {
    /// The appearance and behaviour of the app.
    pub settings: Settings,
    /// The area of the current screen: the whole window except the title line and the line of keys.
    pub body: Rect,
    /// The size of pictures, if it does not follow from the area.
    pub pictures: Option<PictureSizes>,
    /// The levels.
    pub shelf: Shelf,
    /// The chapters.
    pub book: Book,
    /// The teacher's own written questions.
    pub own: Arc<Library>,
    /// The class that the player left and can return to.
    pub(in crate::screens) class: Option<Route>,
    /// The settings of the lab when the player last left it.
    pub(in crate::screens) lab: Option<LabSettings>,
    /// The path of the data folder, as shown; `None` if nothing is saved.
    pub folder: Option<String>,
    /// The stored settings; `None` if they cannot be read and are therefore not overwritten.
    pub kept: Option<KeptSettings>,
    seed: u64,
    rounds: u64,
    tickets: u64,
    asked: Vec<Effect>,
    reported: Option<String>,
}

impl Context {
    /// A context whose random choices all follow from `seed`.
    pub fn new(settings: Settings, seed: u64) -> Self {
        Self {
            settings,
            kept: Some(KeptSettings::default()),
            seed,
            ..Self::default()
        }
    }

    /// What is known about the player, whose record is `history`.
    pub(super) fn so_far<'a>(&'a self, history: &'a History) -> PathSoFar<'a> {
        PathSoFar {
            attempts: &history.attempts,
            calendar: &history.calendar,
            book: &self.book,
            shelf: &self.shelf,
        }
    }

    /// The area of the current screen, with the size of pictures.
    pub fn room(&self) -> Room {
        Room {
            area: self.body,
            pictures: self.pictures,
        }
    }

    /// Sends a request to the store. The [`StoreAnswer`](crate::messages::StoreAnswer) carries the
    /// same ticket. A game that is saved repeatedly always uses the same ticket.
    pub fn keep(&mut self, ticket: u64, request: StoreRequest) {
        self.asked.push(Effect::Keep(StoreCall { ticket, request }));
    }

    /// Sends a request to the store with a new ticket, and returns the ticket.
    pub fn ask(&mut self, request: StoreRequest) -> u64 {
        let ticket = self.ticket();
        self.keep(ticket, request);
        ticket
    }

    /// Saves something that the player has done.
    pub fn note(&mut self, action: PlayerAction) {
        self.ask(StoreRequest::Note(action));
    }

    /// Records that a level was won, and saves the stars if there are more of them than before.
    pub fn won(&mut self, number: usize, win: Win) {
        if let Some(starred) = self.shelf.won(number, win) {
            let player = self.settings.player.clone();
            self.note(PlayerAction::Star(player, starred));
        }
    }

    /// Saves the settings that have changed since `before`.
    pub fn keep_settings(&mut self, before: &Settings) {
        if let Some(kept) = &mut self.kept
            && kept.note(before, &self.settings)
        {
            let text = kept.text();
            self.ask(StoreRequest::KeepSettings(text));
        }
    }

    /// Changes the player; the previous player's data is removed from memory.
    pub fn change_player(&mut self, name: String) {
        if name != self.settings.player {
            self.settings.player = name;
            self.settings.predicted = 0;
            self.settings.watched = 0;
            self.book.close();
            self.shelf.forget();
        }
    }

    /// Requests the bookmarks if they have not been loaded yet.
    pub fn ask_for_marks(&mut self) {
        if !self.book.is_known() {
            self.ask(StoreRequest::Marks(self.settings.player.clone()));
        }
    }

    /// Records what was done in the chapter with this id, and saves it.
    pub fn mark(&mut self, chapter: &str, later: Bookmark) {
        self.book.merge(chapter, later.clone());
        self.note(PlayerAction::Mark {
            player: self.settings.player.clone(),
            chapter: chapter.to_owned(),
            later: Box::new(later),
        });
    }

    /// Deletes the record of what was done in chapters, in memory and in the store.
    pub fn forget(&mut self, what: Forget) {
        self.book.forget(&what);
        self.note(PlayerAction::Forget(self.settings.player.clone(), what));
    }

    /// A ticket that no request has used yet.
    pub fn ticket(&mut self) -> u64 {
        self.tickets += 1;
        self.tickets
    }

    /// Saves an answer before anything that follows from it is shown.
    pub fn record(&mut self, attempt: Attempt) {
        self.note(PlayerAction::Record(Box::new(attempt)));
    }

    /// Saves what the player saw in a hit, and returns it.
    pub fn observe(&mut self, place: ObservationPlace, rays: [Rays; 3]) -> Observation {
        let [said, truth, seen] = rays;
        let observation = Observation {
            time_s: None,
            player: self.settings.player.clone(),
            place,
            said,
            truth,
            seen,
        };
        self.note(PlayerAction::Observe(Box::new(observation.clone())));
        observation
    }

    /// Requests that `content` be written to a file called `name`.
    pub fn export(&mut self, name: String, content: String) {
        self.asked.push(Effect::Export { name, content });
    }

    /// Requests that the page for browsers be written to a file with this name; if the code of a
    /// round is given, as a SCORM package.
    pub fn export_page(&mut self, name: String, round: Option<Code>) {
        self.asked.push(Effect::ExportPage { name, round });
    }

    /// Sends a request to the server of a class.
    pub fn host(&mut self, call: HostCall) {
        self.asked.push(Effect::Host(call));
    }

    /// Sends a request to the connection to a class's host.
    pub fn join(&mut self, call: JoinCall) {
        self.asked.push(Effect::Join(call));
    }

    /// Shows a notice over the screen until a key is pressed.
    pub fn notify(&mut self, words: String) {
        self.reported = Some(words);
    }

    /// Shows a notice that says where an export was saved, or why it could not be written; `what`
    /// is the name of the export.
    pub fn notify_of_export(&mut self, what: &str, exported: &Result<String, String>) {
        self.notify(match exported {
            Ok(place) => format!("The {what} is in {place}"),
            Err(reason) => format!("The {what} could not be written: {reason}"),
        });
    }

    /// The pending notice.
    pub fn take_notice(&mut self) -> Option<String> {
        self.reported.take()
    }

    /// The screens' requests to the shell since the last call.
    pub fn take_asked(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.asked)
    }

    /// The app's own seed.
    pub const fn seed(&self) -> u64 {
        self.seed
    }

    /// The code of another round of a course.
    pub(super) fn next_code(&mut self, course: Course) -> Code {
        let seed = self.next_seed();
        Code { course, seed }
    }

    /// The seed of the next round: at first the app's own seed, then others that follow from it.
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
