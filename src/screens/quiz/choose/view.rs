//! The view for choosing a round.

use std::sync::Arc;

use super::{
    Choosing, ChoosingAction, ChoosingPage, RoundChoice, chapters_read, choices, code as code_of,
};
use crate::numbers::counted;
use crate::progress::{Mastery, TopicStanding};
use crate::quiz::concepts::Library;
use crate::quiz::{Code, Course, CourseKind, Family};
use crate::screens::{Context, View};
use crate::widgets::Role;
use crate::widgets::input::{ListAction, TextField};
use crate::widgets::panel::Panel;

const WHY_MIXED: &str = "Mixed questions feel harder than many of one kind in a row, and you will \
    miss more of them. But each time you have to recognize the kind of question first, and this \
    helps you remember: weeks later you know more.";

/// The action that opens the chosen line.
const OPEN: ChoosingAction = ChoosingAction::List(ListAction::Open);

/// The list of the page, and a description of the chosen line.
pub(super) fn view<'s>(choosing: &Choosing, cx: &Context) -> View<'s, ChoosingAction> {
    let (list, about) = match &choosing.page {
        ChoosingPage::Rounds => (rounds(choosing, cx), about_round(choosing, cx)),
        ChoosingPage::Topics => (topics(choosing), about_topic(choosing)),
        ChoosingPage::Code { typed, refused } => (code(&cx.own, typed, *refused), about_codes()),
    };
    View::panels(list, about)
}

/// The name of a choice, and its description, which may be empty.
fn words(choice: &RoundChoice) -> (&'static str, &'static str) {
    match choice {
        RoundChoice::Always(kind) => {
            let about = match kind {
                CourseKind::Hits => {
                    "Ten collisions on the board: predict where the striker and the coin will go. Masses and energy losses change from one to the next."
                }
                CourseKind::FindOut => {
                    "Up to twelve questions, each based on your earlier answers. There is no feedback until the end; then you see what you seem to believe about collisions, which answers show it, and where to read more."
                }
                CourseKind::Quick => {
                    "Five questions about what you have read or answered before, the first ones in their simplest form: just right for a short break. If you are new, they are about equal masses."
                }
                CourseKind::Even => {
                    "Ten questions about what you have read or answered before, in any order. You do not know which kind comes next. If you are new, they are about equal masses."
                }
                _ => {
                    "Fifteen questions of all kinds. There is no feedback until the end; then you can open each one with its picture and its explanation."
                }
            };
            (kind.name(), about)
        }
        RoundChoice::Topic => (
            "one topic",
            "Six questions on one topic, getting harder: good when you have just read about that topic. Then return to mixed rounds.",
        ),
        RoundChoice::Read => (
            "what you have read",
            "Ten questions about the chapters that you have finished, in any order.",
        ),
        RoundChoice::Code => (
            "a round by its code",
            "With a code from a friend or a teacher, you get exactly the same questions.",
        ),
        RoundChoice::Own => ("your own questions", ""),
        RoundChoice::Review => ("review what is due", ""),
    }
}

/// The short text beside the name of a choice.
fn beside(choosing: &Choosing, choice: &RoundChoice, cx: &Context) -> String {
    let own = &cx.own;
    match choice {
        RoundChoice::Always(CourseKind::Hits) => "where will they go?".into(),
        RoundChoice::Always(kind @ CourseKind::FindOut) => {
            format!("up to {} questions", kind.length())
        }
        RoundChoice::Always(kind) => format!("{} questions", kind.length()),
        RoundChoice::Topic => format!("{} to choose from", CourseKind::topics().count()),
        RoundChoice::Read if chapters_read(&cx.book).is_none() => "nothing read yet".into(),
        RoundChoice::Read => counted(cx.book.read_through().count(), "chapter"),
        RoundChoice::Code => String::new(),
        RoundChoice::Own => match own.problems.len() {
            0 => format!("of {}", own.concepts.len()),
            left => format!("of {}, {left} left out", own.concepts.len()),
        },
        RoundChoice::Review => match choosing.due().now.len() {
            0 => "nothing due".into(),
            due => format!("{due} due"),
        },
    }
}

/// Whether a choice can be opened.
fn is_open(choosing: &Choosing, choice: &RoundChoice, cx: &Context) -> bool {
    matches!(choice, RoundChoice::Topic | RoundChoice::Code)
        || choosing.course(choice, cx).is_some()
}

fn rounds(choosing: &Choosing, cx: &Context) -> Panel<ChoosingAction> {
    let mut panel = Panel::new("choose a round");
    let choices = choices(cx);
    let chosen = choosing.rounds.chosen(choices.len());
    for (i, (_, choice)) in choices.iter().enumerate() {
        let (name, beside) = (words(choice).0, beside(choosing, choice, cx));
        let role = match is_open(choosing, choice, cx) {
            true => Role::Text,
            false => Role::Dim,
        };
        let name = format!("{} {name}", i + 1);
        let action = ChoosingAction::List(ListAction::Point(i));
        panel.row((name, role), (beside, Role::Dim), i == chosen, action);
        panel.worth(1, Panel::gap);
    }
    panel.worth(2, |panel| {
        panel.gap();
        panel.paragraph(WHY_MIXED, Role::Dim);
    });
    panel
}

fn about_round(choosing: &Choosing, cx: &Context) -> Panel<ChoosingAction> {
    let book = &cx.book;
    let mut panel = Panel::new("this round");
    let choice = choosing.choice(cx);
    let (_, about) = words(choice);
    if !about.is_empty() {
        panel.paragraph(about, Role::Text);
    }
    match choice {
        RoundChoice::Read => {
            panel.gap();
            for chapter in book.read_through() {
                let title = format!("{} {}", chapter.number, chapter.title);
                panel.item(title, Role::Dim);
            }
            if chapters_read(book).is_none() {
                panel.paragraph("First finish a chapter in Learn.", Role::Text);
            }
        }
        RoundChoice::Own => about_own(&cx.own, &mut panel),
        RoundChoice::Review => about_review(choosing, &mut panel),
        _ => {}
    }
    if is_open(choosing, choice, cx) {
        panel.gap();
        let next = match choice {
            RoundChoice::Topic => "choose a topic",
            RoundChoice::Code => "type it",
            _ => "begin",
        };
        panel.prompt(next, OPEN);
    }
    panel
}

fn about_own(own: &Arc<Library>, panel: &mut Panel<ChoosingAction>) {
    let text = match own.concepts.len() {
        0 => "There are no questions to ask.".into(),
        all => {
            let count = all.min(Course::new(CourseKind::Own(own.clone())).count);
            format!("{count} of the questions in a teacher's folder, easy ones first.")
        }
    };
    panel.paragraph(text, Role::Text);
    if !own.problems.is_empty() {
        panel.gap();
        panel.line("Left out:", Role::Dim);
    }
    for problem in &own.problems {
        panel.paragraph(problem.to_string(), Role::Warn);
    }
}

fn about_review(choosing: &Choosing, panel: &mut Panel<ChoosingAction>) {
    if let Some((text, role)) = choosing.history.unknown() {
        return panel.paragraph(text, role);
    }
    let due = choosing.due();
    if due.now.is_empty() {
        let text = match choosing.history.history() {
            None => {
                "There is nothing to review yet. Play any round; what you miss will appear here."
            }
            Some(history) if history.calendar.now_s.is_none() => {
                "carrom does not know the date here, so nothing can be due. Any other round is just as good."
            }
            Some(_) => "Nothing is due: well done. What you know will come back here by itself.",
        };
        panel.paragraph(text, Role::Text);
        if let Some((topic, when)) = &due.next {
            panel.gap();
            panel.paragraph(format!("Next, {when}:"), Role::Dim);
            panel.item(topic.to_string(), Role::Text);
        }
        return;
    }
    let text = "Review what you missed and what you have not seen for a while. Due now:";
    panel.paragraph(text, Role::Text);
    panel.gap();
    for topic in due.first() {
        panel.item(topic.to_string(), Role::Text);
    }
    let left = due.now.len() - due.first().len();
    if left > 0 {
        panel.line(format!("and {left} more after these"), Role::Dim);
    }
}

/// The player's results in a family of questions, if there are any.
fn known(choosing: &Choosing, family: Family) -> Option<TopicStanding> {
    let attempts = &choosing.history.history()?.attempts;
    let of_family = attempts.iter().filter(|it| it.family == family.id());
    let topic = TopicStanding::of(family.name(), of_family);
    (topic.all.attempts > 0).then_some(topic)
}

fn topics(choosing: &Choosing) -> Panel<ChoosingAction> {
    let mut panel = Panel::new("choose a topic");
    let chosen = choosing.topics.chosen(CourseKind::topics().count());
    for (i, family) in CourseKind::topics().enumerate() {
        let mastery = known(choosing, family).map_or(Mastery::New, |topic| topic.mastery());
        let role = match mastery {
            Mastery::Solid => Role::Good,
            _ => Role::Text,
        };
        let name = format!("{} {}", mastery.mark(), family.name());
        let (beside, action) = (mastery.name(), ChoosingAction::List(ListAction::Point(i)));
        panel.row((name, role), (beside, Role::Dim), i == chosen, action);
    }
    panel
}

fn about_topic(choosing: &Choosing) -> Panel<ChoosingAction> {
    let mut panel = Panel::new("this topic");
    let Some(family) = choosing.family() else {
        return panel;
    };
    panel.paragraph(family.name(), Role::Title);
    panel.gap();
    let text = match known(choosing, family) {
        None => "You have not met this topic yet.".into(),
        Some(TopicStanding { all, lately, .. }) => {
            let mut text = format!("{} answered, {} right.", all.attempts, all.right);
            if all.attempts > lately.attempts {
                text += &format!(" Of the last {}, {} right.", lately.attempts, lately.right);
            }
            text
        }
    };
    panel.paragraph(text, Role::Text);
    panel.gap();
    panel.prompt("begin", OPEN);
    panel.gap();
    panel.paragraph(Mastery::legend(), Role::Dim);
    panel
}

fn code(own: &Arc<Library>, typed: &TextField, refused: bool) -> Panel<ChoosingAction> {
    let mut panel = Panel::new("a round by its code");
    panel.text_field("code", typed.around_cursor(), true, None);
    panel.gap();
    match code_of(typed.text(), own) {
        Some(Code { course, seed }) => {
            let name = match &course.kind {
                CourseKind::Topic(_) | CourseKind::Check(_) => course.kind.name(),
                kind => kind.id(),
            };
            // A round of a teacher's questions, or one that is longer than usual, may run out of
            // different questions. To draw them all here would take too long.
            let may_run_out =
                matches!(course.kind, CourseKind::Own(_)) || course.count > course.kind.length();
            let most = match may_run_out || course.follows_answers() {
                true => "at most ",
                false => "",
            };
            let count = counted(course.count, "question");
            let text = format!("{name}: {most}{count}, number {seed}.");
            panel.paragraph(text, Role::Good);
            panel.gap();
            panel.prompt("begin", ChoosingAction::Enter);
        }
        None if refused => {
            let text =
                "This is not the code of a round. Check it again: a name, a hyphen and a number.";
            panel.paragraph(text, Role::Warn);
        }
        None => panel.paragraph("A code looks like even-7.", Role::Dim),
    }
    panel
}

fn about_codes() -> Panel<ChoosingAction> {
    let mut panel = Panel::new("codes");
    let text = "A code consists of the kind of round, the number of questions if it is not the \
                usual one, and a number that fixes the questions:";
    panel.paragraph(text, Role::Text);
    panel.gap();
    for (code, means) in [
        ("even-7", "ten, mixed"),
        ("even12-7", "twelve"),
        ("beliefs-7", "beliefs"),
        ("quick-7", "five"),
        ("exam-7", "an exam"),
        ("speeds-7", "one topic"),
        ("7", "ten hits"),
    ] {
        panel.pair((code, Role::Text), (means, Role::Dim));
    }
    panel.gap();
    let text = "Every round shows its code at the top and at the end.";
    panel.paragraph(text, Role::Dim);
    panel
}
