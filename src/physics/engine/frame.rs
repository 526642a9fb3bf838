//! What a disc meets on its own: its stop, the cushions, the pockets.

use glam::DVec2;

use super::super::slide::slowed;
use super::super::{Board, Motion};

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
    /// It passes into the next cell of the grid; the slide itself goes on.
    Cell(Side),
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
    /// The side towards which something moves at this speed along x.
    pub(super) fn across(speed: f64) -> Self {
        if speed < 0.0 { Self::Left } else { Self::Right }
    }

    /// The side towards which something moves at this speed along y.
    pub(super) fn upright(speed: f64) -> Self {
        if speed < 0.0 { Self::Bottom } else { Self::Top }
    }

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

/// Seconds from the start of a slide to its end, and what ends it. `slowing` is the
/// part of its speed the disc loses a second, a/v.
///
/// Everything in the way is first timed at the constant first speed: what comes
/// first so comes first with friction too.
pub(super) fn end(board: &Board, radius: f64, start: Motion, slowing: f64) -> (f64, End) {
    let Motion { position, velocity } = start;
    if velocity == DVec2::ZERO {
        return (f64::INFINITY, End::Never);
    }
    if board.side.is_finite() {
        let wall = 0.5 * board.side - radius;
        let (mut time, side) = cushion_ahead(position, velocity, wall);
        let mut end = End::Cushion(side);
        if board.pocket_diameter > 0.0 {
            let hole = 0.5 * board.pocket_diameter;
            let corner = 0.5 * board.side - hole;
            let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
            for (i, (x, y)) in corners.into_iter().enumerate() {
                let centre = DVec2::new(x * corner, y * corner);
                if let Some(falls) = time_to_circle(centre - position, velocity, hole)
                    && falls < time
                {
                    time = falls;
                    end = End::Pocket(i);
                }
            }
        }
        if let Some(time) = slowed(time, slowing) {
            return (time, end);
        }
    }
    if slowing > 0.0 {
        (1.0 / slowing, End::Stop)
    } else {
        (f64::INFINITY, End::Never)
    }
}

/// Time to the first of the lines |x| = `wall` and |y| = `wall` at constant velocity;
/// 0 for a disc that is past it by rounding and still going outward.
fn cushion_ahead(position: DVec2, velocity: DVec2, wall: f64) -> (f64, Side) {
    let to = |place: f64, speed: f64| {
        if speed == 0.0 {
            f64::INFINITY
        } else {
            // The wall ahead lies on the side the disc moves to.
            let place = if speed < 0.0 { -place } else { place };
            ((wall - place) / speed.abs()).max(0.0)
        }
    };
    let (x, y) = (to(position.x, velocity.x), to(position.y, velocity.y));
    if x <= y {
        (x, Side::across(velocity.x))
    } else {
        (y, Side::upright(velocity.y))
    }
}

/// Time until a point at constant velocity comes within `radius` of a centre at
/// `to_centre`; 0 if it is there already, `None` if it passes by.
fn time_to_circle(to_centre: DVec2, velocity: DVec2, radius: f64) -> Option<f64> {
    let outside = to_centre.length_squared() - radius * radius;
    if outside <= 0.0 {
        return Some(0.0);
    }
    let ahead = to_centre.dot(velocity);
    let offset = to_centre.perp_dot(velocity);
    let room = radius * radius * velocity.length_squared() - offset * offset;
    (ahead > 0.0 && room > 0.0).then(|| outside / (ahead + room.sqrt()))
}
