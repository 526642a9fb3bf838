//! A tour of moments in which keys mean something: for the table of all keys, and
//! for the test that walks through them.

use std::collections::BTreeMap;

use super::Headless;
use crate::app::App;
use crate::messages::Key;
use crate::quiz::Code;
use crate::screens::{Place, Settings};
use crate::widgets::input::KeyTable;

/// One moment: where the game is opened, and the keys that lead there from that place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TourStop {
    /// What it is called.
    pub name: &'static str,
    /// The place, as in the command line: "quiz mixed-7".
    place: &'static str,
    /// The keys that lead there, as [`Headless::press`] takes them.
    keys: &'static str,
    /// Whether keys beside those of the table mean something there: letters that are typed, or
    /// any key at all, which closes the help.
    pub takes_any: bool,
}

const fn moment(name: &'static str, place: &'static str, keys: &'static str) -> TourStop {
    TourStop {
        name,
        place,
        keys,
        takes_any: false,
    }
}

impl TourStop {
    const fn taking_any(self) -> Self {
        Self {
            takes_any: true,
            ..self
        }
    }
}

/// Moments of every screen, not yet every phase of it.
pub const TOUR: &[TourStop] = &[
    moment("home", "home", ""),
    moment("contents of Learn", "learn", ""),
    moment("a page of a chapter", "chapter 2", ""),
    moment("a question of a chapter", "chapter 2", "<PageDown>"),
    moment("lab, setting up", "lab", ""),
    moment("lab, a number typed", "lab", "12"),
    moment("lab, saying where", "lab", "<Enter>"),
    moment("lab, watching", "lab", "<Enter>60<Enter>30<Enter>"),
    moment(
        "lab, a mystery coin",
        "lab",
        "m<Enter>60<Enter>30<Enter><Space>",
    ),
    moment("foil, tracks", "foil", ""),
    moment("foil, counts", "foil", "<Tab>"),
    moment("foil, 1913", "foil", "<Tab><Tab>"),
    moment("choosing a round", "quiz", ""),
    moment("quiz, rays", "quiz 7", ""),
    moment("quiz, a choice", "quiz separation-7", ""),
    moment("quiz, a number", "quiz speeds-7", ""),
    moment("quiz, a shot", "quiz make-it-so-7", ""),
    moment("quiz, how sure", "quiz 7", "60<Enter>30<Enter>"),
    moment("quiz, watching", "quiz 7", "60<Enter>30<Enter>2"),
    moment("quiz, told", "quiz 7", "60<Enter>30<Enter>2<Enter>"),
    moment("class, setting up", "class", "").taking_any(),
    moment("levels", "levels", ""),
    moment("a level, aiming", "level 4", ""),
    moment("a level, saying where", "level 4", "<Enter>"),
    moment("a level, watching", "level 4", "p<Enter>"),
    moment("a level, an impact", "level 4", "p<Enter><End>i"),
    moment("table, a new game", "table", ""),
    moment("table, aiming", "table", "<Enter>"),
    moment("table, a number typed", "table", "<Enter>9"),
    moment("table, calling", "table", "<Enter>c<Space>"),
    moment("table, watching", "table", "<Enter><Space>"),
    moment("table, a stroke at its end", "table", "<Enter><Space><End>"),
    moment("table, impacts", "table", "<Enter><Space><End>i"),
    moment("table, an impact", "table", "<Enter><Space><End>i<Enter>"),
    moment("table, practice", "table", "<Right><Right><Enter>"),
    moment("table, laying coins out", "table", "<Right><Right><Enter>p"),
    moment(
        "table, saved games",
        "table",
        "<Enter><Space><End><Escape>ys",
    ),
    moment("progress", "progress", ""),
    moment("help", "lab", "?").taking_any(),
    moment("a question", "home", "<Escape>"),
];

impl TourStop {
    /// The game at this moment, on a screen of 80 by 24.
    pub fn game(&self, settings: Settings) -> Headless {
        let (place, rest) = self.place.split_once(' ').unwrap_or((self.place, ""));
        let number = || rest.parse::<usize>().unwrap_or(1).saturating_sub(1);
        let place = match place {
            "learn" => Place::Learn,
            "chapter" => Place::Chapter { number: number() },
            "lab" => Place::Lab,
            "foil" => Place::Foil,
            "quiz" => Place::Quiz {
                code: Code::parse(rest),
            },
            "class" => Place::Class {
                code: None,
                teams: Vec::new(),
            },
            "levels" => Place::Levels,
            "level" => Place::Level { number: number() },
            "table" => Place::Table,
            "progress" => Place::Progress,
            _ => Place::Home,
        };
        let mut game = Headless::new(App::new(place, settings, 7), 80, 24);
        game.press(self.keys);
        game
    }

    /// The keys that mean something at this moment, as the player has them.
    pub fn keys(&self, settings: Settings) -> KeyTable<()> {
        self.game(settings).app().keys()
    }
}

/// Keys by their rows' names, each row with what it does.
pub type AllKeys = BTreeMap<String, (Vec<Key>, &'static str)>;

/// All keys there are, by their names in `keys.toml`: the keys that do it unless they are
/// rebound, and what it is.
pub fn all_keys() -> AllKeys {
    let mut all = BTreeMap::new();
    for moment in TOUR {
        for row in moment.keys(Settings::default()).rows() {
            let keys: Vec<Key> = row.keys().collect();
            let known = all
                .entry(row.id.clone())
                .or_insert((keys.clone(), row.help));
            if keys.len() > known.0.len() {
                known.0 = keys;
            }
        }
    }
    all
}
