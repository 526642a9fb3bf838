//! The frame of the centre of mass: how fast it moves, by what angle Θ it sees both
//! turned, and what that is on the board.

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

/// Why Θ = 180° − 2α.
fn why_turn(alpha: f64, turn: f64) -> String {
    format!(
        "Seen from there the part along the line of impact is turned round and the part across \
         stays, as off a wall. So Θ = 180 - 2 × {} = {}.",
        bare_degrees(alpha),
        degrees(turn)
    )
}

/// Θ asked for.
fn turn(hit: &Hit, turn: f64) -> Outline {
    let picture = Illustration::before(hit.collision(), Markings::given(hit));
    let on_board = hit
        .outcome()
        .theta1
        .map(|theta1| deg_from_rad(theta1.abs()));
    Outline::told(hit, in_short(hit), picture)
        .named("turn", TOPIC)
        .ask(
            "No energy is lost. By what angle Θ does the hit turn the striker as seen from their \
             centre of mass?",
        )
        .number(Measure::Angle, deg_from_rad(turn))
        .wrong(
            DoubleAngleForgotten,
            180.0 - deg_from_rad(hit.alpha().abs()),
        )
        .says("You took α off 180° once. It counts twice: on the way in and on the way out.")
        .wrong(FramesMixed, on_board)
        .says(
            "That is by how much the striker turns on the board. The centre of mass moves, and \
             sees another angle.",
        )
}

/// Θ from α.
fn turn_from_angle(hit: &Hit) -> Option<Question> {
    let alpha = hit.alpha().abs();
    let angle = cm_scattering_angle(alpha, hit.restitution)?;
    turn(hit, angle)
        .wrong(CopiedAngle, deg_from_rad(alpha))
        .says("You took α itself. It says where they touch, not by how much they turn.")
        .why(why_turn(alpha, angle))
}

/// Θ from an offset of so many tenths of r₁ + r₂, which makes the figures easy.
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
        .says(
            "You let the angle shrink in step with the offset. It is the sine of α that goes with \
             the offset.",
        )
        .why(format!(
            "sin α = {} / {}: α = {}. {}",
            bare_millimetres(offset_mm),
            bare_millimetres(reach_mm),
            degrees(alpha),
            why_turn(alpha, angle)
        ))
}

/// The speed of the centre of mass; the target at rest, or moving along the same line,
/// the same way if `target_speed` is positive.
fn speed_of_centre(hit: &Hit, target_speed: Option<f64>) -> Option<Question> {
    let name = hit.pieces.target_name();
    let [m1, m2] = hit.masses_g();
    let (u1, u2) = (hit.speed, target_speed.unwrap_or(0.0));
    // On the same way the striker has to catch up.
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
    // A centre that hardly moves has no ratio to be off by.
    if along.abs() < 0.1 || exchanged.abs() < 0.1 || (u1 + u2).abs() < 0.1 {
        return None;
    }
    let [m1_words, m2_words, u1_words, u2_words] = [m1, m2, u1, u2.abs()].map(significant);
    let (sign, way) = if u2 > 0.0 {
        ("+", "ahead of it, the same way")
    } else {
        ("-", "towards it")
    };
    let (setting, momentum) = match target_speed {
        None => (
            format!("{} at {u1_words} m/s.", hit.who("striker", "hits")),
            format!("{m1_words} × {u1_words}"),
        ),
        Some(_) => (
            format!(
                "A striker of {m1_words} g moves at {u1_words} m/s, a {name} of {m2_words} g at \
                 {u2_words} m/s {way}."
            ),
            format!("{m1_words} × {u1_words} {sign} {m2_words} × {u2_words}"),
        ),
    };
    let backward = if along < 0.0 {
        format!(" It moves the way the {name} came, which brings more momentum.")
    } else {
        String::new()
    };
    let picture = Illustration::before(collision, Markings::FIGURES);
    Outline::told(hit, setting, picture)
        .named("centre-speed", TOPIC)
        .ask("How fast does their centre of mass move?")
        .figure("target_speed", u2)
        .number(Measure::Speed, velocity.length())
        .wrong(HalfwayCentre, (u1 + u2).abs() / 2.0)
        .says("You took the middle between the two velocities. The heavier disc counts for more.")
        .wrong(UpsideDown, exchanged.abs())
        .says("You had the masses the other way round: the centre moves more like the heavier one.")
        .wrong(ScalarMomentum, (m1 * u1 + m2 * u2.abs()) / (m1 + m2))
        .says(
            "You added the momenta as plain numbers. They point in opposite directions, so one is \
             subtracted.",
        )
        .why(format!(
            "All the momentum, {momentum} g m/s, belongs to {} g in all: {} m/s.{backward}",
            significant(m1 + m2),
            significant(velocity.length())
        ))
}

/// A question that goes from Θ back to the board.
fn on_the_board(hit: &Hit, turn_deg: f64, asked: &str, text: &str, mixed: &str) -> Outline {
    let told = format!(
        "{}, and no energy is lost. Seen from their centre of mass the hit turns both by Θ = {}.",
        hit.who("striker", "hits"),
        in_degrees(turn_deg)
    );
    Outline::told(hit, told, unmarked(hit))
        .named(asked, TOPIC)
        .ask(text)
        .figure("turn_deg", turn_deg)
        .wrong(FramesMixed, turn_deg)
        .says(format!(
            "You took Θ for {mixed}. It is seen from the centre of mass, which moves over the \
             board."
        ))
}

/// The angle by which the board sees the striker turned, in degrees.
fn theta1_deg(hit: &Hit, turn_deg: f64) -> Option<f64> {
    let (m1, m2) = (hit.pieces.striker().mass, hit.pieces.target().mass);
    lab_scattering_angle(rad_from_deg(turn_deg), m1, m2).map(deg_from_rad)
}

/// From Θ to the striker's angle.
fn striker_on_the_board(hit: &Hit, turn_deg: f64) -> Option<Question> {
    let text = "By what angle is the striker turned on the board?";
    on_the_board(hit, turn_deg, "theta1", text, "the striker")
        .number(Measure::Angle, theta1_deg(hit, turn_deg)?)
        .wrong(HalfwayCentre, turn_deg / 2.0)
        .says(
            "You took half of Θ. That is for equal masses, where the centre of mass lies halfway.",
        )
        .wrong(UpsideDown, theta1_deg(&hit.exchanged(), turn_deg))
        .says("You had the masses the other way round: a heavier striker is turned less.")
        .why(format!(
            "From there the striker has m₂ parts of the speed, the centre itself m₁ parts, \
             straight ahead. Add them: tan θ₁ = sin Θ / (cos Θ + m₁ / m₂), with m₁ / m₂ = {}.",
            significant(hit.mass_ratio())
        ))
}

/// From Θ to the target's angle.
fn target_on_the_board(hit: &Hit, turn_deg: f64) -> Option<Question> {
    let name = hit.pieces.target_name();
    let text =
        format!("At what angle to the striker's old path does the {name} leave on the board?");
    let mixed = format!("the way of the {name}");
    on_the_board(hit, turn_deg, "theta2", &text, &mixed)
        .number(Measure::Angle, 90.0 - turn_deg / 2.0)
        .wrong(DoubleAngleForgotten, 180.0 - turn_deg)
        .says(format!(
            "You took Θ off 180°. On the board the {name} leaves at α, and that is half of it."
        ))
        .wrong(Swapped, theta1_deg(hit, turn_deg)?)
        .says(format!(
            "That is the striker's angle. The {name} has one of its own."
        ))
        .why(format!(
            "The {name} was at rest, so it leaves along the line of impact, at α. As Θ = 180° - \
             2α, that is 90 - {} / 2.",
            bare_degrees(rad_from_deg(turn_deg))
        ))
}
