//! What a disc meets on its own: its stop, the cushions, the pockets.

use glam::DVec2;

use super::super::{Board, Motion, stopping_time, time_to_cover};

/// How a slide ends if no other disc interferes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum End {
    /// Never: nothing slows the disc and nothing stands in its way.
    Never,
    /// Friction stops it.
    Stop,
    /// It meets the cushion on this side.
    Cushion(Side),
    /// It falls into the pocket of this corner (0 lower left, 1 lower right, 2 upper
    /// left, 3 upper right).
    Pocket(usize),
}

/// A side of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Side {
    Left,
    Right,
    Bottom,
    Top,
}

impl Side {
    /// The unit vector into the cushion.
    pub(super) fn normal(self) -> DVec2 {
        match self {
            Self::Left => DVec2::NEG_X,
            Self::Right => DVec2::X,
            Self::Bottom => DVec2::NEG_Y,
            Self::Top => DVec2::Y,
        }
    }
}

/// Seconds from the start of a slide to its end, and what ends it.
pub(super) fn end(board: &Board, radius: f64, start: Motion) -> (f64, End) {
    let Motion { position, velocity } = start;
    let speed = velocity.length();
    if speed == 0.0 {
        return (f64::INFINITY, End::Never);
    }
    let deceleration = board.deceleration();
    let mut first = (stopping_time(speed, deceleration), End::Stop);
    if first.0 == f64::INFINITY {
        first.1 = End::Never;
    }
    if !board.side.is_finite() {
        return first;
    }
    let along = velocity / speed;
    let mut offer = |distance: f64, end: End| {
        if let Some(time) = time_to_cover(distance, speed, deceleration)
            && time < first.0
        {
            first = (time, end);
        }
    };
    let wall = 0.5 * board.side - radius;
    let (distance, side) = nearest_cushion(position, along, wall);
    offer(distance, End::Cushion(side));
    if board.pocket_diameter > 0.0 {
        let hole = 0.5 * board.pocket_diameter;
        let corner = 0.5 * board.side - hole;
        let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
        for (i, (x, y)) in corners.into_iter().enumerate() {
            let to_centre = DVec2::new(x * corner, y * corner) - position;
            if let Some(distance) = distance_to_circle(to_centre, along, hole) {
                offer(distance, End::Pocket(i));
            }
        }
    }
    first
}

/// Distance along the unit vector `along` to the first line |x| = `wall` or |y| =
/// `wall`; 0 for a disc that is past it by rounding and still going outward.
fn nearest_cushion(position: DVec2, along: DVec2, wall: f64) -> (f64, Side) {
    let to = |place: f64, along: f64| {
        if along == 0.0 {
            f64::INFINITY
        } else {
            // The wall ahead lies on the side the disc moves to.
            ((wall - place * along.signum()) / along.abs()).max(0.0)
        }
    };
    let (x, y) = (to(position.x, along.x), to(position.y, along.y));
    if x <= y {
        let side = if along.x < 0.0 {
            Side::Left
        } else {
            Side::Right
        };
        (x, side)
    } else {
        let side = if along.y < 0.0 {
            Side::Bottom
        } else {
            Side::Top
        };
        (y, side)
    }
}

/// Distance along the unit vector `along` until a point comes within `radius` of a
/// centre at `to_centre`; 0 if it is there already, `None` if it passes by.
fn distance_to_circle(to_centre: DVec2, along: DVec2, radius: f64) -> Option<f64> {
    let outside = to_centre.length_squared() - radius * radius;
    if outside <= 0.0 {
        return Some(0.0);
    }
    let ahead = to_centre.dot(along);
    let offset = to_centre.perp_dot(along);
    let room = (radius - offset) * (radius + offset);
    (ahead > 0.0 && room > 0.0).then(|| outside / (ahead + room.sqrt()))
}
