//! A measurement in words: rows of numbers with their uncertainties, sentences to quote, warnings.

use glam::DVec2;

use super::fit::{Estimate, LEVEL};
use super::model::State;
use super::quantities::{ANGLE, LENGTH, NUMBER, PERCENT, SPEED, changed, predicted, relative};
use super::student::t_beyond;
use super::{LineFrom, Measurement, QUANTITIES, SlowingDown, Unit};
use crate::numbers::{capital, fixed, four_figures, with_unit};

/// A difference counts as agreement up to the first of these numbers of standard deviations, and as
/// disagreement beyond the second. The number is rounded to a tenth, as printed, before it is
/// compared.
const LIMITS: [f64; 2] = [2.0, 3.0];
/// Beyond this number of standard deviations, the correlation of neighbouring residuals counts as
/// more than chance.
const ALIKE: f64 = 4.0;

/// The name of a quantity, and its result as text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReportRow {
    /// What was measured.
    pub name: String,
    /// The numbers with their units, or why there are none.
    pub text: String,
}

/// Rows under a title.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReportSection {
    /// The heading above the rows.
    pub title: &'static str,
    /// The rows, in the order of a lab report.
    pub rows: Vec<ReportRow>,
}

fn row(name: impl Into<String>, text: impl Into<String>) -> ReportRow {
    ReportRow {
        name: name.into(),
        text: text.into(),
    }
}

/// The number of decimal places to which an uncertainty has one significant figure, or two if the
/// first is a 1.
fn decimals(uncertainty: f64) -> usize {
    if !(uncertainty > 0.0 && uncertainty.is_finite()) {
        return 4;
    }
    let exponent = uncertainty.log10().floor();
    let first = (uncertainty / 10_f64.powf(exponent)).round();
    let digits = if first < 2.0 {
        1.0 - exponent
    } else {
        -exponent
    };
    digits.clamp(0.0, 9.0) as usize
}

/// A value with its uncertainty, without a unit.
fn bare(estimate: &Estimate, unit: Unit) -> [String; 2] {
    let uncertainty = unit.in_unit(estimate.uncertainty());
    let decimals = decimals(uncertainty);
    [unit.in_unit(estimate.value), uncertainty].map(|x| fixed(x, decimals))
}

/// A value with its uncertainty: "87° ± 3°", "1.02 ± 0.03 m/s".
fn printed(estimate: &Estimate, unit: Unit) -> String {
    let (both, sign) = (bare(estimate, unit), unit.sign());
    match [ANGLE, PERCENT].contains(&unit) {
        true => both.map(|it| with_unit(&it, sign)).join(" ± "),
        false => with_unit(&both.join(" ± "), sign),
    }
}

/// A number of standard uncertainties: "1.3 σ".
pub(crate) fn sigmas(number: f64) -> String {
    match number < 100.0 {
        true => format!("{number:.1} σ"),
        false => "more than 100 σ".into(),
    }
}

/// Whether a measured value agrees with what is expected.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Agreement {
    Agrees,
    Undecided,
    Disagrees,
}

impl Agreement {
    /// The verdict on a difference of `number` standard deviations.
    fn of_sigmas(number: f64) -> Self {
        let printed = (10.0 * number).round() / 10.0;
        match LIMITS.map(|limit| printed > limit) {
            [_, true] => Self::Disagrees,
            [true, _] => Self::Undecided,
            _ => Self::Agrees,
        }
    }

    /// The verdict on a difference that would be exceeded by chance alone with this probability.
    fn of_chance(chance: f64) -> Self {
        Self::of_sigmas(t_beyond(chance, 1e9))
    }
}

/// Compares a measured value with an exact one. Agreement is weak evidence if half the width of the
/// 95 % interval is more than `wide`.
fn compared(what: &str, estimate: &Estimate, exact: f64, unit: Unit, wide: f64) -> String {
    let both = [printed(estimate, unit), rounded(exact, unit)];
    judged(what, both, estimate, exact, unit, wide)
}

/// A number without an uncertainty.
fn rounded(x: f64, unit: Unit) -> String {
    match [ANGLE, PERCENT].contains(&unit) {
        true => with_unit(&fixed(unit.in_unit(x), 0), unit.sign()),
        false => four_figures(unit.in_unit(x)),
    }
}

/// Compares a result with the expected value; both are text. The uncertainty of `estimate` is that
/// of their difference.
fn judged(
    what: &str,
    [found, expected]: [String; 2],
    estimate: &Estimate,
    exact: f64,
    unit: Unit,
    wide: f64,
) -> String {
    let ratio = estimate.sigmas(exact);
    let far = sigmas(ratio);
    let verdict = Agreement::of_chance(estimate.chance(exact));
    // With few points, chance causes larger differences.
    let few = match verdict < Agreement::of_sigmas(ratio) {
        true => " with so few points",
        false => "",
    };
    if verdict == Agreement::Disagrees {
        return format!("{what}: {found} disagrees with {expected} ({far}).");
    }
    if verdict == Agreement::Undecided {
        return format!(
            "{what}: {found} is {far} from {expected}, too far to agree and too near to \
             disagree{few}."
        );
    }
    let reach = estimate.uncertainty95();
    let doubt = match reach > wide {
        true => {
            let ends = [estimate.value - reach, estimate.value + reach];
            let [low, high] = ends.map(|end| match unit == NUMBER {
                true => fixed(end, 1),
                false => rounded(end, unit),
            });
            format!(" This test is weak: anything from {low} to {high} would agree too.")
        }
        false => String::new(),
    };
    format!("{what}: {found} agrees with {expected}{few} ({far}).{doubt}")
}

impl Measurement {
    /// The quantity with this id and its uncertainty, as text.
    pub(crate) fn printed(&self, id: &str) -> String {
        self.found(id).unwrap_or_else(|_| "not defined".into())
    }

    /// Like [`Self::printed`], but with the reason if there is no result.
    fn found(&self, id: &str) -> Result<String, String> {
        let (quantity, estimate) = self.quantity(id)?;
        Ok(printed(&estimate, quantity.unit))
    }

    fn text_of(&self, id: &str) -> String {
        self.found(id).unwrap_or_else(|reason| reason)
    }

    fn estimate_of(&self, id: &str) -> Result<Estimate, String> {
        self.quantity(id).map(|(_, estimate)| estimate)
    }

    /// A vector: "(1.02 ± 0.01, 0.30 ± 0.01) m/s".
    fn vector(&self, id: &str) -> String {
        let [x, y] = ["x", "y"].map(|axis| self.quantity(&format!("{id}_{axis}")));
        match (x, y) {
            (Ok((quantity, x)), Ok((_, y))) => {
                let [x, y] = [x, y].map(|it| bare(&it, quantity.unit).join(" ± "));
                format!("({x}, {y}) {}", quantity.unit.sign())
            }
            (Err(reason), _) | (_, Err(reason)) => reason,
        }
    }

    /// All results, in the order of a lab report.
    pub fn sections(&self) -> Vec<ReportSection> {
        let names = self.names();
        let fit = &self.fit;
        let counts = |body: usize| {
            let [before, after] = fit.counts[body];
            let noise = |axis: usize| LENGTH.in_unit(fit.noise[2 * body + axis]);
            let [x, y] = [0, 1].map(|axis| four_figures(round2(noise(axis))));
            format!(
                "{before} points before the contact, {after} after it; noise {x} mm in x, {y} mm \
                 in y"
            )
        };
        let mut data: Vec<_> = (0..2).map(|body| row(names[body], counts(body))).collect();
        data.push(row("given", self.what_is_given()));
        let contact = format!("at {}", self.text_of("contact_time"));
        data.push(row("contact", contact));
        data.push(row("legs", self.legs()));
        let distance = self.distance();
        data.extend(distance.map(|text| row("distance between the centres", text)));
        let velocity = |name: &str, body: usize, id: &str| {
            let name = format!("{name} {}", names[body]);
            let size = match self.found(id) {
                Ok(size) => format!(", {size} at {}", self.text_of(&format!("{id}_direction"))),
                Err(reason) => format!("; {}", reason.replace("not defined: ", "")),
            };
            row(name, self.vector(id) + &size)
        };
        let mut velocities = vec![
            velocity("u₁", 0, "u1"),
            velocity("u₂", 1, "u2"),
            velocity("v₁", 0, "v1"),
            velocity("v₂", 1, "v2"),
        ];
        for (body, name) in names.iter().enumerate() {
            if fit.model.slows(body) {
                let found = self.text_of(&format!("deceleration{}", body + 1));
                velocities.push(row(format!("deceleration {name}"), found));
            }
        }
        let mut geometry = self.rows(&["line_of_impact"], Self::found);
        for row in &mut geometry {
            row.text += match self.known.line {
                LineFrom::Centres => ", from the centres at contact",
                LineFrom::Impulse => ", from the change of the relative velocity",
            };
        }
        let impact = ["offset", "alpha", "restitution", "impulse_ratio"];
        geometry.extend(self.rows(&impact, Self::found));
        let outcome = ["theta1", "theta2", "between", "mass_ratio"];
        geometry.extend(self.rows(&outcome, Self::found));
        let mut kept = vec![
            row("momentum before", self.vector("p_before")),
            row("momentum after", self.vector("p_after")),
        ];
        kept.extend(self.rows(&["p_change_along", "p_change_across"], Self::found));
        let energies = ["energy_before", "energy_after", "energy_kept"];
        kept.extend(self.rows(&energies, Self::found));
        let predicted = self.rows(&["v1_x", "v1_y", "v2_x", "v2_y"], Self::beside_prediction);
        let section = |title, rows| ReportSection { title, rows };
        vec![
            section("Tracks", data),
            section("Velocities at contact", velocities),
            section("Collision", geometry),
            section("Momentum and energy", kept),
            section("Prediction from the state before the contact", predicted),
        ]
    }

    /// A row for each of these quantities, with its result as `text` gives it, or why there is
    /// none.
    fn rows(
        &self,
        ids: &[&str],
        text: fn(&Self, &str) -> Result<String, String>,
    ) -> Vec<ReportRow> {
        let rows = ids.iter().filter_map(|id| {
            let quantity = QUANTITIES.iter().find(|quantity| quantity.id == *id)?;
            let text = text(self, id).unwrap_or_else(|reason| reason);
            Some(row(&quantity.name, text))
        });
        rows.collect()
    }

    /// A velocity component with its prediction and the difference.
    fn beside_prediction(&self, id: &str) -> Result<String, String> {
        let expected = self.estimate_of(&format!("predicted_{id}"))?;
        let missed = self.estimate_of(&format!("residual_{id}"))?;
        Ok(format!(
            "{}, predicted {}, difference {} ({})",
            self.found(id)?,
            bare(&expected, SPEED).join(" ± "),
            bare(&missed, SPEED).join(" ± "),
            sigmas(missed.sigmas(0.0)),
        ))
    }

    /// The masses, the radii, the scale and e, as they were given.
    fn what_is_given(&self) -> String {
        let pair = |name: &str, values: Option<[f64; 2]>, unit: &str| match values {
            Some(values) => {
                let [one, other] = values.map(|it| four_figures(1000.0 * it));
                format!("{name}₁ = {one} {unit}, {name}₂ = {other} {unit}")
            }
            None => format!("no {name}₁ and {name}₂"),
        };
        let scale = match self.given.scale {
            1.0 => String::new(),
            scale => format!("; scale × {}", four_figures(scale)),
        };
        format!(
            "{}; {}{scale}; e = {} for the prediction",
            pair("m", self.given.masses, "g"),
            pair("r", self.given.radii, "mm"),
            four_figures(self.given.restitution)
        )
    }

    /// Which motion was fitted, and why.
    fn legs(&self) -> String {
        let slows = self.fit.model.rates() > 0;
        let kind = if slows {
            "constant deceleration"
        } else {
            "straight lines"
        };
        let Some(test) = &self.fit.test else {
            return match self.given.slowing {
                SlowingDown::Never => format!("{kind}, as chosen"),
                _ => format!("{kind}: too few points to find a deceleration"),
            };
        };
        let p = match test.p < 1e-4 {
            true => "p < 0.0001".into(),
            false => format!("p = {}", fixed(test.p, if test.p < 0.01 { 4 } else { 2 })),
        };
        let found = format!("F = {}, {p}", four_figures(round2(test.f)));
        match (self.given.slowing, slows) {
            (SlowingDown::Always, _) => format!("{kind}, as chosen ({found})"),
            (_, true) => format!(
                "{kind}: straight lines fit worse than chance allows ({found}; the limit is \
                 {LEVEL})"
            ),
            (_, false) => format!(
                "{kind}: a deceleration does not improve the fit clearly ({found}; the limit is \
                 {LEVEL})"
            ),
        }
    }

    /// The distance between the centres at contact, and the radii.
    fn distance(&self) -> Option<String> {
        let apart = self.fit.apart?;
        let found = printed(&apart.found, LENGTH);
        let radii = four_figures(LENGTH.in_unit(apart.radii));
        let far = sigmas(apart.found.sigmas(apart.radii));
        Some(match apart.agrees {
            true => format!("{found} from the tracks, {radii} mm from the radii ({far})"),
            false => format!("{found} from the tracks, but {radii} mm from the radii ({far})"),
        })
    }

    /// The results of the measurement, in sentences to quote.
    pub fn sentences(&self) -> Vec<String> {
        let mut sentences = Vec::new();
        let (what, wide) = ("Angle between the paths", 20_f64.to_radians());
        let is_square =
            self.known.masses[0] == self.known.masses[1] && self.quantity("u2").is_err();
        match self.estimate_of("between") {
            Ok(between) if is_square && self.given.restitution >= 1.0 => {
                let exact = 90_f64.to_radians();
                sentences.push(compared(what, &between, exact, ANGLE, wide));
            }
            Ok(between) => {
                let angle = |[v1, v2]: [DVec2; 2]| v1.angle_to(v2).abs();
                let expected = |state: &State| Some(angle(predicted(state, &self.known)?));
                let missed = self.fit.estimate_angle(|state| {
                    let found = [0, 1].map(|body| state.velocity(body, super::Leg::After));
                    Some(angle(found) - expected(state)?)
                });
                if let (Some(missed), Some(expected)) = (missed, self.fit.estimate_angle(expected))
                {
                    let both = [
                        printed(&between, ANGLE),
                        format!("the predicted {}", printed(&expected, ANGLE)),
                    ];
                    let difference = Estimate {
                        value: between.value,
                        ..missed
                    };
                    let exact = between.value - missed.value;
                    sentences.push(judged(what, both, &difference, exact, ANGLE, wide));
                }
            }
            Err(reason) => sentences.push(format!("{what}: {reason}.")),
        }
        sentences.extend(self.momentum_sentence());
        let what = "Coefficient of restitution";
        sentences.push(match self.estimate_of("restitution") {
            Ok(e) => compared(what, &e, self.given.restitution, NUMBER, 0.3),
            Err(reason) => format!("{what}: {reason}."),
        });
        if let Ok(kept) = self.estimate_of("energy_kept") {
            let what = "Kinetic energy kept";
            sentences.push(compared(what, &kept, 1.0, PERCENT, 0.3));
        }
        sentences.push(self.friction_sentence());
        sentences.extend(self.largest_residual());
        sentences
    }

    /// "Momentum agrees within 4 %: 1.3 σ."
    fn momentum_sentence(&self) -> Option<String> {
        let along = match self.estimate_of("p_change_along") {
            Ok(along) => along,
            Err(reason) => return Some(format!("Momentum: {reason}.")),
        };
        let part = |state: &State, axis: usize| Some(changed(state, &self.known)?[axis]);
        let change = changed(&self.fit.state, &self.known)?.length();
        let p = self
            .fit
            .chance_of_zero([&|state| part(state, 0), &|state| part(state, 1)])?;
        let far = sigmas(t_beyond(p, 1e9));
        let share = PERCENT.in_unit(change);
        let share = fixed(share, if share < 1.0 { 1 } else { 0 });
        let verdict = Agreement::of_chance(p);
        Some(if verdict == Agreement::Disagrees {
            format!("Momentum disagrees: it changed by {share} % ({far}).")
        } else if verdict == Agreement::Undecided {
            format!(
                "Momentum changed by {share} %: {far}, too much to agree and too little to disagree."
            )
        } else if along.uncertainty95() > 0.25 {
            let reach = fixed(PERCENT.in_unit(along.uncertainty95()), 0);
            format!(
                "Momentum agrees within {share} %: {far}. This test is weak: a change of {reach} % \
                 would hardly be noticed."
            )
        } else {
            format!("Momentum agrees within {share} %: {far}.")
        })
    }

    /// The friction of the rims: a bound on its coefficient, or why there is none.
    fn friction_sentence(&self) -> String {
        let ratio = match self.estimate_of("impulse_ratio") {
            Ok(ratio) => ratio,
            Err(reason) => return format!("Friction of the rims: {reason}."),
        };
        // The bound is one-sided, at the 95 % level.
        let reach = ratio.deviation * t_beyond(0.1, ratio.freedom);
        let size = ratio.value.abs();
        let found = printed(&ratio, NUMBER);
        if Agreement::of_chance(ratio.chance(0.0)) > Agreement::Agrees {
            let least = fixed((size - reach).max(0.0), 2);
            format!(
                "Friction of the rims: the tangential impulse is {found} of the normal one, so the \
                 coefficient of friction is at least {least} (95 %)."
            )
        } else {
            let most = fixed(size + reach, 2);
            format!(
                "Friction of the rims: none found ({found}); if the rims slipped, the coefficient \
                 of friction is below {most} (95 %)."
            )
        }
    }

    /// A verdict on the prediction, from the largest of the four differences relative to their
    /// uncertainties.
    fn largest_residual(&self) -> Option<String> {
        let ids = ["v1_x", "v1_y", "v2_x", "v2_y"].into_iter();
        let all = ids.filter_map(|id| self.estimate_of(&format!("residual_{id}")).ok());
        let largest = all.max_by(|a, b| a.sigmas(0.0).total_cmp(&b.sigmas(0.0)))?;
        let e = four_figures(self.given.restitution);
        let approach = relative(&self.fit.state, super::Leg::Before).length();
        let doubt = match largest.uncertainty95() > 0.25 * approach {
            true => " This test is weak: the uncertainty is too large.",
            false => "",
        };
        // With four differences, one of 2.5 σ is no surprise.
        let chance = (4.0 * largest.chance(0.0)).min(1.0);
        let verdict = match Agreement::of_chance(chance) {
            Agreement::Disagrees => "disagrees with",
            Agreement::Undecided => "is near the limit of agreement with",
            Agreement::Agrees => "agrees with",
        };
        let is_other = |it: &Estimate| {
            (0.0..=1.0).contains(&it.value)
                && Agreement::of_chance(it.chance(self.given.restitution)) == Agreement::Disagrees
        };
        let other_e = match self.estimate_of("restitution") {
            Ok(found) if is_other(&found) => {
                let [value, _] = bare(&found, NUMBER);
                format!(
                    " Set e = {value} (--restitution {value}) to predict with the e found here."
                )
            }
            _ => String::new(),
        };
        let how = match self.known.line {
            LineFrom::Centres => "",
            LineFrom::Impulse => {
                " Without the radii, the line of impact comes from the outcome, so only a part of \
                 the prediction is tested."
            }
        };
        Some(format!(
            "The outcome {verdict} the prediction for smooth rims and e = {e}: the largest of four \
             differences is {} ({}).{doubt}{other_e}{how}",
            printed(&largest, SPEED),
            sigmas(largest.sigmas(0.0)),
        ))
    }

    /// What the reader should know before trusting the numbers.
    pub fn warnings(&self) -> Vec<String> {
        let fit = &self.fit;
        let (gap, step) = fit.gap;
        let slows = fit.model.rates() > 0;
        let contradicted = fit.apart.filter(|apart| !apart.agrees).map(|apart| {
            format!(
                "The tracks contradict the radii: at contact the centres are {} apart, but the radii \
                 add up to {} mm. Check the scale, whether x and y have the same scale, whether the \
                 marks are at the centres, and parallax. The radii are not used.",
                printed(&apart.found, LENGTH),
                four_figures(LENGTH.in_unit(apart.radii)),
            )
        });
        let missing = (gap > 3.5 * step).then(|| {
            format!(
                "Frames are missing around the contact: there is no point for {} s, {} times the \
                 usual step.",
                four_figures(round2(gap)),
                fixed(gap / step, 0),
            )
        });
        let is_too_great = |e: Estimate| {
            e.value > 1.0 && Agreement::of_chance(e.chance(1.0)) == Agreement::Disagrees
        };
        let when = |holds: bool, text: &str| holds.then(|| text.to_owned());
        let warnings = [
            when(
                self.given.masses.is_none(),
                "The masses are assumed to be equal: set them (--m1-g and --m2-g).",
            ),
            when(
                fit.alike > ALIKE,
                "Neighbouring points miss the fitted paths in the same direction: the paths bend, a \
                 third body or a cushion interferes, or the tracking was smoothed. The true \
                 uncertainties are larger than stated.",
            ),
            contradicted,
            missing,
            when(
                self.estimate_of("restitution").is_ok_and(is_too_great),
                "e is greater than 1, which no collision of two passive bodies can give: check the \
                 scale, the frame rate and the tracks around the contact.",
            ),
            when(
                slows && fit.test.is_some_and(|test| !test.is_slowing),
                "A body speeds up: the surface is not level, the camera moves, or the paths are seen \
                 at an angle.",
            ),
            when(
                !slows
                    && self.given.slowing == SlowingDown::Auto
                    && fit.test.is_some_and(|test| test.p < 0.2),
                "A small deceleration is possible and would distort the velocities. If you allow \
                 for it (--slowing always), the uncertainties are larger.",
            ),
        ];
        warnings.into_iter().flatten().collect()
    }

    /// The whole measurement as text.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for section in self.sections() {
            text += &format!("{}\n", section.title);
            for ReportRow { name, text: found } in section.rows {
                text += &format!("  {name:30}{found}\n");
            }
            text.push('\n');
        }
        text += "In words\n";
        for sentence in self.sentences() {
            text += &format!("  {}\n", capital(&sentence));
        }
        let warnings = self.warnings();
        if !warnings.is_empty() {
            text += "\nBefore you trust it\n";
            for warning in warnings {
                text += &format!("  {warning}\n");
            }
        }
        text
    }
}

/// Rounds to two significant figures.
fn round2(x: f64) -> f64 {
    format!("{x:.1e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn estimate(value: f64, uncertainty: f64) -> Estimate {
        Estimate {
            value,
            deviation: uncertainty,
            freedom: 1e9,
        }
    }

    #[test]
    fn the_uncertainty_decides_the_figures() {
        for (value, uncertainty, text) in [
            (0.9234, 0.0312, "0.92 ± 0.03"),
            (0.9234, 0.0142, "0.923 ± 0.014"),
            (1.0, 0.0960, "1.00 ± 0.10"),
            (123.4, 21.0, "123 ± 21"),
            (123.4, 34.0, "123 ± 34"),
            (-0.001, 0.2, "0.0 ± 0.2"),
        ] {
            assert_eq!(printed(&estimate(value, uncertainty), NUMBER), text);
        }
        let angle = estimate(87_f64.to_radians(), 3_f64.to_radians());
        assert_eq!(printed(&angle, ANGLE), "87° ± 3°");
    }

    #[test]
    fn agreement_is_right_in_words() {
        let words = |by: f64| {
            let sigma = 3_f64.to_radians();
            let angle = estimate(90_f64.to_radians() - by * sigma, sigma);
            compared("Angle", &angle, 90_f64.to_radians(), ANGLE, 0.5)
        };
        assert_eq!(words(0.3), "Angle: 89° ± 3° agrees with 90° (0.3 σ).");
        assert_eq!(words(1.0), "Angle: 87° ± 3° agrees with 90° (1.0 σ).");
        // The rule of chapter 17: up to 2 σ, as printed.
        assert_eq!(words(2.0), "Angle: 84° ± 3° agrees with 90° (2.0 σ).");
        assert_eq!(words(2.04), "Angle: 84° ± 3° agrees with 90° (2.0 σ).");
        assert_eq!(
            words(2.1),
            "Angle: 84° ± 3° is 2.1 σ from 90°, too far to agree and too near to disagree."
        );
        assert_eq!(
            words(3.0),
            "Angle: 81° ± 3° is 3.0 σ from 90°, too far to agree and too near to disagree."
        );
        assert_eq!(words(3.1), "Angle: 81° ± 3° disagrees with 90° (3.1 σ).");
        assert_eq!(words(6.0), "Angle: 72° ± 3° disagrees with 90° (6.0 σ).");
        let few = |value: f64| Estimate {
            value: value.to_radians(),
            deviation: 1_f64.to_radians(),
            freedom: 3.0,
        };
        let right = 90_f64.to_radians();
        assert_eq!(
            compared("Angle", &few(87.2), right, ANGLE, 0.5),
            "Angle: 87.2° ± 1.2° agrees with 90° with so few points (2.3 σ)."
        );
        assert_eq!(
            compared("Angle", &few(86.0), right, ANGLE, 0.5),
            "Angle: 86.0° ± 1.2° is 3.3 σ from 90°, too far to agree and too near to disagree with \
             so few points."
        );
        let wide = estimate(1.6, 0.7);
        assert_eq!(
            compared("e", &wide, 1.0, NUMBER, 0.3),
            "e: 1.6 ± 0.7 agrees with 1 (0.9 σ). This test is weak: anything from 0.2 to 3.0 would \
             agree too."
        );
    }
}
