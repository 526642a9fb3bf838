//! The positions at the contact, and the scale of the picture.

use glam::DVec2;
use ratatui::layout::Rect;

use crate::physics::Collision;
use crate::quiz::Ray;
use crate::widgets::picture::View;

/// Half of the picture's shorter side, in radii of the larger disc.
const HALF_HEIGHT: f64 = 3.3;

/// Half of the shorter side of a low picture, in radii of the larger disc. This is smaller than
/// [`HALF_HEIGHT`], because otherwise the discs would be too small to look round.
const LOW_HALF_HEIGHT: f64 = 2.9;

/// The fraction of [`HALF_HEIGHT`] within which a disc counts as inside the picture.
const IN_SIGHT: f64 = 0.92;

/// The number of rows below which a picture counts as low.
const LOW: u16 = 12;

/// The length of the longest ray, in radii of the larger disc.
const RAY: f64 = 2.9;

/// The geometry of a collision as drawn, with the contact point at the origin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HitLayout {
    /// The mapping from the world to the screen.
    pub view: View,
    /// The collision that is drawn.
    pub collision: Collision,
    /// The centres at contact, or at the closest approach.
    pub(crate) centres: [DVec2; 2],
    /// The middle of the picture.
    middle: DVec2,
}

impl HitLayout {
    /// The layout of `collision` in `area`.
    pub(crate) fn new(area: Rect, collision: &Collision) -> Self {
        let largest = collision.striker.radius.max(collision.target.radius);
        let half = if area.height < LOW {
            LOW_HALF_HEIGHT * largest
        } else {
            HALF_HEIGHT * largest
        };
        let columns = f64::from(area.width.min(area.height.saturating_mul(2)).max(1));
        let view = View::new(area, DVec2::ZERO, 2.0 * half / columns);
        Self::of(collision, view, DVec2::ZERO)
    }

    /// The layout of `collision` on paper: just large enough to show the rectangle between two
    /// corners, with the given number of columns for the radius of the larger disc.
    pub(super) fn between(collision: &Collision, [low, high]: [DVec2; 2], columns: f64) -> Self {
        let largest = collision.striker.radius.max(collision.target.radius);
        let size = (high - low) / largest * columns;
        let area = Rect::new(0, 0, size.x.ceil() as u16, (size.y / 2.0).ceil() as u16);
        Self::of(collision, View::fit(area, low, high), (low + high) / 2.0)
    }

    fn of(collision: &Collision, view: View, middle: DVec2) -> Self {
        Self {
            view,
            collision: *collision,
            centres: collision.placed_at_contact().into(),
            middle,
        }
    }

    /// The radius of the larger disc, which is the unit of length in the picture.
    pub(crate) fn unit(&self) -> f64 {
        self.radius(0).max(self.radius(1))
    }

    /// The radius of the striker (0) or the target (1).
    pub(crate) fn radius(&self, body: usize) -> f64 {
        [self.collision.striker, self.collision.target][body].radius
    }

    /// The striker's direction, from which angles are measured.
    pub(crate) fn heading(&self) -> DVec2 {
        self.collision.u1.try_normalize().unwrap_or(DVec2::X)
    }

    /// Whether the other disc is straight ahead of the disc `body`, which moves in the given
    /// direction, when the discs are at `places`.
    pub(super) fn is_towards(&self, places: [DVec2; 2], body: usize, direction: DVec2) -> bool {
        let other = places[1 - body] - places[body];
        let direction = direction.normalize_or_zero();
        other.dot(direction) > 0.0 && other.perp_dot(direction).abs() < self.radius(1 - body)
    }

    /// Whether the other disc is right behind a disc with this initial velocity.
    pub(super) fn runs_ahead(&self, body: usize, v: DVec2) -> bool {
        self.is_towards(self.centres, body, -v)
    }

    /// A disc's ray at an angle in radians, with the sign convention of `turn`, starting from the
    /// disc's position at contact: the ray's direction, the point where the ray leaves the rim, and
    /// the ray's end.
    pub(crate) fn ray(&self, ray: Ray, angle: f64) -> (DVec2, [DVec2; 2]) {
        let centre = self.centres[ray as usize];
        let direction = DVec2::from_angle(turn(ray) * angle).rotate(self.heading());
        let length = self.room(centre, direction).min(RAY * self.unit());
        let ends = [self.radius(ray as usize), length];
        (direction, ends.map(|away| centre + away * direction))
    }

    /// The angle of a ray in this direction, in degrees, with the signs that players use: the
    /// striker's angle is positive on the side away from the coin, the coin's angle on the coin's
    /// side.
    pub(crate) fn angle_deg_of(&self, ray: Ray, direction: DVec2) -> f64 {
        let angle_deg = self.heading().angle_to(direction).to_degrees();
        self.collision.side() * turn(ray) * angle_deg
    }

    /// Half the width and height of the picture, minus a margin for arrow tips and labels. A low
    /// picture has hardly any margin, because otherwise there would be no space for arrows.
    pub(crate) fn half_extent(&self) -> DVec2 {
        let area = self.view.area();
        let margin = if area.height < LOW { 0.5 } else { 1.5 };
        let half =
            |cells: u16, per_cell: f64| (f64::from(cells) / 2.0 - margin).max(0.5) * per_cell;
        DVec2::new(
            half(area.width, self.view.per_column()),
            half(area.height, self.view.per_row()),
        )
    }

    /// The distance from `from` along `direction` to the edge of the picture.
    pub(crate) fn room(&self, from: DVec2, direction: DVec2) -> f64 {
        let half = self.half_extent();
        let along = |from: f64, step: f64, half: f64| {
            if step.abs() < 1e-9 {
                f64::INFINITY
            } else {
                (half.copysign(step) - from) / step
            }
        };
        let from = from - self.middle;
        along(from.x, direction.x, half.x)
            .min(along(from.y, direction.y, half.y))
            .max(0.0)
    }
}

/// How long both discs stay completely within [`IN_SIGHT`] after the contact, both in the
/// laboratory frame and in the centre-of-mass frame.
pub(super) fn time_in_sight(collision: &Collision) -> f64 {
    let largest = collision.striker.radius.max(collision.target.radius);
    let (c1, c2) = collision.placed_at_contact();
    let outcome = collision.outcome();
    let bodies = [
        (c1, collision.striker.radius, outcome.v1),
        (c2, collision.target.radius, outcome.v2),
    ];
    let seen_from = [DVec2::ZERO, collision.centre_of_mass_velocity()];
    let time = |(centre, radius, v): (DVec2, f64, DVec2)| {
        let inside = (IN_SIGHT * HALF_HEIGHT * largest - radius).max(0.0);
        let along = |from: f64, speed: f64| match speed.abs() > 0.0 {
            true => (inside - from * speed.signum()).max(0.0) / speed.abs(),
            false => f64::INFINITY,
        };
        along(centre.x, v.x).min(along(centre.y, v.y))
    };
    seen_from
        .into_iter()
        .flat_map(|drift| bodies.map(|(centre, radius, v)| time((centre, radius, v - drift))))
        .fold(f64::INFINITY, f64::min)
}

/// The sense in which a ray's angle is positive: 1 (anticlockwise) for scattering angles, −1
/// (clockwise) for recoil angles.
fn turn(ray: Ray) -> f64 {
    match ray {
        Ray::Striker => 1.0,
        Ray::Target => -1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::Disc;

    /// For all masses and angles, both discs stay completely within [`IN_SIGHT`], in both frames,
    /// and at the end a disc just reaches this limit in one of the frames.
    #[test]
    fn discs_are_shown_while_they_are_completely_inside_the_picture() {
        let disc = |mass, radius| Disc { mass, radius };
        for alpha_deg in [-70.0_f64, 0.0, 30.0, 60.0, 85.0] {
            for (m2, r2) in [(0.0055, 0.016), (0.015, 0.02), (0.04, 0.02)] {
                let (striker, target) = (disc(0.015, 0.02), disc(m2, r2));
                let alpha = alpha_deg.to_radians();
                let collision = Collision::at_angle(striker, target, DVec2::X * 4.0, alpha);
                let (c1, c2) = collision.placed_at_contact();
                let outcome = collision.outcome();
                let time = time_in_sight(&collision);
                let edge = |(centre, radius, v): (DVec2, f64, DVec2)| {
                    (centre + time * v).abs().max_element() + radius
                };
                let farthest = [DVec2::ZERO, collision.centre_of_mass_velocity()]
                    .into_iter()
                    .flat_map(|drift| {
                        [
                            edge((c1, striker.radius, outcome.v1 - drift)),
                            edge((c2, target.radius, outcome.v2 - drift)),
                        ]
                    })
                    .fold(0.0, f64::max);
                let expected = IN_SIGHT * HALF_HEIGHT * 0.02;
                assert!(
                    (farthest - expected).abs() < 1e-12,
                    "{alpha_deg} {m2}: {farthest}"
                );
            }
        }
    }
}
