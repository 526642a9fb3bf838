//! What surrounds every screen: the title line, the line of keys, the help page,
//! and the one line that a screen too small for anything else gets.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};
use ratatui::widgets::{Clear, Widget};

use super::layer::AppLayer;
use super::{App, SMALLEST};
use crate::screens::{AnyScreen, Settings};
use crate::widgets::panels::draw_panel;
use crate::widgets::{Charset, Role, Theme, keys, text};

/// The part of a screen of this size that belongs to the screen on top.
pub(super) fn body(size: Rect) -> Rect {
    Rect::new(
        0,
        1.min(size.height),
        size.width,
        size.height.saturating_sub(2),
    )
}

/// Draws everything.
pub(super) fn draw(app: &App, area: Rect, buf: &mut Buffer) {
    let settings = app.settings();
    let theme = settings.theme();
    buf.set_style(area, theme.base());
    if area.width < SMALLEST.0 || area.height < SMALLEST.1 {
        return ask_for_room(area, buf, &theme);
    }
    let Some(screen) = app.stack.last() else {
        return;
    };
    title_line(app, screen.as_ref(), area, buf, &theme);
    screen.draw(body(area), buf, &app.context);
    screen_keys(app, screen.as_ref(), area, buf);
    for layer in &app.layers {
        match layer {
            AppLayer::Help { scrolled } => {
                help_page(app, screen.as_ref(), *scrolled, body(area), buf);
            }
            AppLayer::Notice(words) => show_note("please note", words, settings, area, buf),
            AppLayer::Confirm(question) => {
                show_note("please say", &question.text, settings, area, buf);
            }
        }
    }
    if let Some(layer) = app.layers.last() {
        let close = match layer {
            AppLayer::Help { .. } => Some("back"),
            AppLayer::Notice(_) => Some("go on"),
            AppLayer::Confirm(_) => None,
        };
        let table = layer.keys(&settings.keys);
        let rows = table.rows().iter().map(|row| (row.shown(), row.name));
        let any = close.map(|close| ("any key".to_owned(), close));
        key_line(any.into_iter().chain(rows), area, buf, settings);
    }
    if settings.charset == Charset::Ascii {
        keep_ascii(area, buf);
    }
}

fn ask_for_room(area: Rect, buf: &mut Buffer, theme: &Theme) {
    let (columns, rows) = SMALLEST;
    let text = format!(
        "carrom needs {columns}x{rows}; this is {}x{}",
        area.width, area.height
    );
    let row = area.height / 2;
    let column = area.width.saturating_sub(text.len() as u16) / 2;
    if row < area.height {
        buf.set_stringn(
            column,
            row,
            &text,
            area.width.into(),
            theme.style(Role::Text),
        );
    }
}

fn title_line(app: &App, screen: &dyn AnyScreen, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let charset = app.settings().charset;
    let name = format!(" carrom : {}", screen.title());
    let status = [app.keeping(), screen.status(&app.context)].join("  ");
    let status = charset.text(status.trim());
    let (end, _) = buf.set_stringn(
        0,
        0,
        charset.text(&name),
        area.width.into(),
        theme.style(Role::Title),
    );
    let width = text::width(&status) as u16;
    let start = area.width.saturating_sub(width + 1).max(end + 2);
    let room = usize::from(area.width.saturating_sub(start));
    // Half a code would look like another one.
    let status = text::clipped(&status, room);
    buf.set_stringn(start, 0, status, room, theme.style(Role::Dim));
}

/// The keys of the screen, `?` the last of them.
fn screen_keys(app: &App, screen: &dyn AnyScreen, area: Rect, buf: &mut Buffer) {
    let table = screen.table(&app.context);
    let rows = table.rows().iter().filter(|row| !row.name.is_empty());
    let rows = rows.map(|row| (row.shown(), row.name));
    let help = table.rows().iter().find(|row| row.id == "everywhere.help");
    let help = help.map(|row| (row.shown(), "help"));
    key_line(rows.chain(help), area, buf, app.settings());
}

/// Shows as many keys as fit whole; the last always keeps its place.
fn key_line(
    keys: impl Iterator<Item = (String, &'static str)>,
    area: Rect,
    buf: &mut Buffer,
    settings: &Settings,
) {
    let keys: Vec<_> = keys.filter(|(keys, _)| !keys.is_empty()).collect();
    let pairs: Vec<_> = keys
        .iter()
        .map(|(keys, name)| (keys.as_str(), *name))
        .collect();
    let theme = settings.theme();
    let line = keys::key_line(&pairs, area.width, settings.charset, &theme);
    let row = Rect::new(area.x, area.bottom() - 1, area.width, 1);
    Clear.render(row, buf);
    buf.set_style(row, theme.base());
    buf.set_line(row.x, row.y, &line, row.width);
}

fn help_lines(app: &App, screen: &dyn AnyScreen, width: usize) -> Vec<(String, Role)> {
    let charset = app.settings().charset;
    let mut lines = Vec::new();
    for paragraph in screen.about(&app.context) {
        for line in text::wrap(&charset.text(paragraph), width) {
            lines.push((line, Role::Text));
        }
        lines.push((String::new(), Role::Text));
    }
    let table = screen.table(&app.context);
    let rows = table.rows().iter().map(|row| (row.shown(), row.help));
    let all: Vec<_> = rows.filter(|(keys, _)| !keys.is_empty()).collect();
    let widest = all.iter().map(|(keys, _)| text::width(keys)).max();
    let column = widest.unwrap_or(0) + 2;
    for (keys, does) in &all {
        let does = charset.text(does);
        let wrapped = text::wrap(&does, width.saturating_sub(column).max(8));
        for (i, does) in wrapped.iter().enumerate() {
            let keys = if i == 0 { keys.as_str() } else { "" };
            lines.push((format!("{keys:column$}{does}"), Role::Dim));
        }
    }
    lines
}

/// Where the help page stands.
fn help_area(body: Rect) -> Rect {
    let wide = body.width.min(76);
    let margin = (body.width - wide) / 2;
    Rect::new(body.x + margin, body.y, wide, body.height)
}

/// How far the help page can be scrolled.
pub(super) fn help_overflow(app: &App) -> usize {
    let Some(screen) = app.stack.last() else {
        return 0;
    };
    let inner = help_area(app.context.body).inner(Margin::new(2, 1));
    let lines = help_lines(app, screen.as_ref(), inner.width.into());
    lines.len().saturating_sub(inner.height.into())
}

fn help_page(app: &App, screen: &dyn AnyScreen, scrolled: usize, body: Rect, buf: &mut Buffer) {
    let settings = app.settings();
    let theme = settings.theme();
    let area = help_area(body);
    // All of the body: what looks out beside the page would only be cut words.
    Clear.render(body, buf);
    buf.set_style(body, theme.base());
    let title = format!("help: {}", screen.title());
    draw_panel(buf, area, &title, settings.charset, &theme);
    let inner = area.inner(Margin::new(2, 1));
    let lines = help_lines(app, screen, inner.width.into());
    for (row, (line, role)) in inner.rows().zip(lines.iter().skip(scrolled)) {
        buf.set_stringn(
            row.x,
            row.y,
            settings.charset.text(line),
            row.width.into(),
            theme.style(*role),
        );
    }
}

/// Shows what the player is told or asked, at the foot of the body.
fn show_note(title: &str, words: &str, settings: &Settings, area: Rect, buf: &mut Buffer) {
    let theme = settings.theme();
    let body = body(area);
    let width = body.width.min(76);
    let words = settings.charset.text(words);
    // Whatever it says, it leaves something of the screen to be seen.
    let mut lines = text::wrap(&words, width.saturating_sub(4).into());
    lines.truncate(usize::from(body.height / 2).saturating_sub(2));
    let height = lines.len() as u16 + 2;
    let frame = Rect {
        x: body.x + (body.width - width) / 2,
        y: body.bottom().saturating_sub(height),
        width,
        height,
    };
    Clear.render(frame, buf);
    buf.set_style(frame, theme.base());
    draw_panel(buf, frame, title, settings.charset, &theme);
    for (row, line) in frame.inner(Margin::new(2, 1)).rows().zip(&lines) {
        buf.set_stringn(
            row.x,
            row.y,
            line,
            row.width.into(),
            theme.style(Role::Text),
        );
    }
}

/// The last word on the promise that an ASCII screen holds nothing else: names and
/// texts from outside may have slipped a stranger in.
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
