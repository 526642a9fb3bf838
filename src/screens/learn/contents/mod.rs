//! The contents: what there is to read, how far one has come.

mod view;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::lessons::{Book, Forget};
use crate::messages::{Input, Key, StoreReply};
use crate::screens::list::{Chosen, chosen as chosen_by};
use crate::screens::{Context, Help, Hint, Next, OldScreen, Place};

/// The contents. Which line is chosen belongs to the [`Book`].
#[derive(Debug, Clone, Default)]
pub struct Contents {
    /// What the student has been asked about.
    forgetting: Option<Forget>,
}

impl Contents {
    /// The contents, at the first chapter that is not done. How far they have been read
    /// is asked for, if it is not known yet.
    pub fn new(cx: &mut Context) -> Self {
        cx.ask_for_marks();
        cx.book.at = cx.book.next().unwrap_or(0);
        Self::default()
    }

    fn key(&mut self, key: Key, cx: &mut Context) -> Next {
        if let Some(forget) = self.forgetting.take() {
            if let Key::Char('y' | 'Y') = key {
                cx.forget(forget);
            }
            return Next::Stay;
        }
        let book = &mut cx.book;
        match key {
            Key::Char('n' | 'N') => book.at = book.next().unwrap_or(book.at),
            Key::Char('R') => self.forgetting = chapter_begun(book).map(Forget::Chapter),
            Key::Char('A') => self.forgetting = book.is_begun().then_some(Forget::All),
            _ => return Next::Ignored,
        }
        Next::Stay
    }
}

/// What a line of the contents is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Line {
    /// A chapter, from 0.
    Chapter(usize),
    /// How far one has come.
    Summary,
    /// A file that is left out, from 0.
    Problem(usize),
}

/// All lines that can be chosen.
fn lines(book: &Book) -> Vec<Line> {
    let library = book.library();
    let chapters = (0..library.chapters.len()).map(Line::Chapter);
    let problems = (0..library.problems.len()).map(Line::Problem);
    chapters.chain([Line::Summary]).chain(problems).collect()
}

/// The chosen line.
fn chosen(book: &Book) -> Line {
    lines(book).get(book.at).copied().unwrap_or(Line::Summary)
}

/// The id of the chosen chapter, if it was ever opened.
fn chapter_begun(book: &Book) -> Option<String> {
    let Line::Chapter(number) = chosen(book) else {
        return None;
    };
    let id = &book.chapter(number)?.id;
    book.mark(id).map(|_| id.clone())
}

fn open(book: &Book) -> Next {
    match chosen(book) {
        Line::Chapter(number) => Next::Open(Place::Chapter { number }),
        Line::Summary => match book.next() {
            Some(number) => Next::Open(Place::Chapter { number }),
            None => Next::Stay,
        },
        Line::Problem(_) => Next::Stay,
    }
}

impl OldScreen for Contents {
    fn title(&self) -> String {
        "learn".into()
    }

    fn status(&self, cx: &Context) -> String {
        if !cx.book.is_known() {
            return String::new();
        }
        format!("{} chapters done", cx.book.done())
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        let (body, book) = (cx.body, &mut cx.book);
        if matches!(input, Input::Kept(answer) if matches!(answer.done, StoreReply::Marks(_))) {
            book.at = book.next().unwrap_or(0);
            return Next::Stay;
        }
        if !book.is_known() {
            return Next::Ignored;
        }
        if self.forgetting.is_none() {
            let line_at = |cell| view::line_at(book, body, cell);
            match chosen_by(input, book.at, lines(book).len(), line_at) {
                Chosen::Line(line) => book.at = line,
                Chosen::Open => return open(book),
                Chosen::Nothing => {}
            }
        }
        match input {
            Input::Key(key) => self.key(*key, cx),
            _ => Next::Ignored,
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }

    fn keys(&self, cx: &Context) -> Vec<Hint> {
        if self.forgetting.is_some() {
            return vec![
                Hint::new("y", "forget it"),
                Hint::new("any other key", "leave it"),
            ];
        }
        let mut keys = Vec::new();
        if cx.book.is_known() {
            keys.extend([
                Hint::new("Up Down", "choose"),
                Hint::new("Enter", "read"),
                Hint::new("Esc", "back"),
                Hint::new("n", "next"),
                Hint::new("R", "reset"),
                Hint::new("A", "reset all"),
            ]);
        } else {
            keys.push(Hint::new("Esc", "back"));
        }
        keys
    }

    fn help(&self, cx: &Context) -> Help {
        Help {
            text: vec![
                "Everything about glancing collisions, as things to do: short texts beside figures that obey you, and questions to which you first say what you think.",
                "The chapters build on each other, but all of them are open. SplitLayout each stands how many of its pages you have seen, and a + before those that you have read and answered to the end. Your place is kept, until the next time too.",
                "R forgets your place and your answers in the chosen chapter, A those in all of them, once you have said yes. What you have answered still counts in your progress.",
                "Chapters of your own: carrom learn --lessons DIR. A file that cannot be read is listed at the end with what is wrong with it.",
            ],
            keys: self.keys(cx),
        }
    }
}
