//! Two equal discs that are both moving: the frame in which the angle between their paths is 90°,
//! and the angle and the speeds in the laboratory frame.

use glam::DVec2;

use super::prelude::*;
use crate::physics::CollisionOutcome;
use crate::physics::units::g_from_kg;

/// The cosine of the largest impact angle in these questions; at larger angles the discs hardly
/// touch.
const LEAST_COSINE: f64 = 0.3;

/// The sine of the smallest impact angle in these questions; at smaller angles the picture does not
/// show clearly that the collision is off-centre.
const LEAST_SINE: f64 = 0.17;

/// The minimum difference between an angle and 90°, in degrees, for a question that asks "more or
/// less?".
const NEAR_SQUARE_DEG: f64 = 5.0;

/// Two equal discs that are about to collide.
#[derive(Clone, Copy)]
struct MovingPair {
    /// Speed of the striker in m/s.
    speed: u32,
    /// Speed of the coin in m/s.
    target_speed: u32,
    /// The direction of the coin relative to the striker's direction, in degrees from 0 to 180: to
    /// the left if the coin lies on the right, and vice versa.
    way_deg: u32,
    /// Angle from the striker's path to the line of impact, in degrees.
    line_deg: u32,
    /// The side of the striker's path on which the coin lies: 1 for the right.
    side: f64,
    /// Direction of the striker in the picture, in degrees.
    direction_deg: f64,
}

impl MovingPair {
    fn draw(ways_deg: &[u32], difficulty: Difficulty, dice: &mut Dice) -> Option<Self> {
        Some(Self {
            speed: 2 + dice.below(4),
            target_speed: 1 + dice.below(4),
            way_deg: *dice.pick(ways_deg)?,
            line_deg: 5 * (3 + dice.below(12)),
            side: if dice.coin() { -1.0 } else { 1.0 },
            direction_deg: direction_deg(difficulty, dice),
        })
    }

    /// The collision; `None` if the discs do not approach each other, or if the collision is too
    /// close to a graze or to a head-on collision to be drawn clearly.
    fn collision(&self) -> Option<Collision> {
        let towards = |speed: u32, deg: f64| {
            f64::from(speed) * DVec2::from_angle(rad_from_deg(self.direction_deg + deg))
        };
        let u1 = towards(self.speed, 0.0);
        let u2 = towards(self.target_speed, self.side * f64::from(self.way_deg));
        let normal = towards(1, -self.side * f64::from(self.line_deg));
        let relative = (u1 - u2).try_normalize()?;
        let [striker, target] = Pieces::Equal.discs();
        let head_on = Collision::at_offset(striker, target, u1, 0.0);
        let sine = normal.perp_dot(relative);
        let drawable = relative.dot(normal) > LEAST_COSINE && sine.abs() > LEAST_SINE;
        drawable.then_some(Collision {
            u2,
            offset: head_on.contact_distance() * sine,
            ..head_on
        })
    }

    /// A question about this pair; `place` is a sentence on where the discs meet.
    fn outline(&self, collision: Collision, place: &str) -> Outline {
        let way = match self.way_deg {
            0 => "ahead of it in the same direction".into(),
            180 => "in the opposite direction".into(),
            way => format!("at {} to the striker's direction", in_degrees(way)),
        };
        let [u1, u2] = [self.speed, self.target_speed].map(|it| significant(it.into()));
        let text = format!(
            "A striker moves at {u1} m/s, and an equal coin at {u2} m/s {way}. {place} The discs \
             are smooth, and no energy is lost."
        );
        let disc = collision.striker;
        Outline::new(text, Illustration::before(collision, Markings::FIGURES))
            .figure("mass_g", g_from_kg(disc.mass))
            .figure("radius_mm", mm_from_m(disc.radius))
            .figure("speed", self.speed)
            .figure("target_speed", self.target_speed)
            .figure("target_deg", self.side * f64::from(self.way_deg))
            .figure("line_deg", -self.side * f64::from(self.line_deg))
            .figure("direction_deg", self.direction_deg)
    }
}

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let ways_deg: &[u32] = match difficulty {
        Difficulty::Easy | Difficulty::Hard => &[0, 180],
        Difficulty::Middle => &[0, 60, 90, 120, 180],
    };
    let pair = MovingPair::draw(ways_deg, difficulty, dice)?;
    let collision = pair.collision()?;
    let outcome = collision.outcome();
    let place = match difficulty {
        Difficulty::Easy | Difficulty::Middle => "They collide off-centre.".into(),
        Difficulty::Hard => format!(
            "The line of impact is at {} to the striker's direction.",
            in_degrees(pair.line_deg)
        ),
    };
    let draft = pair.outline(collision, &place);
    match difficulty {
        Difficulty::Easy => frames(&pair, &outcome, draft, dice),
        Difficulty::Middle => on_the_board(&pair, &outcome, draft),
        Difficulty::Hard => match dice.below(3) {
            0 => parting(&pair, &outcome, draft),
            1 => speed(&pair, true, &outcome, draft),
            _ => speed(&pair, false, &outcome, draft),
        },
    }
}

const TOPIC: &str = "both-moving";

/// Asks which observer sees 90°, or which angle a moving observer sees.
fn frames(
    pair: &MovingPair,
    outcome: &CollisionOutcome,
    draft: Outline,
    dice: &mut Dice,
) -> Option<Question> {
    const RIDES: &str = "In the frame that moves as the coin did before the collision, the coin \
                         starts at rest, so the 90° rule for a coin at rest holds.";
    const BACK_TO_BACK: &str = "In the centre-of-mass frame the total momentum is zero, so the \
                                discs leave in opposite directions: 180°.";
    const WHO: [&str; 4] = [
        "An observer who moves as the coin did at first",
        "An observer who stands still at the edge of the board",
        "An observer who moves with the centre of mass",
        "Every observer, at any steady velocity",
    ];
    const ANGLES: [&str; 3] = [
        "90°, whatever the offset",
        "180°, whatever the offset",
        "It depends on the offset",
    ];
    const IT_DEPENDS: &str = "The offset determines the two directions. But for this observer the \
                              angle between them is always the same.";
    let angle_for = |ride: &str| {
        format!(
            "An observer moves {ride}. What angle between the two paths does this observer see?"
        )
    };
    // If the velocities were equal and opposite, the laboratory frame would be the centre-of-mass
    // frame.
    if pair.way_deg == 180 && pair.speed == pair.target_speed {
        return None;
    }
    let on_board = degrees(outcome.separation?);
    let (draft, rule) = match dice.below(3) {
        0 => (
            draft
                .named("who", TOPIC)
                .ask("For which observer is the angle between their paths exactly 90°?")
                .options(WHO, 0)
                .chooses(SquareOnTheGround, 1)
                .says(
                    "You assumed 90° in the laboratory frame. That requires one disc at rest \
                     before the collision, but here both discs move.",
                )
                .chooses(FramesMixed, 2)
                .says(BACK_TO_BACK)
                .chooses(AlwaysSquare, 3)
                .says(
                    "You assumed 90° for every observer. But a moving observer sees other \
                     velocities, and so other angles.",
                ),
            RIDES,
        ),
        1 => (
            draft
                .named("from-the-coin", TOPIC)
                .ask(angle_for("as the coin did at first"))
                .options(ANGLES, 0)
                .chooses(FramesMixed, 1)
                .says(
                    "You answered 180°. That is the angle in the centre-of-mass frame, not in \
                       the coin's.",
                )
                .chooses(None, 2)
                .says(IT_DEPENDS),
            RIDES,
        ),
        _ => (
            draft
                .named("from-the-centre", TOPIC)
                .ask(angle_for("with the centre of mass"))
                .options(ANGLES, 1)
                .chooses(FramesMixed, 0)
                .says(
                    "You answered 90°. That is the angle for an observer who moves as the coin \
                       did before the collision.",
                )
                .chooses(None, 2)
                .says(IT_DEPENDS),
            BACK_TO_BACK,
        ),
    };
    draft.shuffled(dice).why(format!(
        "{rule} In the laboratory frame the angle is {on_board}."
    ))
}

/// Asks whether the angle is more or less than 90° in the laboratory frame. For equal masses
/// without loss v₁·v₂ = u₁·u₂, so the initial directions alone determine the answer.
fn on_the_board(pair: &MovingPair, outcome: &CollisionOutcome, draft: Outline) -> Option<Question> {
    const CORNERS: [&str; 3] = ["Less than 90°", "Exactly 90°", "More than 90°"];
    let separation = outcome.separation?;
    let (right, came) = match pair.way_deg {
        0..90 => (
            0,
            "Before the collision the angle was less than 90°, and it still is afterwards:",
        ),
        90 => (
            1,
            "Before the collision the angle was 90°, and it still is afterwards:",
        ),
        _ => (
            2,
            "Before the collision the angle was more than 90°, and it still is afterwards:",
        ),
    };
    if right != 1 && (deg_from_rad(separation) - 90.0).abs() < NEAR_SQUARE_DEG {
        return None;
    }
    draft
        .named("on-the-board", TOPIC)
        .ask("In the laboratory frame, what is the angle between their paths afterwards?")
        .options(CORNERS, right)
        .chooses(None, 0)
        .says(
            "You answered less than 90°. But v₁·v₂ = u₁·u₂, so an angle of 90° or more before \
               the collision stays 90° or more.",
        )
        .chooses(SquareOnTheGround, 1)
        .says("You assumed 90° in the laboratory frame. But that rule requires one disc at rest.")
        .chooses(None, 2)
        .says(
            "Did you assume that a fast collision makes the angle large? Whether it exceeds 90° \
             depends only on the angle before the collision.",
        )
        .why(format!(
            "For equal masses, with momentum and energy conserved, v₁·v₂ = u₁·u₂. {came} {}.",
            degrees(separation)
        ))
}

/// Asks for the angle between the two paths in the laboratory frame.
fn parting(pair: &MovingPair, outcome: &CollisionOutcome, draft: Outline) -> Option<Question> {
    let sign = if pair.way_deg == 180 { -1.0 } else { 1.0 };
    let dot = sign * f64::from(pair.speed * pair.target_speed);
    let between = |v1: f64, v2: f64| degrees((dot / (v1 * v2)).clamp(-1.0, 1.0).acos());
    let speeds = [outcome.v1.length(), outcome.v2.length()];
    let [v1, v2] = Intermediate::pair(speeds, between);
    let separation = between(v1.value, v2.value);
    draft
        .named("separation", TOPIC)
        .ask("What is the angle between their paths in the laboratory frame?")
        .number(Measure::Angle, deg_from_rad(outcome.separation?))
        .wrong(SquareOnTheGround, 90.0)
        .says("Your answer is close to 90°. That requires one disc at rest.")
        .wrong(FramesMixed, 180.0)
        .says("Your answer is close to 180°, the angle in the centre-of-mass frame.")
        .why(format!(
            "Along the line of impact n the discs exchange components; along t each keeps its own. \
             The speeds become {v1} and {v2} m/s. As v₁·v₂ = u₁·u₂, the cosine of the angle is \
             {} / ({v1} × {v2}), and the angle is {separation}.",
            true_minus(&significant(dot))
        ))
}

/// Asks for the final speed of one of the two discs: equal discs exchange their components along
/// the line of impact, and each disc keeps its own perpendicular component.
fn speed(
    pair: &MovingPair,
    of_target: bool,
    outcome: &CollisionOutcome,
    draft: Outline,
) -> Option<Question> {
    let line = rad_from_deg(f64::from(pair.line_deg));
    let (sin, cos) = line.sin_cos();
    let (u1, u2) = (f64::from(pair.speed), f64::from(pair.target_speed));
    let relative = if pair.way_deg == 180 {
        u1 + u2
    } else {
        u1 - u2
    };
    let (name, id, velocity, seen) = if of_target {
        ("coin", "target-speed", outcome.v2, relative * cos)
    } else {
        ("striker", "striker-speed", outcome.v1, relative * sin)
    };
    let (own, others) = if of_target { (u2, u1) } else { (u1, u2) };
    let truth = velocity.length();
    let speed = |along: f64, across: f64| significant(along.hypot(across));
    let [along, across] = Intermediate::pair([others * cos, own * sin], speed);
    let [taken, kept] = [others, own].map(significant);
    let all = speed(along.value, across.value);
    draft
        .named(id, TOPIC)
        .ask(format!("What is the {name}'s speed after the collision?"))
        .number(Measure::Speed, truth)
        .wrong(CoinAtRest, seen)
        .says("You treated the coin as if it had been at rest. But here both discs move.")
        .wrong(SineCosine, (others * sin).hypot(own * cos))
        .says(
            "You exchanged the components along t. Those stay the same; the components along n are \
             exchanged.",
        )
        .wrong(OneLineFormula, others)
        .says(
            "You exchanged the whole velocities. Off-centre, only the components along n are \
             exchanged.",
        )
        .why(format!(
            "Along the line of impact n the {name} gets the {other}'s {taken} m/s × cos {line}° = {along} m/s. Along t it keeps {kept} m/s × sin \
             {line}° = {across} m/s. Together: √({along}² + {across}²) = {all} m/s.",
            line = bare_degrees(line),
            other = if of_target { "striker" } else { "coin" },
        ))
}
