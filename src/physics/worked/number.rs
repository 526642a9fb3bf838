//! Numbers as they stand in a worked solution: four digits, no noise.

use glam::DVec2;

/// What is smaller than this share of its scale is shown as 0.
const NOISE: f64 = 1e-9;

/// A number to four significant digits, without trailing zeros and with a proper
/// minus sign.
pub fn number(x: f64) -> String {
    let size = x.abs();
    let text = if size <= 0.0 {
        "0".to_owned()
    } else if (1e-4..1e6).contains(&size) {
        // Rounding first settles whether 9.9996 has one digit before the point or two.
        let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
        let before_point = rounded.abs().log10().floor() as i32;
        let decimals = usize::try_from(3 - before_point).unwrap_or(0);
        trimmed(&format!("{rounded:.decimals$}"))
    } else {
        let text = format!("{x:.3e}");
        match text.split_once('e') {
            Some((mantissa, exponent)) => format!("{}e{exponent}", trimmed(mantissa)),
            None => text,
        }
    };
    text.replace('-', "−")
}

/// A number that is 0 where it is rounding noise beside `scale`.
pub fn beside(x: f64, scale: f64) -> String {
    number(if x.abs() <= NOISE * scale { 0.0 } else { x })
}

/// A number to be put after an operator: in brackets where it is negative.
pub fn factor(x: f64, scale: f64) -> String {
    let text = beside(x, scale);
    if text.starts_with('−') {
        format!("({text})")
    } else {
        text
    }
}

/// A vector by its components, without the noise beside its own length or `scale`.
pub fn vector(v: DVec2, scale: f64) -> String {
    let scale = scale.max(v.length());
    format!("({}, {})", beside(v.x, scale), beside(v.y, scale))
}

/// An angle given in radians, in degrees.
pub fn degrees(angle: f64) -> String {
    format!("{}°", beside(angle.to_degrees(), 180.0))
}

fn trimmed(decimal: &str) -> String {
    if decimal.contains('.') {
        let short = decimal.trim_end_matches('0').trim_end_matches('.');
        short.to_owned()
    } else {
        decimal.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_digits_and_no_more_than_needed() {
        for (x, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (15.0, "15"),
            (2.0 * 3.0_f64.sqrt(), "3.464"),
            (-0.5, "−0.5"),
            (9.999_96, "10"),
            (99_996.0, "100000"),
            (0.000_123_456, "0.0001235"),
            (0.000_012_3, "1.23e−5"),
            (1.5e9, "1.5e9"),
            (1234.5, "1234"),
            (90.0 - 1e-13, "90"),
        ] {
            assert_eq!(number(x), text);
        }
    }

    #[test]
    fn noise_is_not_shown() {
        assert_eq!(beside(1e-16, 3.0), "0");
        assert_eq!(vector(DVec2::new(3.0, -1e-16), 0.0), "(3, 0)");
        assert_eq!(factor(-2.0, 1.0), "(−2)");
        assert_eq!(degrees(1e-16), "0°");
    }
}
