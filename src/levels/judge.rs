//! Whether a shot meets the goals of a level, and how close it came: from the
//! record of the shot alone.

use glam::DVec2;

use super::goal::{Goal, GoalCircle, between, between_deg};
use super::level::Level;
use super::quantity::Range;
use super::scene::{Scene, figures, pockets, tidy};
use crate::numbers::degrees;
use crate::physics::angle::angle_between;
use crate::physics::units::mm_from_m;
use crate::physics::{DiscState, Event, EventKind, Shot};

/// What became of a level's goals, one finding each, in their order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Judgement(pub Vec<Finding>);

/// What became of one goal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// Whether it is met.
    pub met: bool,
    /// What happened, in words with numbers.
    pub told: String,
}

impl Judgement {
    /// Whether all goals are met.
    pub fn won(&self) -> bool {
        self.0.iter().all(|finding| finding.met)
    }

    /// How many goals are met.
    pub fn met(&self) -> usize {
        self.0.iter().filter(|finding| finding.met).count()
    }
}

/// Judges a shot of a level.
pub fn judge(level: &Level, shot: &Shot) -> Judgement {
    let scene = &level.scene;
    let judged = level.goals.iter().map(|goal| judge_goal(goal, scene, shot));
    Judgement(judged.collect())
}

fn judge_goal(goal: &Goal, scene: &Scene, shot: &Shot) -> Finding {
    let name = |disc: &usize| scene.name(*disc);
    match goal {
        Goal::Pocket { discs } => pocketed(discs, scene, shot),
        Goal::Keep { disc } => {
            let fell = falls(shot).any(|fallen| fallen == *disc);
            let verb = if fell { "fell" } else { "did not fall" };
            finding(!fell, format!("{} {verb} into a pocket", name(disc)))
        }
        Goal::Untouched { disc, by } => untouched(*disc, *by, scene, shot),
        Goal::Hit { disc, by, least } => hit(*disc, *by, *least, scene, shot),
        Goal::Rest { disc, circle } => {
            let end = shot.at(*disc, shot.duration());
            match end.state {
                DiscState::Pocketed => finding(false, format!("{} fell into a pocket", name(disc))),
                DiscState::Moving => finding(false, format!("{} never came to rest", name(disc))),
                DiscState::Resting => inside(circle, end.position, &name(disc), "came to rest"),
            }
        }
        Goal::Pass { disc, circle } => {
            let nearest = nearest_on_path(shot, *disc, circle.centre);
            inside(circle, nearest, &name(disc), "passed")
        }
        Goal::Bank {
            disc,
            target,
            least,
        } => banked(*disc, *target, *least, scene, shot),
        Goal::Cushions { disc, least } => {
            let met = cushions(*disc, shot.events());
            finding(
                met >= *least,
                format!("{} met {}", name(disc), counted(met)),
            )
        }
        Goal::Speed { disc, range } => measured(shot, |hit| {
            let speed = hit.after(*disc)?.length();
            let told = format!("{} left the hit at {} m/s", name(disc), tidy(speed));
            Some(compared(speed, range, told, || between(range, " m/s")))
        })
        .unwrap_or_else(|| unhit(&name(disc))),
        Goal::Turn { disc, range } => measured(shot, |hit| {
            let after = hit.after(*disc)?;
            Some(match angle_between(hit.before, after) {
                Some(angle) => {
                    let told = format!("{} left at {}", name(disc), degrees(angle));
                    compared(angle, range, told, || between_deg(range))
                }
                None => finding(
                    false,
                    format!("{} stopped, so it has no direction", name(disc)),
                ),
            })
        })
        .unwrap_or_else(|| unhit(&name(disc))),
        Goal::Separation { range } => measured(shot, |hit| {
            let [a, b] = hit.afters;
            Some(match angle_between(a, b) {
                Some(angle) => {
                    let told = format!("they went {} apart", degrees(angle));
                    compared(angle, range, told, || between_deg(range))
                }
                None => finding(false, "one of the two stopped, so there is no angle".into()),
            })
        })
        .unwrap_or_else(|| finding(false, "no disc was hit".into())),
        Goal::Energy { disc, range } => measured(shot, |hit| {
            let share = hit.energy_share(*disc, shot)?;
            let told = format!(
                "{} took {} % of the energy",
                name(disc),
                tidy(100.0 * share)
            );
            let wanted = || between(&range.scaled(100.0), " %");
            Some(compared(share, range, told, wanted))
        })
        .unwrap_or_else(|| unhit(&name(disc))),
    }
}

fn finding(met: bool, told: String) -> Finding {
    Finding { met, told }
}

fn unhit(name: &str) -> Finding {
    finding(false, format!("{name} had no part in a first hit"))
}

/// A measured number against its bounds.
fn compared(number: f64, range: &Range, told: String, wanted: impl Fn() -> String) -> Finding {
    if range.holds(number) {
        finding(true, told)
    } else {
        finding(false, format!("{told}, wanted {}", wanted()))
    }
}

/// The first time two discs meet.
struct FirstImpact {
    discs: [usize; 2],
    /// Velocity of body 1, the disc that was set off, before.
    before: DVec2,
    /// The disc that was set off.
    body1: usize,
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
                // The other is at rest.
                let first = before[0].length_squared() >= before[1].length_squared();
                let moving = usize::from(!first);
                Some(Self {
                    discs,
                    before: before[moving],
                    body1: discs[moving],
                    afters: after,
                })
            }
            _ => None,
        })
    }

    fn after(&self, disc: usize) -> Option<DVec2> {
        let both = self.discs.into_iter().zip(self.afters);
        both.into_iter()
            .find_map(|(number, after)| (number == disc).then_some(after))
    }

    /// Kinetic energy of a disc after over that of body 1 before.
    fn energy_share(&self, disc: usize, shot: &Shot) -> Option<f64> {
        let mass = |number: usize| shot.discs().get(number).map(|disc| disc.mass);
        let after = mass(disc)? * self.after(disc)?.length_squared();
        let before = mass(self.body1)? * self.before.length_squared();
        (before > 0.0).then(|| after / before)
    }
}

fn measured(shot: &Shot, of: impl Fn(&FirstImpact) -> Option<Finding>) -> Option<Finding> {
    of(&FirstImpact::of(shot)?)
}

/// The discs that fall, in order.
fn falls(shot: &Shot) -> impl Iterator<Item = usize> + '_ {
    shot.events().iter().filter_map(|event| match event.kind {
        EventKind::Pocket { disc, .. } => Some(disc),
        _ => None,
    })
}

fn pocketed(discs: &[usize], scene: &Scene, shot: &Shot) -> Finding {
    if let Some(disc) = discs
        .iter()
        .find(|&disc| falls(shot).all(|fallen| fallen != *disc))
    {
        let near = pockets(shot.board())
            .map(|hole| nearest_on_path(shot, *disc, hole).distance(hole))
            .min_by(f64::total_cmp);
        let name = scene.name(*disc);
        return finding(
            false,
            match near {
                Some(near) => {
                    let short = mm_from_m(near - 0.5 * shot.board().pocket_diameter);
                    format!(
                        "{name} came within {} mm of a pocket",
                        figures(short.max(0.0))
                    )
                }
                None => "there are no pockets".into(),
            },
        );
    }
    let order: Vec<_> = falls(shot).filter(|disc| discs.contains(disc)).collect();
    let names: Vec<_> = order.iter().map(|&disc| scene.name(disc)).collect();
    let fell = format!("{} fell", names.join(", then "));
    if order == discs {
        finding(true, fell)
    } else {
        finding(false, format!("{fell}: the wrong order"))
    }
}

/// The events before two discs first meet; `None` if they never do.
fn before_meeting(one: usize, other: usize, shot: &Shot) -> Option<&[Event]> {
    let at = shot.events().iter().position(|event| match event.kind {
        EventKind::Impact { discs, .. } => discs.contains(&one) && discs.contains(&other),
        _ => false,
    })?;
    shot.events().get(..at)
}

fn hit(disc: usize, by: usize, least: usize, scene: &Scene, shot: &Shot) -> Finding {
    let (name, by_name) = (scene.name(disc), scene.name(by));
    match before_meeting(disc, by, shot) {
        None => finding(false, format!("{by_name} did not hit {name}")),
        Some(_) if least == 0 => finding(true, format!("{by_name} hit {name}")),
        Some(before) => {
            let met = cushions(by, before);
            let told = format!("{by_name} hit {name} off {}", counted(met));
            finding(met >= least, told)
        }
    }
}

/// How many times a disc meets a cushion.
fn cushions(disc: usize, events: &[Event]) -> usize {
    let met = |kind| matches!(kind, EventKind::Cushion { disc: met, .. } if met == disc);
    events.iter().filter(|event| met(event.kind)).count()
}

/// A number of cushions in words.
fn counted(cushions: usize) -> String {
    match cushions {
        0 => "no cushion".into(),
        1 => "1 cushion".into(),
        _ => format!("{cushions} cushions"),
    }
}

fn untouched(disc: usize, by: Option<usize>, scene: &Scene, shot: &Shot) -> Finding {
    let other = shot.events().iter().find_map(|event| match event.kind {
        EventKind::Impact { discs: [a, b], .. } if a == disc => Some(b),
        EventKind::Impact { discs: [a, b], .. } if b == disc => Some(a),
        _ => None,
    });
    let hit = by.map_or(other.is_some(), |by| {
        before_meeting(disc, by, shot).is_some()
    });
    let name = scene.name(disc);
    match (hit, by.or(other)) {
        (true, Some(other)) => finding(false, format!("{} hit {name}", scene.name(other))),
        (_, _) => match by {
            Some(by) => finding(true, format!("{} did not hit {name}", scene.name(by))),
            None => finding(true, format!("nothing hit {name}")),
        },
    }
}

fn banked(disc: usize, target: usize, least: usize, scene: &Scene, shot: &Shot) -> Finding {
    let (name, target_name) = (scene.name(disc), scene.name(target));
    let mut cushions = 0;
    for event in shot.events() {
        match event.kind {
            EventKind::Cushion { disc: met, .. } if met == disc => cushions += 1,
            EventKind::Impact { discs, .. } if discs.contains(&disc) => {
                return if !discs.contains(&target) {
                    finding(false, format!("{name} met another disc first"))
                } else if cushions == 0 {
                    finding(false, format!("{name} met {target_name} without a cushion"))
                } else {
                    let told = format!("{name} met {target_name} off {}", counted(cushions));
                    finding(cushions >= least, told)
                };
            }
            _ => {}
        }
    }
    finding(false, format!("{name} never met {target_name}"))
}

fn inside(circle: &GoalCircle, point: DVec2, name: &str, verb: &str) -> Finding {
    let outside = circle.outside_mm(point);
    if outside <= 0.0 {
        let off = figures(mm_from_m(circle.centre.distance(point)));
        finding(
            true,
            format!("{name} {verb} {off} mm from the middle of the circle"),
        )
    } else {
        finding(
            false,
            format!("{name} {verb} {} mm outside the circle", figures(outside)),
        )
    }
}

/// The point of a disc's way that is nearest to a point.
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
