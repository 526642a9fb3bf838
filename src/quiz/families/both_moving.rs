//! Two equal discs that both move: who sees them part at 90°, and what is seen on the
//! board.

use glam::DVec2;

use super::prelude::*;
use crate::physics::CollisionOutcome;
use crate::physics::units::g_from_kg;

/// The largest impact angle asked about, as its cosine: beyond it they hardly touch.
const LEAST_COSINE: f64 = 0.3;

/// The smallest impact angle asked about, as its sine: a meeting nearer to head-on is not
/// seen to be off-centre.
const LEAST_SINE: f64 = 0.17;

/// Nearer to 90° than this no one is asked whether it is more or less, in degrees.
const NEAR_SQUARE_DEG: f64 = 5.0;

/// Two equal discs about to meet.
#[derive(Clone, Copy)]
struct MovingPair {
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
            offset: head_on.contact_distance() * sine,
            ..head_on
        })
    }

    /// A question about the two, after this sentence on where they meet.
    fn told(&self, collision: Collision, place: &str) -> Outline {
        let way = match self.way_deg {
            0 => "ahead of it, the same way".into(),
            180 => "the opposite way".into(),
            way => format!("at {} to its path", in_degrees(way)),
        };
        let [u1, u2] = [self.speed, self.target_speed].map(|it| significant(it.into()));
        let text = format!(
            "A striker moves at {u1} m/s, an equal coin at {u2} m/s {way}. {place} Smooth rims, \
             no energy lost."
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
        Difficulty::Easy | Difficulty::Middle => "They meet off-centre.".into(),
        Difficulty::Hard => format!(
            "The line of impact makes {} with the striker's path.",
            in_degrees(pair.line_deg)
        ),
    };
    let draft = pair.told(collision, &place);
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

/// Who sees 90°, or what somebody sees who moves along.
fn frames(
    pair: &MovingPair,
    outcome: &CollisionOutcome,
    draft: Outline,
    dice: &mut Dice,
) -> Option<Question> {
    const RIDES: &str = "Move with the velocity that the coin had before the hit: seen from there \
                         it is at rest at first, and the rule for a coin at rest holds.";
    const BACK_TO_BACK: &str = "With the centre of mass the momentum is zero, so the two part \
                                back to back: 180°.";
    const WHO: [&str; 4] = [
        "Someone who moves as the coin did before the hit",
        "Someone who stands still at the edge of the board",
        "Someone who moves with the centre of mass",
        "Everyone, however they move",
    ];
    const ANGLES: [&str; 3] = [
        "At 90°, wherever they touch",
        "At 180°, wherever they touch",
        "At an angle that depends on the offset",
    ];
    const IT_DEPENDS: &str = "The offset decides where they go. But seen from there, the angle \
                              between them is always the same.";
    let angle_for =
        |ride: &str| format!("At what angle do they part, seen by someone who moves {ride}?");
    // The board would be the frame of the centre of mass.
    if pair.way_deg == 180 && pair.speed == pair.target_speed {
        return None;
    }
    let on_board = degrees(outcome.separation?);
    let (draft, rule) = match dice.below(3) {
        0 => (
            draft
                .named("who", TOPIC)
                .ask("Who sees them part at exactly 90°?")
                .options(WHO, 0)
                .chooses(SquareOnTheGround, 1)
                .says(
                    "You looked for 90° on the board. There it takes a coin at rest, and here \
                     both move.",
                )
                .chooses(FramesMixed, 2)
                .says(BACK_TO_BACK)
                .chooses(AlwaysSquare, 3)
                .says(
                    "You took 90° for everyone. But whoever moves sees other velocities, and \
                     other angles.",
                ),
            RIDES,
        ),
        1 => (
            draft
                .named("from-the-coin", TOPIC)
                .ask(angle_for("as the coin did before the hit"))
                .options(ANGLES, 0)
                .chooses(FramesMixed, 1)
                .says("You took 180°. That is seen from the centre of mass, not from the coin.")
                .chooses(None, 2)
                .says(IT_DEPENDS),
            RIDES,
        ),
        _ => (
            draft
                .named("from-the-centre", TOPIC)
                .ask(angle_for("with their centre of mass"))
                .options(ANGLES, 1)
                .chooses(FramesMixed, 0)
                .says("You took 90°. That is seen by someone who moves as the coin did before the hit.")
                .chooses(None, 2)
                .says(IT_DEPENDS),
            BACK_TO_BACK,
        ),
    };
    draft
        .shuffled(dice)
        .why(format!("{rule} On the board the angle is {on_board}."))
}

/// More or less than 90° on the board. For equal masses without loss v₁·v₂ = u₁·u₂, so
/// that alone the way of the coin decides.
fn on_the_board(pair: &MovingPair, outcome: &CollisionOutcome, draft: Outline) -> Option<Question> {
    const CORNERS: [&str; 3] = ["Less than 90°", "Exactly 90°", "More than 90°"];
    let separation = outcome.separation?;
    let (right, came) = match pair.way_deg {
        0..90 => (
            0,
            "They came the same way, more or less, and so they go on:",
        ),
        90 => (1, "They came at right angles, and so they part:"),
        _ => (2, "They came towards each other, and so they part:"),
    };
    if right != 1 && (deg_from_rad(separation) - 90.0).abs() < NEAR_SQUARE_DEG {
        return None;
    }
    draft
        .named("on-the-board", TOPIC)
        .ask("On the board, at what angle do they part?")
        .options(CORNERS, right)
        .chooses(None, 0)
        .says("You let them go on side by side. But as they came, so they part.")
        .chooses(SquareOnTheGround, 1)
        .says("You looked for 90° on the board. But that rule wants one coin at rest.")
        .chooses(None, 2)
        .says(
            "Did you take a fast meeting to throw them wide apart? How fast they come does change \
             the angle. But whether it is more than 90° or less, the angle at which they came \
             decides.",
        )
        .why(format!(
            "Equal masses, momentum and energy kept: so v₁·v₂ = u₁·u₂. {came} {}.",
            degrees(separation)
        ))
}

/// The angle between the two on the board.
fn parting(pair: &MovingPair, outcome: &CollisionOutcome, draft: Outline) -> Option<Question> {
    let [v1, v2] = [outcome.v1, outcome.v2].map(|it| significant(it.length()));
    let sign = if pair.way_deg == 180 { "-" } else { "" };
    draft
        .named("separation", TOPIC)
        .ask("At what angle do they part on the board?")
        .number(Measure::Angle, deg_from_rad(outcome.separation?))
        .wrong(SquareOnTheGround, 90.0)
        .says("You took 90°. On the board that wants a coin at rest.")
        .wrong(FramesMixed, 180.0)
        .says("You took 180°. That is seen from the centre of mass, not on the board.")
        .why(format!(
            "Along the line of impact they exchange velocities, across it each keeps its own: so \
             they leave at {v1} and {v2} m/s. As v₁·v₂ = u₁·u₂, the cosine of the angle is \
             {sign}{} / ({v1} × {v2}).",
            significant(f64::from(pair.speed * pair.target_speed))
        ))
}

/// How fast one of the two leaves: equal discs exchange their parts along the line of
/// impact, and each keeps its own across it.
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
    let [taken, along] = [others, others * cos].map(significant);
    let [kept, across, all] = [own, own * sin, truth].map(significant);
    draft
        .named(id, TOPIC)
        .ask(format!("How fast does the {name} leave?"))
        .number(Measure::Speed, truth)
        .wrong(CoinAtRest, seen)
        .says(format!(
            "You took the coin as if it had been at rest. That is the speed of the {name} as seen \
             from the coin before the hit."
        ))
        .wrong(SineCosine, (others * sin).hypot(own * cos))
        .says(
            "You exchanged the parts across the line of impact. They are kept; those along it are \
             exchanged.",
        )
        .wrong(OneLineFormula, others)
        .says(
            "You let them exchange all of their velocities. That is for a head-on hit; here only \
             the parts along the line are exchanged.",
        )
        .why(format!(
            "Along the line of impact equal discs exchange: the {name} takes over {taken} cos \
             {line} = {along} m/s. Across it, it keeps {kept} sin {line} = {across} m/s. At right \
             angles they make {all} m/s.",
            line = bare_degrees(line),
        ))
}
