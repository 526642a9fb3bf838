//! The picture of a hit at one moment.

use glam::DVec2;
use ratatui::buffer::Buffer;

use super::arrows::{Arrows, split};
use super::labels::Labels;
use super::layers::{Layer, Layers};
use super::mark::Mark;
use super::playback::Playback;
use super::stage::Stage;
use super::watch::Face;
use super::{angles, inset};
use crate::physics::{Bond, Frame, Outcome, Shot};
use crate::quiz::{Ray, Rays};
use crate::widgets::ink::{self, Pen, Sheet, Side};
use crate::widgets::{Look, Role};

/// A way this short, in radii of the disc, is none.
const STANDS: f64 = 1e-6;

/// What a moment of a hit is drawn from.
pub(super) struct Moment<'a> {
    pub(super) stage: Stage,
    pub(super) outcome: &'a Outcome,
    pub(super) shot: Option<&'a Shot>,
    pub(super) clock: &'a Playback,
    pub(super) contact: f64,
    pub(super) frame: Frame,
    pub(super) layers: Layers,
    pub(super) said: Option<&'a Rays>,
    pub(super) mark: Option<Mark>,
    pub(super) faces: [Face; 2],
}

impl Moment<'_> {
    /// Velocity of the frame it is seen from.
    fn drift(&self) -> DVec2 {
        self.frame.velocity(&self.stage.collision)
    }

    /// Where a disc is at a time of the shot, as seen from the frame.
    fn place(&self, body: usize, time: f64) -> DVec2 {
        let position = match self.shot {
            Some(shot) => shot.at(body, time).position,
            // Two that move alike never make a shot; each goes its way.
            None => {
                let (p1, p2) = self.stage.collision.positions_before(self.contact - time);
                [p1, p2][body]
            }
        };
        position - self.drift() * (time - self.contact)
    }

    /// A disc where it is now. Once it has left the contact and stands, it is an outline,
    /// so that it hides nothing of what explains its way.
    fn disc(&self, sheet: &mut Sheet, body: usize, face: Face, now: DVec2) {
        let radius = self.stage.radius(body);
        let gone = now - self.stage.centres[body];
        let has_left = self.clock.has_met() && gone.length() > STANDS * radius;
        match gone.try_normalize() {
            // Its arrow runs through its middle, so the letter stands beside it, on the side
            // further from the line of its old motion.
            Some(way) if has_left && !self.clock.is_running() => {
                let off = self.stage.heading().perp();
                let away = way.perp().dot(off) * way.dot(off);
                let beside = way.perp() * 1.0_f64.copysign(away);
                let letter = (face.letter, now + 0.55 * radius * beside);
                sheet.ring(now, radius, face.role, letter);
            }
            _ => sheet.disc(now, radius, face.role, face.letter),
        }
    }

    /// Whether they go on as one.
    fn sticks(&self) -> bool {
        self.stage.collision.bond == Bond::Stick && self.outcome.hit()
    }

    /// Velocities after the contact as arrows show them, at a time of the shot. A pair
    /// that sticks shows that of its centre of mass; seen from there, how its discs go
    /// round.
    fn after(&self, time: f64) -> [DVec2; 2] {
        let shared = [self.outcome.v1, self.outcome.v2];
        if self.sticks() && self.frame == Frame::CentreOfMass {
            let turned = -self.outcome.spin * (time - self.contact).max(0.0);
            let turned = DVec2::from_angle(turned);
            let centres = self.stage.collision.centres_after();
            return [0, 1].map(|body| turned.rotate(centres[body] - shared[body]));
        }
        shared.map(|v| v - self.drift())
    }

    /// A pen for the geometry of the contact: over the discs while they are there,
    /// behind them once they have left.
    fn pen(&self, role: Role) -> Pen {
        if self.clock.at_contact() {
            Pen::new(role)
        } else {
            Pen::new(role).on(ink::Layer::Trail)
        }
    }

    fn shows(&self, layer: Layer) -> bool {
        self.layers.shows(layer)
    }

    /// Whether the picture is of the split of u alone, with all its room for that.
    fn is_split_alone(&self) -> bool {
        self.shows(Layer::Split) && !self.shows(Layer::Velocities)
    }

    /// Draws it.
    pub(super) fn draw(&self, buf: &mut Buffer, look: &Look) {
        let mut sheet = Sheet::new(self.stage.view, look.charset);
        let mut labels = Labels::default();
        let time = self.clock.time();
        let met = self.clock.has_met();
        let now = [self.place(0, time), self.place(1, time)];
        if self.shows(Layer::Trails) {
            self.trails(&mut sheet, time);
        }
        for (body, face) in self.faces.into_iter().enumerate() {
            self.disc(&mut sheet, body, face, now[body]);
        }
        let collision = &self.stage.collision;
        let before = [collision.u1 - self.drift(), collision.u2 - self.drift()];
        let after = self.after(time);
        let normal = self.outcome.normal.filter(|_| self.is_split_alone());
        let arrows = match normal {
            Some(n) => Arrows::fit_split(&self.stage, before[0], n),
            None => Arrows::fit(&self.stage, before, after),
        };
        let beats = self.clock.beats();
        if let (Some(n), Some(t)) = (self.outcome.normal, self.outcome.tangent) {
            if beats >= 1 && self.shows(Layer::Lines) {
                self.lines(&mut sheet, &mut labels, n, t);
            }
            let telling = beats == 2 && self.clock.at_contact();
            if beats >= 2 && (telling || self.shows(Layer::Split)) {
                split(&mut sheet, &self.stage, &arrows, before[0], n, t);
                labels.split(&self.stage, &arrows, before[0], n, t);
                if !self.shows(Layer::Velocities) {
                    labels.whole(&self.stage, &arrows, before[0]);
                }
            }
        }
        if self.shows(Layer::Velocities) {
            let at = if met { self.stage.centres } else { now };
            self.incoming(&mut sheet, &mut labels, &arrows, before, at);
        }
        if let Some(mark) = self.mark
            && self.shows(Layer::Prediction)
            && self.frame == Frame::Laboratory
        {
            mark.draw(&mut sheet, &mut labels, &self.stage);
        }
        if met && beats >= 3 {
            if self.shows(Layer::Prediction) && self.frame == Frame::Laboratory {
                self.prediction(&mut sheet, &mut labels);
            }
            if self.shows(Layer::Velocities) {
                let turns = self.sticks() && self.frame == Frame::CentreOfMass;
                let at = if turns { now } else { self.stage.centres };
                self.outgoing(&mut sheet, &mut labels, &arrows, after, at);
            }
            if self.shows(Layer::Angles) && self.outcome.hit() {
                self.angles(&mut sheet, &mut labels, after);
            }
            // From the centre of mass the triangle is none: the two cancel.
            let flat = self.frame == Frame::CentreOfMass || !self.outcome.hit();
            if self.shows(Layer::Triangle) && !flat {
                self.triangle(&mut sheet, before, after);
            }
        }
        if met && self.outcome.hit() {
            sheet.reserve(DVec2::ZERO);
        }
        labels.write(&mut sheet);
        sheet.draw(buf, &look.theme);
    }

    /// Where the discs came from and, after the contact, have gone.
    fn trails(&self, sheet: &mut Sheet, time: f64) {
        for body in 0..2 {
            let until = time.min(self.contact);
            let old = Pen::new(Role::Trail).dotted().aged(0.6);
            sheet.line(self.place(body, 0.0), self.place(body, until), old);
            if time <= self.contact {
                continue;
            }
            let fresh = Pen::new(Role::Trail);
            // A pair that sticks turns, so its trail is a curve.
            let pieces = if self.sticks() { 48 } else { 1 };
            let point = |i: usize| {
                let share = i as f64 / f64::from(pieces);
                self.place(body, self.contact + share * (time - self.contact))
            };
            sheet.polyline((0..=pieces as usize).map(point), fresh);
            let ghost = Pen::new(Role::Trail).dotted();
            sheet.circle(self.stage.centres[body], self.stage.radius(body), ghost);
        }
    }

    /// Line of impact and tangent.
    fn lines(&self, sheet: &mut Sheet, labels: &mut Labels, n: DVec2, t: DVec2) {
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
                sheet.line(rim, end, pen);
            }
        } else {
            sheet.line(ends[0], ends[1], pen);
        }
        let top = 1.7 * unit * t;
        sheet.line(-top, top, self.pen(Role::TangentLine).dotted());
        labels.add("n", ends[0], Side::towards(-n), Role::LineOfImpact);
        labels.add("t", top, Side::towards(t), Role::TangentLine);
    }

    fn incoming(
        &self,
        sheet: &mut Sheet,
        labels: &mut Labels,
        arrows: &Arrows,
        before: [DVec2; 2],
        at: [DVec2; 2],
    ) {
        let names = if self.stage.collision.u2 == DVec2::ZERO && self.frame == Frame::Laboratory {
            ["u", "u₂"]
        } else {
            ["u₁", "u₂"]
        };
        for body in 0..2 {
            let radius = self.stage.radius(body);
            let v = before[body];
            if arrows.inwards(sheet, at[body], radius, v, Role::Incoming) {
                labels.incoming(&self.stage, names[body], at[body], radius, v);
            }
        }
    }

    fn outgoing(
        &self,
        sheet: &mut Sheet,
        labels: &mut Labels,
        arrows: &Arrows,
        after: [DVec2; 2],
        at: [DVec2; 2],
    ) {
        if self.sticks() && self.frame != Frame::CentreOfMass {
            return self.common_velocity(sheet, labels, arrows, after[0], at);
        }
        // As chapter 11 names them.
        let names = match self.frame {
            Frame::CentreOfMass => ["w₁", "w₂"],
            _ => ["v₁", "v₂"],
        };
        let bodies = names.into_iter().zip([Role::StrikerOut, Role::CoinOut]);
        for (body, (name, role)) in bodies.enumerate() {
            let radius = self.stage.radius(body);
            let tip = arrows.outwards(sheet, &self.stage, at[body], radius, after[body], role);
            labels.outgoing(name, tip, at[body], radius, after[body], role);
        }
    }

    /// The one velocity of a pair that sticks, from its centre of mass.
    fn common_velocity(
        &self,
        sheet: &mut Sheet,
        labels: &mut Labels,
        arrows: &Arrows,
        velocity: DVec2,
        at: [DVec2; 2],
    ) {
        if arrows.is_still(velocity) {
            return;
        }
        let collision = &self.stage.collision;
        let (m1, m2) = (collision.striker.mass, collision.target.mass);
        let centre = (m1 * at[0] + m2 * at[1]) / (m1 + m2);
        let role = Role::StrikerOut;
        let tip = arrows.outwards(sheet, &self.stage, centre, 0.0, velocity, role);
        labels.outgoing("V", tip, centre, self.stage.unit(), velocity, role);
    }

    fn angles(&self, sheet: &mut Sheet, labels: &mut Labels, after: [DVec2; 2]) {
        if self.frame == Frame::Laboratory {
            for (body, v) in after.into_iter().enumerate() {
                if let Some(middle) = angles::arc(sheet, &self.stage, body, v, self.pen(Role::Arc))
                {
                    let turn = self.stage.heading().angle_to(v).to_degrees();
                    let outwards = middle - self.stage.centres[body];
                    labels.angle(turn.abs(), middle, outwards);
                }
            }
            if self.stage.collision.u2 == DVec2::ZERO {
                let pen = self.pen(Role::SquareCorner);
                angles::square_corner(sheet, &self.stage, after[0], after[1], pen);
            }
        }
    }

    fn prediction(&self, sheet: &mut Sheet, labels: &mut Labels) {
        let Some(said) = self.said else {
            return;
        };
        for (index, ray) in Ray::BOTH.into_iter().enumerate() {
            let Some(angle) = said.get(ray) else {
                continue;
            };
            let direction = self.stage.direction(ray, angle);
            let centre = self.stage.centres[index];
            let from = centre + self.stage.radius(index) * direction;
            let reach = self
                .stage
                .room(centre, direction)
                .min(2.9 * self.stage.unit());
            let to = centre + reach * direction;
            sheet.line(from, to, Pen::new(Role::Predicted).dashed());
            labels.add("you", to, Side::towards(direction), Role::Predicted);
        }
    }

    fn triangle(&self, sheet: &mut Sheet, before: [DVec2; 2], after: [DVec2; 2]) {
        let collision = &self.stage.collision;
        let p1 = collision.striker.mass * after[0];
        let p2 = collision.target.mass * after[1];
        let mut busy = vec![-before[0], -before[1], after[0], after[1]];
        if let Some(n) = self.outcome.normal {
            busy.extend([n, -n]);
        }
        inset::triangle(sheet, &self.stage, p1, p2, &busy);
    }
}
