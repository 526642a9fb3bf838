//! Whether confidence and answers go together, in all and as time goes by.

use ratatui::layout::Rect;

use super::ProgressAction;
use crate::messages::History;
use crate::progress::words::percent;
use crate::progress::{Calibrated, calibration, calibration_over_time, calibration_words};
use crate::quiz::Confidence;
use crate::widgets::panel::Panel;
use crate::widgets::picture::Picture;
use crate::widgets::plot::sureness_picture;
use crate::widgets::{Look, Role};

/// How many answers of one confidence a share is taken of.
const REACH: usize = 10;
/// How many of the last answers are shown.
const SHOWN: usize = 200;

/// Of each confidence the share that was right, over the range for which it pays.
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
        panel.gauge(
            (right.unwrap_or(0.0), percent(right), role),
            (Calibrated::honest(confidence), "honest"),
        );
        panel.gap();
    }
}

/// What it says.
pub(super) fn panel(history: &History, panel: &mut Panel<ProgressAction>) {
    let calibration = calibration(&history.attempts);
    panel.paragraph(calibration_words(&calibration), Role::Text);
    panel.gap();
    let missed = { history.attempts.iter() }.filter(|it| it.is_surely_wrong());
    let missed = missed.count();
    if missed > 0 {
        panel.fact("sure, but off", missed.to_string());
        panel.paragraph(
            "Each of these is a find: something you did not know you did not know.",
            Role::Text,
        );
    }
}

/// Of each confidence the share that was right among the last few; or why there is nothing
/// to draw.
pub(super) fn plot_over_time(
    history: &History,
    area: Rect,
    look: Look,
) -> Result<Picture, &'static str> {
    let picture = sureness_picture(&history.attempts, SHOWN, REACH, area, look);
    picture.ok_or("A line begins here after three answers of one confidence.")
}

/// Where each line should be, and where it ended.
pub(super) fn panel_over_time(history: &History, panel: &mut Panel<ProgressAction>) {
    let shares = calibration_over_time(&history.attempts, REACH);
    panel.heading("Right, of the last ten");
    for (confidence, shares) in Confidence::ALL.into_iter().zip(&shares).rev() {
        let now = shares.last().map(|(_, share)| *share);
        panel.fact(confidence.name(), percent(now));
    }
    panel.gap();
    panel.paragraph(
        "Honest is: sure above 80, think so between 50 and 80, guess below.",
        Role::Text,
    );
    panel.gap();
    panel.paragraph(
        "Lines that keep to their own part, one above the other, belong to someone who knows \
         what they know.",
        Role::Dim,
    );
}
