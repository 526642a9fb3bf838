//! How the list of earlier rounds looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::earlier::{Earlier, Rounds};
use super::view::column;
use crate::class::ClassRound;
use crate::messages::Kept;
use crate::widgets::panel::draw_panel;
use crate::widgets::{Lines, Look, Role, text};

/// Rows below the list for what is to be said of the chosen round.
const ABOUT: u16 = 7;

/// Draws the list.
pub(super) fn draw(earlier: &Earlier, area: Rect, buf: &mut Buffer, look: &Look) {
    let frame = column(area);
    let inside = draw_panel(buf, frame, "earlier rounds", look.charset, &look.theme);
    let mut lines = Lines::new(inside, buf, *look);
    match &earlier.rounds {
        Rounds::Asked => lines.paragraph("Looking …", Role::Text),
        Rounds::Unknown(reason) => {
            let message = format!("The earlier rounds cannot be looked at: {reason}.");
            lines.paragraph(&message, Role::Warn);
        }
        Rounds::Known(rounds) if rounds.is_empty() => lines.paragraph(
            "There are none yet. Every round is saved by itself, after each vote.",
            Role::Text,
        ),
        Rounds::Known(rounds) => {
            let rows = usize::from(inside.height.saturating_sub(ABOUT)).max(1);
            let last_start = rounds.len().saturating_sub(rows);
            let first = earlier.at.saturating_sub(rows / 2).min(last_start);
            for (i, kept) in rounds.iter().enumerate().skip(first).take(rows) {
                let (mark, role) = if i == earlier.at {
                    (">", Role::Selected)
                } else {
                    (" ", Role::Text)
                };
                let age = kept.age.map(text::ago).unwrap_or_default();
                let room = usize::from(lines.width()).saturating_sub(text::width(&age) + 4);
                let title = text::clipped(&look.charset.text(&title(kept)), room);
                lines.pair(&format!("{mark} {title} "), &age, role, Role::Dim);
            }
        }
    }
    lines.gap();
    about(earlier, &mut lines);
}

/// What is to be said of the chosen round.
fn about(earlier: &Earlier, lines: &mut Lines) {
    let Some(kept) = earlier.chosen() else {
        return;
    };
    if earlier.removing {
        lines.paragraph("Remove this round for good?", Role::Warn);
        lines.paragraph("y: remove it. Any other key: keep it.", Role::Key);
        return;
    }
    if let Some(notice) = &earlier.notice {
        lines.paragraph(notice, Role::Warn);
        return;
    }
    match &kept.content {
        Ok(round) => {
            lines.paragraph(&place(round), Role::Text);
            lines.paragraph(&round.teams().join(", "), Role::Dim);
            lines.gap();
            lines.paragraph("Enter: take it up where it was left.", Role::Key);
        }
        Err(reason) => {
            lines.paragraph(&format!("It cannot be read. {reason}."), Role::Warn);
            lines.paragraph("The file is left as it is.", Role::Text);
        }
    }
}

/// A round in a line.
fn title(kept: &Kept<ClassRound>) -> String {
    match &kept.content {
        Ok(round) => format!("{}: {}", round.code(), round.teams().join(", ")),
        Err(_) => format!("{}: not readable", kept.name),
    }
}

/// Where a round stands.
fn place(round: &ClassRound) -> String {
    format!(
        "Question {} of {}.",
        round.place().question + 1,
        round.questions().len()
    )
}
