//! Where the striker may be placed.
//!
//! The striker must touch both base lines of its side. It must be clear of the base circles, or
//! cover one of them fully. It must not cover part of a base circle ("cutting the moon") or touch a
//! coin.

use glam::DVec2;
use thiserror::Error;

use super::pieces::{
    BASE_CIRCLE_RADIUS, BASE_LINE_FROM_FRAME, BASE_LINE_GAP, BASE_LINE_LENGTH, Coin, GAP, Piece,
    PieceSet,
};
use super::seat::Seat;
use crate::physics::Board;

/// The tolerance for rounding when a position is checked, in metres: the overlap of discs that the
/// engine allows.
pub(super) const SLACK: f64 = 1e-10;

/// Why a position of the striker is not legal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum Misplaced {
    /// The striker does not touch both base lines.
    #[error("the striker must touch both of your base lines")]
    OffTheBaseLines,
    /// The striker covers part of a base circle.
    #[error("the striker must cover a base circle fully or not touch it")]
    CutsBaseCircle,
    /// The striker would touch a coin.
    #[error("the striker must not touch the {0}")]
    OnACoin(Piece),
    /// The striker would overlap the frame or be beyond it.
    #[error("the striker must be inside the frame")]
    OutsideTheFrame,
    /// The striker would fall straight into a pocket.
    #[error("the striker must not be over a pocket")]
    OverAPocket,
}

/// A side's base lines, with everything that restricts the striker there.
#[derive(Debug, Clone, Copy)]
pub struct BaseLines<'a> {
    set: PieceSet,
    seat: Seat,
    coins: &'a [Coin],
}

/// The striker's position between the base lines, as seen on the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stand {
    /// The striker is in the middle, to the millimetre.
    Middle,
    /// The striker is on a base circle, such as the "left" or the "upper" one.
    Circle(&'static str),
    /// The striker is beside the middle: the distance in millimetres, and the direction, such as
    /// "left" or "above".
    Beside(f64, &'static str),
}

impl Stand {
    /// A short description: "12 mm left".
    pub(crate) fn words(self) -> String {
        match self {
            Self::Middle => "the middle".into(),
            Self::Circle(side) => format!("the {side} circle"),
            Self::Beside(mm, side) => format!("{mm:.0} mm {side}"),
        }
    }

    /// The description as a clause: "place the striker 12 mm left of the middle".
    pub(crate) fn phrase(self) -> String {
        match self {
            Self::Middle => "in the middle".into(),
            Self::Circle(side) => format!("on the {side} circle"),
            Self::Beside(mm, side @ ("left" | "right")) => {
                format!("{mm:.0} mm {side} of the middle")
            }
            Self::Beside(mm, side) => format!("{mm:.0} mm {side} the middle"),
        }
    }
}

impl<'a> BaseLines<'a> {
    /// The base lines of the player at `seat`, with `coins` on the board.
    pub(crate) const fn new(set: PieceSet, seat: Seat, coins: &'a [Coin]) -> Self {
        Self { set, seat, coins }
    }

    /// The position `along` metres to the player's right of the middle, halfway between the base
    /// lines. The position may be illegal.
    pub fn at(&self, along: f64) -> DVec2 {
        self.seat.turn(DVec2::new(along, self.middle()))
    }

    /// The y coordinate, as seen by the player, of the middle between the base lines, in metres.
    pub(super) fn middle(&self) -> f64 {
        let from_frame = BASE_LINE_FROM_FRAME + BASE_LINE_GAP / 2.0;
        -Board::default().side / 2.0 + from_frame
    }

    /// How far to the player's right of the middle `at` is, in metres.
    pub fn along(&self, at: DVec2) -> f64 {
        self.seat.turn_back(at).x
    }

    /// Distance from the middle of the base lines to the centre of a base
    /// circle, in metres.
    pub(crate) const fn base_circle_along() -> f64 {
        BASE_LINE_LENGTH / 2.0 - BASE_CIRCLE_RADIUS
    }

    /// The position of a striker at `at`, as seen on the screen.
    pub(crate) fn stand(&self, at: DVec2) -> Stand {
        let along = self.along(at);
        // The sides to the player's left and right.
        let (sides, circles) = match self.seat {
            Seat::South => (["left", "right"], ["left", "right"]),
            Seat::East => (["below", "above"], ["lower", "upper"]),
            Seat::North => (["right", "left"], ["right", "left"]),
            Seat::West => (["above", "below"], ["upper", "lower"]),
        };
        let side = usize::from(along > 0.0);
        if (along.abs() - Self::base_circle_along()).abs() < SLACK {
            return Stand::Circle(circles[side]);
        }
        match (along.abs() * 1000.0).round() {
            0.0 => Stand::Middle,
            mm => Stand::Beside(mm, sides[side]),
        }
    }

    /// Whether the striker may be placed at `at`.
    ///
    /// # Errors
    /// Returns the first rule that the position breaks.
    pub(crate) fn check(&self, at: DVec2) -> Result<(), Misplaced> {
        let here = self.seat.turn_back(at);
        let middle = self.middle();
        let striker = self.set.striker_radius();
        let circle = DVec2::new(Self::base_circle_along(), middle);
        let from_circle = DVec2::new(here.x.abs(), here.y).distance(circle);

        let covers = from_circle <= striker - BASE_CIRCLE_RADIUS + SLACK;
        if !covers && from_circle < striker + BASE_CIRCLE_RADIUS - SLACK {
            return Err(Misplaced::CutsBaseCircle);
        }
        let off_middle = (here.y - middle).abs();
        let touches_both = off_middle <= striker - BASE_LINE_GAP / 2.0 + SLACK;
        let between = touches_both && here.x.abs() < Self::base_circle_along();
        // The condition is written so that a position of NaN is refused too.
        if !(covers || between) {
            return Err(Misplaced::OffTheBaseLines);
        }
        clear_of_coins(self.set, self.coins, at)
    }

    /// Of the legal positions halfway between the base lines, the one nearest to `at`. Distances
    /// are measured along the lines.
    ///
    /// `None` if coins block the whole length, which requires at least seven coins on the base
    /// lines.
    pub fn nearest(&self, at: DVec2) -> Option<DVec2> {
        let (end, circle) = (self.end_of_the_lines(), Self::base_circle_along());
        let ends = [self.along(at).clamp(-end, end), circle, -circle];
        self.nearest_of(ends.into_iter().chain(self.barred().flatten()), at)
    }

    /// The position nearest to `at` among those of `places` (metres along the base lines) that are
    /// legal.
    pub(super) fn nearest_of(&self, places: impl Iterator<Item = f64>, at: DVec2) -> Option<DVec2> {
        let wanted = self.along(at);
        let apart = |along: &f64| (along - wanted).abs();
        let legal = places.filter(|along| self.check(self.at(*along)).is_ok());
        let nearest = legal.min_by(|a, b| apart(a).total_cmp(&apart(b)));
        nearest.map(|along| self.at(along))
    }

    /// Legal positions from left to right: `steps` positions spread evenly between the base
    /// circles, and the two that cover a base circle, except any that are blocked by coins.
    pub(crate) fn candidates(&self, steps: u16) -> Vec<DVec2> {
        let end = self.end_of_the_lines();
        let spread = (0..steps).map(|i| {
            let share = (f64::from(i) + 0.5) / f64::from(steps);
            end * (2.0 * share - 1.0)
        });
        let circle = Self::base_circle_along();
        let places = [-circle].into_iter().chain(spread).chain([circle]);
        places
            .map(|along| self.at(along))
            .filter(|at| self.check(*at).is_ok())
            .collect()
    }

    /// How far from the middle, in metres, the striker may be placed without touching a base
    /// circle.
    fn end_of_the_lines(&self) -> f64 {
        Self::base_circle_along() - BASE_CIRCLE_RADIUS - self.set.striker_radius()
    }

    /// The intervals that coins block on the line midway between the base lines, as distances along
    /// that line.
    fn barred(&self) -> impl Iterator<Item = [f64; 2]> {
        let reach = self.set.striker_radius() + self.set.coin_radius() + GAP;
        let middle = self.middle();
        self.coins.iter().filter_map(move |coin| {
            let coin = self.seat.turn_back(coin.at);
            let off = coin.y - middle;
            let half = reach * reach - off * off;
            (half > 0.0).then(|| [coin.x - half.sqrt(), coin.x + half.sqrt()])
        })
    }
}

/// Whether the striker may be placed at `at` if it need not be on the base lines.
///
/// # Errors
/// Returns the first rule that the position breaks.
pub(crate) fn check_anywhere(set: PieceSet, coins: &[Coin], at: DVec2) -> Result<(), Misplaced> {
    let board = Board::default();
    let room = board.side / 2.0 - set.striker_radius();
    if !at.abs().cmple(DVec2::splat(room + SLACK)).all() {
        return Err(Misplaced::OutsideTheFrame);
    }
    if board.has_pocket_at(at) {
        return Err(Misplaced::OverAPocket);
    }
    clear_of_coins(set, coins, at)
}

fn clear_of_coins(set: PieceSet, coins: &[Coin], at: DVec2) -> Result<(), Misplaced> {
    let reach = set.striker_radius() + set.coin_radius() - SLACK;
    match coins.iter().find(|coin| coin.at.distance(at) < reach) {
        Some(coin) => Err(Misplaced::OnACoin(coin.piece)),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SET: PieceSet = PieceSet::Tournament;

    fn black(at: DVec2) -> Coin {
        Coin {
            piece: Piece::Black,
            at,
        }
    }

    #[test]
    fn every_seat_has_the_same_positions() {
        for seat in Seat::ALL {
            let lines = BaseLines::new(SET, seat, &[]);
            assert_eq!(lines.check(lines.at(0.0)), Ok(()));
            assert_eq!(lines.check(lines.at(0.18)), Ok(()));
            assert_eq!(
                lines.check(lines.at(BaseLines::base_circle_along())),
                Ok(())
            );
            assert_eq!(lines.check(lines.at(0.20)), Err(Misplaced::CutsBaseCircle));
            assert_eq!(lines.check(lines.at(0.30)), Err(Misplaced::OffTheBaseLines));
            for other in Seat::ALL {
                let same = other == seat;
                let there = BaseLines::new(SET, other, &[]).at(0.0);
                assert_eq!(lines.check(there).is_ok(), same);
            }
        }
    }

    #[test]
    fn both_lines_must_be_touched() {
        let lines = BaseLines::new(SET, Seat::South, &[]);
        let play = SET.striker_radius() - BASE_LINE_GAP / 2.0;
        let shifted = |by| lines.at(0.0) + DVec2::new(0.0, by);
        assert_eq!(lines.check(shifted(play)), Ok(()));
        assert_eq!(lines.check(shifted(-play)), Ok(()));
        assert_eq!(
            lines.check(shifted(play + 1e-6)),
            Err(Misplaced::OffTheBaseLines)
        );
    }

    #[test]
    fn a_base_circle_is_covered_fully_or_not_at_all() {
        let lines = BaseLines::new(SET, Seat::North, &[]);
        let circle = BaseLines::base_circle_along();
        let spare = SET.striker_radius() - BASE_CIRCLE_RADIUS;
        let touching = SET.striker_radius() + BASE_CIRCLE_RADIUS;
        for (off, legal) in [
            (spare, true),
            (spare + 1e-6, false),
            (touching - 1e-6, false),
            (touching, true),
        ] {
            for side in [1.0, -1.0] {
                let at = lines.at(side * (circle - off));
                assert_eq!(lines.check(at).is_ok(), legal, "{off} m from the circle");
            }
        }
    }

    #[test]
    fn a_coin_blocks_its_position_and_the_nearest_free_one_touches_nothing() {
        let coins = [black(DVec2::new(0.01, -0.26))];
        let lines = BaseLines::new(SET, Seat::South, &coins);
        let wanted = lines.at(0.0);
        assert_eq!(lines.check(wanted), Err(Misplaced::OnACoin(Piece::Black)));
        let free = lines.nearest(wanted).unwrap();
        assert_eq!(lines.check(free), Ok(()));
        let touching = SET.striker_radius() + SET.coin_radius() + GAP;
        assert!((free.distance(coins[0].at) - touching).abs() < 1e-12);
        assert!(lines.along(free) < 0.0, "the shorter way is to the left");
    }

    #[test]
    fn the_nearest_position_to_a_cut_circle_is_on_it_or_beside_it() {
        let lines = BaseLines::new(SET, Seat::East, &[]);
        let circle = BaseLines::base_circle_along();
        let beside = circle - SET.striker_radius() - BASE_CIRCLE_RADIUS;
        let nearest = |along| lines.along(lines.nearest(lines.at(along)).unwrap());
        assert!((nearest(circle - 0.01) - circle).abs() < 1e-12);
        assert!((nearest(beside + 0.01) - beside).abs() < 1e-12);
        assert!((nearest(-0.5) + circle).abs() < 1e-12);
        assert!((nearest(0.0123) - 0.0123).abs() < 1e-12);
    }

    #[test]
    fn there_is_no_position_if_coins_block_the_whole_length() {
        let empty = BaseLines::new(SET, Seat::South, &[]);
        let coins: Vec<Coin> = (-4..=4)
            .map(|i| black(empty.at(f64::from(i) * 0.055)))
            .collect();
        let lines = BaseLines::new(SET, Seat::South, &coins);
        assert_eq!(lines.nearest(lines.at(0.0)), None);
        assert!(lines.candidates(40).is_empty());
    }

    #[test]
    fn the_candidates_are_legal_and_ordered_from_left_to_right() {
        let coins = [black(DVec2::new(0.26, 0.05)), black(DVec2::new(0.25, -0.1))];
        let lines = BaseLines::new(SET, Seat::East, &coins);
        let places = lines.candidates(30);
        assert!(places.len() > 10 && places.len() < 32);
        assert!(places.iter().all(|at| lines.check(*at).is_ok()));
        assert!(
            places
                .windows(2)
                .all(|p| lines.along(p[0]) < lines.along(p[1]))
        );
    }

    #[test]
    fn free_placing_is_restricted_to_the_board() {
        let coins = [black(DVec2::ZERO)];
        let check = |x, y| check_anywhere(SET, &coins, DVec2::new(x, y));
        assert_eq!(check(0.1, 0.1), Ok(()));
        assert_eq!(check(0.01, 0.02), Err(Misplaced::OnACoin(Piece::Black)));
        assert_eq!(check(0.36, 0.0), Err(Misplaced::OutsideTheFrame));
        assert_eq!(check(0.345, -0.345), Err(Misplaced::OverAPocket));
        assert_eq!(check(f64::NAN, 0.0), Err(Misplaced::OutsideTheFrame));
    }

    #[test]
    fn a_position_that_is_not_a_number_is_refused() {
        let lines = BaseLines::new(SET, Seat::South, &[]);
        assert!(lines.check(DVec2::new(f64::NAN, -0.25)).is_err());
        assert!(
            lines
                .nearest(DVec2::new(f64::NAN, 0.0))
                .is_none_or(|at| lines.check(at).is_ok())
        );
    }
}
