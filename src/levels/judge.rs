//! Whether a shot meets the goals of a level, and what came about instead: from the
//! record of the shot alone. In words it is put by `told`.

use glam::DVec2;

use super::goal::{Goal, GoalCircle, HitMeasure};
use super::level::Level;
use crate::physics::angle::angle_between;
use crate::physics::{DiscState, Event, EventKind, Shot};

/// What became of a level's goals, in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement(pub(super) Vec<Judged>);

/// What became of one goal.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Judged {
    /// Whether it is met.
    pub(super) met: bool,
    /// What was seen of what it asks for.
    pub(super) seen: Observed,
}

/// What was seen of what a goal asks for.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Observed {
    /// It did not come about.
    Nothing,
    /// The disc fell into a pocket.
    Fell,
    /// The discs fell in this order.
    FellInOrder(Vec<usize>),
    /// This disc did not fall; its centre came this near to a pocket's, in metres, if
    /// there are pockets.
    NotFallen(usize, Option<f64>),
    /// This disc hit it.
    HitBy(usize),
    /// It came about after the disc had met a cushion so many times.
    Cushions(usize),
    /// The disc met another than its target first.
    OtherFirst,
    /// The disc never came to rest.
    NeverResting,
    /// Where its centre was.
    Point(DVec2),
    /// What was measured, in the unit of the goal's range.
    Number(f64),
    /// It has no direction, because a disc stopped.
    NoDirection,
}

impl Judgement {
    /// Whether all goals are met.
    pub fn won(&self) -> bool {
        self.0.iter().all(|judged| judged.met)
    }

    /// How many goals are met.
    pub fn met(&self) -> usize {
        self.0.iter().filter(|judged| judged.met).count()
    }
}

/// Judges a shot of a level.
pub fn judge(level: &Level, shot: &Shot) -> Judgement {
    Judgement(level.goals.iter().map(|goal| goal.judge(shot)).collect())
}

/// Whether a shot of a level meets all goals.
pub(super) fn wins(level: &Level, shot: &Shot) -> bool {
    level.goals.iter().all(|goal| goal.judge(shot).met)
}

impl Goal {
    fn judge(&self, shot: &Shot) -> Judged {
        let (met, seen) = match self {
            Self::Pocket { discs } => pocketed(discs, shot),
            Self::Keep { disc } => match shot.fallen().any(|fallen| fallen == *disc) {
                true => (false, Observed::Fell),
                false => (true, Observed::Nothing),
            },
            Self::Untouched { disc, by } => untouched(*disc, *by, shot),
            Self::Hit { disc, by, least } => match before_meeting(*disc, *by, shot) {
                None => (false, Observed::Nothing),
                Some(before) => counted(cushions(*by, before), *least),
            },
            Self::Rest { disc, circle } => {
                let end = shot.at(*disc, shot.duration());
                match end.state {
                    DiscState::Pocketed => (false, Observed::Fell),
                    DiscState::Moving => (false, Observed::NeverResting),
                    DiscState::Resting => inside(circle, end.position),
                }
            }
            Self::Pass { disc, circle } => {
                inside(circle, nearest_on_path(shot, *disc, circle.centre))
            }
            Self::Bank {
                disc,
                target,
                least,
            } => banked(*disc, *target, *least, shot),
            Self::Cushions { disc, least } => counted(cushions(*disc, shot.events()), *least),
            Self::FirstHit { measure, range } => {
                let hit = FirstImpact::of(shot);
                let seen = hit.and_then(|hit| hit.shows(*measure, shot));
                let seen = seen.unwrap_or(Observed::Nothing);
                let met = matches!(seen, Observed::Number(number) if range.holds(number));
                (met, seen)
            }
        };
        Judged { met, seen }
    }
}

fn angle(one: DVec2, other: DVec2) -> Observed {
    angle_between(one, other).map_or(Observed::NoDirection, Observed::Number)
}

fn counted(cushions: usize, least: usize) -> (bool, Observed) {
    (cushions >= least, Observed::Cushions(cushions))
}

fn inside(circle: &GoalCircle, point: DVec2) -> (bool, Observed) {
    (circle.outside_mm(point) <= 0.0, Observed::Point(point))
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

    /// What it shows of a measure; `None` where the disc had no part in it.
    fn shows(&self, measure: HitMeasure, shot: &Shot) -> Option<Observed> {
        Some(match measure {
            HitMeasure::Speed(disc) => Observed::Number(self.after(disc)?.length()),
            HitMeasure::Turn(disc) => angle(self.before, self.after(disc)?),
            HitMeasure::Separation => angle(self.afters[0], self.afters[1]),
            HitMeasure::Energy(disc) => Observed::Number(self.energy_share(disc, shot)?),
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

fn pocketed(discs: &[usize], shot: &Shot) -> (bool, Observed) {
    let stayed = |disc: &&usize| shot.fallen().all(|fallen| fallen != **disc);
    if let Some(&disc) = discs.iter().find(stayed) {
        let near = shot
            .board()
            .pockets()
            .map(|hole| nearest_on_path(shot, disc, hole).distance(hole))
            .min_by(f64::total_cmp);
        return (false, Observed::NotFallen(disc, near));
    }
    let order: Vec<_> = shot.fallen().filter(|disc| discs.contains(disc)).collect();
    (order == discs, Observed::FellInOrder(order))
}

/// The events before two discs first meet; `None` if they never do.
fn before_meeting(one: usize, other: usize, shot: &Shot) -> Option<&[Event]> {
    let meets = |event: &Event| event.kind.partner(one) == Some(other);
    let at = shot.events().iter().position(meets)?;
    shot.events().get(..at)
}

/// How many times a disc meets a cushion.
fn cushions(disc: usize, events: &[Event]) -> usize {
    let met = |kind| matches!(kind, EventKind::Cushion { disc: met, .. } if met == disc);
    events.iter().filter(|event| met(event.kind)).count()
}

fn untouched(disc: usize, by: Option<usize>, shot: &Shot) -> (bool, Observed) {
    let hit_by = match by {
        Some(by) => before_meeting(disc, by, shot).map(|_| by),
        None => (shot.events().iter()).find_map(|event| event.kind.partner(disc)),
    };
    match hit_by {
        Some(by) => (false, Observed::HitBy(by)),
        None => (true, Observed::Nothing),
    }
}

fn banked(disc: usize, target: usize, least: usize, shot: &Shot) -> (bool, Observed) {
    let partners = shot.events().iter().map(|event| event.kind.partner(disc));
    match partners
        .enumerate()
        .find_map(|(at, other)| Some((at, other?)))
    {
        None => (false, Observed::Nothing),
        Some((at, other)) if other == target => {
            counted(cushions(disc, &shot.events()[..at]), least)
        }
        Some(_) => (false, Observed::OtherFirst),
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
