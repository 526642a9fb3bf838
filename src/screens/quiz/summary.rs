//! The look back over a round.

use super::Quiz;
use crate::quiz::{
    Answer, Confidence, CourseKind, Form, Question, Summary, SummaryLine, explain, words,
};
use crate::widgets::{Lines, Role};

/// Writes the look back: the score, a row a question, how well confidence and answers
/// went together, and what to try next.
pub(super) fn write(quiz: &Quiz, lines: &mut Lines) {
    let summary = quiz.summary();
    let table = Table::new(lines.width());
    let closing = closing(&summary);
    let closing_rows: u16 = closing.iter().map(|text| lines.rows_of(text)).sum();
    let rows = summary.lines.len() as u16;
    let score = score(&summary);
    let mut spare = lines.spare(lines.rows_of(&score) + HEAD + rows + closing_rows);
    let gap_after = spare.take(1);
    let gap_before = spare.take(1);
    let friend = spare.take(2);
    let apart = spare.take(closing.len() as u16 - 1);
    lines.paragraph(&score, Role::Title);
    if gap_before {
        lines.gap();
    }
    let answered = quiz.round.questions().iter().zip(&quiz.answers);
    let rays = |question: &Question| matches!(question.form, Form::Rays { .. });
    let all_rays = answered.clone().all(|(question, _)| rays(question));
    table.head(summary.lines.iter().any(missed_surely), all_rays, lines);
    for (i, (line, answered)) in summary.lines.iter().zip(answered).enumerate() {
        table.row(i + 1, line, answered, lines);
    }
    if gap_after {
        lines.gap();
    }
    for (i, text) in closing.iter().enumerate() {
        if apart && i > 0 {
            lines.gap();
        }
        lines.paragraph(text, Role::Text);
    }
    if friend {
        let code = quiz.round.code();
        let command = match code.course.kind {
            CourseKind::Hits => format!("The same ten for a friend: carrom quiz --seed {code}"),
            _ => format!("The same round for a friend: carrom quiz --code {code}"),
        };
        lines.gap();
        lines.line(&command, Role::Dim);
    }
}

fn score(summary: &Summary) -> String {
    let mut text = format!(
        "{:.1} of {:.0} points, {} of {} right",
        summary.points(),
        summary.most(),
        summary.right(),
        summary.lines.len()
    );
    if let Some(error) = summary.mean_error() {
        text += &format!(", mean error {}", words::degrees(error));
    }
    text
}

/// What follows from the round, a paragraph each.
fn closing(summary: &Summary) -> Vec<String> {
    let mut closing = vec![summary.calibration_words()];
    if let Some((misconception, count)) = summary.most_held() {
        closing.push(match count {
            1 => format!("Once it looked like this: {}.", misconception.name),
            _ => format!("Most often, {count} times: {}.", misconception.name),
        });
    }
    closing.push(summary.advice());
    closing
}

fn missed_surely(line: &SummaryLine) -> bool {
    line.grade.confidence == Confidence::Sure && !line.grade.right
}

/// Rows of [`Table::head`].
const HEAD: u16 = 2;

/// The columns of the look back; the more room, the more of them.
struct Table {
    gap: &'static str,
    confidence: bool,
    topic: bool,
}

impl Table {
    fn new(width: u16) -> Self {
        Self {
            gap: if width >= 72 { "   " } else { "" },
            confidence: width >= 72,
            topic: width >= 104,
        }
    }

    fn head(&self, marked: bool, rays: bool, lines: &mut Lines) {
        let gap = self.gap;
        let legend = if marked { "! sure, but off" } else { "" };
        let over = format!(
            "   {gap}{:>9}{gap}{:>10}{gap}       {legend}",
            "you said", "truth"
        );
        lines.line(&over, Role::Dim);
        let each = if rays { "   S    C" } else { "" };
        let head = self.cells(["", " ", each, each, "pts"], "sure?", "about", "it was");
        lines.line(&head, Role::Dim);
    }

    fn row(
        &self,
        number: usize,
        line: &SummaryLine,
        (question, answer): (&Question, &Answer),
        lines: &mut Lines,
    ) {
        let said = question.form.brief(&answer.said);
        let truth = question.form.brief(&question.form.truth());
        let number = number.to_string();
        let points = format!("{:.1}", line.grade.points() + 0.0);
        let missed = missed_surely(line);
        let mark = if missed { "!" } else { " " };
        let role = match missed {
            true => Role::Warn,
            false if line.grade.right => Role::Good,
            false => Role::Text,
        };
        let row = self.cells(
            [&number, mark, &said, &truth, &points],
            line.grade.confidence.name(),
            &line.topic,
            explain(question, answer).title,
        );
        lines.line(&row, role);
    }

    /// Number, mark, what was said, the truth and points; then words.
    fn cells(&self, cells: [&str; 5], confidence: &str, topic: &str, what: &str) -> String {
        let gap = self.gap;
        let [number, mark, said, truth, points] = cells;
        let mut row = format!("{number:>2}{mark}{gap}{said:>9}{gap}{truth:>10}{gap}{points:>5}  ");
        if self.confidence {
            row += &format!("{confidence:10}");
        }
        if self.topic {
            row += &format!("{topic:28}");
        }
        row + what
    }
}
