//! Whether confidence and answers go together as time goes by.

use glam::dvec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::words::percent;
use crate::messages::History;
use crate::progress::{Calibrated, calibration_over_time};
use crate::quiz::Confidence;
use crate::widgets::picture::{Pen, Side};
use crate::widgets::plot::{Axis, Plot};
use crate::widgets::{Lines, Look, Role};

/// How many answers of one confidence a share is taken of.
const REACH: usize = 10;
/// How many of the last answers are shown.
const SHOWN: usize = 200;

/// Draws of each confidence the share that was right among the last few.
pub(super) fn plot(history: &History, area: Rect, buf: &mut Buffer, look: Look) {
    let count = history.attempts.len();
    let hidden = count.saturating_sub(SHOWN);
    let mut lines = calibration_over_time(&history.attempts, REACH);
    for line in &mut lines {
        line.retain(|(number, _)| *number > hidden);
    }
    let Some(first) = lines.iter().flatten().map(|(number, _)| *number).min() else {
        let said = "Three answers of one confidence, and its line begins here.";
        return Lines::new(area, buf, look).paragraph(said, Role::Text);
    };
    let (from, to) = (first as f64, count.max(first + 9) as f64);
    let numbers = Axis::linear("answer", from - 0.5, to + 0.5);
    let shares = Axis::linear("right (%)", 0.0, 100.0).every(20.0);
    let mut plot = Plot::new(area, look, numbers, shares);
    let (_, guess) = Calibrated::honest(Confidence::Guess);
    let (_, think_so) = Calibrated::honest(Confidence::ThinkSo);
    for limit in [guess, think_so] {
        plot.level(100.0 * limit, Pen::new(Role::Dim).dotted());
    }
    for (confidence, line) in Confidence::ALL.into_iter().zip(&lines) {
        let mut points = line
            .iter()
            .map(|(n, share)| dvec2(*n as f64, 100.0 * share));
        let (pen, mark) = pen(confidence);
        plot.curve(points.clone(), pen);
        if let Some(end) = points.next_back() {
            let role = role(confidence);
            plot.mark(end, mark, role);
            let sides = [Side::Above, Side::AboveLeft, Side::Below, Side::BelowLeft];
            plot.label(confidence.name(), end, &sides, role);
        }
    }
    plot.draw(buf);
}

fn role(confidence: Confidence) -> Role {
    match confidence {
        Confidence::Guess => Role::Dim,
        Confidence::ThinkSo => Role::CoinOut,
        Confidence::Sure => Role::StrikerOut,
    }
}

/// How the line of a confidence is drawn, and what is at its end.
fn pen(confidence: Confidence) -> (Pen, char) {
    let pen = Pen::new(role(confidence));
    match confidence {
        Confidence::Guess => (pen.dotted(), 'g'),
        Confidence::ThinkSo => (pen.dashed(), 't'),
        Confidence::Sure => (pen.bold(), 's'),
    }
}

/// Where each line should be, and where it ended.
pub(super) fn panel(history: &History, lines: &mut Lines) {
    let shares = calibration_over_time(&history.attempts, REACH);
    lines.line("Right, of the last ten", Role::Title);
    for (confidence, shares) in Confidence::ALL.into_iter().zip(&shares).rev() {
        let now = percent(shares.last().map(|(_, share)| *share));
        lines.pair(confidence.name(), &now, Role::Dim, Role::Text);
    }
    lines.gap();
    lines.paragraph(
        "Honest is: sure above 80, think so between 50 and 80, guess below.",
        Role::Text,
    );
    lines.gap();
    lines.paragraph(
        "Lines that keep to their own part, one above the other, belong to someone who knows \
         what they know.",
        Role::Dim,
    );
}
