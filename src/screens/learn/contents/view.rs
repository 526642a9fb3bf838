//! The view of the contents.

use super::{Contents, ContentsAction, ContentsLine, chosen, lines};
use crate::lessons::{Book, Bookmark, Chapter, GlossaryEntry};
use crate::screens::{Context, View};
use crate::widgets::Role;
use crate::widgets::input::ListAction;
use crate::widgets::panel::Panel;

/// The contents, and the description of the chosen line.
pub(super) fn view<'s>(contents: &Contents, cx: &Context) -> View<'s, ContentsAction> {
    let book = &cx.book;
    let mut list = Panel::new("learn");
    if !book.is_known() {
        list.line("Loading …", Role::Dim);
        return View::panels(list, Panel::new(""));
    }
    let next = contents.next_chapter(book);
    for (i, line) in lines(book).into_iter().enumerate() {
        let (text, side, role) = match line {
            ContentsLine::Chapter(chapter) => chapter_line(book, chapter, next == Some(i)),
            ContentsLine::Summary => ("How far you have come".into(), String::new(), Role::Dim),
            ContentsLine::Glossary => ("Glossary".into(), String::new(), Role::Dim),
            ContentsLine::Problem(fault) => {
                let text = format!("left out: {}", fault.file);
                (text, String::new(), Role::Warn)
            }
        };
        let action = ContentsAction::List(ListAction::Point(i));
        list.row((text, role), (side, role), i == book.at, action);
    }
    let mut about = match chosen(book) {
        ContentsLine::Chapter(chapter) => about_chapter(book, chapter),
        ContentsLine::Summary => summary(contents, book),
        ContentsLine::Glossary => about_glossary(),
        ContentsLine::Problem(fault) => {
            let mut panel = Panel::new("what is wrong");
            panel.paragraph(fault.to_string(), Role::Text);
            panel
        }
    };
    about.worth(1, |about| {
        about.gap();
        about.heading("What next");
    });
    contents.ahead.write(ContentsAction::Next, &mut about);
    View::panels(list, about)
}

/// The mark beside the chapter that comes next.
const NEXT: &str = "next";

fn chapter_line(book: &Book, chapter: &Chapter, is_next: bool) -> (String, String, Role) {
    let mark = book.mark(&chapter.id);
    let standing = mark.map(|mark| standing(mark, chapter)).unwrap_or_default();
    let (side, role) = match is_next {
        true => (format!("{standing} {NEXT}").trim().to_owned(), Role::Key),
        false => (standing, Role::Text),
    };
    (format!("{} {}", chapter.number, chapter.title), side, role)
}

/// The progress of a chapter: the number of pages read or, once all of them have been read, the
/// number of right answers.
fn standing(mark: &Bookmark, chapter: &Chapter) -> String {
    let (seen, pages) = (mark.seen(chapter), chapter.pages.len());
    let sign = match (mark.is_done(chapter), mark.is_right(chapter)) {
        (true, true) => "✓ ",
        (true, false) => "~ ",
        (false, _) => "",
    };
    match chapter.checkpoints() {
        _ if seen < pages => format!("{sign}read {seen} of {pages}"),
        0 => format!("{sign}read"),
        asked => format!("{sign}right {} of {asked}", mark.right(chapter)),
    }
}

fn about_chapter(book: &Book, chapter: &Chapter) -> Panel<ContentsAction> {
    let mut panel = Panel::new("the chapter");
    panel.paragraph(format!("{} {}", chapter.number, chapter.title), Role::Title);
    panel.gap();
    panel.paragraph(&chapter.about, Role::Text);
    panel.gap();
    let mark = book.mark(&chapter.id).cloned().unwrap_or_default();
    let of = |some: usize, all: usize| format!("{some} of {all}");
    panel.fact("pages seen", of(mark.seen(chapter), chapter.pages.len()));
    let asked = chapter.checkpoints();
    if asked > 0 {
        panel.fact("answered", of(mark.answered(chapter), asked));
        panel.fact("right", of(mark.right(chapter), asked));
        match mark.right_after_hint(chapter) {
            0 => {}
            hinted => panel.fact("  after a hint", hinted.to_string()),
        }
    }
    panel.gap();
    let next = match mark.page(chapter) {
        0 => "read it".into(),
        page => format!("read on at page {}", page + 1),
    };
    panel.prompt(next, ContentsAction::List(ListAction::Open));
    panel
}

fn about_glossary() -> Panel<ContentsAction> {
    let mut panel = Panel::new("the glossary");
    let about = format!(
        "{} terms of mechanics, each explained in one sentence, with the page that introduces it.",
        GlossaryEntry::all().len()
    );
    panel.paragraph(about, Role::Text);
    panel.gap();
    panel.prompt("look up a term", ContentsAction::Glossary);
    panel
}

/// The overall progress, and what to try on the board.
fn summary(contents: &Contents, book: &Book) -> Panel<ContentsAction> {
    let mut panel = Panel::new("so far");
    let chapters = &book.library().chapters;
    let marks = || {
        let chapters = chapters.iter();
        chapters.filter_map(|chapter| Some((book.mark(&chapter.id)?, chapter)))
    };
    let asked: usize = chapters.iter().map(Chapter::checkpoints).sum();
    let answered: usize = marks().map(|(mark, of)| mark.answered(of)).sum();
    let right: usize = marks().map(|(mark, of)| mark.right(of)).sum();
    contents.ahead.write_done(&mut panel);
    panel.fact("answered", format!("{answered} of {asked}"));
    panel.fact("right", right.to_string());
    panel.gap();
    panel.heading("On the board, try this:");
    for idea in [
        "Two equal coins, off-centre: look for the right angle.",
        "A 5.5 g coin deflects a striker of 15 g by at most 21.5°. At which offset?",
        "Levels: use the line of impact to aim.",
    ] {
        panel.item(idea, Role::Text);
    }
    panel
}
