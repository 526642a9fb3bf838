//! Smooth rims with e = 0, compared with rims that stick: how the two discs move after the
//! collision.

use super::prelude::*;
use crate::physics::Bond;

#[derive(Clone, Copy, PartialEq)]
enum RimKind {
    /// The rims are smooth, and no energy is lost.
    Lossless,
    /// The rims are smooth and the discs do not rebound: e = 0.
    Slip,
    /// The discs stick together where they touch.
    Stick,
}

impl RimKind {
    fn restitution(self) -> f64 {
        if self == Self::Lossless { 1.0 } else { 0.0 }
    }

    /// The collision that a hit becomes if the discs have these rims.
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

    /// A question about a hit between discs with these rims.
    fn ask(self, hit: &Hit, asked: &'static str, text: &str) -> Outline {
        let (id, topic, words) = match self {
            Self::Lossless => (
                "lossless",
                "smooth-no-loss",
                "The discs are smooth and no energy is lost: e = 1.",
            ),
            Self::Slip => (
                "slip",
                "smooth-no-spring",
                "The rims are frictionless and the discs do not rebound: e = 0.",
            ),
            Self::Stick => (
                "stick",
                "sticking",
                "Glue on the rims holds the discs together where they touch.",
            ),
        };
        let shown = Markings {
            angle: true,
            ..Markings::FIGURES
        };
        let picture = Illustration::before(self.collision(hit), shown);
        Outline::with_text(hit, format!("{} {words}", in_short(hit)), picture)
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

/// Asks, with choices, how two discs of equal mass move after the collision.
fn by_choice(hit: &Hit, dice: &mut Dice) -> Option<Question> {
    /// The choices, the first three in the order of [`RimKind`].
    const WAYS: [&str; 4] = [
        "They move apart at exactly 90°",
        "They move apart at less than 90°",
        "They stay together and move on",
        "They stay together, at rest",
    ];
    let rims = *dice.pick(&[
        RimKind::Slip,
        RimKind::Slip,
        RimKind::Stick,
        RimKind::Stick,
        RimKind::Lossless,
    ])?;
    let hit = &hit.with_restitution(rims.restitution());
    let outcome = rims.collision(hit).outcome();
    let across = significant(hit.speed * hit.alpha().abs().sin());
    // The feedback for "less than 90°" and for "stay together", and the explanation.
    let (narrow, together, why) = match rims {
        RimKind::Lossless => (
            "You assumed that some energy is lost. With e = 1 none is lost.",
            "You assumed that they stay together. But smooth rims cannot hold each other.",
            format!(
                "Along the line of impact the coin gets all of the striker's velocity. \
                 Perpendicular to that line the striker keeps its {across} m/s: the angle between \
                 the paths is 90°."
            ),
        ),
        RimKind::Slip => (
            "",
            "You assumed that they stay together. But smooth rims do not grip: perpendicular to \
             the line of impact there is no force.",
            format!(
                "Along the line of impact both discs move on at the same speed. Perpendicular to \
                 that line the striker keeps its {across} m/s: the angle between the paths is {}.",
                degrees(outcome.separation?)
            ),
        ),
        RimKind::Stick => (
            "You assumed that the rims slip past each other. Smooth rims do that at e = 0, but \
             these rims are held together.",
            "",
            format!(
                "The collision is perfectly inelastic: they move on together, with their centre \
                 of mass, at {} m/s. Off-centre, the pair also rotates.",
                significant(outcome.v1.length())
            ),
        ),
    };
    rims.ask(hit, "picture", "How do the two discs move afterwards?")
        .options(WAYS, rims as usize)
        .chooses(Lossless, 0)
        .says("You assumed that no energy is lost. But these discs do not rebound.")
        .chooses((rims == RimKind::Stick).then_some(GripIgnored), 1)
        .says(narrow)
        .chooses(GripStopsAll, 2)
        .says(together)
        .chooses(MomentumLost, 3)
        .says("You assumed that all motion is lost. Energy can be lost, but momentum is conserved.")
        .shuffled(dice)
        .why(why)
}

/// The striker's fraction of the total mass. A joined pair moves on at this fraction of the
/// striker's initial speed.
fn share(hit: &Hit) -> f64 {
    let [m1, m2] = hit.masses_g();
    m1 / (m1 + m2)
}

/// The components of the striker's initial velocity along the line of impact and perpendicular to
/// it.
fn parts(hit: &Hit) -> (f64, f64) {
    let (sin, cos) = hit.alpha().abs().sin_cos();
    (hit.speed * cos, hit.speed * sin)
}

fn shared(along: &Intermediate) -> String {
    format!("Along the line of impact both move on at {along} m/s.")
}

/// Asks for the angle between the paths of discs that slip.
fn parting(hit: &Hit) -> Option<Question> {
    let name = hit.pieces.target_name();
    let (along, across) = parts(hit);
    let separation = |rims: RimKind| rims.collision(hit).outcome().separation.map(deg_from_rad);
    let between = |along: f64, across: f64| degrees(across.atan2(along));
    let [shown, across] = Intermediate::pair([share(hit) * along, across], between);
    RimKind::Slip
        .ask(hit, "separation", "What is the angle between their paths?")
        .number(Measure::Angle, separation(RimKind::Slip)?)
        .wrong(GripStopsAll, 0.0)
        .says(
            "You assumed that they move on together. Smooth rims do not grip: the striker \
               slides off.",
        )
        .wrong(Lossless, separation(RimKind::Lossless))
        .says(
            "That is the angle if no energy is lost. With e = 0 the discs do not rebound along \
             the line of impact.",
        )
        .wrong(AlwaysSquare, 90.0)
        .says("Your answer is close to 90°. That is right for equal masses if no energy is lost.")
        .why(format!(
            "{} Perpendicular to it the striker keeps {across} m/s and the {name} has none: the \
             tangent of the angle is {across} / {shown}, and the angle is {}.",
            shared(&shown),
            between(shown.value, across.value),
        ))
}

/// Asks for the striker's final speed.
fn striker_speed(hit: &Hit) -> Option<Question> {
    let (along, across) = parts(hit);
    let speed = |rims: RimKind| rims.collision(hit).outcome().v1.length();
    let both = |along: f64, across: f64| significant(along.hypot(across));
    let [along, kept] = Intermediate::pair([share(hit) * along, across], both);
    RimKind::Slip
        .ask(
            hit,
            "striker-speed",
            "What is the striker's speed after the collision?",
        )
        .number(Measure::Speed, speed(RimKind::Slip))
        .wrong(GripStopsAll, speed(RimKind::Stick))
        .says("You assumed that they move on together. But smooth rims do not grip.")
        .wrong(Lossless, speed(RimKind::Lossless))
        .says(
            "That is the speed if no energy is lost. With e = 0 both are equally fast along the \
             line of impact.",
        )
        .wrong(MomentumLost, (!hit.masses_are_equal()).then_some(across))
        .says(
            "You assumed that all motion along the line of impact is lost. But momentum is \
             conserved: the discs share it.",
        )
        .why(format!(
            "{} Perpendicular to it the striker keeps {} m/s × sin {}° = {kept} m/s. Together: \
             √({along}² + {kept}²) = {} m/s.",
            shared(&along),
            significant(hit.speed),
            bare_degrees(hit.alpha().abs()),
            both(along.value, kept.value),
        ))
}

/// Asks for the final speed of the joined pair.
fn pair_speed(hit: &Hit) -> Option<Question> {
    let (u, share) = (hit.speed, share(hit));
    let shown = Intermediate::new(share, |share| significant(share * u));
    let outcome = RimKind::Stick.collision(hit).outcome();
    RimKind::Stick
        .ask(
            hit,
            "pair-speed",
            "What is the pair's speed after the collision?",
        )
        .number(Measure::Speed, outcome.v1.length())
        .wrong(GripIgnored, share * parts(hit).0)
        .says(
            "You shared only the component along the line of impact. Discs that are held together \
             share the perpendicular component, too.",
        )
        .wrong(Lossless, u * share.sqrt())
        .says(
            "You assumed that kinetic energy is conserved. Some of it is lost here; only \
               momentum is conserved.",
        )
        .wrong(HalfwayCentre, (!hit.masses_are_equal()).then_some(u / 2.0))
        .says("You halved the speed. That is right for equal masses.")
        .wrong(UpsideDown, u * (1.0 - share))
        .says("You swapped the two masses: a heavier striker is slowed less.")
        .why(format!(
            "They move on with their centre of mass: m₁ / (m₁ + m₂) of the striker's speed is \
             {shown} × {} m/s = {} m/s, at any offset.",
            significant(u),
            significant(shown.value * u)
        ))
}

/// Asks for the fraction of the energy that is lost if the discs slip.
fn loss(hit: &Hit) -> Option<Question> {
    let (sin, cos) = hit.alpha().abs().sin_cos();
    let (share, at_stake) = (share(hit), cos.powi(2));
    let outcome = RimKind::Slip.collision(hit).outcome();
    let percent = |of: f64, share: f64| Measure::Share.print(100.0 * of * share);
    let [shown, lost] = Intermediate::pair([at_stake, 1.0 - share], percent);
    RimKind::Slip
        .ask(
            hit,
            "energy-lost",
            "What share of the kinetic energy is lost?",
        )
        .number(
            Measure::Share,
            100.0 * outcome.energy_lost / outcome.energy_before,
        )
        .wrong(GripStopsAll, 100.0 * (1.0 - share))
        .says(
            "You assumed that they move on together. But smooth rims do not stop the \
               perpendicular motion.",
        )
        .wrong(MomentumLost, 100.0 * at_stake)
        .says(
            "You assumed that all energy of motion along the line of impact is lost. But momentum \
             is conserved.",
        )
        .wrong(UpsideDown, 100.0 * share * at_stake)
        .says("You swapped the two masses: with a heavier striker a smaller share is lost.")
        .wrong(SineCosine, 100.0 * (1.0 - share) * sin.powi(2))
        .says(
            "You used the sine instead of the cosine. The loss is smallest near a graze and \
               greatest head-on.",
        )
        .why(format!(
            "Only the energy of motion along the line of impact can be lost: cos² {}° = {shown} of \
             the total. The share m₂ / (m₁ + m₂) = {lost} of that is lost: {shown} × {lost} = {}.",
            bare_degrees(hit.alpha().abs()),
            percent(shown.value, lost.value)
        ))
}
