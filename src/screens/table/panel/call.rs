//! The panel while the first impact is called.

use crate::quiz::Ray;
use crate::screens::table::active_game::Calling;
use crate::widgets::{Lines, Role};

/// The hit, and both rays as said so far.
pub(super) fn draw(calling: &Calling, lines: &mut Lines) {
    let collision = &calling.hit.impact.collision;
    let mm = collision.offset.abs() * 1000.0;
    lines.pair("offset b", &format!("{mm:.1} mm"), Role::Dim, Role::Text);
    if let Some(alpha) = collision.alpha() {
        let alpha = format!("{:.1}°", alpha.to_degrees().abs());
        lines.pair("impact angle", &alpha, Role::Dim, Role::Text);
    }
    for (name, disc) in [("striker", collision.striker), ("coin", collision.target)] {
        let mass = format!("{:.1} g", disc.mass * 1000.0);
        lines.pair(name, &mass, Role::Dim, Role::Text);
    }
    lines.gap();
    lines.line("Where will they go?", Role::Title);
    for (ray, name) in [(Ray::Striker, "striker"), (Ray::Target, "coin")] {
        let (mark, role) = if ray == calling.rays.turning() {
            (">", Role::Selected)
        } else {
            (" ", Role::Text)
        };
        lines.pair(
            &format!("{mark} {name}"),
            &calling.rays.shown(ray),
            role,
            role,
        );
    }
    lines.gap();
    let (about, next) = match calling.rays.turning() {
        Ray::Striker => (
            "The striker: degrees from its direction, to the side away from the coin.",
            "Enter: then the coin.",
        ),
        Ray::Target => (
            "The coin: degrees from the striker's direction, to the coin's own side.",
            "Enter: strike!",
        ),
    };
    lines.paragraph(about, Role::Text);
    lines.gap();
    lines.paragraph(next, Role::Key);
}
