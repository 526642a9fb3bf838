//! Tests every phase of every screen against its own table of keys.

use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

use carrom::app::App;
use carrom::game::SavedGame;
use carrom::messages::{FileContent, Key, MouseKind, StoreCall, StoreRequest};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use carrom::widgets::input::{KeyRow, Rebound};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use ratatui::buffer::Buffer;

use crate::tour::TOUR;

/// A moment of the tour, or one that only this test can reach.
pub(crate) struct Moment {
    pub(crate) name: &'static str,
    takes_any: bool,
    game: Box<dyn Fn(Settings) -> Headless>,
}

impl Moment {
    pub(crate) fn game(&self) -> Headless {
        self.with(Settings::default())
    }

    /// The game with these settings.
    pub(crate) fn with(&self, settings: Settings) -> Headless {
        (self.game)(settings)
    }
}

/// Every phase of every screen.
pub(crate) fn moments() -> impl Iterator<Item = Moment> {
    let tour = TOUR.iter().map(|stop| Moment {
        name: stop.name,
        takes_any: stop.takes_any,
        game: Box::new(|settings| stop.game(settings)),
    });
    let more = Moment {
        name: "table, the end of a board",
        takes_any: false,
        game: Box::new(end_of_a_board),
    };
    tour.chain([more])
}

/// A game that shows the complete hint for a stroke.
fn a_whole_hint() -> Headless {
    let mut game = Headless::from(App::new(Route::Table, Settings::default(), 7));
    game.press("<Enter>hh");
    game
}

/// A saved game between two computer players whose last stroke is being played.
fn end_of_a_board(settings: Settings) -> Headless {
    let bytes = include_bytes!("../saves/board-over-1.toml");
    let (saved, _) = SavedGame::read("board-over-1.toml", bytes).unwrap();
    let mut store = Store::in_memory().timeless();
    let request = StoreRequest::Save(FileContent::Game(Box::new(saved)));
    store.answer(&StoreCall {
        ticket: 99,
        request,
    });
    let app = App::new(Route::Table, settings, 7);
    let mut game = Headless::keeping(app, 80, 24, store);
    game.press("s<Enter>");
    game
}

/// The computer's stroke, before it is played.
fn the_computer_aims() -> Headless {
    let app = App::new(Route::Table, Settings::default(), 7);
    let mut game = Headless::from(app);
    game.press("<Enter><Up><Down><Space><End><Space>");
    game.pass(Duration::from_secs(1));
    game
}

/// The visible state of a game: its cells with their colours, its keys and settings, whether the
/// player has quit, and how many files were exported.
pub(crate) type Seen = (Buffer, Vec<String>, Settings, bool, usize);

pub(crate) fn seen(game: &mut Headless) -> Seen {
    let keys = game.app().keys();
    let keys = keys.rows().iter().map(|row| row.shown()).collect();
    let settings = game.app().settings().clone();
    let (quit, exports) = (game.has_quit(), game.exports().len());
    (game.buffer().clone(), keys, settings, quit, exports)
}

/// Whether a key changes anything in a game on a screen of this size, optionally after another key.
fn changes(mut game: Headless, size: (u16, u16), before: Option<Key>, key: Key) -> bool {
    game.resize(size.0, size.1);
    if let Some(before) = before {
        game.key(before);
        if !game.app().keys().keys().any(|other| other == key) {
            return false;
        }
    }
    let first = seen(&mut game);
    game.key(key);
    seen(&mut game) != first
}

/// Whether a row is tested. The keys that all screens share are handled by the same code, so one
/// test per screen is enough.
fn counts(moment: &Moment, row: &KeyRow<()>) -> bool {
    let own = ["everywhere.back", "everywhere.scroll"].contains(&row.id.as_str());
    own || !row.id.starts_with("everywhere.") || !moment.name.contains(',')
}

/// The keys that most often make another key useful; tried first, to save time.
const USUAL: [Key; 4] = [Key::Down, Key::Home, Key::End, Key::Backspace];

#[test]
fn each_key_of_each_table_does_something() {
    let mut idle = Vec::new();
    // A text that fits cannot be scrolled; each screen has some longer texts.
    let mut scrolls = BTreeMap::new();
    for moment in moments() {
        let mut untouched = moment.game();
        let at_first = seen(&mut untouched);
        let table = untouched.app().keys();
        for row in table.rows().iter().filter(|row| counts(&moment, row)) {
            if row.id.ends_with("scroll") {
                let any = scrolls.entry(row.id.clone()).or_insert(false);
                let scrolls = |key| changes(moment.game(), (60, 20), None, key);
                *any = *any || row.all_keys().any(scrolls);
                continue;
            }
            for key in row.all_keys() {
                let mut pressed = moment.game();
                pressed.key(key);
                if seen(&mut pressed) != at_first {
                    continue;
                }
                // The mark of a list cannot move up from its first line, but it can once another
                // key of the table has been pressed, most likely one in the same row.
                let does = |before| changes(moment.game(), (80, 24), Some(before), key);
                let usual = USUAL
                    .into_iter()
                    .filter(|it| table.keys().any(|key| key == *it));
                if !row.all_keys().chain(usual).chain(table.keys()).any(does) {
                    idle.push(format!("{}: {key}", moment.name));
                }
            }
        }
    }
    assert!(idle.is_empty(), "{idle:#?}");
    let hint = changes(a_whole_hint(), (60, 20), None, Key::PageDown);
    scrolls.insert("table.scroll".to_owned(), hint);
    assert!(scrolls.values().all(|any| *any), "{scrolls:?}");
}

#[test]
fn no_key_outside_the_table_does_anything() {
    let named = [
        Key::Up,
        Key::Down,
        Key::Left,
        Key::Right,
        Key::Enter,
        Key::Tab,
        Key::BackTab,
        Key::Backspace,
        Key::Delete,
        Key::PageUp,
        Key::PageDown,
        Key::Home,
        Key::End,
    ];
    let all: Vec<Key> = (' '..='~').map(Key::Char).chain(named).collect();
    let mut strangers = Vec::new();
    for moment in moments().filter(|moment| !moment.takes_any) {
        let mut game = moment.game();
        let before = seen(&mut game);
        let table = game.app().keys();
        let strange: Vec<Key> = all
            .iter()
            .copied()
            .filter(|key| table.find(*key).is_none())
            .collect();
        // Several keys are pressed before each drawing, which takes longer than a press; they are
        // chosen so that none undoes the effect of another.
        for first in 0..9 {
            let some = strange.iter().skip(first).step_by(9);
            some.clone().for_each(|key| game.key(*key));
            if seen(&mut game) != before {
                strangers.push(format!(
                    "{}: one of {:?}",
                    moment.name,
                    some.collect::<Vec<_>>()
                ));
                break;
            }
        }
    }
    assert!(strangers.is_empty(), "{strangers:#?}");
}

#[test]
fn each_row_is_named_and_explained_and_no_two_share_an_id() {
    for moment in moments() {
        let table = moment.game().app().keys();
        let mut ids = BTreeSet::new();
        for row in table.rows() {
            assert!(
                ids.insert(row.id.clone()),
                "{}: {} twice",
                moment.name,
                row.id
            );
            assert!(!row.help.is_empty(), "{}: {}", moment.name, row.id);
        }
    }
}

#[test]
fn escape_always_goes_back_or_asks_for_confirmation() {
    for moment in moments() {
        let mut game = moment.game();
        for presses in 0.. {
            assert!(presses < 8, "{}: Escape leads nowhere", moment.name);
            let before = seen(&mut game);
            game.key(Key::Escape);
            if game.screen().contains("Leave carrom?") {
                break;
            }
            assert!(
                seen(&mut game) != before,
                "{}: after {presses}",
                moment.name
            );
            if game.screen().contains("please choose") {
                game.press("y");
            }
        }
    }
}

/// The cell beside the mark of a list: the mark is in `with`, but not in `without`.
fn mark(with: &Buffer, without: &Buffer) -> (u16, u16) {
    let marks = |at: &(u16, u16)| with[*at].symbol() == ">" && without[*at].symbol() != ">";
    let cells = with.area.positions().map(|at| (at.x, at.y));
    let (column, row) = { cells }.find(marks).unwrap();
    (column + 2, row)
}

#[test]
fn every_list_behaves_the_same_way() {
    let (mut lists, mut clicked) = (0, 0);
    for moment in moments() {
        let table = moment.game().app().keys();
        // While a name is being typed, Home and End go to its ends.
        let has = |id: &str| table.rows().iter().any(|row| row.id == id);
        if !has("list.choose") || !has("list.end") {
            continue;
        }
        lists += 1;
        let name = moment.name;
        let after = |keys: &str| {
            let mut game = moment.game();
            game.press(keys);
            seen(&mut game)
        };
        let first = after("<Home>");
        assert_eq!(
            after("<Home><Up>"),
            first,
            "{name}: the mark stops at the top"
        );
        assert_eq!(
            after("<End><Down>"),
            after("<End>"),
            "{name}: the mark stops at the end"
        );
        if has("list.page") {
            assert_eq!(after("<Home><PageUp>"), first, "{name}");
            assert_eq!(after("<End><PageDown>"), after("<End>"), "{name}");
        }
        assert_eq!(after("<Home><Tab>"), after("<Home><Down>"), "{name}");
        assert_eq!(
            after("<Home><Enter>"),
            after("<Home><Space>"),
            "{name}: both keys open a line"
        );
        let mut wheel = moment.game();
        wheel.press("<Home>");
        wheel.mouse(MouseKind::ScrollDown, (70, 8));
        let turned = seen(&mut wheel);
        let second = after("<Home><Down>");
        assert_eq!(turned, second, "{name}: the wheel moves the mark");
        if second == first {
            continue;
        }
        clicked += 1;
        let mut click = moment.game();
        click.press("<Home>");
        click.click(mark(&second.0, &first.0));
        assert_eq!(seen(&mut click), second, "{name}: a click chooses a line");
        click.click(mark(&second.0, &first.0));
        let opened = after("<Home><Down><Enter>");
        assert_eq!(
            seen(&mut click),
            opened,
            "{name}: a second click opens the line"
        );
    }
    assert!(lists >= 8 && clicked >= 6, "{lists} lists, {clicked}");
}

#[test]
fn each_moment_has_keys_of_its_own() {
    let mut tables = Vec::new();
    for moment in moments() {
        let mut game = moment.game();
        let table = game.app().keys();
        let rows = table.rows().iter().map(|row| (row.id.clone(), row.name));
        let rows: Vec<(String, &str)> = rows.collect();
        // A vote has the same keys as a question of the quiz.
        let screen = game.screen();
        let screen: String = screen.chars().take(18).collect();
        let table = (screen, rows);
        if let Some((other, _)) = tables.iter().find(|(_, other)| *other == table) {
            panic!("{} is {other}", moment.name);
        }
        tables.push((moment.name, table));
    }
}

#[test]
fn a_rebound_key_works_and_is_shown_wherever_its_row_is() {
    let mut met = BTreeSet::new();
    for moment in moments() {
        let table = moment.game().app().keys();
        for row in table.rows().iter().filter(|row| counts(&moment, row)) {
            let id = row.id.as_str();
            // Each row of each screen is tested in the first phase that has the row.
            let screen = moment.name.split(',').next().unwrap();
            if !met.insert((screen, row.id.clone())) {
                continue;
            }
            let old = row.keys().next().unwrap();
            if moment.takes_any && matches!(old, Key::Char(_)) {
                continue;
            }
            // The first key of the row is replaced by a key that no other row has.
            let keys = std::iter::once(Key::F(9)).chain(row.keys().skip(1));
            let keys = Rebound::from([(id.to_owned(), keys.collect())]);
            let mut rebound = moment.game();
            rebound.app_mut().settings_mut().keys = keys;
            let mut usual = moment.game();
            usual.key(old);
            let help = rebound.app().keys();
            let shown = help.rows().iter().find(|row| row.id == id).unwrap();
            let shown = shown.shown();
            assert!(shown.contains("F9"), "{}: {id}: {shown}", moment.name);
            rebound.key(Key::F(9));
            rebound.app_mut().settings_mut().keys.clear();
            assert_eq!(
                rebound.screen(),
                usual.screen(),
                "{}: {id} by F9 as by {old}",
                moment.name
            );
        }
    }
}

/// All keys, one row per line as in `keys.toml`.
fn all_keys() -> String {
    let mut all = BTreeMap::new();
    let computer_aims = the_computer_aims();
    for game in moments().map(|it| it.game()).chain([computer_aims]) {
        for row in game.app().keys().rows() {
            let keys: Vec<String> = row.keys().map(|key| quoted(&key.to_string())).collect();
            let known = all
                .entry(quoted(&row.id))
                .or_insert((keys.clone(), row.help));
            if keys.len() > known.0.len() {
                known.0 = keys;
            }
        }
    }
    let line = |(id, (keys, help)): (_, (Vec<String>, _))| {
        format!("{id} = [{}]  # {help}\n", keys.join(", "))
    };
    all.into_iter().map(line).collect()
}

fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}

#[test]
fn carrom_keys_prints_the_keys_of_all_tables() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/keys.toml");
    let all = all_keys();
    if std::env::var("INSTA_UPDATE").is_ok_and(|it| it == "always") {
        std::fs::write(path, &all).unwrap();
    }
    let kept = std::fs::read_to_string(path).unwrap();
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<BTreeSet<_>>();
    let (kept, all) = (lines(&kept), lines(&all));
    let differing: Vec<_> = kept.symmetric_difference(&all).collect();
    assert!(
        differing.is_empty(),
        "accept with INSTA_UPDATE=always: {differing:#?}"
    );
}

#[test]
fn every_row_found_by_a_random_walk_can_be_rebound() {
    let known: toml::Table = all_keys().parse().unwrap();
    let mut unknown = BTreeMap::new();
    let mut random = Pcg64::seed_from_u64(1);
    for moment in moments() {
        let mut game = moment.game();
        let mut way = String::new();
        for _ in 0..40 {
            let table = game.app().keys();
            for row in table
                .rows()
                .iter()
                .filter(|row| !known.contains_key(&row.id))
            {
                unknown
                    .entry(row.id.clone())
                    .or_insert(format!("{}: {way}", moment.name));
            }
            let keys: Vec<Key> = table.keys().filter(|key| *key != Key::Ctrl('c')).collect();
            let Some(key) = keys.choose(&mut random) else {
                break;
            };
            way += &format!("<{key}>");
            game.key(*key);
            if random.random_ratio(1, 8) {
                game.pass(Duration::from_secs(2));
            }
        }
    }
    assert!(unknown.is_empty(), "{unknown:#?}");
}
