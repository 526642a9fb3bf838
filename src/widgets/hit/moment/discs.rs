//! The two discs and their paths.

use glam::DVec2;

use super::Moment;
use crate::widgets::Role;
use crate::widgets::picture::{Pen, Picture};

/// The shortest path that counts as motion, in radii of the disc; also the smallest component along
/// t that does not count as zero, as a fraction of the velocity.
const STANDS: f64 = 1e-6;
/// The distance of a letter from the centre when it is moved aside, in radii of the disc.
const LETTER_ASIDE: f64 = 0.55;

impl Moment<'_> {
    /// Draws a disc at its current position. During the explanation, and while the playback stands
    /// still after the disc has left the contact, the disc hides nothing and its letter is moved
    /// aside.
    pub(super) fn disc(&self, picture: &mut Picture, body: usize, now: DVec2) {
        let face = self.watch.faces[body];
        let radius = self.stage.radius(body);
        let gone = now - self.stage.centres[body];
        let has_left = self.watch.clock.has_met() && gone.length() > STANDS * radius;
        let beside = match gone.try_normalize() {
            // The arrow runs through the disc's centre, so the letter is on the side away from the
            // original path.
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

    /// The side of a disc's centre on which its velocity components are usually not drawn.
    fn aside(&self, body: usize) -> Option<DVec2> {
        let tangent = self.watch.outcome.tangent?;
        if self.split_step().is_some() && !self.target_rests() {
            // The components are usually drawn on the side away from the contact.
            return (-self.stage.centres[body]).try_normalize();
        }
        let collision = &self.stage.collision;
        let own = self.before()[body];
        let sideways = match own.dot(tangent) {
            sideways if sideways.abs() > STANDS * own.length() => sideways,
            _ => collision.relative_velocity().dot(tangent),
        };
        Some(-tangent * 1.0_f64.copysign(sideways))
    }

    /// Draws the paths of the discs up to the current time.
    pub(super) fn trails(&self, picture: &mut Picture, time: f64) {
        let contact = self.watch.clock.contact;
        for body in 0..2 {
            let until = time.min(contact);
            let old = Pen::new(Role::Trail).dotted().aged(0.6);
            let (start, mut end) = (self.place(body, 0.0), self.place(body, until));
            if self.is_explaining() {
                // The arrows on the disc must stay readable.
                end -= (end - start).clamp_length_max(self.stage.radius(body));
            }
            picture.line(start, end, old);
            if time <= contact {
                continue;
            }
            let fresh = Pen::new(Role::Trail);
            // A pair that moves on together may also rotate, which curves its trails.
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
}
