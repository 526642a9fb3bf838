//! An app without a terminal, on simulated time: tests send keys and read screens.

use std::time::Duration;

use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;

use super::AppHolder;
use crate::app::App;
use crate::messages::{
    Effect, History, HostCall, Input, JoinCall, Key, Mouse, MouseKind, StoreCall, StoreReply,
    StoreRequest,
};
use crate::progress::Attempt;
use crate::store::Store;
use crate::widgets::cells::text;

/// An app with a screen in memory.
///
/// ```
/// use carrom::app::App;
/// use carrom::screens::{Route, Settings};
/// use carrom::shells::Headless;
///
/// let mut game = Headless::new(App::new(Route::Home, Settings::default(), 1), 80, 24);
/// assert!(game.screen().contains("carrom : home"));
/// game.press("<Down><Up>q");
/// assert!(game.has_quit());
/// ```
pub struct Headless {
    app: App,
    terminal: Terminal<TestBackend>,
    store: Store,
    exports: Vec<(String, String)>,
    host_calls: Vec<HostCall>,
    join_calls: Vec<JoinCall>,
}

impl Headless {
    /// Runs `app` on a screen of `columns` by `rows`, with an in-memory store and without a clock,
    /// so that every run is the same.
    pub fn new(app: App, columns: u16, rows: u16) -> Self {
        Self::keeping(app, columns, rows, Store::in_memory().timeless())
    }

    /// Like [`Self::new`], but with this store.
    pub fn keeping(app: App, columns: u16, rows: u16, store: Store) -> Self {
        let Ok(terminal) = Terminal::new(TestBackend::new(columns, rows));
        let mut headless = Self {
            app,
            terminal,
            store,
            exports: Vec::new(),
            host_calls: Vec::new(),
            join_calls: Vec::new(),
        };
        headless.input(&Input::Resize(columns, rows));
        headless
    }

    /// The app, to read its state.
    pub fn app(&self) -> &App {
        &self.app
    }

    /// The app, to change the player's settings.
    pub fn app_mut(&mut self) -> &mut App {
        &mut self.app
    }

    /// Whether the app has quit. After that it ignores every input.
    pub fn has_quit(&self) -> bool {
        self.app.has_quit()
    }

    /// Stops the store's clock at this time, in seconds since the start of 1970.
    pub fn set_time(&mut self, time_s: i64) {
        self.store.stop_clock(time_s, 0);
    }

    /// The stored answers in order; empty if they cannot be read.
    pub fn attempts(&mut self) -> Vec<Attempt> {
        self.history().attempts
    }

    /// The stored answers and observations; empty if they cannot be read.
    pub fn history(&mut self) -> History {
        let request = StoreRequest::Recall(None);
        match self.store.answer(&StoreCall { ticket: 0, request }).done {
            StoreReply::Recalled(Ok(history)) => *history,
            _ => History::default(),
        }
    }

    /// The exported files, which are kept in memory: names and contents.
    pub fn exports(&self) -> &[(String, String)] {
        &self.exports
    }

    /// The app's requests to the class's server since the last call.
    pub fn take_host_calls(&mut self) -> Vec<HostCall> {
        std::mem::take(&mut self.host_calls)
    }

    /// The app's requests to its connection to a class since the last call.
    pub fn take_join_calls(&mut self) -> Vec<JoinCall> {
        std::mem::take(&mut self.join_calls)
    }

    /// Passes on one input.
    pub fn input(&mut self, input: &Input) {
        AppHolder::input(self, input);
    }

    /// Activates the target with this index in [`App::targets`].
    pub fn choose(&mut self, target: usize) {
        if !self.has_quit() {
            let effects = self.app.choose(target);
            self.carry_out_all(effects);
        }
    }

    /// Presses one key.
    pub fn key(&mut self, key: Key) {
        self.input(&Input::Key(key));
    }

    /// Presses keys one by one. A character is its own key; a name in angle brackets is a key as
    /// named in tapes (`"<Right><Right>60<Enter>"`). Brackets around anything else are typed
    /// literally.
    pub fn press(&mut self, keys: &str) {
        let mut rest = keys;
        while let Some(first) = rest.chars().next() {
            let named = rest.strip_prefix('<').and_then(|it| it.split_once('>'));
            let named = named.and_then(|(name, after)| Some((Key::named(name)?, after)));
            let (key, after) = named.unwrap_or((Key::Char(first), &rest[first.len_utf8()..]));
            self.key(key);
            rest = after;
        }
    }

    /// Presses and releases the mouse button over a cell.
    pub fn click(&mut self, at: (u16, u16)) {
        self.mouse(MouseKind::Down, at);
        self.mouse(MouseKind::Up, at);
    }

    /// Presses the mouse button over one cell and releases it over another.
    pub fn drag(&mut self, from: (u16, u16), to: (u16, u16)) {
        self.mouse(MouseKind::Down, from);
        self.mouse(MouseKind::Drag, to);
        self.mouse(MouseKind::Up, to);
    }

    /// Passes on one mouse event over a cell (column and row, counted from 0).
    pub fn mouse(&mut self, kind: MouseKind, cell: (u16, u16)) {
        self.input(&Input::Mouse(Mouse::over(kind, cell)));
    }

    /// Resizes the screen.
    pub fn resize(&mut self, columns: u16, rows: u16) {
        self.terminal.backend_mut().resize(columns, rows);
        self.input(&Input::Resize(columns, rows));
    }

    /// Advances simulated time in the steps that the app requires.
    pub fn pass(&mut self, time: Duration) {
        AppHolder::pass(self, time);
    }

    /// Advances time until nothing moves, but by no more than `limit`. Returns whether everything
    /// has stopped.
    pub fn settle(&mut self, limit: Duration) -> bool {
        self.pass(limit);
        self.has_quit() || self.app.wake().is_none()
    }

    /// Draws the screen and returns its cells.
    pub fn buffer(&mut self) -> &Buffer {
        let Ok(()) = self.terminal.autoresize();
        // The whole screen is drawn each time, because there is no terminal that needs only the
        // changes.
        self.terminal.current_buffer_mut().reset();
        self.app.draw(&mut self.terminal.get_frame());
        self.terminal.current_buffer_mut()
    }

    /// Draws the screen and returns its text.
    pub fn screen(&mut self) -> String {
        text(self.buffer())
    }
}

impl AppHolder for Headless {
    fn app(&mut self) -> &mut App {
        &mut self.app
    }

    fn carry_out(&mut self, effect: Effect) -> Option<Input> {
        match effect {
            Effect::Keep(call) => {
                let answer = self.store.answer(&call);
                return Some(Input::Kept(Box::new(answer)));
            }
            Effect::Host(call) => self.host_calls.push(call),
            Effect::Join(call) => self.join_calls.push(call),
            Effect::ExportPage { .. } => {
                let words = "this program contains no page for browsers".to_owned();
                return Some(Input::Exported(Err(words)));
            }
            Effect::Export { name, content } => {
                self.exports.push((name.clone(), content));
                return Some(Input::Exported(Ok(name)));
            }
        }
        None
    }
}

/// Uses a screen of 80 by 24.
impl From<App> for Headless {
    fn from(app: App) -> Self {
        Self::new(app, 80, 24)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::screens::{Context, Hosted, Next, Route, Screen, Settings, View};
    use crate::widgets::input::KeyTable;
    use crate::widgets::{Charset, Depth};

    /// Records its inputs, and moves for one second after a space is typed.
    #[derive(Default)]
    struct Counter {
        typed: String,
        left: Duration,
        steps: Vec<Duration>,
    }

    impl Screen for Counter {
        type Action = ();
        const HELP: &'static str = "";

        fn title(&self) -> String {
            format!("{} {}", self.typed, self.steps.len())
        }
        fn keys(&self, _: &Context) -> KeyTable<()> {
            KeyTable::new("counter")
        }
        fn typed(&mut self, key: Key, _: &mut Context) -> bool {
            match key {
                Key::Char(' ') => self.left = Duration::from_secs(1),
                Key::Char(c) => self.typed.push(c),
                Key::Escape => return false,
                key => self.typed += &format!("[{key}]"),
            }
            true
        }
        fn act(&mut self, (): (), _: &mut Context) -> Next {
            Next::Stay
        }
        fn advance(&mut self, passed: Duration, _: &mut Context) {
            self.steps.push(passed);
            self.left = self.left.saturating_sub(passed);
        }
        fn wake(&self, _: &Context) -> Option<Duration> {
            (!self.left.is_zero()).then(|| Duration::from_millis(40).min(self.left))
        }
        fn view<'s>(&'s self, _: &'s Context) -> View<'s, ()> {
            View::picture_alone(|_, _, _| ())
        }
    }

    fn counter() -> Headless {
        let app = App::on(
            Box::new(Hosted::new(Counter::default())),
            Settings::default(),
            1,
        );
        Headless::new(app, 80, 24)
    }

    #[test]
    fn keys_arrive_one_by_one() {
        let mut game = counter();
        game.press("6<Right>0<what><Enter");
        let screen = game.screen();
        assert!(screen.contains("6[Right]0<what><Enter 0"), "{screen}");
    }

    #[test]
    fn time_passes_only_while_the_app_requests_it() {
        let mut game = counter();
        game.pass(Duration::from_secs(3600));
        assert!(game.screen().contains(" 0"));
        game.press(" ");
        game.pass(Duration::from_millis(100));
        assert!(game.screen().contains(" 3"), "40, 40 and 20 ms");
        assert!(game.settle(Duration::from_secs(3600)));
        assert!(game.screen().contains(" 26"), "900 ms are 23 more steps");
    }

    #[test]
    fn nothing_reaches_an_app_that_has_quit() {
        let mut game = Headless::new(App::new(Route::Home, Settings::default(), 1), 80, 24);
        let before = game.screen();
        game.press("q<Down>");
        assert!(game.has_quit());
        assert_eq!(game.screen(), before);
    }

    #[test]
    fn a_wide_letter_is_erased_completely() {
        let (code, teams, name) = (None, vec![], String::new());
        let settings = Settings {
            charset: Charset::Unicode,
            depth: Depth::None,
            ..Settings::default()
        };
        let app = App::new(Route::Class { code, teams, name }, settings, 1);
        let mut game = Headless::new(app, 80, 24);
        game.press("a<Backspace>");
        let before = game.screen();
        game.press("abcd");
        assert!(game.screen().contains("abcd"));
        game.press("<Backspace><Backspace><Backspace><Backspace>球球");
        assert!(game.screen().contains("球球"));
        game.press("<Backspace><Backspace>");
        assert_eq!(game.screen(), before);
    }

    #[test]
    fn any_size_is_drawn() {
        let mut game = counter();
        for (columns, rows) in [
            (0, 0),
            (1, 1),
            (0, 5),
            (5, 0),
            (300, 100),
            (59, 20),
            (60, 20),
        ] {
            game.resize(columns, rows);
            assert_eq!(
                game.screen().lines().count(),
                if columns == 0 { 0 } else { rows.into() }
            );
        }
    }
}
