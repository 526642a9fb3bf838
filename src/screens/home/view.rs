//! How the first screen looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{ENTRIES, Home};
use crate::screens::Context;
use crate::widgets::input::ListView;
use crate::widgets::panels::draw_panel;
use crate::widgets::{Lines, Role, areas};

/// Columns of the menu.
const MENU: u16 = 36;
/// Rows above the first choice.
const HEAD_ROWS: u16 = 3;

/// Where the picture's frame and the menu are.
fn layout(area: Rect) -> [Rect; 2] {
    areas::picture_and_panel(area, MENU)
}

/// Which line of the menu stands at this cell.
pub(super) fn choice_at(area: Rect, cell: (u16, u16)) -> Option<usize> {
    let [_, menu] = layout(area);
    let row = ListView::row_at(menu, cell)?.checked_sub(HEAD_ROWS.into())?;
    let choice = row / usize::from(rows_of_a_choice(menu));
    (choice < ENTRIES.len()).then_some(choice)
}

/// A choice takes a row for its name, one for what it is about and an empty one, as
/// far as there is room for all of them.
fn rows_of_a_choice(menu: Rect) -> u16 {
    let room = menu.height.saturating_sub(HEAD_ROWS);
    (room / ENTRIES.len() as u16).clamp(1, 3)
}

/// Draws the menu beside a hit.
pub(super) fn draw(home: &Home, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let [picture, menu] = layout(area);
    let title = "a glancing hit";
    let inside = draw_panel(buf, picture, title, look.charset, &look.theme);
    home.picture.picture(inside).draw(buf, &look);
    let mut lines = Lines::new(menu, buf, look);
    lines.line("Aim. Say where both will go.", Role::Text);
    lines.line("Then watch the exact hit, and why.", Role::Text);
    lines.line("", Role::Text);
    let rows = rows_of_a_choice(menu);
    for (i, choice) in ENTRIES.iter().enumerate() {
        let chosen = i == home.list.chosen(ENTRIES.len());
        let (mark, role) = Role::Text.of_choice(chosen);
        lines.line(&format!("{mark} {}  {} ", choice.key, choice.name), role);
        if rows > 1 {
            lines.line(&format!("     {}", choice.about), Role::Dim);
        }
        if rows > 2 {
            lines.line("", Role::Text);
        }
    }
    let whole = lines.rows_by(first_steps);
    if lines.left() > whole {
        lines.gap();
        first_steps(&mut lines);
    } else if lines.left() > 1 {
        lines.gap();
        lines.line("New here? Press l, then Enter.", Role::Key);
    }
}

/// The way for someone who is here for the first time.
fn first_steps(lines: &mut Lines) {
    lines.line("New here? Three minutes:", Role::Key);
    let steps = [
        (
            "1. ",
            "Press l for the lab, then Enter: say where both will go, and watch one hit.",
        ),
        (
            "2. ",
            "Press Esc until you are back, then e and Enter: the first chapter of Learn.",
        ),
    ];
    for (number, step) in steps {
        lines.hanging(number, step, Role::Text);
    }
}
