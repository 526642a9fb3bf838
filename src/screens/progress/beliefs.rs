//! Which misconceptions were held, and whether they fade.

use super::words::{brief, padded};
use crate::messages::History;
use crate::progress::{Belief, Trend, beliefs};
use crate::widgets::{Lines, Role};

/// Columns of the figures after a name.
const FIGURES: u16 = 24;

/// A row a belief: how often before and since the middle of all answers.
pub(super) fn table(history: &History, lines: &mut Lines) {
    let beliefs = beliefs(&history.attempts);
    if beliefs.is_empty() {
        lines.paragraph(
            "None of your answers fitted a known misconception. That is rare.",
            Role::Good,
        );
        return;
    }
    let columns = usize::from(lines.width());
    let name = columns.saturating_sub(FIGURES.into()).min(36);
    let wide = name >= 20;
    if wide {
        let head = format!("{:name$}{:>6}{:>6}", "", "before", "since");
        lines.line(&head, Role::Dim);
    }
    for belief in &beliefs {
        let trend = belief.trend();
        let role = match trend {
            Trend::Gone | Trend::Fading => Role::Good,
            Trend::Held => Role::Text,
        };
        let Belief { before, since, .. } = belief;
        let shown = belief.misconception.name;
        if wide {
            let shown = padded(&brief(shown, name - 1), name);
            let row = format!("{shown}{before:>6}{since:>6}  {}", trend.name());
            lines.line(&row, role);
        } else {
            lines.line(&brief(shown, columns), role);
            let row = format!("  {before}, then {since}: {}", trend.name());
            lines.line(&row, Role::Dim);
        }
    }
    lines.gap();
    lines.paragraph(
        "How often answers fitted it in the first half of all your answers, and in the \
         second.",
        Role::Dim,
    );
}

/// What helps against the one held most, or that they are gone.
pub(super) fn panel(history: &History, lines: &mut Lines) {
    let beliefs = beliefs(&history.attempts);
    let fading = beliefs
        .iter()
        .filter(|belief| belief.trend() != Trend::Held)
        .count();
    if fading > 0 {
        lines.pair("gone or fading", &fading.to_string(), Role::Dim, Role::Good);
        lines.gap();
    }
    let held = beliefs.iter().find(|belief| belief.trend() != Trend::Gone);
    match held {
        Some(belief) => {
            lines.paragraph(belief.misconception.name, Role::Title);
            lines.paragraph(belief.misconception.advice, Role::Text);
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
