//! The home screen: what to do next, and the menu.

use strum::{EnumMessage, IntoStaticStr};

use super::ahead::Ahead;
use super::route::FoilPage;
use super::{Confirmation, Context, Next, Route, Screen, SharedAction, View};
use crate::messages::{Input, Key};
use crate::physics::{CollisionSpec, ImpactPoint};
use crate::widgets::hit::{Overlay, Overlays, Watch};
use crate::widgets::input::{KeyTable, ListAction, ListView};
use crate::widgets::panel::Panel;
use crate::widgets::{Role, Room, SplitLayout, text};

/// The width of the menu.
const MENU: u16 = 42;
/// The width of the menu without the descriptions.
const NARROW: u16 = 31;
const WIDE: u16 = 78;

#[derive(Debug, Clone)]
pub(crate) struct Home {
    list: ListView,
    picture: Watch,
    /// The next step; not requested while another screen is on top.
    ahead: Ahead,
}

impl Default for Home {
    /// The first line is chosen; the picture shows a collision at the moment of contact.
    fn default() -> Self {
        // A different angle from that of the lab's first shot, because the player should predict
        // the result of that shot.
        let alpha_deg = -50.0;
        let shot = CollisionSpec {
            point: ImpactPoint::Angle { alpha_deg },
            ..CollisionSpec::default()
        };
        let layers = Overlays::default().without([Overlay::Triangle]);
        Self {
            list: ListView::default(),
            picture: Watch::revealed(shot.collision()).with_layers(layers),
            ahead: Ahead::default(),
        }
    }
}

impl Home {
    /// The home screen; requests the player's record.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        let mut home = Self::default();
        home.resumed(cx);
        home
    }

    /// The lines: the class that the pupil left, the next step, then the menu.
    fn lines(&self, cx: &Context) -> Vec<HomeLine> {
        let class = cx.class.iter().map(|_| HomeLine::Class);
        let step = self.ahead.step().map(|_| HomeLine::Next);
        let entries = (0..ENTRIES.len()).map(HomeLine::Entry);
        class.chain(step).chain(entries).collect()
    }

    /// Opens a line.
    fn open(&mut self, line: HomeLine, cx: &mut Context) -> Next {
        let at = self.lines(cx).iter().position(|it| *it == line);
        self.list.choose(at.unwrap_or(0));
        match line {
            HomeLine::Class => cx.class.clone().map_or(Next::Stay, Next::Open),
            HomeLine::Next => self.ahead.follow(cx),
            HomeLine::Entry(entry) => Next::Open(ENTRIES[entry].3.clone()),
        }
    }
}

/// A line of the home screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HomeLine {
    /// Return to the class that the pupil left.
    Class,
    /// Open the next step.
    Next,
    /// An entry of the menu.
    Entry(usize),
}

/// Actions of the home screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum HomeAction {
    /// choose and open
    List(ListAction),
    /// take the next step: read on, review what is due, find out what you believe
    Suggested(HomeLine),
    /// open a menu entry by its letter
    Open(usize),
    /// quit carrom
    Quit,
    /// leave carrom, after confirming
    Leave,
}

/// The index of the class in [`ENTRIES`].
const CLASS_AT: usize = 3;

const FOIL: Route = Route::Foil(FoilPage::Tracks);
const CLASS: Route = Route::Class {
    code: None,
    teams: Vec::new(),
    name: String::new(),
};

/// The menu: the letter, the name, the description and the screen of each entry.
static ENTRIES: [(char, &str, &str, Route); 10] = [
    ('e', "Learn", "interactive chapters", Route::Learn),
    ('l', "Lab", "set up, predict, watch", Route::Lab),
    ('z', "Quiz", "find out what you know", Route::Quiz(None)),
    ('c', "Class", "phones, cards or teams", CLASS),
    ('t', "Table", "carrom, hits explained", Route::Table),
    ('v', "Levels", "puzzles, solved by aiming", Route::Levels),
    ('f', "Foil", "beams: from board to atom", FOIL),
    ('p', "Progress", "how far you have come", Route::Progress),
    ('h', "Teacher", "worksheets and reports", Route::Teacher),
    ('s', "Settings", "colours, motion, player", Route::Settings),
];

impl Screen for Home {
    type Action = HomeAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "home";

    fn status(&self, cx: &Context) -> String {
        text::clipped(&cx.settings.player, 24)
    }

    fn keys(&self, cx: &Context) -> KeyTable<HomeAction> {
        let next = HomeAction::Suggested(HomeLine::Next);
        let letters = ENTRIES.iter().map(|(letter, ..)| *letter);
        let letters = letters.zip((0..).map(HomeAction::Open));
        KeyTable::new("home")
            .with(ListView::keys("open"), HomeAction::List)
            .on(Key::Char('q'), HomeAction::Quit, "quit")
            .on('n', next, "next step")
            .or([(Key::Char('b'), next), (Key::Char('r'), next)])
            .when(self.ahead.step().is_some())
            .on('j', HomeAction::Suggested(HomeLine::Class), "")
            .when(cx.class.is_some())
            .each(letters, "")
            // Earlier versions used this letter for the class.
            .or([(Key::Char('g'), HomeAction::Open(CLASS_AT))])
            .on(Key::Escape, HomeAction::Leave, "")
    }

    fn act(&mut self, action: HomeAction, cx: &mut Context) -> Next {
        match action {
            HomeAction::List(action) => {
                let lines = self.lines(cx);
                let outcome = self.list.act(action, lines.len());
                Next::of(outcome, |line| self.open(lines[line], cx))
            }
            HomeAction::Suggested(line) => self.open(line, cx),
            HomeAction::Open(entry) => self.open(HomeLine::Entry(entry), cx),
            HomeAction::Leave => Next::Confirm(Confirmation::new("Leave carrom?", "leave", "stay")),
            HomeAction::Quit => Next::Shared(SharedAction::Quit),
        }
    }

    fn confirmed(&mut self, _action: HomeAction, _cx: &mut Context) -> Next {
        Next::Shared(SharedAction::Quit)
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        self.act(HomeAction::List(ListAction::Choose(by.into())), cx)
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        self.ahead.input(input, cx)
    }

    fn resumed(&mut self, cx: &mut Context) {
        self.ahead.ask_again(cx);
        self.list = ListView::default();
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, HomeAction> {
        let hit = |area| self.picture.picture(area);
        View::drawn("a glancing hit", hit, menu(self, cx)).laid_out(layout)
    }
}

fn layout(room: Room) -> SplitLayout {
    let menu = if room.area.width < WIDE { NARROW } else { MENU };
    SplitLayout::with_open_panel(room, menu)
}

fn menu(home: &Home, cx: &Context) -> Panel<HomeAction> {
    let lines = home.lines(cx);
    let chosen = home.list.chosen(lines.len());
    let mut panel = Panel::new("");
    panel.worth(2, |panel| {
        panel.line("Aim. Predict where both go.", Role::Text);
        panel.line("Then watch, and read why.", Role::Text);
        panel.gap();
    });
    for (at, line) in lines.into_iter().enumerate() {
        let point = HomeAction::List(ListAction::Point(at));
        let style = |role| (role, at == chosen);
        match line {
            HomeLine::Class => {
                panel.entry('j', ("Back to your class", ""), style(Role::Key), point);
                panel.gap();
            }
            HomeLine::Next => {
                if let Some(next) = home.ahead.step() {
                    panel.entry('n', (&*next.words, ""), style(Role::Key), point);
                    panel.paragraph(&next.why, Role::Dim);
                    panel.gap();
                }
            }
            HomeLine::Entry(entry) => {
                let (letter, name, about, _) = &ENTRIES[entry];
                panel.entry(*letter, (*name, *about), style(Role::Text), point);
            }
        }
    }
    panel.worth(1, |panel| {
        panel.gap();
        home.ahead.write_done(panel);
    });
    panel
}
