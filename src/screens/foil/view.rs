//! The view of the foil: the tabs, the picture of a page, and the panel beside it.

use ratatui::layout::Rect;

use super::{FoilAction, FoilScreen, beam_page, measured_page, tracks_page};
use crate::screens::route::FoilPage;
use crate::screens::{Context, View};
use crate::widgets::Look;
use crate::widgets::panel::Panel;
use crate::widgets::picture::Picture;

/// The open page, below the names of all pages.
pub(super) fn view<'s>(foil: &'s FoilScreen, cx: &Context) -> View<'s, FoilAction> {
    let mut tabs = Panel::new("");
    let pages = FoilPage::ALL.map(|page| (page.name(), FoilAction::Open(page)));
    tabs.tabs(pages, foil.fields.page as usize);
    let draw = |area, buf: &mut _, look: &Look| picture(foil, area, *look).draw(buf, look);
    View {
        tabs: Some(tabs),
        ..View::picture(title(foil), draw, panel(foil, cx)).dragging(match foil.fields.page {
            FoilPage::Tracks => Some("Drag the particle up or down to set its offset."),
            FoilPage::Counts | FoilPage::Measured => None,
        })
    }
}

/// The title of the picture.
pub(super) fn title(foil: &FoilScreen) -> &'static str {
    match foil.fields.page {
        FoilPage::Tracks => tracks_page::title(&foil.fields.setup),
        FoilPage::Counts => beam_page::title(foil),
        FoilPage::Measured => measured_page::title(foil.levelled),
    }
}

pub(super) fn picture(foil: &FoilScreen, area: Rect, look: Look) -> Picture {
    match foil.fields.page {
        FoilPage::Tracks => tracks_page::picture(&foil.fields.setup, area),
        FoilPage::Counts => beam_page::picture(foil, area, look),
        FoilPage::Measured => measured_page::picture(foil.levelled, area, look),
    }
}

fn panel(foil: &FoilScreen, cx: &Context) -> Panel<FoilAction> {
    let mut panel = Panel::new(match foil.fields.page {
        FoilPage::Tracks => "the particle",
        FoilPage::Counts => "the beam",
        FoilPage::Measured => "the experiment",
    });
    panel.subject = 2 * foil.runs as usize;
    if let Some(said) = &foil.guess {
        panel.subject += 1;
        beam_page::write_guess(foil, said, &mut panel);
        return panel;
    }
    panel.part(FoilAction::Set, |panel| {
        foil.form.write(&foil.fields, panel);
        foil.form.write_about(&foil.fields, panel);
    });
    match foil.fields.page {
        FoilPage::Tracks => tracks_page::write(&foil.fields.setup, &mut panel),
        FoilPage::Counts => beam_page::write(foil, &mut panel, cx),
        FoilPage::Measured => measured_page::write(&mut panel),
    }
    panel
}
