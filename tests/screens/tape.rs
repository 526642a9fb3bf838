//! Tapes: their instructions, the errors of invalid ones, and their screenshots.

use std::time::Duration;

use carrom::app::App;
use carrom::cli;
use carrom::messages::{Key, Mouse, MouseKind};
use carrom::screens::{Context, Hosted, Next, Route, Screen, Settings, View};
use carrom::shells::tape::{ParseError, PlayError, PlayFault, Screenshot, Tape, play};
use carrom::widgets::input::KeyTable;
use ratatui::layout::Rect;
use ratatui::style::Style;

fn tape(text: &str) -> Tape {
    Tape::parse(text).unwrap()
}

fn played(text: &str) -> Result<Vec<Screenshot>, PlayError> {
    play(&tape(text), cli::open)
}

#[test]
fn an_empty_tape_plays() {
    assert_eq!(played(""), Ok(vec![]));
    assert_eq!(played("\n   \n# nothing\r\n"), Ok(vec![]));
}

#[test]
fn the_same_tape_gives_the_same_bytes() {
    let text = "Set Charset unicode\nSet Color truecolor\nScreenshot a\nType \"?\"\nScreenshot b";
    let once = played(text).unwrap();
    let again = played(text).unwrap();
    assert_eq!(once.len(), 2);
    for (a, b) in once.iter().zip(&again) {
        assert_eq!((&a.name, a.text(), a.svg()), (&b.name, b.text(), b.svg()));
    }
}

#[test]
fn a_screenshot_has_every_row_and_no_blanks_at_their_ends() {
    let shots = played("Set Size 100x30\nScreenshot wide").unwrap();
    let text = shots[0].text();
    assert_eq!(text.lines().count(), 30);
    assert!(text.ends_with('\n'));
    assert!(text.lines().all(|line| line == line.trim_end()));
    assert!(shots[0].svg().contains("width=\"900\" height=\"540\""));
}

#[test]
fn bad_tapes_are_refused_with_line_and_reason() {
    let count = "a count from 1 to 10000";
    for (text, line, message) in [
        ("\nDance", 2, "unknown instruction Dance; expected Run, Set"),
        ("\"Type\"", 1, "expected an instruction, found \"Type\""),
        ("Type", 1, "Type: expected a text in quotes, found nothing"),
        (
            "Type 60",
            1,
            "expected a text in quotes, found 60 without quotes",
        ),
        ("Type \"\"", 1, "Type: expected a text that is not empty"),
        ("Type \"60", 1, "expected a closing double quote"),
        (
            "Expect \"a\" \"b\"",
            1,
            "Expect: expected a text in quotes, found \"a\" \"b\"",
        ),
        ("Right 0", 1, count),
        ("Right -1", 1, count),
        ("Right +1", 1, count),
        ("Right 10001", 1, count),
        ("Right 99999999999999999999", 1, count),
        ("Right \"1\"", 1, count),
        (
            "Right 1 2",
            1,
            "Right: expected at most one count, found 1 2",
        ),
        (
            "Set",
            1,
            "Set: expected Size, Charset, Color or Day with a value, found nothing",
        ),
        (
            "Set Speed 3",
            1,
            "Set: expected Size, Charset, Color or Day",
        ),
        (
            "Set Day 5",
            1,
            "Set Day: expected a day, such as 2026-01-05",
        ),
        ("Set Day 2026-02-30", 1, "Set Day: expected a day"),
        ("Set Day 1969-01-05", 1, "Set Day: expected a day"),
        ("Set Size 80", 1, "Set Size: expected columns x rows"),
        ("Set Size 80x-1", 1, "Set Size: expected columns x rows"),
        ("Set Size 80x1001", 1, "Set Size: expected columns x rows"),
        (
            "Set Charset utf8",
            1,
            "Set Charset: expected ascii or unicode, found utf8",
        ),
        (
            "Set Color red",
            1,
            "Set Color: expected none, 16, 256 or truecolor, found red",
        ),
        (
            "Click 40",
            1,
            "expected a cell as column,row such as 40,12, found 40",
        ),
        ("Click 40,12,3", 1, "expected a cell as column,row"),
        (
            "Drag 1,2",
            1,
            "Drag: expected two cells, such as 40,12 44,12, found 1,2",
        ),
        ("Scroll left", 1, "Scroll: expected up or down"),
        ("Sleep 3", 1, "Sleep: expected a time of at most 3600s"),
        ("Sleep -3s", 1, "Sleep: expected a time of at most 3600s"),
        ("Sleep infs", 1, "Sleep: expected a time of at most 3600s"),
        ("Sleep 1e9s", 1, "Sleep: expected a time of at most 3600s"),
        ("Sleep 3601s", 1, "Sleep: expected a time of at most 3600s"),
        ("Sleep .s", 1, "Sleep: expected a time of at most 3600s"),
        (
            "Screenshot ../x",
            1,
            "Screenshot: expected a name of at most 64 letters",
        ),
        (
            "Screenshot a/b",
            1,
            "Screenshot: expected a name of at most 64 letters",
        ),
        (
            "Screenshot .",
            1,
            "Screenshot: expected a name of at most 64 letters",
        ),
        (
            "Screenshot \"\"",
            1,
            "Screenshot: expected a name of at most 64 letters",
        ),
        (
            "Screenshot a\nScreenshot A",
            2,
            "Screenshot: the name A is taken by line 1",
        ),
        (
            "Escape\nRun \"lab\"",
            2,
            "Run must be the first instruction",
        ),
        (
            "Run \"lab\"\nRun \"lab\"",
            2,
            "Run must be the first instruction",
        ),
        (
            "Run lab",
            1,
            "expected the arguments in quotes, found lab without quotes",
        ),
    ] {
        match Tape::parse(text) {
            Ok(_) => panic!("{text:?} is accepted"),
            Err(ParseError {
                line: l,
                message: m,
            }) => {
                assert_eq!(l, line, "{text:?}");
                assert!(m.contains(message), "{text:?}: {m}");
            }
        }
    }
}

#[test]
fn a_long_tape_is_refused() {
    let noise = "\u{1}".repeat(10 << 20);
    assert!(Tape::parse(&noise).is_err());
}

#[test]
fn a_failed_expectation_shows_line_and_screen() {
    let error = played("# first\nExpect \"90.0\"").unwrap_err();
    assert_eq!(error.line, 2);
    assert!(matches!(&error.fault, PlayFault::Expect { text, .. } if text == "90.0"));
    let message = error.to_string();
    assert!(message.starts_with("2: Expect: the screen does not show \"90.0\"\n"));
    assert!(message.contains("carrom : home"));

    let error = played("Refuse \"home\"").unwrap_err();
    assert_eq!(error.line, 1);
    assert!(matches!(error.fault, PlayFault::Refuse { .. }));
}

#[test]
fn unusable_arguments_are_reported() {
    let error = played("# first\nRun \"lab --sed 3\"").unwrap_err();
    assert_eq!(error.line, 2);
    assert!(matches!(error.fault, PlayFault::Run(reason) if reason.contains("'--sed'")));
}

#[test]
fn nothing_can_follow_after_carrom_has_quit() {
    let error = played("Type \"q\"\nScreenshot late").unwrap_err();
    let fault = PlayFault::Left(1);
    assert_eq!(error, PlayError { line: 2, fault });
}

/// A screen that records every input and shows it.
#[derive(Default)]
struct Notes(String);

impl Screen for Notes {
    type Action = ();
    const HELP: &'static str = "";
    const TITLE: &'static str = "notes";
    fn keys(&self, _: &Context) -> KeyTable<()> {
        KeyTable::new("notes")
    }
    fn typed(&mut self, key: Key, _: &mut Context) -> bool {
        self.0 += &match key {
            Key::Char(letter) => letter.to_string(),
            key => format!("<{key}>"),
        };
        true
    }
    fn act(&mut self, (): (), _: &mut Context) -> Next {
        Next::Stay
    }
    fn point(&mut self, mouse: &Mouse, _: Rect, _: &mut Context) -> Next {
        let kind = match mouse.kind {
            MouseKind::Down => "down",
            MouseKind::Drag => "drag",
            MouseKind::Up => "up",
            MouseKind::ScrollUp => "wheel-up",
            MouseKind::ScrollDown => "wheel-down",
        };
        self.0 += &format!("<{kind} {},{}>", mouse.column, mouse.row);
        Next::Stay
    }
    fn advance(&mut self, passed: Duration, _: &mut Context) {
        self.0 += &format!("<{} ms>", passed.as_millis());
    }
    fn wake(&self, _: &Context) -> Option<Duration> {
        Some(Duration::from_millis(400))
    }
    fn view<'s>(&'s self, _: &'s Context) -> View<'s, ()> {
        View::picture_alone(|area, buf, _| {
            buf.set_stringn(area.x, area.y, &self.0, area.width.into(), Style::new());
        })
    }
}

#[test]
fn each_instruction_does_what_it_says() {
    for (instructions, noted) in [
        ("Type \"6\\\"\\n\\t\"", "6\"<Enter><Tab>"),
        (
            "Right 3\nShift+Tab\nspace\nF2",
            "<Right><Right><Right><Shift+Tab> <F2>",
        ),
        ("Click 40,12", "<down 40,12><up 40,12>"),
        ("Drag 40,12 44,13", "<down 40,12><drag 44,13><up 44,13>"),
        ("Scroll down 2", "<wheel-down 40,12><wheel-down 40,12>"),
        ("Scroll up 1 3,4", "<wheel-up 3,4>"),
        ("Sleep 1s", "<400 ms><400 ms><200 ms>"),
        ("Sleep 200ms\nType \"x\"", "<200 ms>x"),
        ("Sleep 0s", ""),
    ] {
        let open = |_: &str| {
            let screen = Box::new(Hosted::new(Notes::default()));
            Ok(App::on(screen, Settings::default(), 1))
        };
        let text = format!("{instructions}\nScreenshot s");
        let shots = play(&tape(&text), open).unwrap();
        let text = shots[0].text();
        assert_eq!(text.lines().nth(1), Some(noted), "{instructions}");
    }
}

#[test]
fn settings_reach_the_app() {
    let open = |arguments: &str| {
        assert_eq!(arguments, "lab --seed 3");
        Ok(App::new(Route::Home, Settings::default(), 3))
    };
    let text = "Run \"lab --seed 3\"\nSet Size 40x10\nScreenshot s";
    let shots = play(&tape(text), open).unwrap();
    assert!(shots[0].text().contains("this is 40x10"));
}
