//! The look back over a round.

use super::Quiz;
use crate::lessons::Book;
use crate::numbers;
use crate::quiz::{
    Answer, Code, Confidence, CourseKind, Form, Question, Summary, SummaryLine, explain,
};
use crate::screens::leads;
use crate::widgets::flow::Run;
use crate::widgets::{Charset, Lines, Role, Words};

/// Writes the look back: the score, a row a question with a mark at the one `at`, how
/// well confidence and answers went together, and what to try next. Gives the row of
/// the first question.
pub(super) fn write(quiz: &Quiz, at: usize, book: &Book, lines: &mut Lines) -> u16 {
    let summary = quiz.summary();
    let answered = quiz.round.questions().iter().zip(&quiz.answers);
    let rays = |question: &Question| matches!(question.form, Form::Rays { .. });
    let all_rays = answered.clone().all(|(question, _)| rays(question));
    let finds_out = quiz.round.course().follows_answers();
    let table = SummaryTable::new(lines, all_rays, finds_out);
    let (opening, closing) = match quiz.round.course().kind {
        CourseKind::FindOut => (summary.finding(), after_finding(quiz)),
        _ => (vec![score(&summary)], closing(quiz, &summary)),
    };
    let opening_rows: u16 = opening.iter().map(|text| lines.rows_of(text)).sum();
    let closing_rows: u16 = closing.iter().map(|text| lines.rows_of(text)).sum();
    let rows = summary.lines.len() as u16;
    let friend = for_a_friend(quiz.round.code());
    let friend_rows = friend.as_ref().map_or(0, |text| lines.rows_of(text));
    let lead = |lines: &mut Lines| leads::write(summary.passage(), book, lines);
    let lead_rows = lines.rows_by(lead);
    let needed = opening_rows + HEAD + rows + closing_rows + lead_rows + friend_rows;
    let mut spare = lines.spare(needed);
    let gap_after = spare.take(1);
    let gap_before = spare.take(1);
    let before_friend = spare.take(1);
    let apart = spare.take((closing.len() as u16).saturating_sub(1));
    for (i, text) in opening.iter().enumerate() {
        let role = if i == 0 { Role::Title } else { Role::Text };
        lines.paragraph(text, role);
    }
    if gap_before {
        lines.gap();
    }
    table.head(summary.lines.iter().any(missed_surely), lines);
    let first = lines.written();
    for (i, (line, answered)) in summary.lines.iter().zip(answered).enumerate() {
        table.row((i, i == at), line, answered, lines);
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
    lead(lines);
    if let Some(command) = friend {
        if before_friend {
            lines.gap();
        }
        lines.paragraph(&command, Role::Dim);
    }
    first
}

/// How a friend gets the same round; a review is its player's alone.
fn for_a_friend(code: &Code) -> Option<String> {
    match code.course.kind {
        CourseKind::Review(_) | CourseKind::Own(_) => None,
        CourseKind::Hits => Some(format!(
            "The same ten for a friend: carrom quiz --seed {code}"
        )),
        _ => Some(format!(
            "The same round for a friend: carrom quiz --code {code}"
        )),
    }
}

fn score(summary: &Summary) -> String {
    let mut text = summary.score();
    if let Some(error) = summary.mean_error() {
        text += &format!(
            ", mean error {} of {} angles",
            numbers::degrees(error),
            summary.angles()
        );
    }
    text
}

/// What follows from the round, a paragraph each.
fn closing(quiz: &Quiz, summary: &Summary) -> Vec<String> {
    let mut closing = vec![summary.calibration_words()];
    match quiz.round.course().kind {
        CourseKind::Check(misconception) => closing.push(summary.checked(misconception)),
        _ => {
            closing.extend(summary.held_words());
            closing.push(summary.advice());
        }
    }
    closing
}

/// What to do after a belief was found out.
fn after_finding(quiz: &Quiz) -> Vec<String> {
    let check = "Have a look at it first. Then k asks two questions, to check what became of it.";
    let found = quiz.found().map(|_| check.to_owned());
    found.into_iter().collect()
}

fn missed_surely(line: &SummaryLine) -> bool {
    line.grade.confidence == Confidence::Sure && !line.grade.right
}

/// Rows of [`SummaryTable::head`].
const HEAD: u16 = 2;

/// Columns of a topic, where there is room for what it was too.
const TOPIC: usize = 28;

/// The columns of the look back; the more room, the more of them.
struct SummaryTable {
    gap: &'static str,
    /// Whether every answer is two rays, with a column for each of them.
    rays: bool,
    confidence: bool,
    /// What the question was about.
    topic: bool,
    /// What became of the answer, in words.
    outcome: bool,
}

impl SummaryTable {
    fn new(lines: &Lines, rays: bool, finds_out: bool) -> Self {
        let width = lines.width();
        Self {
            gap: if width >= 72 { "   " } else { "" },
            rays,
            confidence: width >= 72,
            // Where answers are of many forms, one wants to know to what; unless what they
            // show is what was looked for.
            topic: width >= 104 || !rays && !finds_out,
            outcome: width >= 104 || rays || finds_out,
        }
    }

    fn head(&self, marked: bool, lines: &mut Lines) {
        let gap = self.gap;
        let legend = if marked { "! sure, but off" } else { "" };
        let over = format!(
            "    {gap}{:>10}{gap}{:>11}{gap}       {legend}",
            "you said", "truth"
        );
        lines.unrecorded(|lines| lines.line(&over, Role::Dim));
        let each = if self.rays { "   S    C" } else { "" };
        let cells = [" ", "", " ", each, each, "pts"];
        let head = self.cells(cells, "sure?", "about", "it was");
        let recorded = |charset| {
            let said = if self.rays {
                "you said: S C"
            } else {
                "you said"
            };
            let about = if self.topic { "about" } else { "it was" };
            let cells = [said, "truth", "pts", "sure?", about];
            let values = cells.map(|it| Run::new(it, Role::Dim).spelt(charset));
            Words::Columns {
                name: Run::new(legend, Role::Dim),
                values: values.into(),
            }
        };
        lines.written_as(recorded, |lines| lines.line(&head, Role::Dim));
    }

    fn row(
        &self,
        (number, chosen): (usize, bool),
        line: &SummaryLine,
        (question, answer): (&Question, &Answer),
        lines: &mut Lines,
    ) {
        let charset = lines.charset();
        let brief = |said| charset.text(&question.form.brief(said)).into_owned();
        let (said, truth) = (brief(&answer.said), brief(&question.form.truth()));
        let number = (number + 1).to_string();
        let points = numbers::points(line.grade.points());
        let missed = missed_surely(line);
        let chosen_mark = if chosen { ">" } else { " " };
        let mark = if missed { "!" } else { " " };
        let role = match missed {
            _ if chosen => Role::Selected,
            true => Role::Warn,
            false if line.grade.right => Role::Good,
            false => Role::Text,
        };
        let row = self.cells(
            [chosen_mark, &number, mark, &said, &truth, &points],
            line.grade.confidence.name(),
            &line.topic.name(),
            explain(question, answer).title,
        );
        let (topic, outcome) = (line.topic.name(), explain(question, answer).title);
        let about = match (self.topic, self.outcome) {
            (true, true) => format!("{topic}: {outcome}"),
            (true, false) => topic,
            _ => outcome.to_owned(),
        };
        let sure = line.grade.confidence.name();
        let recorded = |charset: Charset| {
            let values = [&said, &truth, &points, sure, &about];
            let values = values.map(|it| Run::new(it, role).spelt(charset));
            Words::Columns {
                name: Run::new(format!("{number}{mark}").trim(), role),
                values: values.into(),
            }
        };
        lines.clicked_as(recorded, Some(chosen), |lines| lines.line(&row, role));
    }

    /// The mark of the chosen line, number, mark, what was said, the truth and points;
    /// then words.
    fn cells(&self, cells: [&str; 6], confidence: &str, topic: &str, outcome: &str) -> String {
        let gap = self.gap;
        let [chosen, number, mark, said, truth, points] = cells;
        let mut row =
            format!("{chosen}{number:>2}{mark}{gap}{said:>10}{gap}{truth:>11}{gap}{points:>5}  ");
        if self.confidence {
            row += &format!("{confidence:10}");
        }
        match (self.topic, self.outcome) {
            (true, true) => row += &format!("{topic:TOPIC$}{outcome}"),
            (true, false) => row += topic,
            _ => row += outcome,
        }
        row
    }
}
