//! Whether confidence matches the answers, overall and over time.

use ratatui::layout::Rect;

use super::{Plotted, ProgressAction};
use crate::messages::History;
use crate::progress::words::percent;
use crate::progress::{Calibrated, calibration, calibration_over_time, calibration_words};
use crate::quiz::Confidence;
use crate::widgets::panel::Panel;
use crate::widgets::plot::sureness_picture;
use crate::widgets::{Look, Role};

/// The largest number of answers, all with the same confidence, from which a share of right answers
/// is calculated.
const REACH: usize = 10;
/// The number of recent answers that are shown.
const SHOWN: usize = 200;

/// For each confidence level, the share of right answers and the range in which it should be.
pub(super) fn table(history: &History, panel: &mut Panel<ProgressAction>) {
    for calibrated in calibration(&history.attempts) {
        let Calibrated { confidence, tally } = calibrated;
        let of = format!("{} of {} right", tally.right, tally.attempts);
        panel.pair((confidence.name(), Role::Title), (of, Role::Dim));
        let right = tally.share_right();
        let role = match calibrated.beyond() < 0.0 {
            true => Role::Warn,
            false => Role::Good,
        };
        let share = (right.unwrap_or(0.0), percent(right), role);
        panel.gauge(share, (Calibrated::honest(confidence), "honest"));
        panel.gap();
    }
}

pub(super) fn panel(history: &History, panel: &mut Panel<ProgressAction>) {
    let calibration = calibration(&history.attempts);
    panel.paragraph(calibration_words(&calibration), Role::Text);
    panel.gap();
    let answers = history.attempts.iter();
    let missed = answers.filter(|it| it.is_surely_wrong()).count();
    if missed > 0 {
        panel.fact("sure, but wrong", missed.to_string());
        let text =
            "Each of these is a discovery: something you did not know that you did not know.";
        panel.paragraph(text, Role::Text);
    }
}

/// For each confidence level, the share of right answers among the last few; or the reason why
/// there is no plot.
pub(super) fn plot_over_time(history: &History, area: Rect, look: Look) -> Plotted {
    let picture = sureness_picture(&history.attempts, SHOWN, REACH, area, look);
    picture.ok_or("A line appears here after three answers with the same confidence.")
}

/// The latest share of right answers for each confidence level, and the ranges in which the lines
/// should be.
pub(super) fn panel_over_time(history: &History, panel: &mut Panel<ProgressAction>) {
    let shares = calibration_over_time(&history.attempts, REACH);
    panel.heading("Right among the last ten");
    for (confidence, shares) in Confidence::ALL.into_iter().zip(&shares).rev() {
        let now = shares.last().map(|(_, share)| *share);
        panel.fact(confidence.name(), percent(now));
    }
    panel.gap();
    panel.paragraph(
        "Well calibrated means that \"sure\" is right more than 80 % of the time, \"think so\" \
         between 50 and 80 %, and \"guess\" less often.",
        Role::Text,
    );
    panel.gap();
    panel.paragraph(
        "If the lines stay in their own ranges, one above the other, you judge your own \
         knowledge well.",
        Role::Dim,
    );
}
