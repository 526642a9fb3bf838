//! The table as a player sees it: what lies where, and which ways are clear.

use glam::DVec2;

use crate::game::pieces::{Coin, Piece, PieceSet};
use crate::physics::{Board, RestingTarget};

/// Coins on a board, and the numbers that shots are made of.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sight<'a> {
    pub(super) board: &'a Board,
    pub(super) set: PieceSet,
    pub(super) coins: &'a [Coin],
}

/// A wall of the frame, by the unit vector that points into it.
pub(super) const WALLS: [DVec2; 4] = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];

impl Sight<'_> {
    /// The four pockets, in the order in which the engine numbers the corners.
    pub(super) fn pockets(&self) -> [DVec2; 4] {
        let far = self.board.side / 2.0 - self.pocket_radius();
        [(-far, -far), (far, -far), (-far, far), (far, far)].map(DVec2::from)
    }

    pub(super) fn pocket_radius(&self) -> f64 {
        self.board.pocket_diameter / 2.0
    }

    pub(super) fn coin(&self) -> f64 {
        self.set.coin_radius()
    }

    pub(super) fn striker(&self) -> f64 {
        self.set.striker_radius()
    }

    /// The share of its speed along the line of impact that `piece` gives a coin.
    pub(super) fn passed_on(&self, piece: Piece) -> f64 {
        let pair = RestingTarget {
            m1: self.set.disc(piece).mass,
            m2: self.set.disc(Piece::White).mass,
            restitution: self.board.restitution,
        };
        pair.target_speed(0.0)
    }

    /// The speed in m/s a disc needs to have `left` of it after `distance` metres.
    pub(super) fn speed_for(&self, distance: f64, left: f64) -> f64 {
        (left * left + 2.0 * self.board.deceleration() * distance).sqrt()
    }

    /// Whether a disc of `radius` can go straight from one point to another past
    /// every coin but those that take part.
    pub(super) fn is_clear(&self, from: DVec2, to: DVec2, radius: f64, part: &[usize]) -> bool {
        let way = to - from;
        let length_squared = way.length_squared();
        let reach = radius + self.coin();
        self.coins.iter().enumerate().all(|(i, coin)| {
            let seen = coin.at - from;
            let share = if length_squared > 0.0 {
                (seen.dot(way) / length_squared).clamp(0.0, 1.0)
            } else {
                0.0
            };
            (seen - way * share).length_squared() >= reach * reach || part.contains(&i)
        })
    }

    /// Whether a disc of `radius` has room at a point within the frame.
    pub(super) fn is_inside(&self, at: DVec2, radius: f64) -> bool {
        at.abs().max_element() <= self.board.side / 2.0 - radius
    }

    /// How a disc of `radius` gets from one point to another by way of a wall;
    /// `None` where it cannot.
    ///
    /// The wall takes the part 1 − e of the velocity across it and leaves the rest,
    /// so the disc must aim at the image of its goal that lies 1/e times as far
    /// behind the wall as the goal lies before it.
    pub(super) fn bounce(
        &self,
        from: DVec2,
        to: DVec2,
        wall: DVec2,
        radius: f64,
    ) -> Option<Bounce> {
        let e = self.board.cushion_restitution;
        let line = self.board.side / 2.0 - radius;
        let (before, behind) = (line - from.dot(wall), line - to.dot(wall));
        if e <= 0.0 || before <= 0.0 || behind <= 0.0 {
            return None;
        }
        let toward = (to + wall * (behind + behind / e) - from).try_normalize()?;
        let across = toward.dot(wall);
        let at = from + toward * (before / across);
        let after = toward - wall * ((1.0 + e) * across);
        let kept = after.length();
        Some(Bounce {
            toward,
            at,
            leaving: after / kept,
            kept,
        })
    }
}

/// The way of a disc by a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bounce {
    /// Its direction at the start.
    pub(super) toward: DVec2,
    /// Its centre when it meets the wall.
    pub(super) at: DVec2,
    /// Its direction from there.
    pub(super) leaving: DVec2,
    /// The share of its speed that the wall leaves it.
    pub(super) kept: f64,
}
