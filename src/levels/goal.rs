//! The goals of a level.

use glam::DVec2;

use super::quantity as q;
use super::scene::{Scene, point, read_disc, read_discs, tidy};
use crate::files::{Fields, Range};
use crate::physics::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

/// A goal; a level is won when all of its goals are met.
///
/// "The first hit" is the first collision of two discs. Body 1 is always the disc that was shot,
/// because all other discs are at rest before this collision.
#[derive(Debug, Clone, PartialEq)]
pub enum Goal {
    /// These discs are pocketed, in this order.
    Pocket {
        /// The numbers of the discs.
        discs: Vec<usize>,
    },
    /// A disc is not pocketed.
    Keep {
        /// The number of the disc.
        disc: usize,
    },
    /// A disc is not hit.
    Untouched {
        /// The number of the disc.
        disc: usize,
        /// The disc that must not hit this disc; `None` means that no disc may.
        by: Option<usize>,
    },
    /// A disc is hit by another disc.
    Hit {
        /// The disc that is hit.
        disc: usize,
        /// The disc that hits it.
        by: usize,
        /// The minimum number of cushions that `by` must hit first.
        least: usize,
    },
    /// A disc comes to rest with its centre inside a circle.
    Rest {
        /// The number of the disc.
        disc: usize,
        /// The circle in which the disc must come to rest.
        circle: GoalCircle,
    },
    /// The centre of a disc passes through a circle.
    Pass {
        /// The number of the disc.
        disc: usize,
        /// The circle through which the centre must pass.
        circle: GoalCircle,
    },
    /// A disc hits cushions before it hits another disc for the first time.
    Bank {
        /// The number of the disc.
        disc: usize,
        /// The disc that is hit after the cushions.
        target: usize,
        /// The minimum number of cushions.
        least: usize,
    },
    /// A disc hits cushions, whether before or after other collisions.
    Cushions {
        /// The number of the disc.
        disc: usize,
        /// The minimum number of hits.
        least: usize,
    },
    /// A quantity of the first collision is within a range.
    FirstHit {
        /// The quantity that is judged.
        measure: HitMeasure,
        /// The range, in the unit of the quantity.
        range: Range,
    },
}

/// A quantity just after the first collision.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HitMeasure {
    /// The speed of a disc, in m/s.
    Speed(usize),
    /// The angle between the velocity of body 1 just before the collision and that of a disc, on
    /// either side, in radians.
    Turn(usize),
    /// The angle between the velocities of the two discs, in radians.
    Separation,
    /// The fraction of the energy of body 1 that a disc has after the collision, from 0 to 1.
    Energy(usize),
}

impl HitMeasure {
    /// The name of the disc to which the quantity belongs; empty if it belongs to both discs.
    pub(super) fn name(self, scene: &Scene) -> String {
        match self {
            Self::Speed(disc) | Self::Turn(disc) | Self::Energy(disc) => scene.name(disc),
            Self::Separation => String::new(),
        }
    }

    /// Describes a range of the quantity in words.
    pub(super) fn between(self, range: &Range) -> String {
        let (factor, unit) = match self {
            Self::Speed(_) => (1.0, " m/s"),
            Self::Turn(_) | Self::Separation => (deg_from_rad(1.0), "°"),
            Self::Energy(_) => (100.0, " %"),
        };
        let Range { from, to } = range.scaled(factor);
        format!("{} to {}{unit}", tidy(from), tidy(to))
    }
}

impl Goal {
    /// Whether the goal is decided by the first collision alone.
    pub(crate) fn is_of_the_first_hit(&self) -> bool {
        matches!(self, Self::FirstHit { .. })
    }
}

/// A circle marked on the board.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GoalCircle {
    /// The centre, in metres from the centre of the board.
    pub centre: DVec2,
    /// The radius in metres.
    pub radius: f64,
}

/// The maximum number of cushions that a goal may require.
const MOST_CUSHIONS: usize = 20;

/// The kinds of goals by their names in a file, each with its fields.
const KINDS: [(&str, &[&str]); 12] = [
    ("pocket", &["kind", "discs"]),
    ("keep", &["kind", "disc"]),
    ("untouched", &["kind", "disc", "by"]),
    ("hit", &["kind", "disc", "by", "least"]),
    ("rest", &IN_CIRCLE),
    ("pass", &IN_CIRCLE),
    ("bank", &["kind", "disc", "target", "least"]),
    ("cushions", &["kind", "disc", "least"]),
    ("speed", &["kind", "disc", "between"]),
    ("turn", &["kind", "disc", "between_deg"]),
    ("separation", &["kind", "between_deg"]),
    ("energy", &["kind", "disc", "between_percent"]),
];

/// The fields of a goal with a circle.
const IN_CIRCLE: [&str; 4] = ["kind", "disc", "centre_mm", "radius_mm"];

impl Goal {
    /// Reads a goal in a scene of `count` discs.
    pub(super) fn from_fields(fields: Fields, count: usize) -> Option<Self> {
        let kinds = KINDS.map(|(kind, known)| (kind, (kind, known)));
        let (kind, known) = fields.word("kind", &kinds)?;
        let fields = fields.only(known);
        let disc_at = |name| read_disc(&fields, name, count);
        let disc = || disc_at("disc");
        let least = || {
            let expected = format!("a number of cushions from 1 to {MOST_CUSHIONS}");
            fields.whole("least", &expected, 1..=MOST_CUSHIONS)
        };
        let least_or = |usual| fields.or("least", usual, |_| least());
        let circle = || GoalCircle::from_fields(&fields);
        let angles = || {
            let range = fields.range("between_deg", &q::ANGLE)?;
            Some(range.scaled(rad_from_deg(1.0)))
        };
        let first_hit = |measure: Option<HitMeasure>, range: Option<Range>| {
            let (measure, range) = measure.zip(range)?;
            Some(Self::FirstHit { measure, range })
        };
        // With `zip`, all fields are read before a missing value ends the function, so all errors
        // are reported.
        Some(match kind {
            "pocket" => Self::Pocket {
                discs: read_discs(&fields, "discs", count, count)?,
            },
            "keep" => Self::Keep { disc: disc()? },
            "untouched" => {
                let by = fields.or("by", None, |by| disc_at(by).map(Some));
                let (disc, by) = disc().zip(by)?;
                Self::Untouched { disc, by }
            }
            "hit" => {
                let ((disc, by), least) = disc().zip(disc_at("by")).zip(least_or(0))?;
                Self::Hit { disc, by, least }
            }
            "rest" => {
                let (disc, circle) = disc().zip(circle())?;
                Self::Rest { disc, circle }
            }
            "pass" => {
                let (disc, circle) = disc().zip(circle())?;
                Self::Pass { disc, circle }
            }
            "bank" => {
                let target = disc_at("target");
                let ((disc, target), least) = disc().zip(target).zip(least_or(1))?;
                Self::Bank {
                    disc,
                    target,
                    least,
                }
            }
            "cushions" => {
                let (disc, least) = disc().zip(least())?;
                Self::Cushions { disc, least }
            }
            "speed" => first_hit(
                disc().map(HitMeasure::Speed),
                fields.range("between", &q::SPEED),
            )?,
            "turn" => first_hit(disc().map(HitMeasure::Turn), angles())?,
            "separation" => first_hit(Some(HitMeasure::Separation), angles())?,
            _ => {
                let disc = disc().map(HitMeasure::Energy);
                let percent = fields.range("between_percent", &q::PERCENT);
                first_hit(disc, percent.map(|range| range.scaled(0.01)))?
            }
        })
    }

    /// The circle to draw on the board, and the disc to whose goal the circle belongs.
    pub(crate) fn circle(&self) -> Option<(GoalCircle, usize)> {
        match self {
            Self::Rest { disc, circle } | Self::Pass { disc, circle } => Some((*circle, *disc)),
            _ => None,
        }
    }

    /// Describes in plain words what the player has to do.
    pub(crate) fn describe(&self, scene: &Scene) -> String {
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
                format!("Bring {} to rest in its circle.", name(disc))
            }
            Self::Pass { disc, .. } => format!("Send {} through its circle.", name(disc)),
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
            Self::FirstHit { measure, range } => {
                let between = measure.between(range);
                let name = measure.name(scene);
                match measure {
                    HitMeasure::Speed(_) if range.from <= 0.0 => {
                        let most = tidy(range.to);
                        format!("Leave {name} with at most {most} m/s right after the first hit.")
                    }
                    HitMeasure::Speed(_) => {
                        format!("Give {name} a speed of {between} right after the first hit.")
                    }
                    HitMeasure::Turn(_) => {
                        format!("Send {name} off at {between} from the incoming path.")
                    }
                    HitMeasure::Separation => {
                        format!("Make the angle between the paths {between}.")
                    }
                    HitMeasure::Energy(_) => {
                        format!("Give {name} {between} of the energy in the first hit.")
                    }
                }
            }
        }
    }
}

/// Describes a minimum number of cushions in words.
fn cushions(least: usize) -> String {
    match least {
        1 => "a cushion".into(),
        _ => format!("at least {least} cushions"),
    }
}

impl GoalCircle {
    fn from_fields(fields: &Fields) -> Option<Self> {
        let centre = fields.pair("centre_mm", "[x, y]", &q::COORDINATE);
        let radius = fields.number("radius_mm", &q::RADIUS);
        Some(Self {
            centre: point(centre?),
            radius: m_from_mm(radius?),
        })
    }

    /// The distance of a point from the edge of the circle, in mm, which is positive outside the
    /// circle and negative inside.
    pub(super) fn outside_mm(&self, point: DVec2) -> f64 {
        mm_from_m(self.centre.distance(point) - self.radius)
    }
}
