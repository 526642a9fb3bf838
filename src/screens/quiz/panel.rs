//! The panel beside the quiz's picture: the question, how sure one is, the answer
//! and why.

use ratatui::layout::Rect;

use super::{Asked, Watched};
use crate::quiz::words::bare_degrees;
use crate::quiz::{Confidence, Grade, Ray, explain};
use crate::widgets::bar::bar;
use crate::widgets::hit::degrees;
use crate::widgets::{Charset, Lines, RayInput, Role, brief};

/// The question, and the rays being turned.
pub(super) fn rays(asked: &Asked, lines: &mut Lines) {
    let question = asked.question.text();
    let target = asked.question.pieces.target_name();
    let about = asked.rays.about(target);
    let next = match asked.rays.turning() {
        Ray::Striker => format!("Enter: then the {target}."),
        Ray::Target => "Enter: then how sure.".into(),
    };
    let mut spare = lines.spare(lines.rows_of(&question) + 1 + RAYS);
    let about = spare.take(lines.rows_of(&about) + 1).then_some(about);
    let next = spare.take(lines.rows_of(&next) + 1).then_some(next);
    lines.paragraph(&question, Role::Text);
    lines.gap();
    asked.rays.write(lines, target);
    for (text, role) in [(about, Role::Dim), (next, Role::Key)] {
        if let Some(text) = text {
            lines.gap();
            lines.paragraph(&text, role);
        }
    }
}

/// Rows of both rays.
const RAYS: u16 = 2;
/// Row of the first confidence, from the top of the text.
const FIRST_CONFIDENCE: u16 = 2;

/// How sure one is, what that may bring, and what one is to be sure of.
pub(super) fn confidence(asked: &Asked, chosen: Confidence, lines: &mut Lines) {
    lines.line("How sure are you?", Role::Title);
    let head = |text| (text, Role::Dim);
    lines.columns(head("points if"), ["wrong", "right"].map(head));
    for (number, confidence) in (1..).zip(Confidence::ALL) {
        let (mark, role) = if confidence == chosen {
            (">", Role::Selected)
        } else {
            (" ", Role::Text)
        };
        let name = format!("{mark} {number} {}", confidence.name());
        let points = [0.0, 1.0].map(|credit| format!("{:.0}", confidence.points(credit)));
        lines.columns(
            (&name, role),
            points.each_ref().map(|p| (p.as_str(), Role::Text)),
        );
    }
    lines.gap();
    lines.line("You said", Role::Dim);
    said(&asked.rays, asked.question.pieces.target_name(), lines);
    let advice = "Be honest with yourself: that is what brings most points.";
    let mut spare = lines.spare(0);
    if spare.take(lines.rows_of(advice) + 1) {
        lines.gap();
        lines.paragraph(advice, Role::Dim);
    }
    if spare.take(2) {
        lines.gap();
        lines.line("Enter: watch what happens.", Role::Key);
    }
}

fn said(rays: &RayInput, target: &str, lines: &mut Lines) {
    for (ray, name) in [(Ray::Striker, "striker"), (Ray::Target, target)] {
        let name = format!("  {name}");
        lines.pair(&name, &rays.shown(ray), Role::Dim, Role::Predicted);
    }
}

/// The confidence whose row is at this cell of the panel. They stand at the top and
/// are never scrolled away: their text is short enough for the smallest screen.
pub(super) fn confidence_at(panel: Rect, (column, row): (u16, u16)) -> Option<Confidence> {
    if !panel.contains((column, row).into()) {
        return None;
    }
    let row = (row - panel.y).checked_sub(FIRST_CONFIDENCE)?;
    Confidence::ALL.get(usize::from(row)).copied()
}

/// What the picture is just showing.
pub(super) fn untold(watched: &Watched, lines: &mut Lines) {
    let question = watched.question.text();
    lines.paragraph(&question, Role::Dim);
    lines.gap();
    lines.paragraph(watched.watch.telling(), Role::Text);
}

/// The points, both rays beside the truth, and the one explanation, which comes
/// whole: where there is not room for all, other things give way.
pub(super) fn told(watched: &Watched, lines: &mut Lines, charset: Charset) {
    let question = &watched.question;
    let grade = Grade::new(question, &watched.answer);
    let explanation = explain(question, &watched.answer);
    let again = question.text();
    let title_rows = lines.rows_of(explanation.title);
    let needed = ANSWERS + title_rows + lines.rows_of(&explanation.text);
    let mut spare = lines.spare(needed);
    let credit = spare.take(1);
    let gap = spare.take(1);
    let gap_before = spare.take(1);
    let next = spare.take(2);
    if spare.take(lines.rows_of(&again) + 1) {
        lines.paragraph(&again, Role::Dim);
        lines.gap();
    }
    points(&grade, lines);
    if credit {
        credit_bar(&grade, lines, charset);
    }
    if gap_before {
        lines.gap();
    }
    answers(watched, &grade, lines);
    if gap {
        lines.gap();
    }
    lines.paragraph(explanation.title, Role::Title);
    lines.paragraph(&explanation.text, Role::Text);
    if next {
        lines.gap();
        lines.line("Enter: go on.", Role::Key);
    }
}

/// Rows of the points and of [`answers`].
const ANSWERS: u16 = 4;

fn points(grade: &Grade, lines: &mut Lines) {
    let points = format!("{:.1} of {:.0} points", grade.points() + 0.0, Grade::MOST);
    let role = if grade.is_right() {
        Role::Good
    } else {
        Role::Text
    };
    lines.pair(&points, grade.confidence.name(), role, Role::Dim);
}

fn credit_bar(grade: &Grade, lines: &mut Lines, charset: Charset) {
    let percent = format!("{:.0} %", 100.0 * grade.credit());
    // A name of eight columns, five and a blank for the share.
    let width = lines.width().saturating_sub(8 + 1 + 6);
    let bar = bar(grade.credit(), width, charset);
    lines.pair(&format!("credit  {bar}"), &percent, Role::Text, Role::Text);
}

fn answers(watched: &Watched, grade: &Grade, lines: &mut Lines) {
    let collision = watched.watch.collision();
    let said = degrees(collision, &watched.answer.rays);
    let truth = degrees(collision, &watched.question.truth());
    let off = [grade.striker, grade.target].map(|ray| ray.error.map_or("-".into(), bare_degrees));
    let head = |text| (text, Role::Dim);
    lines.columns(head("degrees"), ["you", "truth", "off"].map(head));
    let names = ["striker", watched.question.pieces.target_name()];
    let roles = [Role::StrikerOut, Role::CoinOut];
    for i in 0..2 {
        lines.columns(
            head(names[i]),
            [
                (&brief(said[i]), Role::Predicted),
                (&brief(truth[i]), roles[i]),
                (&off[i], Role::Text),
            ],
        );
    }
}
