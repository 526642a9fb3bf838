//! "Make it so": choose the offset that sends a disc the way it is to go, and shoot.

use std::collections::BTreeMap;

use serde_json::json;

use super::setting::{more, wrong};
use crate::physics::Disc;
use crate::physics::units::{deg_from_rad, g_from_kg, m_from_mm, mm_from_m, rad_from_deg};
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::catalogue::{FRAMES_MIXED, SINE_COSINE};
use crate::quiz::misconceptions::{ALWAYS_SQUARE, COPIED_ANGLE, OFFSET_AS_ANGLE, SIDES_EXCHANGED};
use crate::quiz::words::{bare_degrees, bare_millimetres, degrees, significant};
use crate::quiz::{
    AimTask, Difficulty, Family, Form, Hit, Illustration, Markings, Misconception, Pieces,
    Placement, Question, Ray, Response, Topic, WrongAnswer,
};

/// Lighter strikers, which can be turned by any angle.
const LIGHT: [Pieces; 3] = [
    Pieces::Marbles,
    Pieces::Own {
        striker: Disc::from_g_mm(10.0, 14.0),
        target: Disc::from_g_mm(30.0, 16.0),
    },
    Pieces::Own {
        striker: Disc::from_g_mm(15.0, 15.0),
        target: Disc::from_g_mm(45.0, 20.0),
    },
];

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let (pieces, wanted_deg) = match difficulty {
        Difficulty::Easy | Difficulty::Middle => {
            (Pieces::Equal, f64::from(5 * (3 + dice.below(13))))
        }
        Difficulty::Hard => (*dice.pick(&LIGHT)?, f64::from(5 * (6 + dice.below(21)))),
    };
    // Square across, some of what is believed would be head-on or a graze.
    if (wanted_deg - 90.0).abs() < 1.0 {
        return None;
    }
    let turn = difficulty.turn_deg();
    let hit = Hit {
        pieces,
        given: Placement::Angle { alpha_deg: 0.0 },
        restitution: 1.0,
        speed: f64::from(2 + dice.below(4)),
        direction_deg: f64::from(turn * dice.below(360 / turn)),
    };
    let side = if dice.coin() { -1.0 } else { 1.0 };
    Some(match difficulty {
        Difficulty::Easy => target(&hit, side, wanted_deg),
        Difficulty::Middle | Difficulty::Hard => striker(&hit, side, wanted_deg, difficulty),
    })
}

/// Send the coin: it leaves along the line of impact.
fn target(hit: &Hit, side: f64, wanted_deg: f64) -> Question {
    let reach_mm = hit.reach_mm();
    let wanted = rad_from_deg(wanted_deg);
    let offset_mm = reach_mm * wanted.sin();
    let beliefs = [
        (
            &OFFSET_AS_ANGLE,
            reach_mm * wanted_deg / 90.0,
            "You took the offset in proportion to the angle. It goes with the sine.".to_owned(),
        ),
        (
            &SINE_COSINE,
            reach_mm * wanted.cos(),
            "You took the cosine for the sine. Offset 0 is head-on and sends the coin straight \
             ahead."
                .into(),
        ),
        (&SIDES_EXCHANGED, -offset_mm, wrong_side("coin", true)),
    ];
    let why = format!(
        "The coin leaves along the line of impact, which must be {}° off the path. So \
         b = {} sin {} = {}.",
        bare_degrees(wanted),
        bare_millimetres(reach_mm),
        bare_degrees(wanted),
        length(offset_mm)
    );
    let asked = Asked {
        ray: Ray::Target,
        side,
        wanted_deg,
        offset_mm,
        beliefs: &beliefs,
        why,
    };
    question(hit, Difficulty::Easy, asked)
}

/// Turn the striker, which is no heavier than its target: no loss.
fn striker(hit: &Hit, side: f64, wanted_deg: f64, difficulty: Difficulty) -> Question {
    let reach_mm = hit.reach_mm();
    let wanted = rad_from_deg(wanted_deg);
    // Seen from the centre of mass the striker is turned by Θ = 180° − 2α, and
    // sin(Θ − θ₁) = (m₁/m₂) sin θ₁, from θ₁ = atan2(sin Θ, cos Θ + m₁/m₂).
    let ratio = hit.mass_ratio();
    let turn = wanted + (ratio * wanted.sin()).clamp(-1.0, 1.0).asin();
    let alpha = rad_from_deg(90.0) - turn / 2.0;
    let offset_mm = reach_mm * alpha.sin();
    let copied = (
        &COPIED_ANGLE,
        reach_mm * wanted.sin(),
        "You let the line of impact be the striker's way. That is the way of the one it hits."
            .to_owned(),
    );
    let linear = (
        &OFFSET_AS_ANGLE,
        reach_mm * deg_from_rad(alpha) / 90.0,
        format!(
            "You took the offset in proportion to α = {}. It goes with the sine.",
            degrees(alpha)
        ),
    );
    let sides = (&SIDES_EXCHANGED, -offset_mm, wrong_side("striker", false));
    let equal = ratio.total_cmp(&1.0).is_eq();
    let [square, mixed] = [
        (
            &ALWAYS_SQUARE,
            reach_mm * wanted.cos(),
            "You aimed as if the two would part at 90°. They do so for equal masses; here they \
             part wider."
                .to_owned(),
        ),
        (
            &FRAMES_MIXED,
            reach_mm * (wanted / 2.0).cos(),
            format!(
                "You turned it by {} as seen from the centre of mass. On the board it turns less.",
                degrees(wanted)
            ),
        ),
    ];
    let beliefs = if equal {
        vec![copied, linear, sides]
    } else if wanted_deg < 90.0 {
        vec![square, copied, linear, sides, mixed]
    } else {
        // Nothing lies that way to be hit, nor can the target leave square to it.
        vec![linear, sides, mixed]
    };
    let why = if equal {
        format!(
            "The two part at 90°, so the coin must leave at 90 - {} = {}. That is the line of \
             impact: b = {} sin {} = {}.",
            bare_degrees(wanted),
            degrees(alpha),
            bare_millimetres(reach_mm),
            bare_degrees(alpha),
            length(offset_mm)
        )
    } else {
        format!(
            "From the centre of mass it must turn by Θ, with sin(Θ - {theta}) = m₁ / m₂ sin {theta}: \
             Θ = {}. So α = 90° - Θ / 2 = {}, and b = {} sin {} = {}.",
            degrees(turn),
            degrees(alpha),
            bare_millimetres(reach_mm),
            bare_degrees(alpha),
            length(offset_mm),
            theta = bare_degrees(wanted),
        )
    };
    let asked = Asked {
        ray: Ray::Striker,
        side,
        wanted_deg,
        offset_mm,
        beliefs: &beliefs,
        why,
    };
    question(hit, difficulty, asked)
}

fn wrong_side(name: &str, towards: bool) -> String {
    let rule = if towards {
        "It goes to the side on which it lies."
    } else {
        "It is thrown to the side away from what it hits."
    };
    format!("The {name} goes off to the other side. {rule}")
}

fn length(offset_mm: f64) -> String {
    format!("{} mm", significant(offset_mm))
}

/// What is to be done, for a coin that lies to the right.
struct Asked<'a> {
    ray: Ray,
    /// The side on which the target has to lie: 1 for the right, −1 for the left.
    side: f64,
    wanted_deg: f64,
    offset_mm: f64,
    beliefs: &'a [(&'static Misconception, f64, String)],
    why: String,
}

fn question(hit: &Hit, difficulty: Difficulty, asked: Asked) -> Question {
    let name = hit.pieces.target_name();
    let (striker, target) = (hit.pieces.striker(), hit.pieces.target());
    let (m1, m2) = (g_from_kg(striker.mass), g_from_kg(target.mass));
    let collision = hit.collision();
    let at = |offset_mm: f64| asked.side * m_from_mm(offset_mm);
    let form = Form::Shot(AimTask {
        collision,
        ray: asked.ray,
        wanted: asked.side * rad_from_deg(asked.wanted_deg),
        offset: at(asked.offset_mm),
    });
    let beliefs = asked
        .beliefs
        .iter()
        .map(|(misconception, offset_mm, says)| {
            Some(WrongAnswer::new(
                misconception,
                Response::Shot(at(*offset_mm)),
                says.clone(),
            ))
        });
    let beliefs = wrong(&form, beliefs);
    // The striker is thrown to the side away from its target.
    let (sent, way) = match (asked.ray, asked.side < 0.0) {
        (Ray::Target, false) => (name, "right"),
        (Ray::Target, true) => (name, "left"),
        (Ray::Striker, false) => ("striker", "left"),
        (Ray::Striker, true) => ("striker", "right"),
    };
    let masses = if m1.total_cmp(&m2).is_eq() {
        format!("Both weigh {} g", significant(m1))
    } else {
        format!(
            "The striker weighs {} g, the {name} {} g",
            significant(m1),
            significant(m2)
        )
    };
    let text = format!(
        "Send the {sent} off {} to the {way} of the striker's path. {masses}, the {name} is at \
         rest, the two radii make {} mm together, no energy is lost. Choose the offset and shoot.",
        degrees(rad_from_deg(asked.wanted_deg)),
        bare_millimetres(hit.reach_mm())
    );
    Question {
        family: Family::MakeItSo,
        difficulty,
        topic: Topic::with_id(format!("send-{sent}")),
        text,
        picture: Illustration::Before {
            collision,
            shown: Markings {
                offset: true,
                angle: false,
                figures: true,
            },
        },
        form,
        beliefs,
        replies: BTreeMap::new(),
        why: asked.why,
        figures: more([
            ("m1_g", json!(m1)),
            ("m2_g", json!(m2)),
            ("r1_mm", json!(mm_from_m(striker.radius))),
            ("r2_mm", json!(mm_from_m(target.radius))),
            ("speed", json!(hit.speed)),
            ("direction_deg", json!(hit.direction_deg)),
            ("wanted_deg", json!(asked.wanted_deg)),
            (
                "side",
                json!(if asked.side < 0.0 { "left" } else { "right" }),
            ),
            (
                "asked",
                json!(match asked.ray {
                    Ray::Striker => "striker",
                    Ray::Target => "target",
                }),
            ),
        ]),
    }
}
