//! The contents: what there is to read, how far one has come.

mod view;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::messages::{Input, Key, MouseKind};
use crate::screens::{Book, Context, Help, Hint, Next, Place, Screen};

/// The contents. Which line is chosen belongs to the [`Book`].
#[derive(Debug, Clone, Default)]
pub struct Contents {}

impl Contents {
    /// The contents, at the first chapter that is not done.
    pub fn new(cx: &mut Context) -> Self {
        cx.book.at = cx.book.next().unwrap_or(0);
        Self::default()
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

fn choose(book: &mut Book, by: isize) {
    let last = lines(book).len().saturating_sub(1);
    book.at = book.at.saturating_add_signed(by).min(last);
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

impl Screen for Contents {
    fn title(&self) -> String {
        "learn".into()
    }

    fn status(&self, cx: &Context) -> String {
        let chapters = &cx.book.library().chapters;
        let done = chapters.iter().filter(|chapter| cx.book.is_done(chapter));
        format!("{} of {} chapters done", done.count(), chapters.len())
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        let body = cx.body;
        let book = &mut cx.book;
        match input {
            Input::Key(key) => match key {
                Key::Up | Key::BackTab => choose(book, -1),
                Key::Down | Key::Tab => choose(book, 1),
                Key::PageUp => choose(book, -10),
                Key::PageDown => choose(book, 10),
                Key::Home => choose(book, isize::MIN),
                Key::End => choose(book, isize::MAX),
                Key::Char('n' | 'N') => book.at = book.next().unwrap_or(book.at),
                Key::Char('R') => {
                    if let Line::Chapter(number) = chosen(book)
                        && let Some(id) = book.chapter(number).map(|chapter| chapter.id.clone())
                    {
                        book.reset(&id);
                    }
                }
                Key::Enter | Key::Char(' ') => return open(book),
                _ => return Next::Ignored,
            },
            Input::Mouse(mouse) => match mouse.kind {
                MouseKind::ScrollUp => choose(book, -1),
                MouseKind::ScrollDown => choose(book, 1),
                MouseKind::Down => {
                    let Some(at) = view::line_at(book, body, (mouse.column, mouse.row)) else {
                        return Next::Ignored;
                    };
                    if std::mem::replace(&mut book.at, at) == at {
                        return open(book);
                    }
                }
                _ => return Next::Ignored,
            },
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(area, buf, cx);
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        vec![
            Hint::new("Up Down", "choose"),
            Hint::new("Enter", "read"),
            Hint::new("n", "next to read"),
            Hint::new("R", "reset"),
            Hint::new("Esc", "back"),
        ]
    }

    fn help(&self, cx: &Context) -> Help {
        Help {
            text: vec![
                "Everything about glancing collisions, as things to do: short texts beside figures that obey you, and questions to which you first say what you think.",
                "The chapters build on each other, but all of them are open. A + stands before those that you have read and answered to the end.",
                "Chapters of your own: carrom learn --lessons DIR. A file that cannot be read is listed at the end with what is wrong with it.",
            ],
            keys: self.keys(cx),
        }
    }
}
