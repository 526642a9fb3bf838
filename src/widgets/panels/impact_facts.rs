//! The facts of an impact, one per row: the point of impact, the discs, the angle between the
//! paths, and the explanation.

use crate::numbers::{fixed, true_minus};
use crate::physics::Collision;
use crate::physics::units::{deg_from_rad, g_from_kg, mm_from_m};
use crate::widgets::Role;
use crate::widgets::panel::Panel;

/// Writes how far off-centre the collision is.
pub(crate) fn offset<A>(collision: &Collision, panel: &mut Panel<A>) {
    let offset = mm_from_m(collision.offset.abs());
    panel.fact("offset b", format!("{offset:.1} mm"));
}

/// Writes the distance between the centres at contact.
pub(crate) fn contact_distance<A>(collision: &Collision, panel: &mut Panel<A>) {
    let apart = mm_from_m(collision.contact_distance());
    panel.fact("r₁ + r₂", format!("{apart:.1} mm"));
}

/// Writes the angle between the relative velocity and the line of impact; writes nothing for a
/// miss.
pub(crate) fn impact_angle<A>(collision: &Collision, panel: &mut Panel<A>) {
    if let Some(alpha) = collision.alpha() {
        let alpha = deg_from_rad(alpha.abs());
        panel.fact("impact angle", format!("{alpha:.1}°"));
    }
}

/// Writes the masses, except `secret` masses, and e if it is less than 1.
pub(crate) fn masses<A>(collision: &Collision, secret: [bool; 2], panel: &mut Panel<A>) {
    let discs = [collision.striker, collision.target];
    let [striker, target] = [0, 1].map(|body| match secret[body] {
        true => "?".into(),
        false => format!("{:.1}", g_from_kg(discs[body].mass)),
    });
    panel.fact("masses", format!("{striker} on {target} g"));
    if collision.restitution < 1.0 {
        panel.fact("restitution e", format!("{:.2}", collision.restitution));
    }
}

/// Writes the angle between the paths, or "none" if there are not two paths.
pub(crate) fn separation<A>(collision: &Collision, panel: &mut Panel<A>) {
    let apart = collision.outcome().separation;
    let apart = apart.filter(|_| !collision.coalesces());
    let separation = apart.map_or("none".into(), |angle| {
        format!("{:.1}°", deg_from_rad(angle))
    });
    panel.fact("separation", separation);
}

/// Writes the throw, if there is one, and the spins before and after the collision; writes nothing
/// if the rims are smooth and no disc spins.
pub(crate) fn rim_facts<A>(collision: &Collision, panel: &mut Panel<A>) {
    if collision.rims.is_plain() {
        return;
    }
    let outcome = collision.outcome();
    if let Some(throw) = collision.throw() {
        let throw = deg_from_rad(throw.abs());
        panel.fact("throw δ", format!("{throw:.1}°"));
    }
    for (body, name) in ["ω₁ rad/s", "ω₂ rad/s"].into_iter().enumerate() {
        let [before, after] =
            [collision.rims.spins, outcome.spins].map(|spins| fixed(spins[body], 1));
        panel.fact(name, true_minus(&format!("{before} → {after}")));
    }
}

/// Writes the explanation of the directions: a title, which may be empty, and the text below it.
pub(crate) fn reason<A>((title, text): &(&str, String), panel: &mut Panel<A>) {
    if !title.is_empty() {
        panel.paragraph(*title, Role::Title);
    }
    panel.paragraph(text, Role::Text);
}
