//! Figures as the quiz prints them.

/// An angle of `angle` radians in tenths of a degree, rounded.
pub fn tenths(angle: f64) -> i64 {
    (angle.to_degrees() * 10.0).round() as i64
}

/// An angle of `angle` radians to a tenth of a degree, with its unit: "63.4°".
pub fn degrees(angle: f64) -> String {
    format!("{}°", bare_degrees(angle))
}

/// An angle of `angle` radians to a tenth of a degree, without a unit: "63.4".
pub fn bare_degrees(angle: f64) -> String {
    // By way of a whole number, for "-0.0" is no figure to show.
    format!("{:.1}", tenths(angle) as f64 / 10.0)
}

/// Points to a tenth: "8.0", "-2.0".
pub fn points(points: f64) -> String {
    // By way of a whole number, for "-0.0" is no figure to show.
    format!("{:.1}", (10.0 * points).round() / 10.0 + 0.0)
}

/// `x` to three significant figures, trailing zeros kept: "15.0", "5.50", "0.707".
pub fn significant(x: f64) -> String {
    // The exponent is taken after rounding: 9.999 is 10.0, not 10.00.
    let scientific = format!("{x:.2e}");
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse::<i32>().ok())
        .unwrap_or(0);
    let decimals = usize::try_from(2 - exponent).unwrap_or(0);
    format!("{x:.decimals$}")
}

/// A length of `length_mm` millimetres to a hundredth, as discs are measured, and with
/// three figures at least: "8.60", "30.0", "36.55".
pub fn bare_millimetres(length_mm: f64) -> String {
    let rounded = significant(length_mm);
    let exact = format!("{length_mm:.2}");
    match exact.strip_suffix('0') {
        Some(_) => rounded,
        None => exact,
    }
}

/// The same with its unit: "36.55 mm".
pub fn millimetres(length_mm: f64) -> String {
    format!("{} mm", bare_millimetres(length_mm))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_figures() {
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
    fn points_to_a_tenth() {
        for (x, text) in [(8.0, "8.0"), (-2.0, "-2.0"), (-0.04, "0.0"), (9.96, "10.0")] {
            assert_eq!(points(x), text);
        }
    }

    #[test]
    fn lengths_to_a_hundredth() {
        assert_eq!(millimetres(8.6), "8.60 mm");
        assert_eq!(millimetres(30.0), "30.0 mm");
        assert_eq!(millimetres(20.65 + 15.9), "36.55 mm");
    }

    #[test]
    fn angles_to_a_tenth() {
        assert_eq!(degrees(2_f64.atan()), "63.4°");
        assert_eq!(degrees(-1e-9), "0.0°");
        assert_eq!(bare_degrees(-0.5), "-28.6");
    }
}
