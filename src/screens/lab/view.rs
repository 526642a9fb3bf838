//! How the lab looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Lab, LabPhase, panel};
use crate::screens::Context;
use crate::widgets::SplitLayout;
use crate::widgets::hit::{Face, Markings, setup_picture};

/// Draws the lab.
pub(super) fn draw(lab: &Lab, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = SplitLayout::new(area);
    let (title, side_title) = match &lab.phase {
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
