//! Rutherford's law: how many are counted at two angles, 1 / sin⁴(φ/2).

use std::collections::BTreeMap;

use serde_json::json;

use super::choices::{Choice, shuffled};
use super::setting::{more, number, wrong};
use crate::physics::rutherford::{ALPHA_CHARGE, MEV, Rutherford};
use crate::physics::units::{deg_from_rad, rad_from_deg};
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::catalogue::{
    EVERY_ANGLE_ALIKE, HALF_ANGLE_FORGOTTEN, TOO_GENTLE, UPSIDE_DOWN,
};
use crate::quiz::words::{bare_degrees, degrees, significant};
use crate::quiz::{Difficulty, Family, Form, Illustration, Measure, Question, WrongAnswer};

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
struct Beam {
    foil: &'static str,
    charge: f64,
    /// Kinetic energy of the α-particles in MeV.
    energy_mev: f64,
}

impl Beam {
    fn draw(dice: &mut Dice) -> Option<Self> {
        let (foil, charge) = *dice.pick(&FOILS)?;
        let energy_mev = f64::from(5 + dice.below(4));
        Some(Self {
            foil,
            charge,
            energy_mev,
        })
    }

    fn rutherford(&self) -> Rutherford {
        Rutherford::new(ALPHA_CHARGE, self.charge, self.energy_mev * MEV)
    }

    fn words(&self) -> String {
        format!("α-particles meet a thin foil of {}.", self.foil)
    }

    fn tracks(&self, angles_deg: [f64; 2]) -> Illustration {
        Illustration::Tracks {
            rutherford: self.rutherford(),
            angles: angles_deg.map(rad_from_deg),
        }
    }
}

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let beam = Beam::draw(dice)?;
    match difficulty {
        Difficulty::Easy => whole_ratio(&beam, dice),
        Difficulty::Middle => ratio(&beam, dice),
        Difficulty::Hard if dice.coin() => ratio_of_energies(&beam, dice),
        Difficulty::Hard => angle(&beam, dice),
    }
}

/// How many times as many are counted at the first angle as at the second.
fn times_as_many(from_deg: f64, to_deg: f64) -> f64 {
    let sine = |deg: f64| rad_from_deg(deg / 2.0).sin();
    (sine(to_deg) / sine(from_deg)).powi(4)
}

/// Why, for two angles.
fn why(from_deg: f64, to_deg: f64) -> String {
    let half = |deg: f64| rad_from_deg(deg / 2.0);
    let ratio = half(to_deg).sin() / half(from_deg).sin();
    format!(
        "Counts go as 1 / sin⁴ of half the angle. sin {} / sin {} = {}, and its fourth power is \
         {}.",
        bare_degrees(half(to_deg)),
        bare_degrees(half(from_deg)),
        significant(ratio),
        significant(ratio.powi(4))
    )
}

fn in_degrees(deg: f64) -> String {
    degrees(rad_from_deg(deg))
}

/// A whole ratio, to be chosen.
fn whole_ratio(beam: &Beam, dice: &mut Dice) -> Option<Question> {
    let (near, far, times) = *dice.pick(&WHOLE)?;
    let (near_deg, far_deg) = (f64::from(near), f64::from(far));
    // Asked from the small angle to the large one, or back.
    let more_here = dice.coin();
    let (here, there) = if more_here {
        (near_deg, far_deg)
    } else {
        (far_deg, near_deg)
    };
    let many = |n: u32| format!("{n} times as many");
    let few = |n: u32| format!("1/{n} as many");
    let root = f64::from(times).sqrt().round() as u32;
    let [right, gentle, upside_down] = if more_here {
        [many(times), many(root), few(times)]
    } else {
        [few(times), few(root), many(times)]
    };
    let choices = vec![
        Choice::right(right),
        Choice::of(
            &TOO_GENTLE,
            gentle,
            "You took the square of the sine. It is the fourth power that counts.",
        ),
        Choice::of(
            &UPSIDE_DOWN,
            upside_down,
            "You had it the other way round. Small angles are the common ones: most pass far \
             from a nucleus.",
        ),
        Choice::of(
            &EVERY_ANGLE_ALIKE,
            "Just as many",
            "You took all angles as alike. But to be turned far, one must pass close by, and few \
             do.",
        ),
    ];
    let choices = shuffled(choices, dice)?;
    Some(Question {
        family: Family::Rutherford,
        difficulty: Difficulty::Easy,
        topic: "counts-at-two-angles".into(),
        text: format!(
            "{} Compared with {}, how many does the same small screen count at {}?",
            beam.words(),
            in_degrees(there),
            in_degrees(here)
        ),
        picture: beam.tracks([near_deg, far_deg]),
        form: choices.form,
        beliefs: choices.beliefs,
        replies: choices.replies,
        why: why(near_deg, far_deg),
        figures: more([
            ("foil", json!(beam.foil)),
            ("energy_mev", json!(beam.energy_mev)),
            ("angle_deg", json!(here)),
            ("to_deg", json!(there)),
            ("asked", json!("choice")),
        ]),
    })
}

/// A ratio as a number.
fn ratio(beam: &Beam, dice: &mut Dice) -> Option<Question> {
    let (here_deg, there_deg) = two_angles(dice)?;
    let form = Form::Number {
        quantity: Measure::Times,
        truth: times_as_many(here_deg, there_deg),
    };
    let beliefs = wrong(
        &form,
        [
            half_forgotten(here_deg, there_deg, 1.0),
            too_gentle(here_deg, there_deg, 1.0),
            number(
                &UPSIDE_DOWN,
                times_as_many(there_deg, here_deg),
                "You had the ratio upside down. The smaller angle has the larger count.".into(),
            ),
        ],
    );
    Some(Question {
        family: Family::Rutherford,
        difficulty: Difficulty::Middle,
        topic: "counts-at-two-angles".into(),
        text: format!(
            "{} How many times as many does a small screen count at {} as at {}?",
            beam.words(),
            in_degrees(here_deg),
            in_degrees(there_deg)
        ),
        picture: beam.tracks([here_deg, there_deg]),
        beliefs,
        replies: BTreeMap::new(),
        form,
        why: why(here_deg, there_deg),
        figures: more([
            ("foil", json!(beam.foil)),
            ("energy_mev", json!(beam.energy_mev)),
            ("angle_deg", json!(here_deg)),
            ("to_deg", json!(there_deg)),
            ("asked", json!("ratio")),
        ]),
    })
}

/// The energy changes with the angle: d goes as 1 / E, and counts as d².
fn ratio_of_energies(beam: &Beam, dice: &mut Dice) -> Option<Question> {
    let (here_deg, there_deg) = two_angles(dice)?;
    let energy_mev = beam.energy_mev;
    let to_energy_mev = f64::from(3 + dice.below(6));
    let by_energy = (to_energy_mev / energy_mev).powi(2);
    let by_angle = times_as_many(here_deg, there_deg);
    let form = Form::Number {
        quantity: Measure::Times,
        truth: by_energy * by_angle,
    };
    if (to_energy_mev - energy_mev).abs() < 0.5 {
        return None;
    }
    let beliefs = wrong(
        &form,
        [
            half_forgotten(here_deg, there_deg, by_energy),
            too_gentle(here_deg, there_deg, by_energy),
            number(
                &UPSIDE_DOWN,
                (by_energy * by_angle).recip(),
                "You had the ratio upside down. Counts fall with the angle, and with the energy."
                    .into(),
            ),
            number(
                &EVERY_ANGLE_ALIKE,
                by_energy,
                "You counted the energy alone, as if all angles were alike. The larger angle is \
                 the rarer one."
                    .into(),
            ),
        ],
    );
    Some(Question {
        family: Family::Rutherford,
        difficulty: Difficulty::Hard,
        topic: "counts-angle-and-energy".into(),
        text: format!(
            "{} How many times as many does a screen count at {} with {} MeV as at {} with {} \
             MeV?",
            beam.words(),
            in_degrees(here_deg),
            significant(energy_mev),
            in_degrees(there_deg),
            significant(to_energy_mev)
        ),
        picture: beam.tracks([here_deg, there_deg]),
        beliefs,
        replies: BTreeMap::new(),
        form,
        why: format!(
            "{} Counts also go as 1 / E²: times {}, in all {}.",
            why(here_deg, there_deg),
            significant(by_energy),
            significant(by_energy * by_angle)
        ),
        figures: more([
            ("foil", json!(beam.foil)),
            ("energy_mev", json!(energy_mev)),
            ("angle_deg", json!(here_deg)),
            ("to_energy_mev", json!(to_energy_mev)),
            ("to_deg", json!(there_deg)),
            ("asked", json!("ratio")),
        ]),
    })
}

/// The ratio is given, the angle asked for.
fn angle(beam: &Beam, dice: &mut Dice) -> Option<Question> {
    let from_deg = f64::from(15 * (2 + dice.below(5)));
    let fewer = f64::from(*dice.pick(&[2_u32, 3, 4, 5, 8, 10, 16, 20, 50])?);
    // The angle at which sin⁴ of its half, or what is taken for it, is so many times as
    // large; NaN beyond 180°.
    let half_sine = rad_from_deg(from_deg / 2.0).sin();
    let at = |sine: f64| 2.0 * deg_from_rad(sine.asin());
    let root = fewer.sqrt().sqrt();
    let truth = at(half_sine * root);
    // Close to straight back the sine hardly grows any more.
    if truth.is_nan() || truth > 165.0 {
        return None;
    }
    let form = Form::Number {
        quantity: Measure::Angle,
        truth,
    };
    let beliefs = wrong(
        &form,
        [
            number(
                &HALF_ANGLE_FORGOTTEN,
                deg_from_rad((rad_from_deg(from_deg).sin() * root).asin()),
                "You took the sine of the whole angle. It is the half of it that counts.".into(),
            ),
            number(
                &TOO_GENTLE,
                at(half_sine * fewer.sqrt()),
                "You took the square of the sine. Counts fall with its fourth power.".into(),
            ),
            number(
                &UPSIDE_DOWN,
                at(half_sine / root),
                "You went to a smaller angle. There more are counted, not fewer.".into(),
            ),
        ],
    );
    Some(Question {
        family: Family::Rutherford,
        difficulty: Difficulty::Hard,
        topic: "angle-of-count".into(),
        text: format!(
            "{} At which angle does a small screen count 1/{fewer} of what it counts at {}?",
            beam.words(),
            in_degrees(from_deg)
        ),
        picture: Illustration::Nothing,
        beliefs,
        replies: BTreeMap::new(),
        form,
        why: format!(
            "Counts go as 1 / sin⁴ of half the angle. For 1/{fewer} of them the sine must be {} \
             times as large: {} × {} = {}, half of the angle is {}.",
            significant(root),
            significant(root),
            significant(half_sine),
            significant(half_sine * root),
            in_degrees(truth / 2.0)
        ),
        figures: more([
            ("foil", json!(beam.foil)),
            ("energy_mev", json!(beam.energy_mev)),
            ("angle_deg", json!(from_deg)),
            ("fewer_times", json!(fewer)),
            ("asked", json!("angle")),
        ]),
    })
}

/// Two different angles in degrees, the smaller one first.
fn two_angles(dice: &mut Dice) -> Option<(f64, f64)> {
    let mut angle = || f64::from(15 * (2 + dice.below(10)));
    let (a, b) = (angle(), angle());
    (a < b).then_some((a, b))
}

fn half_forgotten(from_deg: f64, to_deg: f64, by_energy: f64) -> Option<WrongAnswer> {
    // Straight back has a whole angle whose sine is 0 but for rounding.
    let whole = (to_deg < 175.0).then(|| times_as_many(2.0 * from_deg, 2.0 * to_deg))?;
    number(
        &HALF_ANGLE_FORGOTTEN,
        by_energy * whole,
        "You took the sine of the whole angles. It is the half of each that counts.".into(),
    )
}

fn too_gentle(from_deg: f64, to_deg: f64, by_energy: f64) -> Option<WrongAnswer> {
    number(
        &TOO_GENTLE,
        by_energy * times_as_many(from_deg, to_deg).sqrt(),
        "You took the square of the sines. Counts fall with the fourth power.".into(),
    )
}
