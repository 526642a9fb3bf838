//! Slipping, e = 0 with smooth rims, against sticking: how the two go on.

use std::collections::BTreeMap;

use serde_json::json;

use super::choices::{Choice, Choices, shuffled};
use super::in_short::in_short;
use super::setting::{Setting, more, number, wrong};
use super::where_to::figures;
use crate::physics::units::deg_from_rad;
use crate::physics::{Bond, Collision};
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::catalogue::{
    GRIP_IGNORED, GRIP_STOPS_ALL, HALFWAY_CENTRE, MOMENTUM_LOST, SINE_COSINE, UPSIDE_DOWN,
};
use crate::quiz::misconceptions::{ALWAYS_SQUARE, LOSSLESS};
use crate::quiz::words::{bare_degrees, degrees, significant};
use crate::quiz::{
    Difficulty, Family, Form, Hit, Illustration, Markings, Measure, Pieces, Question,
};

const UNEQUAL: [Pieces; 2] = [Pieces::Tournament, Pieces::Marbles];

/// What the rims do.
#[derive(Clone, Copy, PartialEq)]
enum Rims {
    /// Smooth, and nothing is lost.
    Lossless,
    /// Smooth, and nothing springs back.
    Slip,
    /// They hold fast.
    Stick,
}

impl Rims {
    const fn id(self) -> &'static str {
        match self {
            Self::Lossless => "lossless",
            Self::Slip => "slip",
            Self::Stick => "stick",
        }
    }

    const fn words(self) -> &'static str {
        match self {
            Self::Lossless => "The rims are smooth and no energy is lost: e = 1.",
            Self::Slip => "The rims are smooth and nothing springs back: e = 0.",
            Self::Stick => "The rims are sticky and hold fast where they touch.",
        }
    }
}

/// What a number is asked for.
#[derive(Clone, Copy, PartialEq)]
enum Sought {
    /// The angle at which the two slip apart.
    Parting,
    /// How fast the striker slips on.
    StrikerSpeed,
    /// How fast the stuck pair goes on.
    PairSpeed,
    /// The share of the energy that is lost as they slip.
    Loss,
}

impl Sought {
    const fn id(self) -> &'static str {
        match self {
            Self::Parting => "separation",
            Self::StrikerSpeed => "striker-speed",
            Self::PairSpeed => "pair-speed",
            Self::Loss => "energy-lost",
        }
    }
}

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    use Sought::{Loss, PairSpeed, Parting, StrikerSpeed};
    let (pieces, sought): (&[Pieces], &[Sought]) = match difficulty {
        Difficulty::Easy => (&[Pieces::Equal], &[]),
        Difficulty::Middle => (&[Pieces::Equal], &[Parting, StrikerSpeed, PairSpeed]),
        Difficulty::Hard => (&UNEQUAL, &[Parting, StrikerSpeed, PairSpeed, Loss]),
    };
    let setting = Setting {
        pieces,
        fives_deg: 20..=70,
        restitutions: &[0.0],
    };
    let hit = setting.draw(difficulty, dice)?;
    match dice.pick(sought) {
        Some(sought) => Some(by_number(&hit, *sought, difficulty)),
        None => by_choice(&hit, difficulty, dice),
    }
}

/// How do they go on? Equal masses.
fn by_choice(hit: &Hit, difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    const SQUARE: &str = "They part at exactly 90°";
    const NARROW: &str = "They part at less than 90°";
    const MOVING: &str = "They stay together and move on";
    const STILL: &str = "They stay together, at rest";
    let rims = *dice.pick(&[
        Rims::Slip,
        Rims::Slip,
        Rims::Stick,
        Rims::Stick,
        Rims::Lossless,
    ])?;
    let hit = &Hit {
        restitution: if rims == Rims::Lossless { 1.0 } else { 0.0 },
        ..*hit
    };
    let outcome = collision(hit, rims).outcome();
    let across = significant(hit.speed * hit.alpha().abs().sin());
    let bounced = "You let them part as if nothing were lost. Here nothing throws them apart.";
    let still = Choice::of(
        &MOMENTUM_LOST,
        STILL,
        "You let all motion go. Energy can be lost, but momentum cannot: the two carry it on.",
    );
    let (choices, why) = match rims {
        Rims::Lossless => (
            vec![
                Choice::right(SQUARE),
                Choice::wrong(
                    NARROW,
                    "You let some of the bounce be lost. With e = 1 all of it comes back.",
                ),
                Choice::of(
                    &GRIP_STOPS_ALL,
                    MOVING,
                    "You let them stick. But smooth rims cannot hold each other.",
                ),
                still,
            ],
            format!(
                "Along the line of impact the coin takes all that the striker had. Across it the \
                 striker keeps its {across} m/s: a corner of 90°."
            ),
        ),
        Rims::Slip => (
            vec![
                Choice::of(&LOSSLESS, SQUARE, bounced),
                Choice::right(NARROW),
                Choice::of(
                    &GRIP_STOPS_ALL,
                    MOVING,
                    "You let them stick. But smooth rims do not grip: across the line of impact \
                     nothing is stopped.",
                ),
                still,
            ],
            format!(
                "Along the line of impact both go on alike. Across it the striker keeps its \
                 {across} m/s and slides off: they part at {}.",
                degrees(outcome.separation?)
            ),
        ),
        Rims::Stick => (
            vec![
                Choice::of(&LOSSLESS, SQUARE, bounced),
                Choice::of(
                    &GRIP_IGNORED,
                    NARROW,
                    "You let them slip along each other. So it would be with smooth rims and \
                     e = 0; these hold fast.",
                ),
                Choice::right(MOVING),
                still,
            ],
            format!(
                "Stuck together they go on with their centre of mass, at {} m/s. Off-centre, the \
                 pair also turns.",
                significant(outcome.v1.length())
            ),
        ),
    };
    let answers = shuffled(choices, dice)?;
    let asked = Asked {
        sought: "picture",
        text: "How do the two go on?",
        answers,
        why,
    };
    Some(question(hit, rims, difficulty, asked))
}

/// One number of how they go on.
fn by_number(hit: &Hit, sought: Sought, difficulty: Difficulty) -> Question {
    let name = hit.pieces.target_name();
    let (u, alpha) = (hit.speed, hit.alpha().abs());
    let (m1, m2) = (hit.pieces.striker().mass, hit.pieces.target().mass);
    let share = m1 / (m1 + m2);
    let (along, across) = (u * alpha.cos(), u * alpha.sin());
    let unequal = m1.total_cmp(&m2).is_ne();
    let slip = collision(hit, Rims::Slip).outcome();
    let lossless = collision(hit, Rims::Lossless).outcome();
    let angle = |angle: Option<f64>| angle.map_or(f64::NAN, deg_from_rad);
    let shared = format!(
        "Along the line of impact the two go on alike, with {} m/s.",
        significant(share * along)
    );
    let (quantity, truth, beliefs, why) = match sought {
        Sought::Parting => (
            Measure::Angle,
            angle(slip.separation),
            vec![
                number(
                    &GRIP_STOPS_ALL,
                    0.0,
                    "You let them stick. Smooth rims do not grip: the striker slides off.".into(),
                ),
                number(
                    &LOSSLESS,
                    angle(lossless.separation),
                    "That is the angle without loss. With e = 0 nothing springs back along the \
                     line of impact."
                        .into(),
                ),
                number(
                    &ALWAYS_SQUARE,
                    90.0,
                    "You took 90°. That is for equal masses without loss.".into(),
                ),
            ],
            format!(
                "{shared} Across it the striker keeps {} m/s, the {name} has none: the tangent \
                 of the angle is {} / {}.",
                significant(across),
                significant(across),
                significant(share * along)
            ),
        ),
        Sought::StrikerSpeed => (
            Measure::Speed,
            slip.v1.length(),
            vec![
                number(
                    &GRIP_STOPS_ALL,
                    share * u,
                    "You let them stick and share all the speed. Across the line of impact \
                     smooth rims share nothing."
                        .into(),
                ),
                number(
                    &LOSSLESS,
                    lossless.v1.length(),
                    "That is the speed without loss. With e = 0 the two stay level along the \
                     line of impact."
                        .into(),
                ),
                unequal.then_some(()).and_then(|()| {
                    number(
                        &MOMENTUM_LOST,
                        across,
                        "You let all that was along the line of impact be lost. But momentum \
                         stays: the two share it."
                            .into(),
                    )
                }),
            ],
            format!(
                "{shared} Across it the striker keeps {} sin {} = {} m/s. Those two are square \
                 to each other and make {} m/s.",
                significant(u),
                bare_degrees(alpha),
                significant(across),
                significant(slip.v1.length())
            ),
        ),
        Sought::PairSpeed => (
            Measure::Speed,
            collision(hit, Rims::Stick).outcome().v1.length(),
            vec![
                number(
                    &GRIP_IGNORED,
                    share * along,
                    "You shared only the part along the line of impact. Sticky rims take the \
                     part across along, too."
                        .into(),
                ),
                number(
                    &LOSSLESS,
                    u * share.sqrt(),
                    "You kept the energy of motion. Sticking costs energy; what stays is the \
                     momentum."
                        .into(),
                ),
                unequal.then_some(()).and_then(|()| {
                    number(
                        &HALFWAY_CENTRE,
                        u / 2.0,
                        "You took half the speed. That is for equal masses.".into(),
                    )
                }),
                number(
                    &UPSIDE_DOWN,
                    u * (1.0 - share),
                    "You had the masses the other way round: a heavier striker is slowed less."
                        .into(),
                ),
            ],
            format!(
                "Stuck together they go on with their centre of mass: \
                 m₁ / (m₁ + m₂) = {} times {} m/s, wherever they touch.",
                significant(share),
                significant(u)
            ),
        ),
        Sought::Loss => (
            Measure::Share,
            100.0 * slip.energy_lost / slip.energy_before,
            vec![
                number(
                    &GRIP_STOPS_ALL,
                    100.0 * (1.0 - share),
                    "You let them go on as one. But across the line of impact smooth \
                     rims stop nothing."
                        .into(),
                ),
                number(
                    &MOMENTUM_LOST,
                    100.0 * alpha.cos().powi(2),
                    "You let all that was along the line of impact be lost. But momentum stays, \
                     and some energy with it."
                        .into(),
                ),
                number(
                    &UPSIDE_DOWN,
                    100.0 * share * alpha.cos().powi(2),
                    "You had the masses the other way round: against a heavier target more is \
                     lost."
                        .into(),
                ),
                number(
                    &SINE_COSINE,
                    100.0 * (1.0 - share) * alpha.sin().powi(2),
                    "You took the sine for the cosine. A graze loses least, a head-on hit most."
                        .into(),
                ),
            ],
            format!(
                "Only the part along the line of impact is at stake: cos² {} = {} of the energy. \
                 Of that, m₂ / (m₁ + m₂) = {} is lost.",
                bare_degrees(alpha),
                significant(alpha.cos().powi(2)),
                significant(1.0 - share)
            ),
        ),
    };
    let form = Form::Number { quantity, truth };
    let text = match sought {
        Sought::Parting => "At what angle do they part?",
        Sought::StrikerSpeed => "How fast does the striker go on?",
        Sought::PairSpeed => "How fast does the pair go on?",
        Sought::Loss => "What share of the energy is lost?",
    };
    let rims = match sought {
        Sought::PairSpeed => Rims::Stick,
        _ => Rims::Slip,
    };
    let asked = Asked {
        sought: sought.id(),
        text,
        answers: Choices {
            beliefs: wrong(&form, beliefs),
            form,
            replies: BTreeMap::new(),
        },
        why,
    };
    question(hit, rims, difficulty, asked)
}

/// The hit with these rims.
fn collision(hit: &Hit, rims: Rims) -> Collision {
    let (restitution, bond) = match rims {
        Rims::Lossless => (1.0, Bond::Slip),
        Rims::Slip => (0.0, Bond::Slip),
        Rims::Stick => (0.0, Bond::Stick),
    };
    Collision {
        restitution,
        bond,
        ..hit.collision()
    }
}

/// What is asked about a hit.
struct Asked {
    sought: &'static str,
    text: &'static str,
    answers: Choices,
    why: String,
}

fn question(hit: &Hit, rims: Rims, difficulty: Difficulty, asked: Asked) -> Question {
    let mut figures = figures(hit);
    figures.extend(more([
        ("rims", json!(rims.id())),
        ("asked", json!(asked.sought)),
    ]));
    Question {
        family: Family::SlipOrStick,
        difficulty,
        topic: match rims {
            Rims::Lossless => "smooth-no-loss".into(),
            Rims::Slip => "smooth-no-spring".into(),
            Rims::Stick => "sticking".into(),
        },
        text: format!("{} {} {}", in_short(hit), rims.words(), asked.text),
        picture: Illustration::Before {
            collision: collision(hit, rims),
            shown: Markings {
                offset: false,
                angle: true,
                figures: true,
            },
        },
        form: asked.answers.form,
        beliefs: asked.answers.beliefs,
        replies: asked.answers.replies,
        why: asked.why,
        figures,
    }
}
