//! Two equal discs that both move: who sees them part at 90°, and what is seen on the
//! board.

use std::collections::BTreeMap;

use glam::DVec2;
use serde_json::json;

use super::choices::{Choice, Choices, ordered, shuffled};
use super::setting::{more, number, wrong};
use crate::physics::units::{deg_from_rad, g_from_kg, mm_from_m, rad_from_deg};
use crate::physics::{Collision, Outcome};
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::ALWAYS_SQUARE;
use crate::quiz::misconceptions::catalogue::{
    FRAMES_MIXED, ONE_LINE_FORMULA, SINE_COSINE, SPEED_OPENS_ANGLE, SQUARE_ON_THE_GROUND,
};
use crate::quiz::words::{bare_degrees, degrees, significant};
use crate::quiz::{
    Difficulty, Family, Form, Illustration, Markings, Measure, Pieces, Question, WrongAnswer,
};

/// The largest impact angle asked about, as its cosine: beyond it they hardly touch.
const LEAST_COSINE: f64 = 0.3;

/// The smallest impact angle asked about, as its sine: a meeting nearer to head-on is not
/// seen to be off-centre.
const LEAST_SINE: f64 = 0.17;

/// Nearer to 90° than this no one is asked whether it is more or less, in degrees.
const NEAR_SQUARE_DEG: f64 = 5.0;

/// Two equal discs about to meet.
#[derive(Clone, Copy)]
struct Meeting {
    /// Speed of the striker in m/s.
    speed: u32,
    /// Speed of the coin in m/s.
    target_speed: u32,
    /// Direction of the coin against that of the striker, 0 to 180 degrees to the left.
    way_deg: u32,
    /// Angle from the striker's path to the line of impact, in degrees.
    line_deg: u32,
    /// The side of the striker's path on which the coin lies: 1 for the right.
    side: f64,
    /// Direction of the striker on the picture, in degrees.
    direction_deg: f64,
}

impl Meeting {
    fn draw(ways_deg: &[u32], difficulty: Difficulty, dice: &mut Dice) -> Option<Self> {
        let turn = difficulty.turn_deg();
        Some(Self {
            speed: 2 + dice.below(4),
            target_speed: 1 + dice.below(4),
            way_deg: *dice.pick(ways_deg)?,
            line_deg: 5 * (3 + dice.below(12)),
            side: if dice.coin() { -1.0 } else { 1.0 },
            direction_deg: f64::from(turn * dice.below(360 / turn)),
        })
    }

    /// The hit, if they come together and squarely enough to be drawn.
    fn collision(&self) -> Option<Collision> {
        let towards = |speed: u32, deg: f64| {
            f64::from(speed) * DVec2::from_angle(rad_from_deg(self.direction_deg + deg))
        };
        let u1 = towards(self.speed, 0.0);
        let u2 = towards(self.target_speed, self.side * f64::from(self.way_deg));
        let normal = towards(1, -self.side * f64::from(self.line_deg));
        let relative = (u1 - u2).try_normalize()?;
        let (striker, target) = (Pieces::Equal.striker(), Pieces::Equal.target());
        let head_on = Collision::at_offset(striker, target, u1, 0.0);
        let sine = normal.perp_dot(relative);
        let drawable = relative.dot(normal) > LEAST_COSINE && sine.abs() > LEAST_SINE;
        drawable.then_some(Collision {
            u2,
            offset: head_on.reach() * sine,
            ..head_on
        })
    }

    fn words(&self) -> String {
        let way = match self.way_deg {
            0 => "ahead of it, the same way".into(),
            180 => "the opposite way".into(),
            way => format!("at {} to its path", degrees(rad_from_deg(f64::from(way)))),
        };
        format!(
            "A striker moves at {} m/s, an equal coin at {} m/s {way}.",
            significant(f64::from(self.speed)),
            significant(f64::from(self.target_speed))
        )
    }
}

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let ways_deg: &[u32] = match difficulty {
        Difficulty::Easy | Difficulty::Hard => &[0, 180],
        Difficulty::Middle => &[0, 60, 90, 120, 180],
    };
    let meeting = Meeting::draw(ways_deg, difficulty, dice)?;
    let collision = meeting.collision()?;
    let outcome = collision.outcome();
    let asked = match difficulty {
        Difficulty::Easy => frames(&meeting, &outcome, dice)?,
        Difficulty::Middle => on_the_board(&meeting, &outcome)?,
        Difficulty::Hard => match dice.below(3) {
            0 => parting(&meeting, &outcome)?,
            1 => speed(&meeting, true, &outcome),
            _ => speed(&meeting, false, &outcome),
        },
    };
    let by_line = difficulty == Difficulty::Hard;
    let place = if by_line {
        format!(
            "The line of impact makes {} with the striker's path.",
            degrees(rad_from_deg(f64::from(meeting.line_deg)))
        )
    } else {
        "They meet off-centre.".into()
    };
    let text = format!(
        "{} {place} Smooth rims, no energy lost. {}",
        meeting.words(),
        asked.text
    );
    let disc = collision.striker;
    let figures = more([
        ("mass_g", json!(g_from_kg(disc.mass))),
        ("radius_mm", json!(mm_from_m(disc.radius))),
        ("speed", json!(meeting.speed)),
        ("target_speed", json!(meeting.target_speed)),
        (
            "target_deg",
            json!(meeting.side * f64::from(meeting.way_deg)),
        ),
        (
            "line_deg",
            json!(-meeting.side * f64::from(meeting.line_deg)),
        ),
        ("direction_deg", json!(meeting.direction_deg)),
        ("asked", json!(asked.id)),
    ]);
    Some(Question {
        family: Family::BothMoving,
        difficulty,
        topic: "both-moving".into(),
        text,
        picture: Illustration::Before {
            collision,
            shown: Markings {
                offset: false,
                angle: false,
                figures: true,
            },
        },
        form: asked.answers.form,
        beliefs: asked.answers.beliefs,
        replies: asked.answers.replies,
        why: asked.why,
        figures,
    })
}

/// What is asked about a meeting.
struct Asked {
    id: &'static str,
    text: &'static str,
    answers: Choices,
    why: String,
}

/// The answers to a question for a number.
fn by_number(form: Form, beliefs: Vec<WrongAnswer>) -> Choices {
    Choices {
        form,
        beliefs,
        replies: BTreeMap::new(),
    }
}

/// Who sees 90°, or what somebody sees who moves along.
fn frames(meeting: &Meeting, outcome: &Outcome, dice: &mut Dice) -> Option<Asked> {
    // The board would be the frame of the centre of mass.
    if meeting.way_deg == 180 && meeting.speed == meeting.target_speed {
        return None;
    }
    let on_board = degrees(outcome.separation?);
    let rides = "Ride along with the coin as it came: there it is at rest before the hit, and the \
                 rule for a coin at rest holds.";
    let back_to_back = "With the centre of mass the momentum is zero, so the two part back to \
                        back: 180°.";
    let it_depends = "The offset decides where they go. But seen from there, the angle between them \
                      is always the same.";
    let depends = "At an angle that depends on the offset";
    let (id, text, choices, why) = match dice.below(3) {
        0 => (
            "who",
            "Who sees them part at exactly 90°?",
            vec![
                Choice::right("One who rides along with the coin as it came"),
                Choice::of(
                    &SQUARE_ON_THE_GROUND,
                    "One who stands still at the edge of the board",
                    "You looked for 90° on the board. There it takes a coin at rest, and here both \
                     move.",
                ),
                Choice::of(
                    &FRAMES_MIXED,
                    "One who rides along with the centre of mass",
                    back_to_back,
                ),
                Choice::of(
                    &ALWAYS_SQUARE,
                    "Everyone, however they move themselves",
                    "You took 90° for everyone. But whoever moves along sees other velocities, and \
                     other angles.",
                ),
            ],
            format!("{rides} On the board the angle is {on_board}."),
        ),
        1 => (
            "from-the-coin",
            "At what angle do they part for one who rides along with the coin as it came?",
            vec![
                Choice::right("At 90°, wherever they touch"),
                Choice::of(
                    &FRAMES_MIXED,
                    "At 180°, wherever they touch",
                    "You took 180°. That is seen from the centre of mass, not from the coin.",
                ),
                Choice::wrong(depends, it_depends),
            ],
            format!("{rides} On the board the angle is {on_board}."),
        ),
        _ => (
            "from-the-centre",
            "At what angle do they part for one who rides along with their centre of mass?",
            vec![
                Choice::of(
                    &FRAMES_MIXED,
                    "At 90°, wherever they touch",
                    "You took 90°. That is seen by one who rides along with the coin as it came.",
                ),
                Choice::right("At 180°, wherever they touch"),
                Choice::wrong(depends, it_depends),
            ],
            format!("{back_to_back} On the board the angle is {on_board}."),
        ),
    };
    let answers = shuffled(choices, dice)?;
    Some(Asked {
        id,
        text,
        answers,
        why,
    })
}

/// More or less than 90° on the board. For equal masses without loss v₁·v₂ = u₁·u₂, so
/// that alone the way of the coin decides.
fn on_the_board(meeting: &Meeting, outcome: &Outcome) -> Option<Asked> {
    let (less, square, more) = ("Less than 90°", "Exactly 90°", "More than 90°");
    let on_board = deg_from_rad(outcome.separation?);
    let wider = || {
        Choice::of(
            &SPEED_OPENS_ANGLE,
            more,
            "You took a fast meeting to throw them wide apart. Speed alone opens no angle.",
        )
    };
    let exactly = || {
        Choice::of(
            &SQUARE_ON_THE_GROUND,
            square,
            "You looked for 90° on the board. But that rule wants one coin at rest.",
        )
    };
    let narrower = "You let them go on side by side. But as they came, so they part.";
    let choices = match meeting.way_deg {
        0..90 => vec![Choice::right(less), exactly(), wider()],
        90 => vec![
            Choice::wrong(less, narrower),
            Choice::right(square),
            wider(),
        ],
        _ => vec![
            Choice::wrong(less, narrower),
            exactly(),
            Choice::right(more),
        ],
    };
    if meeting.way_deg != 90 && (on_board - 90.0).abs() < NEAR_SQUARE_DEG {
        return None;
    }
    let came = match meeting.way_deg {
        0..90 => "They came the same way, more or less, and so they go on:",
        90 => "They came square, so they part square:",
        _ => "They came against each other, and so they part:",
    };
    let answers = ordered(choices)?;
    Some(Asked {
        id: "on-the-board",
        text: "On the board, at what angle do they part?",
        answers,
        why: format!(
            "Equal masses, momentum and energy kept: so v₁·v₂ = u₁·u₂. {came} {}.",
            degrees(rad_from_deg(on_board))
        ),
    })
}

/// The angle between the two on the board.
fn parting(meeting: &Meeting, outcome: &Outcome) -> Option<Asked> {
    let form = Form::Number {
        quantity: Measure::Angle,
        truth: deg_from_rad(outcome.separation?),
    };
    let beliefs = wrong(
        &form,
        [
            number(
                &SQUARE_ON_THE_GROUND,
                90.0,
                "You took 90°. On the board that wants a coin at rest.".into(),
            ),
            number(
                &FRAMES_MIXED,
                180.0,
                "You took 180°. That is seen from the centre of mass, not on the board.".into(),
            ),
        ],
    );
    let (v1, v2) = (
        significant(outcome.v1.length()),
        significant(outcome.v2.length()),
    );
    let sign = if meeting.way_deg == 180 { "-" } else { "" };
    Some(Asked {
        id: "separation",
        text: "At what angle do they part on the board?",
        answers: by_number(form, beliefs),
        why: format!(
            "Along the line of impact they exchange velocities, across it each keeps its own: so \
             they leave at {v1} and {v2} m/s. As v₁·v₂ = u₁·u₂, the cosine of the angle is \
             {sign}{} / ({v1} × {v2}).",
            significant(f64::from(meeting.speed * meeting.target_speed))
        ),
    })
}

/// The speed of one of the two on the board: what the other had along the line of
/// impact, and its own across it.
fn speed(meeting: &Meeting, of_target: bool, outcome: &Outcome) -> Asked {
    let line = rad_from_deg(f64::from(meeting.line_deg));
    let (u1, u2) = (f64::from(meeting.speed), f64::from(meeting.target_speed));
    let relative = if meeting.way_deg == 180 {
        u1 + u2
    } else {
        u1 - u2
    };
    let (own, others) = if of_target { (u2, u1) } else { (u1, u2) };
    let (taken, kept) = (others * line.cos(), own * line.sin());
    let truth = if of_target { outcome.v2 } else { outcome.v1 }.length();
    let form = Form::Number {
        quantity: Measure::Speed,
        truth,
    };
    let (name, seen) = if of_target {
        ("coin", relative * line.cos())
    } else {
        ("striker", relative * line.sin())
    };
    let beliefs = wrong(
        &form,
        [
            number(
                &FRAMES_MIXED,
                seen,
                "You took the coin as if it had been at rest. That is how fast it looks to one \
                 who rides along with the coin as it came."
                    .replace("it looks", &format!("the {name} looks")),
            ),
            number(
                &SINE_COSINE,
                (others * line.sin()).hypot(own * line.cos()),
                "You exchanged the parts across the line of impact. They are kept; those along \
                 it are exchanged."
                    .into(),
            ),
            number(
                &ONE_LINE_FORMULA,
                others,
                "You let them exchange all of their velocities. That is for a head-on hit; here \
                 only the parts along the line are exchanged."
                    .into(),
            ),
        ],
    );
    Asked {
        id: if of_target {
            "target-speed"
        } else {
            "striker-speed"
        },
        text: if of_target {
            "How fast does the coin leave?"
        } else {
            "How fast does the striker leave?"
        },
        answers: by_number(form, beliefs),
        why: format!(
            "Along the line of impact equal discs exchange: the {name} takes over {} cos {line} = \
             {} m/s. Across it, it keeps {} sin {line} = {} m/s. Square to each other, they make \
             {} m/s.",
            significant(others),
            significant(taken),
            significant(own),
            significant(kept),
            significant(truth),
            line = bare_degrees(line),
        ),
    }
}
