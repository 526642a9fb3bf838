//! Many shots at once: the fraction of a uniform beam that is scattered by more than a given angle.
//!
//! Offsets spread evenly over a *line*, as on a board, and evenly over a *disc*, as in space, give
//! different counts under the same scattering law.

use std::f64::consts::PI;

/// The distribution of the offsets of a beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beam {
    /// Evenly over a line: discs on a board.
    Board,
    /// Evenly over a disc: spheres in space.
    Space,
}

impl Beam {
    /// The fraction of a beam of half-width r₁ + r₂ that has offsets below `nearness` · (r₁ + r₂),
    /// for a `nearness` of 0 to 1.
    pub(crate) fn share_within(self, nearness: f64) -> f64 {
        let nearness = nearness.clamp(0.0, 1.0);
        match self {
            Self::Board => nearness,
            Self::Space => nearness * nearness,
        }
    }

    /// For equal masses, a target at rest and e = 1, the fraction of hits that scatter the striker
    /// by more than `theta1` radians: cos θ₁ on a board, cos²θ₁ in space, 0 from 90° on.
    ///
    /// θ₁ = 90° − α, so the largest offset that still deflects by `theta1` is b/(r₁+r₂) = sin α =
    /// cos θ₁.
    pub fn share_beyond(self, theta1: f64) -> f64 {
        if theta1 >= PI / 2.0 {
            return 0.0;
        }
        self.share_within(theta1.max(0.0).cos())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Collision, Disc, Frame};
    use glam::DVec2;

    /// The fraction scattered by more than `cm_angle` in the centre-of-mass frame, where at e = 1
    /// the scattering angle is 180° − 2α for every pair of masses: cos(Θ/2) on a board, cos²(Θ/2)
    /// in space.
    fn cm_share_beyond(beam: Beam, cm_angle: f64) -> f64 {
        beam.share_beyond(cm_angle / 2.0)
    }

    /// The fraction of a beam with evenly spread offsets that is scattered by more than `beyond`,
    /// counted collision by collision.
    fn counted(beam: Beam, scattered: impl Fn(&Collision) -> f64, beyond: f64) -> f64 {
        const SHOTS: u32 = 20_000;
        let disc = Disc::from_g_mm(15.0, 15.9);
        let far = (0..SHOTS).filter(|shot| {
            let even = (f64::from(*shot) + 0.5) / f64::from(SHOTS);
            let nearness = match beam {
                Beam::Board => even,
                Beam::Space => even.sqrt(),
            };
            let offset = nearness * 2.0 * disc.radius;
            scattered(&Collision::at_offset(disc, disc, DVec2::X, offset)) > beyond
        });
        far.count() as f64 / f64::from(SHOTS)
    }

    #[test]
    fn the_formulas_agree_with_counted_shots() {
        let lab = |c: &Collision| c.outcome().theta1.unwrap_or(0.0);
        let cm = |c: &Collision| Frame::CentreOfMass.view(c).outcome().theta1.unwrap_or(0.0);
        for beam in [Beam::Board, Beam::Space] {
            for deg in [5.0_f64, 30.0, 45.0, 60.0, 85.0] {
                let theta = deg.to_radians();
                assert!((beam.share_beyond(theta) - counted(beam, lab, theta)).abs() < 1e-4);
                let turned = 2.0 * theta;
                assert!((cm_share_beyond(beam, turned) - counted(beam, cm, turned)).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn the_closed_forms_give_known_shares() {
        let theta = 60.0_f64.to_radians();
        assert!((Beam::Board.share_beyond(theta) - 0.5).abs() < 1e-15);
        assert!((Beam::Space.share_beyond(theta) - 0.25).abs() < 1e-15);
        for beam in [Beam::Board, Beam::Space] {
            assert!((beam.share_beyond(0.0) - 1.0).abs() < 1e-15);
            assert!(beam.share_beyond(1.6) <= 0.0);
            assert!(cm_share_beyond(beam, PI) < 1e-15);
        }
    }

    #[test]
    fn hard_spheres_scatter_evenly_over_the_sphere() {
        for step in 0..18 {
            let band = |a: f64| cm_share_beyond(Beam::Space, a.to_radians());
            let (from, to) = (f64::from(step) * 10.0, f64::from(step + 1) * 10.0);
            let solid_angle = 2.0 * PI * (from.to_radians().cos() - to.to_radians().cos());
            let share = band(from) - band(to);
            assert!((share - solid_angle / (4.0 * PI)).abs() < 1e-15);
        }
    }
}
