//! What has to come about in a level.

use glam::DVec2;

use super::quantity as q;
use super::scene::{Scene, point, read_disc, read_discs, tidy};
use crate::files::{Fields, Range};
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

/// The kinds of goals in a file.
#[derive(Clone, Copy)]
enum GoalKind {
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

/// What a file says of a goal of a kind.
type KindFields = (GoalKind, &'static [&'static str]);

/// The kinds of goals by their names, each with its fields.
const KINDS: [(&str, KindFields); 12] = [
    ("pocket", (GoalKind::Pocket, &["kind", "discs"])),
    ("keep", (GoalKind::Keep, &["kind", "disc"])),
    ("untouched", (GoalKind::Untouched, &["kind", "disc", "by"])),
    ("hit", (GoalKind::Hit, &["kind", "disc", "by", "least"])),
    ("rest", (GoalKind::Rest, &IN_CIRCLE)),
    ("pass", (GoalKind::Pass, &IN_CIRCLE)),
    (
        "bank",
        (GoalKind::Bank, &["kind", "disc", "target", "least"]),
    ),
    ("cushions", (GoalKind::Cushions, &["kind", "disc", "least"])),
    ("speed", (GoalKind::Speed, &["kind", "disc", "between"])),
    ("turn", (GoalKind::Turn, &["kind", "disc", "between_deg"])),
    (
        "separation",
        (GoalKind::Separation, &["kind", "between_deg"]),
    ),
    (
        "energy",
        (GoalKind::Energy, &["kind", "disc", "between_percent"]),
    ),
];

/// The fields of a goal with a circle.
const IN_CIRCLE: [&str; 4] = ["kind", "disc", "centre_mm", "radius_mm"];

impl Goal {
    /// Reads a goal in a scene of so many discs.
    pub(super) fn from_fields(fields: Fields, count: usize) -> Option<Self> {
        let (kind, known) = fields.word("kind", &KINDS)?;
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
        // Zipped, so that every field is read before one that is wrong ends it.
        Some(match kind {
            GoalKind::Pocket => Self::Pocket {
                discs: read_discs(&fields, "discs", count, count)?,
            },
            GoalKind::Keep => Self::Keep { disc: disc()? },
            GoalKind::Untouched => {
                let by = fields.or("by", None, |by| disc_at(by).map(Some));
                let (disc, by) = disc().zip(by)?;
                Self::Untouched { disc, by }
            }
            GoalKind::Hit => {
                let ((disc, by), least) = disc().zip(disc_at("by")).zip(least_or(0))?;
                Self::Hit { disc, by, least }
            }
            GoalKind::Rest => {
                let (disc, circle) = disc().zip(circle())?;
                Self::Rest { disc, circle }
            }
            GoalKind::Pass => {
                let (disc, circle) = disc().zip(circle())?;
                Self::Pass { disc, circle }
            }
            GoalKind::Bank => {
                let target = disc_at("target");
                let ((disc, target), least) = disc().zip(target).zip(least_or(1))?;
                Self::Bank {
                    disc,
                    target,
                    least,
                }
            }
            GoalKind::Cushions => {
                let (disc, least) = disc().zip(least())?;
                Self::Cushions { disc, least }
            }
            GoalKind::Speed => {
                let (disc, range) = disc().zip(fields.range("between", &q::SPEED))?;
                Self::Speed { disc, range }
            }
            GoalKind::Turn => {
                let (disc, range) = disc().zip(angles())?;
                Self::Turn { disc, range }
            }
            GoalKind::Separation => Self::Separation { range: angles()? },
            GoalKind::Energy => {
                let share = fields.range("between_percent", &q::PERCENT);
                let (disc, share) = disc().zip(share)?;
                let range = share.scaled(0.01);
                Self::Energy { disc, range }
            }
        })
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

/// So many cushions at least, in words.
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
