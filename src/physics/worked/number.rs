//! Numbers as a worked solution prints them: four digits, no noise.

use glam::DVec2;

use crate::numbers::{figures, four_figures, true_minus};

/// A number below this fraction of its scale is shown as 0.
pub(super) const NOISE: f64 = 1e-9;

/// A number to four significant digits with a proper minus sign.
pub(crate) fn number(x: f64) -> String {
    true_minus(&four_figures(x))
}

/// A number, or 0 if it is rounding noise relative to `scale`.
pub(crate) fn beside(x: f64, scale: f64) -> String {
    number(if x.abs() <= NOISE * scale { 0.0 } else { x })
}

/// A number after an operator: in brackets if it is negative.
pub(super) fn factor(x: f64, scale: f64) -> String {
    let text = beside(x, scale);
    if text.starts_with('−') {
        format!("({text})")
    } else {
        text
    }
}

/// The factors of a result as they are printed: with four figures, or with more if the printed
/// result cannot be reproduced from four. A result that is rounding noise relative to `scale` is 0.
pub(super) fn factors<const N: usize>(
    values: [f64; N],
    scale: f64,
    result: impl Fn([f64; N]) -> f64,
) -> [String; N] {
    /// The maximum number of figures: with more, the result would depend on rounding noise.
    const MOST: u8 = 10;
    let printed = |values| beside(result(values), scale);
    let wanted = printed(values);
    let texts = |count| values.map(|x| figures(x, count));
    let gives = |texts: &[String; N]| {
        let read = texts
            .each_ref()
            .map(|text| text.parse().unwrap_or(f64::NAN));
        printed(read) == wanted
    };
    let texts = (4..MOST)
        .map(texts)
        .find(gives)
        .unwrap_or_else(|| texts(MOST));
    texts.map(|text| match text.starts_with('-') {
        true => format!("({})", true_minus(&text)),
        false => text,
    })
}

/// The components of a vector; those that are rounding noise relative to its length or `scale` are
/// 0.
pub(super) fn vector(v: DVec2, scale: f64) -> String {
    let scale = scale.max(v.length());
    format!("({}, {})", beside(v.x, scale), beside(v.y, scale))
}

/// An angle given in radians, in degrees.
pub(super) fn degrees(angle: f64) -> String {
    format!("{}°", beside(angle.to_degrees(), 180.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_not_shown() {
        assert_eq!(beside(1e-16, 3.0), "0");
        assert_eq!(vector(DVec2::new(3.0, -1e-16), 0.0), "(3, 0)");
        assert_eq!(factor(-2.0, 1.0), "(−2)");
        assert_eq!(degrees(1e-16), "0°");
    }
}
