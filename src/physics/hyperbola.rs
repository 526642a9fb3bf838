//! The path of a charge past a fixed charge that repels it.

use std::f64::consts::PI;

use glam::DVec2;

use super::rutherford::Rutherford;

/// The exact path of one particle: the branch of a hyperbola that curves away from the fixed charge
/// at the origin. The particle comes in along +x.
///
/// In polar coordinates about the charge, with φ measured from the apse (the direction of closest
/// approach), r = l / (ε cos φ − 1), where ε = 1/sin(Θ/2) and l = 2b²/d. See L. D. Landau and E. M.
/// Lifshitz, *Mechanics*, § 15.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hyperbola {
    impact_parameter: f64,
    /// Scattering angle Θ, 0 to π radians.
    pub angle: f64,
    /// Distance r_min of the nearest point, in metres.
    closest_approach: f64,
}

impl Rutherford {
    /// The path at impact parameter b metres, where b is positive if the charge is to the
    /// right of the incoming particle, which is then deflected to the left.
    pub fn path(&self, impact_parameter: f64) -> Hyperbola {
        let angle = self.scattering_angle(impact_parameter.abs());
        Hyperbola {
            impact_parameter,
            angle,
            closest_approach: self
                .closest_approach(angle)
                .unwrap_or(impact_parameter.abs()),
        }
    }
}

impl Hyperbola {
    /// The point nearest to the charge. In a head-on approach it is the turning point.
    pub(crate) fn nearest(&self) -> DVec2 {
        self.mirrored(DVec2::from_angle(self.apse()) * self.closest_approach)
    }

    /// Direction of the apse for b ≥ 0: it bisects the angle between the incoming and outgoing
    /// parts of the path.
    fn apse(&self) -> f64 {
        (PI + self.angle) / 2.0
    }

    /// A point of the path for |b|, mirrored if b is negative.
    fn mirrored(&self, point: DVec2) -> DVec2 {
        if self.impact_parameter < 0.0 {
            DVec2::new(point.x, -point.y)
        } else {
            point
        }
    }

    /// The path from a distance of `reach` metres on the way in to the same distance on the way
    /// out, as `pieces` (2 or more) straight segments, which are shortest where the path bends
    /// most; empty if the path never comes within `reach`.
    pub(crate) fn points(&self, reach: f64, pieces: u32) -> Vec<DVec2> {
        if !(reach > self.closest_approach && reach.is_finite()) {
            return Vec::new();
        }
        let pieces = pieces.max(2);
        // In terms of the hyperbola's parameter s: r = r_min + a ε (cosh s − 1), where the
        // semi-axis a = d/2. With the apse along +X, X = a (ε + cosh s) and Y = ±a √(ε² − 1) sinh
        // s; both remain valid head-on, where ε = 1 and Y = 0.
        let eccentricity = 1.0 / (self.angle / 2.0).sin();
        let axis = self.closest_approach / (1.0 + eccentricity);
        let cosh_end = 1.0 + (reach - self.closest_approach) / (axis * eccentricity);
        let end = cosh_end.acosh();
        let across = axis
            * ((eccentricity - 1.0) * (eccentricity + 1.0))
                .max(0.0)
                .sqrt();
        let apse = DVec2::from_angle(self.apse());
        (0..=pieces)
            .map(|i| {
                let s = end * (2.0 * f64::from(i) / f64::from(pieces) - 1.0);
                // The path starts on the incoming side, which is anticlockwise of the apse.
                let local = DVec2::new(axis * (eccentricity + s.cosh()), -across * s.sinh());
                self.mirrored(apse.rotate(local))
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const REACH: f64 = 1e-11;

    fn paths() -> impl Iterator<Item = (f64, Hyperbola)> {
        let gold = Rutherford::radium_c_on_gold();
        [0.0, 0.01, 1.0, 5.0, 14.8, 30.0, 100.0, 400.0]
            .into_iter()
            .flat_map(|b| [b, -b])
            .map(move |b| (b * 1e-15, gold.path(b * 1e-15)))
    }

    /// The outgoing asymptote is at Θ = 2 atan(d/2b), on the side away from the charge.
    #[test]
    fn the_particle_leaves_at_the_scattering_angle() {
        let gold = Rutherford::radium_c_on_gold();
        for (b, path) in paths() {
            // From very far away the last piece points along the asymptote.
            let points = path.points(1e-3, 400);
            let [.., before, last] = points[..] else {
                panic!("no path at {b}");
            };
            let direction = (last - before).normalize();
            let turned = direction.to_angle().abs();
            assert!(
                (turned - gold.scattering_angle(b.abs())).abs() < 1e-6,
                "{b}"
            );
            assert!(b == 0.0 || direction.y.signum() == b.signum());
            let first = (points[1] - points[0]).normalize();
            assert!((first - DVec2::X).length() < 1e-6, "{b}");
            // The particle came in along y = b.
            assert!((points[0].y - b).abs() < 1e-6 * points[0].x.abs());
        }
    }

    #[test]
    fn the_nearest_point_is_the_closest_approach() {
        for (b, path) in paths() {
            let points = path.points(REACH, 1000);
            let nearest = points.iter().map(|p| p.length()).fold(REACH, f64::min);
            assert!((nearest / path.closest_approach - 1.0).abs() < 1e-12, "{b}");
            assert!((points[500] - path.nearest()).length() < 1e-12 * nearest);
            let d = Rutherford::radium_c_on_gold().head_on_approach;
            assert!(nearest > d * (1.0 - 1e-12));
        }
    }

    /// Energy conservation gives 1 = v² + d/r, and angular momentum b = r v sin ψ, where ψ follows
    /// from the slope of the path. So the speed from one equation must satisfy the other.
    #[test]
    fn energy_and_angular_momentum_are_conserved_along_the_path() {
        let d = Rutherford::radium_c_on_gold().head_on_approach;
        for (b, path) in paths() {
            let points = path.points(REACH, 20_000);
            // In a head-on approach the path has no direction at the turning point.
            for i in [400, 3000, 7000, 9990, 10_005, 13_000, 19_000] {
                let here = points[i];
                let along = (points[i + 1] - points[i - 1]).normalize();
                let speed = (1.0 - d / here.length()).max(0.0).sqrt();
                let momentum = -here.perp_dot(along) * speed;
                assert!((momentum - b).abs() < 2e-6 * (b.abs() + d), "{b} at {i}");
            }
        }
    }

    #[test]
    fn the_path_begins_and_ends_at_the_reach() {
        for (b, path) in paths() {
            let points = path.points(REACH, 60);
            for end in [points[0], points[60]] {
                assert!((end.length() / REACH - 1.0).abs() < 1e-9, "{b}");
            }
        }
        let (_, far) = paths().last().unwrap();
        assert!(far.points(1e-14, 60).is_empty() && far.points(f64::NAN, 60).is_empty());
    }
}
