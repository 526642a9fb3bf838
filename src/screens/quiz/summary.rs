//! The summary of a round.

use super::{Quiz, QuizAction};
use crate::lessons::Book;
use crate::numbers;
use crate::progress::{Attempt, Summary};
use crate::quiz::{Code, CourseKind, Form, Grade, Origin, explain};
use crate::screens::leads;
use crate::widgets::Role;
use crate::widgets::input::ListAction;
use crate::widgets::panel::{Panel, TableColumn, TableRow};

/// The largest width of the summary with its frame, in columns.
pub(super) const WIDEST: u16 = 108;
/// The smallest width of a panel with both the topic and what the answer showed.
const WIDE: u16 = 104;

/// The summary: the score, one row per question with a mark at question `at`, how well
/// confidence matched the answers, and what to try next. In a round that looks for a
/// misconception, the finding replaces the score and the words on confidence.
pub(super) fn panel(quiz: &Quiz, at: usize, book: &Book) -> Panel<QuizAction> {
    let summary = quiz.summary();
    let finds_out = quiz.round.course().follows_answers();
    let (title, opening, closing) = match finds_out {
        true => ("what you seem to believe", summary.finding(), Vec::new()),
        false => (
            "your round",
            vec![score(&summary), summary.points_words()],
            closing(quiz, &summary),
        ),
    };
    let mut panel = Panel::new(title);
    for (i, text) in opening.into_iter().enumerate() {
        let role = if i == 0 { Role::Title } else { Role::Text };
        panel.paragraph(text, role);
    }
    panel.worth(4, Panel::gap);
    table(quiz, &summary, at, &mut panel);
    panel.worth(5, Panel::gap);
    for (i, text) in closing.into_iter().enumerate() {
        if i > 0 {
            panel.worth(2, Panel::gap);
        }
        panel.paragraph(text, Role::Text);
    }
    leads::write(quiz.passage(book), book, QuizAction::ReadUp, &mut panel);
    if let Some(ahead) = &quiz.ahead {
        panel.worth(4, Panel::gap);
        ahead.write(QuizAction::Next, &mut panel);
    }
    if let Some(found) = quiz.found() {
        let check = match found.origin() {
            Origin::Slip => "check with two questions whether it still happens",
            _ => "check with two questions whether you still believe it",
        };
        panel.prompt(check, QuizAction::Check);
    }
    if let Some((text, command)) = for_a_friend(quiz.round.code()) {
        panel.worth(3, Panel::gap);
        let address = format!("quiz={}", quiz.round.code());
        panel.code(text, command, address);
    }
    panel
}

/// The command that gives a friend the same round; `None` for a round that depends on the player or
/// on a teacher's files.
fn for_a_friend(code: &Code) -> Option<(&'static str, String)> {
    let (text, option) = match code.course.kind {
        CourseKind::Met(_) | CourseKind::Review(_) | CourseKind::Own(_) | CourseKind::Set(_) => {
            return None;
        }
        CourseKind::Hits => ("The same ten for a friend", "--seed"),
        _ => ("The same round for a friend", "--code"),
    };
    Some((text, format!("carrom quiz {option} {code}")))
}

fn score(summary: &Summary) -> String {
    let mut text = summary.score();
    if let Some(error) = summary.mean_error() {
        let (error, angles) = (numbers::degrees(error), summary.angles());
        text += &format!(", mean error {error} of {angles} angles");
    }
    text
}

/// The conclusions from the round, one paragraph each.
fn closing(quiz: &Quiz, summary: &Summary) -> Vec<String> {
    let mut closing = vec![summary.calibration_words()];
    match quiz.round.course().kind {
        CourseKind::Check(misconception) => closing.push(summary.checked(misconception)),
        _ => {
            closing.extend(summary.held_words());
            closing.extend(summary.most_held().map(|it| it.advice().into()));
        }
    }
    closing
}

/// One row per question: the answer, the true answer, the points, the confidence and, if there is
/// room, the topic and what the answer showed.
fn table(quiz: &Quiz, summary: &Summary, at: usize, panel: &mut Panel<QuizAction>) {
    let answered = || quiz.round.questions().iter().zip(&quiz.answers);
    let all_rays = answered().all(|(question, _)| matches!(question.form, Form::Rays { .. }));
    // Many answers are unclear without their topic; but in a round that looks for a
    // misconception, the topic matters less than what the answer showed.
    let shows_topic = !all_rays && !quiz.round.course().follows_answers();
    let if_wide = |always| if always { 0 } else { WIDE };
    let [said, truth] = match all_rays {
        true => ["you S    C", "true S    C"],
        false => ["you said", "truth"],
    };
    let columns = vec![
        TableColumn::numbers("", 3),
        TableColumn::numbers(said, 10),
        TableColumn::numbers(truth, 11),
        TableColumn::numbers("pts", 5),
        TableColumn::words("sure?", 10).from(72),
        TableColumn::words("about", 28).from(if_wide(shows_topic)),
        TableColumn::words("it was", 0).from(if_wide(!shows_topic)),
    ];
    let lines = summary.attempts.iter().zip(answered()).enumerate();
    let rows = lines.map(|(number, (attempt, (question, answer)))| {
        let missed = was_far_off(attempt);
        let role = match missed {
            true => Role::Warn,
            false if attempt.right => Role::Good,
            false => Role::Text,
        };
        let cells = vec![
            format!("{}{}", number + 1, if missed { "!" } else { " " }),
            question.form.brief(&answer.said),
            question.form.brief(&question.form.truth()),
            numbers::points(attempt.earned()),
            answer.confidence.name().into(),
            question.topic.name(),
            explain(question, answer).title.into(),
        ];
        TableRow {
            chosen: number == at,
            action: Some(QuizAction::LookBack(ListAction::Point(number))),
            ..TableRow::of(cells, role)
        }
    });
    panel.table(columns, rows.collect(), None);
    if summary.attempts.iter().any(was_far_off) {
        panel.line("! sure, but wrong", Role::Dim);
    }
}

/// Whether the player was sure of an answer that earned less than half of the points. An answer
/// only just outside the tolerance is wrong, too, but earns nearly all of them.
pub(super) fn was_far_off(attempt: &Attempt) -> bool {
    attempt.is_surely_wrong() && attempt.earned() < 0.5 * Grade::MOST
}
