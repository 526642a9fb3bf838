//! The contents: the chapters and the reading progress.

mod view;

use strum::{EnumMessage, IntoStaticStr};

use crate::files::FileError;
use crate::lessons::{Book, Chapter, Forget};
use crate::messages::{Input, Key, StoreReply};
use crate::screens::ahead::Ahead;
use crate::screens::{Confirmation, Context, Next, Route, Screen, View};
use crate::widgets::input::{KeyTable, ListAction, ListView};

#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum ContentsAction {
    /// choose a chapter, or read it
    List(ListAction),
    /// take the next step, in a chapter or elsewhere
    Next,
    /// open the glossary
    Glossary,
    /// forget your place and your answers in the chosen chapter
    Forget,
    /// forget your place and your answers in all chapters
    ForgetAll,
    /// go back
    Leave,
}

/// The contents. The chosen line is stored in the [`Book`].
#[derive(Debug, Clone)]
pub(crate) struct Contents {
    ahead: Ahead,
    /// Whether the player has moved the mark or returned from another screen: the mark then stays.
    moved: bool,
}

impl Contents {
    /// The contents. Until the next step is known, the first chapter that is not done is chosen.
    pub(crate) fn new(cx: &mut Context) -> Self {
        cx.book.at = cx.book.next().unwrap_or(0);
        Self {
            ahead: Ahead::ask(cx),
            moved: false,
        }
    }

    /// The index of the next chapter: that of the next step, or else the first that is not done.
    fn next_chapter(&self, book: &Book) -> Option<usize> {
        let step = self.ahead.step().and_then(|it| it.step.chapter());
        step.or_else(|| book.next())
    }
}

/// Moves the mark, or opens the marked line.
fn listed(book: &mut Book, action: ListAction) -> Next {
    let mut list = ListView::at(book.at);
    let count = lines(book).len();
    let outcome = list.act(action, count);
    book.at = list.chosen(count);
    Next::of(outcome, |_| open(book))
}

#[derive(Debug, Clone, Copy)]
enum ContentsLine<'a> {
    Chapter(&'a Chapter),
    /// The reading progress.
    Summary,
    /// The terms that the chapters introduce.
    Glossary,
    /// A file that is left out.
    Problem(&'a FileError),
}

/// All lines that can be chosen, the chapters first.
fn lines(book: &Book) -> Vec<ContentsLine<'_>> {
    let library = book.library();
    let chapters = library.chapters.iter().map(ContentsLine::Chapter);
    let problems = library.problems.iter().map(ContentsLine::Problem);
    let lines = chapters.chain([ContentsLine::Summary, ContentsLine::Glossary]);
    lines.chain(problems).collect()
}

fn chosen(book: &Book) -> ContentsLine<'_> {
    let chosen = lines(book).get(book.at).copied();
    chosen.unwrap_or(ContentsLine::Summary)
}

/// The id of the chosen chapter, if it was ever opened.
fn chapter_begun(book: &Book) -> Option<String> {
    let id = &book.chapter(book.at)?.id;
    book.mark(id).map(|_| id.clone())
}

fn open(book: &Book) -> Next {
    let number = match chosen(book) {
        ContentsLine::Chapter(_) => Some(book.at),
        ContentsLine::Summary => book.next(),
        ContentsLine::Glossary => return Next::Open(Route::Glossary),
        ContentsLine::Problem(_) => None,
    };
    number.map_or(Next::Stay, |number| Next::Open(Route::Chapter(number)))
}

impl Screen for Contents {
    type Action = ContentsAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "learn";
    const ROUTE: Route = Route::Learn;

    fn status(&self, cx: &Context) -> String {
        if !cx.book.is_known() {
            return String::new();
        }
        format!("{} chapters done", cx.book.done())
    }

    fn keys(&self, cx: &Context) -> KeyTable<ContentsAction> {
        use ContentsAction::{Forget, ForgetAll, Glossary, Leave, List, Next};
        let keys = KeyTable::new("contents");
        let book = &cx.book;
        if !book.is_known() {
            return keys.on(Key::Escape, Leave, "back");
        }
        keys.with(ListView::keys("read"), List)
            .on(Key::Escape, Leave, "back")
            .on(Key::Char('n'), Next, "next step")
            .when(self.ahead.step().is_some())
            .on(Key::Char('g'), Glossary, "glossary")
            .on(Key::Char('R'), Forget, "reset")
            .when(chapter_begun(book).is_some())
            .on(Key::Char('A'), ForgetAll, "reset all")
            .when(book.is_begun())
    }

    fn act(&mut self, action: ContentsAction, cx: &mut Context) -> Next {
        let book = &mut cx.book;
        let (title, of) = match action {
            ContentsAction::List(action) => {
                self.moved = true;
                return listed(book, action);
            }
            ContentsAction::Next => return self.ahead.follow(cx),
            ContentsAction::Glossary => return Next::Open(Route::Glossary),
            ContentsAction::Leave => return Next::Back,
            ContentsAction::ForgetAll => ("all chapters".to_owned(), "all chapters"),
            ContentsAction::Forget => {
                let number = book.chapter(book.at).map_or(0, |chapter| chapter.number);
                (format!("chapter {number}"), "this chapter")
            }
        };
        let text = format!(
            "Forget {title}? Your place and your answers in {of} will be forgotten, so that you \
             can start over. Your progress still counts every answer you have given."
        );
        Next::Confirm(Confirmation::new(text, "forget it", "keep it"))
    }

    fn confirmed(&mut self, action: ContentsAction, cx: &mut Context) -> Next {
        let what = match action {
            ContentsAction::ForgetAll => Some(Forget::All),
            _ => chapter_begun(&cx.book).map(Forget::Chapter),
        };
        if let Some(what) = what {
            cx.forget(what);
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        let next = self.ahead.input(input, cx);
        if let Input::Kept(answer) = input
            && matches!(answer.done, StoreReply::Marks(_) | StoreReply::Recalled(_))
            && !self.moved
        {
            cx.book.at = self.next_chapter(&cx.book).unwrap_or(0);
        }
        next
    }

    fn resumed(&mut self, cx: &mut Context) {
        self.ahead.ask_again(cx);
        self.moved = true;
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        self.moved = true;
        listed(&mut cx.book, ListAction::Choose(by.into()))
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, ContentsAction> {
        view::view(self, cx)
    }
}
