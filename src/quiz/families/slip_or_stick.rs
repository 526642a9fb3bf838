//! Slipping, e = 0 with smooth rims, against sticking: how the two go on.

use super::prelude::*;
use crate::physics::Bond;

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
    fn restitution(self) -> f64 {
        if self == Self::Lossless { 1.0 } else { 0.0 }
    }

    /// The hit with these rims.
    fn collision(self, hit: &Hit) -> Collision {
        Collision {
            restitution: self.restitution(),
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
            .named(asked, topic)
            .ask(text)
            .figure("rims", id)
    }
}

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let by_number: [fn(&Hit) -> Option<Question>; 4] = [parting, striker_speed, pair_speed, loss];
    let (pieces, asks) = match difficulty {
        Difficulty::Easy => (EQUAL, 0),
        Difficulty::Middle => (EQUAL, 3),
        Difficulty::Hard => (UNEQUAL, 4),
    };
    let hit = HitDraws(pieces, 20..=70, &[0.0]).draw(difficulty, dice)?;
    match dice.pick(&by_number[..asks]) {
        Some(ask) => ask(&hit),
        None => by_choice(&hit, dice),
    }
}

/// How do they go on? Equal masses.
fn by_choice(hit: &Hit, dice: &mut Dice) -> Option<Question> {
    /// The first three in the order of [`Rims`].
    const WAYS: [&str; 4] = [
        "They part at exactly 90°",
        "They part at less than 90°",
        "They stay together and move on",
        "They stay together, at rest",
    ];
    let rims = *dice.pick(&[
        Rims::Slip,
        Rims::Slip,
        Rims::Stick,
        Rims::Stick,
        Rims::Lossless,
    ])?;
    let hit = &hit.with_restitution(rims.restitution());
    let outcome = rims.collision(hit).outcome();
    let across = significant(hit.speed * hit.alpha().abs().sin());
    // What is said to whoever lets them part at less than 90°, or stay together.
    let (narrow, together, why) = match rims {
        Rims::Lossless => (
            "You let some of the bounce be lost. With e = 1 all of it comes back.",
            "You let them stick. But smooth rims cannot hold each other.",
            format!(
                "Along the line of impact the coin takes all that the striker had. Across it the \
                 striker keeps its {across} m/s: they part at 90°."
            ),
        ),
        Rims::Slip => (
            "",
            "You let them stick. But smooth rims do not grip: across the line of impact nothing \
             is stopped.",
            format!(
                "Along the line of impact both go on at one speed. Across it the striker keeps \
                 its {across} m/s and slides off: they part at {}.",
                degrees(outcome.separation?)
            ),
        ),
        Rims::Stick => (
            "You let them slip along each other. That is what smooth rims do at e = 0; these hold \
             fast.",
            "",
            format!(
                "Stuck together they go on with their centre of mass, at {} m/s. Off-centre, the \
                 pair also turns.",
                significant(outcome.v1.length())
            ),
        ),
    };
    rims.ask(hit, "picture", "How do the two go on?")
        .options(WAYS, rims as usize)
        .chooses(Lossless, 0)
        .says("You let them part as if nothing were lost. Here nothing throws them apart.")
        .chooses((rims == Rims::Stick).then_some(GripIgnored), 1)
        .says(narrow)
        .chooses(GripStopsAll, 2)
        .says(together)
        .chooses(MomentumLost, 3)
        .says(
            "You let all motion go. Energy can be lost, but momentum cannot: the two carry it on.",
        )
        .shuffled(dice)
        .why(why)
}

/// The striker's share of the masses, which is the share of its speed that the two have in
/// common.
fn share(hit: &Hit) -> f64 {
    let [m1, m2] = hit.masses_g();
    m1 / (m1 + m2)
}

/// The striker's speed along the line of impact and across it.
fn parts(hit: &Hit) -> (f64, f64) {
    let (sin, cos) = hit.alpha().abs().sin_cos();
    (hit.speed * cos, hit.speed * sin)
}

fn shared(hit: &Hit) -> String {
    format!(
        "Along the line of impact the two go on together, at {} m/s.",
        significant(share(hit) * parts(hit).0)
    )
}

/// The angle at which the two slip apart.
fn parting(hit: &Hit) -> Option<Question> {
    let name = hit.pieces.target_name();
    let (along, across) = parts(hit);
    let separation = |rims: Rims| rims.collision(hit).outcome().separation.map(deg_from_rad);
    Rims::Slip
        .ask(hit, "separation", "At what angle do they part?")
        .number(Measure::Angle, separation(Rims::Slip)?)
        .wrong(GripStopsAll, 0.0)
        .says("You let them stick. Smooth rims do not grip: the striker slides off.")
        .wrong(Lossless, separation(Rims::Lossless))
        .says(
            "That is the angle without loss. With e = 0 nothing springs back along the line of \
             impact.",
        )
        .wrong(AlwaysSquare, 90.0)
        .says("You took 90°. That is for equal masses without loss.")
        .why(format!(
            "{} Across it the striker keeps {across} m/s, the {name} has none: the tangent of the \
             angle is {across} / {}.",
            shared(hit),
            significant(share(hit) * along),
            across = significant(across),
        ))
}

/// How fast the striker slips on.
fn striker_speed(hit: &Hit) -> Option<Question> {
    let (_, across) = parts(hit);
    let speed = |rims: Rims| rims.collision(hit).outcome().v1.length();
    let [u, kept, both] = [hit.speed, across, speed(Rims::Slip)].map(significant);
    Rims::Slip
        .ask(hit, "striker-speed", "How fast does the striker go on?")
        .number(Measure::Speed, speed(Rims::Slip))
        .wrong(GripStopsAll, speed(Rims::Stick))
        .says(
            "You let them stick and share all the speed. Across the line of impact smooth rims \
             share nothing.",
        )
        .wrong(Lossless, speed(Rims::Lossless))
        .says(
            "That is the speed without loss. With e = 0 the two stay level along the line of \
             impact.",
        )
        .wrong(MomentumLost, (!hit.masses_are_equal()).then_some(across))
        .says(
            "You let all that was along the line of impact be lost. But momentum stays: the two \
             share it.",
        )
        .why(format!(
            "{} Across it the striker keeps {u} sin {} = {kept} m/s. The two parts are at right \
             angles: together {both} m/s.",
            shared(hit),
            bare_degrees(hit.alpha().abs()),
        ))
}

/// How fast the stuck pair goes on.
fn pair_speed(hit: &Hit) -> Option<Question> {
    let (u, share) = (hit.speed, share(hit));
    let outcome = Rims::Stick.collision(hit).outcome();
    Rims::Stick
        .ask(hit, "pair-speed", "How fast does the pair go on?")
        .number(Measure::Speed, outcome.v1.length())
        .wrong(GripIgnored, share * parts(hit).0)
        .says(
            "You shared only the part along the line of impact. Sticky rims share the part \
             across, too.",
        )
        .wrong(Lossless, u * share.sqrt())
        .says("You kept the energy of motion. Sticking costs energy; what stays is the momentum.")
        .wrong(HalfwayCentre, (!hit.masses_are_equal()).then_some(u / 2.0))
        .says("You took half the speed. That is for equal masses.")
        .wrong(UpsideDown, u * (1.0 - share))
        .says("You had the masses the other way round: a heavier striker is slowed less.")
        .why(format!(
            "Stuck together they go on with their centre of mass: m₁ / (m₁ + m₂) = {} times {} \
             m/s, wherever they touch.",
            significant(share),
            significant(u)
        ))
}

/// The share of the energy that is lost as they slip.
fn loss(hit: &Hit) -> Option<Question> {
    let (sin, cos) = hit.alpha().abs().sin_cos();
    let (share, at_stake) = (share(hit), cos.powi(2));
    let outcome = Rims::Slip.collision(hit).outcome();
    Rims::Slip
        .ask(hit, "energy-lost", "What share of the energy is lost?")
        .number(
            Measure::Share,
            100.0 * outcome.energy_lost / outcome.energy_before,
        )
        .wrong(GripStopsAll, 100.0 * (1.0 - share))
        .says("You let them go on as one. But across the line of impact smooth rims stop nothing.")
        .wrong(MomentumLost, 100.0 * at_stake)
        .says(
            "You let all that was along the line of impact be lost. But momentum stays, and some \
             energy with it.",
        )
        .wrong(UpsideDown, 100.0 * share * at_stake)
        .says("You had the masses the other way round: against a heavier target more is lost.")
        .wrong(SineCosine, 100.0 * (1.0 - share) * sin.powi(2))
        .says("You took the sine for the cosine. A graze loses least, a head-on hit most.")
        .why(format!(
            "Only the part along the line of impact is at stake: cos² {} = {} of the energy. Of \
             that, m₂ / (m₁ + m₂) = {} is lost.",
            bare_degrees(hit.alpha().abs()),
            significant(at_stake),
            significant(1.0 - share)
        ))
}
