//! The parts that every screen has in common: the title line, the key line, the help page, and the
//! single line on a screen that is too small for anything else.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};
use ratatui::widgets::{Clear, Widget};

use super::layer::{AppLayer, LayerAction};
use super::{App, SMALLEST};
use crate::screens::AnyScreen;
use crate::widgets::panel::{Panel, Writing};
use crate::widgets::panels::draw_panel;
use crate::widgets::{Charset, Look, Role, SheetKind, areas, keys, sheet, text};

/// The area of the current screen if the window has this size.
pub(super) fn body(size: Rect) -> Rect {
    let (top, rows) = (1.min(size.height), size.height.saturating_sub(2));
    Rect::new(0, top, size.width, rows)
}

pub(super) fn draw(app: &App, area: Rect, buf: &mut Buffer) {
    let look = app.settings().look();
    buf.set_style(area, look.theme.base());
    if area.width < SMALLEST.0 || area.height < SMALLEST.1 {
        return ask_for_room(area, buf, look);
    }
    let Some(screen) = app.stack.last() else {
        return;
    };
    title_line(app, screen.as_ref(), area, buf, look);
    let body = body(area);
    screen.draw(buf, &app.context);
    // The key line ends with `?`.
    let table = screen.table(&app.context);
    let rows = table.rows().iter().filter(|row| !row.name.is_empty());
    let rows = rows.map(|row| (row.brief(), row.name));
    let help = table.rows().iter().find(|row| row.id == "everywhere.help");
    let help = help.map(|row| (row.shown(), "help"));
    key_line(rows.chain(help), area, buf, look);
    for layer in &app.layers {
        draw_layer(app, layer, body, buf);
    }
    if let Some(layer) = app.layers.last() {
        let close = match layer {
            AppLayer::Help { .. } => Some("back"),
            AppLayer::Notice(_) => Some("go on"),
            AppLayer::Confirm(_) | AppLayer::Leave(_) => None,
        };
        let table = layer.keys(&app.settings().keys);
        let rows = table.rows().iter().map(|row| (row.shown(), row.name));
        let any = close.map(|close| ("any key".to_owned(), close));
        key_line(any.into_iter().chain(rows), area, buf, look);
    }
    if look.charset == Charset::Ascii {
        keep_ascii(area, buf);
    }
}

fn ask_for_room(area: Rect, buf: &mut Buffer, look: Look) {
    let (columns, rows) = SMALLEST;
    let text = format!(
        "carrom needs {columns}x{rows}; this is {}x{}",
        area.width, area.height
    );
    let row = area.height / 2;
    let column = area.width.saturating_sub(text.len() as u16) / 2;
    if row < area.height {
        let style = look.theme.style(Role::Text);
        buf.set_stringn(column, row, &text, area.width.into(), style);
    }
}

fn title_line(app: &App, screen: &dyn AnyScreen, area: Rect, buf: &mut Buffer, look: Look) {
    let status = [app.keeping(), screen.status(&app.context)].join("  ");
    let title = screen.title();
    let [title, status] = [&*title, status.trim()].map(|it| look.charset.text(it));
    sheet::begin(SheetKind::Screen, &title, &status);
    let name = format!(" carrom : {title}");
    let style = look.theme.style(Role::Title);
    let (end, _) = buf.set_stringn(0, 0, name, area.width.into(), style);
    let width = text::width(&status) as u16;
    let start = area.width.saturating_sub(width + 1).max(end + 2);
    let room = usize::from(area.width.saturating_sub(start));
    // A code truncated without a mark would look like a different code.
    let status = text::clipped(&status, room);
    buf.set_stringn(start, 0, status, room, look.theme.style(Role::Dim));
}

/// Shows as many keys as fit without being cut off; the last key is always shown.
fn key_line(
    keys: impl Iterator<Item = (String, &'static str)>,
    area: Rect,
    buf: &mut Buffer,
    look: Look,
) {
    let keys: Vec<_> = keys.filter(|(keys, _)| !keys.is_empty()).collect();
    let line = keys::key_line(&keys, area.width, &look);
    let row = Rect::new(area.x, area.bottom() - 1, area.width, 1);
    clear(row, buf, look);
    buf.set_line(row.x, row.y, &line, row.width);
}

fn panel_of(app: &App, layer: &AppLayer) -> (SheetKind, Panel<LayerAction>) {
    let (kind, title, words) = match layer {
        AppLayer::Help { .. } => return (SheetKind::Help, help(app)),
        AppLayer::Notice(words) => (SheetKind::Notice, "please note", words),
        AppLayer::Confirm(question) | AppLayer::Leave(question) => {
            (SheetKind::Question, "please choose", &question.text)
        }
    };
    let mut panel = Panel::new(title);
    panel.paragraph(words, Role::Text);
    (kind, panel)
}

/// The help page for the topmost screen.
fn help(app: &App) -> Panel<LayerAction> {
    let Some(screen) = app.stack.last() else {
        return Panel::new("help");
    };
    let mut panel = Panel::new(format!("help: {}", screen.title()));
    for paragraph in screen.help().lines() {
        panel.paragraph(paragraph, Role::Text);
        panel.gap();
    }
    let table = screen.table(&app.context);
    let rows = table.rows().iter().map(|row| (row.shown(), row.help));
    let all: Vec<_> = rows.filter(|(keys, _)| !keys.is_empty()).collect();
    let widest = all.iter().map(|(keys, _)| text::width(keys)).max();
    let column = widest.unwrap_or(0) + 2;
    for (keys, does) in &all {
        panel.marked(&format!("{keys:column$}"), *does, Role::Dim);
    }
    panel
}

/// The style in which a layer is drawn.
fn writing(app: &App) -> Writing<'static, LayerAction> {
    Writing {
        look: app.settings().look(),
        pages: None,
        key: &|_| None,
    }
}

/// How far the help page can be scrolled, in lines.
pub(super) fn help_overflow(app: &App) -> u16 {
    let inside = centred(app.context.body).inner(Margin::new(1, 1));
    help(app).placed(inside, &writing(app)).overflow()
}

/// Draws a layer. A help page covers the whole body, because only truncated words would be visible
/// beside the page. Any other layer is at the bottom of the body, so the rest of the screen stays
/// visible.
fn draw_layer(app: &App, layer: &AppLayer, body: Rect, buf: &mut Buffer) {
    let writing = writing(app);
    let (kind, panel) = panel_of(app, layer);
    let columns = centred(body);
    let (scrolled, frame, covered) = match layer {
        AppLayer::Help { scrolled, .. } => (*scrolled, columns, body),
        AppLayer::Notice(_) | AppLayer::Confirm(_) | AppLayer::Leave(_) => {
            let placed = panel.placed(columns.inner(Margin::new(1, 1)), &writing);
            let height = (placed.rows() + 2).min(body.height / 2);
            let [_, frame] = areas::upper(columns, columns.height.saturating_sub(height));
            (0, frame, frame)
        }
    };
    sheet::begin(kind, &panel.title, "");
    let look = writing.look;
    clear(covered, buf, look);
    let inside = draw_panel(buf, frame, &panel.title, &look);
    let placed = panel.placed(inside, &writing);
    placed.draw(scrolled, buf, &writing);
}

/// The columns of the body in which the frame of a layer is drawn.
fn centred(body: Rect) -> Rect {
    areas::middle(body, 76)
}

fn clear(area: Rect, buf: &mut Buffer, look: Look) {
    Clear.render(area, buf);
    buf.set_style(area, look.theme.base());
}

/// Ensures that a screen in ASCII contains only ASCII characters: names and external text may
/// contain other characters.
fn keep_ascii(area: Rect, buf: &mut Buffer) {
    for position in area.positions() {
        if let Some(cell) = buf.cell_mut(position) {
            let printable = |b: u8| (0x20..0x7f).contains(&b);
            if cell.symbol().len() != 1 || !cell.symbol().bytes().all(printable) {
                cell.set_symbol("?");
            }
        }
    }
}
