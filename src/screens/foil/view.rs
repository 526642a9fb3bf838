//! How the foil looks: tabs above, the picture of a page, its panel beside it.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{FoilPage, FoilScreen, beam_page, measured_page, tracks_page};
use crate::screens::Context;
use crate::widgets::panel::written;
use crate::widgets::picture::Picture;
use crate::widgets::{Item, Lines, Look, Role, Room, SplitLayout, Words, areas, sheet, text};

/// Where everything is.
#[derive(Debug, Clone, Copy)]
pub(super) struct FoilLayout {
    tabs: Rect,
    /// The picture and the panel.
    pub beside: SplitLayout,
}

impl FoilLayout {
    /// Lays it out in `area`.
    pub(super) fn new(room: Room) -> Self {
        let [tabs, rest] = areas::upper(room.area, 1);
        Self {
            tabs,
            beside: SplitLayout::new(Room { area: rest, ..room }),
        }
    }

    /// The columns of each tab.
    fn tabs(self) -> [(FoilPage, u16, String); 3] {
        let mut column = self.tabs.x + 1;
        FoilPage::ALL.map(|page| {
            let start = column;
            let name = format!(" {} ", page.name());
            column += text::width(&name) as u16 + 2;
            (page, start, name)
        })
    }

    /// The page whose tab is at this cell.
    pub(crate) fn tab_at(self, (column, row): (u16, u16)) -> Option<FoilPage> {
        if !self.tabs.contains((column, row).into()) {
            return None;
        }
        let at = |(_, start, name): &(FoilPage, u16, String)| {
            (*start..start + text::width(name) as u16).contains(&column)
        };
        self.tabs().into_iter().find(at).map(|(page, ..)| page)
    }

    /// Which row of the panel's text, which may be scrolled, is at this cell of it.
    pub(crate) fn row_of_text(self, foil: &FoilScreen, (_, row): (u16, u16), cx: &Context) -> u16 {
        let (panel, look) = (self.beside.panel, cx.settings.look());
        let write = |lines: &mut Lines| write_panel(foil, lines, cx);
        row.saturating_sub(panel.y) + foil.scroll.rows(panel, look, write)
    }
}

/// Draws the foil.
pub(super) fn draw(foil: &FoilScreen, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = FoilLayout::new(cx.room());
    for (page, column, name) in layout.tabs() {
        let (mark, role) = Role::Dim.of_choice(page == foil.page);
        let room = area.right().saturating_sub(column).into();
        sheet::note(layout.tabs, || Item {
            words: Words::Tab {
                name: name.trim().to_owned(),
            },
            press: Some([column, layout.tabs.y]),
            chosen: Some(page == foil.page),
        });
        let name = format!("{mark}{}", &name[1..]);
        let style = look.theme.style(role);
        buf.set_stringn(column, layout.tabs.y, name, room, style);
    }
    let beside = layout.beside;
    let side = match foil.page {
        FoilPage::Tracks => "the particle",
        FoilPage::Counts => "the beam",
        FoilPage::Measured => "the experiment",
    };
    beside.draw(buf, &look, title(foil), side);
    picture(foil, beside.picture, look).draw(buf, &look);
    foil.scroll.draw(beside.panel, buf, look, |lines| {
        write_panel(foil, lines, cx);
    });
}

/// The title of the picture.
pub(super) fn title(foil: &FoilScreen) -> &'static str {
    match foil.page {
        FoilPage::Tracks => tracks_page::title(&foil.setup),
        FoilPage::Counts => beam_page::title(foil),
        FoilPage::Measured => measured_page::title(foil.levelled),
    }
}

/// The picture of the page.
pub(super) fn picture(foil: &FoilScreen, area: Rect, look: Look) -> Picture {
    match foil.page {
        FoilPage::Tracks => tracks_page::picture(&foil.setup, area),
        FoilPage::Counts => beam_page::picture(foil, area, look),
        FoilPage::Measured => measured_page::picture(foil.levelled, area, look),
    }
}

/// Writes what stands beside the picture.
pub(super) fn write_panel(foil: &FoilScreen, lines: &mut Lines, cx: &Context) {
    match foil.page {
        FoilPage::Tracks => {
            settings(foil, lines);
            tracks_page::write(&foil.setup, lines);
        }
        FoilPage::Counts => match &foil.guess {
            Some(said) => beam_page::write_guess(foil, said, lines),
            None => {
                settings(foil, lines);
                beam_page::write(foil, lines, cx);
            }
        },
        FoilPage::Measured => measured_page::write(lines),
    }
}

/// The settings of the page, a row each, and what the chosen one is.
fn settings(foil: &FoilScreen, lines: &mut Lines) {
    written(lines, |panel| {
        foil.form.write(&foil.fields(), panel);
        foil.form.write_about(&foil.fields(), panel);
    });
}
