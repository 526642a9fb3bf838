//! What became of the goals of a level, in words.

use super::goal::{Goal, HitMeasure};
use super::judge::{Judged, Judgement, Observed};
use super::level::Level;
use super::scene::{figures, tidy};
use crate::numbers::{counted, degrees};
use crate::physics::units::mm_from_m;

/// What became of one goal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// Whether it is met.
    pub met: bool,
    /// What happened, in words with numbers.
    pub told: String,
}

impl Judgement {
    /// It in words, a finding for each goal of the level that was judged.
    pub fn told(&self, level: &Level) -> Vec<Finding> {
        let judged = level.goals.iter().zip(&self.0);
        let found = judged.map(|(goal, judged)| Finding {
            met: judged.met,
            told: told(level, goal, judged),
        });
        found.collect()
    }
}

fn told(level: &Level, goal: &Goal, Judged { met, seen }: &Judged) -> String {
    let name = |disc: &usize| level.scene.name(*disc);
    let pocket = level.scene.board.pocket_diameter;
    match (goal, seen) {
        (_, Observed::NotFallen(disc, Some(near))) => {
            let short = mm_from_m(near - 0.5 * pocket).max(0.0);
            let name = name(disc);
            format!("{name} came within {} mm of a pocket", figures(short))
        }
        (_, Observed::NotFallen(_, None)) => "there are no pockets".into(),
        (_, Observed::FellInOrder(order)) => {
            let names: Vec<_> = order.iter().map(name).collect();
            let order = if *met { "" } else { ": the wrong order" };
            format!("{} fell{order}", names.join(", then "))
        }
        (Goal::Keep { disc } | Goal::Rest { disc, .. }, Observed::Fell) => {
            format!("{} fell into a pocket", name(disc))
        }
        (Goal::Keep { disc }, _) => format!("{} did not fall into a pocket", name(disc)),
        (Goal::Untouched { disc, .. }, Observed::HitBy(by)) => {
            format!("{} hit {}", name(by), name(disc))
        }
        (Goal::Untouched { disc, by: Some(by) }, _) => did_not_hit(&name(by), &name(disc)),
        (Goal::Untouched { disc, by: None }, _) => format!("nothing hit {}", name(disc)),
        (Goal::Hit { disc, by, least }, Observed::Cushions(met)) => {
            let hit = format!("{} hit {}", name(by), name(disc));
            match least {
                0 => hit,
                _ => format!("{hit} off {}", in_cushions(*met)),
            }
        }
        (Goal::Hit { disc, by, .. }, _) => did_not_hit(&name(by), &name(disc)),
        (Goal::Rest { disc, .. }, Observed::NeverResting) => {
            format!("{} never came to rest", name(disc))
        }
        (Goal::Rest { disc, circle } | Goal::Pass { disc, circle }, Observed::Point(point)) => {
            let rests = matches!(goal, Goal::Rest { .. });
            let came = if rests { "came to rest" } else { "passed" };
            let place = if *met {
                let off = figures(mm_from_m(circle.centre.distance(*point)));
                format!("{off} mm from the middle of its circle")
            } else {
                let off = figures(circle.outside_mm(*point));
                format!("{off} mm outside its circle")
            };
            format!("{} {came} {place}", name(disc))
        }
        (Goal::Bank { disc, target, .. }, seen) => {
            let (name, target) = (name(disc), name(target));
            match seen {
                Observed::OtherFirst => format!("{name} met another disc first"),
                Observed::Cushions(0) => format!("{name} met {target} without a cushion"),
                Observed::Cushions(met) => format!("{name} met {target} off {}", in_cushions(*met)),
                _ => format!("{name} never met {target}"),
            }
        }
        (Goal::Cushions { disc, .. }, Observed::Cushions(met)) => {
            format!("{} met {}", name(disc), in_cushions(*met))
        }
        (Goal::FirstHit { measure, range }, Observed::Number(number)) => {
            let name = measure.disc().as_ref().map_or(String::new(), name);
            let told = match measure {
                HitMeasure::Speed(_) => format!("{name} left the hit at {} m/s", tidy(*number)),
                HitMeasure::Turn(_) => format!("{name} left at {}", degrees(*number)),
                HitMeasure::Separation => format!("they went {} apart", degrees(*number)),
                HitMeasure::Energy(_) => {
                    format!("{name} took {} % of the energy", tidy(100.0 * number))
                }
            };
            match met {
                true => told,
                false => format!("{told}, wanted {}", measure.between(range)),
            }
        }
        (Goal::FirstHit { measure, .. }, seen) => match (measure.disc().as_ref().map(name), seen) {
            (None, Observed::NoDirection) => "one of the two stopped, so there is no angle".into(),
            (Some(name), Observed::NoDirection) => {
                format!("{name} stopped, so it has no direction")
            }
            (Some(name), _) => format!("{name} had no part in a first hit"),
            (None, _) => "no disc was hit".into(),
        },
        _ => "no disc was hit".into(),
    }
}

fn did_not_hit(one: &str, other: &str) -> String {
    format!("{one} did not hit {other}")
}

/// A number of cushions in words.
fn in_cushions(count: usize) -> String {
    match count {
        0 => "no cushion".into(),
        _ => counted(count, "cushion"),
    }
}
