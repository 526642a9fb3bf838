//! Every reported quantity, as a function of the fitted state.

use std::sync::LazyLock;

use glam::DVec2;

use super::fit::{Estimate, TracksFit};
use super::model::State;
use super::track::Leg::{self, After, Before};
use super::{Given, Measurement};
use crate::numbers::fixed;
use crate::physics::impact::{Contact, kinetic_energy};
use crate::physics::units::{deg_from_rad, mm_from_m};

/// The unit of a quantity: the symbol after a number, the ending of a quantity's name in JSON, and
/// the factor from SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unit(&'static str, &'static str, f64);

pub(super) const SECONDS: Unit = Unit("s", "_s", 1.0);
pub(super) const SPEED: Unit = Unit("m/s", "_m_s", 1.0);
pub(super) const SLOWING: Unit = Unit("m/s²", "_m_s2", 1.0);
pub(super) const LENGTH: Unit = Unit("mm", "_mm", mm_from_m(1.0));
pub(super) const ANGLE: Unit = Unit("°", "_deg", deg_from_rad(1.0));
pub(super) const MOMENTUM: Unit = Unit("g m/s", "_g_m_s", 1000.0);
pub(super) const ENERGY: Unit = Unit("mJ", "_mj", 1000.0);
pub(super) const PERCENT: Unit = Unit("%", "_percent", 100.0);
pub(super) const NUMBER: Unit = Unit("", "", 1.0);

impl Unit {
    /// The unit symbol after a number.
    pub(crate) const fn sign(self) -> &'static str {
        self.0
    }

    /// The unit as the ending of a quantity's name in JSON.
    pub(crate) const fn ending(self) -> &'static str {
        self.1
    }

    /// Converts a value from SI units to this unit.
    pub(crate) fn in_unit(self, value: f64) -> f64 {
        value * self.2
    }

    /// A quantity with this unit.
    fn of(
        self,
        id: impl Into<String>,
        name: impl Into<String>,
        needs: &[Need],
        of: impl Fn(&State, &Known) -> Option<f64> + Send + Sync + 'static,
    ) -> Quantity {
        Quantity {
            id: id.into(),
            name: name.into(),
            unit: self,
            needs: needs.to_vec(),
            of: Box::new(of),
        }
    }

    /// Both components of a vector; their ids and names have x and y in place of the asterisk.
    fn components(
        self,
        id: &str,
        name: &str,
        needs: &[Need],
        of: impl Fn(&State, &Known) -> Option<DVec2> + Copy + Send + Sync + 'static,
    ) -> [Quantity; 2] {
        [("x", 0), ("y", 1)].map(|(axis, at)| {
            let [id, name] = [id, name].map(|it| it.replace('*', axis));
            self.of(id, name, needs, move |s, k| Some(of(s, k)?[at]))
        })
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
    /// The coefficient of restitution for the prediction.
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
    pub(crate) id: String,
    /// The name of the quantity in a table.
    pub(crate) name: String,
    pub(crate) unit: Unit,
    pub(crate) needs: Vec<Need>,
    pub(crate) of: Derivation,
}

/// Computes a quantity from the motion of both bodies and what is known of them; `None` if it is
/// undefined.
type Derivation = Box<dyn Fn(&State, &Known) -> Option<f64> + Send + Sync>;

/// All reported quantities.
pub(crate) static QUANTITIES: LazyLock<Vec<Quantity>> = LazyLock::new(|| {
    use Need::{Approach, Masses, Moves, Radii, Slows};
    let mut all = vec![SECONDS.of("contact_time", "time of contact", &[], |s, _| {
        Some(s.time())
    })];
    for (id, sign, body, leg) in [
        ("u1", "u₁", 0, Before),
        ("u2", "u₂", 1, Before),
        ("v1", "v₁", 0, After),
        ("v2", "v₂", 1, After),
    ] {
        let velocity = move |s: &State| s.velocity(body, leg);
        let (ids, names) = (format!("{id}_*"), format!("{sign} along *"));
        all.extend(SPEED.components(&ids, &names, &[], move |s, _| Some(velocity(s))));
        let (moves, name) = ([Moves(body, leg)], format!("speed {sign}"));
        all.push(SPEED.of(id, name, &moves, move |s, _| Some(velocity(s).length())));
        let (id, name) = (format!("{id}_direction"), format!("direction of {sign}"));
        all.push(ANGLE.of(id, name, &moves, move |s, _| Some(velocity(s).to_angle())));
    }
    for (id, name, body) in [
        ("deceleration1", "deceleration of body 1", 0),
        ("deceleration2", "deceleration of body 2", 1),
    ] {
        all.push(SLOWING.of(id, name, &[Slows(body)], move |s, _| Some(s.slowing(body))));
    }
    all.extend([
        ANGLE.of("line_of_impact", "line of impact n", &[], |s, k| {
            Some(line(s, k).to_angle())
        }),
        LENGTH.of("offset", "impact parameter b", &[Approach], |s, _| {
            let along = relative(s, Before).try_normalize()?;
            Some(-along.perp_dot(s.centre(1) - s.centre(0)))
        }),
        ANGLE.of("alpha", "impact angle α", &[Approach], |s, k| {
            Some(-relative(s, Before).angle_to(line(s, k)))
        }),
        NUMBER.of(
            "restitution",
            "coefficient of restitution e",
            &[Approach],
            |s, k| {
                let n = line(s, k);
                Some(-relative(s, After).dot(n) / relative(s, Before).dot(n))
            },
        ),
        NUMBER.of(
            "impulse_ratio",
            "tangential/normal impulse",
            &[Radii],
            |s, k| {
                let (n, change) = (line(s, k), relative(s, Before) - relative(s, After));
                Some(change.dot(n.perp()) / change.dot(n))
            },
        ),
        NUMBER.of("mass_ratio", "m₁/m₂ from Δv₂/Δv₁", &[], |s, _| {
            let change = |body| s.velocity(body, After) - s.velocity(body, Before);
            let along = (change(1) - change(0)).normalize_or_zero();
            Some(-change(1).dot(along) / change(0).dot(along))
        }),
    ]);
    for (ids, names, leg) in [
        ("p_before_*", "momentum before along *", Before),
        ("p_after_*", "momentum after along *", After),
    ] {
        let total = move |s: &State, k: &Known| Some(momentum(s, k, leg));
        all.extend(MOMENTUM.components(ids, names, &[Masses], total));
    }
    for (id, name, axis) in [
        ("p_change_along", "momentum change parallel to p", 0),
        ("p_change_across", "momentum change normal to p", 1),
    ] {
        let needs = [Need::Momentum];
        all.push(PERCENT.of(id, name, &needs, move |s, k| Some(changed(s, k)?[axis])));
    }
    for (id, name, leg) in [
        ("energy_before", "kinetic energy before", Before),
        ("energy_after", "kinetic energy after", After),
    ] {
        all.push(ENERGY.of(id, name, &[Masses], move |s, k| Some(energy(s, k, leg))));
    }
    let [u1, v1, v2] = [Moves(0, Before), Moves(0, After), Moves(1, After)];
    all.extend([
        PERCENT.of("energy_kept", "kinetic energy kept", &[Approach], |s, k| {
            Some(energy(s, k, After) / energy(s, k, Before))
        }),
        ANGLE.of("theta1", "deflection θ₁", &[u1, v1], |s, _| {
            Some(s.velocity(0, Before).angle_to(s.velocity(0, After)))
        }),
        ANGLE.of("theta2", "recoil angle θ₂", &[u1, v2], |s, _| {
            Some(-s.velocity(0, Before).angle_to(s.velocity(1, After)))
        }),
        ANGLE.of("between", "angle between the paths", &[v1, v2], |s, _| {
            Some(s.velocity(0, After).angle_to(s.velocity(1, After)).abs())
        }),
    ]);
    for (ids, names, body) in [
        ("predicted_v1_*", "predicted v₁ along *", 0),
        ("predicted_v2_*", "predicted v₂ along *", 1),
    ] {
        let found = move |s: &State, k: &Known| Some(predicted(s, k)?[body]);
        all.extend(SPEED.components(ids, names, &[Approach], found));
    }
    for (ids, names, body) in [
        ("residual_v1_*", "v₁ along * − predicted", 0),
        ("residual_v2_*", "v₂ along * − predicted", 1),
    ] {
        let missed =
            move |s: &State, k: &Known| Some(s.velocity(body, After) - predicted(s, k)?[body]);
        all.extend(SPEED.components(ids, names, &[Approach], missed));
    }
    let name = "distance between the centres at contact";
    all.push(LENGTH.of("centres_apart", name, &[], |s, _| {
        Some(s.centre(0).distance(s.centre(1)))
    }));
    all
});

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

impl Measurement {
    /// The estimate of a quantity, or why there is none.
    pub(crate) fn estimate(&self, quantity: &Quantity) -> Result<Estimate, String> {
        let mut needs = quantity.needs.iter();
        if let Some(reason) = needs.find_map(|need| self.missing(*need)) {
            return Err(reason);
        }
        let of = |state: &State| (quantity.of)(state, &self.known);
        let estimate = match quantity.unit == ANGLE {
            true => self.fit.estimate_angle(of),
            false => self.fit.estimate(of),
        };
        estimate.ok_or_else(|| "not defined for this collision".into())
    }

    /// Why a condition is not met; `None` if it is met.
    fn missing(&self, need: Need) -> Option<String> {
        let (fit, known) = (&self.fit, &self.known);
        let is_clear = |it: Option<Estimate>| it.is_some_and(|it| it.is_clear());
        let (is_met, reason) = match need {
            Need::Moves(body, leg) => {
                let speed = fit.estimate(|state| Some(state.velocity(body, leg).length()));
                let most = speed.map_or(f64::NAN, |it| it.value + it.uncertainty95());
                let (name, most) = (self.names()[body], fixed(most, 3));
                let reason = format!(
                    "not defined: {name} is at rest {leg} the contact, or slower than {most} m/s"
                );
                return (!is_clear(speed)).then_some(reason);
            }
            Need::Approach => {
                let along = |state: &State| Some(relative(state, Before).dot(line(state, known)));
                let speed = fit.estimate(along).filter(|it| it.value > 0.0);
                let reason = "not defined: the speed of approach along the line of impact is not \
                              clearly above zero";
                (is_clear(speed), reason)
            }
            Need::Momentum => {
                let total = fit.estimate(|state| Some(momentum(state, known, Before).length()));
                let reason = "not defined: the total momentum before the contact is not clearly \
                              different from zero";
                (is_clear(total), reason)
            }
            Need::Radii => {
                let reason = match fit.apart {
                    None => "unknown without the radii",
                    Some(_) => "unknown: the tracks contradict the radii",
                };
                (known.line == LineFrom::Centres, reason)
            }
            Need::Masses => (known.are_given, "unknown without the masses"),
            Need::Slows(body) => (fit.model.slows(body), "none found: straight lines"),
        };
        (!is_met).then(|| reason.into())
    }
}
