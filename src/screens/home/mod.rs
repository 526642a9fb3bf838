//! The home screen: what to do next, and the menu.

mod suggestion;
mod view;

use strum::{EnumMessage, IntoStaticStr};

use super::recall::Recall;
use super::{Confirmation, Context, Next, Route, Screen, View};
use crate::messages::{Input, Key};
use crate::physics::CollisionSpec;
use crate::widgets::hit::{Overlay, Overlays, Watch};
use crate::widgets::input::{KeyTable, ListAction, ListView};
use suggestion::{Suggestion, suggestions};

#[derive(Debug, Clone)]
pub(crate) struct Home {
    list: ListView,
    picture: Watch,
    /// The player's answers so far; they are not requested while another screen is on top.
    history: Recall,
}

impl Default for Home {
    /// The first line is chosen; the picture shows the worked shot at its contact.
    fn default() -> Self {
        let worked_shot = CollisionSpec::default().collision();
        let layers = Overlays::default().without([Overlay::Triangle]);
        Self {
            list: ListView::default(),
            picture: Watch::revealed(worked_shot).with_layers(layers),
            history: Recall::Asked(0),
        }
    }
}

impl Home {
    /// Requests the player's answers.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        let mut home = Self::default();
        home.resumed(cx);
        home
    }

    fn suggestions(&self, cx: &Context) -> Vec<Suggestion> {
        suggestions(&self.history, cx)
    }

    /// Opens a line; lines are counted from the first suggestion.
    fn open(&mut self, line: usize, cx: &mut Context) -> Next {
        self.list.choose(line);
        let suggestions = self.suggestions(cx);
        Next::Open(match suggestions.get(line) {
            Some(suggestion) => suggestion.route(cx),
            None => ENTRIES[line - suggestions.len()].3.clone(),
        })
    }
}

/// Actions of the home screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum HomeAction {
    /// choose and open
    List(ListAction),
    /// follow the suggestion: read on, review what is due, find out what you believe
    Suggested(usize),
    /// open a menu entry by its letter
    Open(usize),
    /// quit carrom
    Quit,
    /// leave carrom, after confirming
    Leave,
}

/// Indices of some [`ENTRIES`].
const LEARN: usize = 0;
const LAB: usize = 1;
const CLASS: usize = 3;

/// The menu: the letter, the name, the description and the screen of each entry.
static ENTRIES: [(char, &str, &str, Route); 9] = [
    ('e', "Learn", "interactive chapters", Route::Learn),
    ('l', "Lab", "set up, predict, watch", Route::Lab),
    (
        'z',
        "Quiz",
        "find out what you know",
        Route::Quiz { code: None },
    ),
    (
        'c',
        "Class",
        "teams, one shared screen",
        Route::Class {
            code: None,
            teams: Vec::new(),
            name: String::new(),
        },
    ),
    ('t', "Table", "carrom, hits explained", Route::Table),
    ('v', "Levels", "puzzles, solved by aiming", Route::Levels),
    ('f', "Foil", "beams: from board to atom", Route::Foil),
    ('p', "Progress", "how far you have come", Route::Progress),
    ('s', "Settings", "colours, motion, player", Route::Settings),
];

impl Screen for Home {
    type Action = HomeAction;

    fn title(&self) -> String {
        "home".into()
    }

    fn keys(&self, cx: &Context) -> KeyTable<HomeAction> {
        let suggested = self.suggestions(cx);
        let suggested = suggested.iter().map(Suggestion::key);
        let letters = ENTRIES.iter().map(|(letter, ..)| *letter);
        let letters = letters.zip((0..).map(HomeAction::Open));
        KeyTable::new("home")
            .with(ListView::keys("open"), HomeAction::List)
            .on(Key::Char('q'), HomeAction::Quit, "quit")
            .each(suggested.zip((0..).map(HomeAction::Suggested)), "")
            .each(letters, "")
            // Earlier versions used this letter for the class.
            .or([(Key::Char('g'), HomeAction::Open(CLASS))])
            .on(Key::Escape, HomeAction::Leave, "")
    }

    fn about(&self, _cx: &Context) -> Vec<&'static str> {
        include_str!("help.txt").lines().collect()
    }

    fn act(&mut self, action: HomeAction, cx: &mut Context) -> Next {
        match action {
            HomeAction::List(action) => {
                let lines = self.suggestions(cx).len() + ENTRIES.len();
                let outcome = self.list.act(action, lines);
                Next::of(outcome, |line| self.open(line, cx))
            }
            HomeAction::Suggested(line) => self.open(line, cx),
            HomeAction::Open(entry) => self.open(self.suggestions(cx).len() + entry, cx),
            HomeAction::Leave => Next::Confirm(Confirmation::new("Leave carrom?", "leave", "stay")),
            HomeAction::Quit => Next::Quit,
        }
    }

    fn confirmed(&mut self, _action: HomeAction, _cx: &mut Context) -> Next {
        Next::Quit
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        self.act(HomeAction::List(ListAction::Choose(by.into())), cx)
    }

    fn input(&mut self, input: &Input, _cx: &mut Context) -> Next {
        match input {
            Input::Kept(answer) => {
                self.history.take(answer);
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn resumed(&mut self, cx: &mut Context) {
        cx.ask_for_marks();
        self.history = Recall::ask(cx);
        self.list = ListView::default();
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, HomeAction> {
        view::view(self, cx)
    }
}
