//! The facts of an impact, a row each: where the two meet, what they are, how they part, and why.

use crate::physics::units::{deg_from_rad, g_from_kg, mm_from_m};
use crate::physics::{Bond, Collision, Meeting};
use crate::widgets::{Lines, Role};

/// How far off-centre they meet.
pub(crate) fn offset(collision: &Collision, lines: &mut Lines) {
    let offset = mm_from_m(collision.offset.abs());
    lines.fact("offset b", &format!("{offset:.1} mm"));
}

/// How far apart their centres are when they touch.
pub(crate) fn contact_distance(collision: &Collision, lines: &mut Lines) {
    let apart = mm_from_m(collision.contact_distance());
    lines.fact("r₁ + r₂", &format!("{apart:.1} mm"));
}

/// The angle between the motion and the line of impact; nothing for a miss.
pub(crate) fn impact_angle(collision: &Collision, lines: &mut Lines) {
    if let Some(alpha) = collision.alpha() {
        let alpha = deg_from_rad(alpha.abs());
        lines.fact("impact angle", &format!("{alpha:.1}°"));
    }
}

/// The masses of the two, but for those that are `secret`, and e where energy is lost.
pub(crate) fn masses(collision: &Collision, secret: [bool; 2], lines: &mut Lines) {
    let discs = [collision.striker, collision.target];
    let [striker, target] = [0, 1].map(|body| match secret[body] {
        true => "?".into(),
        false => format!("{:.1}", g_from_kg(discs[body].mass)),
    });
    lines.fact("masses", &format!("{striker} on {target} g"));
    if collision.restitution < 1.0 {
        lines.fact("restitution e", &format!("{:.2}", collision.restitution));
    }
}

/// The angle between the two departures, if both move on apart.
pub(crate) fn separation(collision: &Collision, lines: &mut Lines) {
    let outcome = collision.outcome();
    let sticks = collision.bond == Bond::Stick && outcome.meeting == Meeting::Hit;
    let apart = outcome.separation.filter(|_| !sticks);
    let separation = apart.map_or("none".into(), |angle| {
        format!("{:.1}°", deg_from_rad(angle))
    });
    lines.fact("separation", &separation);
}

/// Why the two go where they go: a title, which may be empty, and a text.
pub(crate) fn reason((title, text): &(&str, String), lines: &mut Lines) {
    if !title.is_empty() {
        lines.paragraph(title, Role::Title);
    }
    lines.paragraph(text, Role::Text);
}
