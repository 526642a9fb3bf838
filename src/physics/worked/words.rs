//! The result of a collision in plain words.

use std::f64::consts::TAU;

use super::number::{beside, degrees, number};
use super::rough;
use crate::physics::{Bond, Collision, CollisionOutcome, Frame, Meeting, Rims};

/// How close to 90° counts as a right angle, in degrees.
const SQUARE: f64 = 1e-9;

pub(super) fn result(c: &Collision, after: &CollisionOutcome) -> String {
    match after.meeting {
        Meeting::Miss if c.relative_velocity().length() <= 0.0 => {
            "Both discs have the same velocity, so they never collide and nothing changes."
                .to_owned()
        }
        Meeting::Miss => "A miss: the offset is larger than the sum of the radii, so the discs \
                          pass each other and nothing changes."
            .to_owned(),
        Meeting::Graze => "A graze: the discs just touch, with no relative velocity along the \
                           line of impact, so nothing changes."
            .to_owned(),
        Meeting::Hit if c.bond == Bond::Stick => stuck(after),
        Meeting::Hit if !c.rims.is_plain() => [
            target(c, after),
            striker(c, after),
            rough::in_words(c, after),
            parting(c, after),
        ]
        .join(" "),
        Meeting::Hit => [target(c, after), striker(c, after), parting(c, after)].join(" "),
    }
}

fn stuck(after: &CollisionOutcome) -> String {
    let speed = after.v1.length();
    let going = if speed > 0.0 {
        format!("moves on at {} m/s", number(speed))
    } else {
        "comes to rest".to_owned()
    };
    let turning = if after.energy_rotation > 0.0 {
        format!(
            ", and they rotate about it at {} rad/s, {} times a second",
            number(after.spin.abs()),
            number(after.spin.abs() / TAU)
        )
    } else {
        String::new()
    };
    format!("The two discs move on together: their centre of mass {going}{turning}.")
}

fn target(c: &Collision, after: &CollisionOutcome) -> String {
    let speed = number(after.v2.length());
    match after.theta2 {
        _ if after.v2.length() <= 0.0 => "The target is brought to rest.".to_owned(),
        Some(angle) => {
            let course = course(angle, "right", "left", "the striker's");
            let pushed = match (c.u2.length() <= 0.0, after.friction_impulse != 0.0) {
                (true, false) => "was at rest and is pushed along the line of impact; it ",
                (true, true) => {
                    "was at rest, is pushed along the line of impact and dragged to one side of it \
                     by friction; it "
                }
                (false, _) => "",
            };
            format!("The target {pushed}leaves at {speed} m/s, {course}.")
        }
        None => format!("The target leaves at {speed} m/s."),
    }
}

fn striker(c: &Collision, after: &CollisionOutcome) -> String {
    let speed = number(after.v1.length());
    match after.theta1 {
        _ if after.v1.length() <= 0.0 => {
            "The striker stops: it no longer has a direction, so θ₁ and the angle between the paths \
             are undefined."
                .to_owned()
        }
        Some(angle) => format!(
            "The striker leaves at {speed} m/s, {}.",
            course(angle, "left", "right", "its")
        ),
        None if c.u1.length() <= 0.0 => format!(
            "The striker was at rest and leaves at {speed} m/s; without an original direction \
             there is no scattering angle."
        ),
        None => format!("The striker leaves at {speed} m/s."),
    }
}

/// The direction of a disc relative to the striker's original path.
fn course(angle: f64, positive: &str, negative: &str, whose: &str) -> String {
    match beside(angle.to_degrees().abs(), 180.0).as_str() {
        "0" => format!("straight on in {whose} original direction"),
        "180" => format!("straight back along {whose} original path"),
        _ => format!(
            "{} to the {} of {whose} original direction",
            degrees(angle.abs()),
            if angle > 0.0 { positive } else { negative }
        ),
    }
}

/// The angle between the paths, and what it shows about the masses.
fn parting(c: &Collision, after: &CollisionOutcome) -> String {
    let Some(separation) = after.separation else {
        return String::new();
    };
    let parted = format!("The angle between their paths is {}", degrees(separation));
    if after.friction_impulse != 0.0 {
        let rims = Rims::default();
        let smooth = Collision { rims, ..*c }.outcome().separation;
        return match smooth {
            Some(smooth) => format!(
                "{parted}; with smooth rims it would be {}.",
                degrees(smooth)
            ),
            None => format!("{parted}."),
        };
    }
    let head_on = c.offset.abs() <= 0.0;
    if c.u2.length() > 0.0 {
        let seen = Frame::Target.view(c).outcome().separation;
        return match seen {
            Some(seen) if !head_on => {
                let (angle, reason) = (degrees(seen), reason(c, seen));
                format!(
                    "{parted}. In the frame in which the target was at rest it is {angle}: \
                     {reason}."
                )
            }
            _ => format!("{parted}."),
        };
    }
    if head_on {
        return format!("{parted}, because all motion is on one line.");
    }
    format!("{parted}: {}.", reason(c, separation))
}

/// Why the angle between the paths has this size, in a frame in which the target was at rest.
fn reason(c: &Collision, separation: f64) -> String {
    let off = separation.to_degrees() - 90.0;
    let elastic = c.restitution >= 1.0;
    let target = if elastic {
        "the target's".to_owned()
    } else {
        format!(
            "{} times that of the target, which is e m₂",
            number(c.restitution)
        )
    };
    if off.abs() <= SQUARE {
        if elastic {
            "a right angle, as always for equal masses if no energy is lost".to_owned()
        } else {
            format!("a right angle, because the striker's mass is {target}")
        }
    } else if off > 0.0 {
        format!("more than a right angle, because the striker's mass is less than {target}")
    } else if c.restitution <= 0.0 {
        "less than a right angle, as always at e = 0".to_owned()
    } else {
        format!("less than a right angle, because the striker's mass is more than {target}")
    }
}
