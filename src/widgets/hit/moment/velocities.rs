//! Velocities before and after the collision, the deflections, and the triangle of momenta.

use glam::DVec2;

use super::Moment;
use crate::physics::Frame;
use crate::quiz::Ray;
use crate::widgets::Role;
use crate::widgets::hit::Overlay;
use crate::widgets::hit::sketch::{ArrowScale, Sketch};
use crate::widgets::picture::Pen;

impl Moment<'_> {
    /// Draws the prediction, the final velocities, and the deflections.
    pub(super) fn departures(&self, sketch: &mut Sketch, scale: &ArrowScale) {
        let (before, after, frame) = (self.before(), self.after(), self.watch.frame);
        if self.shows(Overlay::Prediction) && frame == Frame::Laboratory {
            self.prediction(sketch);
        }
        if self.shows(Overlay::Velocities) {
            self.outgoing(sketch, scale, after);
        }
        if !self.shows(Overlay::Angles) || !self.watch.outcome.hit() {
            return;
        }
        let pen = self.pen(Role::Arc);
        if frame == Frame::CentreOfMass {
            // In this frame both discs are deflected by the same angle, so one arc is enough. Two
            // discs that move on together have no such angle: they rotate or are at rest.
            if !self.sticks() {
                sketch.arc(0, [before[0], after[0]], "Θ = ", pen);
            }
            return;
        }
        for (body, v) in after.into_iter().enumerate() {
            if !scale.is_still(v) {
                sketch.arc(body, [before[0], v], "", pen);
            }
        }
        if before[1] == DVec2::ZERO {
            sketch.square_corner(after[0], after[1], self.pen(Role::SquareCorner));
        }
    }

    /// Draws the velocities before the collision.
    pub(super) fn incoming(&self, sketch: &mut Sketch, scale: &ArrowScale, at: [DVec2; 2]) {
        let (names, before) = (self.names().before, self.before());
        for body in 0..2 {
            sketch.incoming(scale, names[body], (body, at[body]), before[body]);
        }
    }

    fn outgoing(&self, sketch: &mut Sketch, scale: &ArrowScale, after: [DVec2; 2]) {
        let turns = self.sticks() && self.watch.frame == Frame::CentreOfMass;
        let at = match turns {
            true => self.now(),
            false => self.stage.centres,
        };
        if self.sticks() && !turns {
            // If the discs move on together, only the velocity of their centre of mass is drawn.
            if !scale.is_still(after[0]) {
                let collision = &self.stage.collision;
                let (m1, m2) = (collision.striker.mass, collision.target.mass);
                let centre = (m1 * at[0] + m2 * at[1]) / (m1 + m2);
                let disc = (centre, 0.0, self.stage.unit());
                sketch.outgoing(scale, "V", disc, after[0], Role::StrikerOut);
            }
            return;
        }
        let names = self.names().after;
        let bodies = names.into_iter().zip([Role::StrikerOut, Role::CoinOut]);
        for (body, (name, role)) in bodies.enumerate() {
            let radius = self.stage.radius(body);
            let disc = (at[body], radius, radius);
            sketch.outgoing(scale, name, disc, after[body], role);
        }
    }

    /// Draws the predicted rays.
    fn prediction(&self, sketch: &mut Sketch) {
        for ray in Ray::BOTH {
            if let Some(angle) = self.watch.said.and_then(|said| said.get(ray)) {
                let (direction, [from, to]) = self.stage.ray(ray, angle);
                let pen = Pen::new(Role::Predicted).dashed();
                sketch.picture.line(from, to, pen);
                sketch.label("you", to, direction, Role::Predicted);
            }
        }
    }

    /// Draws the triangle of momenta.
    pub(super) fn triangle(&self, sketch: &mut Sketch) {
        let (before, after) = (self.before(), self.after());
        let collision = &self.stage.collision;
        let p1 = collision.striker.mass * after[0];
        let p2 = collision.target.mass * after[1];
        let mut busy = vec![-before[0], -before[1], after[0], after[1]];
        if let Some(n) = self.watch.outcome.normal {
            busy.extend([n, -n]);
        }
        sketch.triangle(p1, p2, &busy);
    }
}
