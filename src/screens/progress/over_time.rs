//! How far off the answers were as time went by.

use glam::dvec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::words::{degrees, percent};
use crate::lessons::Book;
use crate::messages::History;
use crate::progress::{Tally, advice, ends_deg, smoothed_errors_deg};
use crate::quiz::RIGHT_DEG;
use crate::widgets::ink::{Pen, Side};
use crate::widgets::plot::{Axis, Plot};
use crate::widgets::{Lines, Look, Role};

/// How many answers the line takes the mean of.
const REACH: usize = 5;
/// How many of the last answers are shown.
const SHOWN: usize = 100;

/// Draws the error of each answer, and the mean of the last few.
pub(super) fn plot(history: &History, area: Rect, buf: &mut Buffer, look: Look) {
    let errors = smoothed_errors_deg(&history.attempts, REACH);
    let shown = &errors[errors.len().saturating_sub(SHOWN)..];
    let (Some(first), Some(last)) = (shown.first(), shown.last()) else {
        let said = "None of your answers so far had an angle to be off.";
        return Lines::new(area, buf, look).paragraph(said, Role::Text);
    };
    let most = shown.iter().map(|(_, error, _)| *error).fold(0.0, f64::max);
    // In tens, and with some room above the highest.
    let top = (10.0 * (most / 10.0).floor() + 10.0).clamp(20.0, 180.0);
    let from = (first.0 as f64).min((last.0 as f64 - 9.0).max(1.0));
    let to = (last.0 as f64).max(from + 9.0);
    let numbers = Axis::linear("answer", from - 0.5, to + 0.5);
    let mut plot = Plot::new(area, look, numbers, Axis::linear("off by (°)", 0.0, top));
    plot.level(RIGHT_DEG, Pen::new(Role::Good).dashed());
    let at = |number: usize, y: f64| dvec2(number as f64, y);
    plot.curve(
        shown.iter().map(|(number, _, mean)| at(*number, *mean)),
        Pen::new(Role::StrikerOut).bold(),
    );
    for (number, error, _) in shown {
        let right = history.attempts.get(number - 1).is_some_and(|it| it.right);
        let (symbol, role) = if right {
            ('o', Role::Good)
        } else {
            ('x', Role::Predicted)
        };
        plot.mark(at(*number, *error), symbol, role);
    }
    let above = [Side::AboveLeft, Side::Above, Side::AboveRight];
    plot.label("right", dvec2(to, RIGHT_DEG), &above, Role::Good);
    plot.draw(buf);
}

/// The figures of all, how the ends compare, and what to do next.
pub(super) fn panel(history: &History, book: &Book, lines: &mut Lines) {
    let attempts = &history.attempts;
    let all = Tally::of(attempts);
    let row = |lines: &mut Lines, name: &str, value: &str| {
        lines.pair(name, value, Role::Dim, Role::Text);
    };
    row(lines, "answers", &all.attempts.to_string());
    row(lines, "right", &percent(all.share_right()));
    row(lines, "chapters done", &book.done());
    if let Some(error) = all.mean_error_deg() {
        row(lines, "angles", &all.angles().to_string());
        row(lines, "  mean error", &degrees(Some(error)));
    }
    if let Some((first, last)) = ends_deg(attempts) {
        row(lines, "  first ten", &degrees(Some(first)));
        row(lines, "  last ten", &degrees(Some(last)));
        lines.gap();
        lines.paragraph(compared(first, last), Role::Text);
    }
    lines.gap();
    lines.line("What next", Role::Title);
    lines.paragraph(&advice(attempts, &history.calendar), Role::Text);
    lines.gap();
    lines.paragraph(
        "o is right, x not yet; the line is the mean of five.",
        Role::Dim,
    );
}

/// What to make of the mean errors of the first and the last answers.
fn compared(first: f64, last: f64) -> &'static str {
    if last <= RIGHT_DEG {
        "That is as fine as the eye can judge. Well aimed."
    } else if last < 0.8 * first {
        "You come closer than you did: that is what practice looks like."
    } else if last > 1.25 * first {
        "Lately it was harder. New kinds of hits do that; the line comes down again."
    } else {
        "Steady. The next step comes from the ones you miss: read why."
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_said_follows_from_the_ends() {
        assert!(compared(20.0, 3.0).contains("Well aimed"));
        assert!(compared(20.0, 10.0).contains("closer"));
        assert!(compared(10.0, 20.0).contains("harder"));
        assert!(compared(10.0, 10.0).contains("Steady"));
    }
}
