//! How the contents look.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{ContentsLine, chosen, lines};
use crate::lessons::{Book, Bookmark, Chapter};
use crate::screens::Context;
use crate::widgets::input::ListView;
use crate::widgets::{Lines, Role, SplitLayout};

/// The line at a cell.
pub(super) fn line_at(book: &Book, area: Rect, cell: (u16, u16)) -> Option<usize> {
    let list = SplitLayout::new(area).picture;
    ListView::line_at(list, cell, book.at, lines(book).len())
}

/// Draws the contents, and what the chosen line is about.
pub(super) fn draw(area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = SplitLayout::new(area);
    let book = &cx.book;
    if !book.is_known() {
        layout.draw(buf, &look, "learn", "");
        return Lines::new(layout.picture, buf, look).line("Looking …", Role::Dim);
    }
    let all = lines(book);
    let title = match chosen(book) {
        ContentsLine::Chapter(_) => "the chapter",
        ContentsLine::Summary => "so far",
        ContentsLine::Problem(_) => "what is wrong",
    };
    layout.draw(buf, &look, "learn", title);
    let first = ListView::first_shown(book.at, all.len(), layout.picture.height);
    let mut rows = Lines::new(layout.picture, buf, look);
    for (i, line) in all.into_iter().enumerate().skip(first) {
        let (text, side, role) = match line {
            ContentsLine::Chapter(chapter) => chapter_line(book, chapter),
            ContentsLine::Summary => (
                "     How far you have come".into(),
                String::new(),
                Role::Dim,
            ),
            ContentsLine::Problem(fault) => {
                let text = format!("  !  left out: {}", fault.file);
                (text, String::new(), Role::Warn)
            }
        };
        let (mark, role) = role.of_choice(i == book.at);
        rows.pair(&format!("{mark}{text}"), &side, role, role);
    }
    let mut about = Lines::new(layout.panel, buf, look);
    match chosen(book) {
        ContentsLine::Chapter(chapter) => about_chapter(book, chapter, &mut about),
        ContentsLine::Summary => summary(book, &mut about),
        ContentsLine::Problem(fault) => about.paragraph(&fault.to_string(), Role::Text),
    }
}

fn chapter_line(book: &Book, chapter: &Chapter) -> (String, String, Role) {
    let mark = book.mark(&chapter.id);
    let done = match mark {
        Some(mark) if mark.is_done(chapter) && mark.is_right(chapter) => "✓",
        Some(mark) if mark.is_done(chapter) => "~",
        _ => " ",
    };
    let text = format!(" {done}{:>2} {}", chapter.number, chapter.title);
    (
        text,
        mark.map(|mark| standing(mark, chapter)).unwrap_or_default(),
        Role::Text,
    )
}

/// How far a chapter is: its page while it is being read, then how many answers are right.
fn standing(mark: &Bookmark, chapter: &Chapter) -> String {
    let (seen, pages) = (mark.seen(chapter), chapter.pages.len());
    match chapter.checkpoints() {
        _ if seen < pages => format!("read {seen} of {pages}"),
        0 => "read".into(),
        asked => format!("right {} of {asked}", mark.right(chapter)),
    }
}

fn about_chapter(book: &Book, chapter: &Chapter, lines: &mut Lines) {
    lines.paragraph(
        &format!("{} {}", chapter.number, chapter.title),
        Role::Title,
    );
    lines.gap();
    lines.paragraph(&chapter.about, Role::Text);
    lines.gap();
    let mark = book.mark(&chapter.id).cloned().unwrap_or_default();
    let of = |some: usize, all: usize| format!("{some} of {all}");
    lines.fact("pages seen", &of(mark.seen(chapter), chapter.pages.len()));
    let asked = chapter.checkpoints();
    if asked > 0 {
        lines.fact("answered", &of(mark.answered(chapter), asked));
        lines.fact("right", &of(mark.right(chapter), asked));
        match mark.right_after_hint(chapter) {
            0 => {}
            hinted => lines.fact("  after a hint", &hinted.to_string()),
        }
    }
    lines.gap();
    let next = match mark.page(chapter) {
        0 => "Enter: read it.".into(),
        page => format!("Enter: go on at page {}.", page + 1),
    };
    lines.paragraph(&next, Role::Key);
}

/// How far one has come, and what to try on the board.
fn summary(book: &Book, lines: &mut Lines) {
    let chapters = &book.library().chapters;
    let marks = || {
        let chapters = chapters.iter();
        chapters.filter_map(|chapter| Some((book.mark(&chapter.id)?, chapter)))
    };
    let asked: usize = chapters.iter().map(Chapter::checkpoints).sum();
    let answered: usize = marks().map(|(mark, of)| mark.answered(of)).sum();
    let right: usize = marks().map(|(mark, of)| mark.right(of)).sum();
    lines.fact("chapters done", &book.done());
    lines.fact("answered", &format!("{answered} of {asked}"));
    lines.fact("right", &right.to_string());
    lines.gap();
    let weakest = marks()
        .filter_map(|(mark, chapter)| {
            let missed = mark.answered(chapter) - mark.right(chapter);
            (missed > 0).then_some((missed, chapter))
        })
        .max_by_key(|(missed, chapter)| (*missed, std::cmp::Reverse(chapter.number)));
    if let Some((_, chapter)) = weakest {
        let advice = format!(
            "Worth another look: chapter {}, {}. In a week it will teach you more than it would today.",
            chapter.number, chapter.title
        );
        lines.paragraph(&advice, Role::Text);
        lines.gap();
    }
    lines.line("On the board, try this:", Role::Title);
    for idea in [
        "Two equal coins, off-centre: look for the right angle.",
        "Striker on a coin: it turns by 21.5° at most. Find the offset that does it.",
        "Levels: aim by the line of impact.",
    ] {
        lines.flowing("-", 2, &[crate::widgets::flow::Run::new(idea, Role::Text)]);
    }
    if book.next().is_some() {
        lines.gap();
        lines.paragraph("Enter: the next chapter.", Role::Key);
    }
}
