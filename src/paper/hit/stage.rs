//! Where everything stands: in metres, with the point of contact at the origin.

use glam::DVec2;

use super::{After, Shown};
use crate::physics::{Bond, Collision, Outcome};

/// Radius of the larger disc on paper, in units of the picture: 8 mm.
const RADIUS: f64 = 30.0;
/// The longest arrow, in radii of the larger disc.
const LONGEST: f64 = 2.2;
/// A share of the greatest speed below which a disc counts as standing still.
const STILL: f64 = 1e-9;

/// What is drawn, and its geometry.
pub(super) struct Stage {
    pub(super) collision: Collision,
    pub(super) outcome: Outcome,
    pub(super) shown: Shown,
    /// The centres at contact, or where the two are nearest.
    pub(super) contact: [DVec2; 2],
    /// The centres some time before.
    pub(super) start: [DVec2; 2],
    /// Metres for each m/s of an arrow.
    per_speed: f64,
    fastest: f64,
}

impl Stage {
    pub(super) fn new(collision: &Collision, shown: &Shown) -> Self {
        let outcome = collision.outcome();
        let (c1, c2) = collision.placed_at_contact();
        let mut speeds = vec![collision.u1.length(), collision.u2.length()];
        let before = speeds.iter().copied().fold(0.0, f64::max);
        if shown.after == After::Departures {
            speeds.extend([outcome.v1.length(), outcome.v2.length()]);
        }
        let fastest = speeds.into_iter().fold(0.0, f64::max);
        let mut stage = Self {
            collision: *collision,
            outcome,
            shown: *shown,
            contact: [c1, c2],
            start: [c1, c2],
            per_speed: 0.0,
            fastest,
        };
        let longest = match shown.after {
            After::Departures => LONGEST,
            _ => 1.6,
        };
        if fastest > 0.0 && fastest.is_finite() {
            stage.per_speed = longest * stage.unit() / fastest;
        }
        if before > 0.0 && before.is_finite() {
            // The faster one is so far away that its arrow lies between its two places.
            let quicker = usize::from(collision.u2.length() > collision.u1.length());
            let arrow = stage.per_speed * before;
            let clear = match shown.after {
                After::Space => stage.protractor() + stage.radius(quicker),
                _ => 2.0 * stage.radius(quicker),
            };
            let (s1, s2) =
                collision.positions_before((clear + arrow + 0.5 * stage.unit()) / before);
            stage.start = [s1, s2];
        }
        stage
    }

    /// The same, with a striker that has just room for its arrow.
    pub(super) fn nearer(mut self) -> Self {
        self.start[0] += 1.1 * self.radius(0) * self.along();
        self
    }

    /// Units of the picture for each metre.
    pub(super) fn scale(&self) -> f64 {
        RADIUS / self.unit()
    }

    /// Radius of the larger disc: the picture's own unit of length.
    pub(super) fn unit(&self) -> f64 {
        self.radius(0).max(self.radius(1))
    }

    /// Radius of the striker (0) or the target (1).
    pub(super) fn radius(&self, body: usize) -> f64 {
        [self.collision.striker, self.collision.target][body].radius
    }

    /// Mass of the striker (0) or the target (1).
    pub(super) fn mass(&self, body: usize) -> f64 {
        [self.collision.striker, self.collision.target][body].mass
    }

    /// Velocity of the striker (0) or the target (1) before.
    pub(super) fn before(&self, body: usize) -> DVec2 {
        [self.collision.u1, self.collision.u2][body]
    }

    /// Velocity of the striker (0) or the target (1) after.
    pub(super) fn after(&self, body: usize) -> DVec2 {
        [self.outcome.v1, self.outcome.v2][body]
    }

    /// Direction of the striker as seen from the target, from which offset and impact
    /// angle are measured.
    pub(super) fn along(&self) -> DVec2 {
        let relative = self.collision.relative_velocity();
        relative.try_normalize().unwrap_or(DVec2::X)
    }

    /// Direction of the striker, from which θ₁ and θ₂ are measured; `None` if it rests.
    pub(super) fn heading(&self) -> Option<DVec2> {
        self.direction(self.collision.u1)
    }

    /// Radius of the protractor: round the target too.
    pub(super) fn protractor(&self) -> f64 {
        self.collision.contact_distance() + self.radius(1) + 0.45 * self.unit()
    }

    /// Whether there is an angle α and it is shown.
    pub(super) fn shows_angle(&self) -> bool {
        self.shown.angle && self.outcome.normal.is_some()
    }

    /// Whether the target moves.
    pub(super) fn both_move(&self) -> bool {
        self.direction(self.collision.u2).is_some()
    }

    /// Whether they go on as one.
    pub(super) fn as_one(&self) -> bool {
        self.collision.bond == Bond::Stick && self.outcome.impulse > 0.0
    }

    /// The direction of a velocity; `None` where it is nothing beside the others.
    pub(super) fn direction(&self, v: DVec2) -> Option<DVec2> {
        if v.length() <= STILL * self.fastest {
            return None;
        }
        v.try_normalize()
    }

    /// A velocity as an arrow, in metres.
    pub(super) fn arrow(&self, v: DVec2) -> DVec2 {
        self.per_speed * v
    }
}
