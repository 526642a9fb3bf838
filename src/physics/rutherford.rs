//! Rutherford scattering: the glancing collision of two charges that repel.
//!
//! The target is treated as fixed, which is a good approximation for a gold nucleus struck by an
//! α-particle. See E. Rutherford, Phil. Mag. 21 (1911) 669.

use std::f64::consts::PI;

/// Elementary charge e in coulombs, exact by definition of the SI (2019).
pub(crate) const ELEMENTARY_CHARGE: f64 = 1.602_176_634e-19;

/// Electric constant ε₀ in F/m, CODATA 2018.
pub(crate) const ELECTRIC_CONSTANT: f64 = 8.854_187_812_8e-12;

/// e²/(4πε₀) in joule metres; 1.43996 MeV·fm.
pub(crate) const COULOMB_ENERGY_LENGTH: f64 =
    ELEMENTARY_CHARGE * ELEMENTARY_CHARGE / (4.0 * PI * ELECTRIC_CONSTANT);

/// One mega-electronvolt in joules.
pub const MEV: f64 = 1e6 * ELEMENTARY_CHARGE;

/// One femtometre in metres.
pub const FM: f64 = 1e-15;

/// Charge number of an α-particle.
pub(crate) const ALPHA_CHARGE: f64 = 2.0;

/// Mass number of an α-particle.
pub(crate) const ALPHA_MASS_NUMBER: f64 = 4.0;

/// Charge number of gold.
pub const GOLD_CHARGE: f64 = 79.0;

/// Radius of a nucleus of mass number 1 in metres, r₀ in R = r₀ A^⅓: about 1.2 fm, from the
/// scattering of electrons (K. S. Krane, Introductory Nuclear Physics, 1988, section 3.1).
const NUCLEAR_RADIUS: f64 = 1.2 * FM;

/// Energy in joules of radium C's α-particles (from ²¹⁴Po): 7.69 MeV.
pub const RADIUM_C_ENERGY: f64 = 7.69 * MEV;

/// Atoms in a cubic metre of gold.
pub const GOLD_DENSITY: f64 = 5.9e28;

/// The fraction of α-particles from radium C that Geiger and Marsden counted at 45° behind 2.1·10⁻⁵
/// cm of gold on a screen of 1 mm² at 1 cm, known to within 20 % (Phil. Mag. 25 (1913) 604): the
/// only count whose absolute scale is known.
pub const MEASURED_SHARE: f64 = 3.7e-7;

/// A charged projectile and a fixed charge of the same sign.
///
/// Scattering angles Θ are in radians, above 0 and up to π: a repulsion of infinite range deflects
/// every projectile a little, so at Θ = 0 nothing is defined.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rutherford {
    /// Closest approach in a head-on shot, d, in metres.
    pub head_on_approach: f64,
}

impl Rutherford {
    /// A projectile of charge number `z1` and kinetic energy `energy` joules, and a target of
    /// charge number `z2`, all positive: d = q₁q₂ / (4πε₀E).
    pub fn new(z1: f64, z2: f64, energy: f64) -> Self {
        Self {
            head_on_approach: COULOMB_ENERGY_LENGTH * z1 * z2 / energy,
        }
    }

    /// The α-particles from radium C on gold: d = 29.6 fm.
    pub fn radium_c_on_gold() -> Self {
        Self::new(ALPHA_CHARGE, GOLD_CHARGE, RADIUM_C_ENERGY)
    }

    /// Impact parameter b = (d/2) cot(Θ/2) in metres.
    pub(crate) fn impact_parameter(&self, angle: f64) -> Option<f64> {
        let half = half_angle(angle)?;
        Some(self.head_on_approach / 2.0 * half.cos() / half.sin())
    }

    /// Scattering angle Θ = 2 atan(d / 2b) in radians, for b ≥ 0 metres.
    pub fn scattering_angle(&self, impact_parameter: f64) -> f64 {
        2.0 * (self.head_on_approach / 2.0).atan2(impact_parameter)
    }

    /// Closest approach r_min = (d/2)(1 + 1/sin(Θ/2)) in metres.
    pub(crate) fn closest_approach(&self, angle: f64) -> Option<f64> {
        let half = half_angle(angle)?;
        Some(self.head_on_approach / 2.0 * (1.0 + 1.0 / half.sin()))
    }

    /// Differential cross-section dσ/dΩ = (d/4)² / sin⁴(Θ/2) in m²/sr.
    pub(crate) fn differential_cross_section(&self, angle: f64) -> Option<f64> {
        let half = half_angle(angle)?;
        Some((self.head_on_approach / 4.0).powi(2) / half.sin().powi(4))
    }

    /// Cross-section for scattering by more than Θ, π (d/2)² cot²(Θ/2), in m².
    pub(crate) fn cross_section_beyond(&self, angle: f64) -> Option<f64> {
        self.impact_parameter(angle).map(|b| PI * b * b)
    }

    /// The fraction of a beam that a foil of `atoms_per_area` atoms/m² scatters at Θ into a small
    /// solid angle of `solid_angle` steradians, each particle scattered at most once.
    pub(crate) fn share_into(
        &self,
        angle: f64,
        solid_angle: f64,
        atoms_per_area: f64,
    ) -> Option<f64> {
        Some(self.differential_cross_section(angle)? * solid_angle * atoms_per_area)
    }
}

/// Distance between the centres at which an α-particle and a nucleus of this mass number touch,
/// r₀ (A_α^⅓ + A^⅓), in metres. Within this distance, and slightly beyond it, the nuclear force
/// acts.
pub(crate) fn touching_distance(mass_number: f64) -> f64 {
    NUCLEAR_RADIUS * (ALPHA_MASS_NUMBER.cbrt() + mass_number.cbrt())
}

/// The fraction by which the closest approach in a head-on shot is larger than for a fixed nucleus:
/// only the energy E M/(m + M) in the centre-of-mass frame goes into the repulsion, so d is larger
/// by the factor 1 + m/M.
pub(crate) fn recoil_share(mass_number: f64) -> f64 {
    ALPHA_MASS_NUMBER / mass_number
}

/// Θ/2, if Θ is a possible scattering angle.
fn half_angle(angle: f64) -> Option<f64> {
    (angle > 0.0 && angle <= PI).then_some(angle / 2.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64, relative: f64) {
        assert!((a / b - 1.0).abs() <= relative, "{a} is not {b}");
    }

    #[test]
    fn the_coulomb_constant_has_its_known_value() {
        close(COULOMB_ENERGY_LENGTH / (MEV * FM), 1.43996, 5e-6);
    }

    #[test]
    fn radium_c_on_gold_comes_within_30_fm() {
        let d = Rutherford::radium_c_on_gold().head_on_approach;
        assert!((d / FM - 29.6).abs() < 0.05);
        // At the closest approach of a head-on particle all the energy is potential.
        let potential = COULOMB_ENERGY_LENGTH * ALPHA_CHARGE * GOLD_CHARGE / d;
        close(potential, RADIUM_C_ENERGY, 1e-14);
    }

    /// Geiger and Marsden's absolute count at 45°: 2.1·10⁻⁵ cm of gold, a screen of 1 mm² at 1 cm.
    #[test]
    fn the_absolute_count_at_45_degrees_agrees_with_the_measurement() {
        let share = Rutherford::radium_c_on_gold()
            .share_into(PI / 4.0, 1e-6 / 1e-4, GOLD_DENSITY * 2.1e-7)
            .unwrap();
        assert!((share - 3.2e-7).abs() < 0.05e-7, "{share}");
        assert!((share - MEASURED_SHARE).abs() < 0.2 * MEASURED_SHARE);
    }

    #[test]
    fn impact_parameter_and_angle_are_inverse_functions() {
        let gold = Rutherford::radium_c_on_gold();
        for deg in 1..=180 {
            let angle = f64::from(deg).to_radians();
            let b = gold.impact_parameter(angle).unwrap();
            close(gold.scattering_angle(b), angle, 1e-13);
            close(
                gold.cross_section_beyond(angle).unwrap() + 1.0,
                PI * b * b + 1.0,
                1e-15,
            );
        }
        close(gold.scattering_angle(0.0), PI, 1e-15);
    }

    /// At closest approach the velocity is perpendicular to the radius, so angular momentum gives
    /// the speed, and energy must balance: (b/r)² + d/r = 1.
    #[test]
    fn closest_approach_conserves_energy_and_angular_momentum() {
        let gold = Rutherford::radium_c_on_gold();
        for deg in 1..=180 {
            let angle = f64::from(deg).to_radians();
            let b = gold.impact_parameter(angle).unwrap();
            let r = gold.closest_approach(angle).unwrap();
            close((b / r).powi(2) + gold.head_on_approach / r, 1.0, 1e-14);
        }
    }

    /// dσ/dΩ is the decrease per steradian of the cross-section beyond Θ.
    #[test]
    fn the_two_cross_sections_agree() {
        let gold = Rutherford::radium_c_on_gold();
        for deg in 5..175 {
            let angle = f64::from(deg).to_radians();
            let h = 1e-4;
            let beyond = |a| gold.cross_section_beyond(a).unwrap();
            let lost = beyond(angle - h) - beyond(angle + h);
            let steradians = 2.0 * PI * ((angle - h).cos() - (angle + h).cos());
            close(
                lost / steradians,
                gold.differential_cross_section(angle).unwrap(),
                1e-5,
            );
        }
    }

    #[test]
    fn nothing_is_defined_without_deflection() {
        let gold = Rutherford::radium_c_on_gold();
        for angle in [0.0, -1.0, 4.0, f64::NAN] {
            assert_eq!(gold.impact_parameter(angle), None);
            assert_eq!(gold.closest_approach(angle), None);
            assert_eq!(gold.differential_cross_section(angle), None);
            assert_eq!(gold.cross_section_beyond(angle), None);
        }
    }

    /// Geiger and Marsden's relative counts for gold, times sin⁴(Θ/2), are in a band of −15 % to
    /// +23 % about their mean, and rise at small angles.
    #[test]
    fn the_measured_counts_follow_the_law_within_a_band() {
        let gold = [
            (150.0_f64, 33.1),
            (135.0, 43.0),
            (120.0, 51.9),
            (105.0, 69.5),
            (75.0, 211.0),
            (60.0, 477.0),
            (45.0, 1435.0),
            (37.5, 3300.0),
            (30.0, 7800.0),
            (22.5, 27300.0),
            (15.0, 132_000.0),
        ];
        let level = gold.map(|(deg, count)| count * (deg.to_radians() / 2.0).sin().powi(4));
        let mean = level.iter().sum::<f64>() / level.len() as f64;
        let off = level.map(|l| l / mean - 1.0);
        let lowest = off.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = off.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!((lowest + 0.15).abs() < 0.005, "{lowest}");
        assert!((highest - 0.23).abs() < 0.005, "{highest}");
    }
}
