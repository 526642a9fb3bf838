//! What the lab is set to: two discs, how they move, how far off-centre they meet.

use glam::DVec2;

use crate::physics::angle::unit_vector;
use crate::physics::{Bond, Collision, Disc};
use crate::quiz::Hit;

/// A named pair of discs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PiecePair {
    /// Its name.
    pub name: &'static str,
    /// Mass and radius of the striker, in g and mm.
    pub striker: (f64, f64),
    /// Mass and radius of the target, in g and mm.
    pub target: (f64, f64),
}

/// The pairs one key goes through.
pub(crate) const PIECE_SETS: [PiecePair; 3] = [
    PiecePair {
        name: "equal masses",
        striker: (15.0, 15.0),
        target: (15.0, 15.0),
    },
    PiecePair {
        name: "tournament set",
        striker: (15.0, 20.65),
        target: (5.5, 15.9),
    },
    PiecePair {
        name: "marbles",
        striker: (20.0, 12.4),
        target: (40.0, 15.6),
    },
];

/// The setting, in the units of the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setup {
    /// Impact parameter b in mm, positive when the coin lies to the right.
    pub offset_mm: f64,
    /// Direction of the striker in degrees from +x, anticlockwise.
    pub aim_deg: f64,
    /// Speed of the striker at contact in m/s.
    pub speed: f64,
    /// Restitution, 0 to 1.
    pub restitution: f64,
    /// Slip or stick.
    pub bond: Bond,
    /// Mass of the striker in g.
    pub m1_g: f64,
    /// Mass of the target in g.
    pub m2_g: f64,
    /// Radius of the striker in mm.
    pub r1_mm: f64,
    /// Radius of the target in mm.
    pub r2_mm: f64,
    /// Speed of the target before the contact in m/s.
    pub target_speed: f64,
    /// Direction of the target before the contact in degrees from +x.
    pub target_deg: f64,
}

impl Default for Setup {
    /// The worked shot: 15 g on 15 g at 4 m/s, half-way off-centre, α = 30°.
    fn default() -> Self {
        let mut setup = Self {
            offset_mm: 0.0,
            aim_deg: 0.0,
            speed: 4.0,
            restitution: 1.0,
            bond: Bond::Slip,
            m1_g: 0.0,
            m2_g: 0.0,
            r1_mm: 0.0,
            r2_mm: 0.0,
            target_speed: 0.0,
            target_deg: 90.0,
        };
        setup.put_out(&PIECE_SETS[0]);
        setup.offset_mm = setup.reach_mm() / 2.0;
        setup
    }
}

impl Setup {
    /// The setting that is this collision.
    pub fn of(collision: &Collision) -> Self {
        // What rounding left of whole millimetres and grams goes.
        let tidy = |x: f64| (x * 1e9).round() / 1e9;
        let degrees = |v: DVec2| tidy(v.to_angle().to_degrees());
        let moves = collision.u2 != DVec2::ZERO;
        Self {
            offset_mm: tidy(1000.0 * collision.offset),
            aim_deg: degrees(collision.u1),
            speed: tidy(collision.u1.length()),
            restitution: collision.restitution,
            bond: collision.bond,
            m1_g: tidy(1000.0 * collision.striker.mass),
            m2_g: tidy(1000.0 * collision.target.mass),
            r1_mm: tidy(1000.0 * collision.striker.radius),
            r2_mm: tidy(1000.0 * collision.target.radius),
            target_speed: tidy(collision.u2.length()),
            target_deg: if moves { degrees(collision.u2) } else { 90.0 },
        }
    }

    /// Distance of the centres at contact in mm.
    pub fn reach_mm(&self) -> f64 {
        self.r1_mm + self.r2_mm
    }

    /// The set these pieces are, if they are one.
    pub fn piece_set(&self) -> Option<usize> {
        let pieces = ((self.m1_g, self.r1_mm), (self.m2_g, self.r2_mm));
        PIECE_SETS
            .iter()
            .position(|set| (set.striker, set.target) == pieces)
    }

    /// Puts out the pieces of a set and keeps the ratio b/(r₁+r₂).
    pub fn put_out(&mut self, set: &PiecePair) {
        let reach = self.reach_mm();
        let ratio = if reach > 0.0 {
            self.offset_mm / reach
        } else {
            0.0
        };
        (self.m1_g, self.r1_mm) = set.striker;
        (self.m2_g, self.r2_mm) = set.target;
        self.offset_mm = ratio * self.reach_mm();
    }

    /// Puts out the set after the present one.
    pub fn next_set(&mut self) {
        let next = self.piece_set().map_or(0, |i| (i + 1) % PIECE_SETS.len());
        self.put_out(&PIECE_SETS[next]);
    }

    /// The question this poses, where the target is at rest and the discs slip.
    pub fn question(&self) -> Hit {
        Hit::from(&self.collision())
    }

    /// The collision this sets up.
    pub fn collision(&self) -> Collision {
        let striker = Disc::from_g_mm(self.m1_g, self.r1_mm);
        let target = Disc::from_g_mm(self.m2_g, self.r2_mm);
        Collision {
            u2: self.target_speed * unit_vector(self.target_deg),
            restitution: self.restitution,
            bond: self.bond,
            ..Collision::at_offset(
                striker,
                target,
                self.speed * unit_vector(self.aim_deg),
                self.offset_mm / 1000.0,
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_setting_is_the_worked_shot() {
        let outcome = Setup::default().collision().outcome();
        assert!((outcome.v1.length() - 2.0).abs() < 1e-12);
        assert!((outcome.v2.length() - 12.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn changing_pieces_keeps_the_shape_of_the_hit() {
        let mut setup = Setup::default();
        let alpha = setup.collision().alpha();
        for expected in [1, 2, 0] {
            setup.next_set();
            assert_eq!(setup.piece_set(), Some(expected));
            let now = setup.collision().alpha();
            assert!((now.unwrap() - alpha.unwrap()).abs() < 1e-12);
        }
    }
}
