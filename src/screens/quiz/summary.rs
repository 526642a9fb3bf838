//! The look back over a round.

use super::Quiz;
use crate::quiz::{Answer, Confidence, Question, Summary, SummaryLine, explain, words};
use crate::widgets::hit::degrees;
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
    table.head(summary.lines.iter().any(missed_surely), lines);
    let answered = quiz.round.questions().iter().zip(&quiz.answers);
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
        let code = quiz.round.seed();
        lines.gap();
        lines.line(
            &format!("The same ten for a friend: carrom quiz --seed {code}"),
            Role::Dim,
        );
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
    line.grade.confidence == Confidence::Sure && !line.grade.is_right()
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

    fn head(&self, marked: bool, lines: &mut Lines) {
        let gap = self.gap;
        let legend = if marked { "! sure, but off" } else { "" };
        let over = format!(
            "   {gap}{:>9}{gap}{:>10}{gap}       {legend}",
            "you said", "truth"
        );
        lines.line(&over, Role::Dim);
        let head = ["", " ", "S", "C", "S", "C", "pts"];
        let head = self.cells(head, "sure?", "about", "it was");
        lines.line(&head, Role::Dim);
    }

    fn row(
        &self,
        number: usize,
        line: &SummaryLine,
        (question, answer): (&Question, &Answer),
        lines: &mut Lines,
    ) {
        let collision = question.collision();
        let [s1, c1] = degrees(&collision, &answer.rays).map(whole);
        let [s2, c2] = degrees(&collision, &question.truth()).map(whole);
        let number = number.to_string();
        let points = format!("{:.1}", line.grade.points() + 0.0);
        let missed = missed_surely(line);
        let mark = if missed { "!" } else { " " };
        let role = match missed {
            true => Role::Warn,
            false if line.grade.is_right() => Role::Good,
            false => Role::Text,
        };
        let row = self.cells(
            [&number, mark, &s1, &c1, &s2, &c2, &points],
            line.grade.confidence.name(),
            &line.topic,
            explain(question, answer).title,
        );
        lines.line(&row, role);
    }

    /// Number, mark, both angles said, both true ones and points; then words.
    fn cells(&self, cells: [&str; 7], confidence: &str, topic: &str, what: &str) -> String {
        let gap = self.gap;
        let [number, mark, s1, c1, s2, c2, points] = cells;
        let mut row =
            format!("{number:>2}{mark}{gap}{s1:>4}{c1:>5}{gap}{s2:>5}{c2:>5}{gap}{points:>5}  ");
        if self.confidence {
            row += &format!("{confidence:10}");
        }
        if self.topic {
            row += &format!("{topic:28}");
        }
        row + what
    }
}

/// An angle to the degree, in at most four columns.
fn whole(angle_deg: Option<f64>) -> String {
    angle_deg.map_or("rest".into(), |angle| format!("{:.0}", angle.round() + 0.0))
}
