//! Which misconceptions were held, and whether they fade.

use super::words::{brief, padded};
use crate::messages::History;
use crate::progress::{HeldBelief, Trend, beliefs};
use crate::quiz::NAMED_ODDS;
use crate::widgets::{Lines, Role};

/// Columns of the figures after a name.
const FIGURES: u16 = 37;

/// A row a belief: how often before and since the middle of all answers, of how often it
/// could have shown itself.
pub(super) fn table(history: &History, lines: &mut Lines) {
    let beliefs = beliefs(&history.attempts);
    if beliefs.is_empty() {
        lines.paragraph(
            "No known misconception stands out in your answers.",
            Role::Good,
        );
        return;
    }
    let columns = usize::from(lines.width());
    let name = columns.saturating_sub(FIGURES.into()).min(36);
    let wide = name >= 20;
    if wide {
        let head = format!("{:name$}{:>11}{:>11}", "", "before", "since");
        lines.line(&head, Role::Dim);
    }
    for belief in &beliefs {
        let trend = belief.trend();
        let role = if trend.is_good() {
            Role::Good
        } else {
            Role::Text
        };
        let HeldBelief { before, since, .. } = belief;
        let shown = belief.misconception.name();
        if wide {
            let shown = padded(&brief(shown, name - 1), name);
            let row = format!("{shown}{before:>11}{since:>11}  {}", trend.name());
            lines.line(&row, role);
        } else {
            lines.line(&brief(shown, columns), role);
            let row = format!("  {before}, then {since}: {}", trend.name());
            lines.line(&row, Role::Dim);
        }
    }
    lines.gap();
    let legend = format!(
        "How often answers fitted it, of how many questions could have shown it: before the \
         middle of all your answers, and since. It stands here once your answers are \
         {NAMED_ODDS} times as likely from somebody who believes it as from somebody who guesses."
    );
    lines.paragraph(&legend, Role::Dim);
}

/// The belief that is still held most.
pub(super) fn held(history: &History) -> Option<HeldBelief> {
    let beliefs = beliefs(&history.attempts).into_iter();
    beliefs
        .into_iter()
        .find(|belief| belief.trend() != Trend::Gone)
}

/// What helps against the one held most, or that they are gone.
pub(super) fn panel(history: &History, lines: &mut Lines) {
    let beliefs = beliefs(&history.attempts);
    let fading = beliefs
        .iter()
        .filter(|belief| belief.trend().is_good())
        .count();
    if fading > 0 {
        lines.pair("gone or fading", &fading.to_string(), Role::Dim, Role::Good);
        lines.gap();
    }
    match held(history) {
        Some(belief) => {
            lines.paragraph(belief.misconception.name(), Role::Title);
            lines.paragraph(belief.misconception.advice(), Role::Text);
            lines.gap();
            lines.paragraph(
                "Many hold it at first. To say it, and to see the hit disagree, is how it goes.",
                Role::Dim,
            );
        }
        None if beliefs.is_empty() => {}
        None => lines.paragraph(
            "All of them are gone. You have changed your mind.",
            Role::Good,
        ),
    }
}
