//! Every reported quantity, as a function of the fitted state.

use glam::DVec2;

use super::Given;
use super::fit::{Estimate, TracksFit};
use super::model::State;
use super::track::Leg::{self, After, Before};
use crate::numbers::fixed;
use crate::physics::impact::{Contact, kinetic_energy};
use crate::physics::units::{deg_from_rad, mm_from_m};

/// The unit of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unit {
    Seconds,
    Speed,
    Slowing,
    Length,
    Angle,
    Momentum,
    Energy,
    Percent,
    Number,
}

impl Unit {
    /// The sign after a number.
    pub(crate) const fn sign(self) -> &'static str {
        match self {
            Self::Seconds => "s",
            Self::Speed => "m/s",
            Self::Slowing => "m/s²",
            Self::Length => "mm",
            Self::Angle => "°",
            Self::Momentum => "g m/s",
            Self::Energy => "mJ",
            Self::Percent => "%",
            Self::Number => "",
        }
    }

    /// The unit as the ending of a quantity's name in JSON.
    pub(crate) const fn ending(self) -> &'static str {
        match self {
            Self::Seconds => "_s",
            Self::Speed => "_m_s",
            Self::Slowing => "_m_s2",
            Self::Length => "_mm",
            Self::Angle => "_deg",
            Self::Momentum => "_g_m_s",
            Self::Energy => "_mj",
            Self::Percent => "_percent",
            Self::Number => "",
        }
    }

    /// Converts a value from SI units to this unit.
    pub(crate) fn in_unit(self, value: f64) -> f64 {
        match self {
            Self::Length => mm_from_m(value),
            Self::Angle => deg_from_rad(value),
            Self::Momentum | Self::Energy => 1000.0 * value,
            Self::Percent => 100.0 * value,
            Self::Seconds | Self::Speed | Self::Slowing | Self::Number => value,
        }
    }
}

/// How the line of impact is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineFrom {
    /// From the centres at contact.
    Centres,
    /// From the change of the relative velocity, which is parallel to the line of impact if the
    /// rims are smooth.
    Impulse,
}

/// What is known besides the tracks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Known {
    /// Both masses in kilograms; 1 and 1 if they are only assumed to be equal.
    pub(crate) masses: [f64; 2],
    pub(crate) are_given: bool,
    pub(crate) line: LineFrom,
    /// The coefficient of restitution of the prediction.
    pub(crate) restitution: f64,
}

impl Known {
    pub(super) fn new(given: &Given, fit: &TracksFit) -> Self {
        let centres = fit.apart.is_some_and(|apart| apart.agrees);
        Self {
            masses: given.masses.unwrap_or([1.0, 1.0]),
            are_given: given.masses.is_some(),
            line: if centres {
                LineFrom::Centres
            } else {
                LineFrom::Impulse
            },
            restitution: given.restitution,
        }
    }
}

/// A condition for a quantity to be defined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Need {
    /// A body clearly moves before or after the contact.
    Moves(usize, Leg),
    /// The bodies clearly approach each other along the line of impact.
    Approach,
    /// The total momentum is clearly different from zero.
    Momentum,
    /// The line of impact comes from the centres.
    Radii,
    /// The masses are given.
    Masses,
    /// A body slows down in the model.
    Slows(usize),
}

/// A reported quantity.
pub(crate) struct Quantity {
    /// The name of the quantity in JSON, without the unit.
    pub(crate) id: &'static str,
    /// The name of the quantity in a table.
    pub(crate) name: &'static str,
    pub(crate) unit: Unit,
    pub(crate) needs: &'static [Need],
    pub(crate) of: fn(&State, &Known) -> Option<f64>,
}

const M1_BEFORE: Need = Need::Moves(0, Before);
const M1_AFTER: Need = Need::Moves(0, After);
const M2_AFTER: Need = Need::Moves(1, After);

macro_rules! quantity {
    ($id:literal, $name:literal, $unit:ident, [$($need:expr),*], $of:expr) => {
        Quantity { id: $id, name: $name, unit: Unit::$unit, needs: &[$($need),*], of: $of }
    };
}

/// All quantities, in the order of reporting.
pub(crate) static QUANTITIES: [Quantity; 46] = [
    quantity!("contact_time", "time of contact", Seconds, [], |s, _| Some(
        s.time()
    )),
    quantity!("u1_x", "u₁ along x", Speed, [], |s, _| Some(
        s.velocity(0, Before).x
    )),
    quantity!("u1_y", "u₁ along y", Speed, [], |s, _| Some(
        s.velocity(0, Before).y
    )),
    quantity!("u1", "speed u₁", Speed, [M1_BEFORE], |s, _| speed(
        s, 0, Before
    )),
    quantity!(
        "u1_direction",
        "direction of u₁",
        Angle,
        [M1_BEFORE],
        |s, _| direction(s, 0, Before)
    ),
    quantity!("u2_x", "u₂ along x", Speed, [], |s, _| Some(
        s.velocity(1, Before).x
    )),
    quantity!("u2_y", "u₂ along y", Speed, [], |s, _| Some(
        s.velocity(1, Before).y
    )),
    quantity!(
        "u2",
        "speed u₂",
        Speed,
        [Need::Moves(1, Before)],
        |s, _| speed(s, 1, Before)
    ),
    quantity!(
        "u2_direction",
        "direction of u₂",
        Angle,
        [Need::Moves(1, Before)],
        |s, _| { direction(s, 1, Before) }
    ),
    quantity!("v1_x", "v₁ along x", Speed, [], |s, _| Some(
        s.velocity(0, After).x
    )),
    quantity!("v1_y", "v₁ along y", Speed, [], |s, _| Some(
        s.velocity(0, After).y
    )),
    quantity!("v1", "speed v₁", Speed, [M1_AFTER], |s, _| speed(
        s, 0, After
    )),
    quantity!(
        "v1_direction",
        "direction of v₁",
        Angle,
        [M1_AFTER],
        |s, _| direction(s, 0, After)
    ),
    quantity!("v2_x", "v₂ along x", Speed, [], |s, _| Some(
        s.velocity(1, After).x
    )),
    quantity!("v2_y", "v₂ along y", Speed, [], |s, _| Some(
        s.velocity(1, After).y
    )),
    quantity!("v2", "speed v₂", Speed, [M2_AFTER], |s, _| speed(
        s, 1, After
    )),
    quantity!(
        "v2_direction",
        "direction of v₂",
        Angle,
        [M2_AFTER],
        |s, _| direction(s, 1, After)
    ),
    quantity!(
        "deceleration1",
        "deceleration of body 1",
        Slowing,
        [Need::Slows(0)],
        |s, _| { Some(s.slowing(0)) }
    ),
    quantity!(
        "deceleration2",
        "deceleration of body 2",
        Slowing,
        [Need::Slows(1)],
        |s, _| { Some(s.slowing(1)) }
    ),
    quantity!("line_of_impact", "line of impact n", Angle, [], |s, k| {
        Some(line(s, k).to_angle())
    }),
    quantity!(
        "offset",
        "impact parameter b",
        Length,
        [Need::Approach],
        |s, _| {
            let along = relative(s, Before).try_normalize()?;
            Some(-along.perp_dot(s.centre(1) - s.centre(0)))
        }
    ),
    quantity!(
        "alpha",
        "impact angle α",
        Angle,
        [Need::Approach],
        |s, k| { Some(-relative(s, Before).angle_to(line(s, k))) }
    ),
    quantity!(
        "restitution",
        "coefficient of restitution e",
        Number,
        [Need::Approach],
        restitution
    ),
    quantity!(
        "impulse_ratio",
        "tangential/normal impulse",
        Number,
        [Need::Radii],
        |s, k| {
            let (n, change) = (line(s, k), relative(s, Before) - relative(s, After));
            Some(change.dot(n.perp()) / change.dot(n))
        }
    ),
    quantity!(
        "mass_ratio",
        "m₁/m₂ from Δv₂/Δv₁",
        Number,
        [],
        |s, _| {
            let change = |body| s.velocity(body, After) - s.velocity(body, Before);
            let along = (change(1) - change(0)).normalize_or_zero();
            Some(-change(1).dot(along) / change(0).dot(along))
        }
    ),
    quantity!(
        "p_before_x",
        "momentum before along x",
        Momentum,
        [Need::Masses],
        |s, k| { Some(momentum(s, k, Before).x) }
    ),
    quantity!(
        "p_before_y",
        "momentum before along y",
        Momentum,
        [Need::Masses],
        |s, k| { Some(momentum(s, k, Before).y) }
    ),
    quantity!(
        "p_after_x",
        "momentum after along x",
        Momentum,
        [Need::Masses],
        |s, k| { Some(momentum(s, k, After).x) }
    ),
    quantity!(
        "p_after_y",
        "momentum after along y",
        Momentum,
        [Need::Masses],
        |s, k| { Some(momentum(s, k, After).y) }
    ),
    quantity!(
        "p_change_along",
        "momentum change parallel to p",
        Percent,
        [Need::Momentum],
        |s, k| { Some(changed(s, k)?.x) }
    ),
    quantity!(
        "p_change_across",
        "momentum change normal to p",
        Percent,
        [Need::Momentum],
        |s, k| { Some(changed(s, k)?.y) }
    ),
    quantity!(
        "energy_before",
        "kinetic energy before",
        Energy,
        [Need::Masses],
        |s, k| { Some(energy(s, k, Before)) }
    ),
    quantity!(
        "energy_after",
        "kinetic energy after",
        Energy,
        [Need::Masses],
        |s, k| { Some(energy(s, k, After)) }
    ),
    quantity!(
        "energy_kept",
        "kinetic energy kept",
        Percent,
        [Need::Approach],
        |s, k| { Some(energy(s, k, After) / energy(s, k, Before)) }
    ),
    quantity!(
        "theta1",
        "deflection θ₁",
        Angle,
        [M1_BEFORE, M1_AFTER],
        |s, _| { Some(s.velocity(0, Before).angle_to(s.velocity(0, After))) }
    ),
    quantity!(
        "theta2",
        "recoil angle θ₂",
        Angle,
        [M1_BEFORE, M2_AFTER],
        |s, _| { Some(-s.velocity(0, Before).angle_to(s.velocity(1, After))) }
    ),
    quantity!(
        "between",
        "angle between the paths",
        Angle,
        [M1_AFTER, M2_AFTER],
        |s, _| { Some(s.velocity(0, After).angle_to(s.velocity(1, After)).abs()) }
    ),
    quantity!(
        "predicted_v1_x",
        "predicted v₁ along x",
        Speed,
        [Need::Approach],
        |s, k| { Some(predicted(s, k)?[0].x) }
    ),
    quantity!(
        "predicted_v1_y",
        "predicted v₁ along y",
        Speed,
        [Need::Approach],
        |s, k| { Some(predicted(s, k)?[0].y) }
    ),
    quantity!(
        "predicted_v2_x",
        "predicted v₂ along x",
        Speed,
        [Need::Approach],
        |s, k| { Some(predicted(s, k)?[1].x) }
    ),
    quantity!(
        "predicted_v2_y",
        "predicted v₂ along y",
        Speed,
        [Need::Approach],
        |s, k| { Some(predicted(s, k)?[1].y) }
    ),
    quantity!(
        "residual_v1_x",
        "v₁ along x − predicted",
        Speed,
        [Need::Approach],
        |s, k| { Some(missed(s, k, 0)?.x) }
    ),
    quantity!(
        "residual_v1_y",
        "v₁ along y − predicted",
        Speed,
        [Need::Approach],
        |s, k| { Some(missed(s, k, 0)?.y) }
    ),
    quantity!(
        "residual_v2_x",
        "v₂ along x − predicted",
        Speed,
        [Need::Approach],
        |s, k| { Some(missed(s, k, 1)?.x) }
    ),
    quantity!(
        "residual_v2_y",
        "v₂ along y − predicted",
        Speed,
        [Need::Approach],
        |s, k| { Some(missed(s, k, 1)?.y) }
    ),
    quantity!(
        "centres_apart",
        "distance between the centres at contact",
        Length,
        [],
        |s, _| { Some(s.centre(0).distance(s.centre(1))) }
    ),
];

fn speed(state: &State, body: usize, leg: Leg) -> Option<f64> {
    Some(state.velocity(body, leg).length())
}

fn direction(state: &State, body: usize, leg: Leg) -> Option<f64> {
    Some(state.velocity(body, leg).to_angle())
}

/// The velocity of body 1 relative to body 2.
pub(super) fn relative(state: &State, leg: Leg) -> DVec2 {
    state.velocity(0, leg) - state.velocity(1, leg)
}

/// The line of impact: the unit vector from centre 1 to centre 2.
pub(crate) fn line(state: &State, known: &Known) -> DVec2 {
    match known.line {
        LineFrom::Centres => state.centre(1) - state.centre(0),
        LineFrom::Impulse => relative(state, Before) - relative(state, After),
    }
    .normalize_or_zero()
}

fn restitution(state: &State, known: &Known) -> Option<f64> {
    let n = line(state, known);
    Some(-relative(state, After).dot(n) / relative(state, Before).dot(n))
}

pub(super) fn momentum(state: &State, known: &Known, leg: Leg) -> DVec2 {
    let [m1, m2] = known.masses;
    m1 * state.velocity(0, leg) + m2 * state.velocity(1, leg)
}

/// The change of the total momentum, parallel and perpendicular to the momentum before, as a
/// fraction of the momentum before.
pub(super) fn changed(state: &State, known: &Known) -> Option<DVec2> {
    let [before, after] = [Before, After].map(|leg| momentum(state, known, leg));
    let along = before.try_normalize()?;
    let change = (after - before) / before.length();
    Some(DVec2::new(change.dot(along), change.dot(along.perp())))
}

fn energy(state: &State, known: &Known, leg: Leg) -> f64 {
    let of = |body: usize| kinetic_energy(known.masses[body], state.velocity(body, leg));
    of(0) + of(1)
}

/// The velocities after the contact that follow from those before it and the line of impact.
pub(crate) fn predicted(state: &State, known: &Known) -> Option<[DVec2; 2]> {
    let impact = Contact {
        m1: known.masses[0],
        m2: known.masses[1],
        u1: state.velocity(0, Before),
        u2: state.velocity(1, Before),
        normal: line(state, known),
        restitution: known.restitution,
    }
    .resolve()?;
    Some([impact.v1, impact.v2])
}

fn missed(state: &State, known: &Known, body: usize) -> Option<DVec2> {
    Some(state.velocity(body, After) - predicted(state, known)?[body])
}

/// A quantity of a measurement: its estimate, or why there is none.
pub(super) fn measured(
    quantity: &Quantity,
    fit: &TracksFit,
    known: &Known,
    names: [&str; 2],
) -> Result<Estimate, String> {
    for need in quantity.needs {
        if let Some(reason) = missing(*need, fit, known, names) {
            return Err(reason);
        }
    }
    let estimate = match quantity.unit {
        Unit::Angle => fit.estimate_angle(|state| (quantity.of)(state, known)),
        _ => fit.estimate(|state| (quantity.of)(state, known)),
    };
    estimate.ok_or_else(|| "not defined for this collision".into())
}

/// Why a condition is not met; `None` if it is met.
fn missing(need: Need, fit: &TracksFit, known: &Known, names: [&str; 2]) -> Option<String> {
    let (clear, reason) = match need {
        Need::Moves(body, leg) => {
            let speed = fit.estimate(|state| Some(state.velocity(body, leg).length()));
            let side = if leg == Before { "before" } else { "after" };
            let most = speed.map_or(f64::NAN, |it| it.value + it.uncertainty95());
            let reason = format!(
                "not defined: {} is at rest {side} the contact, or slower than {} m/s",
                names[body],
                fixed(most, 3)
            );
            (speed.is_some_and(|it| it.is_clear()), reason)
        }
        Need::Approach => {
            let along = |state: &State| Some(relative(state, Before).dot(line(state, known)));
            let reason = "not defined: the speed of approach along the line of impact is not \
                          clearly above zero";
            let speed = fit.estimate(along);
            (
                speed.is_some_and(|it| it.is_clear() && it.value > 0.0),
                reason.into(),
            )
        }
        Need::Momentum => {
            let total = fit.estimate(|state| Some(momentum(state, known, Before).length()));
            let reason = "not defined: the total momentum before the contact is not clearly \
                          different from zero";
            (total.is_some_and(|it| it.is_clear()), reason.into())
        }
        Need::Radii => {
            let reason = match fit.apart {
                None => "unknown without the radii",
                Some(_) => "unknown: the tracks contradict the radii",
            };
            (known.line == LineFrom::Centres, reason.into())
        }
        Need::Masses => (known.are_given, "unknown without the masses".into()),
        Need::Slows(body) => (fit.model.slows(body), "none found: straight lines".into()),
    };
    (!clear).then_some(reason)
}
