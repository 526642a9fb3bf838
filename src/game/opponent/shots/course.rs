//! The paths along which a coin reaches a pocket.

use glam::DVec2;

use super::super::sight::{Sight, WALLS, Way};
use super::{THINNEST, Unchecked};
use crate::game::pieces::Piece;

/// The motion that a coin needs to reach a pocket, or to drive another coin there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct PocketPath {
    /// The index of the coin.
    pub(in super::super) coin: usize,
    /// The direction in which the coin must move.
    pub(in super::super) toward: DVec2,
    /// The minimum speed that the coin requires, in m/s.
    pub(in super::super) speed: f64,
    /// The largest tolerable error in the coin's direction, in radians.
    pub(in super::super) allowance: f64,
}

/// The unblocked straight paths of a coin into pockets.
pub(in super::super) fn straight(sight: &Sight, coin: usize) -> impl Iterator<Item = PocketPath> {
    to_the_pockets(sight, coin).filter_map(|course| course.if_clear(sight))
}

/// The straight paths of a coin to all pockets.
pub(in super::super) fn to_the_pockets(
    sight: &Sight,
    coin: usize,
) -> impl Iterator<Item = Unchecked<PocketPath>> {
    let from = sight.coins.get(coin).map(|coin| coin.at);
    let pockets = sight.board.pockets();
    let ways = pockets.filter_map(move |pocket| Way::straight(from?, pocket));
    ways.map(move |way| into_pocket(sight, coin, way))
}

/// The unblocked paths of a coin into pockets, each off one of the two cushions opposite the
/// pocket.
pub(in super::super) fn off_a_cushion(
    sight: &Sight,
    coin: usize,
) -> impl Iterator<Item = PocketPath> {
    let from = sight.coins.get(coin).map(|coin| coin.at);
    let ways = WALLS.into_iter().flat_map(move |wall| {
        let pockets = sight.board.pockets();
        let opposite = pockets.filter(move |pocket| pocket.dot(wall) < 0.0);
        opposite.filter_map(move |pocket| sight.bounce(from?, pocket, wall, sight.coin()))
    });
    ways.filter_map(move |way| into_pocket(sight, coin, way).if_clear(sight))
}

/// The course of a coin to the middle of a pocket.
fn into_pocket(sight: &Sight, coin: usize, way: Way) -> Unchecked<PocketPath> {
    let hole = sight.board.pocket_radius();
    let link = PocketPath {
        coin,
        toward: way.toward,
        speed: way.speed(sight, hole, 0.0),
        allowance: hole / way.length(),
    };
    Unchecked {
        link,
        way,
        radius: sight.coin(),
        part: [Some(coin), None],
    }
}

/// The courses on which other coins drive a coin along `course`.
pub(in super::super) fn combinations(
    sight: &Sight,
    course: &PocketPath,
) -> impl Iterator<Item = PocketPath> {
    let reach = 2.0 * sight.coin();
    let target = sight.coins.get(course.coin);
    let ghost = target.map(|target| target.at - course.toward * reach);
    let drivers = sight.coins.iter().enumerate();
    drivers.filter_map(move |(i, driver)| {
        let way = Way::straight(driver.at, ghost?)?;
        let cosine = way.arriving.dot(course.toward);
        let reachable = i != course.coin
            && cosine > THINNEST
            && sight.is_inside(way.to, sight.coin())
            && way.is_clear(sight, sight.coin(), [Some(i), Some(course.coin)]);
        let arriving = course.speed / (sight.passed_on(Piece::White) * cosine);
        reachable.then(|| PocketPath {
            coin: i,
            toward: way.toward,
            speed: way.speed(sight, 0.0, arriving),
            allowance: course.allowance * (reach * cosine / way.length()).min(1.0),
        })
    })
}
