//! How the striker gives a coin its course.

use glam::DVec2;

use super::super::sight::{Sight, WALLS};
use super::{PocketPath, THINNEST};
use crate::game::pieces::Piece;
use crate::physics::Motion;

/// A stroke that gives a coin its course.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct ProposedStroke {
    /// Where the striker stands.
    pub(in super::super) from: DVec2,
    /// The direction in which it is struck.
    pub(in super::super) toward: DVec2,
    /// The speed in m/s that just suffices.
    pub(in super::super) speed: f64,
    /// The largest error of its direction that is forgiven, in radians.
    pub(in super::super) allowance: f64,
}

impl ProposedStroke {
    /// The stroke at `times` the speed that just suffices.
    pub(in super::super) fn motion(&self, times: f64) -> Motion {
        Motion::new(self.from, self.toward * (self.speed * times))
    }
}

/// Where the striker's centre is when it gives the coin its course: the ghost
/// striker that one aims at, touching the coin right behind its line of impact.
pub(in super::super) fn ghost(sight: &Sight, course: &PocketPath) -> Option<DVec2> {
    let coin = sight.coins.get(course.coin)?;
    let ghost = coin.at - course.toward * (sight.striker() + sight.coin());
    sight.is_inside(ghost, sight.striker()).then_some(ghost)
}

/// The straight strokes from these places.
pub(in super::super) fn strikes<'a>(
    sight: &'a Sight,
    course: &'a PocketPath,
    places: &'a [DVec2],
) -> impl Iterator<Item = ProposedStroke> + 'a {
    let ghost = ghost(sight, course);
    ghost.into_iter().flat_map(move |ghost| {
        places.iter().filter_map(move |&from| {
            let toward = (ghost - from).try_normalize()?;
            let cosine = toward.dot(course.toward);
            let clear =
                cosine > THINNEST && sight.is_clear(from, ghost, sight.striker(), &[course.coin]);
            let length = from.distance(ghost);
            clear.then(|| ProposedStroke {
                from,
                toward,
                speed: sight.speed_for(length, arriving(sight, course, cosine)),
                allowance: allowance(sight, course, cosine, length),
            })
        })
    })
}

/// The strokes from these places that come off a cushion first.
pub(in super::super) fn kicks<'a>(
    sight: &'a Sight,
    course: &'a PocketPath,
    places: &'a [DVec2],
) -> impl Iterator<Item = ProposedStroke> + 'a {
    let ghost = ghost(sight, course);
    let ways = ghost.into_iter().flat_map(move |ghost| {
        let places = places.iter();
        places.flat_map(move |&from| WALLS.map(|wall| (ghost, from, wall)))
    });
    ways.filter_map(move |(ghost, from, wall)| {
        let bounce = sight.bounce(from, ghost, wall, sight.striker())?;
        let cosine = bounce.leaving.dot(course.toward);
        let clear = cosine > THINNEST
            && sight.is_clear(from, bounce.at, sight.striker(), &[])
            && sight.is_clear(bounce.at, ghost, sight.striker(), &[course.coin]);
        let (before, after) = (from.distance(bounce.at), bounce.at.distance(ghost));
        let leaving = sight.speed_for(after, arriving(sight, course, cosine));
        clear.then(|| ProposedStroke {
            from,
            toward: bounce.toward,
            speed: sight.speed_for(before, leaving / bounce.kept),
            allowance: allowance(sight, course, cosine, before + after),
        })
    })
}

/// The speed in m/s with which the striker must meet the coin: along the line of
/// impact it passes on a fixed share, and only the cosine of its speed counts.
fn arriving(sight: &Sight, course: &PocketPath, cosine: f64) -> f64 {
    course.speed / (sight.passed_on(Piece::Striker) * cosine)
}

/// The error of the striker's direction that the course forgives: over its way it
/// grows to a shift, which the reach and the cosine turn into an error of the line
/// of impact.
fn allowance(sight: &Sight, course: &PocketPath, cosine: f64, length: f64) -> f64 {
    let reach = sight.striker() + sight.coin();
    course.allowance * reach * cosine / length
}
