//! Rutherford's law: how many are counted at two angles, 1 / sin⁴(φ/2).

use super::prelude::*;
use crate::physics::rutherford::{ALPHA_CHARGE, MEV, Rutherford};

/// Foils and their charge numbers.
const FOILS: [(&str, f64); 4] = [
    ("gold", 79.0),
    ("silver", 47.0),
    ("platinum", 78.0),
    ("copper", 29.0),
];

/// Two angles in degrees, and how many times as many are counted at the first.
const WHOLE: [(u32, u32, u32); 4] = [(60, 180, 16), (60, 120, 9), (60, 90, 4), (90, 180, 4)];

/// A foil and the α-particles thrown at it.
struct FoilBeam {
    foil: &'static str,
    charge: f64,
    /// Kinetic energy of the α-particles in MeV.
    energy_mev: f64,
}

impl FoilBeam {
    /// A question about this beam beside this picture.
    fn told(&self, picture: Illustration) -> Outline {
        let text = format!("α-particles meet a thin foil of {}.", self.foil);
        Outline::new(text, picture)
            .figure("foil", self.foil)
            .figure("energy_mev", self.energy_mev)
    }

    /// A question that compares the counts at two angles in degrees, beside both tracks.
    fn compared(&self, from_deg: f64, to_deg: f64) -> Outline {
        let angles_deg = [from_deg.min(to_deg), from_deg.max(to_deg)];
        self.told(Illustration::Tracks {
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

/// How many times as many are counted at the first angle as at the second.
fn times_as_many(from_deg: f64, to_deg: f64) -> f64 {
    (half_sine(to_deg) / half_sine(from_deg)).powi(4)
}

/// Why, for two angles.
fn why(from_deg: f64, to_deg: f64) -> String {
    let half = |deg: f64| bare_degrees(rad_from_deg(deg / 2.0));
    let ratio = half_sine(to_deg) / half_sine(from_deg);
    format!(
        "Counts go as 1 / sin⁴ of half the angle. sin {} / sin {} = {}, and its fourth power is \
         {}.",
        half(to_deg),
        half(from_deg),
        significant(ratio),
        significant(ratio.powi(4))
    )
}

/// A whole ratio, to be chosen.
fn whole_ratio(beam: &FoilBeam, dice: &mut Dice) -> Option<Question> {
    let (near, far, times) = *dice.pick(&WHOLE)?;
    let (near_deg, far_deg) = (f64::from(near), f64::from(far));
    // Asked from the small angle to the large one, or back.
    let more_here = dice.coin();
    let many = |n: u32| format!("{n} times as many");
    let few = |n: u32| format!("1/{n} as many");
    let root = times.isqrt();
    let (here, there, [right, gentle, upside_down]) = if more_here {
        (near_deg, far_deg, [many(times), many(root), few(times)])
    } else {
        (far_deg, near_deg, [few(times), few(root), many(times)])
    };
    beam.compared(here, there)
        .named("choice", "counts-at-two-angles")
        .ask(format!(
            "Compared with {}, how many does the same small screen count at {}?",
            in_degrees(there),
            in_degrees(here)
        ))
        .options([right, gentle, upside_down, "Just as many".into()], 0)
        .chooses(TooGentle, 1)
        .says("You took the square of the sine. It is the fourth power that counts.")
        .chooses(UpsideDown, 2)
        .says(
            "You had it the other way round. Small angles are the common ones: most pass far from \
             a nucleus.",
        )
        .chooses(EveryAngleAlike, 3)
        .says(
            "You took all angles as equally likely. But to be turned far, one must pass close by, \
             and few do.",
        )
        .shuffled(dice)
        .why(why(near_deg, far_deg))
}

/// What misconceptions answer that is asked for a ratio.
fn wrong_ratios(draft: Outline, from_deg: f64, to_deg: f64, by_energy: f64) -> Outline {
    // Straight back has a whole angle whose sine is 0 but for rounding.
    let whole = (to_deg < 175.0).then(|| times_as_many(2.0 * from_deg, 2.0 * to_deg));
    let truth = by_energy * times_as_many(from_deg, to_deg);
    draft
        .number(Measure::Times, truth)
        .wrong(HalfAngleForgotten, whole.map(|whole| by_energy * whole))
        .says("You took the sine of the whole angles. What counts is half of each.")
        .wrong(
            TooGentle,
            by_energy * times_as_many(from_deg, to_deg).sqrt(),
        )
        .says("You took the square of the sines. Counts fall with the fourth power.")
        .wrong(UpsideDown, truth.recip())
}

/// A ratio as a number.
fn ratio(beam: &FoilBeam, dice: &mut Dice) -> Option<Question> {
    let (here_deg, there_deg) = two_angles(dice)?;
    let [here, there] = [here_deg, there_deg].map(in_degrees);
    let draft = beam
        .compared(here_deg, there_deg)
        .named("ratio", "counts-at-two-angles")
        .ask(format!(
            "How many times as many does a small screen count at {here} as at {there}?"
        ));
    wrong_ratios(draft, here_deg, there_deg, 1.0)
        .says("You had the ratio upside down. The smaller angle has the larger count.")
        .why(why(here_deg, there_deg))
}

/// The energy changes with the angle: d goes as 1 / E, and counts as d².
fn ratio_of_energies(beam: &FoilBeam, dice: &mut Dice) -> Option<Question> {
    let (here_deg, there_deg) = two_angles(dice)?;
    let to_energy_mev = f64::from(3 + dice.below(6));
    if (to_energy_mev - beam.energy_mev).abs() < 0.5 {
        return None;
    }
    let by_energy = (to_energy_mev / beam.energy_mev).powi(2);
    let [here, there] = [here_deg, there_deg].map(in_degrees);
    let [from, to] = [beam.energy_mev, to_energy_mev].map(significant);
    let draft = beam
        .compared(here_deg, there_deg)
        .named("ratio", "counts-angle-and-energy")
        .ask(format!(
            "How many times as many does a screen count at {here} with {from} MeV as at {there} \
             with {to} MeV?"
        ))
        .figure("to_energy_mev", to_energy_mev);
    wrong_ratios(draft, here_deg, there_deg, by_energy)
        .says("You had the ratio upside down. Counts fall with the angle, and with the energy.")
        .wrong(EveryAngleAlike, by_energy)
        .says(
            "You counted the energy alone, as if all angles were equally likely. The larger angle \
             is the rarer one.",
        )
        .why(format!(
            "{} Counts also go as 1 / E²: times {}, in all {}.",
            why(here_deg, there_deg),
            significant(by_energy),
            significant(by_energy * times_as_many(here_deg, there_deg))
        ))
}

/// The ratio is given, the angle asked for.
fn angle(beam: &FoilBeam, dice: &mut Dice) -> Option<Question> {
    let from_deg = f64::from(15 * (2 + dice.below(5)));
    let fewer = f64::from(*dice.pick(&[2_u32, 3, 4, 5, 8, 10, 16, 20, 50])?);
    // The angle at which sin⁴ of its half, or what is taken for it, is so many times as
    // large; NaN beyond 180°.
    let half_sine = half_sine(from_deg);
    let at = |sine: f64| 2.0 * deg_from_rad(sine.asin());
    let root = fewer.sqrt().sqrt();
    let truth = at(half_sine * root);
    // Close to straight back the sine hardly grows any more.
    if truth.is_nan() || truth > 165.0 {
        return None;
    }
    let [times, before, after] = [root, half_sine, half_sine * root].map(significant);
    beam.told(Illustration::Nothing)
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
        .says("You took the sine of the whole angle. What counts is half of it.")
        .wrong(TooGentle, at(half_sine * fewer.sqrt()))
        .says("You took the square of the sine. Counts fall with its fourth power.")
        .wrong(UpsideDown, at(half_sine / root))
        .says("You went to a smaller angle. There more are counted, not fewer.")
        .why(format!(
            "Counts go as 1 / sin⁴ of half the angle. For 1/{fewer} of them the sine must be \
             {times} times as large: {times} × {before} = {after}, half of the angle is {}.",
            in_degrees(truth / 2.0)
        ))
}

/// Two different angles in degrees, the smaller one first.
fn two_angles(dice: &mut Dice) -> Option<(f64, f64)> {
    let mut angle = || f64::from(15 * (2 + dice.below(10)));
    let (a, b) = (angle(), angle());
    (a < b).then_some((a, b))
}
