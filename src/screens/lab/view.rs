//! How the lab looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Lab, Phase, panel};
use crate::screens::Context;
use crate::widgets::hit::{Given, draw_setup};
use crate::widgets::panel::draw_panel;

/// Columns of the panel of numbers, with its frame.
const PANEL: u16 = 30;

/// Where the parts of the lab are: the inside of the picture's frame and of the
/// panel's.
pub(super) struct Layout {
    pub(super) picture: Rect,
    pub(super) panel: Rect,
    frames: [Rect; 2],
}

/// Lays out the lab.
pub(super) fn layout(area: Rect) -> Layout {
    let panel_width = if area.width >= 110 { PANEL + 8 } else { PANEL };
    let panel_width = panel_width.min(area.width / 2);
    let picture = Rect {
        width: area.width - panel_width,
        ..area
    };
    let panel = Rect {
        x: picture.right(),
        width: panel_width,
        ..area
    };
    let inside = |frame: Rect| Rect {
        x: frame.x + 1,
        y: frame.y + 1,
        width: frame.width.saturating_sub(2),
        height: frame.height.saturating_sub(2),
    };
    Layout {
        picture: inside(picture),
        panel: inside(panel),
        frames: [picture, panel],
    }
}

/// Draws the lab.
pub(super) fn draw(lab: &Lab, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(area);
    let (title, side_title) = match &lab.phase {
        Phase::Aim => ("set up the hit".into(), "settings"),
        Phase::Predict(_) => ("where will they go?".into(), "say it first"),
        Phase::Watch(watch) => (
            format!("the hit, slowed {:.0}×", watch.clock().slowed()),
            "the shot",
        ),
    };
    draw_panel(buf, layout.frames[0], &title, look.charset, &look.theme);
    draw_panel(buf, layout.frames[1], side_title, look.charset, &look.theme);
    let collision = lab.setup.collision();
    match &lab.phase {
        Phase::Aim => {
            let given = Given {
                offset: true,
                angle: true,
            };
            draw_setup(layout.picture, buf, &look, &collision, given, None);
            panel::draw_settings(lab, layout.panel, buf, cx);
        }
        Phase::Predict(rays) => {
            let given = Given {
                offset: true,
                angle: true,
            };
            draw_setup(layout.picture, buf, &look, &collision, given, Some(rays));
            panel::draw_prediction(lab, rays, layout.panel, buf, cx);
        }
        Phase::Watch(watch) => {
            watch.draw(layout.picture, buf, &look);
            panel::draw_shot(lab, watch, layout.panel, buf, cx);
        }
    }
}
