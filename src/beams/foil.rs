//! Metal foils in a beam of α-particles.

use std::f64::consts::PI;

use super::BeamTarget;
use crate::physics::rutherford::{ALPHA_CHARGE, GOLD_CHARGE, GOLD_DENSITY, Rutherford};

/// A metal for foils.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Metal {
    /// The name of the metal.
    pub name: &'static str,
    /// Charge number Z.
    pub charge: f64,
    /// Mass number A: the relative atomic mass rounded to a whole number.
    pub(crate) mass_number: f64,
    /// Number of atoms per cubic metre.
    pub(crate) density: f64,
}

/// The metals, heaviest first. The numbers of atoms per cubic metre follow from mass densities and
/// atomic masses, such as 19.3 g/cm³ and 196.97 u for gold (CRC Handbook of Chemistry and Physics).
pub const METALS: [Metal; 5] = [
    metal("gold", GOLD_CHARGE, 197.0, GOLD_DENSITY),
    metal("platinum", 78.0, 195.0, 6.62e28),
    metal("silver", 47.0, 108.0, 5.86e28),
    metal("copper", 29.0, 64.0, 8.49e28),
    metal("aluminium", 13.0, 27.0, 6.02e28),
];

const fn metal(name: &'static str, charge: f64, mass_number: f64, density: f64) -> Metal {
    Metal {
        name,
        charge,
        mass_number,
        density,
    }
}

impl Metal {
    /// The scattering of α-particles of `energy` joules in a foil of this metal, each by at most
    /// one nucleus. The foil is `thickness` metres thick, which is above 0. With n atoms per cubic
    /// metre and a thickness t, the part of the beam that belongs to one nucleus has the area
    /// 1/(n t), so b goes up to 1/√(πnt).
    pub fn foil(&self, thickness: f64, energy: f64) -> BeamTarget {
        BeamTarget::Coulomb {
            scatterer: Rutherford::new(ALPHA_CHARGE, self.charge, energy),
            half_width: 1.0 / (PI * (self.density * thickness)).sqrt(),
        }
    }
}
