//! The table as a player sees it: the positions of the coins, and which paths are clear.

use glam::DVec2;

use crate::game::{Coin, Game, Piece, PieceSet};
use crate::physics::{Board, RestingTarget};

/// Coins on a board, and the numbers that shots are computed from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sight<'a> {
    pub(super) board: Board,
    pub(super) set: PieceSet,
    pub(super) coins: &'a [Coin],
}

/// A factor that exceeds 1 by more than the relative rounding error of distances and tolerances.
pub(super) const ROUNDING: f64 = 1.0 + 1e-9;

/// The walls of the frame, each given by the unit vector that points outwards, towards the wall.
pub(super) const WALLS: [DVec2; 4] = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];

impl<'a> Sight<'a> {
    pub(super) fn of(game: &'a Game) -> Self {
        Self {
            board: game.board(),
            set: game.setup().set,
            coins: game.coins(),
        }
    }

    pub(super) fn coin(&self) -> f64 {
        self.set.coin_radius()
    }

    pub(super) fn striker(&self) -> f64 {
        self.set.striker_radius()
    }

    /// The speed that `piece` gives to a coin, as a multiple of the piece's own speed along the
    /// line of impact.
    pub(super) fn passed_on(&self, piece: Piece) -> f64 {
        let pair = RestingTarget {
            m1: self.set.disc(piece).mass,
            m2: self.set.disc(Piece::White).mass,
            restitution: self.board.restitution,
        };
        pair.target_speed(0.0)
    }

    /// The initial speed in m/s of a disc that still has the speed `left` after `distance` metres.
    fn speed_for(&self, distance: f64, left: f64) -> f64 {
        (left * left + 2.0 * self.board.deceleration() * distance).sqrt()
    }

    /// Whether a disc of `radius` can go straight from one point to another past all coins that do
    /// not take part.
    fn is_clear(&self, from: DVec2, to: DVec2, radius: f64, part: [Option<usize>; 2]) -> bool {
        let way = to - from;
        let length_squared = way.length_squared();
        let reach = radius + self.coin();
        // Most coins are clear of the whole line by more than the rounding error.
        let off = ROUNDING * (reach * reach * length_squared);
        self.coins.iter().enumerate().all(|(i, coin)| {
            let seen = coin.at - from;
            let across = way.perp_dot(seen);
            if across * across > off {
                return true;
            }
            let share = if length_squared > 0.0 {
                (seen.dot(way) / length_squared).clamp(0.0, 1.0)
            } else {
                0.0
            };
            (seen - way * share).length_squared() >= reach * reach || part.contains(&Some(i))
        })
    }

    /// Whether a disc of `radius` at a point is wholly inside the frame.
    pub(super) fn is_inside(&self, at: DVec2, radius: f64) -> bool {
        at.abs().max_element() <= self.board.side / 2.0 - radius
    }

    /// The path of a disc of `radius` from one point to another off a cushion; `None` if there is
    /// none.
    ///
    /// A cushion reverses the perpendicular velocity component and multiplies it by e, so the disc
    /// must aim at the image of its goal, which is 1/e times as far behind the cushion as the goal
    /// is in front of it.
    pub(super) fn bounce(&self, from: DVec2, to: DVec2, wall: DVec2, radius: f64) -> Option<Way> {
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
        Some(Way {
            from,
            to,
            toward,
            arriving: after / kept,
            wall: Some((at, kept)),
        })
    }
}

/// A path of a disc from one point to another, straight or off a cushion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Way {
    pub(super) from: DVec2,
    pub(super) to: DVec2,
    /// The direction at the start of the path.
    pub(super) toward: DVec2,
    /// The direction at the end of the path.
    pub(super) arriving: DVec2,
    /// Where the disc's centre is when it hits a cushion, and the fraction of its speed that
    /// remains.
    wall: Option<(DVec2, f64)>,
}

impl Way {
    /// The straight path; `None` if its length is 0.
    pub(super) fn straight(from: DVec2, to: DVec2) -> Option<Self> {
        let toward = (to - from).try_normalize()?;
        Some(Self {
            from,
            to,
            toward,
            arriving: toward,
            wall: None,
        })
    }

    /// The distances in metres to the cushion, and from there to the end.
    fn legs(&self) -> (f64, f64) {
        let turn = self.wall.map_or(self.from, |(at, _)| at);
        (self.from.distance(turn), turn.distance(self.to))
    }

    pub(super) fn length(&self) -> f64 {
        let (before, after) = self.legs();
        before + after
    }

    /// The initial speed in m/s of a disc that still has the speed `left` when it is `short` metres
    /// from the end.
    pub(super) fn speed(&self, sight: &Sight, short: f64, left: f64) -> f64 {
        let (before, after) = self.legs();
        let leaving = sight.speed_for((after - short).max(0.0), left);
        self.wall
            .map_or(leaving, |(_, kept)| sight.speed_for(before, leaving / kept))
    }

    /// Whether a disc of `radius` can take this path past all coins except those in `part`: the
    /// disc itself, if it is a coin, and the coin at the end of the path.
    pub(super) fn is_clear(&self, sight: &Sight, radius: f64, part: [Option<usize>; 2]) -> bool {
        let turn = self.wall.map(|(at, _)| at);
        turn.is_none_or(|at| sight.is_clear(self.from, at, radius, [part[0], None]))
            && sight.is_clear(turn.unwrap_or(self.from), self.to, radius, part)
    }
}
