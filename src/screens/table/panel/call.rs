//! The panel while the first impact is called.

use crate::quiz::Ray;
use crate::screens::table::active_game::Calling;
use crate::widgets::panel::written;
use crate::widgets::panels::{contact_distance, masses, offset};
use crate::widgets::{Lines, Role};

/// The hit, and both rays as said so far.
pub(super) fn draw(calling: &Calling, lines: &mut Lines) {
    let collision = &calling.hit.impact.collision;
    written(lines, |panel| {
        offset(collision, panel);
        // Not the impact angle: that is the coin's answer.
        contact_distance(collision, panel);
        masses(collision, [false; 2], panel);
        panel.gap();
        panel.heading("Where will they go?");
        calling.rays.write(panel, "coin");
    });
    lines.gap();
    lines.paragraph(&calling.rays.about("coin"), Role::Text);
    lines.gap();
    let next = match calling.rays.turning() {
        Ray::Striker => "Enter: then the coin.",
        Ray::Target => "Enter: strike!",
    };
    lines.paragraph(next, Role::Key);
}
