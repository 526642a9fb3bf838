//! The units of the screen and of files, to and from SI.

use std::f64::consts::PI;

/// Grams to kilograms.
pub(crate) const fn kg_from_g(mass_g: f64) -> f64 {
    mass_g / 1000.0
}

/// Kilograms to grams.
pub(crate) const fn g_from_kg(mass: f64) -> f64 {
    mass * 1000.0
}

/// Millimetres to metres.
pub(crate) const fn m_from_mm(length_mm: f64) -> f64 {
    length_mm / 1000.0
}

/// Metres to millimetres.
pub(crate) const fn mm_from_m(length: f64) -> f64 {
    length * 1000.0
}

/// Degrees to radians.
pub const fn rad_from_deg(angle_deg: f64) -> f64 {
    angle_deg * (PI / 180.0)
}

/// Radians to degrees.
pub const fn deg_from_rad(angle: f64) -> f64 {
    angle * (180.0 / PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_conversion_undoes_its_inverse() {
        for x in [0.1, 5.5, 15.0, 20.65, 63.434_948_822_922_01, 180.0] {
            assert!((g_from_kg(kg_from_g(x)) - x).abs() <= 1e-15 * x);
            assert!((mm_from_m(m_from_mm(x)) - x).abs() <= 1e-15 * x);
            assert!((deg_from_rad(rad_from_deg(x)) - x).abs() <= 1e-15 * x);
        }
        assert!((rad_from_deg(90.0) - PI / 2.0).abs() < 1e-16);
    }
}
