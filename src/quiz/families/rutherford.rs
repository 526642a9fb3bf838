//! Rutherford's law: counts at different angles are proportional to 1 / sin⁴(Θ/2).

use super::prelude::*;
use crate::physics::rutherford::{ALPHA_CHARGE, MEV, Rutherford};

/// The foils, with their charge numbers.
const FOILS: [(&str, f64); 4] = [
    ("gold", 79.0),
    ("silver", 47.0),
    ("platinum", 78.0),
    ("copper", 29.0),
];

/// Two angles in degrees, and the ratio of the count at the first angle to the count at the second.
const WHOLE: [(u32, u32, u32); 4] = [(60, 180, 16), (60, 120, 9), (60, 90, 4), (90, 180, 4)];

/// A foil, and the α-particles that hit the foil.
struct FoilBeam {
    foil: &'static str,
    charge: f64,
    /// Kinetic energy of the α-particles in MeV.
    energy_mev: f64,
}

impl FoilBeam {
    /// A question about this beam, with `picture` beside it.
    fn outline(&self, picture: Illustration) -> Outline {
        let text = format!("α-particles hit a thin {} foil.", self.foil);
        Outline::new(text, picture)
            .figure("foil", self.foil)
            .figure("energy_mev", self.energy_mev)
    }

    /// A question that compares the counts at two angles, in degrees, with the tracks for both
    /// angles beside it.
    fn compared(&self, from_deg: f64, to_deg: f64) -> Outline {
        let angles_deg = [from_deg.min(to_deg), from_deg.max(to_deg)];
        self.outline(Illustration::Tracks {
            rutherford: Rutherford::new(ALPHA_CHARGE, self.charge, self.energy_mev * MEV),
            angles: angles_deg.map(rad_from_deg),
        })
        .figure("angle_deg", from_deg)
        .figure("to_deg", to_deg)
    }
}

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let (foil, charge) = *dice.pick(&FOILS)?;
    let beam = FoilBeam {
        foil,
        charge,
        energy_mev: f64::from(5 + dice.below(4)),
    };
    match difficulty {
        Difficulty::Easy => whole_ratio(&beam, dice),
        Difficulty::Middle => ratio(&beam, dice),
        Difficulty::Hard if dice.coin() => ratio_of_energies(&beam, dice),
        Difficulty::Hard => angle(&beam, dice),
    }
}

/// The sine of half an angle in degrees.
fn half_sine(deg: f64) -> f64 {
    rad_from_deg(deg / 2.0).sin()
}

/// The ratio of the count at the first angle to the count at the second.
fn times_as_many(from_deg: f64, to_deg: f64) -> f64 {
    (half_sine(to_deg) / half_sine(from_deg)).powi(4)
}

/// The explanation for two angles; `power` formats the fourth power of the ratio of the sines.
fn why(from_deg: f64, to_deg: f64, power: impl Fn(f64) -> String) -> String {
    let half = |deg: f64| bare_degrees(rad_from_deg(deg / 2.0));
    let ratio = half_sine(to_deg) / half_sine(from_deg);
    let ratio = Intermediate::new(ratio, |ratio| power(ratio.powi(4)));
    format!(
        "Counts are proportional to 1 / sin⁴ of half the angle. sin {}° / sin {}° = {ratio}, and \
         {ratio}⁴ = {}.",
        half(to_deg),
        half(from_deg),
        power(ratio.value.powi(4))
    )
}

/// Asks, with choices, for a ratio that is a whole number.
fn whole_ratio(beam: &FoilBeam, dice: &mut Dice) -> Option<Question> {
    let (near, far, times) = *dice.pick(&WHOLE)?;
    let (near_deg, far_deg) = (f64::from(near), f64::from(far));
    // The question compares the small angle with the large angle, or vice versa.
    let more_here = dice.coin();
    let many = |n: u32| format!("{n} times as many");
    let few = |n: u32| format!("1/{n} as many");
    let root = times.isqrt();
    let (here, there, [right, gentle, reversed]) = if more_here {
        (near_deg, far_deg, [many(times), many(root), few(times)])
    } else {
        (far_deg, near_deg, [few(times), few(root), many(times)])
    };
    beam.compared(here, there)
        .named("choice", "counts-at-two-angles")
        .ask(format!(
            "Compared with {}, how many particles does the same small screen count at {}?",
            in_degrees(there),
            in_degrees(here)
        ))
        .options([right, gentle, reversed, "Just as many".into()], 0)
        .chooses(TooGentle, 1)
        .says("You used the square of the sine. The law contains the fourth power.")
        .chooses(CountsReversed, 2)
        .says(
            "You gave the larger angle the larger count. But small angles are common: most \
             particles pass far from a nucleus.",
        )
        .chooses(EveryAngleAlike, 3)
        .says(
            "You assumed that all angles are equally likely. But to be scattered far, a particle \
             must pass close to a nucleus, and few do.",
        )
        .shuffled(dice)
        .why(why(near_deg, far_deg, significant))
}

/// Adds the right ratio and the wrong ratios.
fn wrong_ratios(draft: Outline, from_deg: f64, to_deg: f64, by_energy: f64) -> Outline {
    // At 180° the sine of the whole angle is 0, apart from rounding errors.
    let whole = (to_deg < 175.0).then(|| times_as_many(2.0 * from_deg, 2.0 * to_deg));
    let truth = by_energy * times_as_many(from_deg, to_deg);
    draft
        .number(Measure::Times, truth)
        .wrong(HalfAngleForgotten, whole.map(|whole| by_energy * whole))
        .says("You used the sines of the whole angles. Halve each angle first.")
        .wrong(
            TooGentle,
            by_energy * times_as_many(from_deg, to_deg).sqrt(),
        )
        .says("You used the square of the sines. The law contains the fourth power.")
        .wrong(CountsReversed, truth.recip())
}

/// Asks for a ratio as a number.
fn ratio(beam: &FoilBeam, dice: &mut Dice) -> Option<Question> {
    let (here_deg, there_deg) = two_angles(dice)?;
    let [here, there] = [here_deg, there_deg].map(in_degrees);
    let draft = beam
        .compared(here_deg, there_deg)
        .named("ratio", "counts-at-two-angles")
        .ask(format!(
            "How many times as many particles does a small screen count at {here} as at {there}?"
        ));
    wrong_ratios(draft, here_deg, there_deg, 1.0)
        .says("You inverted the ratio. The smaller angle has the larger count.")
        .why(why(here_deg, there_deg, significant))
}

/// Asks for the ratio if both the energy and the angle change: the closest approach head-on, d, is
/// proportional to 1 / E, and counts are proportional to d².
fn ratio_of_energies(beam: &FoilBeam, dice: &mut Dice) -> Option<Question> {
    let (here_deg, there_deg) = two_angles(dice)?;
    let to_energy_mev = f64::from(3 + dice.below(6));
    if (to_energy_mev - beam.energy_mev).abs() < 0.5 {
        return None;
    }
    let energy_ratio = (to_energy_mev / beam.energy_mev).powi(2);
    let product = |angle: f64, energy: f64| significant(angle * energy);
    let by_angle = times_as_many(here_deg, there_deg);
    let [by_angle, by_energy] = Intermediate::pair([by_angle, energy_ratio], product);
    let [here, there] = [here_deg, there_deg].map(in_degrees);
    let [from, to] = [beam.energy_mev, to_energy_mev].map(significant);
    let draft = beam
        .compared(here_deg, there_deg)
        .named("ratio", "counts-angle-and-energy")
        .ask(format!(
            "How many times as many particles does a screen count at {here} with {from} MeV as at \
             {there} with {to} MeV?"
        ))
        .figure("to_energy_mev", to_energy_mev);
    wrong_ratios(draft, here_deg, there_deg, energy_ratio)
        .says("You inverted the ratio. Counts decrease as the angle or the energy increases.")
        .wrong(EveryAngleAlike, energy_ratio)
        .says("You considered the energy alone. But larger angles are rarer.")
        .why(format!(
            "{} Counts are also proportional to 1 / E²: ({to} / {from})² = {by_energy}. Together: \
             {by_angle} × {by_energy} = {}.",
            why(here_deg, there_deg, |power| fixed(
                power,
                by_angle.decimals()
            )),
            product(by_angle.value, by_energy.value)
        ))
}

/// Asks for the angle, given the ratio.
fn angle(beam: &FoilBeam, dice: &mut Dice) -> Option<Question> {
    let from_deg = f64::from(15 * (2 + dice.below(5)));
    let fewer = f64::from(*dice.pick(&[2_u32, 3, 4, 5, 8, 10, 16, 20, 50])?);
    // The angle at which the sine of half the angle has this value; NaN if the sine exceeds 1.
    let half_sine = half_sine(from_deg);
    let at = |sine: f64| 2.0 * deg_from_rad(sine.asin());
    let root = fewer.sqrt().sqrt();
    let truth = at(half_sine * root);
    // Close to 180° the sine of half the angle hardly increases.
    if truth.is_nan() || truth > 165.0 {
        return None;
    }
    let half = Intermediate::angle(rad_from_deg(truth / 2.0), |half| degrees(2.0 * half));
    let arcsine = |sine: f64| fixed(deg_from_rad(sine.asin()), half.decimals());
    let sine = Intermediate::new(half_sine * root, arcsine);
    let times = Intermediate::new(root, |root| {
        [
            fixed(half_sine * root, sine.decimals()),
            fixed(root.powi(4), 0),
        ]
    });
    beam.outline(Illustration::Nothing)
        .named("angle", "angle-of-count")
        .ask(format!(
            "At which angle does a small screen count 1/{fewer} of what it counts at {}?",
            in_degrees(from_deg)
        ))
        .figure("angle_deg", from_deg)
        .figure("fewer_times", fewer)
        .number(Measure::Angle, truth)
        .wrong(
            HalfAngleForgotten,
            at(rad_from_deg(from_deg).sin() * root) / 2.0,
        )
        .says("You used the sine of the whole angle. The law contains the sine of half the angle.")
        .wrong(TooGentle, at(half_sine * fewer.sqrt()))
        .says("You used the square of the sine. The law contains the fourth power.")
        .wrong(CountsReversed, at(half_sine / root))
        .says("You chose a smaller angle. More particles are counted there, not fewer.")
        .why(format!(
            "Counts are proportional to 1 / sin⁴ of half the angle. So the sine of half the angle \
             is {times} × sin {}° = {sine}, where {times}⁴ = {fewer}. Half the angle is {half}°, and \
             the angle is 2 × {half}° = {}.",
            bare_degrees(rad_from_deg(from_deg / 2.0)),
            in_degrees(truth)
        ))
}

/// Two different angles in degrees, the smaller one first.
fn two_angles(dice: &mut Dice) -> Option<(f64, f64)> {
    let mut angle = || f64::from(15 * (2 + dice.below(10)));
    let (a, b) = (angle(), angle());
    (a < b).then_some((a, b))
}
