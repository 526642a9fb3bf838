//! The scattering angles that follow from a beam's offsets.

use std::f64::consts::PI;

use crate::physics::beam::Beam;
use crate::physics::rutherford::Rutherford;

/// The target of a beam. It is treated as fixed, as if it were too heavy to move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BeamTarget {
    /// Hard discs or spheres, e = 1. The beam contains exactly the offsets at which a particle
    /// hits: b goes up to r₁ + r₂.
    Hard,
    /// A charge that repels.
    Coulomb {
        /// The law for one particle.
        scatterer: Rutherford,
        /// The largest offset b in the beam, in metres, above 0: a charge has infinite range, so
        /// the beam must be limited.
        half_width: f64,
    },
}

/// A target and the distribution of the offsets over the beam.
///
/// An offset is expressed as *nearness* to the edge of the beam: b as a fraction of the beam's
/// half-width, 0 at the centre, 1 at the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScatteringLaw {
    /// The target.
    pub target: BeamTarget,
    /// Whether the beam is in a plane or in space.
    pub beam: Beam,
}

impl ScatteringLaw {
    /// The scattering angle Θ of a particle, 0 to π radians, for a nearness from 0 to 1: Θ = 2
    /// arccos(b/(r₁+r₂)) for hard targets (the angle of reflection is equal to the angle of
    /// incidence), Θ = 2 atan(d/2b) for a charge.
    pub fn angle(&self, nearness: f64) -> f64 {
        match self.target {
            BeamTarget::Hard => 2.0 * nearness.clamp(-1.0, 1.0).acos(),
            BeamTarget::Coulomb {
                scatterer,
                half_width,
            } => scatterer.scattering_angle(nearness * half_width),
        }
    }

    /// The nearness below which all particles are scattered by more than `angle` radians: 1 for the
    /// whole beam, 0 from 180° on.
    pub(crate) fn nearness(&self, angle: f64) -> f64 {
        if angle >= PI {
            return 0.0;
        }
        match self.target {
            BeamTarget::Hard => (angle.max(0.0) / 2.0).cos(),
            BeamTarget::Coulomb {
                scatterer,
                half_width,
            } => scatterer
                .impact_parameter(angle)
                .map_or(1.0, |b| (b / half_width).min(1.0)),
        }
    }

    /// The fraction of the beam that leaves at `angle` radians into a small solid angle, per
    /// steradian: 1/4π for hard spheres, dσ/dΩ divided by the area of the beam for a charge. `None`
    /// on a board, where there is no solid angle, and at angles that no particle of the beam
    /// reaches.
    pub fn share_per_steradian(&self, angle: f64) -> Option<f64> {
        if self.beam == Beam::Board {
            return None;
        }
        match self.target {
            BeamTarget::Hard => Some(1.0 / (4.0 * PI)),
            BeamTarget::Coulomb {
                scatterer,
                half_width,
            } => {
                let cross_section = scatterer.differential_cross_section(angle)?;
                let inside = scatterer.impact_parameter(angle)? <= half_width;
                inside.then(|| cross_section / (PI * half_width * half_width))
            }
        }
    }

    /// The fraction of the beam that is scattered by more than `angle` radians.
    pub fn share_beyond(&self, angle: f64) -> f64 {
        self.beam.share_within(self.nearness(angle))
    }
}
