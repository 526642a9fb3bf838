//! Perfectly inelastic collisions: two discs that stick where they touch and move on as one body.
//!
//! This is not the same as e = 0. Smooth discs with e = 0 ("slip") keep their different tangential
//! velocities; discs that stick move on as one body with their centre of mass and, after an
//! off-centre contact, rotate about it.

use super::Disc;
use super::impact::reduced_mass;
use super::rims::inertia;

/// The rotation of a pair that sticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Capture {
    /// Angular velocity ω in rad/s, positive clockwise like the recoil angle: a positive offset
    /// gives a positive ω.
    pub(crate) spin: f64,
    /// Energy of that rotation, ½ I ω², in joules.
    pub(crate) rotation_energy: f64,
    /// Kinetic energy lost, in joules; the rotational energy does not count as lost.
    pub energy_lost: f64,
}

/// The pair that `striker` and `target` form at offset `b` metres and relative speed `w` m/s.
///
/// Angular momentum μ b w about the common centre of mass is conserved, so ω = μ b w / I with I =
/// ½m₁r₁² + ½m₂r₂² + μ(r₁+r₂)²: each disc about its own centre, and the two centres about the
/// common one.
pub(crate) fn capture(striker: Disc, target: Disc, b: f64, w: f64) -> Capture {
    let mu = reduced_mass(striker.mass, target.mass);
    let inertia = moment_of_inertia(striker, target);
    let spin = mu * b * w / inertia;
    let rotation_energy = 0.5 * inertia * spin * spin;
    let kept = mu * b * b / inertia;
    Capture {
        spin,
        rotation_energy,
        energy_lost: 0.5 * mu * w * w * (1.0 - kept),
    }
}

/// Moment of inertia of two uniform discs stuck rim to rim, about their common
/// centre of mass, in kg·m²: ½m₁r₁² + ½m₂r₂² + μ(r₁+r₂)².
pub(crate) fn moment_of_inertia(disc1: Disc, disc2: Disc) -> f64 {
    let reach = disc1.radius + disc2.radius;
    inertia(disc1) + inertia(disc2) + reduced_mass(disc1.mass, disc2.mass) * reach * reach
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An independent calculation: the parallel axis theorem about the actual centre of mass.
    #[test]
    fn inertia_is_that_of_two_discs_about_their_centre_of_mass() {
        let (a, b) = (Disc::from_g_mm(15.0, 20.65), Disc::from_g_mm(5.5, 15.9));
        let reach = a.radius + b.radius;
        let centre = b.mass * reach / (a.mass + b.mass);
        let about = |d: Disc, x: f64| d.mass * (0.5 * d.radius * d.radius + x * x);
        let steiner = about(a, centre) + about(b, reach - centre);
        assert!((moment_of_inertia(a, b) - steiner).abs() < 1e-12 * steiner);
    }

    /// Two equal discs of 10 g and 10 mm, offset 10 mm, 3 m/s, by hand: μ = 5 g, I = 500 + 500 + 5
    /// · 400 = 3000 g mm² = 3·10⁻⁶ kg·m², so ω = 0.005 · 0.01 · 3 / (3·10⁻⁶) = 50 rad/s.
    #[test]
    fn the_rotation_agrees_with_a_calculation_by_hand() {
        let disc = Disc::from_g_mm(10.0, 10.0);
        let pair = capture(disc, disc, 0.010, 3.0);
        assert!((moment_of_inertia(disc, disc) - 3.0e-6).abs() < 1e-18);
        assert!((pair.spin - 50.0).abs() < 1e-12);
        assert!((pair.rotation_energy - 0.00375).abs() < 1e-15);
        assert!((pair.energy_lost - (0.0225 - 0.00375)).abs() < 1e-15);
    }

    #[test]
    fn a_head_on_collision_causes_no_rotation() {
        let disc = Disc::from_g_mm(15.0, 15.0);
        assert!(capture(disc, disc, 0.0, 4.0).spin.abs() < f64::MIN_POSITIVE);
    }
}
