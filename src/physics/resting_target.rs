//! Closed forms for a smooth target at rest.
//!
//! For a given impact angle α, the striker's motion depends on one number, k = (1+e) m₂ / (m₁+m₂).
//! In units of the striker's speed u:
//!
//! ```text
//!   along u      v₁∥ = 1 − k cos²α          along n     v₁ₙ = (1 − k) cos α
//!   across u     v₁⊥ = k sin α cos α        across n    v₁ₜ = sin α
//!   target       v₂  = k (m₁/m₂) cos α, along n, so θ₂ = α
//! ```
//!
//! As α goes from 90° to 0 the tip of v₁ moves along a semicircle of radius k/2 about the point
//! (1 − k/2, 0) on the line of u: v₁ = (1 − k/2, 0) + (k/2)(cos Θ, sin Θ) with Θ = 180° − 2α. At
//! e = 1 that is the circle of the centre-of-mass frame: L. D. Landau and E. M. Lifshitz,
//! *Mechanics*, § 17. Below e = 1 the same holds with Newton's law of restitution along n, as in
//! W. Goldsmith, *Impact* (1960), chapter 2.
//!
//! Angles are in radians, speeds in units of u, and energies in units of ½m₁u². `None` means
//! undefined: a body at rest has no direction.

use std::f64::consts::FRAC_PI_2;

use super::Collision;
use super::impact::reduced_mass;

/// The rounding error allowed in a sine, a cosine or the square of a cosine. A square below 0 or
/// above 1 is clamped, which brings it closer to its true value.
const ROUNDING: f64 = 1e-12;

/// A striker, a smooth target at rest, and their coefficient of restitution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestingTarget {
    /// Mass of the striker in kilograms, positive.
    pub m1: f64,
    /// Mass of the target in kilograms, positive.
    pub m2: f64,
    /// Coefficient of restitution e, 0 to 1.
    pub restitution: f64,
}

/// The shares of the striker's energy; the three add up to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyShares {
    /// The share that the striker keeps.
    pub kept: f64,
    /// The share that the target gets.
    pub passed: f64,
    /// The share that is lost.
    pub lost: f64,
}

/// The greatest deflection of a striker in one collision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LargestDeflection {
    /// k < 1: a true maximum.
    Turned {
        /// The largest θ₁, atan(k / (2√(1−k))); at e = 1 that is asin(m₂/m₁).
        theta1: f64,
        /// The impact angle that gives the largest θ₁, atan √(1−k).
        alpha: f64,
    },
    /// k = 1: θ₁ = 90° − α comes arbitrarily close to 90°, but at α = 0 the striker stops and has
    /// no direction.
    NearlyRight,
    /// k > 1: in a head-on collision the striker comes straight back, θ₁ = 180°.
    Reversed,
}

impl From<&Collision> for RestingTarget {
    /// The masses and the coefficient of restitution of a collision, without its velocities.
    fn from(collision: &Collision) -> Self {
        Self {
            m1: collision.striker.mass,
            m2: collision.target.mass,
            restitution: collision.restitution,
        }
    }
}

impl RestingTarget {
    /// k = (1+e) m₂ / (m₁+m₂), from 0 to 2: the fraction of its normal velocity that the striker
    /// loses.
    pub fn k(&self) -> f64 {
        (1.0 + self.restitution) * (self.m2 / (self.m1 + self.m2))
    }

    /// 1 − k = (m₁ − e m₂) / (m₁+m₂), exactly 0 if m₁ = e m₂ except for rounding: 12 g must equal
    /// 0.8 × 15 g even when both are in kilograms.
    fn normal_kept(&self) -> f64 {
        let kept = self.m1 - self.restitution * self.m2;
        if kept.abs() <= 4.0 * f64::EPSILON * self.m1 {
            0.0
        } else {
            kept / (self.m1 + self.m2)
        }
    }

    /// (1+e) m₁ / (m₁+m₂), which is v₂ / u at α = 0.
    fn normal_passed(&self) -> f64 {
        (1.0 + self.restitution) * (self.m1 / (self.m1 + self.m2))
    }

    /// The components of v₁ along u and perpendicular to it, v₁ = (1 − k cos²α, k sin α cos α); the
    /// second is positive on the side away from the target when α > 0.
    pub(crate) fn striker_velocity(&self, alpha: f64) -> (f64, f64) {
        let (sin, cos) = sin_cos(alpha);
        // 1 − k cos²α, written so that nothing cancels near k = 1.
        let along = self.normal_kept() * cos * cos + sin * sin;
        (along, self.k() * sin * cos)
    }

    /// v₁ / u = √(sin²α + (1−k)² cos²α).
    pub fn striker_speed(&self, alpha: f64) -> f64 {
        let (sin, cos) = sin_cos(alpha);
        sin.hypot(self.normal_kept() * cos)
    }

    /// v₂ / u = (1+e) m₁/(m₁+m₂) cos α.
    pub fn target_speed(&self, alpha: f64) -> f64 {
        self.normal_passed() * sin_cos(alpha).1
    }

    /// Scattering angle θ₁ = atan2(k sin α cos α, 1 − k cos²α); `None` where the
    /// striker stops.
    pub fn theta1(&self, alpha: f64) -> Option<f64> {
        let (along, across) = self.striker_velocity(alpha);
        moves(along.hypot(across)).then(|| across.atan2(along))
    }

    /// Recoil angle θ₂ = α; `None` at ±90°, where the target stays at rest.
    pub fn theta2(&self, alpha: f64) -> Option<f64> {
        moves(sin_cos(alpha).1).then_some(alpha)
    }

    /// Angle between v₁ and v₂, atan2(sin|α|, (1−k) cos α); `None` if either disc is at rest.
    pub fn separation(&self, alpha: f64) -> Option<f64> {
        self.theta1(alpha)?;
        self.theta2(alpha)?;
        let (sin, cos) = sin_cos(alpha);
        Some(sin.abs().atan2(self.normal_kept() * cos))
    }

    /// The shares of energy after a collision at impact angle `alpha`. At e = 1 the target's share
    /// is 4m₁m₂/(m₁+m₂)² cos²α; equal masses share the energy in the ratio sin²α : cos²α.
    pub fn energy_shares(&self, alpha: f64) -> EnergyShares {
        let cos = sin_cos(alpha).1;
        EnergyShares {
            kept: self.striker_speed(alpha).powi(2),
            passed: self.head_on_energy_passed() * cos * cos,
            lost: self.head_on_energy_lost() * cos * cos,
        }
    }

    /// m₂v₂² / m₁u² at α = 0, the target's share of the energy.
    fn head_on_energy_passed(&self) -> f64 {
        self.k() * self.normal_passed()
    }

    /// (1−e²) μ / m₁, the share of the energy that is lost at α = 0.
    fn head_on_energy_lost(&self) -> f64 {
        let inelastic = (1.0 - self.restitution) * (1.0 + self.restitution);
        inelastic * reduced_mass(self.m2, self.m1) / self.m1
    }

    /// The largest θ₁ that any α can give.
    pub fn largest_deflection(&self) -> LargestDeflection {
        let kept = self.normal_kept();
        if kept > 0.0 {
            LargestDeflection::Turned {
                theta1: (self.k() / (2.0 * kept.sqrt())).atan(),
                alpha: kept.sqrt().atan(),
            }
        } else if kept < 0.0 {
            LargestDeflection::Reversed
        } else {
            LargestDeflection::NearlyRight
        }
    }

    /// The impact angle, 0 to 90°, at which the striker transfers `share` of its energy; `None` if
    /// there is none.
    pub(crate) fn alpha_for_energy_passed(&self, share: f64) -> Option<f64> {
        arccosine_of_root(share / self.head_on_energy_passed())
    }
}

/// k from the two final angles alone; `None` if they do not determine it (exactly head-on or a
/// graze) or contradict a smooth collision with a target at rest.
///
/// k = sin θ₁ / (cos θ₂ sin(θ₁+θ₂)), which is
/// tan θ₁ (1+T²) / (T + tan θ₁) with T = tan θ₂, without the poles.
pub(crate) fn k_from_angles(theta1: f64, theta2: f64) -> Option<f64> {
    let k = theta1.sin() / (theta2.cos() * (theta1 + theta2).sin());
    let offset = theta2.sin().abs() > ROUNDING && theta2.cos() > ROUNDING;
    let turned = theta1.sin().abs() > ROUNDING && (theta1 + theta2).sin().abs() > ROUNDING;
    (offset && turned && k > 0.0 && k < 2.0).then_some(k)
}

/// The ratio of the masses from the angles: m₁/m₂ = (1+e)/k − 1, which at e = 1 is sin(θ₁+2θ₂) /
/// sin θ₁; `None` if the angles do not determine it.
pub(crate) fn mass_ratio_from_angles(theta1: f64, theta2: f64, restitution: f64) -> Option<f64> {
    let ratio = (1.0 + restitution) / k_from_angles(theta1, theta2)? - 1.0;
    (ratio > 0.0).then_some(ratio)
}

/// sin and cos of an impact angle, with the cosine of 90° exactly 0.
fn sin_cos(alpha: f64) -> (f64, f64) {
    let (sin, cos) = alpha.sin_cos();
    let graze = alpha.abs() - FRAC_PI_2;
    (sin, if graze >= 0.0 { 0.0 } else { cos })
}

/// Whether a speed, as a fraction of the striker's, is more than rounding noise.
fn moves(share: f64) -> bool {
    share > 4.0 * f64::EPSILON
}

/// The angle from 0 to 90° whose squared cosine is `square`.
fn arccosine_of_root(square: f64) -> Option<f64> {
    (-ROUNDING..=1.0 + ROUNDING)
        .contains(&square)
        .then(|| square.clamp(0.0, 1.0).sqrt().acos())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::units::{deg_from_rad, rad_from_deg};
    use std::f64::consts::PI;

    const PAIRS: [(f64, f64, f64); 7] = [
        (15.0, 15.0, 1.0),
        (20.0, 40.0, 1.0),
        (15.0, 5.5, 1.0),
        (15.0, 5.5, 0.3),
        (5.5, 15.0, 0.8),
        (12.0, 15.0, 0.8),
        (1.0, 1000.0, 0.0),
    ];

    fn pairs() -> impl Iterator<Item = RestingTarget> {
        PAIRS.into_iter().map(|(m1, m2, e)| pair(m1, m2, e))
    }

    fn pair(m1: f64, m2: f64, restitution: f64) -> RestingTarget {
        RestingTarget {
            m1: m1 / 1000.0,
            m2: m2 / 1000.0,
            restitution,
        }
    }

    fn close(a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance, "{a} is not {b}");
    }

    fn alphas() -> impl Iterator<Item = f64> {
        (1..90).map(|deg| rad_from_deg(f64::from(deg)))
    }

    #[test]
    fn equal_masses_share_energy_as_squared_sine_and_cosine() {
        let p = pair(15.0, 15.0, 1.0);
        for alpha in alphas() {
            close(p.theta1(alpha).unwrap(), FRAC_PI_2 - alpha, 1e-14);
            close(p.striker_speed(alpha), alpha.sin(), 1e-15);
            close(p.target_speed(alpha), alpha.cos(), 1e-15);
            let shares = p.energy_shares(alpha);
            close(shares.kept, alpha.sin().powi(2), 1e-15);
            close(shares.passed, alpha.cos().powi(2), 1e-15);
        }
        assert_eq!(p.theta1(0.0), None);
        assert_eq!(p.separation(0.0), None);
        assert_eq!(p.theta2(0.0), Some(0.0));
    }

    #[test]
    fn worked_values_are_reproduced() {
        let tournament = pair(15.0, 5.5, 1.0);
        let alpha = rad_from_deg(30.0);
        let separation = deg_from_rad(tournament.separation(alpha).unwrap());
        close(separation, 51.247_462, 5e-7);
        let marbles = pair(20.0, 40.0, 1.0);
        let alpha = rad_from_deg(45.0);
        let theta1 = deg_from_rad(marbles.theta1(alpha).unwrap());
        close(theta1, deg_from_rad(2.0_f64.atan()), 1e-12);
        let separation = deg_from_rad(marbles.separation(alpha).unwrap());
        close(separation, 45.0 + deg_from_rad(2.0_f64.atan()), 1e-12);
        close(3.0 * marbles.striker_speed(alpha), 5.0_f64.sqrt(), 1e-15);
        close(3.0 * marbles.target_speed(alpha), 2.0_f64.sqrt(), 1e-15);
    }

    #[test]
    fn the_separation_is_the_sum_of_the_angles() {
        for p in pairs() {
            for alpha in alphas() {
                let sum = p.theta1(alpha).unwrap() + p.theta2(alpha).unwrap();
                close(p.separation(alpha).unwrap(), sum, 1e-14);
            }
        }
    }

    #[test]
    fn the_separation_is_90_degrees_exactly_at_m1_equal_to_e_m2() {
        for e in [1.0, 0.8, 0.5, 0.1] {
            for alpha in alphas() {
                let at = |factor| {
                    let p = pair(15.0 * e * factor, 15.0, e);
                    deg_from_rad(p.separation(alpha).unwrap())
                };
                close(at(1.0), 90.0, 1e-12);
                assert!(at(0.999) > 90.0, "lighter: more than 90");
                assert!(at(1.001) < 90.0, "heavier: less than 90");
            }
        }
    }

    #[test]
    fn energy_shares_add_up() {
        for p in pairs() {
            for alpha in alphas() {
                let EnergyShares { kept, passed, lost } = p.energy_shares(alpha);
                close(kept + passed + lost, 1.0, 1e-14);
                let from_speed = p.m2 / p.m1 * p.target_speed(alpha).powi(2);
                close(passed, from_speed, 1e-14);
                if p.restitution >= 1.0 {
                    let most = 4.0 * p.m1 * p.m2 / (p.m1 + p.m2).powi(2);
                    close(passed, most * alpha.cos().powi(2), 1e-15);
                }
            }
        }
    }

    #[test]
    fn a_heavy_striker_has_a_largest_deflection_below_90_degrees() {
        let LargestDeflection::Turned { theta1, alpha } = pair(15.0, 5.5, 1.0).largest_deflection()
        else {
            panic!("15 g on 5.5 g has a largest deflection");
        };
        close(theta1, (5.5_f64 / 15.0).asin(), 1e-15);
        close(deg_from_rad(theta1), 21.510, 5e-4);
        let p = pair(15.0, 5.5, 0.3);
        let LargestDeflection::Turned {
            theta1: most,
            alpha: at,
        } = p.largest_deflection()
        else {
            panic!("15 g on 5.5 g has one at any restitution");
        };
        close(p.theta1(at).unwrap(), most, 1e-15);
        for other in alphas() {
            assert!(p.theta1(other).unwrap() <= most);
        }
        close(pair(15.0, 5.5, 1.0).theta1(alpha).unwrap(), theta1, 1e-15);
    }

    #[test]
    fn a_light_striker_can_be_reversed_and_an_equal_one_nearly_turned_by_90_degrees() {
        let light = pair(5.5, 15.0, 1.0);
        assert_eq!(light.largest_deflection(), LargestDeflection::Reversed);
        assert_eq!(light.theta1(0.0), Some(PI));
        for (m1, m2, e) in [(15.0, 15.0, 1.0), (12.0, 15.0, 0.8)] {
            let most = pair(m1, m2, e).largest_deflection();
            assert_eq!(most, LargestDeflection::NearlyRight);
        }
    }

    #[test]
    fn the_angle_for_a_transferred_share_gives_that_share() {
        for p in pairs() {
            for alpha in alphas() {
                let passed = p.alpha_for_energy_passed(p.energy_shares(alpha).passed);
                close(passed.unwrap(), alpha, 1e-12);
            }
        }
        let p = pair(15.0, 5.5, 1.0);
        assert_eq!(p.alpha_for_energy_passed(0.9), None);
        assert_eq!(p.alpha_for_energy_passed(f64::NAN), None);
    }

    /// If m₁ > e m₂, a fuller and a thinner hit can deflect the striker by the same angle;
    /// otherwise, the thinner the hit, the smaller the deflection.
    #[test]
    fn only_a_striker_heavier_than_e_m2_has_two_impact_angles_for_one_deflection() {
        for p in pairs() {
            let turns: Vec<f64> = alphas().map(|alpha| p.theta1(alpha).unwrap()).collect();
            let rises = turns.windows(2).filter(|pair| pair[1] > pair[0]).count();
            let LargestDeflection::Turned { .. } = p.largest_deflection() else {
                assert_eq!(rises, 0);
                continue;
            };
            assert!(rises > 0 && rises < turns.len() - 1);
        }
    }

    #[test]
    fn the_final_angles_give_the_mass_ratio() {
        for p in pairs() {
            for alpha in alphas() {
                let theta1 = p.theta1(alpha).unwrap();
                let ratio = mass_ratio_from_angles(theta1, alpha, p.restitution).unwrap();
                let exact = p.m1 / p.m2;
                close(ratio, exact, 1e-11 * (1.0 + exact));
                let tan = (alpha.tan(), theta1.tan());
                let k = tan.1 * (1.0 + tan.0 * tan.0) / (tan.0 + tan.1);
                close(k_from_angles(theta1, alpha).unwrap(), p.k(), 1e-12);
                if (theta1 - FRAC_PI_2).abs() > 0.01 {
                    close(k, p.k(), 1e-10);
                }
                if p.restitution >= 1.0 {
                    let sines = (theta1 + 2.0 * alpha).sin() / theta1.sin();
                    close(ratio, sines, 1e-11 * (1.0 + exact));
                }
            }
        }
    }

    #[test]
    fn unsuitable_angles_give_no_mass_ratio() {
        assert_eq!(mass_ratio_from_angles(0.0, 0.0, 1.0), None);
        assert_eq!(mass_ratio_from_angles(0.5, 0.0, 1.0), None);
        assert_eq!(mass_ratio_from_angles(PI, 0.0, 1.0), None);
        assert_eq!(mass_ratio_from_angles(-0.5, 0.3, 1.0), None);
        // No target could deflect the striker so far at e = 0.
        assert_eq!(mass_ratio_from_angles(2.5, 0.3, 0.0), None);
    }
}
