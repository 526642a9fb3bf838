//! How quantities are printed: decimals, significant figures, units and signs.
//!
//! Functions that print a quantity write a hyphen for a minus sign, as files and programs require.
//! Text in formulas passes through [`true_minus`], and elsewhere the Unicode screen replaces the
//! hyphens that mean minus; ranges, names and dates keep theirs.

use std::fmt;

/// `x` with `decimals` decimal places: "63.4". A value that rounds to zero has no sign: "0.0".
pub(crate) fn fixed(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    let is_nothing = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    match text.strip_prefix('-').filter(|_| is_nothing) {
        Some(size) => size.to_owned(),
        None => text,
    }
}

/// `x` with at most `decimals` decimal places: "3.46", "0.5", "60".
pub(crate) fn short(x: f64, decimals: usize) -> String {
    trimmed(&fixed(x, decimals)).to_owned()
}

/// `x` to three significant figures, with trailing zeros: "15.0", "5.50", "0.707"; from 1000 on, as
/// an integer: "1234".
pub(crate) fn significant(x: f64) -> String {
    fixed(x, decimals_for(x, 3))
}

/// `x` to four significant figures, without trailing zeros, and with a power of ten if it is
/// very large or small: "3.464", "10", "1.23e-5".
pub(crate) fn four_figures(x: f64) -> String {
    figures(x, 4)
}

/// Like [`four_figures`], but to `count` significant figures, at least 1.
pub(crate) fn figures(x: f64, count: u8) -> String {
    if x.abs() <= 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{x:.0$e}", usize::from(count) - 1);
    if (1e-4..1e6).contains(&x.abs()) {
        // Rounding comes first: otherwise 99996 would keep all its digits.
        let rounded = scientific.parse().unwrap_or(x);
        return short(rounded, decimals_for(x, count));
    }
    match scientific.split_once('e') {
        Some((mantissa, exponent)) => format!("{}e{exponent}", trimmed(mantissa)),
        None => scientific,
    }
}

/// `x` as a person would type it: "90", "0.5", "1e12".
pub(crate) fn typed(x: f64) -> String {
    if x.abs() <= 0.0 || (1e-4..1e6).contains(&x.abs()) {
        format!("{}", x + 0.0)
    } else {
        format!("{x:e}")
    }
}

/// `x` without the rounding error of a change of units: 30 for 29.999999999999996.
pub(crate) fn tidy(x: f64) -> f64 {
    (x * 1e9).round() / 1e9
}

/// An angle of `angle` radians in tenths of a degree, rounded.
pub(crate) fn tenths(angle: f64) -> i64 {
    (angle.to_degrees() * 10.0).round() as i64
}

/// An angle of `angle` radians to a tenth of a degree, with its unit: "63.4°".
pub(crate) fn degrees(angle: f64) -> String {
    format!("{}°", bare_degrees(angle))
}

/// An angle of `angle` radians to a tenth of a degree, without a unit: "63.4".
pub(crate) fn bare_degrees(angle: f64) -> String {
    format!("{:.1}", tenths(angle) as f64 / 10.0)
}

/// An intermediate value of a printed result. It is printed to three figures (an angle to a tenth
/// of a degree), or to more figures if the printed result cannot be reproduced from three.
#[derive(Debug, Clone)]
pub(crate) struct Intermediate {
    text: String,
    /// The value as printed; in radians if it is an angle.
    pub(crate) value: f64,
}

impl fmt::Display for Intermediate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Intermediate {
    /// The text without a sign.
    pub(crate) fn size(&self) -> &str {
        self.text.trim_start_matches('-')
    }

    /// The number of decimals printed.
    pub(crate) fn decimals(&self) -> usize {
        let decimals = self.text.split_once('.');
        decimals.map_or(0, |(_, decimals)| decimals.len())
    }

    /// The intermediate value `x`. `result` gives what is printed in the end, which is the same
    /// for the rounded [`value`](Self::value) as for `x`.
    pub(crate) fn new<T: PartialEq>(x: f64, result: impl Fn(f64) -> T) -> Self {
        let text = |more| fixed(x, decimals_for(x, 3) + more);
        Self::leading_to(x, text, |read| read, result)
    }

    /// Two intermediate values of one printed result.
    pub(crate) fn pair<T: PartialEq>(
        [a, b]: [f64; 2],
        result: impl Fn(f64, f64) -> T,
    ) -> [Self; 2] {
        let a = Self::new(a, |a| result(a, b));
        let b = Self::new(b, |b| result(a.value, b));
        [a, b]
    }

    /// Like [`Self::new`], but for an angle in radians that is printed in degrees without a unit.
    pub(crate) fn angle<T: PartialEq>(angle: f64, result: impl Fn(f64) -> T) -> Self {
        let text = |more| fixed(angle.to_degrees(), 1 + more);
        Self::leading_to(angle, text, f64::to_radians, result)
    }

    fn leading_to<T: PartialEq>(
        exact: f64,
        text: impl Fn(usize) -> String,
        value: impl Fn(f64) -> f64,
        result: impl Fn(f64) -> T,
    ) -> Self {
        /// The maximum number of additional figures: with more, the result depends on rounding
        /// noise.
        const MOST: usize = 6;
        const EDGE: f64 = 1e-9;
        let printed = |more| {
            let text = text(more);
            let value = value(text.parse().unwrap_or(f64::NAN));
            Self { text, value }
        };
        // A result midway between two printable numbers may be rounded either way.
        let wanted = [1.0, 1.0 - EDGE, 1.0 + EDGE].map(|near| result(near * exact));
        let enough = |it: &Self| wanted.contains(&result(it.value));
        (0..MOST)
            .map(&printed)
            .find(enough)
            .unwrap_or_else(|| printed(MOST))
    }
}

/// Points to a tenth: "8.0", "-2.0".
pub(crate) fn points(points: f64) -> String {
    fixed((10.0 * points).round() / 10.0, 1)
}

/// A length of `length_mm` millimetres to a hundredth, as discs are measured, or to three
/// significant figures if the second decimal is 0: "8.60", "30.0", "36.55".
pub(crate) fn bare_millimetres(length_mm: f64) -> String {
    let exact = format!("{length_mm:.2}");
    match exact.strip_suffix('0') {
        Some(_) => significant(length_mm),
        None => exact,
    }
}

/// Like [`bare_millimetres`], but with the unit: "36.55 mm".
pub(crate) fn millimetres(length_mm: f64) -> String {
    with_unit(&bare_millimetres(length_mm), "mm")
}

/// A number and its unit: "36.55 mm", "63.4°", "0.5".
pub(crate) fn with_unit(number: &str, unit: &str) -> String {
    let gap = if matches!(unit, "" | "°") { "" } else { " " };
    format!("{number}{gap}{unit}")
}

/// A count with its noun: "1 answer", "7 answers".
pub(crate) fn counted(count: usize, what: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {what}{plural}")
}

/// `text` with minus signs instead of hyphens.
pub(crate) fn true_minus(text: &str) -> String {
    text.replace('-', "−")
}

/// The digits as superscripts, for exponents.
pub(crate) const RAISED_DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// The name of a Greek letter, capitalized like the letter: "delta", "Delta".
pub(crate) const fn greek(letter: char) -> Option<&'static str> {
    Some(match letter {
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'δ' => "delta",
        'ε' | 'ϵ' => "epsilon",
        'η' => "eta",
        'θ' | 'ϑ' => "theta",
        'λ' => "lambda",
        'μ' => "mu",
        'ν' => "nu",
        'π' => "pi",
        'ρ' => "rho",
        'σ' => "sigma",
        'τ' => "tau",
        'φ' | 'ϕ' => "phi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'Γ' => "Gamma",
        'Δ' => "Delta ",
        'Θ' => "Theta",
        'Λ' => "Lambda",
        'Σ' => "Sigma",
        'Φ' => "Phi",
        'Ω' => "Omega",
        _ => return None,
    })
}

/// `text` with a capital first letter.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// The initial value: the FNV-1a hash of no bytes.
pub(crate) const FNV_START: u64 = 0xcbf2_9ce4_8422_2325;

/// The 64-bit FNV-1a hash `hash` of earlier bytes, continued with `bytes`.
pub(crate) fn fnv1a(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// The number of decimal places that give `x` the required number of significant figures. The
/// exponent is that of the rounded value: 9.999 is 10.0, not 10.00.
fn decimals_for(x: f64, figures: u8) -> usize {
    let digits = i32::from(figures) - 1;
    let scientific = format!("{x:.*e}", usize::from(figures) - 1);
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    usize::try_from(digits - exponent.unwrap_or(0)).unwrap_or(0)
}

fn trimmed(decimal: &str) -> &str {
    match decimal.contains('.') {
        true => decimal.trim_end_matches('0').trim_end_matches('.'),
        false => decimal,
    }
}

/// The mean; `None` if there are no values.
pub(crate) fn mean(x: &[f64]) -> Option<f64> {
    (!x.is_empty()).then(|| x.iter().sum::<f64>() / x.len() as f64)
}

/// Pearson's correlation coefficient; `None` for fewer than three pairs, or if the squared
/// deviations of either variable from its mean add up to no more than a millionth.
pub(crate) fn correlation(x: &[f64], y: &[f64]) -> Option<f64> {
    const VARIES: f64 = 1e-6;
    if x.len() < 3 {
        return None;
    }
    let (mx, my) = (mean(x)?, mean(y)?);
    let sum = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
        x.iter().zip(y).map(|(x, y)| f(x - mx, y - my)).sum()
    };
    let (xx, yy) = (sum(&|x, _| x * x), sum(&|_, y| y * y));
    let xy = sum(&|x, y| x * y);
    (xx > VARIES && yy > VARIES).then(|| (xy / (xx * yy).sqrt()).clamp(-1.0, 1.0))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn three_significant_figures_keep_trailing_zeros() {
        for (x, text) in [
            (15.0, "15.0"),
            (5.5, "5.50"),
            (0.5, "0.500"),
            (1.0, "1.00"),
            (9.999, "10.0"),
            (0.99999, "1.00"),
            (0.0707, "0.0707"),
            (108.43, "108"),
            (1234.0, "1234"),
            (-3.4641, "-3.46"),
        ] {
            assert_eq!(significant(x), text);
        }
    }

    #[test]
    fn four_significant_figures_drop_trailing_zeros() {
        for (x, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (15.0, "15"),
            (2.0 * 3.0_f64.sqrt(), "3.464"),
            (-0.5, "-0.5"),
            (9.999_96, "10"),
            (99_996.0, "100000"),
            (0.000_123_456, "0.0001235"),
            (0.000_012_3, "1.23e-5"),
            (1.5e9, "1.5e9"),
            (1234.5, "1234"),
            (90.0 - 1e-13, "90"),
        ] {
            assert_eq!(four_figures(x), text);
        }
    }

    #[test]
    fn points_are_printed_to_a_tenth() {
        for (x, text) in [(8.0, "8.0"), (-2.0, "-2.0"), (-0.04, "0.0"), (9.96, "10.0")] {
            assert_eq!(points(x), text);
        }
    }

    /// 1.14⁴ is 1.69, but (√1.31)⁴ is 1.72; (90° − 21.5°) / 2 is 34.25°.
    #[test]
    fn intermediate_values_lead_to_the_result() {
        let ratio = 1.31_f64.sqrt();
        let shown = Intermediate::new(ratio, |x| significant(x.powi(4)));
        assert_eq!((shown.to_string(), shown.value), ("1.145".into(), 1.145));
        let plain = Intermediate::new(0.5, |x| significant(x * x));
        assert_eq!(plain.to_string(), "0.500");
        let most = 21.48_f64.to_radians();
        let half = |angle: f64| degrees((90.0_f64.to_radians() - angle) / 2.0);
        assert_eq!(half(most), "34.3°");
        assert_eq!(Intermediate::angle(most, half).to_string(), "21.5");
        // 3 × 0.433² is 56.247 %, but the exact value is 56.25 %.
        let edge = Intermediate::new(0.75_f64.sqrt() / 2.0, |x| significant(300.0 * x * x));
        assert_eq!(edge.to_string(), "0.433");
        let sixty = Intermediate::angle(60.0_f64.to_radians(), degrees);
        assert_eq!(sixty.to_string(), "60.0");
    }

    #[test]
    fn lengths_are_printed_to_a_hundredth() {
        assert_eq!(millimetres(8.6), "8.60 mm");
        assert_eq!(millimetres(30.0), "30.0 mm");
        assert_eq!(millimetres(20.65 + 15.9), "36.55 mm");
    }

    #[test]
    fn angles_are_printed_to_a_tenth() {
        assert_eq!(degrees(2_f64.atan()), "63.4°");
        assert_eq!(degrees(-1e-9), "0.0°");
        assert_eq!(bare_degrees(-0.5), "-28.6");
    }

    #[test]
    fn a_space_precedes_every_unit_but_degrees() {
        assert_eq!(with_unit("4", "m/s"), "4 m/s");
        assert_eq!(with_unit("60", "°"), "60°");
        assert_eq!(with_unit("0.5", ""), "0.5");
        assert_eq!(true_minus("-1.5e-7"), "−1.5e−7");
    }

    #[test]
    fn capitals_and_hashes_are_correct() {
        assert_eq!(capital("élan vital"), "Élan vital");
        assert_eq!(capital(""), "");
        // Test vectors of the FNV reference.
        assert_eq!(fnv1a(FNV_START, b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(FNV_START, b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv1a(FNV_START, b"foobar"), 0x8594_4171_f739_67e8);
    }

    fn any_number() -> impl Strategy<Value = f64> {
        prop_oneof![
            -1e-3..1e-3_f64,
            -10.0..10.0_f64,
            -1e5..1e5_f64,
            -1e12..1e12_f64
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// The error is at most half a unit in the last place, plus the rounding error of parsing.
        #[test]
        fn printed_numbers_are_read_back_rounded(x in any_number(), decimals in 0_usize..5) {
            let half = |decimals: i32| 0.5 * 10.0_f64.powi(-decimals) + 4.0 * f64::EPSILON * x.abs();
            for text in [fixed(x, decimals), short(x, decimals)] {
                let read: f64 = text.parse().unwrap();
                prop_assert!((read - x).abs() <= half(decimals as i32), "{text}");
            }
            for (text, figures) in [(significant(x), 3), (four_figures(x), 4)] {
                let read: f64 = text.parse().unwrap();
                let last = x.abs().log10().floor() as i32 - (figures - 1);
                prop_assert!((read - x).abs() <= half(-last), "{text}");
            }
            prop_assert_eq!(typed(x).parse(), Ok(x));
        }

        #[test]
        fn zero_has_no_sign(x in -1e-2..1e-2_f64, decimals in 0_usize..3) {
            for x in [x, x * 1e-3, x * 1e-9, -0.0, 0.0] {
                let printed = [
                    fixed(x, decimals),
                    short(x, decimals),
                    significant(x),
                    four_figures(x),
                    typed(x),
                    typed(tidy(x)),
                    points(x),
                    bare_degrees(x),
                    bare_millimetres(x),
                ];
                for text in printed {
                    let read: f64 = text.parse().unwrap();
                    prop_assert!(read != 0.0 || !text.starts_with('-'), "{text}");
                }
            }
        }
    }

    #[test]
    fn correlation_agrees_with_a_calculation_by_hand() {
        // (1,2), (2,4), (3,6) lie on a line; (1,1), (2,3), (3,2): r = 1/2.
        assert_eq!(correlation(&[1.0, 2.0, 3.0], &[2.0, 4.0, 6.0]), Some(1.0));
        let r = correlation(&[1.0, 2.0, 3.0], &[1.0, 3.0, 2.0]).unwrap();
        assert!((r - 0.5).abs() < 1e-12);
        assert_eq!(correlation(&[1.0, 2.0], &[1.0, 2.0]), None);
        assert_eq!(correlation(&[1.0, 1.0, 1.0], &[1.0, 2.0, 3.0]), None);
    }
}
