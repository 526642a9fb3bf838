//! The centre-of-mass frame: its speed, the scattering angle Θ in this frame, and the corresponding
//! angle in the laboratory frame.

use std::f64::consts::PI;

use super::prelude::*;
use crate::physics::frames::{cm_scattering_angle, lab_scattering_angle};

const TOPIC: &str = "centre-of-mass";

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let first = dice.coin();
    let hit = |pieces: &[Pieces], dice: &mut Dice| {
        HitDraws(pieces, 10..=80, NO_LOSS).draw(difficulty, dice)
    };
    match (difficulty, first) {
        (Difficulty::Easy, true) => turn_from_angle(&hit(ALL, dice)?),
        (Difficulty::Easy, false) => speed_of_centre(&hit(UNEQUAL, dice)?, None),
        (Difficulty::Middle, true) => {
            let hit = hit(ALL, dice)?;
            turn_from_offset(&hit, 2 + dice.below(8))
        }
        (Difficulty::Middle, false) => {
            let hit = hit(UNEQUAL, dice)?;
            let speed = f64::from(1 + dice.below(4));
            speed_of_centre(&hit, Some(if dice.coin() { speed } else { -speed }))
        }
        (Difficulty::Hard, striker) => {
            let turn_deg = f64::from(10 * (4 + dice.below(11)));
            let hit = hit(UNEQUAL, dice)?;
            let hit = hit.at_angle(hit.side() * (90.0 - turn_deg / 2.0));
            if striker {
                striker_on_the_board(&hit, turn_deg)
            } else {
                target_on_the_board(&hit, turn_deg)
            }
        }
    }
}

/// The impact angle, with enough digits for the printed value to give Θ = 180° − 2α as printed.
fn shown(alpha: f64) -> Intermediate {
    Intermediate::angle(alpha, |alpha| degrees(PI - 2.0 * alpha))
}

/// The explanation of Θ = 180° − 2α.
fn why_turn(alpha: f64, turn: f64) -> String {
    format!(
        "In the centre-of-mass frame only the component along the line of impact is reversed. So Θ = 180° − 2 × {}° = {}.",
        shown(alpha),
        degrees(turn)
    )
}

/// A question that asks for Θ.
fn turn(hit: &Hit, turn: f64) -> Outline {
    let picture = Illustration::before(hit.collision(), Markings::given(hit));
    let on_board = hit
        .outcome()
        .theta1
        .map(|theta1| deg_from_rad(theta1.abs()));
    Outline::with_text(hit, in_short(hit), picture)
        .named("turn", TOPIC)
        .ask(
            "No energy is lost. By what angle Θ is the striker deflected in the centre-of-mass \
             frame?",
        )
        .number(Measure::Angle, deg_from_rad(turn))
        .wrong(
            DoubleAngleForgotten,
            180.0 - deg_from_rad(hit.alpha().abs()),
        )
        .says("Your answer is close to 180° − α. But α must be subtracted twice.")
        .wrong(FramesMixed, on_board)
        .says("That is the striker's deflection in the laboratory frame.")
}

/// Asks for Θ, given α.
fn turn_from_angle(hit: &Hit) -> Option<Question> {
    let alpha = hit.alpha().abs();
    let angle = cm_scattering_angle(alpha, hit.restitution)?;
    turn(hit, angle)
        .wrong(CopiedAngle, deg_from_rad(alpha))
        .says(
            "You answered α itself. But α describes where the discs touch, not how far the striker \
             is deflected.",
        )
        .why(why_turn(alpha, angle))
}

/// Asks for Θ, given an offset that is a whole number of tenths of r₁ + r₂, rounded to 0.1 mm.
fn turn_from_offset(hit: &Hit, tenths: u32) -> Option<Question> {
    let reach_mm = hit.reach_mm();
    let offset_mm = (reach_mm * f64::from(tenths)).round() / 10.0;
    let hit = Hit {
        given: ImpactPoint::Offset {
            offset_mm: hit.side() * offset_mm,
        },
        ..*hit
    };
    let alpha = hit.alpha().abs();
    let angle = cm_scattering_angle(alpha, hit.restitution)?;
    turn(&hit, angle)
        .wrong(OffsetAsAngle, 180.0 * (1.0 - offset_mm / reach_mm))
        .says("You made the angle proportional to the offset, which is proportional to sin α.")
        .why(format!(
            "sin α = {} / {}, so α = {}°. {}",
            bare_millimetres(offset_mm),
            bare_millimetres(reach_mm),
            shown(alpha),
            why_turn(alpha, angle)
        ))
}

/// Asks for the speed of the centre of mass. The target is at rest or moves parallel to the
/// striker's path, in the striker's direction if `target_speed` is positive.
fn speed_of_centre(hit: &Hit, target_speed: Option<f64>) -> Option<Question> {
    let name = hit.pieces.target_name();
    let [m1, m2] = hit.masses_g();
    let (u1, u2) = (hit.speed, target_speed.unwrap_or(0.0));
    // If both discs move in the same direction, the striker must be faster in order to catch up.
    if u2 >= u1 {
        return None;
    }
    let forward = hit.collision().u1.try_normalize()?;
    let collision = Collision {
        u2: u2 * forward,
        ..hit.collision()
    };
    let velocity = collision.centre_of_mass_velocity();
    let along = velocity.dot(forward);
    let exchanged = (m2 * u1 + m1 * u2) / (m1 + m2);
    // Answers are compared by their ratio, which is meaningless for a speed near 0.
    if along.abs() < 0.1 || exchanged.abs() < 0.1 || (u1 + u2).abs() < 0.1 {
        return None;
    }
    let [m1_words, m2_words, u1_words, u2_words] = [m1, m2, u1, u2.abs()].map(significant);
    let (sign, way) = if u2 > 0.0 {
        ("+", "ahead of the striker in the same direction")
    } else {
        ("−", "towards the striker")
    };
    let (setting, momentum) = match target_speed {
        None => (
            format!("{}.", hit.who("striker", &hit.hits())),
            format!("{m1_words} × {u1_words}"),
        ),
        Some(_) => (
            format!(
                "A striker of {m1_words} g moves at {u1_words} m/s, and a {name} of {m2_words} g \
                 at {u2_words} m/s {way}."
            ),
            format!("{m1_words} × {u1_words} {sign} {m2_words} × {u2_words}"),
        ),
    };
    let backward = if along < 0.0 {
        format!(" The minus sign means motion in the {name}'s direction.")
    } else {
        String::new()
    };
    let picture = Illustration::before(collision, Markings::FIGURES);
    Outline::with_text(hit, setting, picture)
        .named("centre-speed", TOPIC)
        .ask("How fast does their centre of mass move?")
        .figure("target_speed", u2)
        .number(Measure::Speed, velocity.length())
        .wrong(HalfwayCentre, (u1 + u2).abs() / 2.0)
        .says("You used the mean of the two velocities. But the heavier disc counts for more.")
        .wrong(UpsideDown, exchanged.abs())
        .says("You swapped the two masses. The heavier disc counts for more.")
        .wrong(ScalarMomentum, (m1 * u1 + m2 * u2.abs()) / (m1 + m2))
        .says(
            "You added the momenta as plain numbers. They point in opposite directions, so one is \
             subtracted.",
        )
        .why(format!(
            "The velocity of the centre of mass is the total momentum divided by the total mass: \
             ({momentum}) g m/s / {} g = {} m/s.{backward}",
            significant(m1 + m2),
            true_minus(&significant(along))
        ))
}

/// A question that gives Θ and asks for an angle in the laboratory frame.
fn on_the_board(hit: &Hit, turn_deg: f64, asked: &str, text: &str, mixed: &str) -> Outline {
    let with_text = format!(
        "{}, and no energy is lost. In the centre-of-mass frame both discs are deflected by Θ = \
         {}.",
        hit.who("striker", "hits"),
        in_degrees(turn_deg)
    );
    Outline::with_text(hit, with_text, unmarked(hit))
        .named(asked, TOPIC)
        .ask(text)
        .figure("turn_deg", turn_deg)
        .wrong(FramesMixed, turn_deg)
        .says(format!("You used Θ for {mixed}."))
}

/// The striker's deflection in the laboratory frame, in degrees.
fn theta1_deg(hit: &Hit, turn_deg: f64) -> Option<f64> {
    let [m1, m2] = hit.pieces.discs().map(|disc| disc.mass);
    lab_scattering_angle(rad_from_deg(turn_deg), m1, m2).map(deg_from_rad)
}

/// Asks for the striker's angle, given Θ.
fn striker_on_the_board(hit: &Hit, turn_deg: f64) -> Option<Question> {
    let text = "By what angle is the striker deflected in the laboratory frame?";
    let theta = rad_from_deg(turn_deg);
    let theta1 = |ratio: f64| degrees(theta.sin().atan2(theta.cos() + ratio));
    let ratio = Intermediate::new(hit.mass_ratio(), theta1);
    on_the_board(hit, turn_deg, "theta1", text, "the striker's deflection")
        .number(Measure::Angle, theta1_deg(hit, turn_deg)?)
        .wrong(HalfwayCentre, turn_deg / 2.0)
        .says("You used half of Θ. That is right only for equal masses.")
        .wrong(UpsideDown, theta1_deg(&hit.exchanged(), turn_deg))
        .says("You swapped the two masses: a heavier striker is deflected less.")
        .why(format!(
            "In the centre-of-mass frame the striker's speed is m₂u / (m₁ + m₂); that frame \
             moves at m₁u / (m₁ + m₂). So tan θ₁ = sin Θ / (cos Θ + m₁ / m₂) = sin {theta}° / (cos \
             {theta}° + {ratio}), and θ₁ = {}.",
            theta1(ratio.value),
            theta = bare_degrees(theta),
        ))
}

/// Asks for the target's angle, given Θ.
fn target_on_the_board(hit: &Hit, turn_deg: f64) -> Option<Question> {
    let name = hit.pieces.target_name();
    let text = format!(
        "At what angle to the striker's original direction does the {name} leave in the \
                 laboratory frame?"
    );
    let mixed = format!("the {name}'s direction");
    on_the_board(hit, turn_deg, "theta2", &text, &mixed)
        .number(Measure::Angle, 90.0 - turn_deg / 2.0)
        .wrong(DoubleAngleForgotten, 180.0 - turn_deg)
        .says(format!(
            "Your answer is close to 180° − Θ. In the laboratory frame the {name} leaves at α, which is half of that."
        ))
        .wrong(Swapped, theta1_deg(hit, turn_deg)?)
        .says(format!(
            "That is the striker's angle. The question is about the {name}."
        ))
        .why(format!(
            "The {name} was at rest, so it leaves along the line of impact, at α. As Θ = 180° − 2α, \
             α = 90° − {}° / 2 = {}.",
            bare_degrees(rad_from_deg(turn_deg)),
            in_degrees(90.0 - turn_deg / 2.0)
        ))
}
