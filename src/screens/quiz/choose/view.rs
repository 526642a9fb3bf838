//! How choosing a round looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Choosing, ChoosingPage, RoundChoice, chapters_read, code as code_of};
use crate::lessons::Book;
use crate::numbers::counted;
use crate::progress::{Mastery, TopicStanding};
use crate::quiz::{Code, Course, CourseKind, Family};
use crate::screens::Context;
use crate::widgets::input::{ListView, TextField};
use crate::widgets::{Lines, Look, Role, SplitLayout, Words, rehearsed, text};

/// Why rounds are mixed.
const WHY_MIXED: &str = "Mixed questions feel harder than many of one kind in a row, and you will \
    miss more of them. But each time you must see first what kind it is, and that is what stays \
    with you: weeks later you know more.";

/// The line of the page at a cell.
pub(super) fn line_at(choosing: &Choosing, cx: &Context, cell: (u16, u16)) -> Option<usize> {
    let list = SplitLayout::new(cx.body).picture;
    match choosing.page {
        ChoosingPage::Rounds => {
            let row = ListView::row_at(list, cell)?;
            let each = usize::from(rows_of_a_round(choosing, list, cx.settings.look()));
            let at = row / each;
            (row % each == 0 && at < choosing.choices().len()).then_some(at)
        }
        ChoosingPage::Topics => {
            let count = CourseKind::topics().count();
            ListView::line_at(list, cell, choosing.topics.chosen(count), count)
        }
        ChoosingPage::Code { .. } => None,
    }
}

/// Rows of a round in the list: one, and an empty one below it where there is room.
fn rows_of_a_round(choosing: &Choosing, list: Rect, look: Look) -> u16 {
    let why = rehearsed(list, look, |lines| lines.rows_of(WHY_MIXED));
    let rounds = choosing.choices().len() as u16;
    if list.height > 2 * rounds + why { 2 } else { 1 }
}

/// Draws the page.
pub(super) fn draw(choosing: &Choosing, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = SplitLayout::new(area);
    let (list, about) = match choosing.page {
        ChoosingPage::Rounds => ("choose a round", "this round"),
        ChoosingPage::Topics => ("choose a topic", "this topic"),
        ChoosingPage::Code { .. } => ("a round by its code", "codes"),
    };
    layout.draw(buf, &look, list, about);
    let each = rows_of_a_round(choosing, layout.picture, look);
    let mut lines = Lines::new(layout.picture, buf, look);
    match &choosing.page {
        ChoosingPage::Rounds => rounds(choosing, &cx.book, each, &mut lines),
        ChoosingPage::Topics => topics(choosing, &mut lines),
        ChoosingPage::Code { typed, refused } => code(choosing, typed, *refused, &mut lines),
    }
    let mut lines = Lines::new(layout.panel, buf, look);
    match choosing.page {
        ChoosingPage::Rounds => about_round(choosing, &cx.book, &mut lines),
        ChoosingPage::Topics => about_topic(choosing, &mut lines),
        ChoosingPage::Code { .. } => about_codes(&mut lines),
    }
}

/// A line that can be chosen, with what is said of it on the right.
fn line(lines: &mut Lines, name: &str, value: &str, chosen: bool, role: Role) {
    let (_, value_role) = Role::Dim.of_choice(chosen);
    lines.choice(chosen, role, |lines, mark, role| {
        let name = format!("{mark} {name}");
        let room = usize::from(lines.width()).saturating_sub(text::width(&name) + 2);
        let value = if text::width(value) <= room {
            value
        } else {
            ""
        };
        lines.pair(&name, value, role, value_role);
    });
}

fn rounds(choosing: &Choosing, book: &Book, each: u16, lines: &mut Lines) {
    let chosen = choosing.rounds.chosen(choosing.choices().len());
    let (due, own) = (choosing.due().now.len(), &choosing.own);
    for (i, (_, choice)) in choosing.choices().iter().enumerate() {
        let (name, value) = match choice {
            RoundChoice::Always(CourseKind::Hits) => {
                (CourseKind::Hits.name(), "where will they go?".into())
            }
            RoundChoice::Always(CourseKind::FindOut) => {
                let value = format!("up to {} questions", CourseKind::FindOut.length());
                (CourseKind::FindOut.name(), value)
            }
            RoundChoice::Always(kind) => (kind.name(), format!("{} questions", kind.length())),
            RoundChoice::Topic => {
                let value = format!("{} to choose from", CourseKind::topics().count());
                ("one topic", value)
            }
            RoundChoice::Read => {
                let value = match chapters_read(book) {
                    None => "nothing read yet".into(),
                    Some(_) => counted(book.read_through().count(), "chapter"),
                };
                ("what you have read", value)
            }
            RoundChoice::Code => ("a round by its code", String::new()),
            RoundChoice::Own => {
                let value = match own.problems.len() {
                    0 => format!("of {}", own.concepts.len()),
                    left => format!("of {}, {left} left out", own.concepts.len()),
                };
                ("your own questions", value)
            }
            RoundChoice::Review if due == 0 => ("review what is due", "nothing due".into()),
            RoundChoice::Review => ("review what is due", format!("{due} due")),
        };
        let role = match choice {
            RoundChoice::Review if due == 0 => Role::Dim,
            RoundChoice::Own if own.concepts.is_empty() => Role::Dim,
            RoundChoice::Read if chapters_read(book).is_none() => Role::Dim,
            _ => Role::Text,
        };
        let name = format!("{} {name}", i + 1);
        line(lines, &name, &value, i == chosen, role);
        for _ in 1..each {
            lines.line("", Role::Text);
        }
    }
    if each == 1 {
        lines.gap();
    }
    lines.paragraph(WHY_MIXED, Role::Dim);
}

fn about_round(choosing: &Choosing, book: &Book, lines: &mut Lines) {
    let text = match choosing.choice() {
        RoundChoice::Always(CourseKind::Quick) => {
            "Five questions, each of another kind, the first ones in their plainest form. Any kind may come up, even one you have not met yet: just right for a short break."
        }
        RoundChoice::Always(CourseKind::FindOut) => {
            "Up to twelve questions, each chosen by your answers before it. You hear nothing until the end; then you see what you seem to believe about hits, which answers say so, and what settles it."
        }
        RoundChoice::Always(CourseKind::Even) => {
            "Ten questions of all kinds, in any order, so that every idea is met. Nobody tells you what kind comes next."
        }
        RoundChoice::Review => return about_review(choosing, lines),
        RoundChoice::Own => return about_own(choosing, lines),
        RoundChoice::Read => return about_read(book, lines),
        RoundChoice::Always(CourseKind::Hits) => {
            "Ten hits on the board: say where the striker and the coin will go. Masses and losses change from hit to hit."
        }
        RoundChoice::Topic => {
            "Six questions of one kind, which get harder: good when you have just read about it. Then come back to mixed rounds."
        }
        RoundChoice::Always(_) => {
            "Fifteen questions of all kinds. You hear nothing until the end; then you can open each one with its picture and its why."
        }
        RoundChoice::Code => {
            "A friend or a teacher gave you a code? With it you get the very same questions."
        }
    };
    lines.paragraph(text, Role::Text);
    lines.gap();
    let next = match choosing.choice() {
        RoundChoice::Topic => "Enter: choose a topic.",
        RoundChoice::Code => "Enter: type it.",
        _ => "Enter: begin.",
    };
    lines.line(next, Role::Key);
}

fn about_read(book: &Book, lines: &mut Lines) {
    lines.paragraph(
        "Ten questions about what the chapters teach that you have read to their end, in any order.",
        Role::Text,
    );
    lines.gap();
    if chapters_read(book).is_none() {
        return lines.paragraph("Read one of them in Learn first.", Role::Text);
    }
    for chapter in book.read_through() {
        lines.line(&format!(" {} {}", chapter.number, chapter.title), Role::Dim);
    }
    lines.gap();
    lines.line("Enter: begin.", Role::Key);
}

fn about_own(choosing: &Choosing, lines: &mut Lines) {
    let own = &choosing.own;
    if own.concepts.is_empty() {
        lines.paragraph("There are none that can be asked.", Role::Text);
    } else {
        let count = own
            .concepts
            .len()
            .min(Course::new(CourseKind::Own(own.clone())).count);
        let text = format!(
            "{count} of the questions that a teacher wrote and put into a folder, easy ones first."
        );
        lines.paragraph(&text, Role::Text);
        lines.gap();
        lines.line("Enter: begin.", Role::Key);
    }
    if !own.problems.is_empty() {
        lines.gap();
        lines.line("Left out:", Role::Dim);
    }
    for problem in &own.problems {
        lines.paragraph(&problem.to_string(), Role::Warn);
    }
}

fn about_review(choosing: &Choosing, lines: &mut Lines) {
    let due = choosing.due();
    if choosing.history.write_unknown(lines) {
        return;
    }
    if due.now.is_empty() {
        let text = match choosing.history.history() {
            None => "Nothing to come back to yet. Play any round; what you miss will wait here.",
            Some(history) if history.calendar.now_s.is_none() => {
                "The date is not known here, so nothing can be due. Any other round is just as good."
            }
            Some(_) => {
                "Nothing is due: well done. Let what you know rest; it comes back here by itself."
            }
        };
        lines.paragraph(text, Role::Text);
        if let Some((topic, when)) = &due.next {
            lines.gap();
            lines.paragraph(&format!("Next, {when}:"), Role::Dim);
            lines.line(&format!(" {topic}"), Role::Text);
        }
        return;
    }
    lines.paragraph(
        "Come back to what you missed and to what has rested long enough. Due now:",
        Role::Text,
    );
    lines.gap();
    for topic in due.first() {
        lines.line(&format!(" {topic}"), Role::Text);
    }
    match due.now.len() - due.first().len() {
        0 => {}
        left => lines.line(&format!(" and {left} more after these"), Role::Dim),
    }
    lines.gap();
    lines.line("Enter: begin.", Role::Key);
}

/// What was done with a family, if anything.
fn known(choosing: &Choosing, family: Family) -> Option<TopicStanding> {
    let attempts = &choosing.history.history()?.attempts;
    let of_family = attempts.iter().filter(|it| it.family == family.id());
    let topic = TopicStanding::of(family.name(), of_family);
    (topic.all.attempts > 0).then_some(topic)
}

fn topics(choosing: &Choosing, lines: &mut Lines) {
    let count = CourseKind::topics().count();
    let chosen = choosing.topics.chosen(count);
    let first = ListView::first_shown(chosen, count, lines.left());
    for (i, family) in CourseKind::topics().enumerate().skip(first) {
        let mastery = known(choosing, family).map_or(Mastery::New, |topic| topic.mastery());
        let role = match mastery {
            Mastery::Solid => Role::Good,
            _ => Role::Text,
        };
        let name = format!("{} {}", mastery.mark(), family.name());
        line(lines, &name, mastery.name(), i == chosen, role);
    }
}

fn about_topic(choosing: &Choosing, lines: &mut Lines) {
    let Some(family) = choosing.family() else {
        return;
    };
    lines.paragraph(family.name(), Role::Title);
    lines.gap();
    match known(choosing, family) {
        None => lines.paragraph("You have not met it yet.", Role::Text),
        Some(topic) => {
            let (all, lately) = (topic.all, topic.lately);
            let mut text = format!("{} answered, {} right.", all.attempts, all.right);
            if all.attempts > lately.attempts {
                text += &format!(" Of the last {}, {}.", lately.attempts, lately.right);
            }
            lines.paragraph(&text, Role::Text);
        }
    }
    lines.gap();
    lines.line("Enter: begin.", Role::Key);
    lines.gap();
    lines.paragraph(&Mastery::legend(), Role::Dim);
}

fn code(choosing: &Choosing, typed: &TextField, refused: bool, lines: &mut Lines) {
    lines.line("The code of the round:", Role::Text);
    lines.gap();
    let recorded = |_| Words::text_field("code", typed.text());
    lines.clicked_as(recorded, Some(true), |lines| {
        lines.line(&format!("> {}", typed.shown()), Role::Selected);
    });
    lines.gap();
    match code_of(typed.text(), &choosing.own) {
        Some(Code { course, seed }) => {
            let Course { kind, count } = &course;
            let name = match &kind {
                CourseKind::Topic(_) | CourseKind::Check(_) => kind.name(),
                kind => kind.id(),
            };
            let most = if course.follows_answers() {
                "at most "
            } else {
                ""
            };
            let text = format!("{name}: {most}{count} questions, number {seed}.");
            lines.paragraph(&text, Role::Good);
            lines.gap();
            lines.line("Enter: begin.", Role::Key);
        }
        None if refused => {
            let text = "That is not the code of a round yet. Look at it once more: a name, a hyphen and a number.";
            lines.paragraph(text, Role::Warn);
        }
        None => lines.paragraph("It reads like even-7.", Role::Dim),
    }
}

fn about_codes(lines: &mut Lines) {
    lines.paragraph(
        "A code has the kind of round, how many questions if it is not the usual number, and a number that fixes them:",
        Role::Text,
    );
    lines.gap();
    for (code, means) in [
        ("even-7", "ten, mixed"),
        ("even12-7", "twelve"),
        ("find-out-7", "beliefs"),
        ("quick-7", "five"),
        ("exam-7", "an exam"),
        ("speeds-7", "one topic"),
        ("7", "ten hits"),
    ] {
        lines.pair(&format!(" {code}"), means, Role::Text, Role::Dim);
    }
    lines.gap();
    lines.paragraph(
        "Every round shows its own at the top and at the end.",
        Role::Dim,
    );
}
