//! The frame of the centre of mass: how fast it moves, by what angle Θ it sees both
//! turned, and what that is on the board.

use std::collections::BTreeMap;

use glam::DVec2;
use serde_json::{Map, Value, json};

use super::in_short::{in_short, who};
use super::setting::{Setting, more, number, wrong};
use super::where_to::figures;
use crate::physics::frames::{cm_scattering_angle, lab_scattering_angle};
use crate::physics::units::{deg_from_rad, g_from_kg, rad_from_deg};
use crate::physics::{Collision, Outcome};
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::catalogue::{
    DOUBLE_ANGLE_FORGOTTEN, FRAMES_MIXED, HALFWAY_CENTRE, SCALAR_MOMENTUM, UPSIDE_DOWN,
};
use crate::quiz::misconceptions::{COPIED_ANGLE, OFFSET_AS_ANGLE, SWAPPED};
use crate::quiz::words::{bare_degrees, bare_millimetres, degrees, significant};
use crate::quiz::{
    Difficulty, Family, Form, Hit, Illustration, Markings, Measure, Pieces, Placement, Question,
    WrongAnswer,
};

const ALL: [Pieces; 3] = [Pieces::Equal, Pieces::Tournament, Pieces::Marbles];
const UNEQUAL: [Pieces; 2] = [Pieces::Tournament, Pieces::Marbles];

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let first = dice.coin();
    let question = match (difficulty, first) {
        (Difficulty::Easy, true) => turn_from_angle(&hit(&ALL, difficulty, dice)?),
        (Difficulty::Easy, false) => speed_of_centre(&hit(&UNEQUAL, difficulty, dice)?, None),
        (Difficulty::Middle, true) => turn_from_offset(&by_offset(difficulty, dice)?),
        (Difficulty::Middle, false) => {
            let hit = hit(&UNEQUAL, difficulty, dice)?;
            let speed = f64::from(1 + dice.below(4));
            speed_of_centre(&hit, Some(if dice.coin() { speed } else { -speed }))
        }
        (Difficulty::Hard, striker) => on_the_board(difficulty, striker, dice),
    }?;
    Some(Question {
        difficulty,
        ..question
    })
}

fn hit(pieces: &[Pieces], difficulty: Difficulty, dice: &mut Dice) -> Option<Hit> {
    let setting = Setting {
        pieces,
        fives_deg: 10..=80,
        restitutions: &[1.0],
    };
    setting.draw(difficulty, dice)
}

/// A hit whose offset is a whole tenth of r₁ + r₂, which makes the figures easy.
fn by_offset(difficulty: Difficulty, dice: &mut Dice) -> Option<Hit> {
    let hit = hit(&ALL, difficulty, dice)?;
    let tenths = f64::from(2 + dice.below(8));
    Some(Hit {
        given: Placement::Offset {
            offset_mm: hit.side() * (hit.reach_mm() * tenths).round() / 10.0,
        },
        ..hit
    })
}

/// What is asked about a hit.
struct Asked {
    id: &'static str,
    text: String,
    quantity: Measure,
    truth: f64,
    beliefs: Vec<Option<WrongAnswer>>,
    why: String,
    more: Map<String, Value>,
}

fn question(hit: &Hit, target_velocity: DVec2, shown: Markings, asked: Asked) -> Question {
    let form = Form::Number {
        quantity: asked.quantity,
        truth: asked.truth,
    };
    let mut figures = figures(hit);
    figures.extend(more([("asked", json!(asked.id))]));
    figures.extend(asked.more);
    Question {
        family: Family::CentreOfMass,
        difficulty: Difficulty::Middle,
        topic: "centre-of-mass".into(),
        text: asked.text,
        picture: Illustration::Before {
            collision: Collision {
                u2: target_velocity,
                ..hit.collision()
            },
            shown,
        },
        beliefs: wrong(&form, asked.beliefs),
        replies: BTreeMap::new(),
        form,
        why: asked.why,
        figures,
    }
}

const TURN: &str = "By what angle Θ does the hit turn the striker as seen from their centre of \
                    mass?";

/// Why Θ = 180° − 2α.
fn why_turn(alpha: f64, turn: f64) -> String {
    format!(
        "Seen from there the part along the line of impact is turned round and the part across \
         stays, as off a wall. So Θ = 180 - 2 × {} = {}.",
        bare_degrees(alpha),
        degrees(turn)
    )
}

/// What misconceptions make of Θ.
fn turned(alpha: f64, outcome: &Outcome) -> [Option<WrongAnswer>; 2] {
    [
        number(
            &DOUBLE_ANGLE_FORGOTTEN,
            180.0 - deg_from_rad(alpha),
            "You took α off 180° once. It counts twice: on the way in and on the way out.".into(),
        ),
        number(
            &FRAMES_MIXED,
            outcome.theta1.map_or(f64::NAN, |it| deg_from_rad(it.abs())),
            "That is by how much the striker turns on the board. The centre of mass moves, and \
             sees another angle."
                .into(),
        ),
    ]
}

/// Θ asked for.
fn turn_question(hit: &Hit, turn: f64, beliefs: Vec<Option<WrongAnswer>>, why: String) -> Question {
    let asked = Asked {
        id: "turn",
        text: format!("{} No energy is lost. {TURN}", in_short(hit)),
        quantity: Measure::Angle,
        truth: deg_from_rad(turn),
        beliefs,
        why,
        more: Map::new(),
    };
    question(hit, DVec2::ZERO, Markings::given(hit), asked)
}

/// Θ from α.
fn turn_from_angle(hit: &Hit) -> Option<Question> {
    let alpha = hit.alpha().abs();
    let turn = cm_scattering_angle(alpha, hit.restitution)?;
    let mut beliefs = turned(alpha, &hit.outcome()).to_vec();
    beliefs.push(number(
        &COPIED_ANGLE,
        deg_from_rad(alpha),
        "You took α itself. It says where they touch, not by how much they turn.".into(),
    ));
    Some(turn_question(hit, turn, beliefs, why_turn(alpha, turn)))
}

/// Θ from the offset.
fn turn_from_offset(hit: &Hit) -> Option<Question> {
    let Placement::Offset { offset_mm } = hit.given else {
        return None;
    };
    let alpha = hit.alpha().abs();
    let share = offset_mm.abs() / hit.reach_mm();
    let turn = cm_scattering_angle(alpha, hit.restitution)?;
    let mut beliefs = turned(alpha, &hit.outcome()).to_vec();
    beliefs.push(number(
        &OFFSET_AS_ANGLE,
        180.0 * (1.0 - share),
        "You let the angle shrink in step with the offset. It is the sine of α that goes with \
         the offset."
            .into(),
    ));
    let sine = format!(
        "sin α = {} / {}: α = {}.",
        bare_millimetres(offset_mm.abs()),
        bare_millimetres(hit.reach_mm()),
        degrees(alpha)
    );
    let why = format!("{sine} {}", why_turn(alpha, turn));
    Some(turn_question(hit, turn, beliefs, why))
}

/// The speed of the centre of mass; the target at rest, or moving along the same line,
/// the same way if `target_speed` is positive.
fn speed_of_centre(hit: &Hit, target_speed: Option<f64>) -> Option<Question> {
    let name = hit.pieces.target_name();
    let (striker, target) = (hit.pieces.striker(), hit.pieces.target());
    let (m1, m2) = (g_from_kg(striker.mass), g_from_kg(target.mass));
    let (u1, u2) = (hit.speed, target_speed.unwrap_or(0.0));
    // On the same way the striker has to catch up.
    if u2 >= u1 {
        return None;
    }
    let forward = hit.collision().u1.try_normalize()?;
    let moving = Collision {
        u2: u2 * forward,
        ..hit.collision()
    };
    let velocity = moving.centre_of_mass_velocity();
    let along = velocity.dot(forward);
    let weighed = |a: f64, b: f64| (a * u1 + b * u2) / (m1 + m2);
    // A centre that hardly moves has no ratio to be off by.
    if along.abs() < 0.1 || weighed(m2, m1).abs() < 0.1 || (u1 + u2).abs() < 0.1 {
        return None;
    }
    let setting = match target_speed {
        None => format!("{} at {} m/s.", who(hit), significant(u1)),
        Some(_) => format!(
            "A striker of {} g moves at {} m/s, a {name} of {} g at {} m/s {}.",
            significant(m1),
            significant(u1),
            significant(m2),
            significant(u2.abs()),
            if u2 > 0.0 {
                "ahead of it, the same way"
            } else {
                "towards it"
            }
        ),
    };
    let text = format!("{setting} How fast does their centre of mass move?");
    let momentum = match target_speed {
        None => format!("{} × {}", significant(m1), significant(u1)),
        Some(_) => format!(
            "{} × {} {} {} × {}",
            significant(m1),
            significant(u1),
            if u2 > 0.0 { "+" } else { "-" },
            significant(m2),
            significant(u2.abs())
        ),
    };
    let backward = if along < 0.0 {
        " It moves the way of the heavier one."
    } else {
        ""
    };
    let asked = Asked {
        id: "centre-speed",
        text,
        quantity: Measure::Speed,
        truth: velocity.length(),
        beliefs: vec![
            number(
                &HALFWAY_CENTRE,
                (u1 + u2).abs() / 2.0,
                "You took the middle between the two velocities. The heavier one counts for more."
                    .into(),
            ),
            number(
                &UPSIDE_DOWN,
                weighed(m2, m1).abs(),
                "You had the masses the other way round: the centre moves more like the heavier \
                 one."
                    .into(),
            ),
            number(
                &SCALAR_MOMENTUM,
                (m1 * u1 + m2 * u2.abs()) / (m1 + m2),
                "You added the momenta as plain numbers. They point against each other, so one \
                 is taken off."
                    .into(),
            ),
        ],
        why: format!(
            "All the momentum, {momentum} g m/s, belongs to {} g in all: {} m/s.{backward}",
            significant(m1 + m2),
            significant(velocity.length())
        ),
        more: more([("target_speed", json!(u2))]),
    };
    let shown = Markings {
        offset: false,
        angle: false,
        figures: true,
    };
    Some(question(hit, u2 * forward, shown, asked))
}

/// From Θ back to the board: the striker's angle or the target's.
fn on_the_board(difficulty: Difficulty, striker: bool, dice: &mut Dice) -> Option<Question> {
    let turn_deg = f64::from(10 * (4 + dice.below(11)));
    let drawn = hit(&UNEQUAL, difficulty, dice)?;
    let hit = Hit {
        given: Placement::Angle {
            alpha_deg: drawn.side() * (90.0 - turn_deg / 2.0),
        },
        ..drawn
    };
    let name = hit.pieces.target_name();
    let (m1, m2) = (hit.pieces.striker().mass, hit.pieces.target().mass);
    let turn = rad_from_deg(turn_deg);
    let theta1 = deg_from_rad(lab_scattering_angle(turn, m1, m2)?);
    let asked_for = if striker {
        "the striker".to_owned()
    } else {
        format!("the way of the {name}")
    };
    let question_text = if striker {
        "By what angle is the striker turned on the board?".to_owned()
    } else {
        format!("At what angle to the striker's old path does the {name} leave on the board?")
    };
    let text = format!(
        "{}, and no energy is lost. Seen from their centre of mass the hit turns both by Θ = {}. \
         {question_text}",
        who(&hit),
        degrees(turn)
    );
    let mixed = number(
        &FRAMES_MIXED,
        turn_deg,
        format!(
            "You took Θ for {asked_for}. It is seen from the centre of mass, which moves over the \
             board."
        ),
    );
    let (truth, beliefs, why) = if striker {
        (
            theta1,
            vec![
                mixed,
                number(
                    &HALFWAY_CENTRE,
                    turn_deg / 2.0,
                    "You took half of Θ. That is for equal masses, where the centre of mass lies \
                     halfway."
                        .into(),
                ),
                number(
                    &UPSIDE_DOWN,
                    lab_scattering_angle(turn, m2, m1).map_or(f64::NAN, deg_from_rad),
                    "You had the masses the other way round: a heavier striker is turned less."
                        .into(),
                ),
            ],
            format!(
                "From there the striker has m₂ parts of the speed, the centre itself m₁ parts, \
                 straight ahead. Add them: tan θ₁ = sin Θ / (cos Θ + m₁ / m₂), with m₁ / m₂ = {}.",
                significant(m1 / m2)
            ),
        )
    } else {
        (
            90.0 - turn_deg / 2.0,
            vec![
                mixed,
                number(
                    &DOUBLE_ANGLE_FORGOTTEN,
                    180.0 - turn_deg,
                    format!(
                        "You took Θ off 180°. On the board the {name} leaves at α, and that is \
                         half of it."
                    ),
                ),
                number(
                    &SWAPPED,
                    theta1,
                    format!("That is the striker's angle. The {name} has one of its own."),
                ),
            ],
            format!(
                "The {name} was at rest, so it leaves along the line of impact, at α. As \
                 Θ = 180° - 2α, that is 90 - {} / 2.",
                bare_degrees(turn)
            ),
        )
    };
    let asked = Asked {
        id: if striker { "theta1" } else { "theta2" },
        text,
        quantity: Measure::Angle,
        truth,
        beliefs,
        why,
        more: more([("turn_deg", json!(turn_deg))]),
    };
    let shown = Markings {
        offset: false,
        angle: false,
        figures: true,
    };
    Some(question(&hit, DVec2::ZERO, shown, asked))
}
