//! What has to come about in a level.

use glam::DVec2;

use super::fields::Fields;
use super::quantity::{self as q, Range};
use super::scene::{Scene, tidy};
use crate::files::FileError;
use crate::physics::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

/// One thing that has to come about; a level is won when all of its goals are met.
///
/// What is said of "the first hit" is said of the first time two discs meet. Body 1
/// of it is always the disc that was set off, as all others are at rest until then.
#[derive(Debug, Clone, PartialEq)]
pub enum Goal {
    /// These discs fall into pockets, in this order.
    Pocket {
        /// The discs.
        discs: Vec<usize>,
    },
    /// A disc stays on the board.
    Keep {
        /// The disc.
        disc: usize,
    },
    /// A disc is not hit.
    Untouched {
        /// The disc.
        disc: usize,
        /// Only this one must not hit it; `None` means that no disc may.
        by: Option<usize>,
    },
    /// A disc is hit by another.
    Hit {
        /// The disc that is hit.
        disc: usize,
        /// The disc that hits it.
        by: usize,
        /// How many times that one meets a cushion before, at least.
        least: usize,
    },
    /// A disc comes to rest with its centre in a circle.
    Rest {
        /// The disc.
        disc: usize,
        /// The circle.
        circle: GoalCircle,
    },
    /// The centre of a disc passes through a circle.
    Pass {
        /// The disc.
        disc: usize,
        /// The circle.
        circle: GoalCircle,
    },
    /// A disc meets cushions before it meets another disc for the first time.
    Bank {
        /// The disc.
        disc: usize,
        /// The disc it then meets.
        target: usize,
        /// How many times it meets a cushion at least.
        least: usize,
    },
    /// A disc meets cushions, whatever else it does.
    Cushions {
        /// The disc.
        disc: usize,
        /// How many times at least.
        least: usize,
    },
    /// The speed of a disc right after the first hit.
    Speed {
        /// The disc.
        disc: usize,
        /// Bounds in m/s.
        range: Range,
    },
    /// The angle between the line along which body 1 came and the velocity of a disc
    /// right after the first hit, to either side.
    Turn {
        /// The disc.
        disc: usize,
        /// Bounds in radians.
        range: Range,
    },
    /// The angle between the velocities of the two right after the first hit.
    Separation {
        /// Bounds in radians.
        range: Range,
    },
    /// The part of the energy body 1 brought to the first hit that a disc takes away.
    Energy {
        /// The disc.
        disc: usize,
        /// Bounds, as fractions of one.
        range: Range,
    },
}

impl Goal {
    /// Whether it is decided by the first hit alone.
    pub fn is_of_the_first_hit(&self) -> bool {
        match self {
            Self::Speed { .. }
            | Self::Turn { .. }
            | Self::Separation { .. }
            | Self::Energy { .. } => true,
            Self::Pocket { .. }
            | Self::Keep { .. }
            | Self::Untouched { .. }
            | Self::Hit { .. }
            | Self::Rest { .. }
            | Self::Pass { .. }
            | Self::Bank { .. }
            | Self::Cushions { .. } => false,
        }
    }
}

/// A circle marked on the board.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GoalCircle {
    /// Its centre in metres.
    pub centre: DVec2,
    /// Its radius in metres.
    pub radius: f64,
}

/// The names of the goals in a file.
#[derive(Clone, Copy)]
enum Name {
    Pocket,
    Keep,
    Untouched,
    Hit,
    Rest,
    Pass,
    Bank,
    Cushions,
    Speed,
    Turn,
    Separation,
    Energy,
}

/// The most cushions a goal may ask for.
const MOST_CUSHIONS: usize = 20;

const NAMES: [(&str, Name); 12] = [
    ("pocket", Name::Pocket),
    ("keep", Name::Keep),
    ("untouched", Name::Untouched),
    ("hit", Name::Hit),
    ("rest", Name::Rest),
    ("pass", Name::Pass),
    ("bank", Name::Bank),
    ("cushions", Name::Cushions),
    ("speed", Name::Speed),
    ("turn", Name::Turn),
    ("separation", Name::Separation),
    ("energy", Name::Energy),
];

impl Goal {
    pub(super) fn from_fields(mut fields: Fields, scene: &Scene) -> Result<Self, FileError> {
        let count = scene.pieces.len();
        let name = fields.word("kind", &NAMES)?;
        let disc = |fields: &mut Fields| fields.disc("disc", count);
        let between_deg = |fields: &mut Fields| {
            let range = fields.required_range("between_deg", &q::ANGLE)?;
            Ok(range.scaled(rad_from_deg(1.0)))
        };
        let goal = match name {
            Name::Pocket => Self::Pocket {
                discs: fields.discs("discs", count, count)?,
            },
            Name::Keep => Self::Keep {
                disc: disc(&mut fields)?,
            },
            Name::Untouched => Self::Untouched {
                disc: disc(&mut fields)?,
                by: fields
                    .has("by")
                    .then(|| fields.disc("by", count))
                    .transpose()?,
            },
            Name::Hit => Self::Hit {
                disc: disc(&mut fields)?,
                by: fields.disc("by", count)?,
                least: read_optional_least(&mut fields, 0)?,
            },
            Name::Rest => Self::Rest {
                disc: disc(&mut fields)?,
                circle: GoalCircle::from_fields(&mut fields)?,
            },
            Name::Pass => Self::Pass {
                disc: disc(&mut fields)?,
                circle: GoalCircle::from_fields(&mut fields)?,
            },
            Name::Bank => Self::Bank {
                disc: disc(&mut fields)?,
                target: fields.disc("target", count)?,
                least: read_optional_least(&mut fields, 1)?,
            },
            Name::Cushions => Self::Cushions {
                disc: disc(&mut fields)?,
                least: read_least(&mut fields)?,
            },
            Name::Speed => Self::Speed {
                disc: disc(&mut fields)?,
                range: fields.required_range("between", &q::SPEED)?,
            },
            Name::Turn => Self::Turn {
                disc: disc(&mut fields)?,
                range: between_deg(&mut fields)?,
            },
            Name::Separation => Self::Separation {
                range: between_deg(&mut fields)?,
            },
            Name::Energy => Self::Energy {
                disc: disc(&mut fields)?,
                range: fields
                    .required_range("between_percent", &q::PERCENT)?
                    .scaled(0.01),
            },
        };
        fields.finish()?;
        Ok(goal)
    }

    /// The circle that belongs on the board.
    pub fn circle(&self) -> Option<GoalCircle> {
        match self {
            Self::Rest { circle, .. } | Self::Pass { circle, .. } => Some(*circle),
            _ => None,
        }
    }

    /// What to do, in plain words.
    pub fn describe(&self, scene: &Scene) -> String {
        let name = |disc: &usize| scene.name(*disc);
        match self {
            Self::Pocket { discs } => {
                let names: Vec<_> = discs.iter().map(name).collect();
                format!("Pocket {}.", names.join(", then "))
            }
            Self::Keep { disc } => format!("Keep {} out of the pockets.", name(disc)),
            Self::Untouched { disc, by: None } => format!("Leave {} untouched.", name(disc)),
            Self::Untouched { disc, by: Some(by) } => {
                format!("Do not hit {} with {}.", name(disc), name(by))
            }
            Self::Hit { disc, by, least: 0 } => {
                format!("Hit {} with {}.", name(disc), name(by))
            }
            Self::Hit { disc, by, least } => format!(
                "Hit {} with {} off {}.",
                name(disc),
                name(by),
                cushions(*least)
            ),
            Self::Rest { disc, .. } => {
                format!("Bring {} to rest in the marked circle.", name(disc))
            }
            Self::Pass { disc, .. } => format!("Send {} through the marked circle.", name(disc)),
            Self::Bank {
                disc,
                target,
                least,
            } => format!(
                "Send {} off {} before it meets {}.",
                name(disc),
                cushions(*least),
                name(target)
            ),
            Self::Cushions { disc, least } => {
                format!("Send {} off {}.", name(disc), cushions(*least))
            }
            Self::Speed { disc, range } if range.from <= 0.0 => format!(
                "Leave {} with at most {} m/s right after the first hit.",
                name(disc),
                tidy(range.to)
            ),
            Self::Speed { disc, range } => format!(
                "Give {} {} right after the first hit.",
                name(disc),
                between(range, " m/s")
            ),
            Self::Turn { disc, range } => format!(
                "Send {} off at {} from the line of the shot.",
                name(disc),
                between_deg(range)
            ),
            Self::Separation { range } => {
                format!("Make the two go {} apart.", between_deg(range))
            }
            Self::Energy { disc, range } => format!(
                "Give {} {} of the energy in the first hit.",
                name(disc),
                between(&range.scaled(100.0), " %")
            ),
        }
    }
}

/// How many times a disc meets a cushion at least; 0 would ask for nothing.
fn read_least(fields: &mut Fields) -> Result<usize, FileError> {
    let expected = format!("a number of cushions from 1 to {MOST_CUSHIONS}");
    match fields.whole("least", &expected, MOST_CUSHIONS)? {
        0 => Err(fields.fault_at("least", format!("expected {expected}, found 0"))),
        least => Ok(least),
    }
}

/// As [`read_least`], or `otherwise` where the field is left out.
fn read_optional_least(fields: &mut Fields, otherwise: usize) -> Result<usize, FileError> {
    if fields.has("least") {
        read_least(fields)
    } else {
        Ok(otherwise)
    }
}

/// So many cushions at least, in words.
fn cushions(least: usize) -> String {
    match least {
        1 => "a cushion".into(),
        _ => format!("at least {least} cushions"),
    }
}

impl GoalCircle {
    fn from_fields(fields: &mut Fields) -> Result<Self, FileError> {
        let centre = fields.place("centre_mm", &q::COORDINATE)?;
        let radius = fields.required_number("radius_mm", &q::RADIUS)?;
        Ok(Self {
            centre: DVec2::new(m_from_mm(centre.x), m_from_mm(centre.y)),
            radius: m_from_mm(radius),
        })
    }

    /// How far a point lies outside the circle in mm; negative inside.
    pub(super) fn outside_mm(&self, point: DVec2) -> f64 {
        mm_from_m(self.centre.distance(point) - self.radius)
    }
}

/// A range in words.
pub(super) fn between(range: &Range, unit: &str) -> String {
    format!("{} to {}{unit}", tidy(range.from), tidy(range.to))
}

/// A range of angles in radians, in words.
pub(super) fn between_deg(range: &Range) -> String {
    between(&range.scaled(deg_from_rad(1.0)), "°")
}
