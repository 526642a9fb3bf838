//! How a coin gets to a pocket.

use glam::DVec2;

use super::super::sight::{Sight, WALLS};
use super::THINNEST;
use crate::game::pieces::Piece;

/// What a coin must be given to end in a pocket, or to drive one there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct PocketPath {
    /// The coin, by its place among the coins.
    pub(in super::super) coin: usize,
    /// The direction in which it must leave.
    pub(in super::super) toward: DVec2,
    /// The speed in m/s with which it just gets there.
    pub(in super::super) speed: f64,
    /// The largest error of its direction that is forgiven, in radians.
    pub(in super::super) allowance: f64,
}

/// The straight ways of a coin into the pockets.
pub(in super::super) fn straight<'a>(
    sight: &'a Sight,
    coin: usize,
) -> impl Iterator<Item = PocketPath> + 'a {
    let from = sight.coins.get(coin).map(|coin| coin.at);
    let ways = from.map(|from| sight.pockets().map(|pocket| (from, pocket)));
    ways.into_iter()
        .flatten()
        .filter_map(move |(from, pocket)| {
            let length = from.distance(pocket);
            let toward = (pocket - from).try_normalize()?;
            let clear = sight.is_clear(from, pocket, sight.coin(), &[coin]);
            clear.then(|| PocketPath {
                coin,
                toward,
                speed: sight.speed_for((length - sight.pocket_radius()).max(0.0), 0.0),
                allowance: sight.pocket_radius() / length,
            })
        })
}

/// The ways of a coin into a pocket by way of the wall opposite to it.
pub(in super::super) fn off_a_cushion<'a>(
    sight: &'a Sight,
    coin: usize,
) -> impl Iterator<Item = PocketPath> + 'a {
    let from = sight.coins.get(coin).map(|coin| coin.at);
    let ways = from.into_iter().flat_map(move |from| {
        WALLS.into_iter().flat_map(move |wall| {
            let pockets = sight.pockets().into_iter();
            pockets
                .filter(move |pocket| pocket.dot(wall) < 0.0)
                .map(move |pocket| (from, wall, pocket))
        })
    });
    ways.filter_map(move |(from, wall, pocket)| {
        let bounce = sight.bounce(from, pocket, wall, sight.coin())?;
        let (before, after) = (from.distance(bounce.at), bounce.at.distance(pocket));
        let clear = sight.is_clear(from, bounce.at, sight.coin(), &[coin])
            && sight.is_clear(bounce.at, pocket, sight.coin(), &[coin]);
        let leaving = sight.speed_for((after - sight.pocket_radius()).max(0.0), 0.0);
        clear.then(|| PocketPath {
            coin,
            toward: bounce.toward,
            speed: sight.speed_for(before, leaving / bounce.kept),
            allowance: sight.pocket_radius() / (before + after),
        })
    })
}

/// How other coins can give a coin its course.
pub(in super::super) fn combinations<'a>(
    sight: &'a Sight,
    course: &'a PocketPath,
) -> impl Iterator<Item = PocketPath> + 'a {
    let target = sight.coins.get(course.coin).map(|coin| coin.at);
    let drivers = target.into_iter().flat_map(move |target| {
        let coins = sight.coins.iter().enumerate();
        coins.map(move |(i, driver)| (target, i, driver.at))
    });
    drivers.filter_map(move |(target, i, from)| {
        if i == course.coin {
            return None;
        }
        let reach = 2.0 * sight.coin();
        let ghost = target - course.toward * reach;
        let length = from.distance(ghost);
        let toward = (ghost - from).try_normalize()?;
        let cosine = toward.dot(course.toward);
        let reachable = cosine > THINNEST
            && sight.is_inside(ghost, sight.coin())
            && sight.is_clear(from, ghost, sight.coin(), &[i, course.coin]);
        let arriving = course.speed / (sight.passed_on(Piece::White) * cosine);
        reachable.then(|| PocketPath {
            coin: i,
            toward,
            speed: sight.speed_for(length, arriving),
            allowance: course.allowance * (reach * cosine / length).min(1.0),
        })
    })
}
