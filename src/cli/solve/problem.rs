//! A problem as it is asked, in the units of files, and the check that makes a
//! collision of it.

use std::ops::RangeInclusive;

use glam::DVec2;

use crate::physics::units::{kg_from_g, m_from_mm, rad_from_deg};
use crate::physics::worked::Given;
use crate::physics::{Bond, Collision, Disc};

/// Masses in g and lengths in mm: wide enough for dust and for planets' rings,
/// narrow enough that nothing in the working over- or underflows.
const SIZE: RangeInclusive<f64> = 1e-12..=1e12;
/// Offsets in mm, either side.
const OFFSET: RangeInclusive<f64> = -1e12..=1e12;
/// Components of a velocity in m/s.
const SPEED: RangeInclusive<f64> = -1e9..=1e9;
/// Impact angles in degrees.
const ALPHA: RangeInclusive<f64> = -90.0..=90.0;
/// Coefficients of restitution.
const RESTITUTION: RangeInclusive<f64> = 0.0..=1.0;
/// Radius in mm where none is given: a carrom piece. With an impact angle it matters
/// only for how a pair that sticks turns.
const RADIUS_MM: f64 = 15.9;

/// A field that is missing, out of range or out of place.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{field}: {message}")]
pub(super) struct Fault {
    /// The field or option at fault.
    pub(super) field: String,
    /// What was expected, and what was found.
    pub(super) message: String,
}

/// A collision as it is asked; what is `None` was not said.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Problem {
    pub(super) m1_g: Option<f64>,
    pub(super) m2_g: Option<f64>,
    pub(super) u1: Option<[f64; 2]>,
    pub(super) u2: Option<[f64; 2]>,
    pub(super) alpha_deg: Option<f64>,
    pub(super) offset_mm: Option<f64>,
    pub(super) r1_mm: Option<f64>,
    pub(super) r2_mm: Option<f64>,
    pub(super) restitution: Option<f64>,
    pub(super) stick: Option<bool>,
}

impl Problem {
    /// The collision that is asked for, and which way it was given.
    pub(super) fn collision(&self) -> Result<(Collision, Given), Fault> {
        if self.alpha_deg.is_some() && self.offset_mm.is_some() {
            return Err(fault(
                "alpha_deg",
                "expected either this or offset_mm, found both",
            ));
        }
        let mass = |field, value| number(field, required(field, value)?, SIZE, "grams");
        let radius = |field, value| number(field, value, SIZE, "millimetres");
        let (m1, m2) = (mass("m1_g", self.m1_g)?, mass("m2_g", self.m2_g)?);
        let u1 = velocity("u1", required("u1", self.u1)?)?;
        let u2 = velocity("u2", self.u2.unwrap_or_default())?;
        let restitution = self.restitution.unwrap_or(1.0);
        let restitution = number("restitution", restitution, RESTITUTION, "a number")?;
        if self.offset_mm.is_some() {
            required("r1_mm", self.r1_mm)?;
            required("r2_mm", self.r2_mm)?;
        }
        let r1 = radius("r1_mm", self.r1_mm.unwrap_or(RADIUS_MM))?;
        let r2 = radius("r2_mm", self.r2_mm.unwrap_or(RADIUS_MM))?;
        let head_on = Collision {
            striker: disc(m1, r1),
            target: disc(m2, r2),
            u1,
            u2,
            offset: 0.0,
            restitution,
            bond: if self.stick.unwrap_or(false) {
                Bond::Stick
            } else {
                Bond::Slip
            },
        };
        match (self.alpha_deg, self.offset_mm) {
            (Some(alpha), None) => {
                let alpha = number("alpha_deg", alpha, ALPHA, "degrees")?;
                Ok((head_on.with_alpha(rad_from_deg(alpha)), Given::Angle))
            }
            (None, Some(offset)) => {
                let offset = m_from_mm(number("offset_mm", offset, OFFSET, "millimetres")?);
                Ok((Collision { offset, ..head_on }, Given::Offset))
            }
            _ => Err(fault(
                "alpha_deg",
                "missing: expected this, or offset_mm with r1_mm and r2_mm",
            )),
        }
    }
}

fn disc(mass_g: f64, radius_mm: f64) -> Disc {
    Disc {
        mass: kg_from_g(mass_g),
        radius: m_from_mm(radius_mm),
    }
}

fn required<T>(field: &str, value: Option<T>) -> Result<T, Fault> {
    value.ok_or_else(|| fault(field, "missing"))
}

/// A speed along a line, in m/s.
pub(super) fn speed(value: f64) -> Result<f64, Fault> {
    number("speed", value, SPEED, "a speed in m/s")
}

fn velocity(field: &str, components: [f64; 2]) -> Result<DVec2, Fault> {
    for component in components {
        number(field, component, SPEED, "components in m/s")?;
    }
    Ok(DVec2::from_array(components))
}

fn number(field: &str, value: f64, range: RangeInclusive<f64>, what: &str) -> Result<f64, Fault> {
    if range.contains(&value) {
        return Ok(value);
    }
    let (low, high) = (plain(*range.start()), plain(*range.end()));
    let message = format!(
        "expected {what} from {low} to {high}, found {}",
        plain(value)
    );
    Err(fault(field, &message))
}

/// A number as one would type it: 90, 0.5, 1e12.
fn plain(x: f64) -> String {
    if x.abs() <= 0.0 || (1e-4..1e6).contains(&x.abs()) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

fn fault(field: &str, message: &str) -> Fault {
    Fault {
        field: field.to_owned(),
        message: message.to_owned(),
    }
}
