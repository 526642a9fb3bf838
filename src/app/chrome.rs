//! What surrounds every screen: the title line, the line of keys, the help page,
//! and the one line that a screen too small for anything else gets.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};
use ratatui::widgets::{Clear, Widget};

use super::layer::AppLayer;
use super::{App, SMALLEST};
use crate::screens::AnyScreen;
use crate::widgets::flow::Run;
use crate::widgets::panels::draw_panel;
use crate::widgets::{
    Charset, Lines, Look, Role, SheetKind, Words, areas, keys, overflow, sheet, text,
};

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
    screen.draw(body, buf, &app.context);
    // `?` is the last of the screen's keys.
    let table = screen.table(&app.context);
    let rows = table.rows().iter().filter(|row| !row.name.is_empty());
    let rows = rows.map(|row| (row.shown(), row.name));
    let help = table.rows().iter().find(|row| row.id == "everywhere.help");
    let help = help.map(|row| (row.shown(), "help"));
    key_line(rows.chain(help), area, buf, look);
    for layer in &app.layers {
        match layer {
            AppLayer::Help { scrolled } => {
                let title = format!("help: {}", screen.title());
                sheet::begin(SheetKind::Help, &title, "");
                // All of the body: what looks out beside the page would only be cut words.
                let page = framed(&title, (centred(body), body), buf, look);
                write_help(app, screen.as_ref(), &mut page.scrolled(*scrolled));
            }
            AppLayer::Notice(words) => {
                sheet::begin(SheetKind::Notice, "please note", "");
                show_note("please note", words, body, buf, look);
            }
            AppLayer::Confirm(question) | AppLayer::Leave(question) => {
                sheet::begin(SheetKind::Question, "please say", "");
                show_note("please say", &question.text, body, buf, look);
            }
        }
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
    let name = format!(" carrom : {}", screen.title());
    let name = look.charset.text(&name);
    let status = [app.keeping(), screen.status(&app.context)].join("  ");
    sheet::begin(
        SheetKind::Screen,
        &look.charset.text(&screen.title()),
        &look.charset.text(status.trim()),
    );
    let status = look.charset.text(status.trim());
    let title = look.theme.style(Role::Title);
    let (end, _) = buf.set_stringn(0, 0, name, area.width.into(), title);
    let width = text::width(&status) as u16;
    let start = area.width.saturating_sub(width + 1).max(end + 2);
    let room = usize::from(area.width.saturating_sub(start));
    // Half a code would look like another one.
    let status = text::clipped(&status, room);
    buf.set_stringn(start, 0, status, room, look.theme.style(Role::Dim));
}

/// Shows as many keys as fit whole; the last always keeps its place.
fn key_line(
    keys: impl Iterator<Item = (String, &'static str)>,
    area: Rect,
    buf: &mut Buffer,
    look: Look,
) {
    let keys: Vec<_> = keys.filter(|(keys, _)| !keys.is_empty()).collect();
    let pairs: Vec<_> = keys
        .iter()
        .map(|(keys, name)| (keys.as_str(), *name))
        .collect();
    let line = keys::key_line(&pairs, area.width, look.charset, &look.theme);
    let row = Rect::new(area.x, area.bottom() - 1, area.width, 1);
    clear(row, buf, look);
    buf.set_line(row.x, row.y, &line, row.width);
}

/// Writes the help page of a screen.
fn write_help(app: &App, screen: &dyn AnyScreen, lines: &mut Lines) {
    for paragraph in screen.about(&app.context) {
        lines.paragraph(paragraph, Role::Text);
        lines.gap();
    }
    let table = screen.table(&app.context);
    let rows = table.rows().iter().map(|row| (row.shown(), row.help));
    let all: Vec<_> = rows.filter(|(keys, _)| !keys.is_empty()).collect();
    let widest = all.iter().map(|(keys, _)| text::width(keys)).max();
    let column = widest.unwrap_or(0) + 2;
    for (keys, does) in &all {
        lines.hanging(&format!("{keys:column$}"), does, Role::Dim);
    }
}

/// How far the help page can be scrolled.
pub(super) fn help_overflow(app: &App) -> u16 {
    let Some(screen) = app.stack.last() else {
        return 0;
    };
    let inside = centred(app.context.body).inner(Margin::new(1, 1));
    let write = |lines: &mut Lines| write_help(app, screen.as_ref(), lines);
    overflow(inside, app.settings().look(), write)
}

/// The columns of the body in which something lies over it.
fn centred(body: Rect) -> Rect {
    areas::middle(body, 76)
}

fn clear(area: Rect, buf: &mut Buffer, look: Look) {
    Clear.render(area, buf);
    buf.set_style(area, look.theme.base());
}

/// Clears an area and draws an empty frame there, to be written into.
fn framed<'a>(
    title: &str,
    (frame, cleared): (Rect, Rect),
    buf: &'a mut Buffer,
    look: Look,
) -> Lines<'a> {
    clear(cleared, buf, look);
    let inside = draw_panel(buf, frame, title, look.charset, &look.theme);
    Lines::new(inside, buf, look)
}

/// Shows what the player is told or asked, at the foot of the body.
fn show_note(title: &str, words: &str, body: Rect, buf: &mut Buffer, look: Look) {
    let columns = centred(body);
    let words = look.charset.text(words);
    // Whatever it says, it leaves something of the screen to be seen.
    let mut lines = text::wrap(&words, columns.width.saturating_sub(4).into());
    lines.truncate(usize::from(body.height / 2).saturating_sub(2));
    let height = lines.len() as u16 + 2;
    let y = body.bottom().saturating_sub(height);
    let frame = Rect {
        y,
        height,
        ..columns
    };
    let mut note = framed(title, (frame, frame), buf, look);
    let all = Run::new(words.clone(), Role::Text);
    note.written_as(
        |_| Words::text(all),
        |note| {
            lines.iter().for_each(|line| note.line(line, Role::Text));
        },
    );
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
