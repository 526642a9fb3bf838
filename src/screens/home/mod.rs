//! The first screen: where to go.

mod view;

use glam::DVec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::{Confirmation, Context, Next, Place, Screen};
use crate::messages::{Input, Key};
use crate::physics::{Collision, Disc};
use crate::widgets::Outcome;
use crate::widgets::hit::{Overlay, Overlays, Watch};
use crate::widgets::input::{KeyTable, ListAction, ListView};

/// The first screen.
#[derive(Debug, Clone)]
pub(crate) struct Home {
    list: ListView,
    picture: Watch,
}

impl Default for Home {
    /// The first choice, beside a hit at its contact.
    fn default() -> Self {
        let mut layers = Overlays::default();
        layers.toggle(Overlay::Triangle);
        Self {
            list: ListView::default(),
            picture: Watch::new(worked_shot(), None, true).with_layers(layers),
        }
    }
}

/// 15 g on 15 g at 4 m/s and 30°: the shot that everything here is explained on.
fn worked_shot() -> Collision {
    let disc = Disc::from_g_mm(15.0, 15.0);
    Collision::at_angle(disc, disc, DVec2::new(4.0, 0.0), 30_f64.to_radians())
}

impl Home {
    fn open(&mut self, line: usize) -> Next {
        self.list.choose(line);
        Next::Open(ENTRIES[line].place.clone())
    }
}

/// What keys do on the first screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum HomeAction {
    /// choose and open
    List(ListAction),
    /// open a line of the menu by its letter
    Open(usize),
    /// leave carrom
    Quit,
    /// leave carrom, if you are sure
    Leave,
}

/// Where the class stands among the [`ENTRIES`].
const CLASS: usize = 3;

/// A line of the menu.
struct Entry {
    key: char,
    name: &'static str,
    about: &'static str,
    place: Place,
}

static ENTRIES: [Entry; 8] = [
    Entry {
        key: 'e',
        name: "Learn",
        about: "chapters, read by doing",
        place: Place::Learn,
    },
    Entry {
        key: 'l',
        name: "Lab",
        about: "one hit: set it, say, watch",
        place: Place::Lab,
    },
    Entry {
        key: 'z',
        name: "Quiz",
        about: "find out what you know",
        place: Place::Quiz { code: None },
    },
    Entry {
        key: 'c',
        name: "Class",
        about: "teams, one screen, two votes",
        place: Place::Class {
            code: None,
            teams: Vec::new(),
        },
    },
    Entry {
        key: 't',
        name: "Table",
        about: "carrom, every hit explained",
        place: Place::Table,
    },
    Entry {
        key: 'v',
        name: "Levels",
        about: "puzzles, solved by aiming",
        place: Place::Levels,
    },
    Entry {
        key: 'f',
        name: "Foil",
        about: "beams: from board to atom",
        place: Place::Foil,
    },
    Entry {
        key: 'p',
        name: "Progress",
        about: "how far you have come",
        place: Place::Progress,
    },
];

impl Screen for Home {
    type Action = HomeAction;

    fn title(&self) -> String {
        "home".into()
    }

    fn keys(&self, _cx: &Context) -> KeyTable<HomeAction> {
        let letters = (0..).zip(ENTRIES.iter().map(|entry| entry.key));
        let letters = letters.map(|(i, key)| (Key::Char(key), HomeAction::Open(i)));
        KeyTable::new("home")
            .with(ListView::keys("open"), HomeAction::List)
            .on(Key::Char('q'), HomeAction::Quit, "quit")
            .each(letters, "")
            // What the class had before its own letter was free.
            .or([(Key::Char('g'), HomeAction::Open(CLASS))])
            .on(Key::Escape, HomeAction::Leave, "")
    }

    fn about(&self, _cx: &Context) -> Vec<&'static str> {
        vec![
            "carrom teaches one thing well: what happens when one disc hits another off-centre.",
            "Everywhere in it you first say what will happen, then watch the exact hit, then read why. A wrong prediction is the best start there is.",
            "New here? Open the lab and press Enter: a hit in a minute. Then read the first chapter of Learn.",
        ]
    }

    fn act(&mut self, action: HomeAction, _cx: &mut Context) -> Next {
        match action {
            HomeAction::List(action) => match self.list.act(action, ENTRIES.len()) {
                Outcome::Done(line) => self.open(line),
                _ => Next::Stay,
            },
            HomeAction::Open(line) => self.open(line),
            HomeAction::Leave => Next::Confirm(Confirmation::new("Leave carrom?", "leave", "stay")),
            HomeAction::Quit => Next::Quit,
        }
    }

    fn confirmed(&mut self, _action: HomeAction, _cx: &mut Context) -> Next {
        Next::Quit
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        let Input::Mouse(mouse) = input else {
            return Next::Ignored;
        };
        let line = view::choice_at(cx.body, mouse.column, mouse.row);
        match self.list.mouse(mouse, ENTRIES.len(), line) {
            Outcome::Done(line) => self.open(line),
            Outcome::Used => Next::Stay,
            Outcome::Ignored => Next::Ignored,
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }
}
