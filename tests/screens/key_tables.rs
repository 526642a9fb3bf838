//! Every phase of every screen, walked by its own table of keys.

use std::collections::BTreeSet;

use carrom::messages::{Key, MouseKind};
use carrom::screens::Settings;
use carrom::shells::Headless;
use carrom::shells::tour::{TOUR, TourStop};
use carrom::widgets::input::Rebound;
use ratatui::buffer::Buffer;

fn game(moment: &TourStop) -> Headless {
    moment.game(Settings::default())
}

/// What can be seen of a game: its cells with their colours, its keys and settings, and
/// whether it was left or wrote anything.
type Seen = (Buffer, Vec<String>, Settings, bool, usize);

fn seen(game: &mut Headless) -> Seen {
    let keys = game.app().keys();
    let keys = keys.rows().iter().map(|row| row.shown()).collect();
    let settings = game.app().settings().clone();
    let (quit, exports) = (game.has_quit(), game.exports().len());
    (game.buffer().clone(), keys, settings, quit, exports)
}

/// Whether a key changes anything at a moment, or after one of the moment's other keys:
/// the mark of a list cannot go up from its first line.
fn does_something(moment: &TourStop, key: Key) -> bool {
    let changes = |before: Option<Key>, rows: u16| {
        let mut game = game(moment);
        game.resize(80, rows);
        if let Some(before) = before {
            game.key(before);
            if !game.app().keys().keys().any(|other| other == key) {
                return false;
            }
        }
        let first = seen(&mut game);
        game.key(key);
        seen(&mut game) != first
    };
    let table = game(moment).app().keys();
    // A text that fits cannot be scrolled.
    let sizes = [24, 20];
    let first = sizes.iter().any(|rows| changes(None, *rows));
    let after = |before| sizes.iter().any(|rows| changes(Some(before), *rows));
    first || table.keys().any(after)
}

#[test]
fn each_key_of_each_table_does_something() {
    let mut idle = Vec::new();
    for moment in TOUR {
        let table = game(moment).app().keys();
        // What scrolls has nothing to do while the text fits.
        let scrolls = table.rows().iter().filter(|row| row.id.ends_with("scroll"));
        let scrolls: Vec<Key> = scrolls.flat_map(|row| row.all_keys()).collect();
        for key in table.keys().filter(|key| !scrolls.contains(key)) {
            if !does_something(moment, key) {
                idle.push(format!("{}: {key}", moment.name));
            }
        }
    }
    assert!(idle.is_empty(), "{idle:#?}");
}

#[test]
fn no_key_outside_of_the_table_does_anything() {
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
    for moment in TOUR.iter().filter(|moment| !moment.takes_any) {
        let mut game = game(moment);
        let before = seen(&mut game);
        let table = game.app().keys();
        for key in all.iter().filter(|key| table.find(**key).is_none()) {
            game.key(*key);
            if seen(&mut game) != before {
                strangers.push(format!("{}: {key}", moment.name));
                break;
            }
        }
    }
    assert!(strangers.is_empty(), "{strangers:#?}");
}

#[test]
fn each_row_is_named_and_explained_and_no_two_share_an_id() {
    for moment in TOUR {
        let table = game(moment).app().keys();
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
fn escape_always_goes_back_or_asks() {
    for moment in TOUR {
        let mut game = game(moment);
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
            if game.screen().contains("please say") {
                game.press("y");
            }
        }
    }
}

#[test]
fn every_list_has_the_same_manners() {
    for moment in TOUR {
        let table = game(moment).app().keys();
        if !table.rows().iter().any(|row| row.id == "list.choose") {
            continue;
        }
        let name = moment.name;
        let after = |keys: &str| {
            let mut game = game(moment);
            game.press(keys);
            seen(&mut game)
        };
        let first = after("<Home>");
        assert_eq!(after("<Home><Up>"), first, "{name}: it stops at its top");
        assert_eq!(
            after("<End><Down>"),
            after("<End>"),
            "{name}: it stops at its end"
        );
        assert_eq!(after("<Home><PageUp>"), first, "{name}");
        assert_eq!(after("<End><PageDown>"), after("<End>"), "{name}");
        assert_eq!(after("<Home><Tab>"), after("<Home><Down>"), "{name}");
        assert_eq!(
            after("<Home><Enter>"),
            after("<Home><Space>"),
            "{name}: both open"
        );
        let mut wheel = game(moment);
        wheel.press("<Home>");
        wheel.mouse(MouseKind::ScrollDown, (70, 8));
        let turned = seen(&mut wheel);
        assert_eq!(
            turned,
            after("<Home><Down>"),
            "{name}: the wheel moves the mark"
        );
    }
}

#[test]
fn a_rebound_key_works_wherever_its_row_is_and_its_help_says_so() {
    for moment in TOUR {
        for row in game(moment).app().keys().rows() {
            let id = row.id.as_str();
            let old = row.keys().next().unwrap();
            if moment.takes_any && matches!(old, Key::Char(_)) {
                continue;
            }
            // A key that nothing else has, for the row's first one.
            let keys = std::iter::once(Key::F(9)).chain(row.keys().skip(1));
            let keys = Rebound::from([(id.to_owned(), keys.collect())]);
            let mut rebound = game(moment);
            rebound.app_mut().settings_mut().keys = keys;
            let mut usual = game(moment);
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
