//! The text of a page: what is to be read and asked, or what is said to an answer.

use ratatui::layout::Rect;

use super::Reading;
use crate::lessons::{Checkpoint, CheckpointChoice, CheckpointKind};
use crate::numbers::{fixed, true_minus, with_unit};
use crate::physics::Collision;
use crate::quiz::{Rays, RaysGrade, Response, why_of_hit};
use crate::screens::lab::explain;
use crate::screens::learn::figure::LiveFigure;
use crate::screens::learn::prose;
use crate::widgets::hit::Watch;
use crate::widgets::panel::written;
use crate::widgets::panels::{reason, said_and_true};
use crate::widgets::{Lines, Look, Role, rehearsed};

/// Writes it.
pub(super) fn write(reading: &Reading, lines: &mut Lines) {
    write_noting(reading, lines, |_| {});
}

/// The line of a choice at a cell of the panel.
pub(super) fn choice_at(
    reading: &Reading,
    area: Rect,
    (_, row): (u16, u16),
    look: Look,
) -> Option<usize> {
    let starts = starts(reading, area, look);
    let scrolled = reading
        .scroll
        .rows(area, look, |lines| write(reading, lines));
    let row = row.saturating_sub(area.y) + scrolled;
    let is_last = starts.last().is_some_and(|start| row > start + 3);
    let line = starts.into_iter().rposition(|start| start <= row)?;
    (!is_last).then_some(line)
}

/// The last row of the line of the answer in the making that keys change.
pub(super) fn row_of_answer(reading: &Reading, area: Rect, look: Look) -> Option<u16> {
    let starts = starts(reading, area, look);
    let line = reading.question.as_ref()?.line();
    let after = starts.get(line + 1).map(|next| next.saturating_sub(1));
    after.or_else(|| starts.get(line).copied())
}

/// The first row of each line of the answer in the making.
fn starts(reading: &Reading, area: Rect, look: Look) -> Vec<u16> {
    let mut starts = Vec::new();
    rehearsed(area, look, |lines| {
        write_noting(reading, lines, |row| starts.push(row));
    });
    starts
}

fn write_noting(reading: &Reading, lines: &mut Lines, rows: impl FnMut(u16)) {
    let Some(page) = reading.page() else {
        return;
    };
    if let Some(watch) = reading.telling() {
        return written::<()>(lines, |panel| watch.write_telling(panel));
    }
    let collision = reading.collision();
    let Some((checkpoint, question)) = page.checkpoint.as_ref().zip(reading.question.as_ref())
    else {
        return prose::write(&page.text, lines, collision);
    };
    let Some(answer) = reading.answer else {
        match &reading.first {
            None => {
                prose::write(&page.text, lines, collision);
                lines.gap();
                prose::write(&checkpoint.question, lines, collision);
            }
            Some(first) => {
                let hinted = |lines: &mut Lines| hinted(checkpoint, first, collision, lines);
                let asked = |lines: &mut Lines| {
                    hinted(lines);
                    lines.gap();
                    question.write(checkpoint, lines, |_| {});
                };
                let mut spare = lines.spare(lines.rows_by(asked));
                let read = |lines: &mut Lines| prose::write_dimmed(&page.text, lines, collision);
                if spare.take(lines.rows_by(read) + 1) {
                    read(lines);
                    lines.gap();
                }
                hinted(lines);
            }
        }
        lines.gap();
        question.write(checkpoint, lines, rows);
        let next = question.hint();
        let mut spare = lines.spare(0);
        if spare.take(lines.rows_of(next) + 1) {
            lines.gap();
            lines.paragraph(next, Role::Key);
        }
        return;
    };
    let told = |lines: &mut Lines| told(reading, checkpoint, answer, lines);
    // What was read stays above it, if there is room for both.
    let asked_above = matches!(answer, Response::Rays(_));
    let read = |lines: &mut Lines| {
        prose::write_dimmed(&page.text, lines, collision);
        if asked_above {
            lines.gap();
            prose::write_dimmed(&checkpoint.question, lines, collision);
        }
    };
    let mut spare = lines.spare(lines.rows_by(told));
    if spare.take(lines.rows_by(read) + 1) {
        read(lines);
        lines.gap();
    }
    told(lines);
}

/// The question once more, and what helps after a first wrong answer to it.
fn hinted(
    checkpoint: &Checkpoint,
    first: &Response,
    figure: Option<&Collision>,
    lines: &mut Lines,
) {
    prose::write(&checkpoint.question, lines, figure);
    lines.gap();
    let verdict = match (first, figure) {
        (Response::Rays(said), Some(collision)) => {
            let grade = RaysGrade::new(said, &Rays::from(&collision.outcome()));
            match (grade.striker.is_right(), grade.target.is_right()) {
                (true, _) => "The striker is right. The coin is not, yet.",
                (_, true) => "The coin is right. The striker is not, yet.",
                _ => "Not yet. A hint:",
            }
        }
        _ if checkpoint.credit(first, figure) > 0.0 => "Nearly. A hint:",
        _ => "Not yet. A hint:",
    };
    lines.paragraph(verdict, Role::Warn);
    match (first, &checkpoint.asked) {
        (Response::Choice(chosen), CheckpointKind::Choice(choices))
            if checkpoint.hint.is_empty() =>
        {
            if let Some(choice) = choices.get(*chosen) {
                lines.flowing("", 0, &prose::runs(&choice.why, Role::Text, figure));
            }
        }
        _ => prose::write(&checkpoint.hint, lines, figure),
    }
}

/// What is said to an answer.
fn told(reading: &Reading, checkpoint: &Checkpoint, answer: Response, lines: &mut Lines) {
    let collision = reading.collision();
    if answer.rays().is_none() {
        prose::write(&checkpoint.question, lines, collision);
        lines.gap();
    }
    match (&answer, &checkpoint.asked) {
        (Response::Rays(rays), _) => {
            if let Some(figure) = &reading.figure
                && let Some(watch) = figure.watch()
            {
                rays_told(rays, watch, figure, lines);
            }
        }
        (Response::Choice(chosen), CheckpointKind::Choice(choices)) => {
            choice_told(*chosen, choices, collision, lines);
        }
        _ => number_told(&answer, checkpoint, collision, lines),
    }
    if reading.first.is_some() && checkpoint.is_right(&answer, collision) {
        lines.paragraph("On the second try: half the credit.", Role::Dim);
    }
    if !checkpoint.after.is_empty() {
        lines.gap();
        prose::write(&checkpoint.after, lines, collision);
    }
}

/// Both rays beside the truth, and the explanation that starts from them.
fn rays_told(rays: &Rays, watch: &Watch, figure: &LiveFigure, lines: &mut Lines) {
    let names = ["striker", "coin"].map(Some);
    written::<()>(lines, |panel| {
        said_and_true(watch.collision(), rays, names, false, panel);
    });
    lines.gap();
    let why = match figure.question_by_angle() {
        Some(question) => why_of_hit(&question, Some(*rays)),
        None => explain(watch),
    };
    written::<()>(lines, |panel| reason(&why, panel));
}

/// A number beside the right one.
fn number_told(
    answer: &Response,
    checkpoint: &Checkpoint,
    figure: Option<&Collision>,
    lines: &mut Lines,
) {
    let (
        Response::Number(number),
        CheckpointKind::Number {
            expected,
            tolerance,
        },
    ) = (answer, &checkpoint.asked)
    else {
        return;
    };
    let right = checkpoint.is_right(answer, figure);
    let (_, unit) = expected.sign_and_unit();
    // As many decimals as the tolerance asks for.
    let decimals = (1.0 - tolerance.log10()).clamp(0.0, 6.0) as usize;
    let shown = |value: f64| true_minus(&with_unit(&fixed(value, decimals), unit));
    let role = if right { Role::Good } else { Role::Warn };
    lines.pair("you said", &shown(*number), Role::Dim, role);
    if let Some(truth) = expected.value(figure) {
        lines.fact("truth", &shown(truth));
    }
    lines.gap();
    let credit = checkpoint.credit(answer, figure);
    let verdict = match right {
        true => "Right.",
        false if credit > 0.0 => "Nearly.",
        false => "Not this time. Here is why:",
    };
    lines.paragraph(verdict, role);
}

fn choice_told(
    chosen: usize,
    choices: &[CheckpointChoice],
    figure: Option<&Collision>,
    lines: &mut Lines,
) {
    let Some(choice) = choices.get(chosen) else {
        return;
    };
    let (mark, role) = match choice.right {
        true => ("✓", Role::Good),
        false => ("✗", Role::Warn),
    };
    lines.flowing(mark, 2, &prose::runs(&choice.text, role, figure));
    lines.flowing("", 0, &prose::runs(&choice.why, Role::Text, figure));
    if let Some(right) = choices.iter().find(|other| other.right && !choice.right) {
        lines.gap();
        lines.flowing("✓", 2, &prose::runs(&right.text, Role::Good, figure));
    }
}
