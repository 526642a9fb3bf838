//! The player's progress: errors over time, the state of each topic, whether confidence
//! matches the answers, which misconceptions fade, and what to do next.

mod beliefs;
mod over_time;
mod sure;
mod topics;

use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr, VariantArray};

use super::ahead::Ahead;
use super::view::View;
use super::{Context, Next, Route, Screen};
use crate::gradebook::HandIn;
use crate::messages::{History, Input, Key, Mouse, MouseKind};
use crate::numbers::counted;
use crate::progress::ObservationCounts;
use crate::widgets::input::KeyTable;
use crate::widgets::panel::Panel;
use crate::widgets::picture::Picture;
use crate::widgets::{Lines, Look, Role, Room, SplitLayout, text};

/// Actions of the progress screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum ProgressAction {
    /// go to the next or previous page
    Turn(isize),
    /// open a page: over time, topics, how sure, how sure over time, beliefs
    TurnTo(usize),
    /// scroll a text that is longer than its panel
    Scroll(i16),
    /// take the next step: a page of a chapter, a review, a level
    DoNext,
    /// hand in every answer, as one small file for a teacher
    HandIn,
    /// go back
    Back,
}

/// The minimum number of columns for a panel of the usual width.
const NARROW: u16 = 80;
/// The width of the panel on a narrow screen, where the tables need the room.
const NARROW_PANEL: u16 = 26;

#[derive(Debug, Clone, Copy, PartialEq, Eq, VariantArray)]
enum ProgressPage {
    /// The errors of the answers over time.
    OverTime,
    Topics,
    /// Whether confidence matches the answers.
    Sure,
    /// Whether confidence matches the answers, over time.
    SureOverTime,
    /// The player's misconceptions.
    Beliefs,
}

impl ProgressPage {
    /// The page `steps` pages after this one; the first page follows the last.
    fn beside(self, steps: isize) -> Self {
        let count = Self::VARIANTS.len() as isize;
        let at = (self as isize + steps).rem_euclid(count);
        Self::VARIANTS[at as usize]
    }

    /// The titles of the picture and of the panel.
    const fn titles(self) -> (&'static str, &'static str) {
        match self {
            Self::OverTime => ("1 how far off, over time", "summary"),
            Self::Topics => ("2 topics", "what is due"),
            Self::Sure => ("3 how sure, and how right", "what it shows"),
            Self::SureOverTime => ("4 how sure, over time", "how to read it"),
            Self::Beliefs => ("5 what you believed", "what helps"),
        }
    }
}

#[derive(Debug, Clone)]
pub(crate) struct Progress {
    ahead: Ahead,
    page: ProgressPage,
}

impl Progress {
    /// Requests the player's record.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        Self {
            ahead: Ahead::ask(cx),
            page: ProgressPage::OverTime,
        }
    }

    /// The player's answers, if there are any.
    fn history(&self) -> Option<&History> {
        self.ahead.history.history()
    }

    /// The same view with the next step at the end.
    fn with_next_step<'s>(&self, mut view: View<'s, ProgressAction>) -> View<'s, ProgressAction> {
        view.second.worth(1, |second| second.heading("What next"));
        self.ahead.write(ProgressAction::DoNext, &mut view.second);
        view.laid_out(layout)
    }

    /// Writes the file that the player hands in to a teacher.
    fn hand_in(&self, cx: &mut Context) {
        let Some(history) = self.history() else {
            return;
        };
        let hand_in = HandIn::new(&cx.settings.player, "", history.attempts.clone());
        match hand_in.text() {
            Ok(text) => cx.export(hand_in.file_name(), text),
            Err(reason) => cx.notify(format!("The file could not be written: {reason}")),
        }
    }
}

/// The panel has its usual width only on a wide screen; otherwise the tables need the room.
fn layout(room: Room) -> SplitLayout {
    match room.area.width < NARROW {
        true => SplitLayout::with_panel(room, NARROW_PANEL),
        false => SplitLayout::new(room),
    }
}

/// The text for a player without answers.
fn nothing_yet(panel: &mut Panel<ProgressAction>) {
    for text in [
        "There is nothing here yet: every game starts with a clean board.",
        "Answer a few questions of the quiz, then come back. Here you will see your answers \
         come closer to the true values.",
    ] {
        panel.gap();
        panel.paragraph(text, Role::Text);
    }
}

/// A picture, or the reason why there is none.
type Plotted = Result<Picture, &'static str>;

impl Screen for Progress {
    type Action = ProgressAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "progress";
    const ROUTE: Route = Route::Progress;

    fn status(&self, cx: &Context) -> String {
        let player = text::clipped(&cx.settings.player, 24);
        match self.history() {
            Some(history) => format!("{player}   {}", counted(history.attempts.len(), "answer")),
            None => player,
        }
    }

    fn keys(&self, _cx: &Context) -> KeyTable<ProgressAction> {
        use ProgressAction::{Back, DoNext, HandIn, Scroll, Turn, TurnTo};
        let pages = ('1'..).zip((0..ProgressPage::VARIANTS.len()).map(TurnTo));
        let some = self.history().is_some();
        KeyTable::new("progress")
            .on(Key::Tab, Turn(1), "next page")
            .or([(Key::Right, Turn(1)), (Key::BackTab, Turn(-1))])
            .or([(Key::Left, Turn(-1))])
            .when(some)
            .each(pages, "page")
            .when(some)
            .each([(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))], "scroll")
            .when(some)
            .on(Key::Enter, DoNext, "next step")
            .when(self.ahead.step().is_some())
            .on('h', HandIn, "hand in")
            .when(some)
            .on(Key::Escape, Back, "back")
    }

    fn act(&mut self, action: ProgressAction, cx: &mut Context) -> Next {
        match action {
            ProgressAction::Turn(by) => self.page = self.page.beside(by),
            ProgressAction::TurnTo(page) => self.page = ProgressPage::VARIANTS[page],
            ProgressAction::Scroll(rows) => return Next::scroll(rows),
            ProgressAction::DoNext => return self.ahead.follow(cx),
            ProgressAction::HandIn => self.hand_in(cx),
            ProgressAction::Back => return Next::Back,
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Exported(exported) => {
                cx.notify_of_export("file to hand in", exported);
                Next::Stay
            }
            input => self.ahead.input(input, cx),
        }
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, ProgressAction> {
        let (book, page) = (&cx.book, self.page);
        let Some(history) = self.history() else {
            let mut first = Panel::new("your progress");
            match self.ahead.history.unknown() {
                Some((words, role)) => first.paragraph(words, role),
                None => nothing_yet(&mut first),
            }
            let seen = self.ahead.history.observations();
            for words in ObservationCounts::new(seen).words() {
                first.gap();
                first.paragraph(words, Role::Text);
            }
            return self.with_next_step(View::panels(first, Panel::new("")));
        };
        let (title, beside) = page.titles();
        let (mut first, mut second) = (Panel::new(title), Panel::new(beside));
        let plot: Option<fn(&History, Rect, Look) -> Plotted> = match page {
            ProgressPage::OverTime => {
                over_time::panel(history, &mut second);
                self.ahead.write_done(&mut second);
                Some(over_time::plot)
            }
            ProgressPage::SureOverTime => {
                sure::panel_over_time(history, &mut second);
                Some(sure::plot_over_time)
            }
            ProgressPage::Topics => {
                topics::table(history, book, &cx.settings.look(), &mut first);
                topics::panel(history, &mut second);
                None
            }
            ProgressPage::Sure => {
                sure::table(history, &mut first);
                sure::panel(history, &mut second);
                None
            }
            ProgressPage::Beliefs => {
                let columns = layout(cx.body.into()).picture.width;
                beliefs::table(history, columns, &mut first);
                beliefs::panel(history, &mut second);
                None
            }
        };
        second.gap();
        let Some(plot) = plot else {
            return self.with_next_step(View::panels(first, second));
        };
        let draw = move |area, buf: &mut _, look: &_| match plot(history, area, *look) {
            Ok(picture) => picture.draw(buf, look),
            Err(why) => Lines::new(area, buf, *look).paragraph(why, Role::Text),
        };
        self.with_next_step(View::picture(title, draw, second))
    }

    fn point(&mut self, mouse: &Mouse, _picture: Rect, _cx: &mut Context) -> Next {
        if mouse.kind != MouseKind::Down {
            return Next::Ignored;
        }
        self.page = self.page.beside(1);
        Next::Stay
    }

    fn resumed(&mut self, cx: &mut Context) {
        self.ahead.ask_again(cx);
    }
}
