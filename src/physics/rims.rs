//! Friction between the rims of two solid discs, and the spins that it changes.
//!
//! The engine does not use this module: on the board, rims are smooth.

use glam::DVec2;

use super::Disc;
use super::impact::{Contact, Impact, changed, reduced_mass};

/// The rims of two discs before a collision. By default they are smooth, and no disc spins.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rims {
    /// Coefficient of friction μᵣ between the rims, 0 or more; it may be infinite.
    pub friction: f64,
    /// Angular velocities ω₁ and ω₂ in rad/s, positive anticlockwise.
    pub spins: [f64; 2],
}

impl Rims {
    /// Whether the rims are smooth and no disc spins.
    pub(crate) fn is_plain(&self) -> bool {
        *self == Self::default()
    }

    /// Energy of rotation in joules, ½ I ω² of each disc.
    pub(super) fn rotation_energy(discs: [Disc; 2], spins: [f64; 2]) -> f64 {
        let energy = |body: usize| 0.5 * inertia(discs[body]) * spins[body] * spins[body];
        energy(0) + energy(1)
    }
}

/// Moment of inertia of a solid disc about its centre, ½ m r², in kg·m².
pub(super) fn inertia(disc: Disc) -> f64 {
    0.5 * disc.mass * disc.radius * disc.radius
}

/// What friction between the rims does in one contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rub {
    pub(super) v1: DVec2,
    pub(super) v2: DVec2,
    /// Angular velocities after the contact in rad/s, positive anticlockwise.
    pub(super) spins: [f64; 2],
    /// The impulse Jₜ on body 2 along the tangent t (and on body 1 against it), in N·s.
    pub(super) impulse: f64,
    /// Energy lost to friction, in joules.
    pub(super) energy_lost: f64,
}

/// The speed in m/s of rim 1 relative to rim 2 along t at the point of contact:
/// uₛ = (u₁ − u₂)·t + ω₁r₁ + ω₂r₂. Rounding noise counts as 0.
pub(crate) fn slip(discs: [Disc; 2], relative: DVec2, spins: [f64; 2], normal: DVec2) -> f64 {
    let rims = [0, 1].map(|body| discs[body].radius * spins[body]);
    let slip = relative.dot(normal.perp()) + rims[0] + rims[1];
    let noise = 16.0 * f64::EPSILON * (relative.length() + rims[0].abs() + rims[1].abs());
    if slip.abs() <= noise { 0.0 } else { slip }
}

impl Contact {
    /// Adds friction to the `impact` of smooth rims: Jₜ stops the slip if Coulomb's law
    /// |Jₜ| ≤ μᵣJₙ allows that; there is no tangential rebound. For solid discs, Jₜ reduces the
    /// slip by 3 Jₜ/μ, with the reduced mass μ, because it also turns the discs. `None` for smooth
    /// rims.
    pub(super) fn rub(&self, impact: &Impact, discs: [Disc; 2], rims: Rims) -> Option<Rub> {
        if rims.friction <= 0.0 {
            return None;
        }
        let slip = slip(discs, self.u1 - self.u2, rims.spins, self.normal);
        let mu = reduced_mass(self.m1, self.m2);
        let size = (rims.friction * impact.impulse).min(mu * slip.abs() / 3.0);
        let impulse = size.copysign(slip);
        let tangent = self.normal.perp();
        // ω = ω before − r Jₜ/(½ m r²), the same sense for both: the impulses are opposite, and so
        // are the sides of the centres on which they act.
        let spun = |body: usize| {
            let Disc { mass, radius } = discs[body];
            rims.spins[body] - 2.0 * impulse / (mass * radius)
        };
        Some(Rub {
            v1: changed(impact.v1, -impulse / self.m1, tangent),
            v2: changed(impact.v2, impulse / self.m2, tangent),
            spins: [spun(0), spun(1)],
            impulse,
            energy_lost: size * (slip.abs() - 1.5 * size / mu),
        })
    }
}
