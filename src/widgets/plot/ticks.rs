//! The positions and labels of the ticks of an axis.

use crate::lessons::formula::superscript;
use crate::numbers::{fixed, true_minus};
use crate::widgets::picture::positive;

/// The position of a tick, in units in which the axis is linear, and the text beside it.
pub(crate) type Tick = (f64, String);

/// The maximum number of intervals between ticks, which is more than fit on any screen.
const MOST: usize = 100;

/// The smallest step for which numbers are written with a power of ten.
const LARGE: f64 = 1e5;

/// Ticks at the multiples of `step`, or of the smallest multiple of `step` that divides the range
/// into at most `most` parts; without a step, at the multiples of 1, 2 or 5 times a power of ten.
pub(super) fn even((from, to): (f64, f64), step: Option<f64>, most: usize) -> Vec<Tick> {
    let most = most.clamp(1, MOST) as f64;
    let wanted = (to - from) / most;
    let step = match step {
        Some(step) if step > 0.0 && step.is_finite() => step * (wanted / step).ceil().max(1.0),
        _ => round_up(wanted),
    };
    let decimals = decimals(step);
    let written = |value: f64| {
        if step < LARGE || value == 0.0 {
            return fixed(value, decimals);
        }
        let exponent = (step.log10() + 1e-9).floor() as i32;
        let digits = fixed(value / 10_f64.powi(exponent), 0);
        format!("{digits}×{}", power_of_ten(exponent))
    };
    // Rounding errors must not remove the ticks at the ends.
    let (first, last) = ((from / step - 1e-9).ceil(), (to / step + 1e-9).floor());
    let count = (last - first).clamp(-1.0, MOST as f64);
    (0..=count as i64)
        .filter(|_| count >= 0.0)
        .map(|i| {
            // Adding 0 turns -0 into 0.
            let value = (first + i as f64) * step + 0.0;
            (value, true_minus(&written(value)))
        })
        .collect()
}

/// Ticks between two exponents: at most `most` ticks at powers of ten or, if fewer than two powers
/// are in the range, ticks at 1, 2 and 5 times each power.
pub(super) fn decades((from, to): (f64, f64), most: usize) -> Vec<Tick> {
    let most = most.clamp(1, MOST) as f64;
    let (first, last) = ((from - 1e-9).ceil(), (to + 1e-9).floor());
    if last - first < 1.0 {
        return fine_decades(from, to);
    }
    let step = ((last - first + 1.0) / most).ceil().max(1.0);
    // Exponents are multiples of the step, so that 1 has a tick if possible.
    let first = (first / step).ceil() * step;
    (0..MOST)
        .map(|i| first + i as f64 * step)
        .take_while(|exponent| *exponent <= last)
        .map(|exponent| (exponent, power_of_ten(exponent as i32)))
        .collect()
}

fn fine_decades(from: f64, to: f64) -> Vec<Tick> {
    let decade = from.floor() as i32;
    (decade..=decade.saturating_add(2))
        .flat_map(|decade| [1.0, 2.0, 5.0].map(|digit| (digit, decade)))
        .map(|(digit, decade)| {
            let value = digit * 10_f64.powi(decade);
            let text = match decade {
                0..=3 => value.to_string(),
                -3..0 => fixed(value, decade.unsigned_abs() as usize),
                _ => format!("{digit}×{}", power_of_ten(decade)),
            };
            (f64::from(decade) + f64::log10(digit), text)
        })
        .filter(|(place, _)| (from - 1e-9..=to + 1e-9).contains(place))
        .collect()
}

/// The text for a power of ten: 1, 10, 100, 1000, then 10⁴ and so on; below 1, always an exponent,
/// as in 10⁻¹.
fn power_of_ten(exponent: i32) -> String {
    if (0..=3).contains(&exponent) {
        return format!("{}", 10_i32.pow(exponent.unsigned_abs()));
    }
    let exponent = superscript(&exponent.to_string());
    format!("10{}", exponent.unwrap_or_default())
}

/// The smallest number of the form 1, 2 or 5 times a power of ten that is not below `least`.
fn round_up(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    let mut digits = [1.0, 2.0, 5.0].into_iter();
    let digit = digits.find(|digit| digit * power >= least * (1.0 - 1e-9));
    positive(digit.unwrap_or(10.0) * power)
}

/// The number of decimal places, at most nine, needed to write the multiples of a step exactly.
fn decimals(step: f64) -> usize {
    (0..9)
        .find(|decimals| {
            let scaled = step * 10_f64.powi(*decimals);
            (scaled - scaled.round()).abs() < 1e-6 * scaled
        })
        .map_or(9, |decimals| decimals as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(ticks: &[Tick]) -> Vec<&str> {
        ticks.iter().map(|(_, text)| text.as_str()).collect()
    }

    #[test]
    fn even_ticks_are_round_numbers() {
        assert_eq!(
            texts(&even((0.0, 1.0), None, 6)),
            ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]
        );
        assert_eq!(
            texts(&even((0.0, 180.0), None, 4)),
            ["0", "50", "100", "150"]
        );
        assert_eq!(texts(&even((-1.0, 1.0), None, 2)), ["−1", "0", "1"]);
        assert_eq!(texts(&even((0.0, 4.2e7), None, 3)), ["0", "2×10⁷", "4×10⁷"]);
    }

    #[test]
    fn a_given_step_is_kept_or_multiplied() {
        let angles = |most| even((0.0, 90.0), Some(15.0), most);
        assert_eq!(texts(&angles(7)).len(), 7);
        assert_eq!(texts(&angles(3)), ["0", "30", "60", "90"]);
        assert_eq!(
            texts(&even((0.0, 1.0), Some(0.25), 9)).last(),
            Some(&"1.00")
        );
    }

    #[test]
    fn ticks_of_a_logarithmic_axis_are_powers_of_ten_or_round_numbers() {
        assert_eq!(
            texts(&decades((-1.0, 5.0), 9)),
            ["10⁻¹", "1", "10", "100", "1000", "10⁴", "10⁵"]
        );
        assert_eq!(
            texts(&decades((0.0, 8.0), 5)),
            ["1", "100", "10⁴", "10⁶", "10⁸"]
        );
        assert_eq!(texts(&decades((0.0, 0.5), 5)), ["1", "2"]);
        assert_eq!(texts(&decades((-1.1, -0.2), 5)), ["0.1", "0.2", "0.5"]);
    }

    #[test]
    fn ticks_are_on_the_axis_and_not_too_many() {
        for (from, to) in [(0.0, 1e-9), (-3.0, 7e12), (0.1, 0.2), (5.0, 6.0)] {
            for most in [0, 1, 2, 5, 50] {
                let length = to - from;
                for ticks in [
                    even((from, to), None, most),
                    even((from, to), Some(0.1), most),
                ] {
                    assert!(ticks.len() <= most + 2, "{ticks:?}");
                    for (place, _) in ticks {
                        let share = (place - from) / length;
                        assert!((-1e-6..=1.0 + 1e-6).contains(&share));
                    }
                }
                assert!(decades((from, to.min(300.0)), most).len() <= MOST);
            }
        }
    }
}
