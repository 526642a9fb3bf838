//! The first screen: where to go.

mod view;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::{Confirmation, Context, Next, Place, Screen};
use crate::messages::{Key, Mouse};
use crate::physics::CollisionSpec;
use crate::widgets::hit::{Overlay, Overlays, Watch};
use crate::widgets::input::{KeyTable, ListAction, ListView};

/// The first screen.
#[derive(Debug, Clone)]
pub(crate) struct Home {
    list: ListView,
    picture: Watch,
}

impl Default for Home {
    /// The first choice, beside a hit at its contact: the shot that everything here is
    /// explained on.
    fn default() -> Self {
        let worked_shot = CollisionSpec::default().collision();
        let layers = Overlays::default().without([Overlay::Triangle]);
        Self {
            list: ListView::default(),
            picture: Watch::told(worked_shot).with_layers(layers),
        }
    }
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

impl Entry {
    const fn new(key: char, name: &'static str, about: &'static str, place: Place) -> Self {
        Self {
            key,
            name,
            about,
            place,
        }
    }
}

static ENTRIES: [Entry; 8] = [
    Entry::new('e', "Learn", "chapters, read by doing", Place::Learn),
    Entry::new('l', "Lab", "one hit: set it, say, watch", Place::Lab),
    Entry::new(
        'z',
        "Quiz",
        "find out what you know",
        Place::Quiz { code: None },
    ),
    Entry::new(
        'c',
        "Class",
        "teams, one screen, two votes",
        Place::Class {
            code: None,
            teams: Vec::new(),
        },
    ),
    Entry::new('t', "Table", "carrom, every hit explained", Place::Table),
    Entry::new('v', "Levels", "puzzles, solved by aiming", Place::Levels),
    Entry::new('f', "Foil", "beams: from board to atom", Place::Foil),
    Entry::new('p', "Progress", "how far you have come", Place::Progress),
];

impl Screen for Home {
    type Action = HomeAction;

    fn title(&self) -> String {
        "home".into()
    }

    fn keys(&self, _cx: &Context) -> KeyTable<HomeAction> {
        let letters = ENTRIES.iter().map(|entry| entry.key);
        let letters = letters.zip((0..).map(HomeAction::Open));
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
            HomeAction::List(action) => {
                let outcome = self.list.act(action, ENTRIES.len());
                Next::of(outcome, |line| self.open(line))
            }
            HomeAction::Open(line) => self.open(line),
            HomeAction::Leave => Next::Confirm(Confirmation::new("Leave carrom?", "leave", "stay")),
            HomeAction::Quit => Next::Quit,
        }
    }

    fn confirmed(&mut self, _action: HomeAction, _cx: &mut Context) -> Next {
        Next::Quit
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let line = view::choice_at(cx.body, mouse.cell());
        let outcome = self.list.mouse(mouse, ENTRIES.len(), line);
        Next::of(outcome, |line| self.open(line))
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }
}
