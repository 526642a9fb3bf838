//! How the contents look.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Line, chosen, lines};
use crate::lessons::Chapter;
use crate::screens::book::checkpoints;
use crate::screens::{Book, Context};
use crate::widgets::{Beside, Lines, Role};

/// The first line shown: the chosen one stands in the middle where there are more
/// lines than rows.
fn first_shown(book: &Book, height: usize) -> usize {
    let most = lines(book).len().saturating_sub(height);
    book.at.saturating_sub(height / 2).min(most)
}

/// The line at a cell.
pub(super) fn line_at(book: &Book, area: Rect, cell: (u16, u16)) -> Option<usize> {
    let list = Beside::new(area).picture;
    let at = first_shown(book, list.height.into()) + usize::from(cell.1.checked_sub(list.y)?);
    (list.contains(cell.into()) && at < lines(book).len()).then_some(at)
}

/// Draws the contents, and what the chosen line is about.
pub(super) fn draw(area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = Beside::new(area);
    let book = &cx.book;
    let title = match chosen(book) {
        Line::Chapter(_) => "the chapter",
        Line::Summary => "so far",
        Line::Problem(_) => "what is wrong",
    };
    layout.draw(buf, &look, "learn", title);
    let first = first_shown(book, layout.picture.height.into());
    let mut rows = Lines::new(layout.picture, buf, look);
    for (i, line) in lines(book).into_iter().enumerate().skip(first) {
        let here = i == book.at;
        let mark = if here { ">" } else { " " };
        let (text, side, role) = match line {
            Line::Chapter(number) => chapter_line(book, number),
            Line::Summary => (
                "     How far you have come".into(),
                String::new(),
                Role::Dim,
            ),
            Line::Problem(number) => {
                let file = book
                    .library()
                    .problems
                    .get(number)
                    .map_or("", |fault| &fault.file);
                (format!("  !  left out: {file}"), String::new(), Role::Warn)
            }
        };
        let role = if here { Role::Selected } else { role };
        rows.pair(&format!("{mark}{text}"), &side, role, role);
    }
    let mut about = Lines::new(layout.panel, buf, look);
    match chosen(book) {
        Line::Chapter(number) => {
            if let Some(chapter) = book.chapter(number) {
                about_chapter(book, chapter, &mut about);
            }
        }
        Line::Summary => summary(book, &mut about),
        Line::Problem(number) => {
            if let Some(fault) = book.library().problems.get(number) {
                about.paragraph(&fault.to_string(), Role::Text);
            }
        }
    }
}

fn chapter_line(book: &Book, number: usize) -> (String, String, Role) {
    let Some(chapter) = book.chapter(number) else {
        return (String::new(), String::new(), Role::Text);
    };
    let mark = book.mark(&chapter.id);
    let done = if book.is_done(chapter) { "✓" } else { " " };
    let side = match mark {
        Some(mark) if mark.seen() > 0 => format!("{}/{}", mark.seen(), chapter.pages.len()),
        _ => String::new(),
    };
    (
        format!(" {done}{:>2} {}", chapter.number, chapter.title),
        side,
        Role::Text,
    )
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
    lines.pair(
        "pages seen",
        &of(mark.seen(), chapter.pages.len()),
        Role::Dim,
        Role::Text,
    );
    let asked = checkpoints(chapter);
    if asked > 0 {
        lines.pair(
            "answered",
            &of(mark.answered(), asked),
            Role::Dim,
            Role::Text,
        );
        lines.pair("right", &of(mark.right(), asked), Role::Dim, Role::Text);
    }
    lines.gap();
    let next = match mark.page {
        0 => "Enter: read it.".into(),
        page => format!("Enter: go on at page {}.", page + 1),
    };
    lines.paragraph(&next, Role::Key);
}

/// How far one has come, and what to try on the board.
fn summary(book: &Book, lines: &mut Lines) {
    let chapters = &book.library().chapters;
    let done = chapters
        .iter()
        .filter(|chapter| book.is_done(chapter))
        .count();
    let marks = || chapters.iter().filter_map(|chapter| book.mark(&chapter.id));
    let asked: usize = chapters.iter().map(checkpoints).sum();
    let answered: usize = marks().map(|mark| mark.answered()).sum();
    let right: usize = marks().map(|mark| mark.right()).sum();
    lines.pair(
        "chapters done",
        &format!("{done} of {}", chapters.len()),
        Role::Dim,
        Role::Text,
    );
    lines.pair(
        "answered",
        &format!("{answered} of {asked}"),
        Role::Dim,
        Role::Text,
    );
    lines.pair("right", &right.to_string(), Role::Dim, Role::Text);
    lines.gap();
    let weakest = chapters
        .iter()
        .filter_map(|chapter| {
            let mark = book.mark(&chapter.id)?;
            let missed = mark.answered() - mark.right();
            (missed > 0).then_some((missed, chapter))
        })
        .max_by_key(|(missed, chapter)| (*missed, std::cmp::Reverse(chapter.number)));
    if let Some((_, chapter)) = weakest {
        let advice = format!(
            "Worth another look: chapter {}, {}. A week from now it will teach you more than today.",
            chapter.number, chapter.title
        );
        lines.paragraph(&advice, Role::Text);
        lines.gap();
    }
    lines.line("On the board, try this:", Role::Title);
    for idea in [
        "Two equal coins, off-centre: look for the square corner.",
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
