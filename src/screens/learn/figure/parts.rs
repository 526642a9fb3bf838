//! The kinetic energy of two discs in two parts, before and after: that of the motion of their
//! centre of mass, which no collision changes, and that of their relative motion.

use std::iter::zip;

use glam::{DVec2, dvec2};

use super::FigureArea;
use crate::numbers::{short, significant};
use crate::physics::impact::kinetic_energy;
use crate::physics::{Bond, Collision};
use crate::widgets::Role;
use crate::widgets::picture::{LabelSide, Pen, Picture, View};

/// The left and right edges of each bar, in a picture 10 units wide.
const BARS: [(f64, f64); 2] = [(0.8, 4.4), (5.6, 9.2)];

/// The two parts of the kinetic energy, in millijoules.
pub(super) struct EnergyParts {
    pub(super) of_centre: f64,
    /// The energy of the relative motion before and after the collision.
    pub(super) relative: [f64; 2],
}

impl EnergyParts {
    pub(super) fn new(collision: &Collision) -> Self {
        let total = collision.striker.mass + collision.target.mass;
        let of_centre = kinetic_energy(total, collision.centre_of_mass_velocity());
        let outcome = collision.outcome();
        let relative = [outcome.energy_before, outcome.energy_after].map(|it| it - of_centre);
        Self {
            of_centre: 1e3 * of_centre,
            // Rounding must not turn a part that is lost completely into "−0.00".
            relative: relative.map(|it| (1e3 * it).max(0.0)),
        }
    }

    /// The two parts in words, and the energy that is lost in the collision.
    fn words(&self, collision: &Collision) -> [String; 3] {
        let [before, after] = self.relative.map(significant);
        let of_centre = significant(self.of_centre);
        let lost = significant(self.relative[0] - self.relative[1]);
        let contact = match collision.bond {
            Bond::Stick => "together".to_owned(),
            Bond::Slip => format!("e = {}", short(collision.restitution, 2)),
        };
        [
            format!("½MV² = {of_centre} mJ, before and after"),
            format!("relative: {before} mJ, then {after} mJ"),
            format!("{contact}: {lost} mJ lost"),
        ]
    }
}

/// The bars, with the lost energy as an outline; only the first bar while the outcome is hidden.
pub(super) fn lay_out(collision: &Collision, figure: FigureArea) -> Picture {
    let parts = EnergyParts::new(collision);
    let hidden = figure.hidden;
    let (area, mut lines) = figure.split(3);
    let all = (parts.of_centre + parts.relative[0]).max(1e-9);
    let view = View::stretch(area, dvec2(0.0, -0.12 * all), dvec2(10.0, 1.05 * all));
    let mut picture = Picture::new(view);
    let bars = zip(BARS, ["before", "after"]).zip(parts.relative);
    for (((left, right), name), relative) in bars.take(if hidden { 1 } else { 2 }) {
        let middle = 0.5 * (left + right);
        let mut part = |from: f64, size: f64, text: &str, role: Role| {
            if size > 0.01 * all {
                let [low, high] = [dvec2(left, from), dvec2(right, from + size)];
                picture.rectangle(low, high, Pen::new(role));
                // The label needs a row inside the bar.
                if size > 2.0 * view.per_row() {
                    let centre = dvec2(middle, from + 0.5 * size);
                    picture.label(text, centre, &[LabelSide::Over], role);
                }
            }
        };
        part(0.0, parts.of_centre, "½MV²", Role::Incoming);
        part(parts.of_centre, relative, "relative", Role::CoinOut);
        let top = parts.of_centre + relative;
        if all - top > 2.0 * view.per_row() {
            let [low, high] = [dvec2(left, top), dvec2(right, all)];
            picture.rectangle(low, high, Pen::new(Role::Warn).dotted());
            let centre = dvec2(middle, 0.5 * (top + all));
            picture.label("lost", centre, &[LabelSide::Over], Role::Warn);
        }
        picture.text(DVec2::new(middle, -0.06 * all), name, Role::Dim);
    }
    let words = match hidden {
        true => vec![format!("before: {} mJ in all", significant(all))],
        false => parts.words(collision).into(),
    };
    for line in words {
        lines.line(&line, Role::Text);
    }
    picture
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::CollisionSpec;

    /// A head-on collision multiplies the energy of the relative motion by e².
    #[test]
    fn only_the_relative_part_is_lost() {
        for restitution in [0.0, 0.5, 1.0] {
            let shot = CollisionSpec {
                m2_g: 40.0,
                restitution,
                target_speed: 1.0,
                target_deg: 180.0,
                ..CollisionSpec::default()
            };
            let parts = EnergyParts::new(&shot.collision().with_alpha(0.0));
            let [before, after] = parts.relative;
            assert!((after - restitution * restitution * before).abs() < 1e-9);
        }
    }
}
