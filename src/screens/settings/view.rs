//! How the settings look.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::SettingsScreen;
use crate::screens::Context;
use crate::widgets::input::{FormFields, ListView};
use crate::widgets::{Lines, Role, SplitLayout};

/// The setting whose row is at a cell.
pub(super) fn row_at(cx: &Context, cell: (u16, u16)) -> Option<usize> {
    let row = ListView::row_at(SplitLayout::new(cx.body).picture, cell)?;
    (row < cx.settings.fields().len()).then_some(row)
}

/// Draws the settings beside what the chosen one is.
pub(super) fn draw(screen: &SettingsScreen, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = SplitLayout::new(area);
    layout.draw(buf, &look, "settings", "this setting");
    let mut lines = Lines::new(layout.picture, buf, look);
    screen.form.write(&cx.settings, &mut lines);
    lines.gap();
    if let Some(typed) = &screen.typed {
        lines.line(&format!("  name: {}", typed.shown()), Role::Selected);
        lines.gap();
    }
    let mut about = Lines::new(layout.panel, buf, look);
    screen.form.write_about(&cx.settings, &mut about);
    about.gap();
    about.line("Where everything is kept", Role::Title);
    match &cx.folder {
        Some(folder) => about.paragraph(folder, Role::Text),
        None => about.paragraph("Nowhere: it is gone when carrom ends.", Role::Text),
    }
    about.paragraph(
        "Answers, bookmarks, games and these settings are kept there and nowhere else.",
        Role::Dim,
    );
    about.gap();
    about.paragraph("? says how to change keys.", Role::Dim);
}
