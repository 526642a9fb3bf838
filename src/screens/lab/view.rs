//! How the lab looks.

use glam::DVec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Lab, LabPhase, panel};
use crate::physics::Bond;
use crate::screens::Context;
use crate::screens::learn::speeds_picture;
use crate::widgets::hit::{Face, Markings, Overlay, Overlays, Watch, setup_picture};
use crate::widgets::{SplitLayout, areas};

/// Draws the lab.
pub(super) fn draw(lab: &Lab, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = SplitLayout::new(area);
    let (title, side_title) = match &lab.phase {
        LabPhase::Aim if lab.is_live(cx) => ("live: it follows what you set".into(), "settings"),
        LabPhase::Aim => ("set up the hit".into(), "settings"),
        LabPhase::Predict(_) => ("where will they go?".into(), "say it first"),
        LabPhase::Watch(watch) => (watch.slowed_title(), "the shot"),
    };
    layout.draw(buf, &look, &title, side_title);
    let collision = lab.settings.setup.collision();
    let given = Markings::ALL;
    let faces = Face::STRIKER_AND_COIN;
    let setup = |rays| setup_picture(layout.picture, faces, &collision, given, rays);
    match &lab.phase {
        LabPhase::Aim if lab.is_live(cx) => {
            live(lab, layout.picture, buf, cx);
            panel::draw_settings(lab, layout.panel, buf, cx);
        }
        LabPhase::Aim => {
            setup(None).draw(buf, &look);
            panel::draw_settings(lab, layout.panel, buf, cx);
        }
        LabPhase::Predict(rays) => {
            setup(Some(rays)).draw(buf, &look);
            panel::draw_prediction(lab, rays, layout.panel, buf, cx);
        }
        LabPhase::Watch(watch) => {
            watch.picture(layout.picture).draw(buf, &look);
            lab.scroll.draw(layout.panel, buf, look, |lines| {
                panel::write_shot(lab, watch, lines);
            });
        }
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
fn live(lab: &Lab, picture: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let hit = hit_area(lab, picture, cx);
    live_hit(lab).picture(hit).draw(buf, &look);
    if hit.height < picture.height {
        let [_, below] = areas::upper(picture, hit.height);
        speeds_picture(&lab.settings.setup, below, &look).draw(buf, &look);
    }
}
