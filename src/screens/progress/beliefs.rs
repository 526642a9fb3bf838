//! The player's misconceptions, and whether they fade.

use super::ProgressAction;
use crate::messages::History;
use crate::progress::{HeldBelief, Trend, beliefs};
use crate::quiz::{NAMED_ODDS, Origin};
use crate::widgets::Role;
use crate::widgets::panel::{Panel, TableColumn, TableRow};

/// The smallest width, in columns, at which the numbers fit beside the longest name.
const WIDE: u16 = 75;

/// One row per misconception: how many of the answers that could have shown it did so, in the
/// first half of all answers and in the second.
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
        let heads = vec![
            TableColumn::words("", 36),
            TableColumn::numbers("before", 8),
            TableColumn::numbers("since", 8),
            TableColumn::words("", 0),
        ];
        let rows = beliefs.iter().map(|belief| {
            let [name, trend] = [belief.misconception.name(), belief.trend().name()];
            let [before, since] = [belief.before, belief.since].map(|it| it.to_string());
            TableRow::of(vec![name.into(), before, since, trend.into()], role(belief))
        });
        panel.table(heads, rows.collect(), None);
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
        "How many answers fitted each misconception, out of the questions that could have shown \
         it: in the first half of your answers, and since. A misconception is listed once it \
         explains the answers {NAMED_ODDS} times better than guessing does."
    );
    panel.paragraph(legend, Role::Dim);
}

/// Advice on overcoming a misconception of this origin.
const fn how_it_fades(origin: Origin) -> &'static str {
    match origin {
        Origin::Study(_) => {
            "Many people believe this at first. It fades when you predict and then see that the \
             collision disagrees."
        }
        Origin::Slip => {
            "This is a slip, not a belief. Checking the result in an extreme case reveals it."
        }
        Origin::Ours => {
            "An idea like this fades when you predict and then see that the collision disagrees."
        }
    }
}

/// Advice on the strongest misconception, or a note that all have disappeared.
pub(super) fn panel(history: &History, panel: &mut Panel<ProgressAction>) {
    let beliefs = beliefs(&history.attempts);
    let fading = beliefs.iter().filter(|it| it.trend().is_good()).count();
    if fading > 0 {
        panel.coloured_fact("gone or fading", fading.to_string(), Role::Good);
        panel.gap();
    }
    // The strongest belief that the player still holds.
    match beliefs.iter().find(|it| it.trend() != Trend::Gone) {
        Some(belief) => {
            panel.paragraph(belief.misconception.name(), Role::Title);
            panel.paragraph(belief.misconception.advice(), Role::Text);
            panel.gap();
            panel.paragraph(how_it_fades(belief.misconception.origin()), Role::Dim);
        }
        None if beliefs.is_empty() => {}
        None => {
            let text = "All of them are gone. You have changed your mind.";
            panel.paragraph(text, Role::Good);
        }
    }
}
