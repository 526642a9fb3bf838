//! How the foil looks: tabs above, the picture of a page, its panel beside it.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Foil, Page, beam_page, measured_page, tracks_page};
use crate::screens::Context;
use crate::widgets::picture::Picture;
use crate::widgets::{Lines, Look, Role, SplitLayout, text};

/// Where everything is.
#[derive(Debug, Clone, Copy)]
pub(super) struct FoilLayout {
    tabs: Rect,
    /// The picture and the panel.
    pub beside: SplitLayout,
}

impl FoilLayout {
    /// Lays it out in `area`.
    pub(super) fn new(area: Rect) -> Self {
        let row = 1.min(area.height);
        let tabs = Rect {
            height: row,
            ..area
        };
        let rest = Rect {
            y: area.y + row,
            height: area.height - row,
            ..area
        };
        Self {
            tabs,
            beside: SplitLayout::new(rest),
        }
    }

    /// The columns of each tab.
    fn tabs(self) -> [(Page, u16, String); 3] {
        let mut column = self.tabs.x + 1;
        Page::ALL.map(|page| {
            let start = column;
            let name = format!(" {} ", page.name());
            column += text::width(&name) as u16 + 2;
            (page, start, name)
        })
    }

    /// The page whose tab is at this cell.
    pub(super) fn tab_at(self, (column, row): (u16, u16)) -> Option<Page> {
        if !self.tabs.contains((column, row).into()) {
            return None;
        }
        let at = |(_, start, name): &(Page, u16, String)| {
            (*start..start + text::width(name) as u16).contains(&column)
        };
        self.tabs().into_iter().find(at).map(|(page, ..)| page)
    }

    /// Which row of the panel's text, which may be scrolled, is at this cell of it.
    pub(super) fn row_of_text(self, foil: &Foil, (_, row): (u16, u16), cx: &Context) -> u16 {
        let scrolled = foil
            .scroll
            .rows(self.beside.panel, cx.settings.look(), |lines| {
                write_panel(foil, lines, cx);
            });
        row.saturating_sub(self.beside.panel.y) + scrolled
    }
}

/// Draws the foil.
pub(super) fn draw(foil: &Foil, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = FoilLayout::new(area);
    for (page, column, name) in layout.tabs() {
        let role = if page == foil.page {
            Role::Selected
        } else {
            Role::Dim
        };
        let room = area.right().saturating_sub(column);
        let mark = if page == foil.page { ">" } else { " " };
        let name = format!("{mark}{}", &name[1..]);
        buf.set_stringn(
            column,
            layout.tabs.y,
            name,
            room.into(),
            look.theme.style(role),
        );
    }
    let beside = layout.beside;
    let side = match foil.page {
        Page::Tracks => "the particle",
        Page::Counts => "the beam",
        Page::Measured => "the experiment",
    };
    beside.draw(buf, &look, title(foil), side);
    picture(foil, beside.picture, look).draw(buf, &look);
    foil.scroll.draw(beside.panel, buf, look, |lines| {
        write_panel(foil, lines, cx);
    });
}

/// The title of the picture.
pub(super) fn title(foil: &Foil) -> &'static str {
    match foil.page {
        Page::Tracks => tracks_page::title(&foil.setup),
        Page::Counts => beam_page::title(&foil.setup),
        Page::Measured => measured_page::title(foil.levelled),
    }
}

/// The picture of the page.
pub(super) fn picture(foil: &Foil, area: Rect, look: Look) -> Picture {
    match foil.page {
        Page::Tracks => tracks_page::picture(&foil.setup, area),
        Page::Counts => beam_page::picture(foil, area, look),
        Page::Measured => measured_page::picture(foil.levelled, area, look),
    }
}

/// Writes what stands beside the picture.
pub(super) fn write_panel(foil: &Foil, lines: &mut Lines, cx: &Context) {
    match foil.page {
        Page::Tracks => {
            settings(foil, lines);
            tracks_page::write(&foil.setup, lines);
        }
        Page::Counts => match foil.guess {
            Some(chosen) => beam_page::write_guess(foil, chosen, lines),
            None => {
                settings(foil, lines);
                beam_page::write(foil, lines, cx);
            }
        },
        Page::Measured => measured_page::write(lines),
    }
}

/// The settings of the page, a row each.
fn settings(foil: &Foil, lines: &mut Lines) {
    let chosen = foil.field();
    for field in foil.fields() {
        let is_chosen = chosen == Some(*field);
        let value = if is_chosen && foil.entry.is_open() {
            format!("{}_", foil.entry.text())
        } else {
            field.shown(&foil.setup)
        };
        let (name_role, value_role) = if is_chosen {
            (Role::Selected, Role::Selected)
        } else {
            (Role::Dim, Role::Text)
        };
        let mark = if is_chosen { ">" } else { " " };
        let name = format!("{mark} {}", field.name());
        lines.pair(&name, &value, name_role, value_role);
    }
    if let Some(field) = chosen.filter(|_| foil.held) {
        lines.line(&format!("  {}", field.range(&foil.setup)), Role::Warn);
    }
}
