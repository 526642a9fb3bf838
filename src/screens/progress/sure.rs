//! Whether confidence and answers go together.

use super::words::percent;
use crate::messages::History;
use crate::progress::{Calibrated, calibration, calibration_words};
use crate::widgets::bar::bar;
use crate::widgets::flow::Run;
use crate::widgets::{Charset, Lines, Role, Words};

/// Of each confidence the share that was right, over the range for which it pays.
pub(super) fn table(history: &History, lines: &mut Lines) {
    let width = lines.width().saturating_sub(2).min(50);
    for calibrated in calibration(&history.attempts) {
        let tally = &calibrated.tally;
        let of = format!("{} of {} right", tally.right, tally.attempts);
        lines.pair(calibrated.confidence.name(), &of, Role::Title, Role::Dim);
        let right = tally.share_right();
        let share = right.unwrap_or(0.0);
        let bar = bar(share, width.saturating_sub(8), lines.charset());
        let role = match calibrated.beyond() < 0.0 {
            true => Role::Warn,
            false => Role::Good,
        };
        lines.written_as(
            |_| Words::meter("", share, &percent(right), role),
            |lines| lines.pair(&bar, &percent(right), role, Role::Text),
        );
        let (from, to) = Calibrated::honest(calibrated.confidence);
        let honest = format!("from {:.0} to {:.0} %", 100.0 * from, 100.0 * to);
        let range = range(&calibrated, width.saturating_sub(8), lines.charset());
        lines.written_as(
            |_| Words::Pair {
                name: Run::new("honest", Role::Dim),
                value: Run::new(honest, Role::Dim),
            },
            |lines| lines.pair(&range, "honest", Role::Dim, Role::Dim),
        );
        lines.gap();
    }
}

/// A stroke under the part of a bar that the confidence is for.
fn range(calibrated: &Calibrated, width: u16, charset: Charset) -> String {
    let (from, to) = Calibrated::honest(calibrated.confidence);
    let cell = |share: f64| (share * f64::from(width)).round() as usize;
    let (from, to) = (cell(from), cell(to));
    let [left, line, right] = match charset {
        Charset::Ascii => ["|", "-", "|"],
        Charset::Unicode => ["├", "─", "┤"],
    };
    let inner = (to - from).saturating_sub(2);
    format!("{}{left}{}{right}", " ".repeat(from), line.repeat(inner))
}

/// What it says.
pub(super) fn panel(history: &History, lines: &mut Lines) {
    let calibration = calibration(&history.attempts);
    lines.paragraph(calibration_words(&calibration), Role::Text);
    lines.gap();
    let missed = history
        .attempts
        .iter()
        .filter(|it| it.is_surely_wrong())
        .count();
    if missed > 0 {
        lines.fact("sure, but off", &missed.to_string());
        lines.paragraph(
            "Each of these is a find: something you did not know you did not know.",
            Role::Text,
        );
    }
}
