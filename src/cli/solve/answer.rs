//! The answers, one JSON object per line.

use std::borrow::Cow;

use glam::DVec2;
use serde::Serialize;

use super::problem::Solvable;
use crate::physics::Bond;
use crate::physics::units::deg_from_rad;

/// Undefined values are `null`. Numbers have enough digits to be read back exactly. `docs/solve.md`
/// describes every field; scripts rely on the names and the signs.
#[derive(Debug, Clone, Serialize)]
pub(super) struct SolveAnswer {
    hit: bool,
    v1: [f64; 2],
    v2: [f64; 2],
    speed1: f64,
    speed2: f64,
    /// Positive anticlockwise.
    theta1_deg: Option<f64>,
    /// Positive clockwise.
    theta2_deg: Option<f64>,
    separation_deg: Option<f64>,
    energy_before_j: f64,
    /// Includes the rotational energy.
    energy_after_j: f64,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    turning: Option<Turning>,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    rims: Option<RimAnswer>,
    assumed: Vec<Cow<'static, str>>,
}

/// Additional values for discs that stick together.
#[derive(Debug, Clone, Copy, Serialize)]
struct Turning {
    energy_rotation_j: f64,
    /// Positive clockwise, although the axes require anticlockwise: kept because scripts read it.
    spin_rad_s: f64,
    /// Positive anticlockwise, as the axes require.
    spin_ccw_rad_s: f64,
    /// The velocities of the two centres right after the contact. `v1` and `v2` are the velocity of
    /// the centre of mass.
    centre_v1: [f64; 2],
    centre_v2: [f64; 2],
}

/// Additional values for rims with friction or discs that spin.
#[derive(Debug, Clone, Copy, Serialize)]
struct RimAnswer {
    energy_rotation_j: f64,
    /// Positive anticlockwise.
    spin1_ccw_rad_s: f64,
    spin2_ccw_rad_s: f64,
    /// The impulse on the target along the line of impact.
    normal_impulse_n_s: f64,
    /// The impulse on the target along t, which is n turned by 90° anticlockwise.
    friction_impulse_n_s: f64,
    /// The angle from n to the change of the target's velocity, positive anticlockwise.
    throw_deg: Option<f64>,
}

impl SolveAnswer {
    pub(super) fn of(solvable: Solvable) -> Self {
        let collision = &solvable.collision;
        let after = collision.outcome();
        let [centre_v1, centre_v2] = collision.centres_after().map(components);
        Self {
            hit: after.hit(),
            v1: components(after.v1),
            v2: components(after.v2),
            speed1: after.v1.length(),
            speed2: after.v2.length(),
            theta1_deg: after.theta1.map(deg_from_rad),
            theta2_deg: after.theta2.map(deg_from_rad),
            separation_deg: after.separation.map(deg_from_rad),
            energy_before_j: after.energy_before,
            energy_after_j: after.energy_after,
            turning: (collision.bond == Bond::Stick).then_some(Turning {
                energy_rotation_j: after.energy_rotation,
                spin_rad_s: after.spin,
                // This turns −0 into 0.
                spin_ccw_rad_s: 0.0 - after.spin,
                centre_v1,
                centre_v2,
            }),
            rims: (!collision.rims.is_plain()).then(|| RimAnswer {
                energy_rotation_j: after.energy_rotation,
                // This turns −0 into 0, here and below.
                spin1_ccw_rad_s: after.spins[0] + 0.0,
                spin2_ccw_rad_s: after.spins[1] + 0.0,
                normal_impulse_n_s: after.impulse,
                friction_impulse_n_s: after.friction_impulse + 0.0,
                throw_deg: collision.throw().map(|throw| deg_from_rad(throw) + 0.0),
            }),
            assumed: solvable.assumed,
        }
    }
}

/// The components, with −0 turned into 0.
fn components(v: DVec2) -> [f64; 2] {
    (v + DVec2::ZERO).to_array()
}
