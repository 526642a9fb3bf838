//! The force of one contact against time.
//!
//! The rims are springs that are stiffer while they expand (1/e² times as stiff): the force rises
//! along a quarter of a sine wave and falls along another quarter, which lasts e times as long. The
//! area under the curve is J, and the average force is 2/π of the greatest, whatever e is.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

use glam::dvec2;

use super::FigureArea;
use crate::lessons::FigureKind;
use crate::numbers::significant;
use crate::physics::Collision;
use crate::physics::units::g_from_kg;
use crate::widgets::Role;
use crate::widgets::picture::{LabelSide, Pen, Picture};
use crate::widgets::plot::{Axis, Plot};

/// The force during a contact.
pub(super) struct ContactForce {
    /// J in N s.
    impulse: f64,
    restitution: f64,
    /// How long the contact lasts, in milliseconds.
    time_ms: f64,
}

impl ContactForce {
    pub(super) fn new(collision: &Collision, time_ms: f64) -> Self {
        Self {
            impulse: collision.outcome().impulse,
            restitution: collision.restitution,
            time_ms,
        }
    }

    /// The average force in newtons.
    pub(super) fn average(&self) -> f64 {
        1e3 * self.impulse / self.time_ms
    }

    /// The greatest force in newtons.
    pub(super) fn greatest(&self) -> f64 {
        self.average() / FRAC_2_PI
    }

    /// The force at a time in milliseconds, in newtons.
    fn at(&self, ms: f64) -> f64 {
        let compression = self.time_ms / (1.0 + self.restitution);
        let left = self.time_ms - compression;
        let phase = match ms {
            _ if !(0.0..=self.time_ms).contains(&ms) => return 0.0,
            ms if ms <= compression => ms / compression,
            ms => (self.time_ms - ms) / left,
        };
        self.greatest() * (phase * FRAC_PI_2).sin()
    }

    /// The impulse, the time and the greatest force.
    fn words(&self) -> [String; 2] {
        let [grams, newtons] = [g_from_kg(self.impulse), self.impulse].map(significant);
        let [time, greatest] = [self.time_ms, self.greatest()].map(significant);
        [
            format!("J = {grams} g m/s = {newtons} N s"),
            format!("Contact: {time} ms, at most {greatest} N"),
        ]
    }

    /// The plot; while the outcome is hidden, without the average force and the text below.
    pub(super) fn lay_out(&self, figure: FigureArea) -> Picture {
        let (hidden, look) = (figure.hidden, *figure.look);
        let (area, mut lines) = figure.split(2);
        let (shortest, longest) = FigureKind::CONTACT_MS;
        let shortest = Self {
            time_ms: shortest,
            ..*self
        };
        let most = 1.05 * shortest.greatest();
        let time = Axis::linear("time (ms)", 0.0, longest).every(0.3);
        let force = Axis::linear("force (N)", 0.0, most.max(1.0));
        let mut plot = Plot::new(area, look, time, force);
        let columns = u32::from(plot.paper().width.max(2)) - 1;
        let at = |columns_in: f64| longest * columns_in / f64::from(columns);
        for column in 1..columns {
            // The bar in a column shows the force at the middle of that column.
            let [from, middle, to] = [-0.5, 0.0, 0.5].map(|by| at(f64::from(column) + by));
            let force = self.at(middle);
            if force > plot.least_clear() {
                plot.bar(from, to, force, Role::Trail);
            }
        }
        let force = |ms| (ms <= self.time_ms).then(|| self.at(ms));
        plot.function(force, Pen::new(Role::CoinOut));
        if !hidden {
            let average = self.average();
            let corners = [(0.0, average), (self.time_ms, average), (self.time_ms, 0.0)];
            let corners = corners.map(|(ms, force)| dvec2(ms, force));
            plot.curve(corners, Pen::new(Role::Aim).dotted());
            let end = dvec2(self.time_ms, average);
            let sides = [LabelSide::Right, LabelSide::AboveRight, LabelSide::Above];
            let text = format!("F = {} N", significant(average));
            plot.label(&text, end, &sides, Role::Text);
            for line in self.words() {
                lines.line(&line, Role::Text);
            }
        }
        plot.picture()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::CollisionSpec;

    #[test]
    fn the_area_is_the_impulse_whatever_the_duration_and_the_restitution() {
        for restitution in [0.0, 0.3, 0.8, 1.0] {
            let collision = CollisionSpec {
                restitution,
                ..CollisionSpec::default()
            };
            for time_ms in [0.3, 0.7, 1.5] {
                let force = ContactForce::new(&collision.collision(), time_ms);
                let pieces = 20_000;
                let width = time_ms / f64::from(pieces);
                let middle = |i| force.at((f64::from(i) + 0.5) * width);
                let area: f64 = (0..pieces).map(middle).sum::<f64>() * width / 1e3;
                assert!((area / force.impulse - 1.0).abs() < 1e-6, "{area}");
                let highest = (0..pieces).map(middle).fold(0.0, f64::max);
                assert!((highest / force.greatest() - 1.0).abs() < 1e-3);
            }
        }
    }
}
