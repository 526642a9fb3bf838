//! The picture of a hit at one moment.

use glam::DVec2;

use super::sketch::{ArrowScale, Sketch};
use super::{Face, HitLayout, Overlay, Watch};
use crate::numbers::significant;
use crate::physics::{Bond, Frame, units::g_from_kg};
use crate::quiz::Ray;
use crate::widgets::Role;
use crate::widgets::picture::{self, Pen, Picture};

/// A way this short, in radii of the disc, is none.
const STANDS: f64 = 1e-6;

/// What a moment of a hit is drawn from.
pub(super) struct Moment<'a> {
    pub(super) watch: &'a Watch,
    pub(super) stage: HitLayout,
}

impl Moment<'_> {
    /// Velocity of the frame it is seen from.
    fn drift(&self) -> DVec2 {
        self.watch.frame.velocity(&self.stage.collision)
    }

    /// Where a disc is at a time of the shot, as seen from the frame.
    fn place(&self, body: usize, time: f64) -> DVec2 {
        let position = match &self.watch.shot {
            Some(shot) => shot.at(body, time).position,
            // Two that move alike never make a shot; each goes its way.
            None => {
                let (p1, p2) = self
                    .stage
                    .collision
                    .positions_before(self.watch.clock.contact - time);
                [p1, p2][body]
            }
        };
        position - self.drift() * (time - self.watch.clock.contact)
    }

    /// A disc where it is now. Once it has left the contact and stands, it is an outline,
    /// so that it hides nothing of what explains its way.
    fn disc(&self, picture: &mut Picture, body: usize, face: Face, now: DVec2) {
        let radius = self.stage.radius(body);
        let gone = now - self.stage.centres[body];
        let has_left = self.watch.clock.has_met() && gone.length() > STANDS * radius;
        match gone.try_normalize() {
            // Its arrow runs through its middle, so the letter stands beside it, on the side
            // further from the line of its old motion.
            Some(way) if has_left && !self.watch.clock.is_running() => {
                let off = self.stage.heading().perp();
                let away = way.perp().dot(off) * way.dot(off);
                let beside = way.perp() * 1.0_f64.copysign(away);
                let letter = (face.letter, now + 0.55 * radius * beside);
                picture.ring(now, radius, face.role, letter);
            }
            _ => picture.disc(now, radius, face.role, face.letter),
        }
    }

    /// Whether they go on as one.
    fn sticks(&self) -> bool {
        self.stage.collision.bond == Bond::Stick && self.watch.outcome.hit()
    }

    /// Velocities after the contact as arrows show them, at a time of the shot. A pair
    /// that sticks shows that of its centre of mass; seen from there, how its discs go
    /// round.
    fn after(&self, time: f64) -> [DVec2; 2] {
        let shared = [self.watch.outcome.v1, self.watch.outcome.v2];
        if self.sticks() && self.watch.frame == Frame::CentreOfMass {
            let turned = -self.watch.outcome.spin * (time - self.watch.clock.contact).max(0.0);
            let turned = DVec2::from_angle(turned);
            let centres = self.stage.collision.centres_after();
            return [0, 1].map(|body| turned.rotate(centres[body] - shared[body]));
        }
        shared.map(|v| v - self.drift())
    }

    /// A pen for the geometry of the contact: over the discs while they are there,
    /// behind them once they have left.
    fn pen(&self, role: Role) -> Pen {
        if self.watch.clock.at_contact() {
            Pen::new(role)
        } else {
            Pen::new(role).on(picture::DrawLayer::Trail)
        }
    }

    fn shows(&self, layer: Overlay) -> bool {
        self.watch.layers.shows(layer)
    }

    /// Whether the picture is of the split of u alone, with all its room for that.
    fn is_split_alone(&self) -> bool {
        self.shows(Overlay::Split) && !self.shows(Overlay::Velocities)
    }

    /// All of it as it stands: ways, discs, and what the layers add.
    pub(super) fn picture(&self) -> Picture {
        let mut sketch = Sketch::new(self.stage);
        let time = self.watch.clock.time();
        let met = self.watch.clock.has_met();
        let now = [self.place(0, time), self.place(1, time)];
        if self.shows(Overlay::Trails) {
            self.trails(&mut sketch.picture, time);
        }
        for (body, face) in self.watch.faces.into_iter().enumerate() {
            self.disc(&mut sketch.picture, body, face, now[body]);
        }
        let collision = &self.stage.collision;
        let before = [collision.u1 - self.drift(), collision.u2 - self.drift()];
        let after = self.after(time);
        let beats = self.watch.clock.beats();
        let told = met && beats >= 3;
        let in_lab = self.watch.frame == Frame::Laboratory;
        // From the centre of mass the triangle is none: the two cancel.
        let flat = self.watch.frame == Frame::CentreOfMass || !self.watch.outcome.hit();
        if told && self.shows(Overlay::Triangle) && !flat {
            self.triangle(&mut sketch, before, after);
        }
        let normal = self.watch.outcome.normal.filter(|_| self.is_split_alone());
        let scale = match normal {
            Some(n) => ArrowScale::fit_split(&self.stage, before[0], n),
            None => ArrowScale::fit(&self.stage, before, after),
        };
        if let (Some(n), Some(t)) = (self.watch.outcome.normal, self.watch.outcome.tangent) {
            if beats >= 1 && self.shows(Overlay::Lines) {
                self.lines(&mut sketch, n, t);
            }
            let telling = beats == 2 && self.watch.clock.at_contact();
            if beats >= 2 && (telling || self.shows(Overlay::Split)) {
                sketch.split(&scale, before[0], n, t);
                if !self.shows(Overlay::Velocities) {
                    sketch.whole(&scale, before[0]);
                }
            }
        }
        if self.shows(Overlay::Velocities) {
            let at = if met { self.stage.centres } else { now };
            self.incoming(&mut sketch, &scale, before, at);
        }
        if let Some(wanted) = &self.watch.wanted
            && self.shows(Overlay::Prediction)
            && in_lab
        {
            sketch.wanted_way(wanted);
        }
        if told {
            if self.shows(Overlay::Prediction) && in_lab {
                self.prediction(&mut sketch);
            }
            if self.shows(Overlay::Velocities) {
                let turns = self.sticks() && self.watch.frame == Frame::CentreOfMass;
                let at = if turns { now } else { self.stage.centres };
                self.outgoing(&mut sketch, &scale, after, at);
            }
            if self.shows(Overlay::Angles) && self.watch.outcome.hit() && in_lab {
                for (body, v) in after.into_iter().enumerate() {
                    sketch.arc(body, v, self.pen(Role::Arc));
                }
                if collision.u2 == DVec2::ZERO {
                    sketch.square_corner(after[0], after[1], self.pen(Role::SquareCorner));
                }
            }
        }
        if met && self.watch.outcome.hit() {
            sketch.picture.reserve(DVec2::ZERO);
        }
        if self.watch.measured {
            self.measures(&mut sketch);
        }
        sketch.picture
    }

    /// The masses, and the angle to the line of impact.
    fn measures(&self, sketch: &mut Sketch) {
        let [c1, c2] = self.stage.centres;
        let apart = (c2 - c1).normalize_or(DVec2::X);
        let collision = &self.stage.collision;
        if let Some(alpha) = collision.alpha() {
            let end = c2 + 1.5 * self.stage.unit() * apart;
            let text = format!("α = {:.1}°", alpha.to_degrees().abs());
            sketch.label(text, end, apart, Role::LineOfImpact);
        }
        for (disc, out) in [(collision.striker, -apart), (collision.target, apart)] {
            let body = usize::from(out == apart);
            let rim = self.stage.centres[body] + disc.radius * out;
            let text = format!("{} g", significant(g_from_kg(disc.mass)));
            sketch.label(text, rim, out, Role::Text);
        }
    }

    /// Where the discs came from and, after the contact, have gone.
    fn trails(&self, picture: &mut Picture, time: f64) {
        let contact = self.watch.clock.contact;
        for body in 0..2 {
            let until = time.min(contact);
            let old = Pen::new(Role::Trail).dotted().aged(0.6);
            picture.line(self.place(body, 0.0), self.place(body, until), old);
            if time <= contact {
                continue;
            }
            let fresh = Pen::new(Role::Trail);
            // A pair that sticks turns, so its trail is a curve.
            let pieces = if self.sticks() { 48 } else { 1 };
            let point = |i: usize| {
                let share = i as f64 / f64::from(pieces);
                self.place(body, contact + share * (time - contact))
            };
            picture.curve((0..=pieces as usize).map(point), fresh);
            let ghost = Pen::new(Role::Trail).dotted();
            picture.circle(self.stage.centres[body], self.stage.radius(body), ghost);
        }
    }

    /// Line of impact and tangent.
    fn lines(&self, sketch: &mut Sketch, n: DVec2, t: DVec2) {
        let unit = self.stage.unit();
        let ends = [
            self.stage.centres[0] - 1.5 * unit * n,
            self.stage.centres[1] + 1.5 * unit * n,
        ];
        let pen = self.pen(Role::LineOfImpact).dashed();
        if self.is_split_alone() {
            // Within the discs there are arrows to be read.
            for (body, end) in ends.into_iter().enumerate() {
                let centre = self.stage.centres[body];
                let rim = centre + self.stage.radius(body) * (end - centre).normalize_or_zero();
                sketch.picture.line(rim, end, pen);
            }
        } else {
            sketch.picture.line(ends[0], ends[1], pen);
        }
        let top = 1.7 * unit * t;
        let pen = self.pen(Role::TangentLine).dotted();
        sketch.picture.line(-top, top, pen);
        sketch.label("n", ends[0], -n, Role::LineOfImpact);
        sketch.label("t", top, t, Role::TangentLine);
    }

    fn incoming(
        &self,
        sketch: &mut Sketch,
        scale: &ArrowScale,
        before: [DVec2; 2],
        at: [DVec2; 2],
    ) {
        let stands = self.stage.collision.u2 == DVec2::ZERO;
        let names = match self.watch.frame {
            Frame::Laboratory if stands => ["u", "u₂"],
            _ => ["u₁", "u₂"],
        };
        for body in 0..2 {
            let disc = (at[body], self.stage.radius(body));
            sketch.incoming(scale, names[body], disc, before[body]);
        }
    }

    fn outgoing(&self, sketch: &mut Sketch, scale: &ArrowScale, after: [DVec2; 2], at: [DVec2; 2]) {
        if self.sticks() && self.watch.frame != Frame::CentreOfMass {
            // The one velocity of a pair that sticks, from its centre of mass.
            if !scale.is_still(after[0]) {
                let collision = &self.stage.collision;
                let (m1, m2) = (collision.striker.mass, collision.target.mass);
                let centre = (m1 * at[0] + m2 * at[1]) / (m1 + m2);
                let disc = (centre, 0.0, self.stage.unit());
                sketch.outgoing(scale, "V", disc, after[0], Role::StrikerOut);
            }
            return;
        }
        // As chapter 11 names them.
        let names = match self.watch.frame {
            Frame::CentreOfMass => ["w₁", "w₂"],
            _ => ["v₁", "v₂"],
        };
        let bodies = names.into_iter().zip([Role::StrikerOut, Role::CoinOut]);
        for (body, (name, role)) in bodies.enumerate() {
            let radius = self.stage.radius(body);
            let disc = (at[body], radius, radius);
            sketch.outgoing(scale, name, disc, after[body], role);
        }
    }

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

    fn triangle(&self, sketch: &mut Sketch, before: [DVec2; 2], after: [DVec2; 2]) {
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
