//! How the lab looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Lab, Phase, panel};
use crate::screens::Context;
use crate::widgets::Beside;
use crate::widgets::hit::{Markings, draw_setup};

/// Draws the lab.
pub(super) fn draw(lab: &Lab, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = Beside::new(area);
    let (title, side_title) = match &lab.phase {
        Phase::Aim => ("set up the hit".into(), "settings"),
        Phase::Predict(_) => ("where will they go?".into(), "say it first"),
        Phase::Watch(watch) => (
            format!("the hit, slowed {:.0}×", watch.clock().slowed()),
            "the shot",
        ),
    };
    layout.draw(buf, &look, &title, side_title);
    let collision = lab.setup.collision();
    let given = Markings {
        offset: true,
        angle: true,
        figures: true,
    };
    match &lab.phase {
        Phase::Aim => {
            draw_setup(layout.picture, buf, &look, &collision, given, None);
            panel::draw_settings(lab, layout.panel, buf, cx);
        }
        Phase::Predict(rays) => {
            draw_setup(layout.picture, buf, &look, &collision, given, Some(rays));
            panel::draw_prediction(lab, rays, layout.panel, buf, cx);
        }
        Phase::Watch(watch) => {
            watch.draw(layout.picture, buf, &look);
            lab.scroll.draw(layout.panel, buf, look, |lines| {
                panel::write_shot(lab, watch, lines);
            });
        }
    }
}
