//! The settings of the foil: beam, target and counting.

use crate::beams::{BeamTarget, CountedFor, METALS, Metal, ScatteringLaw};
use crate::physics::beam::Beam;
use crate::physics::rutherford::{ALPHA_CHARGE, MEV, Rutherford};

/// The target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Obstacle {
    /// A hard disc, or a hard sphere.
    Hard,
    /// A nucleus, which repels by its charge.
    Nucleus,
}

/// The settings, in the units shown on the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FoilSetup {
    /// The target.
    pub obstacle: Obstacle,
    /// The distribution of a beam's offsets.
    pub beam: Beam,
    /// The index of the nucleus in [`METALS`].
    pub metal: usize,
    /// Energy of the α-particles in MeV.
    pub energy_mev: f64,
    /// Thickness of the foil in µm.
    pub thickness_um: f64,
    /// Offset from the centre of a hard target, as a fraction of the touching distance.
    pub offset_share: f64,
    /// Offset from a nucleus in fm.
    pub offset_fm: f64,
    /// Particles in a beam, as a power of ten.
    pub particles_exponent: u32,
    /// The unit of the counts of [`Beam::Space`].
    pub counted_for: CountedFor,
}

impl Default for FoilSetup {
    /// α-particles from radium C on the gold foil of 1913.
    fn default() -> Self {
        Self {
            obstacle: Obstacle::Nucleus,
            beam: Beam::Space,
            metal: 0,
            energy_mev: 7.69,
            thickness_um: 0.21,
            offset_share: 0.5,
            offset_fm: 20.0,
            particles_exponent: 6,
            counted_for: CountedFor::default(),
        }
    }
}

impl FoilSetup {
    pub(crate) fn metal(&self) -> Metal {
        METALS[self.metal % METALS.len()]
    }

    /// The law for the deflection of one particle by the nucleus.
    pub(crate) fn scatterer(&self) -> Rutherford {
        Rutherford::new(ALPHA_CHARGE, self.metal().charge, self.energy_mev * MEV)
    }

    /// The scattering law for a beam.
    pub(crate) fn law(&self) -> ScatteringLaw {
        let (thickness, energy) = (self.thickness_um * 1e-6, self.energy_mev * MEV);
        ScatteringLaw {
            target: match self.obstacle {
                Obstacle::Hard => BeamTarget::Hard,
                Obstacle::Nucleus => self.metal().foil(thickness, energy),
            },
            beam: self.beam,
        }
    }

    /// The unit of the counts; `None` on a board, where there is no solid angle.
    pub(crate) fn counted_for(&self) -> Option<CountedFor> {
        (self.beam == Beam::Space).then_some(self.counted_for)
    }

    pub(crate) fn particles(&self) -> u64 {
        10_u64.saturating_pow(self.particles_exponent)
    }

    /// The name of the target.
    pub(crate) fn obstacle_name(&self) -> &'static str {
        match (self.obstacle, self.beam) {
            (Obstacle::Hard, Beam::Board) => "hard disc",
            (Obstacle::Hard, Beam::Space) => "hard sphere",
            (Obstacle::Nucleus, _) => "nucleus",
        }
    }
}
