//! What the player has done so far: how far off the answers were as time went by, how
//! each topic stands, whether confidence and answers go together, which misconceptions
//! fade, and what to do next.

mod beliefs;
mod over_time;
mod page;
mod sure;
mod sure_over_time;
mod topics;
mod words;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::recall::Recall;
use super::{Context, Next, Place, Screen, leads};
use crate::gradebook::HandIn;
use crate::lessons::Book;
use crate::messages::{History, Input, Key, Mouse, MouseKind};
use crate::numbers::counted;
use crate::progress::Due;
use crate::quiz::{Code, Course, CourseKind, Passage};
use crate::widgets::input::KeyTable;
use crate::widgets::{Lines, Role, Scroll, SplitLayout, scroll_keys};
use page::ProgressPage;

/// What keys do on the progress screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum ProgressAction {
    /// next page; Left for the page before
    Turn(isize),
    /// over time, topics, how sure, that over time, beliefs
    TurnTo(usize),
    /// scroll what is longer than its place; PageUp and PageDown by eight rows
    Scroll(i16),
    /// do what the page suggests: a review, the page of a chapter, a round of the quiz
    DoNext,
    /// hand in every answer: one small file for a teacher
    HandIn,
    /// go back
    Back,
}

/// What is to be done next, by the page that is shown.
enum NextStep {
    /// A review of what is due.
    Review(CourseKind),
    /// The page that settles what is still believed.
    Read(Passage),
    /// A round of the quiz, to be chosen.
    Choose,
}

impl NextStep {
    /// What Enter does, in a line.
    fn words(&self, book: &Book) -> String {
        match self {
            Self::Review(kind) => {
                format!("Enter: review {}.", counted(kind.length(), "topic"))
            }
            Self::Read(passage) => {
                let page = book.named(*passage).unwrap_or_default();
                format!("Enter: read {page}.")
            }
            Self::Choose => "Enter: choose a round of the quiz.".into(),
        }
    }

    /// The same in a word or two.
    const fn name(&self) -> &'static str {
        match self {
            Self::Review(_) => "review",
            Self::Read(_) => "its chapter",
            Self::Choose => "quiz",
        }
    }
}

/// Columns from which on the panel need not be narrow.
const NARROW: u16 = 80;
/// Columns of the panel on a narrow screen, where the tables need the room.
const NARROW_PANEL: u16 = 26;

/// The screen.
#[derive(Debug, Clone)]
pub(crate) struct Progress {
    history: Recall,
    page: ProgressPage,
    scroll: Scrolls,
}

/// How far both sides are scrolled.
#[derive(Debug, Clone, Copy, Default)]
struct Scrolls {
    picture: Scroll,
    panel: Scroll,
}

impl Progress {
    /// The screen, with what the player has done asked for.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        cx.ask_for_marks();
        Self {
            history: Recall::ask(cx),
            page: ProgressPage::OverTime,
            scroll: Scrolls::default(),
        }
    }

    /// What was done, where there is something.
    fn history(&self) -> Option<&History> {
        self.history.history()
    }

    /// What Enter does on this page.
    fn next_step(&self) -> NextStep {
        let step = self.history().and_then(|history| match self.page {
            ProgressPage::Topics => {
                let due = Due::of(&history.attempts, &history.calendar);
                due.course().map(NextStep::Review)
            }
            ProgressPage::Beliefs => {
                let held = beliefs::held(history)?;
                Some(NextStep::Read(held.misconception.settled_by()))
            }
            _ => None,
        });
        step.unwrap_or(NextStep::Choose)
    }

    /// Writes the file for a teacher.
    fn hand_in(&self, cx: &mut Context) {
        let Some(history) = self.history() else {
            return;
        };
        let hand_in = HandIn::new(&cx.settings.player, "", history.attempts.clone());
        match hand_in.text() {
            Ok(text) => cx.export(hand_in.file_name(), text),
            Err(reason) => cx.tell(format!("The file could not be written: {reason}")),
        }
    }

    fn turn_to(&mut self, page: ProgressPage) {
        self.page = page;
        self.scroll = Scrolls::default();
    }

    /// Where both parts are. Only pictures have sizes of their own.
    fn layout(&self, cx: &Context) -> SplitLayout {
        let room = match self.page {
            ProgressPage::OverTime | ProgressPage::SureOverTime => cx.room(),
            _ => cx.body.into(),
        };
        match room.area.width < NARROW {
            true => SplitLayout::with_panel(room, NARROW_PANEL),
            false => SplitLayout::new(room),
        }
    }

    fn scroll_by(&mut self, rows: i16, cx: &Context) {
        let look = cx.settings.look();
        let layout = self.layout(cx);
        let table = |lines: &mut Lines| self.table(&cx.book, lines);
        let panel = |lines: &mut Lines| self.panel(&cx.book, lines);
        self.scroll = Scrolls {
            picture: self.scroll.picture.by(rows, layout.picture, look, table),
            panel: self.scroll.panel.by(rows, layout.panel, look, panel),
        };
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &Context) -> Next {
        match (mouse.wheel(), mouse.kind) {
            (Some(by), _) => self.scroll_by(-i16::from(by), cx),
            (None, MouseKind::Down) => self.turn_to(self.page.beside(1)),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    /// Writes the left side, where it is not a plot.
    fn table(&self, book: &Book, lines: &mut Lines) {
        let Some(history) = self.history() else {
            if !self.history.write_unknown(lines) {
                nothing_yet(lines);
            }
            return;
        };
        match self.page {
            ProgressPage::OverTime | ProgressPage::SureOverTime => {}
            ProgressPage::Topics => topics::table(history, book, lines),
            ProgressPage::Sure => sure::table(history, lines),
            ProgressPage::Beliefs => beliefs::table(history, lines),
        }
    }

    /// Writes the right side.
    fn panel(&self, book: &Book, lines: &mut Lines) {
        if let Some(history) = self.history() {
            match self.page {
                ProgressPage::OverTime => over_time::panel(history, book, lines),
                ProgressPage::Topics => topics::panel(history, lines),
                ProgressPage::Sure => sure::panel(history, lines),
                ProgressPage::SureOverTime => sure_over_time::panel(history, lines),
                ProgressPage::Beliefs => beliefs::panel(history, lines),
            }
            lines.gap();
        }
        lines.paragraph(&self.next_step().words(book), Role::Key);
    }

    fn draw_picture(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        let plot = self.history().and_then(|history| match self.page {
            ProgressPage::OverTime => Some(over_time::plot(history, area, look)),
            ProgressPage::SureOverTime => Some(sure_over_time::plot(history, area, look)),
            _ => None,
        });
        let table = |lines: &mut Lines| self.table(&cx.book, lines);
        match plot {
            Some(Ok(picture)) => picture.draw(buf, &look),
            Some(Err(why)) => Lines::new(area, buf, look).paragraph(why, Role::Text),
            None => self.scroll.picture.draw(area, buf, look, table),
        }
    }
}

/// What to say where nothing has been done.
fn nothing_yet(lines: &mut Lines) {
    for text in [
        "Nothing here yet: every beginning is a clean board.",
        "Answer a few questions of the quiz, then come back. Here you will see your answers \
         come closer to the truth.",
    ] {
        lines.gap();
        lines.paragraph(text, Role::Text);
    }
}

impl Screen for Progress {
    type Action = ProgressAction;

    fn title(&self) -> String {
        "progress".into()
    }

    fn status(&self, cx: &Context) -> String {
        let player = words::brief(&cx.settings.player, 24);
        match self.history() {
            Some(history) => format!("{player}   {}", counted(history.attempts.len(), "answer")),
            None => player,
        }
    }

    fn keys(&self, _cx: &Context) -> KeyTable<ProgressAction> {
        use ProgressAction::{Back, DoNext, HandIn, Scroll, Turn, TurnTo};
        let pages = ('1'..).zip((0..ProgressPage::ALL.len()).map(TurnTo));
        let some = self.history().is_some();
        KeyTable::new("progress")
            .on(Key::Tab, Turn(1), "next page")
            .or([
                (Key::Right, Turn(1)),
                (Key::BackTab, Turn(-1)),
                (Key::Left, Turn(-1)),
            ])
            .when(some)
            .each(pages, "page")
            .when(some)
            .each([(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))], "scroll")
            .or(scroll_keys(Scroll))
            .when(some)
            .on(Key::Enter, DoNext, self.next_step().name())
            .on('h', HandIn, "hand in")
            .when(some)
            .on(Key::Escape, Back, "back")
    }

    fn act(&mut self, action: ProgressAction, cx: &mut Context) -> Next {
        match action {
            ProgressAction::Turn(by) => self.turn_to(self.page.beside(by)),
            ProgressAction::TurnTo(page) => self.turn_to(ProgressPage::ALL[page]),
            ProgressAction::Scroll(rows) => self.scroll_by(rows, cx),
            ProgressAction::DoNext => {
                let code = match self.next_step() {
                    NextStep::Read(passage) => return leads::open(Some(passage), cx),
                    NextStep::Choose => None,
                    NextStep::Review(kind) => Some(Code {
                        course: Course::new(kind),
                        seed: cx.next_seed(),
                    }),
                };
                return Next::Replace(Place::Quiz { code });
            }
            ProgressAction::HandIn => self.hand_in(cx),
            ProgressAction::Back => return Next::Back,
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            Input::Kept(answer) => {
                self.history.take(answer);
                Next::Stay
            }
            Input::Exported(exported) => {
                cx.tell_of_export("file to hand in", exported);
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn draw(&self, _area: Rect, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        let layout = self.layout(cx);
        let (picture, panel) = match self.history() {
            Some(_) => self.page.titles(),
            None => ("your progress", "what next"),
        };
        layout.draw(buf, &look, picture, panel);
        self.draw_picture(layout.picture, buf, cx);
        let write = |lines: &mut Lines| self.panel(&cx.book, lines);
        self.scroll.panel.draw(layout.panel, buf, look, write);
    }

    fn about(&self, _cx: &Context) -> Vec<&'static str> {
        vec![
            "Every answer you give is kept on this computer, and nowhere else. Here is what it adds up to.",
            "Over time: each mark is an answer, the higher the further off; the line is the mean of the last five. Topics: how often you were right, and how it stands lately; then the chapters you have opened, as Learn has them. How sure: the honest range is the one in which that confidence brings most points; its page over time shows whether you come to judge yourself better. Beliefs: what your wrong answers had in common, of how many questions could have shown it, before the middle of all answers and since.",
            "What you know may rest for 1, 2, 4 … 32 days before it is asked again; what you missed is due at once. It feels harder to come back to something half forgotten, and that is just why it works.",
            "Several people on one computer: carrom --player NAME. For a table: carrom progress --csv, or --json. For a page to print: --report FILE.html. h writes one small file with every answer, for a teacher who puts those of a class together (carrom gather).",
        ]
    }
}
