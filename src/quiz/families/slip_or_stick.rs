//! Slipping, e = 0 with smooth rims, against sticking: how the two go on.

use super::hit_draws::{EQUAL, HitDraws, UNEQUAL, in_short};
use super::outline::Outline;
use crate::numbers::{bare_degrees, degrees, significant};
use crate::physics::units::deg_from_rad;
use crate::physics::{Bond, Collision};
use crate::quiz::misconceptions::catalogue::{
    GRIP_IGNORED, GRIP_STOPS_ALL, HALFWAY_CENTRE, MOMENTUM_LOST, SINE_COSINE, UPSIDE_DOWN,
};
use crate::quiz::misconceptions::{ALWAYS_SQUARE, LOSSLESS};
use crate::quiz::question::Dice;
use crate::quiz::question::{Difficulty, Hit, Illustration, Markings, Measure, Question};

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
    /// The hit with these rims.
    fn collision(self, hit: &Hit) -> Collision {
        Collision {
            restitution: if self == Self::Lossless { 1.0 } else { 0.0 },
            bond: if self == Self::Stick {
                Bond::Stick
            } else {
                Bond::Slip
            },
            ..hit.collision()
        }
    }

    /// A question about a hit with these rims.
    fn ask(self, hit: &Hit, asked: &'static str, text: &str) -> Outline {
        let (id, topic, words) = match self {
            Self::Lossless => (
                "lossless",
                "smooth-no-loss",
                "The rims are smooth and no energy is lost: e = 1.",
            ),
            Self::Slip => (
                "slip",
                "smooth-no-spring",
                "The rims are smooth and nothing springs back: e = 0.",
            ),
            Self::Stick => (
                "stick",
                "sticking",
                "The rims are sticky and hold fast where they touch.",
            ),
        };
        let shown = Markings {
            angle: true,
            ..Markings::FIGURES
        };
        let picture = Illustration::before(self.collision(hit), shown);
        Outline::told(hit, format!("{} {words}", in_short(hit)), picture)
            .ask(topic, text)
            .figure("rims", id)
            .figure("asked", asked)
    }
}

/// Draws a question.
pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let by_number: [fn(&Hit) -> Option<Outline>; 4] = [parting, striker_speed, pair_speed, loss];
    let (pieces, asks) = match difficulty {
        Difficulty::Easy => (EQUAL, 0),
        Difficulty::Middle => (EQUAL, 3),
        Difficulty::Hard => (UNEQUAL, 4),
    };
    let hit = HitDraws::new(pieces, 20..=70, &[0.0]).draw(difficulty, dice)?;
    let draft = match dice.pick(&by_number[..asks]) {
        Some(ask) => ask(&hit),
        None => by_choice(&hit, dice),
    };
    draft.map(Outline::finish)
}

/// How do they go on? Equal masses.
fn by_choice(hit: &Hit, dice: &mut Dice) -> Option<Outline> {
    const SQUARE: &str = "They part at exactly 90°";
    const NARROW: &str = "They part at less than 90°";
    const MOVING: &str = "They stay together and move on";
    const STILL: &str = "They stay together, at rest";
    const BOUNCED: &str =
        "You let them part as if nothing were lost. Here nothing throws them apart.";
    let rims = *dice.pick(&[
        Rims::Slip,
        Rims::Slip,
        Rims::Stick,
        Rims::Stick,
        Rims::Lossless,
    ])?;
    let hit = &hit.with_restitution(if rims == Rims::Lossless { 1.0 } else { 0.0 });
    let outcome = rims.collision(hit).outcome();
    let across = significant(hit.speed * hit.alpha().abs().sin());
    let draft = rims.ask(hit, "picture", "How do the two go on?");
    let draft = match rims {
        Rims::Lossless => draft
            .right(SQUARE)
            .choice(None, NARROW)
            .says("You let some of the bounce be lost. With e = 1 all of it comes back.")
            .choice(&GRIP_STOPS_ALL, MOVING)
            .says("You let them stick. But smooth rims cannot hold each other.")
            .why(format!(
                "Along the line of impact the coin takes all that the striker had. Across it the \
                 striker keeps its {across} m/s: a corner of 90°."
            )),
        Rims::Slip => draft
            .choice(&LOSSLESS, SQUARE)
            .says(BOUNCED)
            .right(NARROW)
            .choice(&GRIP_STOPS_ALL, MOVING)
            .says(
                "You let them stick. But smooth rims do not grip: across the line of impact \
                 nothing is stopped.",
            )
            .why(format!(
                "Along the line of impact both go on alike. Across it the striker keeps its \
                 {across} m/s and slides off: they part at {}.",
                degrees(outcome.separation?)
            )),
        Rims::Stick => draft
            .choice(&LOSSLESS, SQUARE)
            .says(BOUNCED)
            .choice(&GRIP_IGNORED, NARROW)
            .says(
                "You let them slip along each other. So it would be with smooth rims and e = 0; \
                 these hold fast.",
            )
            .right(MOVING)
            .why(format!(
                "Stuck together they go on with their centre of mass, at {} m/s. Off-centre, the \
                 pair also turns.",
                significant(outcome.v1.length())
            )),
    };
    let draft = draft.choice(&MOMENTUM_LOST, STILL).says(
        "You let all motion go. Energy can be lost, but momentum cannot: the two carry it on.",
    );
    Some(draft.shuffled(dice))
}

/// The striker's share of the masses, which is the share of its speed that the two have in
/// common.
fn share(hit: &Hit) -> f64 {
    let (m1, m2) = hit.masses_g();
    m1 / (m1 + m2)
}

/// The striker's speed along the line of impact and across it.
fn parts(hit: &Hit) -> (f64, f64) {
    let (sin, cos) = hit.alpha().abs().sin_cos();
    (hit.speed * cos, hit.speed * sin)
}

fn shared(hit: &Hit) -> String {
    format!(
        "Along the line of impact the two go on alike, with {} m/s.",
        significant(share(hit) * parts(hit).0)
    )
}

/// The angle at which the two slip apart.
fn parting(hit: &Hit) -> Option<Outline> {
    let name = hit.pieces.target_name();
    let (along, across) = parts(hit);
    let separation = |rims: Rims| rims.collision(hit).outcome().separation.map(deg_from_rad);
    let draft = Rims::Slip
        .ask(hit, "separation", "At what angle do they part?")
        .number(Measure::Angle, separation(Rims::Slip)?)
        .wrong(&GRIP_STOPS_ALL, 0.0)
        .says("You let them stick. Smooth rims do not grip: the striker slides off.")
        .wrong(&LOSSLESS, separation(Rims::Lossless))
        .says(
            "That is the angle without loss. With e = 0 nothing springs back along the line of \
             impact.",
        )
        .wrong(&ALWAYS_SQUARE, 90.0)
        .says("You took 90°. That is for equal masses without loss.")
        .why(format!(
            "{} Across it the striker keeps {across} m/s, the {name} has none: the tangent of the \
             angle is {across} / {}.",
            shared(hit),
            significant(share(hit) * along),
            across = significant(across),
        ));
    Some(draft)
}

/// How fast the striker slips on.
fn striker_speed(hit: &Hit) -> Option<Outline> {
    let (_, across) = parts(hit);
    let speed = |rims: Rims| rims.collision(hit).outcome().v1.length();
    let draft = Rims::Slip
        .ask(hit, "striker-speed", "How fast does the striker go on?")
        .number(Measure::Speed, speed(Rims::Slip))
        .wrong(&GRIP_STOPS_ALL, speed(Rims::Stick))
        .says(
            "You let them stick and share all the speed. Across the line of impact smooth rims \
             share nothing.",
        )
        .wrong(&LOSSLESS, speed(Rims::Lossless))
        .says(
            "That is the speed without loss. With e = 0 the two stay level along the line of \
             impact.",
        )
        .wrong(&MOMENTUM_LOST, (!hit.masses_are_equal()).then_some(across))
        .says(
            "You let all that was along the line of impact be lost. But momentum stays: the two \
             share it.",
        )
        .why(format!(
            "{} Across it the striker keeps {} sin {} = {} m/s. Those two are square to each \
             other and make {} m/s.",
            shared(hit),
            significant(hit.speed),
            bare_degrees(hit.alpha().abs()),
            significant(across),
            significant(speed(Rims::Slip))
        ));
    Some(draft)
}

/// How fast the stuck pair goes on.
fn pair_speed(hit: &Hit) -> Option<Outline> {
    let (u, share) = (hit.speed, share(hit));
    let draft = Rims::Stick
        .ask(hit, "pair-speed", "How fast does the pair go on?")
        .number(
            Measure::Speed,
            Rims::Stick.collision(hit).outcome().v1.length(),
        )
        .wrong(&GRIP_IGNORED, share * parts(hit).0)
        .says(
            "You shared only the part along the line of impact. Sticky rims take the part across \
             along, too.",
        )
        .wrong(&LOSSLESS, u * share.sqrt())
        .says("You kept the energy of motion. Sticking costs energy; what stays is the momentum.")
        .wrong(
            &HALFWAY_CENTRE,
            (!hit.masses_are_equal()).then_some(u / 2.0),
        )
        .says("You took half the speed. That is for equal masses.")
        .wrong(&UPSIDE_DOWN, u * (1.0 - share))
        .says("You had the masses the other way round: a heavier striker is slowed less.")
        .why(format!(
            "Stuck together they go on with their centre of mass: m₁ / (m₁ + m₂) = {} times {} \
             m/s, wherever they touch.",
            significant(share),
            significant(u)
        ));
    Some(draft)
}

/// The share of the energy that is lost as they slip.
fn loss(hit: &Hit) -> Option<Outline> {
    let (sin, cos) = hit.alpha().abs().sin_cos();
    let (share, at_stake) = (share(hit), cos.powi(2));
    let outcome = Rims::Slip.collision(hit).outcome();
    let draft = Rims::Slip
        .ask(hit, "energy-lost", "What share of the energy is lost?")
        .number(
            Measure::Share,
            100.0 * outcome.energy_lost / outcome.energy_before,
        )
        .wrong(&GRIP_STOPS_ALL, 100.0 * (1.0 - share))
        .says("You let them go on as one. But across the line of impact smooth rims stop nothing.")
        .wrong(&MOMENTUM_LOST, 100.0 * at_stake)
        .says(
            "You let all that was along the line of impact be lost. But momentum stays, and some \
             energy with it.",
        )
        .wrong(&UPSIDE_DOWN, 100.0 * share * at_stake)
        .says("You had the masses the other way round: against a heavier target more is lost.")
        .wrong(&SINE_COSINE, 100.0 * (1.0 - share) * sin.powi(2))
        .says("You took the sine for the cosine. A graze loses least, a head-on hit most.")
        .why(format!(
            "Only the part along the line of impact is at stake: cos² {} = {} of the energy. Of \
             that, m₂ / (m₁ + m₂) = {} is lost.",
            bare_degrees(hit.alpha().abs()),
            significant(at_stake),
            significant(1.0 - share)
        ));
    Some(draft)
}
