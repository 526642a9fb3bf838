//! The surface that discs slide on, its frame and its pockets.

use glam::DVec2;

/// Standard acceleration of free fall in m/s².
pub const G: f64 = 9.80665;

/// A square board with a frame and a pocket in each corner.
///
/// The frame is a full square; each pocket is a circle tangent to both sides of
/// its corner, and a disc falls when its centre comes within the pocket's radius
/// of the pocket's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Board {
    /// Length of the frame's inner side in metres; infinite for an open sheet.
    pub side: f64,
    /// Diameter of a pocket in metres; 0 for none.
    pub pocket_diameter: f64,
    /// Coefficient of sliding friction between disc and board, at least 0.
    pub friction: f64,
    /// Coefficient of restitution between discs, 0 to 1.
    pub restitution: f64,
    /// Coefficient of restitution between disc and cushion, 0 to 1.
    pub cushion_restitution: f64,
}

impl Default for Board {
    /// A tournament board on which collisions of discs are elastic.
    fn default() -> Self {
        Self {
            side: 0.740,
            pocket_diameter: 0.0445,
            friction: 0.12,
            restitution: 1.0,
            cushion_restitution: 0.8,
        }
    }
}

impl Board {
    /// A frictionless sheet without a frame or pockets: the board of the textbooks.
    pub const fn open(restitution: f64) -> Self {
        Self {
            side: f64::INFINITY,
            pocket_diameter: 0.0,
            friction: 0.0,
            restitution,
            cushion_restitution: 1.0,
        }
    }

    /// Radius of a pocket in metres; 0 for none.
    #[inline]
    pub(crate) fn pocket_radius(&self) -> f64 {
        0.5 * self.pocket_diameter
    }

    /// The centres of the pockets: lower left, lower right, upper left, upper right; none if the
    /// board has no pockets.
    #[inline]
    pub fn pockets(&self) -> impl Iterator<Item = DVec2> + use<> {
        let reach = 0.5 * (self.side - self.pocket_diameter);
        let there = self.pocket_diameter > 0.0;
        let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
        let corners = corners.into_iter().filter(move |_| there);
        corners.map(move |(x, y)| reach * DVec2::new(x, y))
    }

    /// Whether a disc whose centre is at `at` falls into a pocket.
    pub(crate) fn has_pocket_at(&self, at: DVec2) -> bool {
        self.pockets()
            .any(|hole| hole.distance(at) <= self.pocket_radius())
    }

    /// Deceleration of a sliding disc in m/s²: a = μ g.
    pub fn deceleration(&self) -> f64 {
        self.friction * G
    }
}
