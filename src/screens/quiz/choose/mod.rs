//! Choosing a round of the quiz.

mod view;

use std::sync::Arc;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::progress::Due;
use crate::quiz::concepts::Library;
use crate::quiz::{Code, Course, CourseKind, Family};
use crate::screens::recall::Recall;
use crate::screens::{Context, Help, Hint, Next, OldScreen, Place};

/// The screen.
#[derive(Debug, Clone)]
pub(crate) struct Choosing {
    history: Recall,
    page: Page,
    /// The round that is chosen.
    round: usize,
    /// The topic that is chosen, of [`CourseKind::topics`].
    topic: usize,
    /// The questions of the teacher's own.
    own: Arc<Library>,
}

/// What is being chosen from.
#[derive(Debug, Clone, PartialEq)]
enum Page {
    /// The kinds of round.
    Rounds,
    /// The topics.
    Topics,
    /// A code, as far as it is typed.
    Code(Typed),
}

/// A code being typed.
#[derive(Debug, Clone, Default, PartialEq)]
struct Typed {
    text: String,
    /// Whether it was entered as it stands, and is none.
    refused: bool,
}

/// Letters of a code at most: more than any has.
const LONGEST: usize = 40;

/// A kind of round to choose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Choice {
    Quick,
    Mixed,
    Review,
    Hits,
    Topic,
    Exam,
    Code,
    Own,
}

impl Choice {
    const ALL: [Self; 8] = [
        Self::Quick,
        Self::Mixed,
        Self::Review,
        Self::Hits,
        Self::Topic,
        Self::Exam,
        Self::Code,
        Self::Own,
    ];

    /// The letter that chooses it, besides its number.
    const fn key(self) -> char {
        match self {
            Self::Quick => 'q',
            Self::Mixed => 'm',
            Self::Review => 'r',
            Self::Hits => 'h',
            Self::Topic => 't',
            Self::Exam => 'e',
            Self::Code => 'c',
            Self::Own => 'o',
        }
    }

    /// The choice of a digit from 1 or of its letter.
    fn of(c: char) -> Option<Self> {
        let of_letter = || {
            let letter = c.to_ascii_lowercase();
            Self::ALL.into_iter().find(|choice| choice.key() == letter)
        };
        let number = c.to_digit(10).and_then(|digit| digit.checked_sub(1));
        match number {
            Some(number) => Self::ALL.get(number as usize).copied(),
            None => of_letter(),
        }
    }
}

impl Choosing {
    /// The screen, with what the player has done asked for.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        Self {
            history: Recall::ask(cx),
            page: Page::Rounds,
            round: 0,
            topic: 0,
            own: Arc::clone(&cx.own),
        }
    }

    /// The kinds of round to choose from; own questions only where a folder was given.
    fn choices(&self) -> &'static [Choice] {
        let all = &Choice::ALL[..];
        match *self.own == Library::default() {
            true => &all[..all.len() - 1],
            false => all,
        }
    }

    /// The kind of round that is chosen.
    fn choice(&self) -> Choice {
        let choices = self.choices();
        choices[self.round.min(choices.len() - 1)]
    }

    /// The keys that choose them.
    fn numbers(&self) -> &'static str {
        match self.choices().len() {
            8 => "1-8",
            _ => "1-7",
        }
    }

    /// The topic that is chosen.
    fn family(&self) -> Option<Family> {
        CourseKind::topics().nth(self.topic)
    }

    /// What is due.
    fn due(&self) -> Due {
        let history = self.history.history();
        history.map_or_else(Due::default, |it| Due::of(&it.attempts, &it.calendar))
    }

    /// The chosen line of the page, and how many there are; `None` where nothing is
    /// chosen from a list.
    fn line(&mut self) -> Option<(&mut usize, usize)> {
        let rounds = self.choices().len();
        match self.page {
            Page::Rounds => Some((&mut self.round, rounds)),
            Page::Topics => Some((&mut self.topic, CourseKind::topics().count())),
            Page::Code(_) => None,
        }
    }

    fn move_by(&mut self, lines: isize) -> Next {
        let Some((line, count)) = self.line() else {
            return Next::Ignored;
        };
        *line = line
            .saturating_add_signed(lines)
            .min(count.saturating_sub(1));
        Next::Stay
    }

    /// Does what the chosen line says.
    fn enter(&mut self, cx: &mut Context) -> Next {
        let kind = match (&self.page, self.choice()) {
            (Page::Topics, _) => self.family().map(CourseKind::Topic),
            (Page::Code(_), _) => return self.enter_code(),
            (Page::Rounds, Choice::Quick) => Some(CourseKind::Quick),
            (Page::Rounds, Choice::Mixed) => Some(CourseKind::Mixed),
            (Page::Rounds, Choice::Hits) => Some(CourseKind::Hits),
            (Page::Rounds, Choice::Exam) => Some(CourseKind::Exam),
            (Page::Rounds, Choice::Review) => self.due().course(),
            (Page::Rounds, Choice::Own) => {
                let own = (!self.own.concepts.is_empty()).then(|| Arc::clone(&self.own));
                own.map(CourseKind::Own)
            }
            (Page::Rounds, Choice::Topic) => {
                self.page = Page::Topics;
                None
            }
            (Page::Rounds, Choice::Code) => {
                self.page = Page::Code(Typed::default());
                None
            }
        };
        let Some(kind) = kind else {
            return Next::Stay;
        };
        let code = Code {
            course: Course::new(kind),
            seed: cx.next_seed(),
        };
        Next::Replace(Place::Quiz { code: Some(code) })
    }

    /// Plays the round of the code that was typed, if it is one.
    fn enter_code(&mut self) -> Next {
        let Page::Code(typed) = &mut self.page else {
            return Next::Ignored;
        };
        match Code::parse(&typed.text).and_then(|code| code.with_own(&self.own).ok()) {
            Some(code) => Next::Replace(Place::Quiz { code: Some(code) }),
            None => {
                typed.refused = !typed.text.is_empty();
                Next::Stay
            }
        }
    }

    fn key(&mut self, key: Key, cx: &mut Context) -> Next {
        if let Page::Code(typed) = &mut self.page
            && typed.update(key)
        {
            return Next::Stay;
        }
        match key {
            Key::Up | Key::BackTab => self.move_by(-1),
            Key::Down | Key::Tab => self.move_by(1),
            Key::PageUp => self.move_by(-8),
            Key::PageDown => self.move_by(8),
            Key::Home => self.move_by(isize::MIN),
            Key::End => self.move_by(isize::MAX),
            Key::Enter | Key::Char(' ') => self.enter(cx),
            Key::Escape if self.page != Page::Rounds => {
                self.page = Page::Rounds;
                Next::Stay
            }
            Key::Char(c) if self.page == Page::Rounds => {
                let chosen = Choice::of(c);
                let Some(at) = self.choices().iter().position(|it| Some(*it) == chosen) else {
                    return Next::Ignored;
                };
                self.round = at;
                self.enter(cx)
            }
            _ => Next::Ignored,
        }
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        match mouse.kind {
            MouseKind::ScrollUp => self.move_by(-1),
            MouseKind::ScrollDown => self.move_by(1),
            MouseKind::Down => {
                let at = view::line_at(self, cx, (mouse.column, mouse.row));
                let (Some(at), Some((line, _))) = (at, self.line()) else {
                    return Next::Ignored;
                };
                if *line == at {
                    return self.enter(cx);
                }
                *line = at;
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }
}

impl Typed {
    /// Takes a key; says whether it was one of a code's.
    fn update(&mut self, key: Key) -> bool {
        match key {
            Key::Char(c) if c.is_ascii_alphanumeric() || c == '-' => self.push(c),
            Key::Backspace => {
                self.text.pop();
            }
            _ => return false,
        }
        self.refused = false;
        true
    }

    /// Adds a letter, unless it is none of a code's or one too many.
    fn push(&mut self, c: char) {
        if (c.is_ascii_alphanumeric() || c == '-') && self.text.len() < LONGEST {
            self.text.push(c.to_ascii_lowercase());
        }
    }
}

impl OldScreen for Choosing {
    fn title(&self) -> String {
        "quiz".into()
    }

    fn status(&self, _cx: &Context) -> String {
        match self.due().now.len() {
            0 => "choose a round".into(),
            due => format!("choose a round  {due} due"),
        }
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        match (input, &mut self.page) {
            (Input::Key(key), _) => self.key(*key, cx),
            (Input::Mouse(mouse), _) => self.mouse(mouse, cx),
            (Input::Paste(text), Page::Code(typed)) => {
                text.trim().chars().for_each(|c| typed.push(c));
                typed.refused = false;
                Next::Stay
            }
            (Input::Kept(answer), _) => {
                self.history.take(answer);
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        match self.page {
            Page::Rounds => vec![
                Hint::new("Up Down", "choose"),
                Hint::new("Enter", "begin"),
                Hint::new(self.numbers(), "at once"),
                Hint::new("Esc", "back"),
            ],
            Page::Topics => vec![
                Hint::new("Up Down", "choose"),
                Hint::new("Enter", "begin"),
                Hint::new("Esc", "other rounds"),
            ],
            Page::Code(_) => vec![
                Hint::new("a-z 0-9 -", "type"),
                Hint::new("Enter", "begin"),
                Hint::new("Esc", "other rounds"),
            ],
        }
    }

    fn help(&self, _cx: &Context) -> Help {
        Help {
            text: vec![
                "A round is a few questions: you answer, say how sure you are, watch what happens and read why.",
                "Every answer is kept on this computer. What you knew may rest for 1, 2, 4 … 32 days; what you missed is due at once. A review asks once about each topic that is due, in any of its kinds of question.",
                "In an exam you hear nothing until the end; then every question can be opened.",
                "Every round but a review has a code. With the same code a friend, or a whole class, gets the same questions: choose \"a round by its code\", or start with carrom quiz --code CODE.",
            ],
            keys: vec![
                Hint::new("Up Down", "choose"),
                Hint::new("Enter", "begin"),
                Hint::new(self.numbers(), "begin at once"),
                Hint::new(
                    "q m r h t e c",
                    "likewise: quick, mixed, review, hits, topic, exam, code",
                ),
                Hint::new("Esc", "back"),
                Hint::new("mouse", "click to choose, again to begin"),
            ],
        }
    }
}
