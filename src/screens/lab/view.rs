//! What the lab shows.

use glam::DVec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Lab, LabAction, LabPhase, panel};
use crate::lessons::FigureKind;
use crate::physics::Bond;
use crate::screens::{Context, View};
use crate::widgets::curves::curves_picture;
use crate::widgets::hit::{Face, Markings, Overlay, Overlays, Watch, setup_picture};
use crate::widgets::{Look, RayInput, areas};

/// The picture, and the panel beside it.
pub(super) fn view<'s>(lab: &'s Lab, cx: &'s Context) -> View<'s, LabAction> {
    let setup = |rays: Option<&'s RayInput>| {
        move |area: Rect, buf: &mut Buffer, look: &Look| {
            let collision = lab.settings.setup.collision();
            let faces = Face::STRIKER_AND_COIN;
            setup_picture(area, faces, &collision, Markings::ALL, rays).draw(buf, look);
        }
    };
    match &lab.phase {
        LabPhase::Aim if lab.is_live(cx) => View::picture(
            "live: it follows what you set",
            |area, buf, look| live(lab, area, buf, look, cx),
            panel::settings(lab, cx),
        ),
        LabPhase::Aim => View::picture("set up the hit", setup(None), panel::settings(lab, cx)),
        LabPhase::Predict(rays) => View::picture(
            "where will they go?",
            setup(Some(rays)),
            panel::prediction(lab, rays),
        ),
        LabPhase::Watch(watch) => View::picture(
            watch.slowed_title(),
            |area, buf, look| watch.picture(area).draw(buf, look),
            panel::shot(lab, watch),
        ),
    }
}

/// Fewest rows of a picture that has room for the curves too.
const ROOM_FOR_CURVES: u16 = 18;

/// The hit as what is set makes it, told to its end.
pub(super) fn live_hit(lab: &Lab) -> Watch {
    let layers = Overlays::default().without([Overlay::Triangle, Overlay::Trails]);
    Watch::told(lab.settings.setup.collision()).with_layers(layers)
}

/// Where the hit stands in the picture: above the curves, where they are drawn.
pub(super) fn hit_area(lab: &Lab, picture: Rect, cx: &Context) -> Rect {
    match lab.is_live(cx) && has_curves(lab, picture) {
        true => areas::upper(picture, picture.height * 11 / 20)[0],
        false => picture,
    }
}

/// Whether there are curves to draw, which are those of smooth discs and a coin at rest, and
/// room for them.
fn has_curves(lab: &Lab, picture: Rect) -> bool {
    let collision = lab.settings.setup.collision();
    let plain = collision.bond == Bond::Slip && collision.u2 == DVec2::ZERO;
    plain && collision.alpha().is_some() && picture.height >= ROOM_FOR_CURVES
}

/// Draws the hit and, where there is room, how both speeds go with the impact angle.
fn live(lab: &Lab, picture: Rect, buf: &mut Buffer, look: &Look, cx: &Context) {
    let hit = hit_area(lab, picture, cx);
    live_hit(lab).picture(hit).draw(buf, look);
    if hit.height < picture.height {
        let [_, below] = areas::upper(picture, hit.height);
        let collision = lab.settings.setup.collision();
        curves_picture(FigureKind::Curves, &collision, below, look).draw(buf, look);
    }
}
