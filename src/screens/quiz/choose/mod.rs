//! Choosing a round of the quiz.

mod view;

use std::sync::Arc;

use strum::{EnumMessage, IntoStaticStr};

use crate::lessons::Book;
use crate::messages::{Input, Key};
use crate::progress::Due;
use crate::quiz::concepts::Library;
use crate::quiz::{ChaptersRead, Code, Course, CourseKind, Family};
use crate::screens::recall::Recall;
use crate::screens::{Context, Next, Place, Screen, View};
use crate::widgets::input::{KeyTable, ListAction, ListView, TextField};

/// What keys do where a round is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum ChoosingAction {
    /// choose a round or a topic, or begin it
    List(ListAction),
    /// begin at once
    Begin(usize),
    /// begin at once: find out, quick, mixed, review, hits, topic, exam, what was read, code
    BeginByLetter(usize),
    /// begin the round of the code that was typed
    Enter,
    /// go back
    Back,
}

/// The screen.
#[derive(Debug, Clone)]
pub(crate) struct Choosing {
    history: Recall,
    page: ChoosingPage,
    rounds: ListView,
    /// The topics, as in [`CourseKind::topics`].
    topics: ListView,
    /// The questions of the teacher's own.
    own: Arc<Library>,
}

/// What is being chosen from.
#[derive(Debug, Clone, PartialEq)]
enum ChoosingPage {
    Rounds,
    Topics,
    /// A code.
    Code {
        /// As far as it is typed.
        typed: TextField,
        /// Whether it was entered as it stands, and is none.
        refused: bool,
    },
}

/// Letters of a code at most: more than any has.
const LONGEST: usize = 40;

/// A kind of round to choose.
#[derive(Debug)]
enum RoundChoice {
    /// One that is there for everyone.
    Always(CourseKind),
    /// What is due.
    Review,
    /// What the chapters that were read teach.
    Read,
    /// One topic, to be chosen.
    Topic,
    /// The round of a code, to be typed.
    Code,
    /// Questions of a teacher's own.
    Own,
}

/// The kinds of round, each with the letter that chooses it, besides its number.
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

impl Choosing {
    /// The screen, with what the player has done asked for.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        cx.ask_for_marks();
        Self {
            history: Recall::ask(cx),
            page: ChoosingPage::Rounds,
            rounds: ListView::default(),
            topics: ListView::default(),
            own: Arc::clone(&cx.own),
        }
    }

    /// The kinds of round to choose from; own questions only where a folder was given.
    fn choices(&self) -> &'static [(char, RoundChoice)] {
        match *self.own == Library::default() {
            true => &CHOICES[..CHOICES.len() - 1],
            false => &CHOICES,
        }
    }

    /// The kind of round that is chosen.
    fn choice(&self) -> &'static RoundChoice {
        let choices = self.choices();
        &choices[self.rounds.chosen(choices.len())].1
    }

    /// The topic that is chosen.
    fn family(&self) -> Option<Family> {
        CourseKind::topics().nth(self.topics.chosen(CourseKind::topics().count()))
    }

    fn due(&self) -> Due {
        let history = self.history.history();
        history.map_or_else(Due::default, |it| Due::of(&it.attempts, &it.calendar))
    }

    /// The kind of the rounds that a choice begins; `None` where there is nothing to ask, and
    /// where there is more to be chosen.
    fn kind(&self, choice: &RoundChoice, book: &Book) -> Option<CourseKind> {
        match choice {
            RoundChoice::Always(kind) => Some(kind.clone()),
            RoundChoice::Review => self.due().course(),
            RoundChoice::Read => chapters_read(book).map(CourseKind::Read),
            RoundChoice::Own => {
                let own = (!self.own.concepts.is_empty()).then(|| Arc::clone(&self.own));
                own.map(CourseKind::Own)
            }
            RoundChoice::Topic | RoundChoice::Code => None,
        }
    }

    /// Does what the chosen line says.
    fn enter(&mut self, cx: &mut Context) -> Next {
        let kind = match (&self.page, self.choice()) {
            (ChoosingPage::Topics, _) => self.family().map(CourseKind::Topic),
            (_, choice) => self.kind(choice, &cx.book),
        };
        if let Some(kind) = kind {
            let code = Code {
                course: Course::new(kind),
                seed: cx.next_seed(),
            };
            return begin(code);
        }
        match self.choice() {
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

    /// Plays the round of the code that was typed, if it is one.
    fn enter_code(&mut self) -> Next {
        if let ChoosingPage::Code { typed, refused } = &mut self.page {
            if let Some(code) = code(typed.text(), &self.own) {
                return begin(code);
            }
            *refused = !typed.text().is_empty();
        }
        Next::Stay
    }
}

/// The first question of a round.
fn begin(code: Code) -> Next {
    Next::Replace(Place::Quiz { code: Some(code) })
}

/// The chapters that were read to their end, if a question is about any.
fn chapters_read(book: &Book) -> Option<ChaptersRead> {
    ChaptersRead::of(book.read_through().map(|chapter| chapter.id.as_str()))
}

/// The code that a text is, capitals and blanks around it aside.
fn code(text: &str, own: &Arc<Library>) -> Option<Code> {
    let code = Code::parse(&text.trim().to_lowercase())?;
    code.with_own(own).ok()
}

impl Screen for Choosing {
    type Action = ChoosingAction;

    fn title(&self) -> String {
        "quiz".into()
    }

    fn status(&self, _cx: &Context) -> String {
        match self.due().now.len() {
            0 => "choose a round".into(),
            due => format!("choose a round  {due} due"),
        }
    }

    fn keys(&self, _cx: &Context) -> KeyTable<ChoosingAction> {
        use ChoosingAction::{Back, Begin, BeginByLetter, Enter, List};
        let keys = KeyTable::new("rounds");
        let list = ListView::keys("begin");
        match self.page {
            ChoosingPage::Rounds => {
                let numbers = ('1'..='9').zip((0..self.choices().len()).map(Begin));
                let letters = self.choices().iter().map(|(letter, _)| *letter);
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

    fn about(&self, _cx: &Context) -> Vec<&'static str> {
        vec![
            "A round is a few questions: you answer, say how sure you are, watch what happens and read why.",
            "Every answer is kept on this computer. What you knew may rest for 1, 2, 4 … 32 days; what you missed is due at once. A review asks once about each topic that is due, in any of its kinds of question.",
            "In an exam you hear nothing until the end; then every question can be opened.",
            "Every round but a review has a code. With the same code a friend, or a whole class, gets the same questions: choose \"a round by its code\", or start with carrom quiz --code CODE.",
        ]
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        let ChoosingPage::Code { typed, refused } = &mut self.page else {
            return false;
        };
        // A question mark asks for help here: it is in no code.
        let of_code = |c: char| c.is_ascii_alphanumeric() || c == '-';
        let used = !matches!(key, Key::Char(c) if !of_code(c)) && typed.update(key);
        *refused &= !used;
        used
    }

    fn act(&mut self, action: ChoosingAction, cx: &mut Context) -> Next {
        match action {
            ChoosingAction::List(action) => {
                let outcome = match self.page {
                    ChoosingPage::Rounds => self.rounds.act(action, self.choices().len()),
                    _ => self.topics.act(action, CourseKind::topics().count()),
                };
                Next::of(outcome, |_| self.enter(cx))
            }
            ChoosingAction::Begin(at) | ChoosingAction::BeginByLetter(at) => {
                self.rounds.choose(at);
                self.enter(cx)
            }
            ChoosingAction::Enter => self.enter_code(),
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

    fn view<'s>(&'s self, cx: &'s Context) -> Option<View<'s, ChoosingAction>> {
        Some(view::view(self, &cx.book))
    }
}
