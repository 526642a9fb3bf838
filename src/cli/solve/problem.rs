//! A problem in the units used in files, and the check that turns it into a collision.

use std::borrow::Cow;
use std::num::ParseFloatError;

use clap::ArgAction;
use glam::DVec2;

use crate::numbers::typed;
use crate::physics::{Bond, Collision, CollisionSpec, FieldRange, ImpactPoint, Rims};

/// The ranges of the fields, wide enough for dust and for planetary rings, but narrow enough to
/// prevent overflow and underflow in the calculation.
const RANGES: [FieldRange; 13] = [
    FieldRange::new("m1_g", "grams", 1e-12, 1e12),
    FieldRange::new("m2_g", "grams", 1e-12, 1e12),
    FieldRange::new("r1_mm", "millimetres", 1e-12, 1e12),
    FieldRange::new("r2_mm", "millimetres", 1e-12, 1e12),
    FieldRange::new("u1", "components in m/s", -1e9, 1e9),
    FieldRange::new("u2", "components in m/s", -1e9, 1e9),
    FieldRange::new("speed", "a speed in m/s", -1e9, 1e9),
    FieldRange::new("alpha_deg", "degrees", -90.0, 90.0),
    FieldRange::new("offset_mm", "millimetres", -1e12, 1e12),
    FieldRange::new("restitution", "a number", 0.0, 1.0),
    FieldRange::new("rim_friction", "a number", 0.0, 1e9),
    FieldRange::new("spin1", "rad/s", -1e9, 1e9),
    FieldRange::new("spin2", "rad/s", -1e9, 1e9),
];
/// The default radius in mm: that of a carrom piece. With an impact angle it matters only for
/// rotation.
const RADIUS_MM: f64 = 15.9;
/// The default mass on the command line, in grams.
const MASS_G: f64 = 15.0;
/// The default speed on the command line, in m/s.
const SPEED: f64 = 4.0;

/// A field that is missing, out of range or out of place.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{field}: {message}")]
pub(super) struct ProblemError {
    /// The field or option at fault.
    pub(super) field: String,
    /// What was expected, and what was found.
    pub(super) message: String,
}

/// A collision to solve; `None` means not given.
#[derive(Debug, Clone, Copy, Default, PartialEq, clap::Args)]
pub(super) struct Problem {
    /// Mass of the striker in grams [default: 15]
    #[arg(long, value_name = "G", allow_negative_numbers = true)]
    pub(super) m1_g: Option<f64>,

    /// Mass of the target in grams [default: 15]
    #[arg(long, value_name = "G", allow_negative_numbers = true)]
    pub(super) m2_g: Option<f64>,

    /// Speed of the striker in m/s, along +x [default: 4]
    #[arg(long = "speed", value_name = "M/S")]
    #[arg(value_parser = along_x, allow_negative_numbers = true)]
    pub(super) u1: Option<[f64; 2]>,

    /// Impact angle in degrees, -90 to 90
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub(super) alpha_deg: Option<f64>,

    /// Offset of the target's centre to the right of the striker's path in mm,
    /// instead of the impact angle
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    #[arg(conflicts_with = "alpha_deg", requires_all = ["r1_mm", "r2_mm"])]
    pub(super) offset_mm: Option<f64>,

    /// Radius of the striker in mm [default: 15.9, with --alpha-deg]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    pub(super) r1_mm: Option<f64>,

    /// Radius of the target in mm [default: 15.9, with --alpha-deg]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    pub(super) r2_mm: Option<f64>,

    /// Velocity of the target in m/s, as X,Y [default: 0,0]
    #[arg(long, value_name = "X,Y")]
    #[arg(value_parser = pair, allow_hyphen_values = true)]
    pub(super) u2: Option<[f64; 2]>,

    /// Coefficient of restitution, 0 to 1 [default: 1]
    #[arg(long, value_name = "E", allow_negative_numbers = true)]
    pub(super) restitution: Option<f64>,

    /// The discs stick together and move on as one (perfectly inelastic)
    #[arg(long, action = ArgAction::SetTrue)]
    pub(super) stick: Option<bool>,

    /// Coefficient of friction between the rims of solid discs [default: 0, smooth]
    #[arg(long, value_name = "MU", allow_negative_numbers = true)]
    #[arg(conflicts_with = "stick")]
    pub(super) rim_friction: Option<f64>,

    /// Spin of the striker in rad/s, positive anticlockwise [default: 0]
    #[arg(long, value_name = "RAD/S", allow_negative_numbers = true)]
    #[arg(conflicts_with = "stick")]
    pub(super) spin1: Option<f64>,

    /// Spin of the target in rad/s, positive anticlockwise [default: 0]
    #[arg(long, value_name = "RAD/S", allow_negative_numbers = true)]
    #[arg(conflicts_with = "stick")]
    pub(super) spin2: Option<f64>,
}

/// A checked problem.
#[derive(Debug, Clone)]
pub(super) struct Solvable {
    pub(super) collision: Collision,
    /// Whether the problem gave the offset instead of the impact angle.
    pub(super) by_offset: bool,
    /// What was assumed because the problem does not give it, and what was ignored.
    pub(super) assumed: Vec<Cow<'static, str>>,
}

impl Problem {
    /// The problem, with default values for any mass or speed that it does not give, and a list
    /// of these assumptions. Lines of a batch must give the masses and u1.
    pub(super) fn with_usual(mut self) -> (Self, Vec<Cow<'static, str>>) {
        let mut assumed = Vec::new();
        for (mass, name) in [(&mut self.m1_g, "m1"), (&mut self.m2_g, "m2")] {
            if mass.is_none() {
                *mass = Some(MASS_G);
                assumed.push(format!("{name} = {MASS_G} g").into());
            }
        }
        if self.u1.is_none() {
            self.u1 = Some([SPEED, 0.0]);
            assumed.push(format!("u1 = {SPEED} m/s").into());
        }
        (self, assumed)
    }

    /// Whether the radii matter even if the discs do not stick: a disc spins or may be set
    /// spinning.
    fn turns(&self) -> bool {
        let numbers = [self.rim_friction, self.spin1, self.spin2];
        numbers.into_iter().flatten().any(|number| number != 0.0)
    }

    /// The radii that were not given and are therefore assumed.
    fn assumed_radii(&self) -> Option<Cow<'static, str>> {
        match (self.r1_mm, self.r2_mm) {
            (None, None) => Some(format!("radii {RADIUS_MM} mm").into()),
            (None, Some(_)) => Some(format!("r1 = {RADIUS_MM} mm").into()),
            (Some(_), None) => Some(format!("r2 = {RADIUS_MM} mm").into()),
            (Some(_), Some(_)) => None,
        }
    }

    /// The assumptions that can change the answer, and the values that are ignored.
    fn assumed(&self) -> Vec<Cow<'static, str>> {
        let mut assumed: Vec<Cow<'static, str>> = Vec::new();
        if self.u2.is_none() {
            assumed.push("target at rest".into());
        }
        let sticks = self.stick.unwrap_or(false);
        match self.restitution {
            Some(_) if sticks => {
                assumed.push("restitution ignored, as discs that stick do not rebound".into());
            }
            None if !sticks => assumed.push("elastic, restitution 1".into()),
            _ => {}
        }
        if sticks || self.turns() {
            assumed.extend(self.assumed_radii());
            assumed.push("uniform solid discs".into());
        } else if self.offset_mm.is_none() && (self.r1_mm.is_some() || self.r2_mm.is_some()) {
            assumed.push("radii ignored, as alpha_deg gives the line of impact".into());
        }
        if !sticks && self.rim_friction.is_none() {
            assumed.push("smooth rims".into());
        }
        assumed
    }

    /// The collision and its assumptions.
    pub(super) fn solvable(&self) -> Result<Solvable, ProblemError> {
        if self.alpha_deg.is_some() && self.offset_mm.is_some() {
            return Err(fault(
                "alpha_deg",
                "expected either this or offset_mm, found both",
            ));
        }
        let radius = |field, value: Option<f64>| match self.offset_mm {
            Some(_) => number(field, required(field, value)?),
            None => number(field, value.unwrap_or(RADIUS_MM)),
        };
        let sticks = self.stick.unwrap_or(false);
        for (field, value) in [
            ("rim_friction", self.rim_friction),
            ("spin1", self.spin1),
            ("spin2", self.spin2),
        ] {
            if sticks && value.is_some() {
                return Err(fault(field, "expected either this or stick, found both"));
            }
        }
        let turning = |field, value: Option<f64>| number(field, value.unwrap_or(0.0));
        let (m1_g, m2_g) = (required("m1_g", self.m1_g)?, required("m2_g", self.m2_g)?);
        let spec = CollisionSpec {
            m1_g: number("m1_g", m1_g)?,
            m2_g: number("m2_g", m2_g)?,
            restitution: number("restitution", self.restitution.unwrap_or(1.0))?,
            r1_mm: radius("r1_mm", self.r1_mm)?,
            r2_mm: radius("r2_mm", self.r2_mm)?,
            bond: if sticks { Bond::Stick } else { Bond::Slip },
            rims: Rims {
                friction: turning("rim_friction", self.rim_friction)?,
                spins: [turning("spin1", self.spin1)?, turning("spin2", self.spin2)?],
            },
            point: match (self.alpha_deg, self.offset_mm) {
                (Some(alpha), _) => ImpactPoint::Angle {
                    alpha_deg: number("alpha_deg", alpha)?,
                },
                (None, Some(offset)) => ImpactPoint::Offset {
                    offset_mm: number("offset_mm", offset)?,
                },
                (None, None) => {
                    let wanted = "missing: expected this, or offset_mm with r1_mm and r2_mm";
                    return Err(fault("alpha_deg", wanted));
                }
            },
            ..CollisionSpec::default()
        };
        let collision = Collision {
            u1: velocity("u1", required("u1", self.u1)?)?,
            u2: velocity("u2", self.u2.unwrap_or_default())?,
            ..spec.collision()
        };
        Ok(Solvable {
            collision,
            by_offset: spec.is_by_offset(),
            assumed: self.assumed(),
        })
    }
}

/// A velocity along +x.
fn along_x(speed: &str) -> Result<[f64; 2], ParseFloatError> {
    Ok([speed.parse()?, 0.0])
}

fn pair(text: &str) -> Result<[f64; 2], String> {
    let number = |part: &str| part.trim().parse::<f64>().ok();
    text.split_once(',')
        .and_then(|(x, y)| Some([number(x)?, number(y)?]))
        .ok_or_else(|| {
            "expected two numbers in m/s separated by a comma, such as -1,0.5".to_owned()
        })
}

fn required<T>(field: &str, value: Option<T>) -> Result<T, ProblemError> {
    value.ok_or_else(|| fault(field, "missing"))
}

fn velocity(field: &str, components: [f64; 2]) -> Result<DVec2, ProblemError> {
    let [x, y] = components.map(|component| number(field, component));
    Ok(DVec2::new(x?, y?))
}

/// A number, checked against the range of its field.
pub(super) fn number(field: &str, value: f64) -> Result<f64, ProblemError> {
    let range = RANGES.iter().find(|range| range.name == field);
    range.map_or(Ok(value), |range| {
        range
            .check(value, typed(value))
            .map_err(|message| fault(field, &message))
    })
}

fn fault(field: &str, message: &str) -> ProblemError {
    ProblemError {
        field: field.to_owned(),
        message: message.to_owned(),
    }
}
