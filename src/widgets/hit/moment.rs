//! The picture of a hit at one moment.

use glam::DVec2;

use super::beat::Beat;
use super::names::{VelocityNames, part_name};
use super::sketch::{ArrowScale, NamedVelocity, Sketch};
use super::{HitLayout, Overlay, Watch};
use crate::numbers::significant;
use crate::physics::{Bond, Frame, units::g_from_kg};
use crate::quiz::Ray;
use crate::widgets::Role;
use crate::widgets::picture::{self, Pen, Picture};

/// A way this short, in radii of the disc, is none.
const STANDS: f64 = 1e-6;
/// How far from the centre a letter stands that makes room, in radii of the disc.
const LETTER_ASIDE: f64 = 0.55;

/// The point where the rims touch.
const CONTACT: &str = "●";

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

    /// A disc where it is now. While the contact explains itself, and once it has left and
    /// stands, it is drawn so that it hides nothing, and its letter stands aside.
    fn disc(&self, picture: &mut Picture, body: usize, now: DVec2) {
        let face = self.watch.faces[body];
        let radius = self.stage.radius(body);
        let gone = now - self.stage.centres[body];
        let has_left = self.watch.clock.has_met() && gone.length() > STANDS * radius;
        let beside = match gone.try_normalize() {
            // Its arrow runs through its middle: on the side further from the line of its
            // old motion.
            Some(way) if has_left && !self.watch.clock.is_moving() => {
                let off = self.stage.heading().perp();
                let away = way.perp().dot(off) * way.dot(off);
                Some(way.perp() * 1.0_f64.copysign(away))
            }
            _ if self.is_explaining() => self.aside(body),
            _ => None,
        };
        match beside {
            Some(beside) => {
                let letter = (face.letter, now + LETTER_ASIDE * radius * beside);
                picture.ring(now, radius, face.role, letter);
            }
            None => picture.disc(now, radius, face.role, face.letter),
        }
    }

    /// Whether lines and arrows lie upon the discs at the contact.
    fn is_explaining(&self) -> bool {
        self.watch.clock.at_contact() && self.watch.beat() > Some(Beat::Contact)
    }

    /// The side of a disc's centre on which no part of its velocity lies.
    fn aside(&self, body: usize) -> Option<DVec2> {
        let tangent = self.watch.outcome.tangent?;
        let collision = &self.stage.collision;
        let own = [collision.u1, collision.u2][body] - self.drift();
        let past = collision.relative_velocity().dot(tangent);
        let sideways = own.dot(tangent);
        let sideways = if sideways.abs() > STANDS * own.length() {
            sideways
        } else {
            past
        };
        Some(-tangent * 1.0_f64.copysign(sideways))
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

    /// The step whose velocities are drawn from the centres of the discs, with all the room
    /// of the picture for that.
    fn inside(&self) -> Option<Beat> {
        let beat = self.watch.beat()?;
        match beat {
            Beat::Split | Beat::Coin | Beat::Striker => Some(beat),
            Beat::Whole if self.is_split_alone() => Some(Beat::Split),
            _ => None,
        }
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
        for (body, at) in now.into_iter().enumerate() {
            self.disc(&mut sketch.picture, body, at);
        }
        let collision = &self.stage.collision;
        let before = [collision.u1 - self.drift(), collision.u2 - self.drift()];
        let after = self.after(time);
        let (beat, inside) = (self.watch.beat(), self.inside());
        let told = beat == Some(Beat::Whole);
        let in_lab = self.watch.frame == Frame::Laboratory;
        // From the centre of mass the triangle is none: the two cancel.
        let flat = self.watch.frame == Frame::CentreOfMass || !self.watch.outcome.hit();
        if told && self.shows(Overlay::Triangle) && !flat {
            self.triangle(&mut sketch, before, after);
        }
        let outcome = &self.watch.outcome;
        let axes = outcome.normal.zip(outcome.tangent).map(|(n, t)| [n, t]);
        if let Some(axes @ [n, t]) = axes {
            if beat >= Some(Beat::Line) && (!told || self.shows(Overlay::Lines)) {
                self.lines(&mut sketch, inside.is_some(), n, t);
            }
            if let Some(beat) = inside {
                self.parts(&mut sketch, beat, [before, after], axes);
            }
        }
        if let Some(wanted) = &self.watch.wanted
            && self.shows(Overlay::Prediction)
            && in_lab
        {
            sketch.wanted_way(wanted);
        }
        let scale = ArrowScale::fit(&self.stage, before, after);
        if inside.is_none() && self.shows(Overlay::Velocities) {
            let at = if met { self.stage.centres } else { now };
            self.incoming(&mut sketch, &scale, before, at);
        }
        if told {
            if let Some(axes) = axes.filter(|_| inside.is_none() && self.shows(Overlay::Split)) {
                self.split_before(&mut sketch, &scale, 0, before[0], axes);
            }
            self.departures(&mut sketch, &scale, [before, after], now);
        }
        if met && self.watch.outcome.hit() {
            sketch.picture.reserve(DVec2::ZERO);
            if inside.is_none() && !told {
                sketch.picture.text(DVec2::ZERO, CONTACT, Role::Contact);
            }
        }
        if self.watch.measured {
            self.measures(&mut sketch);
        }
        sketch.picture
    }

    /// What was said, the velocities after the hit, and by how much they are turned.
    fn departures(
        &self,
        sketch: &mut Sketch,
        scale: &ArrowScale,
        [before, after]: [[DVec2; 2]; 2],
        now: [DVec2; 2],
    ) {
        let frame = self.watch.frame;
        if self.shows(Overlay::Prediction) && frame == Frame::Laboratory {
            self.prediction(sketch);
        }
        if self.shows(Overlay::Velocities) {
            let turns = self.sticks() && frame == Frame::CentreOfMass;
            let at = if turns { now } else { self.stage.centres };
            self.outgoing(sketch, scale, after, at);
        }
        if !self.shows(Overlay::Angles) || !self.watch.outcome.hit() {
            return;
        }
        let pen = self.pen(Role::Arc);
        if frame == Frame::CentreOfMass {
            // Both turn by the same angle, so one arc tells it.
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

    /// The velocities of a step, drawn from the centres of the discs.
    fn parts(
        &self,
        sketch: &mut Sketch,
        beat: Beat,
        [before, after]: [[DVec2; 2]; 2],
        axes: [DVec2; 2],
    ) {
        // One scale for all steps: an arrow is as long in one as in another.
        let parts = |body: usize, v: DVec2| {
            let along = axes.map(|axis| (body, v.dot(axis) * axis));
            along.into_iter().chain([(body, v)])
        };
        let all = (0..2).flat_map(|body| parts(body, before[body]).chain(parts(body, after[body])));
        let all: Vec<_> = all.collect();
        // Where both move, each has its share of the way between the centres.
        let along = (before[0] - before[1]).dot(axes[0]) * axes[0];
        let scale = ArrowScale::fit_inside(&self.stage, along, &all);
        match beat {
            Beat::Coin => {
                if before[1] == DVec2::ZERO {
                    let [along, _] = self.parts_before(0, before[0], axes);
                    sketch.centred_arrow(&scale, 0, &along);
                }
                self.split_after(sketch, &scale, 1, after[1], axes);
            }
            Beat::Striker => {
                self.split_after(sketch, &scale, 0, after[0], axes);
                sketch.centred_arrow(&scale, 1, &self.velocity_after(1, after[1]));
            }
            _ => {
                for (body, v) in before.into_iter().enumerate() {
                    self.split_before(sketch, &scale, body, v, axes);
                }
            }
        }
    }

    /// A velocity before the hit with its parts, if there is one.
    fn split_before(
        &self,
        sketch: &mut Sketch,
        scale: &ArrowScale,
        body: usize,
        v: DVec2,
        axes: [DVec2; 2],
    ) {
        if scale.is_still(v) {
            return;
        }
        let name = self.names().before[body].to_owned();
        let role = Role::Incoming;
        let parts = self.parts_before(body, v, axes);
        sketch.split(scale, body, NamedVelocity { name, v, role }, &parts);
    }

    /// A velocity after the hit with its parts, of which that along t is the old one.
    fn split_after(
        &self,
        sketch: &mut Sketch,
        scale: &ArrowScale,
        body: usize,
        v: DVec2,
        axes: [DVec2; 2],
    ) {
        let whole = self.velocity_after(body, v);
        let [mut along, across] = self.parts_before(body, v, axes);
        along.name = match scale.is_still(across.v) {
            true => whole.name.clone(),
            false => part_name(&whole.name, 'ₙ'),
        };
        sketch.split(scale, body, whole, &[along, across]);
    }

    /// A velocity after the hit.
    fn velocity_after(&self, body: usize, v: DVec2) -> NamedVelocity {
        NamedVelocity {
            name: self.names().after[body].to_owned(),
            v,
            role: [Role::StrikerOut, Role::CoinOut][body],
        }
    }

    /// The parts of a velocity along n and t, named as before the hit.
    fn parts_before(&self, body: usize, v: DVec2, axes: [DVec2; 2]) -> [NamedVelocity; 2] {
        let name = self.names().before[body];
        let part = |axis: DVec2, sign, role| NamedVelocity {
            name: part_name(name, sign),
            v: v.dot(axis) * axis,
            role,
        };
        [
            part(axes[0], 'ₙ', Role::NormalPart),
            part(axes[1], 'ₜ', Role::TangentPart),
        ]
    }

    fn names(&self) -> VelocityNames {
        VelocityNames::new(&self.stage.collision, self.watch.frame)
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
            let (start, mut end) = (self.place(body, 0.0), self.place(body, until));
            if self.is_explaining() {
                // Upon the disc there are arrows to be read.
                end -= (end - start).clamp_length_max(self.stage.radius(body));
            }
            picture.line(start, end, old);
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

    /// Line of impact and tangent, the first only `outside` of the discs.
    fn lines(&self, sketch: &mut Sketch, outside: bool, n: DVec2, t: DVec2) {
        let unit = self.stage.unit();
        let ends = [
            self.stage.centres[0] - 1.5 * unit * n,
            self.stage.centres[1] + 1.5 * unit * n,
        ];
        let pen = self.pen(Role::LineOfImpact).dashed();
        if outside {
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
        let names = self.names().before;
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
        let names = self.names().after;
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
