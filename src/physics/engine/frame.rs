//! The events of a single disc, which stops, hits a cushion or falls into a pocket.

use glam::DVec2;

use super::super::slide::{slowed, time_to_distance};
use super::super::{Board, Motion};

/// How a slide ends if no other disc interferes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum SlideEnd {
    /// The slide never ends: the disc is at rest, or nothing slows it and nothing is in its path.
    Never,
    Stop,
    /// The disc hits the cushion on this side.
    Cushion(FrameSide),
    /// The disc falls into the pocket in this corner (0 lower left, 1 lower right, 2 upper left, 3
    /// upper right).
    Pocket(usize),
    /// The disc passes into the next cell of the grid; the slide itself continues.
    Cell(FrameSide),
}

/// A side of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FrameSide {
    /// The axis perpendicular to the side: 0 for the left and right sides, 1 for the bottom and top
    /// sides.
    pub(super) axis: usize,
    /// Whether the side is the one with the larger coordinates: right or top.
    pub(super) beyond: bool,
}

impl FrameSide {
    /// The side that is reached first at this velocity, and the time in seconds. It takes `x`
    /// seconds to reach the side ahead along x, and `y` seconds to reach the side ahead along y.
    #[inline]
    pub(super) fn ahead(velocity: DVec2, x: f64, y: f64) -> (f64, Self) {
        let (time, axis) = if x <= y { (x, 0) } else { (y, 1) };
        let beyond = velocity[axis] >= 0.0;
        (time, Self { axis, beyond })
    }

    /// 1 for the side with the larger coordinates, −1 for the other side.
    #[inline]
    pub(super) fn sign(self) -> f64 {
        if self.beyond { 1.0 } else { -1.0 }
    }

    /// The unit vector that points into the cushion.
    #[inline]
    pub(super) fn normal(self) -> DVec2 {
        let mut normal = DVec2::ZERO;
        normal[self.axis] = self.sign();
        normal
    }
}

/// The time in seconds from the start of a slide to its end, and the cause of the end.
/// `relative_deceleration` is the fraction of its initial speed that the disc loses per second,
/// a/v.
///
/// All times are first calculated for a constant speed, because friction does not change the order
/// of events.
#[inline]
pub(super) fn end(
    board: &Board,
    radius: f64,
    start: Motion,
    relative_deceleration: f64,
) -> (f64, SlideEnd) {
    let Motion { position, velocity } = start;
    if velocity == DVec2::ZERO {
        return (f64::INFINITY, SlideEnd::Never);
    }
    if board.side.is_finite() {
        let wall = 0.5 * board.side - radius;
        let (mut time, side) = cushion_ahead(position, velocity, wall);
        let mut end = SlideEnd::Cushion(side);
        let hole = board.pocket_radius();
        for (i, centre) in board.pockets().enumerate() {
            if let Some(falls) = time_to_circle(position - centre, velocity, hole)
                && falls < time
            {
                time = falls;
                end = SlideEnd::Pocket(i);
            }
        }
        if let Some(time) = slowed(time, relative_deceleration) {
            return (time, end);
        }
    }
    if relative_deceleration > 0.0 {
        (1.0 / relative_deceleration, SlideEnd::Stop)
    } else {
        (f64::INFINITY, SlideEnd::Never)
    }
}

/// The time until the disc reaches the first of the lines |x| = `wall` and |y| = `wall` at constant
/// velocity; 0 if rounding has moved the disc past a line and the disc is still moving outwards.
#[inline]
fn cushion_ahead(position: DVec2, velocity: DVec2, wall: f64) -> (f64, FrameSide) {
    let to = |place: f64, speed: f64| {
        if speed == 0.0 {
            f64::INFINITY
        } else {
            // The wall ahead is on the side towards which the disc is moving.
            let place = if speed < 0.0 { -place } else { place };
            ((wall - place) / speed.abs()).max(0.0)
        }
    };
    let (x, y) = (to(position.x, velocity.x), to(position.y, velocity.y));
    FrameSide::ahead(velocity, x, y)
}

/// The time until a point that moves at constant velocity and is now at `place`, relative to a
/// centre, comes within `radius` of that centre; 0 if the point is already within `radius`, `None`
/// if it never is.
#[inline]
fn time_to_circle(place: DVec2, velocity: DVec2, radius: f64) -> Option<f64> {
    let outside = place.length_squared() - radius * radius;
    if outside <= 0.0 {
        return Some(0.0);
    }
    time_to_distance(place, velocity, radius, outside)
}
