//! Whether confidence and answers go together as time goes by.

use ratatui::layout::Rect;

use super::words::percent;
use crate::messages::History;
use crate::progress::calibration_over_time;
use crate::quiz::Confidence;
use crate::widgets::picture::Picture;
use crate::widgets::plot::sureness_picture;
use crate::widgets::{Lines, Look, Role};

/// How many answers of one confidence a share is taken of.
const REACH: usize = 10;
/// How many of the last answers are shown.
const SHOWN: usize = 200;

/// Of each confidence the share that was right among the last few; or why there is nothing
/// to draw.
pub(super) fn plot(history: &History, area: Rect, look: Look) -> Result<Picture, &'static str> {
    let picture = sureness_picture(&history.attempts, SHOWN, REACH, area, look);
    picture.ok_or("A line begins here after three answers of one confidence.")
}

/// Where each line should be, and where it ended.
pub(super) fn panel(history: &History, lines: &mut Lines) {
    let shares = calibration_over_time(&history.attempts, REACH);
    lines.line("Right, of the last ten", Role::Title);
    for (confidence, shares) in Confidence::ALL.into_iter().zip(&shares).rev() {
        let now = percent(shares.last().map(|(_, share)| *share));
        lines.fact(confidence.name(), &now);
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
