//! Sessions of random keys, clicks, pastes and sizes.

use std::net::Ipv4Addr;
use std::time::Duration;

use carrom::class::protocol::ClientMessage;
use carrom::class::{SeatToken, Vote};
use carrom::messages::{HostNews, Input, JoinNews, Key, Mouse, MouseKind, Newcomer};
use carrom::screens::Settings;
use carrom::shells::Headless;
use carrom::widgets::input::KeyRow;
use carrom::widgets::{Charset, Depth, Palette};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use ratatui::buffer::Cell;

use crate::tour::TOUR;
use crate::{Fault, watched};

/// The largest number of inputs in a session.
const LONGEST: u64 = 2000;
/// The number of inputs between two frames.
const DRAWN: u64 = 100;
/// After this number of inputs, the keys with a meaning are looked up again even if nothing seems
/// to have changed.
const CAUGHT_UP: u64 = 10;

/// Plays the session with this number; returns the number of inputs, and the fault if there was
/// one. Prints each input, and any screen with forbidden text, if `told`.
pub(crate) fn play(number: u64, told: bool) -> (u64, Option<Fault>) {
    let mut inputs = 0;
    let played = watched_steps(number, told, &mut inputs);
    (inputs, played.err())
}

fn watched_steps(number: u64, told: bool, inputs: &mut u64) -> Result<(), Fault> {
    let mut chance = Pcg64Mcg::seed_from_u64(number);
    let settings = Settings {
        charset: *[Charset::Ascii, Charset::Unicode]
            .choose(&mut chance)
            .expect("two"),
        depth: *[Depth::None, Depth::Ansi16, Depth::True]
            .choose(&mut chance)
            .expect("three"),
        palette: *[Palette::Dark, Palette::Light]
            .choose(&mut chance)
            .expect("two"),
        reduced_motion: chance.random_bool(0.3),
        predict: chance.random_bool(0.8),
        ..Settings::default()
    };
    let stop = TOUR.choose(&mut chance).expect("the tour has stops");
    if told {
        println!("{}, {settings:?}", stop.name);
    }
    let mut game = watched(|| Ok(stop.game(settings)))?;
    let mut moment = Moment::of(&game);
    for step in 0..chance.random_range(10..=LONGEST) {
        if game.has_quit() {
            break;
        }
        *inputs += 1;
        let act = act(&moment, &mut chance);
        if told {
            println!("{step}: {act:?}");
        }
        // Another screen is usually opened by a key with a meaning; changes with other causes are
        // noticed after a few inputs.
        let is_meant = matches!(&act, Act::Tell(Input::Key(key)) if moment.means(key));
        let has_changed = watched(|| {
            match &act {
                Act::Tell(input) => game.input(input),
                Act::Resize(columns, rows) => game.resize(*columns, *rows),
                Act::Pass(time) => game.pass(*time),
            }
            if !is_meant && step % CAUGHT_UP != 0 {
                return Ok(false);
            }
            let before = std::mem::replace(&mut moment, Moment::of(&game));
            Ok(moment.screen != before.screen)
        });
        let at = |fault| format!("{fault} at input {step}, {act:?}");
        if has_changed.map_err(at)? || step % DRAWN == DRAWN - 1 {
            watched(|| look(&mut game, told)).map_err(at)?;
        }
    }
    match game.has_quit() {
        true => Ok(()),
        false => watched(|| look(&mut game, told)),
    }
}

/// The current state of the game.
struct Moment {
    /// The prefix of the names of this screen's keys.
    screen: String,
    /// The keys with a meaning on this screen.
    own: Vec<Key>,
    /// The keys with the same meaning on every screen.
    shared: Vec<Key>,
}

impl Moment {
    fn of(game: &Headless) -> Self {
        let table = game.app().keys();
        let first = table.rows().first();
        let screen = first.and_then(|row| row.id.split('.').next());
        let (shared, own): (Vec<_>, Vec<_>) =
            (table.rows().iter()).partition(|row| row.id.starts_with("everywhere."));
        let keys = |rows: Vec<&KeyRow<()>>| rows.into_iter().flat_map(KeyRow::all_keys).collect();
        Self {
            screen: screen.unwrap_or_default().into(),
            own: keys(own),
            shared: keys(shared),
        }
    }

    /// Whether a key has a meaning.
    fn means(&self, key: &Key) -> bool {
        self.own.contains(key) || self.shared.contains(key)
    }

    /// A random key with a meaning, usually one of the screen's own.
    fn meant(&self, chance: &mut Pcg64Mcg) -> Key {
        let keys = match chance.random_bool(0.1) {
            true => &self.shared,
            false => &self.own,
        };
        match keys.choose(chance).copied() {
            // This key ends the session, and most sessions should continue.
            Some(Key::Ctrl('c')) if chance.random_bool(0.8) => Key::Escape,
            key => key.unwrap_or(Key::Enter),
        }
    }
}

/// Draws the screen and checks it for forbidden text.
fn look(game: &mut Headless, told: bool) -> Result<(), Fault> {
    let is_ascii = game.app().settings().charset == Charset::Ascii;
    let is_strange = |c: &char| c.is_control() || (is_ascii && !c.is_ascii());
    let cells = &game.buffer().content;
    let mut letters = cells.iter().flat_map(|cell| cell.symbol().chars());
    let is_no_number = |cells: &[Cell]| cells.iter().map(Cell::symbol).eq(["N", "a", "N"]);
    let shown = match letters.find(is_strange) {
        Some(c) => format!("{c:?}"),
        None if cells.windows(3).any(is_no_number) => "NaN".into(),
        None => return Ok(()),
    };
    if told {
        println!("{}", game.screen());
    }
    Err(format!("the screen shows {shown}"))
}

/// An event in a session.
#[derive(Debug, Clone)]
enum Act {
    Tell(Input),
    Resize(u16, u16),
    Pass(Duration),
}

fn act(moment: &Moment, chance: &mut Pcg64Mcg) -> Act {
    use MouseKind::{Down, Drag, ScrollDown, ScrollUp, Up};
    let key = |key| Act::Tell(Input::Key(key));
    match chance.random_range(0..100) {
        0..45 => key(moment.meant(chance)),
        45..70 => key(Key::Char(chance.random_range(' '..='~'))),
        70..72 => key(Key::Char(chance.random())),
        72..80 => {
            let numbers = [
                "0", "-1", "45", "90", "1e9", "0.001", "-0", "99999999", ".", "1e-300",
            ];
            let text = numbers.choose(chance).copied().unwrap_or_default();
            Act::Tell(Input::Paste(text.into()))
        }
        80..92 => Act::Tell(Input::Mouse(Mouse {
            kind: *[Down, Down, Drag, Up, ScrollUp, ScrollDown]
                .choose(chance)
                .expect("six"),
            column: chance.random_range(0..130),
            row: chance.random_range(0..45),
            within: chance.random(),
        })),
        92 => Act::Tell(Input::Hosted(vec![host_news(chance)])),
        93 => Act::Tell(Input::Joined(join_news(chance))),
        94 => Act::Tell(Input::Paste(any_text(chance, 200))),
        95 => {
            let sizes = [(80, 24), (120, 40), (60, 20), (100, 30), (200, 60)];
            let (columns, rows) = sizes.choose(chance).copied().unwrap_or((80, 24));
            Act::Resize(columns, rows)
        }
        96 if chance.random_bool(0.1) => {
            Act::Resize(chance.random_range(0..300), chance.random_range(0..100))
        }
        97 => Act::Pass(Duration::from_millis(chance.random_range(0..2000))),
        _ => Act::Pass(Duration::from_millis(chance.random_range(0..100))),
    }
}

/// A random text of fewer than `most` characters.
fn any_text(chance: &mut Pcg64Mcg, most: usize) -> String {
    let letters = chance.random_range(0..most);
    (0..letters).map(|_| chance.random::<char>()).collect()
}

/// News that a host may receive from pupils, whatever it has asked them.
fn host_news(chance: &mut Pcg64Mcg) -> HostNews {
    let connection = chance.random_range(0..12);
    match chance.random_range(0..8) {
        0 => HostNews::Gone(connection),
        1 | 2 => HostNews::Came(Newcomer {
            connection,
            name: any_text(chance, 30),
            seat: (chance.random_bool(0.3)).then(|| SeatToken::of(chance.random_range(0..12))),
            fresh: SeatToken::of(chance.random_range(0..12)),
            address: Ipv4Addr::from(chance.random_range(0..3)).into(),
            at: Duration::from_millis(chance.random_range(0..1000)),
        }),
        _ => {
            let said = [
                "sure rays 60 still",
                "guess rays 30 60",
                "think choice 1",
                "sure number 1e300",
                "",
            ];
            let vote = ClientMessage::Vote {
                q: chance.random_range(0..3),
                vote: *Vote::BOTH.choose(chance).expect("two"),
                said: said.choose(chance).copied().unwrap_or_default().into(),
                n: chance.random_range(0..100),
            };
            HostNews::Said(connection, vote)
        }
    }
}

/// News that a pupil's carrom may receive from its connection to the host.
fn join_news(chance: &mut Pcg64Mcg) -> JoinNews {
    match chance.random_range(0..5) {
        0 => JoinNews::Reached,
        1 => JoinNews::Heard {
            text: any_text(chance, 30),
        },
        2 => JoinNews::Lost,
        3 => JoinNews::Remembered {
            seat: any_text(chance, 30),
            name: any_text(chance, 30),
        },
        _ => JoinNews::Awake,
    }
}
