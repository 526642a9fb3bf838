//! How each topic stands.

use super::words::{brief, degrees, padded, percent};
use crate::messages::History;
use crate::progress::{LATELY, Mastery, Review, reviews, topics};
use crate::widgets::bar::bar;
use crate::widgets::{Lines, Role};

/// Columns of a topic's name.
const NAME: usize = 26;
/// Columns of a row with all its figures.
const ROW: u16 = 46;
/// Columns of the bar, where there is room for it.
const BAR: u16 = 20;
/// How many reviews are listed.
const LISTED: usize = 6;

/// A row a topic, or two where the place is narrow.
pub(super) fn table(history: &History, lines: &mut Lines) {
    let wide = lines.width() >= ROW;
    let charted = lines.width() >= ROW + BAR + 3;
    if wide {
        // The sign for degrees may be a word.
        let off = lines.charset().text("off °").into_owned();
        let head = format!("  {:NAME$}{:>4}{:>6}{off:>8}", "", "of", "right");
        let chart = if charted { "   lately" } else { "" };
        lines.line(&(head + chart), Role::Dim);
    }
    for topic in topics(&history.attempts) {
        let (mark, role) = match topic.mastery() {
            Mastery::New => (' ', Role::Text),
            Mastery::Growing => ('~', Role::Text),
            Mastery::Solid => ('*', Role::Good),
        };
        let count = topic.all.attempts;
        let right = percent(topic.all.share_right());
        let off = topic.all.mean_error_deg();
        if wide {
            let off = off.map_or("-".into(), |off| format!("{off:.1}"));
            let name = padded(&brief(&topic.name, NAME), NAME);
            let share = topic.lately.share_right().unwrap_or(0.0);
            let chart = if charted {
                format!("   {}", bar(share, BAR, lines.charset()))
            } else {
                String::new()
            };
            let row = format!("{mark} {name}{count:>4}{right:>6}{off:>8}{chart}");
            lines.line(&row, role);
        } else {
            let room = usize::from(lines.width()).saturating_sub(2);
            lines.line(&format!("{mark} {}", brief(&topic.name, room)), role);
            let figures = format!("  {count}: {right} right, {} off", degrees(off));
            lines.line(&figures, Role::Dim);
        }
    }
    lines.gap();
    let legend = format!("* is solid: four of the last {LATELY} right; ~ is growing.");
    lines.paragraph(&legend, Role::Dim);
}

/// What is due now and what comes next.
pub(super) fn panel(history: &History, lines: &mut Lines) {
    let solid = topics(&history.attempts)
        .iter()
        .filter(|topic| topic.mastery() == Mastery::Solid)
        .count();
    if solid > 0 {
        lines.pair("solid", &solid.to_string(), Role::Dim, Role::Good);
        lines.gap();
    }
    let Some(now_s) = history.now_s else {
        lines.paragraph(
            "What you know may rest for a while; what you missed comes back soon. Here it \
             will say when.",
            Role::Text,
        );
        return;
    };
    let mut head = String::new();
    let reviews = reviews(&history.attempts).into_iter();
    for review in reviews.filter(Review::comes_back).take(LISTED) {
        let when = review.when(now_s);
        if when != head {
            lines.line(&when, Role::Title);
            head = when;
        }
        let room = usize::from(lines.width()).saturating_sub(2);
        let name = brief(&review.topic, room);
        lines.line(&format!(" {name}"), Role::Text);
    }
    lines.gap();
    lines.paragraph(
        "Coming back after a rest feels harder, and is what makes it stay.",
        Role::Dim,
    );
}
