//! The record of a perfectly inelastic collision: two discs that meet and stick together.
//!
//! Sticking is not the same as e = 0. The pair becomes one body: its centre of mass keeps the
//! velocity V = (m₁u₁ + m₂u₂)/(m₁+m₂) and, after an off-centre contact, it rotates with ω = μ b w /
//! (½m₁r₁² + ½m₂r₂² + μ(r₁+r₂)²), where w is the relative speed, b the impact parameter and μ the
//! reduced mass: angular momentum about the centre of mass is conserved.

use glam::DVec2;

use super::super::capture::capture;
use super::super::slide::time_to_distance;
use super::{Board, Disc, Event, EventKind, Leg, Motion, Shot};

/// Two discs stuck together, rotating about their centre of mass without friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StuckPair {
    pub(super) time: f64,
    centre: DVec2,
    velocity: DVec2,
    /// Vectors from the centre of mass to the discs' centres at the contact.
    arms: [DVec2; 2],
    /// Angular velocity in rad/s, positive anticlockwise.
    omega: f64,
    pub(super) energy: f64,
}

impl StuckPair {
    /// The pair formed at `time` by two discs that touch.
    fn new(time: f64, discs: &[Disc; 2], at: &[Motion; 2]) -> Self {
        let [m1, m2] = discs.map(|disc| disc.mass);
        let total = m1 + m2;
        let apart = at[1].position - at[0].position;
        let closing = at[0].velocity - at[1].velocity;
        let velocity = (at[0].velocity * m1 + at[1].velocity * m2) / total;
        let speed = closing.length();
        let turning = capture(discs[0], discs[1], apart.perp_dot(closing) / speed, speed);
        Self {
            time,
            centre: (at[0].position * m1 + at[1].position * m2) / total,
            velocity,
            arms: [apart * (-m2 / total), apart * (m1 / total)],
            // The angular velocity in a capture is positive clockwise.
            omega: -turning.spin,
            energy: 0.5 * total * velocity.length_squared() + turning.rotation_energy,
        }
    }

    /// The motion of one disc's centre at a time after the contact.
    pub(super) fn at(&self, disc: usize, time: f64) -> Motion {
        let since = time - self.time;
        let arm = DVec2::from_angle(self.omega * since).rotate(self.arms[disc]);
        Motion::new(
            self.centre + self.velocity * since + arm,
            self.velocity + arm.perp() * self.omega,
        )
    }

    /// The path of a disc from the contact to `end` in chords of at most 3°, or in 100,000 longer
    /// chords if the pair rotates too far for that.
    pub(super) fn chords(&self, disc: usize, end: f64) -> impl Iterator<Item = Leg> + use<> {
        let pair = *self;
        let turned = (pair.omega * (end - pair.time)).abs();
        // A pair that is left spinning for hours still has a trail that can be drawn.
        let count = (turned / 3_f64.to_radians()).ceil().clamp(1.0, 100_000.0);
        let step = (end - pair.time) / count;
        let place = move |i: f64| pair.at(disc, pair.time + i * step).position;
        (0..count as u32)
            .map(f64::from)
            .map(move |i| Leg {
                start: pair.time + i * step,
                end: pair.time + (i + 1.0) * step,
                from: place(i),
                to: place(i + 1.0),
            })
            .filter(|leg| leg.end > leg.start && leg.from != leg.to)
    }
}

impl Shot {
    /// The record, `duration` seconds long, of two discs that slide on a frictionless open sheet
    /// and stick together when they meet. If the discs miss each other, this is the record of the
    /// miss. The numbers must be valid for a shot, and the duration finite.
    pub(in super::super) fn captured(
        board: &Board,
        discs: [Disc; 2],
        start: [Motion; 2],
        duration: f64,
    ) -> Self {
        let touching = discs[0].radius + discs[1].radius;
        let apart = start[1].position - start[0].position;
        let mut shot = Self::default();
        shot.begin(board, &discs, &start);
        shot.end(duration);
        let relative = start[1].velocity - start[0].velocity;
        let gap = (apart.length_squared() - touching * touching).max(0.0);
        let meeting = time_to_distance(apart, relative, touching, gap);
        if let Some(time) = meeting.filter(|&t| t <= duration) {
            let met = start.map(|Motion { position, velocity }| {
                Motion::new(position + velocity * time, velocity)
            });
            let pair = StuckPair::new(time, &discs, &met);
            let after = [pair.at(0, time), pair.at(1, time)];
            for (disc, motion) in after.into_iter().enumerate() {
                shot.push_leg(disc, time, motion, false);
            }
            shot.events.push(Event {
                time,
                kind: EventKind::Impact {
                    discs: [0, 1],
                    normal: (met[1].position - met[0].position).normalize(),
                    before: start.map(|motion| motion.velocity),
                    after: after.map(|motion| motion.velocity),
                },
            });
            shot.capture = Some(pair);
        }
        shot
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair(offset: f64) -> Shot {
        let discs = [Disc::from_g_mm(15.0, 20.0), Disc::from_g_mm(5.0, 16.0)];
        let striker = Motion {
            position: DVec2::new(-0.2, 0.0),
            velocity: DVec2::new(2.0, 0.0),
        };
        let target = Motion::at_rest(DVec2::new(0.0, -offset));
        Shot::captured(&Board::open(0.0), discs, [striker, target], 1.0)
    }

    fn moments(shot: &Shot, time: f64) -> (DVec2, DVec2) {
        let mut momentum = DVec2::ZERO;
        let mut weighted = DVec2::ZERO;
        for (i, disc) in shot.discs().iter().enumerate() {
            let now = shot.at(i, time);
            momentum += disc.mass * now.velocity;
            weighted += disc.mass * now.position;
        }
        (momentum, weighted)
    }

    #[test]
    fn the_centre_of_mass_moves_straight_on_and_the_discs_stay_together() {
        for offset in [0.0, 0.01, -0.03] {
            let shot = pair(offset);
            assert_eq!(shot.events().len(), 1);
            let contact = shot.events()[0].time;
            let (momentum, weighted) = moments(&shot, 0.0);
            for time in [contact, 0.3, 0.7, 1.0] {
                let (p, w) = moments(&shot, time);
                assert!(p.distance(momentum) < 1e-15);
                assert!(w.distance(weighted + momentum * time) < 1e-15);
                let apart = shot
                    .at(0, time)
                    .position
                    .distance(shot.at(1, time).position);
                assert!((apart - 0.036).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn an_off_centre_pair_rotates_as_angular_momentum_requires() {
        // μ = 3.75 g, b = 10 mm, w = 2 m/s; I = ½·15·20² + ½·5·16² + 3.75·36² g mm².
        let shot = pair(0.01);
        let omega = 3.75e-3 * 0.01 * 2.0 / ((3000.0 + 640.0 + 4860.0) * 1e-9);
        let time = shot.events()[0].time;
        let spin = shot.at(1, time).velocity - shot.at(0, time).velocity;
        assert!((spin.length() / 0.036 - omega).abs() < 1e-12);
        // The target is on the right, so the pair rotates clockwise.
        let arm = shot.at(1, time).position - shot.at(0, time).position;
        assert!(arm.perp_dot(spin) < 0.0);
        let centre = 0.5 * 0.020 * 1.5 * 1.5;
        let turning = 0.5 * 8500e-9 * omega * omega;
        assert!((shot.energy_after() - centre - turning).abs() < 1e-12);
        assert!(shot.energy_after() < shot.energy_before());
    }

    #[test]
    fn a_head_on_pair_does_not_rotate_and_a_miss_stays_a_miss() {
        let straight = pair(0.0);
        assert_eq!(straight.at(1, 1.0).velocity, DVec2::new(1.5, 0.0));
        let miss = pair(0.0361);
        assert!(miss.events().is_empty());
        assert_eq!(miss.at(0, 1.0).position, DVec2::new(1.8, 0.0));
    }

    #[test]
    fn the_trail_of_a_pair_is_unbroken() {
        let shot = pair(0.02);
        for disc in 0..2 {
            let mut at = shot.start(disc).position;
            for leg in shot.path(disc) {
                assert!(leg.from.distance(at) < 1e-12);
                at = leg.to;
            }
            assert!(at.distance(shot.at(disc, 1.0).position) < 1e-12);
        }
    }
}
