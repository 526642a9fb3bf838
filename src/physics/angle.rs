//! Angles between velocities, undefined where there is no velocity.

use glam::DVec2;

use super::direction::direction;

/// The angle that turns `from` into `to`, in radians, positive anticlockwise, in (−π, π]; `None` if
/// either vector is zero.
///
/// A component perpendicular to `from` that is rounding noise counts as 0, so straight on is 0 and
/// straight back is +π.
pub(crate) fn signed_angle(from: DVec2, to: DVec2) -> Option<f64> {
    let from = from.try_normalize()?;
    let to = to.try_normalize()?;
    let across = from.perp_dot(to);
    let across = if across.abs() <= 16.0 * f64::EPSILON {
        0.0
    } else {
        across
    };
    Some(across.atan2(from.dot(to)))
}

/// The unit vector at `angle_deg` degrees from +x, anticlockwise; exact along the axes, where a
/// cosine would leave a rounding error.
pub fn unit_vector(angle_deg: f64) -> DVec2 {
    along(angle_deg, DVec2::from_angle)
}

/// The unit vector of a stroke's direction, identical to the last bit on every machine: a single
/// different bit can change a whole board.
pub fn heading(angle_deg: f64) -> DVec2 {
    along(angle_deg, direction)
}

fn along(angle_deg: f64, of_radians: fn(f64) -> DVec2) -> DVec2 {
    let quarters = angle_deg / 90.0;
    if quarters.fract() == 0.0 {
        [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y][quarters.rem_euclid(4.0) as usize]
    } else {
        of_radians(quarters * std::f64::consts::FRAC_PI_2)
    }
}

/// The angle between two velocities in radians, in [0, π]; `None` if either is zero.
pub(crate) fn angle_between(a: DVec2, b: DVec2) -> Option<f64> {
    signed_angle(a, b).map(f64::abs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn unit_vectors_along_the_axes_are_exact() {
        assert_eq!(unit_vector(90.0), DVec2::Y);
        assert_eq!(unit_vector(-90.0), DVec2::NEG_Y);
        assert_eq!(unit_vector(180.0), DVec2::NEG_X);
        assert_eq!(unit_vector(-180.0), DVec2::NEG_X);
        assert_eq!(unit_vector(720.0), DVec2::X);
        let diagonal = DVec2::splat(0.5_f64.sqrt());
        assert!(unit_vector(45.0).distance(diagonal) < 1e-15);
    }

    #[test]
    fn quarter_turns_have_a_sign() {
        assert_eq!(signed_angle(DVec2::X, DVec2::Y), Some(FRAC_PI_2));
        assert_eq!(signed_angle(DVec2::Y, DVec2::X), Some(-FRAC_PI_2));
        assert_eq!(angle_between(DVec2::Y, DVec2::X), Some(FRAC_PI_2));
    }

    #[test]
    fn straight_on_and_straight_back_are_exact() {
        for step in 0..100 {
            let v = 3.0 * DVec2::from_angle(f64::from(step));
            assert_eq!(signed_angle(v, 0.3 * v), Some(0.0));
            assert_eq!(signed_angle(v, -0.3 * v), Some(PI));
        }
    }

    #[test]
    fn nothing_at_rest_has_a_direction() {
        assert_eq!(signed_angle(DVec2::ZERO, DVec2::X), None);
        assert_eq!(angle_between(DVec2::X, DVec2::ZERO), None);
    }
}
