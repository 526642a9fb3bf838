//! Reports in words whether a shot meets the goals of a level or, if not, what happened instead.
//! The reports are based only on the record of the shot.

use glam::DVec2;

use super::goal::{Goal, GoalCircle, HitMeasure};
use super::level::Level;
use super::scene::{Scene, figures, tidy};
use crate::numbers::{counted, degrees};
use crate::physics::angle::angle_between;
use crate::physics::units::mm_from_m;
use crate::physics::{DiscState, Event, EventKind, Shot};

/// The results for the goals of a level.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// A finding for each goal, in the same order as the goals.
    pub findings: Vec<Finding>,
}

/// The result of one goal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// Whether the goal is met.
    pub met: bool,
    /// What happened: "the striker came to rest 12 mm short of its circle".
    pub text: String,
}

impl Judgement {
    /// Whether all goals are met.
    pub fn won(&self) -> bool {
        self.findings.iter().all(|finding| finding.met)
    }

    /// The number of goals met.
    pub(crate) fn met(&self) -> usize {
        self.findings.iter().filter(|finding| finding.met).count()
    }
}

/// Judges a shot of a level.
pub fn judge(level: &Level, shot: &Shot) -> Judgement {
    let goals = level.goals.iter();
    Judgement {
        findings: goals.map(|goal| goal.judge(shot, &level.scene)).collect(),
    }
}

fn found(met: bool, text: String) -> Finding {
    Finding { met, text }
}

impl Goal {
    fn judge(&self, shot: &Shot, scene: &Scene) -> Finding {
        let name = |disc: &usize| scene.name(*disc);
        let hit = |one: &usize, other: &usize| format!("{} hit {}", name(one), name(other));
        let no_hit =
            |one: &usize, other: &usize| format!("{} did not hit {}", name(one), name(other));
        match self {
            Self::Pocket { discs } => pocketed(discs, shot, scene),
            Self::Keep { disc } => match shot.fallen().any(|fallen| fallen == *disc) {
                true => found(false, format!("{} was pocketed", name(disc))),
                false => found(true, format!("{} was not pocketed", name(disc))),
            },
            Self::Untouched { disc, by } => {
                let hit_by = match by {
                    Some(by) => before_meeting(*disc, *by, shot).map(|_| *by),
                    None => shot.events().iter().find_map(|it| it.kind.partner(*disc)),
                };
                match (hit_by, by) {
                    (Some(one), _) => found(false, hit(&one, disc)),
                    (None, Some(by)) => found(true, no_hit(by, disc)),
                    (None, None) => found(true, format!("nothing hit {}", name(disc))),
                }
            }
            Self::Hit { disc, by, least } => match before_meeting(*disc, *by, shot) {
                None => found(false, no_hit(by, disc)),
                Some(_) if *least == 0 => found(true, hit(by, disc)),
                Some(before) => {
                    let met = cushions(*by, before);
                    let text = format!("{} off {}", hit(by, disc), in_cushions(met));
                    found(met >= *least, text)
                }
            },
            Self::Rest { disc, circle } => {
                let end = shot.at(*disc, shot.duration());
                let name = name(disc);
                match end.state {
                    DiscState::Pocketed => found(false, format!("{name} was pocketed")),
                    DiscState::Moving => found(false, format!("{name} never came to rest")),
                    DiscState::Resting => {
                        let came = shot.path(*disc).last().map(|leg| leg.to - leg.from);
                        circle.judge(end.position, came, &format!("{name} came to rest"))
                    }
                }
            }
            Self::Pass { disc, circle } => {
                let nearest = nearest_on_path(shot, *disc, circle.centre);
                circle.judge(nearest, None, &format!("{} passed", name(disc)))
            }
            Self::Bank {
                disc,
                target,
                least,
            } => {
                let events = shot.events().iter().enumerate();
                let mut partners =
                    events.filter_map(|(at, it)| Some((at, it.kind.partner(*disc)?)));
                let (name, target_name) = (name(disc), name(target));
                match partners.next() {
                    None => found(false, format!("{name} never hit {target_name}")),
                    Some((_, other)) if other != *target => {
                        found(false, format!("{name} hit another disc first"))
                    }
                    Some((at, _)) => {
                        let met = cushions(*disc, &shot.events()[..at]);
                        let text = match met {
                            0 => format!("{name} hit {target_name} without a cushion"),
                            _ => format!("{name} hit {target_name} off {}", in_cushions(met)),
                        };
                        found(met >= *least, text)
                    }
                }
            }
            Self::Cushions { disc, least } => {
                let met = cushions(*disc, shot.events());
                found(
                    met >= *least,
                    format!("{} hit {}", name(disc), in_cushions(met)),
                )
            }
            Self::FirstHit { measure, range } => {
                let name = measure.name(scene);
                let hit = FirstImpact::of(shot).ok_or(Missing::Part);
                let number = match hit.and_then(|hit| hit.shows(*measure, shot)) {
                    Ok(number) => number,
                    Err(missing) => return found(false, missing.text(&name)),
                };
                let text = match measure {
                    HitMeasure::Speed(_) => format!("{name} left at {} m/s", tidy(number)),
                    HitMeasure::Turn(_) => format!("{name} left at {}", degrees(number)),
                    HitMeasure::Separation => {
                        format!("the angle between the paths was {}", degrees(number))
                    }
                    HitMeasure::Energy(_) => {
                        format!("{name} had {} % of the energy", tidy(100.0 * number))
                    }
                };
                match range.holds(number) {
                    true => found(true, text),
                    false => found(
                        false,
                        format!("{text}, required {}", measure.between(range)),
                    ),
                }
            }
        }
    }
}

impl GoalCircle {
    /// Judges whether a point is inside the circle. `path` is the last straight part of a path that
    /// ends at the point, and `did` is the beginning of the sentence.
    fn judge(&self, point: DVec2, path: Option<DVec2>, did: &str) -> Finding {
        let outside = self.outside_mm(point);
        if outside > 0.0 {
            let missed = path.map_or("outside", |path| self.side(point, path));
            return found(
                false,
                format!("{did} {} mm {missed} its circle", figures(outside)),
            );
        }
        let off = figures(mm_from_m(self.centre.distance(point)));
        found(
            true,
            format!("{did} {off} mm from the middle of its circle"),
        )
    }

    /// Describes where a point at the end of a path lies relative to the circle.
    fn side(&self, point: DVec2, path: DVec2) -> &'static str {
        let to_centre = self.centre - point;
        let (ahead, left) = (path.dot(to_centre), path.perp_dot(to_centre));
        if left.abs() > ahead.abs() {
            match left > 0.0 {
                true => "to the right of",
                false => "to the left of",
            }
        } else if ahead > 0.0 {
            "short of"
        } else {
            "beyond"
        }
    }
}

/// The reason why a quantity of the first collision is undefined.
enum Missing {
    /// The disc did not take part in the first collision, or there was no collision.
    Part,
    /// A disc is at rest, so it has no direction.
    Direction,
}

impl Missing {
    /// The reason in words; `name` is empty if the quantity belongs to both discs.
    fn text(&self, name: &str) -> String {
        match (self, name) {
            (Self::Direction, "") => "one of the two discs stopped, so there is no angle".into(),
            (Self::Direction, _) => format!("{name} stopped, so it has no direction"),
            (Self::Part, "") => "no disc was hit".into(),
            (Self::Part, _) => format!("{name} was not in the first hit"),
        }
    }
}

/// The first collision of two discs.
struct FirstImpact {
    discs: [usize; 2],
    /// The index, in `discs`, of the disc that was shot; the other disc is at rest.
    moving: usize,
    before: DVec2,
    afters: [DVec2; 2],
}

impl FirstImpact {
    fn of(shot: &Shot) -> Option<Self> {
        shot.events().iter().find_map(|event| match event.kind {
            EventKind::Impact {
                discs,
                before,
                after,
                ..
            } => {
                let first = before[0].length_squared() >= before[1].length_squared();
                let moving = usize::from(!first);
                Some(Self {
                    discs,
                    moving,
                    before: before[moving],
                    afters: after,
                })
            }
            _ => None,
        })
    }

    /// The value of a quantity, in the unit used for the goal's range.
    fn shows(&self, measure: HitMeasure, shot: &Shot) -> Result<f64, Missing> {
        let after = |disc| {
            let both = self.discs.into_iter().zip(self.afters);
            let mut own = both.filter(|(number, _)| *number == disc);
            own.next().map(|(_, after)| after).ok_or(Missing::Part)
        };
        let angle = |one, other| angle_between(one, other).ok_or(Missing::Direction);
        match measure {
            HitMeasure::Speed(disc) => Ok(after(disc)?.length()),
            HitMeasure::Turn(disc) => angle(self.before, after(disc)?),
            HitMeasure::Separation => angle(self.afters[0], self.afters[1]),
            HitMeasure::Energy(disc) => {
                let energy = |number: usize, velocity: DVec2| {
                    let disc = shot.discs().get(number).ok_or(Missing::Part)?;
                    Ok(disc.mass * velocity.length_squared())
                };
                let after = energy(disc, after(disc)?)?;
                let before = energy(self.discs[self.moving], self.before)?;
                (before > 0.0).then(|| after / before).ok_or(Missing::Part)
            }
        }
    }
}

fn pocketed(discs: &[usize], shot: &Shot, scene: &Scene) -> Finding {
    let stayed = |disc: &&usize| shot.fallen().all(|fallen| fallen != **disc);
    if let Some(&disc) = discs.iter().find(stayed) {
        let pockets = shot.board().pockets();
        let near = pockets.map(|hole| nearest_on_path(shot, disc, hole).distance(hole));
        let text = match near.min_by(f64::total_cmp) {
            Some(near) => {
                let short = mm_from_m(near - 0.5 * scene.board.pocket_diameter).max(0.0);
                let name = scene.name(disc);
                format!("{name} came within {} mm of a pocket", figures(short))
            }
            None => "there are no pockets".into(),
        };
        return found(false, text);
    }
    let order: Vec<_> = shot.fallen().filter(|disc| discs.contains(disc)).collect();
    let names: Vec<_> = order.iter().map(|disc| scene.name(*disc)).collect();
    let met = order == discs;
    let wrong = if met { "" } else { ", in the wrong order" };
    found(met, format!("pocketed: {}{wrong}", names.join(", then ")))
}

/// The events before the first collision of these two discs; `None` if they do not collide.
fn before_meeting(one: usize, other: usize, shot: &Shot) -> Option<&[Event]> {
    let meets = |event: &Event| event.kind.partner(one) == Some(other);
    let at = shot.events().iter().position(meets)?;
    shot.events().get(..at)
}

/// The number of times that a disc hits a cushion.
fn cushions(disc: usize, events: &[Event]) -> usize {
    let met = |kind| matches!(kind, EventKind::Cushion { disc: met, .. } if met == disc);
    events.iter().filter(|event| met(event.kind)).count()
}

/// Describes a number of cushions in words.
fn in_cushions(count: usize) -> String {
    match count {
        0 => "no cushion".into(),
        _ => counted(count, "cushion"),
    }
}

/// The point on the path of a disc that is nearest to the given point.
fn nearest_on_path(shot: &Shot, disc: usize, point: DVec2) -> DVec2 {
    let distance = |p: &DVec2| p.distance(point);
    shot.path(disc)
        .map(|leg| {
            let along = leg.to - leg.from;
            let share = (point - leg.from).dot(along) / along.length_squared();
            leg.from + share.clamp(0.0, 1.0) * along
        })
        .fold(shot.start(disc).position, |best, next| {
            if distance(&next) < distance(&best) {
                next
            } else {
                best
            }
        })
}
