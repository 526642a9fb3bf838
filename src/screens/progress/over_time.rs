//! The errors of the answers over time.

use ratatui::layout::Rect;

use super::{Plotted, ProgressAction};
use crate::messages::History;
use crate::progress::words::{degrees, percent};
use crate::progress::{ObservationCounts, Tally, ends_deg};
use crate::quiz::RIGHT_DEG;
use crate::widgets::panel::Panel;
use crate::widgets::plot::errors_picture;
use crate::widgets::{Look, Role};

/// The number of recent answers that are shown.
const SHOWN: usize = 100;

/// Plots the errors of the recent answers that were angles, and their running mean; or returns the
/// reason why there is no plot.
pub(super) fn plot(history: &History, area: Rect, look: Look) -> Plotted {
    let picture = errors_picture(&history.attempts, SHOWN, area, look);
    let picture = picture.map(|(picture, _)| picture);
    picture.ok_or("None of your answers so far was an angle.")
}

/// The overall figures, and the first answers beside the last.
pub(super) fn panel(history: &History, panel: &mut Panel<ProgressAction>) {
    let attempts = &history.attempts;
    let all = Tally::of(attempts);
    panel.fact("answers", all.attempts.to_string());
    panel.fact("right", percent(all.share_right()));
    if let Some(error) = all.mean_error_deg() {
        panel.fact("angles", all.angles().to_string());
        panel.fact("mean error", degrees(Some(error)));
    }
    if let Some((first, last)) = ends_deg(attempts) {
        panel.fact("first ten", degrees(Some(first)));
        panel.fact("last ten", degrees(Some(last)));
        panel.gap();
        panel.paragraph(compared(first, last), Role::Text);
    }
    for words in ObservationCounts::new(&history.observations).words() {
        panel.gap();
        panel.paragraph(words, Role::Text);
    }
    panel.gap();
    let text = "o: right, x: not yet; the line is the mean of five.";
    panel.paragraph(text, Role::Dim);
}

/// A comment on the mean errors of the first and the last answers.
fn compared(first: f64, last: f64) -> &'static str {
    match last {
        ..=RIGHT_DEG => "That is as accurate as the eye can judge. Well aimed.",
        _ if last < 0.8 * first => "You are closer than before: your practice shows.",
        _ if last > 1.25 * first => {
            "Your recent errors were larger. That is normal with new kinds of collision; the line \
             will come down again."
        }
        _ => "Steady. You learn most from the questions you miss: read their explanations.",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_comment_compares_the_first_and_the_last_error() {
        assert!(compared(20.0, 3.0).contains("Well aimed"));
        assert!(compared(20.0, 10.0).contains("closer"));
        assert!(compared(10.0, 20.0).contains("larger"));
        assert!(compared(10.0, 10.0).contains("Steady"));
    }
}
