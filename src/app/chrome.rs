//! What surrounds every screen: the title line, the line of keys, the help page,
//! and the one line that a screen too small for anything else gets.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};
use ratatui::widgets::{Clear, Widget};

use super::{App, SMALLEST};
use crate::screens::{Help, Hint, Screen, Settings};
use crate::widgets::panel::draw_panel;
use crate::widgets::{Charset, Role, Theme, keys, text};

/// Keys that every screen shares, for the help page.
const SHARED: [Hint; 6] = [
    Hint::new("?", "explain this screen"),
    Hint::new("Esc", "go back"),
    Hint::new("U or F2", "switch between ASCII and Unicode"),
    Hint::new("T or F3", "next theme: dark, light, no colour"),
    Hint::new("M or F4", "reduce motion, or bring it back"),
    Hint::new("Ctrl+C", "leave carrom"),
];

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
    match app.help {
        None => key_line(
            &screen.keys(&app.context),
            area,
            buf,
            &theme,
            settings.charset,
        ),
        Some(scrolled) => {
            help_page(app, screen.as_ref(), scrolled, body(area), buf);
            let hints = [Hint::new("any key", "back"), Hint::new("Up Down", "scroll")];
            key_line(&hints, area, buf, &theme, settings.charset);
        }
    }
    if let Some(notice) = &app.notice {
        show_notice(notice, settings, area, buf);
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

fn title_line(app: &App, screen: &dyn Screen, area: Rect, buf: &mut Buffer, theme: &Theme) {
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

/// Shows as many hints as fit whole; `?` always keeps its place at the end.
fn key_line(hints: &[Hint], area: Rect, buf: &mut Buffer, theme: &Theme, charset: Charset) {
    let mut pairs: Vec<_> = hints.iter().map(|hint| (hint.key, hint.does)).collect();
    pairs.push(("?", "help"));
    let line = keys::key_line(&pairs, area.width, charset, theme);
    buf.set_line(area.x, area.bottom() - 1, &line, area.width);
}

fn help_lines(help: &Help, width: usize, charset: Charset) -> Vec<(String, Role)> {
    let mut lines = Vec::new();
    for paragraph in &help.text {
        for line in text::wrap(&charset.text(paragraph), width) {
            lines.push((line, Role::Text));
        }
        lines.push((String::new(), Role::Text));
    }
    let all = || help.keys.iter().chain(&SHARED);
    let column = all().map(|hint| text::width(hint.key)).max().unwrap_or(0) + 2;
    for hint in all() {
        let does = charset.text(hint.does);
        let wrapped = text::wrap(&does, width.saturating_sub(column).max(8));
        for (i, does) in wrapped.iter().enumerate() {
            let key = if i == 0 { hint.key } else { "" };
            lines.push((format!("{key:column$}{does}"), Role::Dim));
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
    let lines = help_lines(
        &screen.help(&app.context),
        inner.width.into(),
        app.settings().charset,
    );
    lines.len().saturating_sub(inner.height.into())
}

fn help_page(app: &App, screen: &dyn Screen, scrolled: usize, body: Rect, buf: &mut Buffer) {
    let settings = app.settings();
    let theme = settings.theme();
    let area = help_area(body);
    // All of the body: what looks out beside the page would only be cut words.
    Clear.render(body, buf);
    buf.set_style(body, theme.base());
    let title = format!("help: {}", screen.title());
    draw_panel(buf, area, &title, settings.charset, &theme);
    let inner = area.inner(Margin::new(2, 1));
    let lines = help_lines(
        &screen.help(&app.context),
        inner.width.into(),
        settings.charset,
    );
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

/// Shows what the player is to be told, at the foot of the body.
fn show_notice(notice: &str, settings: &Settings, area: Rect, buf: &mut Buffer) {
    let theme = settings.theme();
    let body = body(area);
    let width = body.width.min(76);
    let words = settings.charset.text(notice);
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
    draw_panel(buf, frame, "please note", settings.charset, &theme);
    for (row, line) in frame.inner(Margin::new(2, 1)).rows().zip(&lines) {
        buf.set_stringn(
            row.x,
            row.y,
            line,
            row.width.into(),
            theme.style(Role::Text),
        );
    }
    let hint = [("any key", "go on")];
    let line = keys::key_line(&hint, area.width, settings.charset, &theme);
    let keys = Rect::new(area.x, area.bottom() - 1, area.width, 1);
    Clear.render(keys, buf);
    buf.set_style(keys, theme.base());
    buf.set_line(keys.x, keys.y, &line, keys.width);
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
