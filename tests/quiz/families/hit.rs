//! A hit on a target at rest, calculated independently from the figures of a question: by an
//! impulse along the line of centres.

use carrom::quiz::{Question, Rays};
use glam::DVec2;

use super::owed::figure;

/// A hit and its outcome.
pub(crate) struct Hit {
    pub(crate) m1: f64,
    pub(crate) m2: f64,
    pub(crate) u: DVec2,
    pub(crate) v1: DVec2,
    pub(crate) v2: DVec2,
}

impl Hit {
    /// The hit that a question's figures define.
    pub(crate) fn of(question: &Question) -> Self {
        let sine = match question.figures.get("alpha_deg").and_then(|it| it.as_f64()) {
            Some(alpha_deg) => alpha_deg.to_radians().sin(),
            None => {
                figure(question, "offset_mm")
                    / (figure(question, "r1_mm") + figure(question, "r2_mm"))
            }
        };
        let direction = figure(question, "direction_deg").to_radians();
        let [m1, m2, e, speed] =
            ["m1_g", "m2_g", "restitution", "speed"].map(|name| figure(question, name));
        Self::new(m1, m2, e, speed * DVec2::from_angle(direction), sine)
    }

    /// A hit with this sine of the impact angle, positive for a target on the right.
    pub(crate) fn new(m1: f64, m2: f64, e: f64, u: DVec2, sine: f64) -> Self {
        let forward = u.normalize();
        let right = DVec2::new(forward.y, -forward.x);
        let normal = forward * (1.0 - sine * sine).sqrt() + right * sine;
        let impulse = (1.0 + e) * u.dot(normal) / (1.0 / m1 + 1.0 / m2);
        Self {
            m1,
            m2,
            u,
            v1: u - impulse / m1 * normal,
            v2: impulse / m2 * normal,
        }
    }

    /// The directions of both discs after the hit.
    pub(crate) fn rays(&self) -> Rays {
        Rays {
            striker: turn(self.u, self.v1),
            target: turn(self.v2, self.u),
        }
    }

    /// The angle between the paths, in degrees.
    pub(crate) fn separation_deg(&self) -> f64 {
        turn(self.v2, self.v1).unwrap().abs().to_degrees()
    }

    /// The shares of the original energy that the striker keeps and the target gets.
    pub(crate) fn energy_shares(&self) -> (f64, f64) {
        let before = self.m1 * self.u.length_squared();
        (
            self.m1 * self.v1.length_squared() / before,
            self.m2 * self.v2.length_squared() / before,
        )
    }
}

/// The angle from `a` to `b`, anticlockwise; `None` if either is at rest.
fn turn(a: DVec2, b: DVec2) -> Option<f64> {
    let moves = |v: DVec2| v.length() > 1e-9;
    (moves(a) && moves(b)).then(|| a.perp_dot(b).atan2(a.dot(b)))
}
