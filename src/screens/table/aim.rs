//! The aim: the striker's position, its direction and its speed.

use glam::DVec2;

use crate::game::{BaseLines, Game, Rules, Seat, Strike};
use crate::numbers::fixed;
use crate::physics::angle::heading;
use crate::physics::units::mm_from_m;
use crate::physics::{Board, Motion};

/// The speeds of the slowest and the fastest stroke, in m/s.
pub(super) const SPEEDS: (f64, f64) = (0.2, 6.0);
/// The initial speed setting for a break, in m/s.
const BREAK_SPEED: f64 = 4.0;
/// The initial speed setting for any other stroke, in m/s.
const FIRST_SPEED: f64 = 2.5;

/// The aim of a stroke that is being set up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Aim {
    /// The position of the striker, in metres from the centre of the board.
    pub(super) place: DVec2,
    /// Direction in degrees, 0 to 360, from the point of view of the player who strikes: 90 is
    /// straight across the board. Shown and typed directions refer to the screen instead.
    direction_deg: f64,
    /// Speed in m/s.
    pub(super) speed: f64,
}

impl Aim {
    /// The initial aim of a turn: from the middle, or the legal position nearest to it,
    /// straight across.
    pub(super) fn begin(game: &Game) -> Self {
        let lines = game.base_lines();
        let middle = lines.at(0.0);
        Self {
            place: lines.nearest(middle).unwrap_or(middle),
            direction_deg: 90.0,
            speed: match game.play().is_unbroken() {
                true => BREAK_SPEED,
                false => FIRST_SPEED,
            },
        }
    }

    /// The aim of a stroke that was made from `seat`.
    pub(super) fn of(strike: &Strike, seat: Seat) -> Self {
        let mut aim = Self {
            place: strike.place,
            direction_deg: 90.0,
            speed: FIRST_SPEED,
        };
        aim.point_at(strike.place + strike.velocity, seat);
        aim.set_speed(strike.velocity.length());
        aim
    }

    /// This aim as a stroke of the player at `seat`.
    pub(super) fn strike(&self, seat: Seat) -> Strike {
        Motion::new(self.place, self.speed * self.heading(seat)).into()
    }

    /// The direction on the board, a unit vector.
    pub(super) fn heading(&self, seat: Seat) -> DVec2 {
        seat.turn(heading(self.direction_deg))
    }

    /// The direction on the screen in degrees, anticlockwise from the right, 0 to 360.
    pub(super) fn shown_deg(&self, seat: Seat) -> f64 {
        (self.direction_deg + seat.turned_by_deg()).rem_euclid(360.0)
    }

    /// Aims in a direction on the screen, in degrees; any number is valid.
    pub(super) fn set_shown(&mut self, degrees: f64, seat: Seat) {
        self.set_direction(degrees - seat.turned_by_deg());
    }

    /// Turns the aim anticlockwise by an angle in degrees.
    pub(super) fn turn(&mut self, degrees: f64) {
        self.set_direction(self.direction_deg + degrees);
    }

    fn set_direction(&mut self, degrees: f64) {
        // The direction is rounded to a hundredth of a degree, so that the rounding errors of steps
        // do not add up.
        let hundredths = (degrees * 100.0).round().rem_euclid(36_000.0);
        self.direction_deg = hundredths / 100.0;
    }

    /// Turns to the next of these directions on the board: the nearest one in the direction of
    /// [`rightwards`], or in the opposite direction if `sense` is negative.
    pub(super) fn turn_to_next(&mut self, ways: &[DVec2], sense: i8, seat: Seat) {
        let right = f64::from(sense) * rightwards(seat);
        let turns = ways.iter().map(|way| {
            let mut aimed = *self;
            aimed.point_at(self.place + *way, seat);
            let turn = right * (aimed.direction_deg - self.direction_deg);
            // The present direction comes last, after a whole turn. Directions are rounded to
            // hundredths of a degree.
            let turn = (turn - 0.005).rem_euclid(360.0);
            (turn, aimed)
        });
        if let Some((_, next)) = turns.min_by(|(a, _), (b, _)| a.total_cmp(b)) {
            *self = next;
        }
    }

    /// Aims at a point on the board.
    pub(super) fn point_at(&mut self, at: DVec2, seat: Seat) {
        if let Some(way) = (at - self.place).try_normalize() {
            self.set_direction(seat.turn_back(way).to_angle().to_degrees());
        }
    }

    /// Sets the speed, rounded to tenths of a metre per second and limited to [`SPEEDS`].
    pub(super) fn set_speed(&mut self, speed: f64) {
        let tenths = (speed * 10.0).round() / 10.0;
        self.speed = tenths.clamp(SPEEDS.0, SPEEDS.1);
    }

    /// Moves the striker by `step`, in metres on the board. Except in a practice game, the striker
    /// moves only along the base lines, in steps, and skips positions that are not legal. It stays
    /// where it is if there is no further legal position.
    pub(super) fn move_by(&mut self, step: DVec2, game: &Game) {
        if game.setup().rules == Rules::Practice {
            self.put(self.place + step, game);
            return;
        }
        let lines = game.base_lines();
        if let Some(next) = lines.next_on_steps(self.place, lines.along(step)) {
            self.place = next;
        }
    }

    /// Puts the striker at a point or, except in a practice game, at the nearest point of the base
    /// lines. The position may be illegal.
    pub(super) fn put(&mut self, at: DVec2, game: &Game) {
        let board = Board::default();
        if game.setup().rules == Rules::Practice {
            let room = board.side / 2.0 - game.setup().set.striker_radius();
            let grid = (at * 10_000.0).round() / 10_000.0;
            self.place = grid.clamp(DVec2::splat(-room), DVec2::splat(room));
            return;
        }
        let lines = game.base_lines();
        let end = BaseLines::base_circle_along();
        let along = (lines.along(at) * 10_000.0).round() / 10_000.0;
        // The end position covers a base circle.
        self.place = lines.at(along.clamp(-end, end));
    }

    /// The position of the striker as seen on the screen, as in "12 mm left".
    pub(super) fn place_words(&self, game: &Game) -> String {
        if game.setup().rules == Rules::Practice {
            return millimetres(self.place);
        }
        game.base_lines().stand(self.place).words()
    }
}

/// A position on the board in millimetres from its centre, to the right and up.
pub(super) fn millimetres(at: DVec2) -> String {
    let [x, y] = at.to_array().map(|metres| fixed(mm_from_m(metres), 0));
    format!("{x}, {y} mm")
}

/// The direction of a step to the right or up on the screen: along the base lines of a seat, or
/// simply to the right in a practice game.
pub(super) fn along_the_screen(seat: Seat, rules: Rules) -> DVec2 {
    match seat {
        Seat::East | Seat::West if rules != Rules::Practice => DVec2::Y,
        _ => DVec2::X,
    }
}

/// The sign of the change in direction for a turn to the right on the screen or, for players who
/// look left or right, up the screen: clockwise for players who look up or left, anticlockwise for
/// the others.
pub(super) fn rightwards(seat: Seat) -> f64 {
    match seat {
        Seat::South | Seat::East => -1.0,
        Seat::North | Seat::West => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{GameSetup, Hands};

    #[test]
    fn no_action_moves_the_striker_off_the_base_lines() {
        for seat in Seat::ALL {
            let game = Game::new(GameSetup {
                hands: Hands::Four,
                first_breaker: seat,
                ..GameSetup::default()
            });
            let mut aim = Aim::begin(&game);
            assert_eq!(game.check_place(aim.place), Ok(()));
            for step in [
                DVec2::splat(0.05),
                DVec2::splat(-9.0),
                DVec2::new(9.0, -3.0),
            ] {
                aim.move_by(step, &game);
                let seen = seat.turn_back(aim.place);
                assert!((seen.y - seat.turn_back(Aim::begin(&game).place).y).abs() < 1e-12);
                assert!(seen.x.abs() <= BaseLines::base_circle_along());
            }
            // The striker may cover the base circle at either end.
            assert_eq!(game.check_place(aim.place), Ok(()));
            assert!(aim.place_words(&game).ends_with("circle"));
        }
    }

    #[test]
    fn a_position_that_rounds_to_zero_has_no_sign() {
        let at = DVec2::new(-0.000_4, -0.012);
        assert_eq!(millimetres(at), "0, -12 mm");
    }

    #[test]
    fn straight_across_is_exact_from_every_side() {
        for seat in Seat::ALL {
            let game = Game::new(GameSetup {
                hands: Hands::Four,
                first_breaker: seat,
                ..GameSetup::default()
            });
            let velocity = Aim::begin(&game).strike(seat).velocity;
            assert_eq!(seat.turn_back(velocity), DVec2::new(0.0, BREAK_SPEED));
        }
    }

    #[test]
    fn a_stroke_aimed_at_a_point_heads_for_it() {
        let game = Game::new(GameSetup::default());
        let mut aim = Aim::begin(&game);
        for at in [DVec2::new(0.1, 0.2), DVec2::new(-0.3, -0.3), DVec2::ZERO] {
            aim.point_at(at, Seat::South);
            let way = (at - aim.place).normalize();
            assert!(aim.heading(Seat::South).distance(way) < 1e-4);
        }
        aim.set_shown(-725.0, Seat::South);
        assert_eq!(aim.shown_deg(Seat::South), 355.0);
    }

    #[test]
    fn typed_and_shown_directions_agree_at_every_seat() {
        for seat in Seat::ALL {
            let game = Game::new(GameSetup {
                hands: Hands::Four,
                first_breaker: seat,
                ..GameSetup::default()
            });
            let mut aim = Aim::begin(&game);
            for degrees in [0.0, 90.0, 180.0, 270.0, 37.25] {
                aim.set_shown(degrees, seat);
                assert_eq!(aim.shown_deg(seat), degrees);
                assert!(aim.heading(seat).distance(heading(degrees)) < 1e-12);
            }
            let along = along_the_screen(seat, Rules::Tournament);
            let words = if along.x > 0.0 {
                ["right", "left"]
            } else {
                ["above", "below"]
            };
            for (step, word) in [0.05, -0.05].into_iter().zip(words) {
                let middle = aim.place - along * aim.place.dot(along);
                aim.put(middle + step * along, &game);
                assert_eq!(aim.place_words(&game), format!("50 mm {word}"));
            }
        }
    }
}
