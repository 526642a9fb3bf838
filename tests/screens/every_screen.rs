//! Properties of every screen, for any input and any size.

use std::time::Duration;

use carrom::app::App;
use carrom::game::{BoardCode, Rules};
use carrom::messages::{Input, Key, Mouse, MouseKind};
use carrom::quiz::{Code, Course, CourseKind};
use carrom::screens::{FoilPage, Route, Settings};
use carrom::shells::Headless;
use carrom::widgets::Charset;
use proptest::prelude::*;

use crate::thorough::cases;

/// Routes to nearly every screen, and to rounds of the quiz: one of each kind that is always in the
/// menu, a review, and one on each topic.
fn places() -> Vec<Route> {
    let mut places = vec![
        Route::Home,
        Route::Lab,
        Route::Learn,
        Route::Glossary,
        Route::Chapter(2),
        Route::Chapter(3),
        Route::Quiz(None),
        Route::Class {
            code: None,
            teams: Vec::new(),
            name: String::new(),
        },
        Route::Foil(FoilPage::default()),
        Route::Table,
        Route::Board(None),
        Route::Board(BoardCode::parse("2026-11-26").ok()),
        Route::Rules(Rules::Tournament),
        crate::tour::measured(),
        Route::Levels,
        Route::Progress,
        Route::Teacher,
        Route::Settings,
        Route::Page {
            chapter: 6,
            page: 4,
        },
        Route::Level(4),
    ];
    let topics = CourseKind::topics().map(CourseKind::Topic);
    let review = CourseKind::Review(vec!["equal-masses".into(), "both-moving".into()]);
    places.extend(
        CourseKind::ALWAYS
            .into_iter()
            .chain([review])
            .chain(topics)
            .map(|kind| {
                Route::Quiz(Some(Code {
                    course: Course::new(kind),
                    seed: 7,
                }))
            }),
    );
    places
}

/// Whether a screen shows a zero with a sign, such as "-0.0".
pub(crate) fn shows_negative_nothing(screen: &str) -> bool {
    screen.match_indices(['-', '−']).any(|(at, sign)| {
        let after = &screen[at + sign.len()..];
        let number = |c: char| c.is_ascii_digit() || c == '.';
        let figure = &after[..after.find(|c| !number(c)).unwrap_or(after.len())];
        let alone = !screen[..at].ends_with(char::is_alphanumeric);
        alone && figure.contains('.') && figure.parse() == Ok(0.0)
    })
}

fn opened(place: Route, charset: Charset, seed: u64) -> Headless {
    let settings = Settings {
        charset,
        ..Settings::default()
    };
    Headless::new(App::new(place, settings, seed), 80, 24)
}

/// One thing that may happen to an app.
#[derive(Debug, Clone)]
enum Act {
    Tell(Input),
    Resize(u16, u16),
    Pass(Duration),
}

fn key() -> impl Strategy<Value = Key> {
    use Key::*;
    let named = [
        Up, Down, Left, Right, Enter, Escape, Tab, BackTab, Backspace, Delete, PageUp, PageDown,
        Home, End,
    ];
    prop_oneof![
        6 => prop::char::range(' ', '~').prop_map(Char),
        6 => prop::sample::select(named.to_vec()),
        1 => any::<char>().prop_map(Char),
        1 => (1..=12u8).prop_map(F),
    ]
}

fn mouse() -> impl Strategy<Value = Mouse> {
    use MouseKind::*;
    let kinds = vec![Down, Drag, Up, ScrollUp, ScrollDown];
    (prop::sample::select(kinds), 0..310u16, 0..110u16)
        .prop_map(|(kind, column, row)| Mouse::over(kind, (column, row)))
}

fn act() -> impl Strategy<Value = Act> {
    prop_oneof![
        12 => key().prop_map(|key| Act::Tell(Input::Key(key))),
        4 => mouse().prop_map(|mouse| Act::Tell(Input::Mouse(mouse))),
        1 => any::<String>().prop_map(|text| Act::Tell(Input::Paste(text))),
        1 => (0..=300u16, 0..=100u16).prop_map(|(columns, rows)| Act::Resize(columns, rows)),
        1 => Just(Act::Resize(80, 24)),
        3 => (0..4000u64).prop_map(|ms| Act::Pass(Duration::from_millis(ms))),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(16, 64)))]

    #[test]
    fn no_input_and_no_size_makes_the_app_panic(
        place in prop::sample::select(places()),
        unicode: bool,
        seed: u64,
        acts in prop::collection::vec(act(), 1..60),
    ) {
        let charset = if unicode { Charset::Unicode } else { Charset::Ascii };
        let mut game = opened(place, charset, seed);
        for act in &acts {
            match act {
                Act::Tell(input) => game.input(input),
                Act::Resize(columns, rows) => game.resize(*columns, *rows),
                Act::Pass(time) => game.pass(*time),
            }
            let ascii = game.app().settings().charset == Charset::Ascii;
            let screen = game.screen();
            prop_assert!(!shows_negative_nothing(&screen), "{screen}");
            prop_assert!(!ascii || screen.bytes().all(|b| b == b'\n' || (b' '..=b'~').contains(&b)));
            prop_assert!(!screen.contains("NaN"));
        }
    }
}

#[test]
fn every_screen_and_its_help_are_printable_ascii() {
    for place in places() {
        for (columns, rows) in [(60, 20), (80, 24), (120, 40), (300, 100)] {
            let mut game = opened(place.clone(), Charset::Ascii, 1);
            game.resize(columns, rows);
            for keys in ["", "?", "<Down><Down>"] {
                game.press(keys);
                for cell in game.buffer().content() {
                    let symbol = cell.symbol().as_bytes();
                    assert!(
                        matches!(symbol, [b' '..=b'~']),
                        "{place:?} at {columns}x{rows} after {keys:?}: {symbol:?}"
                    );
                }
            }
        }
    }
}

/// The keys that lead from one step of a class round of three teams to the next.
const CLASS: [&str; 12] = [
    "<Enter>",
    "z",
    "z<Enter>",
    "<Enter>",
    "1",
    "<Enter><Enter>a2<Enter>1<Enter>",
    "<End><Enter>",
    "<Enter>",
    "<Enter>",
    "<Enter>",
    "<Enter>",
    "p",
];

fn class(code: &str, charset: Charset) -> Headless {
    let place = Route::Class {
        code: Code::parse(code),
        teams: ["Ants", "Bees", "Cats"].map(Into::into).into(),
        name: String::new(),
    };
    opened(place, charset, 1)
}

#[test]
fn every_step_of_a_class_round_is_complete_in_ascii() {
    for code in ["7", "speeds1-7", "from-picture1-7", "quick-3"] {
        for (columns, rows) in [(60, 20), (80, 24), (97, 31), (120, 40), (300, 100)] {
            let mut game = class(code, Charset::Ascii);
            game.resize(columns, rows);
            for keys in CLASS {
                game.press(keys);
                game.settle(Duration::from_secs(9));
                let screen = game.screen();
                let plain = screen
                    .bytes()
                    .all(|b| b == b'\n' || (b' '..=b'~').contains(&b));
                assert!(plain && !screen.contains("NaN"), "{code} {keys}\n{screen}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(6, 24)))]

    #[test]
    fn any_step_of_a_class_round_accepts_any_key_at_any_size(
        code in prop::sample::select(vec!["quick-3", "mixed-7", "speeds1-7", "7"]),
        unicode: bool,
        steps in 0..CLASS.len(),
        acts in prop::collection::vec(act(), 1..40),
    ) {
        let charset = if unicode { Charset::Unicode } else { Charset::Ascii };
        let mut game = class(code, charset);
        for keys in &CLASS[..steps] {
            game.press(keys);
        }
        for act in &acts {
            match act {
                Act::Tell(input) => game.input(input),
                Act::Resize(columns, rows) => game.resize(*columns, *rows),
                Act::Pass(time) => game.pass(*time),
            }
            prop_assert!(!game.screen().contains("NaN"));
        }
    }
}

#[test]
fn escape_leads_home_and_q_quits() {
    for place in places() {
        let mut game = opened(place.clone(), Charset::Ascii, 1);
        for _ in 0..6 {
            game.press("<Escape>");
            if game.screen().contains("Leave carrom?") {
                break;
            }
            if game.screen().contains("please choose") {
                game.press("y");
            }
        }
        game.press("n");
        assert!(game.screen().contains("carrom : home"), "{place:?}");
        game.press("q");
        assert!(game.has_quit());
    }
}
