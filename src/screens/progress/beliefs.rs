//! Which misconceptions were held, and whether they fade.

use super::ProgressAction;
use crate::messages::History;
use crate::progress::{HeldBelief, Trend, beliefs};
use crate::quiz::NAMED_ODDS;
use crate::widgets::Role;
use crate::widgets::panel::{Panel, TableColumn, TableRow};

/// Columns from which on the figures have room beside the longest name.
const WIDE: u16 = 75;

/// A row a belief: how often before and since the middle of all answers, of how often it
/// could have shown itself.
pub(super) fn table(history: &History, columns: u16, panel: &mut Panel<ProgressAction>) {
    let beliefs = beliefs(&history.attempts);
    if beliefs.is_empty() {
        let none = "No known misconception stands out in your answers.";
        return panel.paragraph(none, Role::Good);
    }
    let role = |belief: &HeldBelief| match belief.trend().is_good() {
        true => Role::Good,
        false => Role::Text,
    };
    if columns >= WIDE {
        let column = |head: &str, width, flush_right| TableColumn {
            head: head.into(),
            width,
            flush_right,
            room: 0,
            drawn: false,
        };
        let heads = vec![
            column("", 36, false),
            column("before", 8, true),
            column("since", 8, true),
            column("", 0, false),
        ];
        let rows = beliefs.iter().map(|belief| TableRow {
            cells: vec![
                belief.misconception.name().into(),
                belief.before.to_string(),
                belief.since.to_string(),
                belief.trend().name().into(),
            ],
            role: role(belief),
            chosen: false,
            action: None,
        });
        panel.table(heads, rows.collect());
    } else {
        for belief in &beliefs {
            let HeldBelief { before, since, .. } = belief;
            panel.line(belief.misconception.name(), role(belief));
            let figures = format!("{before}, then {since}: {}", belief.trend().name());
            panel.marked("  ", figures, Role::Dim);
        }
    }
    panel.gap();
    let legend = format!(
        "How often answers fitted it, of how many questions could have shown it: before the \
         middle of all your answers, and since. It stands here once your answers are \
         {NAMED_ODDS} times as likely from somebody who believes it as from somebody who guesses."
    );
    panel.paragraph(legend, Role::Dim);
}

/// The belief that is still held most.
pub(super) fn held(history: &History) -> Option<HeldBelief> {
    { beliefs(&history.attempts).into_iter() }.find(|belief| belief.trend() != Trend::Gone)
}

/// What helps against the one held most, or that they are gone.
pub(super) fn panel(history: &History, panel: &mut Panel<ProgressAction>) {
    let beliefs = beliefs(&history.attempts);
    let fading = beliefs
        .iter()
        .filter(|belief| belief.trend().is_good())
        .count();
    if fading > 0 {
        panel.coloured_fact("gone or fading", fading.to_string(), Role::Good);
        panel.gap();
    }
    match held(history) {
        Some(belief) => {
            panel.paragraph(belief.misconception.name(), Role::Title);
            panel.paragraph(belief.misconception.advice(), Role::Text);
            panel.gap();
            panel.paragraph(
                "Many hold it at first. To say it, and to see the hit disagree, is how it goes.",
                Role::Dim,
            );
        }
        None if beliefs.is_empty() => {}
        None => panel.paragraph(
            "All of them are gone. You have changed your mind.",
            Role::Good,
        ),
    }
}
