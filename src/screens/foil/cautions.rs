//! Warnings where a fixed point charge is not a good model of the nucleus.

use super::setup::{FoilSetup, Obstacle};
use crate::physics::rutherford::{ALPHA_MASS_NUMBER, FM, recoil_share, touching_distance};
use crate::widgets::Role;
use crate::widgets::panel::Panel;

/// The smallest error of the fixed-nucleus model that is reported, as a fraction. Copper (6 %) and
/// aluminium (15 %) exceed it; silver (4 %), platinum and gold (2 %) do not.
const REPORTED: f64 = 0.05;

/// Writes the warnings for this nucleus and energy, each followed by a gap.
pub(super) fn write<A>(setup: &FoilSetup, panel: &mut Panel<A>) {
    for caution in cautions(setup) {
        panel.paragraph(caution, Role::Warn);
        panel.gap();
    }
}

fn cautions(setup: &FoilSetup) -> Vec<String> {
    let mut cautions = Vec::new();
    if setup.obstacle == Obstacle::Hard {
        return cautions;
    }
    let mass_number = setup.metal().mass_number;
    let d = setup.scatterer().head_on_approach / FM;
    let touching = touching_distance(mass_number) / FM;
    if d < touching {
        cautions.push(format!(
            "d = {d:.1} fm is less than the touching distance of the two nuclei, about \
             {touching:.1} fm. The nuclear force, which reaches about 1 fm farther, would act; carrom \
             leaves it out."
        ));
    }
    let recoil = recoil_share(mass_number);
    if recoil >= REPORTED {
        cautions.push(format!(
            "carrom holds the nucleus still. A nucleus of mass number {mass_number} recoils, so d \
             should be {:.0} % larger (by the factor 1 + {ALPHA_MASS_NUMBER}/{mass_number}): {:.1} fm.",
            100.0 * recoil,
            d * (1.0 + recoil)
        ));
    }
    cautions
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::beams::METALS;

    fn said(metal: &str, energy_mev: f64) -> String {
        let metal = METALS.iter().position(|one| one.name == metal).unwrap();
        let setup = FoilSetup {
            metal,
            energy_mev,
            ..FoilSetup::default()
        };
        cautions(&setup).join(" ")
    }

    #[test]
    fn fast_alpha_particles_touch_aluminium() {
        let said = said("aluminium", 7.69);
        for part in [
            "d = 4.9 fm is less than the touching distance",
            "about 5.5 fm",
            "15 % larger (by the factor 1 + 4/27): 5.6 fm",
        ] {
            assert!(said.contains(part), "{part}: {said}");
        }
        assert_eq!(
            cautions(&FoilSetup {
                obstacle: Obstacle::Hard,
                metal: 4,
                ..FoilSetup::default()
            }),
            Vec::<String>::new()
        );
    }

    /// At 6.80 MeV, d = 2 · 13 · 1.44 MeV fm / E equals the touching distance 1.2 fm (4^⅓ + 27^⅓).
    #[test]
    fn slow_alpha_particles_do_not_touch_and_heavy_nuclei_do_not_recoil() {
        assert!(said("aluminium", 6.85).contains("touching distance"));
        let slow = said("aluminium", 6.75);
        assert!(!slow.contains("touching distance") && slow.contains("15 %"));
        assert!(said("copper", 10.0).starts_with("carrom holds the nucleus still"));
        assert!(said("copper", 10.0).contains("6 % larger"));
        for heavy in ["gold", "platinum", "silver"] {
            assert_eq!(said(heavy, 10.0), "");
        }
    }
}
