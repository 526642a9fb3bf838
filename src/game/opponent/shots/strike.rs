//! The strokes that send a coin along its course.

use glam::DVec2;

use super::super::sight::{Sight, WALLS, Way};
use super::{PocketPath, THINNEST, Unchecked};
use crate::game::pieces::Piece;
use crate::physics::Motion;

/// A stroke that gives a coin its course.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct ProposedStroke {
    /// The striker's position.
    pub(in super::super) from: DVec2,
    /// The direction of the stroke.
    pub(in super::super) toward: DVec2,
    /// The minimum speed that the striker requires, in m/s.
    pub(in super::super) speed: f64,
    /// The largest tolerable error in the stroke's direction, in radians.
    pub(in super::super) allowance: f64,
}

impl ProposedStroke {
    /// The stroke at `times` the minimum speed.
    pub(in super::super) fn motion(&self, times: f64) -> Motion {
        Motion::new(self.from, self.toward * (self.speed * times))
    }
}

/// The position of the striker's centre at the hit that gives the coin its course: the ghost
/// striker to aim at, which touches the coin on its line of impact.
pub(in super::super) fn ghost(sight: &Sight, course: &PocketPath) -> Option<DVec2> {
    let coin = sight.coins.get(course.coin)?;
    let ghost = coin.at - course.toward * (sight.striker() + sight.coin());
    sight.is_inside(ghost, sight.striker()).then_some(ghost)
}

/// The straight strokes from these positions.
pub(in super::super) fn strikes(
    sight: &Sight,
    course: &PocketPath,
    places: &[DVec2],
) -> impl Iterator<Item = Unchecked<ProposedStroke>> {
    let ghost = ghost(sight, course);
    let places = places.iter();
    places.filter_map(move |&from| strike(sight, course, from, ghost?))
}

/// The straight stroke from a position that gives a coin its course by way of `ghost`, if there is
/// one.
pub(in super::super) fn strike(
    sight: &Sight,
    course: &PocketPath,
    from: DVec2,
    ghost: DVec2,
) -> Option<Unchecked<ProposedStroke>> {
    stroke(sight, course, Way::straight(from, ghost)?)
}

/// The tolerance of the straight stroke, apart from rounding, computed without a square root
/// because most strokes are discarded for their tolerance alone.
pub(in super::super) fn allowance(
    sight: &Sight,
    course: &PocketPath,
    from: DVec2,
    ghost: DVec2,
) -> f64 {
    let way = ghost - from;
    most_allowed(sight, course, way.length_squared() / way.dot(course.toward))
}

/// The largest tolerance of a straight stroke that gives a coin its course from this distance: that
/// of a full hit.
pub(in super::super) fn most_allowed(sight: &Sight, course: &PocketPath, away: f64) -> f64 {
    course.allowance * (sight.striker() + sight.coin()) / away
}

/// The strokes off a cushion from these positions.
pub(in super::super) fn kicks(
    sight: &Sight,
    course: &PocketPath,
    places: &[DVec2],
) -> impl Iterator<Item = Unchecked<ProposedStroke>> {
    let ghost = ghost(sight, course);
    let places = places.iter();
    let walls = places.flat_map(|&from| WALLS.map(|wall| (from, wall)));
    walls.filter_map(move |(from, wall)| {
        let way = sight.bounce(from, ghost?, wall, sight.striker())?;
        stroke(sight, course, way)
    })
}

/// The stroke along this path that gives a coin its course at the end, if there is one.
///
/// The coin's speed is a fixed multiple of the striker's velocity component along the line of
/// impact. An error in the striker's direction becomes a shift at the end of its path; divided by
/// r₁ + r₂ and the cosine of the impact angle, this shift gives the error in the line of impact.
fn stroke(sight: &Sight, course: &PocketPath, way: Way) -> Option<Unchecked<ProposedStroke>> {
    let cosine = way.arriving.dot(course.toward);
    if cosine <= THINNEST || cosine.is_nan() {
        return None;
    }
    let arriving = course.speed / (sight.passed_on(Piece::Striker) * cosine);
    let reach = sight.striker() + sight.coin();
    let link = ProposedStroke {
        from: way.from,
        toward: way.toward,
        speed: way.speed(sight, 0.0, arriving),
        allowance: course.allowance * reach * cosine / way.length(),
    };
    Some(Unchecked {
        link,
        way,
        radius: sight.striker(),
        part: [None, Some(course.coin)],
    })
}
