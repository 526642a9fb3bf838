//! The app: a stack of screens, and everything that the screens have in common.
//!
//! The app is pure: [`App::update`] and [`App::advance`] return effects for a shell to carry out,
//! [`App::wake`] returns the time until the next change, and [`App::draw`] does not change the app.
//! The app uses no clock, file or thread; its only mutable global variables record the text and the
//! pictures of a frame for a shell that requests them.

mod chrome;
mod layer;
mod route;

use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Duration;

use ratatui::Frame;
use ratatui::layout::Rect;

use crate::lessons::Book;
use crate::levels::Shelf;
use crate::measure::Measurement;
use crate::messages::{Effect, Input, Key, MouseKind, StoreAnswer, StoreReply, StoreRequest};
use crate::quiz::concepts::Library;
use crate::screens::{
    AnyScreen, Confirmation, Context, Hosted, KeptSettings, Next, Route, Screen, Settings,
    SharedAction,
    class::Class,
    foil::FoilScreen,
    glossary::GlossaryScreen,
    home::Home,
    join::Join,
    lab::Lab,
    learn::{Contents, Reading},
    levels::{LevelPlay, Levels},
    measured::MeasuredScreen,
    progress::Progress,
    quiz::{Choosing, Quiz},
    rules::RulesScreen,
    settings::SettingsScreen,
    table::Table,
    teacher::Teacher,
};
use crate::widgets::input::KeyTable;
use crate::widgets::{Outcome, Palette, PictureSizes};

use layer::{AppLayer, LayerAction};

/// The smallest size, in columns and rows, of a screen that is drawn; on a smaller one, a single
/// line states this size.
pub(crate) const SMALLEST: (u16, u16) = (60, 20);

/// The contents of an app: everything that can be read, played and answered.
#[derive(Debug, Clone, Default)]
pub struct Data {
    /// The levels.
    pub shelf: Shelf,
    /// The chapters.
    pub book: Book,
    /// Questions in words that are available in addition to the built-in questions.
    pub own: Arc<Library>,
    /// The path of the folder where data is saved.
    pub folder: Option<String>,
}

/// The pause before the first retry after a failed save; each failed retry doubles the pause, up to
/// the longest pause.
const RETRY: Duration = Duration::from_secs(2);
const LONGEST_RETRY: Duration = Duration::from_secs(8);

/// The state of the retries after a failed save.
#[derive(Debug, Clone, Copy, Default)]
struct Retry {
    /// The time since the last attempt.
    waited: Duration,
    /// The ticket of the attempt in progress.
    ticket: Option<u64>,
    /// The number of failed retries since the last success.
    failures: u32,
}

impl Retry {
    /// The pause before the next retry.
    fn pause(self) -> Duration {
        let pause = RETRY.saturating_mul(1 << self.failures.min(8));
        pause.min(LONGEST_RETRY)
    }
}

/// The whole game, without a terminal or any other shell.
pub struct App {
    stack: Vec<Box<dyn AnyScreen>>,
    context: Context,
    size: Rect,
    /// The layers over the screen, with the topmost last.
    layers: Vec<AppLayer>,
    /// The tickets of slow saves that are in progress.
    saving: BTreeSet<u64>,
    /// The number of items that have not been saved yet because saving failed.
    unsaved: usize,
    /// The time since the last retry, and whether a retry is in progress.
    retry: Retry,
    /// Whether a notice has reported that earlier answers could not be loaded, or that settings
    /// cannot be saved: one notice is enough.
    reported_store: bool,
    has_quit: bool,
}

impl App {
    /// Creates an app that starts at `route`, with Home below.
    pub fn new(route: Route, settings: Settings, seed: u64) -> Self {
        Self::with_data(Data::default(), route, settings, seed)
    }

    /// Creates an app with contents in addition to the built-in ones.
    pub fn with_data(data: Data, route: Route, settings: Settings, seed: u64) -> Self {
        let mut context = Context::new(settings, seed);
        context.shelf = data.shelf;
        context.book = data.book;
        context.own = data.own;
        context.folder = data.folder;
        let mut app = Self {
            stack: vec![hosted(Home::default())],
            context,
            size: Rect::default(),
            layers: Vec::new(),
            saving: BTreeSet::new(),
            unsaved: 0,
            retry: Retry::default(),
            reported_store: false,
            has_quit: false,
        };
        match route {
            Route::Level(_) => app.open(Route::Levels),
            Route::Chapter(_) => app.open(Route::Learn),
            _ => {}
        }
        match route {
            Route::Home => app.resume(),
            _ => app.open(route),
        }
        app
    }

    /// The state that all screens share.
    pub fn context(&self) -> &Context {
        &self.context
    }

    /// Creates an app that starts on a screen supplied by the caller, with Home below.
    pub fn on(screen: Box<dyn AnyScreen>, settings: Settings, seed: u64) -> Self {
        let mut app = Self::new(Route::Home, settings, seed);
        app.stack.push(screen);
        app
    }

    /// The address of the current screen, and the number of open screens, including the first.
    /// [`Data::route`] converts most addresses back to the route of the screen.
    pub fn address(&self) -> (String, usize) {
        let cx = &self.context;
        let top = self.stack.last().map(|screen| screen.route(cx));
        let address = top.map_or_else(String::new, |route| route::address(&route, cx));
        (address, self.stack.len())
    }

    /// Whether the player has quit. Once this is true, the app expects no more inputs.
    pub fn has_quit(&self) -> bool {
        self.has_quit
    }

    /// The player's settings.
    pub fn settings(&self) -> &Settings {
        &self.context.settings
    }

    /// Mutable access to the player's settings.
    pub fn settings_mut(&mut self) -> &mut Settings {
        &mut self.context.settings
    }

    /// Applies the preferences of the player's system to the settings that the player has not
    /// changed.
    pub fn prefer(&mut self, palette: Palette, reduced_motion: bool) {
        let settings = &mut self.context.settings;
        settings.palette = palette;
        settings.reduced_motion = reduced_motion;
        if let Some(kept) = &self.context.kept {
            *settings = kept.over(settings.clone());
        }
    }

    /// Sets the sizes of pictures independently of the size of the screen, for a page that arranges
    /// the recorded blocks itself.
    pub fn set_pictures(&mut self, sizes: Option<PictureSizes>) {
        self.context.pictures = sizes;
    }

    /// Tells the app which settings were stored when it started; if `kept` is `None`, the stored
    /// settings are not changed.
    pub fn set_kept(&mut self, kept: Option<KeptSettings>) {
        self.context.kept = kept;
    }

    /// Handles one input and returns what the shell has to do.
    pub fn update(&mut self, input: &Input) -> Vec<Effect> {
        self.effects_of(|app| app.take(input))
    }

    /// Lets the app act, saves the settings that this changes, and returns what the shell has to
    /// do, including requests that the first screen made when it was opened.
    fn effects_of(&mut self, act: impl FnOnce(&mut Self)) -> Vec<Effect> {
        let before = self.context.settings.clone();
        act(self);
        self.context.keep_settings(&before);
        self.context.take_asked()
    }

    fn take(&mut self, input: &Input) {
        match input {
            Input::Resize(columns, rows) => {
                self.size = Rect::new(0, 0, *columns, *rows);
                self.context.body = chrome::body(self.size);
            }
            Input::Key(Key::Ctrl('c')) => self.leave(),
            // The screen that made the request is waiting for the result, even if a layer covers
            // the screen.
            Input::Exported(_) | Input::Hosted(_) | Input::Joined(_) => self.pass_down(input),
            Input::Saving(ticket) => {
                self.saving.insert(*ticket);
            }
            Input::Kept(answer) => {
                self.note(answer);
                self.pass_down(input);
            }
            // On a screen this small, the player could not see the effect of a key.
            _ if self.too_small() => {}
            Input::Key(key) => self.press(*key),
            // A drag may leave the body, and the button may be released outside the body.
            Input::Mouse(mouse)
                if !matches!(mouse.kind, MouseKind::Drag | MouseKind::Up)
                    && !self.context.body.contains(mouse.cell().into()) => {}
            _ if !self.layers.is_empty() => {}
            _ => self.with_screen(|screen, cx| screen.input(input, cx)),
        }
    }

    /// Handles the parts of a reply from the store that do not concern a particular screen.
    fn note(&mut self, answer: &StoreAnswer) {
        self.saving.remove(&answer.ticket);
        if let Some(notice) = &answer.notice {
            self.notify(notice.clone());
        }
        if let StoreReply::Marks(marks) = &answer.done {
            let marks = marks.clone().unwrap_or_default();
            self.context.book.recall(marks);
        }
        if self.retry.ticket == Some(answer.ticket) {
            self.retry.ticket = None;
            self.retry.failures += 1;
        }
        let was_unsaved = std::mem::replace(&mut self.unsaved, answer.unsaved);
        if answer.unsaved == 0 {
            self.retry.failures = 0;
            self.layers
                .retain(|layer| !matches!(layer, AppLayer::Leave(_)));
        }
        match &answer.done {
            StoreReply::Stars(Ok(stars)) => {
                for starred in stars {
                    self.context.shelf.recall(starred);
                }
            }
            StoreReply::Noted(Err(reason)) if was_unsaved == 0 && answer.unsaved > 0 => {
                self.retry.waited = Duration::ZERO;
                self.notify(format!(
                    "Your progress cannot be saved at the moment: {reason}. You can continue: carrom \
                     will save it as soon as possible."
                ));
            }
            StoreReply::Noted(Err(reason))
                if answer.unsaved == 0 && !std::mem::replace(&mut self.reported_store, true) =>
            {
                self.notify(format!(
                    "Your settings cannot be saved: {reason}. You can continue."
                ));
            }
            StoreReply::Stars(Err(reason)) | StoreReply::Marks(Err(reason))
                if !std::mem::replace(&mut self.reported_store, true) =>
            {
                self.notify(format!(
                    "Your earlier answers cannot be loaded: {reason}. You can continue."
                ));
            }
            _ => {}
        }
    }

    /// Leaves the program, or asks first if something has not been saved yet; a second request to
    /// leave is carried out without asking.
    fn leave(&mut self) {
        let is_asked = |layer: &AppLayer| matches!(layer, AppLayer::Leave(_));
        if self.unsaved == 0 || self.layers.iter().any(is_asked) {
            self.has_quit = true;
            return;
        }
        let things = match self.unsaved {
            1 => "One change is not saved yet and will be".to_owned(),
            unsaved => format!("{unsaved} changes are not saved yet and will be"),
        };
        let question = format!("{things} lost if carrom cannot save before it closes. Leave?");
        let question = Confirmation::new(question, "leave", "stay");
        self.layers.push(AppLayer::Leave(question));
    }

    /// The time until the next retry after a failed save.
    fn retry_in(&self) -> Option<Duration> {
        let waits = self.unsaved > 0 && self.retry.ticket.is_none();
        waits.then(|| self.retry.pause().saturating_sub(self.retry.waited))
    }

    /// Reduces the time until the next retry by `passed`, and starts the retry when it is due.
    fn retry(&mut self, passed: Duration) {
        if self.retry_in().is_none() {
            return;
        }
        self.retry.waited += passed;
        if self.retry.waited >= self.retry.pause() {
            self.retry.waited = Duration::ZERO;
            self.retry.ticket = Some(self.context.ask(StoreRequest::Retry));
        }
    }

    /// The status of a save that is slow or has failed; otherwise empty.
    fn keeping(&self) -> String {
        match self.unsaved {
            _ if !self.saving.is_empty() => "saving ..".into(),
            0 => String::new(),
            unsaved => format!("not saved: {unsaved}"),
        }
    }

    /// Advances the time of the app by `passed`.
    pub fn advance(&mut self, passed: Duration) -> Vec<Effect> {
        if self.screen_wake().is_some() {
            self.with_screen(|screen, cx| {
                screen.advance(passed, cx);
                Next::Stay
            });
        }
        self.retry(passed);
        self.context.take_asked()
    }

    /// The time until the app must next be advanced; `None` if nothing moves and no retry is
    /// pending.
    pub fn wake(&self) -> Option<Duration> {
        let times = [self.screen_wake(), self.retry_in()];
        times.into_iter().flatten().min()
    }

    /// The time until the next motion on the screen, for shells that can skip the wait by advancing
    /// the time immediately; `None` also during a countdown that other people can see.
    pub(crate) fn motion(&self) -> Option<Duration> {
        let shares_time = self.stack.last().is_some_and(|it| it.shares_time());
        let wake = self.screen_wake();
        wake.filter(|wake| !shares_time || *wake <= crate::widgets::hit::FRAME)
    }

    /// The time until the screen must next be advanced.
    fn screen_wake(&self) -> Option<Duration> {
        let stands = |layer: &AppLayer| !matches!(layer, AppLayer::Notice(_));
        if self.layers.iter().any(stands) || self.too_small() {
            return None;
        }
        self.stack.last()?.wake(&self.context)
    }

    /// The current keys, as set by the player: if there is a layer, the keys of the topmost layer,
    /// otherwise the keys of the screen and those that all screens share.
    pub fn keys(&self) -> KeyTable<()> {
        match (self.layers.last(), self.stack.last()) {
            (Some(layer), _) => layer.keys(&self.context.settings.keys).map(|_| ()),
            (None, Some(screen)) => screen.table(&self.context),
            (None, None) => KeyTable::new("app"),
        }
    }

    /// The areas of the panels that react to a click, from top to bottom.
    pub fn targets(&self) -> Vec<Rect> {
        match (self.layers.last(), self.stack.last()) {
            (None, Some(screen)) if !self.too_small() => screen.targets(&self.context),
            _ => Vec::new(),
        }
    }

    /// Activates the target with this number, as if it had been clicked.
    pub fn choose(&mut self, target: usize) -> Vec<Effect> {
        self.effects_of(|app| {
            if app.layers.is_empty() && !app.too_small() {
                app.with_screen(|screen, cx| screen.choose(target, cx));
            }
        })
    }

    /// Draws the whole screen. For mouse positions to be correct, the app must already have
    /// received the size of the frame in an [`Input::Resize`].
    pub fn draw(&self, frame: &mut Frame) {
        let area = frame.area();
        let buf = frame.buffer_mut();
        chrome::draw(self, area, buf);
    }

    fn too_small(&self) -> bool {
        self.size.width < SMALLEST.0 || self.size.height < SMALLEST.1
    }

    /// Shows a notice over the screen until a key is pressed.
    pub fn notify(&mut self, words: String) {
        self.layers
            .retain(|layer| !matches!(layer, AppLayer::Notice(_)));
        self.layers.push(AppLayer::Notice(words));
    }

    /// Passes a key to the topmost layer or screen.
    fn press(&mut self, key: Key) {
        let most = match self.layers.last() {
            Some(AppLayer::Help { .. }) => chrome::help_overflow(self),
            _ => 0,
        };
        let Some(layer) = self.layers.last_mut() else {
            return self.with_screen(|screen, cx| screen.press(key, cx));
        };
        let Outcome::Done(action) = layer.press(key, most, &self.context.settings.keys) else {
            return;
        };
        match (self.layers.pop(), action) {
            (_, Some(LayerAction::Glossary)) => self.look_up(Route::Glossary),
            (_, Some(LayerAction::Rules(rules))) => self.look_up(Route::Rules(rules)),
            (Some(AppLayer::Leave(_)), Some(LayerAction::Agree)) => self.has_quit = true,
            (_, Some(LayerAction::Agree)) => self.with_screen(|screen, cx| screen.confirmed(cx)),
            _ => {}
        }
    }

    /// Opens a page over the screen, unless it is the screen.
    fn look_up(&mut self, route: Route) {
        self.with_screen(|screen, cx| match screen.route(cx) == route {
            true => Next::Stay,
            false => Next::Open(route),
        });
    }

    /// Passes an input to the topmost screen or, if that screen ignores the input, to the screen of
    /// a class below it, because the class continues for its other members. If the class then opens
    /// or closes a screen, the screens above the class are closed first.
    fn pass_down(&mut self, input: &Input) {
        let top = self.stack.len().saturating_sub(1);
        let mut screens = self.stack.iter_mut().enumerate().rev();
        let found = screens.find_map(|(at, screen)| {
            if at < top && !screen.shares_time() {
                return None;
            }
            let next = screen.input(input, &mut self.context);
            (next != Next::Ignored).then_some((at, next))
        });
        if let Some((at, next)) = found {
            if next != Next::Stay {
                self.stack.truncate(at + 1);
            }
            self.with_screen(|_, _| next);
        }
    }

    /// Lets the topmost screen act, then carries out its requests.
    fn with_screen(&mut self, act: impl FnOnce(&mut dyn AnyScreen, &mut Context) -> Next) {
        if let Some(screen) = self.stack.last_mut() {
            let next = act(screen.as_mut(), &mut self.context);
            self.follow(next);
            if let Some(reported) = self.context.take_notice() {
                self.notify(reported);
            }
        }
    }

    /// Carries out actions that all screens share.
    fn share(&mut self, action: SharedAction) {
        let settings = &mut self.context.settings;
        match action {
            SharedAction::Help => {
                let rules = self.stack.last().and_then(|screen| screen.rules());
                let scrolled = 0;
                self.layers.push(AppLayer::Help { scrolled, rules });
            }
            SharedAction::Charset => settings.charset = settings.charset.other(),
            SharedAction::Theme => settings.palette = settings.palette.next(),
            SharedAction::Motion => settings.reduced_motion = !settings.reduced_motion,
            SharedAction::Back => self.follow(Next::Back),
            SharedAction::Quit => self.leave(),
            // The screen has already scrolled.
            SharedAction::Scroll(_) => {}
        }
    }

    fn follow(&mut self, next: Next) {
        match next {
            Next::Ignored | Next::Stay => {}
            Next::Open(route) => self.open(route),
            Next::Replace(route) => {
                self.stack.pop();
                self.open(route);
            }
            Next::Back => {
                self.stack.pop();
                if self.stack.is_empty() {
                    self.open(Route::Home);
                    self.leave();
                } else {
                    self.resume();
                }
            }
            Next::Confirm(question) => self.layers.push(AppLayer::Confirm(question)),
            Next::Shared(action) => self.share(action),
        }
    }

    /// Tells the topmost screen that it is visible again.
    fn resume(&mut self) {
        if let Some(screen) = self.stack.last_mut() {
            screen.resumed(&mut self.context);
        }
    }

    /// Shows a measured collision.
    pub fn show(&mut self, measurement: Measurement) {
        self.open(Route::Measured(Arc::new(measurement)));
    }

    fn open(&mut self, route: Route) {
        self.stack.extend(screen_of(route, &mut self.context));
    }
}

/// The screen of a route; `None` if there is no such chapter or level.
fn screen_of(route: Route, cx: &mut Context) -> Option<Box<dyn AnyScreen>> {
    Some(match route {
        Route::Home => hosted(Home::ask(cx)),
        Route::Lab => hosted(Lab::resume(cx)),
        Route::LabOf { setup, hidden } => hosted(Lab::of(setup, hidden)),
        Route::Learn => hosted(Contents::new(cx)),
        Route::Glossary => hosted(GlossaryScreen::default()),
        Route::Chapter(number) => hosted(Reading::new(number, None, cx)?),
        Route::Page { chapter, page } => hosted(Reading::new(chapter, Some(page), cx)?),
        Route::Quiz(Some(code)) => hosted(Quiz::new(code)),
        Route::Quiz(None) => hosted(Choosing::ask(cx)),
        Route::OpenRound {
            code,
            answers,
            is_explained,
        } => hosted(Quiz::left_at(code, &answers, is_explained, cx)),
        Route::Levels => hosted(Levels::new(cx)),
        Route::Level(number) => hosted(LevelPlay::new(number, cx)?),
        Route::Class { code, teams, name } => hosted(Class::new(code.as_ref(), &teams, &name, cx)),
        Route::Host {
            code,
            name,
            nicknames,
        } => hosted(Class::with_devices(code.as_ref(), &name, nicknames, cx)),
        Route::Join {
            address,
            code,
            again,
        } => hosted(Join::new(address.as_deref(), code, again, cx)),
        Route::Foil(page) => hosted(FoilScreen::at(page)),
        Route::Table => hosted(Table::new_game(None, cx)),
        Route::Board(code) => hosted(Table::board(code, cx)),
        Route::Rules(rules) => hosted(RulesScreen { rules }),
        Route::Measured(measurement) => hosted(MeasuredScreen::new(measurement)),
        Route::Progress => hosted(Progress::ask(cx)),
        Route::Teacher => hosted(Teacher::ask(cx)),
        Route::Settings => hosted(SettingsScreen::ask(cx)),
    })
}

fn hosted<S: Screen + 'static>(screen: S) -> Box<dyn AnyScreen> {
    Box::new(Hosted::new(screen))
}
