//! Choosing a round of the quiz.

mod view;

use std::sync::Arc;

use strum::{EnumMessage, IntoStaticStr};

use crate::lessons::Book;
use crate::messages::{History, Input, Key};
use crate::progress::Due;
use crate::quiz::concepts::Library;
use crate::quiz::{ChaptersRead, Code, Course, CourseKind, Family};
use crate::screens::recall::Recall;
use crate::screens::{Context, Next, Route, Screen, View};
use crate::widgets::input::{KeyTable, ListAction, ListView, TextField};

/// Actions while choosing a round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum ChoosingAction {
    /// choose a round or a topic, or begin it
    List(ListAction),
    /// begin at once
    Begin(usize),
    /// begin at once: find out, quick, mixed, review, hits, topic, exam, what was read, code
    BeginByLetter(usize),
    /// begin the round with the typed code
    Enter,
    /// go back
    Back,
}

/// The screen for choosing a round.
#[derive(Debug, Clone)]
pub(crate) struct Choosing {
    history: Recall,
    page: ChoosingPage,
    rounds: ListView,
    /// The topics, as in [`CourseKind::topics`].
    topics: ListView,
}

#[derive(Debug, Clone, PartialEq)]
enum ChoosingPage {
    Rounds,
    Topics,
    Code {
        /// The typed text.
        typed: TextField,
        /// Whether the player entered the text and it is not a valid code.
        refused: bool,
    },
}

/// The largest number of characters that can be typed; every code is shorter.
const LONGEST: usize = 64;

/// A kind of round that can be chosen.
#[derive(Debug)]
enum RoundChoice {
    /// A kind that is always available.
    Always(CourseKind),
    /// A review of the topics that are due.
    Review,
    /// Questions about the chapters that the player has read.
    Read,
    /// One topic, which the player chooses.
    Topic,
    /// The round of a typed code.
    Code,
    /// A teacher's own questions.
    Own,
}

/// The kinds of round, each with its letter; the numbers of the first nine rows are also keys.
static CHOICES: [(char, RoundChoice); 10] = [
    ('f', RoundChoice::Always(CourseKind::FindOut)),
    ('q', RoundChoice::Always(CourseKind::Quick)),
    ('m', RoundChoice::Always(CourseKind::Even)),
    ('r', RoundChoice::Review),
    ('h', RoundChoice::Always(CourseKind::Hits)),
    ('t', RoundChoice::Topic),
    ('e', RoundChoice::Always(CourseKind::Exam)),
    ('w', RoundChoice::Read),
    ('c', RoundChoice::Code),
    ('o', RoundChoice::Own),
];

/// The kinds of round to choose from, with a teacher's questions only if a folder was given.
fn choices(cx: &Context) -> &'static [(char, RoundChoice)] {
    match cx.own.concepts.is_empty() && cx.own.problems.is_empty() {
        true => &CHOICES[..CHOICES.len() - 1],
        false => &CHOICES,
    }
}

impl Choosing {
    /// Requests the player's record.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        cx.ask_for_marks();
        Self {
            history: Recall::ask(cx),
            page: ChoosingPage::Rounds,
            rounds: ListView::default(),
            topics: ListView::default(),
        }
    }

    /// The chosen kind of round.
    fn choice(&self, cx: &Context) -> &'static RoundChoice {
        let choices = choices(cx);
        &choices[self.rounds.chosen(choices.len())].1
    }

    /// The chosen topic.
    fn family(&self) -> Option<Family> {
        CourseKind::topics().nth(self.topics.chosen(CourseKind::topics().count()))
    }

    fn due(&self) -> Due {
        let history = self.history.history();
        history.map_or_else(Due::default, |it| Due::of(&it.attempts, &it.calendar))
    }

    /// The course that a choice begins; `None` if there is nothing to ask, or if the player has to
    /// make another choice first.
    fn course(&self, choice: &RoundChoice, cx: &Context) -> Option<Course> {
        Some(Course::new(match choice {
            RoundChoice::Always(kind @ (CourseKind::Quick | CourseKind::Even)) => {
                let nothing = History::default();
                let history = self.history.history().unwrap_or(&nothing);
                let met = CourseKind::Met(cx.so_far(history).topics_met());
                return Some(Course::of(met, kind.length()));
            }
            RoundChoice::Always(kind) => kind.clone(),
            RoundChoice::Review => self.due().course()?,
            RoundChoice::Read => CourseKind::Read(chapters_read(&cx.book)?),
            RoundChoice::Own if cx.own.concepts.is_empty() => return None,
            RoundChoice::Own => CourseKind::Own(Arc::clone(&cx.own)),
            RoundChoice::Topic | RoundChoice::Code => return None,
        }))
    }

    /// Opens the chosen line.
    fn enter(&mut self, cx: &mut Context) -> Next {
        let choice = self.choice(cx);
        let course = match (&self.page, self.family()) {
            (ChoosingPage::Topics, family) => family.map(|it| Course::new(CourseKind::Topic(it))),
            _ => self.course(choice, cx),
        };
        if let Some(course) = course {
            return Next::Replace(Route::Quiz(Some(cx.next_code(course))));
        }
        match choice {
            RoundChoice::Topic => self.page = ChoosingPage::Topics,
            RoundChoice::Code => {
                self.page = ChoosingPage::Code {
                    typed: TextField::new("", LONGEST),
                    refused: false,
                };
            }
            _ => {}
        }
        Next::Stay
    }

    /// Plays the round of the typed code, if it is valid.
    fn enter_code(&mut self, cx: &Context) -> Next {
        if let ChoosingPage::Code { typed, refused } = &mut self.page {
            if let Some(code) = code(typed.text(), &cx.own) {
                return Next::Replace(Route::Quiz(Some(code)));
            }
            *refused = !typed.text().is_empty();
        }
        Next::Stay
    }
}

/// The finished chapters, if there are questions about any of them.
fn chapters_read(book: &Book) -> Option<ChaptersRead> {
    ChaptersRead::of(book.read_through().map(|chapter| chapter.id.as_str()))
}

/// Reads a code, ignoring case and spaces around it.
fn code(text: &str, own: &Arc<Library>) -> Option<Code> {
    let code = Code::parse(&text.trim().to_lowercase())?;
    code.with_own(own).ok()
}

impl Screen for Choosing {
    type Action = ChoosingAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "quiz";
    const ROUTE: Route = Route::Quiz(None);

    fn status(&self, _cx: &Context) -> String {
        match self.due().now.len() {
            0 => "choose a round".into(),
            due => format!("choose a round  {due} due"),
        }
    }

    fn keys(&self, cx: &Context) -> KeyTable<ChoosingAction> {
        use ChoosingAction::{Back, Begin, BeginByLetter, Enter, List};
        let keys = KeyTable::new("rounds");
        let list = ListView::keys("begin");
        match self.page {
            ChoosingPage::Rounds => {
                let choices = choices(cx);
                let numbers = ('1'..='9').zip((0..choices.len()).map(Begin));
                let letters = choices.iter().map(|(letter, _)| *letter);
                let letters = letters.zip((0..).map(BeginByLetter));
                keys.with(list, List)
                    .each(numbers, "at once")
                    .each(letters, "")
                    .on(Key::Escape, Back, "back")
            }
            ChoosingPage::Topics => keys.with(list, List).on(Key::Escape, Back, "other rounds"),
            ChoosingPage::Code { .. } => {
                keys.on(Key::Enter, Enter, "begin")
                    .on(Key::Escape, Back, "other rounds")
            }
        }
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        let ChoosingPage::Code { typed, refused } = &mut self.page else {
            return false;
        };
        // A question mark opens the help, because no code contains one.
        let of_code = |c: char| c.is_ascii_alphanumeric() || c == '-';
        let used = !matches!(key, Key::Char(c) if !of_code(c)) && typed.update(key);
        *refused &= !used;
        used
    }

    fn act(&mut self, action: ChoosingAction, cx: &mut Context) -> Next {
        match action {
            ChoosingAction::List(action) => {
                let outcome = match self.page {
                    ChoosingPage::Rounds => self.rounds.act(action, choices(cx).len()),
                    _ => self.topics.act(action, CourseKind::topics().count()),
                };
                Next::of(outcome, |_| self.enter(cx))
            }
            ChoosingAction::Begin(at) | ChoosingAction::BeginByLetter(at) => {
                self.rounds.choose(at);
                self.enter(cx)
            }
            ChoosingAction::Enter => self.enter_code(cx),
            ChoosingAction::Back if self.page == ChoosingPage::Rounds => Next::Back,
            ChoosingAction::Back => {
                self.page = ChoosingPage::Rounds;
                Next::Stay
            }
        }
    }

    fn input(&mut self, input: &Input, _cx: &mut Context) -> Next {
        match (input, &mut self.page) {
            (Input::Paste(text), ChoosingPage::Code { typed, refused }) => {
                typed.paste(text.trim());
                *refused = false;
            }
            (Input::Kept(answer), _) => self.history.take(answer),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        match self.page {
            ChoosingPage::Code { .. } => Next::Ignored,
            _ => self.act(ChoosingAction::List(ListAction::Choose(by.into())), cx),
        }
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, ChoosingAction> {
        view::view(self, cx)
    }
}
