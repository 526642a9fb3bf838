//! Aiming with the mouse or a finger: pointing, moving the striker, or pulling it back and letting
//! go.

use glam::DVec2;

use super::{ActiveGame, After, Aim};
use crate::physics::angle::signed_angle;
use crate::screens::table::aim::SPEEDS;
use crate::screens::{Context, Next};

/// The distance within which the mouse takes hold of the striker, in radii of the striker.
const HOLD: f64 = 1.6;
/// The shortest pull that makes a stroke, in radii of the striker.
const LEAST_PULL: f64 = 1.5;
/// The additional pull for the hardest stroke, in metres. With an aim straight across the board, a
/// full pull ends outside the board.
const FULL_PULL: f64 = 0.15;
/// How much harder a stroke becomes if the mouse is to the right of the aim, and how much softer if
/// the mouse is to the left: the additional pull divided by the square of the distance, in 1/m.
///
/// A terminal reports only the cell of the mouse, so a pull straight down offers only as many
/// strengths as there are rows below the striker. The square is needed because, if the additional
/// pull were proportional to the distance, a step to the next column would not change the strength
/// for some aims. With this value every aim has at least 25 strengths at 80x24 if its direction is
/// a whole degree and its position a whole centimetre.
const SIDEWAYS: f64 = 1.5;
/// The tangent of the largest angle (60°) by which a pull can differ from the aim without turning
/// the aim.
const STEADY: f64 = 1.73;
/// The largest angle between a drag and the direction straight back at which the drag pulls the
/// striker rather than moving it, in radians (45°), if the striker may be moved anywhere.
const BACKWARDS: f64 = 0.79;
/// The largest angle between a drag and the direction straight back at which the striker does not
/// move, in radians (25°), so that a pull does not shift the striker first.
const STRAIGHT_BACK: f64 = 0.44;
/// The smallest slope of an aim to which [`STRAIGHT_BACK`] applies, as the sine of its angle with
/// the base lines (35°). With flatter aims, a drag that is meant to move the striker looks too much
/// like a pull.
const STEEP: f64 = 0.57;

/// What the mouse is dragging.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum Grip {
    /// Nothing.
    #[default]
    Free,
    /// The aim.
    Aim,
    /// The striker.
    Striker {
        /// The aim at the moment when the drag of the striker began.
        before: Aim,
    },
    /// The striker, pulled back.
    Pull {
        /// The position of the mouse.
        to: DVec2,
        /// The aim to restore if the pull is cancelled.
        before: Aim,
        /// Whether the striker is pulled far enough to be struck on release.
        drawn: bool,
    },
}

impl ActiveGame {
    /// Whether the striker is pulled back.
    pub(super) fn is_pulling(&self) -> bool {
        matches!(self.grip, Grip::Pull { .. })
    }

    /// Whether the striker is pulled far enough to be struck on release.
    pub(super) fn is_drawn(&self) -> bool {
        matches!(self.grip, Grip::Pull { drawn: true, .. })
    }

    /// Handles a press of the mouse button at a point on the board.
    pub(super) fn take_hold(&mut self, at: DVec2) {
        let reach = HOLD * self.set().striker_radius();
        self.grip = match self.aim.place.distance(at) < reach {
            true => Grip::Striker { before: self.aim },
            false => Grip::Aim,
        };
        if self.grip == Grip::Aim {
            self.lead(at);
        }
    }

    /// Handles a movement of the mouse with the button down.
    pub(super) fn lead(&mut self, at: DVec2) {
        self.entry.take();
        match self.grip {
            Grip::Free => {}
            Grip::Aim => self.aim.point_at(at, self.history.game().seat()),
            Grip::Striker { before } => {
                match self.is_straight_back(at, &before) {
                    true => self.aim = before,
                    false if self.pulls(at) => {}
                    false => self.aim.put(at, self.history.game()),
                }
                if self.pulls(at) {
                    let before = self.aim;
                    self.draw_back(at, before);
                }
            }
            Grip::Pull { before, .. } => self.draw_back(at, before),
        }
    }

    /// Handles the release of the mouse button at a point on the board.
    pub(super) fn let_go(&mut self, at: DVec2, cx: &Context) -> After {
        let Grip::Pull { before, .. } = self.grip else {
            self.grip = Grip::Free;
            return After::Screen(Next::Ignored);
        };
        self.draw_back(at, before);
        if self.is_drawn() {
            self.grip = Grip::Free;
            return self.strike(cx).into();
        }
        self.let_slip();
        After::Screen(Next::Stay)
    }

    /// Ends a pull without a stroke.
    pub(super) fn let_slip(&mut self) {
        if let Grip::Pull { before, .. } = std::mem::take(&mut self.grip) {
            self.aim = before;
        }
    }

    /// Whether a drag of the striker to this point goes straight back from where the drag began; in
    /// a game with a flat aim, always `false`.
    fn is_straight_back(&self, at: DVec2, before: &Aim) -> bool {
        let seat = self.seat();
        let heading = before.heading(seat);
        let off = signed_angle(at - before.place, -heading);
        let most = match self.is_practice() {
            true => BACKWARDS,
            false if seat.turn_back(heading).y > STEEP => STRAIGHT_BACK,
            false => return false,
        };
        off.is_some_and(|off| off.abs() < most)
    }

    /// Whether a drag of the striker to this point pulls it back rather than moving it: in a game
    /// if the point is behind the base lines, in a practice game if the drag is opposite to the
    /// aim.
    fn pulls(&self, at: DVec2) -> bool {
        let seat = self.seat();
        let way = at - self.aim.place;
        let radius = self.set().striker_radius();
        if self.is_practice() {
            let back = signed_angle(way, -self.aim.heading(seat));
            return way.length() > radius && back.is_some_and(|off| off.abs() < BACKWARDS);
        }
        seat.turn_back(way).y < -radius
    }

    /// Pulls the striker back to this point. A pull along the aim keeps the aim; a pull far to the
    /// side turns the aim.
    fn draw_back(&mut self, to: DVec2, before: Aim) {
        let seat = self.seat();
        self.aim = before;
        let way = before.place - to;
        let heading = before.heading(seat);
        let (along, right) = (way.dot(heading), heading.perp_dot(way));
        let is_steady = right.abs() <= STEADY * along;
        let (length, extra) = match is_steady {
            true => (along, SIDEWAYS * right * right.abs()),
            false => (way.length(), 0.0),
        };
        let least = LEAST_PULL * self.set().striker_radius();
        let drawn = length > least;
        if drawn {
            if !is_steady {
                self.aim.point_at(before.place + way, seat);
            }
            let pull = (length + extra - least) / FULL_PULL;
            self.aim.set_speed(SPEEDS.0 + pull * (SPEEDS.1 - SPEEDS.0));
        }
        self.grip = Grip::Pull { to, before, drawn };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{Hands, Rules, Seat};
    use crate::messages::{Mouse, MouseKind};
    use crate::screens::Settings;
    use crate::screens::table::game_history::GameHistory;
    use crate::screens::table::{Options, picture};
    use proptest::prelude::*;
    use ratatui::layout::Rect;

    /// The size of the smallest usual window, and the area of the board in it.
    const WINDOW: (u16, u16) = (80, 24);
    const BOARD: Rect = Rect::new(1, 2, 39, 20);

    fn at_turn_of(seat: Seat) -> ActiveGame {
        let options = Options::two_people().with(|it| it.setup.hands = Hands::Four);
        let mut setup = options.seeded(1);
        setup.first_breaker = seat;
        ActiveGame::with(options, GameHistory::new(setup))
    }

    /// The cell of a point on the board.
    fn over(at: DVec2) -> Option<(u16, u16)> {
        let all = (0..WINDOW.0).flat_map(|x| (0..WINDOW.1).map(move |y| (x, y)));
        let far = |cell: &(u16, u16)| {
            let (there, _) = picture::pointed(&Mouse::over(MouseKind::Drag, *cell), BOARD);
            there.distance(at)
        };
        all.min_by(|a, b| far(a).total_cmp(&far(b)))
    }

    #[test]
    fn a_slanted_pull_strikes_from_where_the_striker_was() {
        let mut game = at_turn_of(Seat::South);
        game.aim.set_shown(50.0, Seat::South);
        let aimed = game.aim;
        game.take_hold(aimed.place);
        for step in 1..12 {
            game.lead(aimed.place - 0.01 * f64::from(step) * aimed.heading(Seat::South));
            assert_eq!(game.aim.place, aimed.place, "after {step} cm");
        }
        assert!(game.is_drawn());
        game.let_slip();
        // A drag to the side moves the striker, and a later pull starts from its new position.
        game.take_hold(aimed.place);
        for (x, y) in [(0.02, 0.0), (0.06, 0.0), (0.06, -0.05), (0.06, -0.1)] {
            game.lead(aimed.place + DVec2::new(x, y));
        }
        assert!((game.aim.place.x - 0.06).abs() < 1e-9);
        assert!(game.is_pulling());
    }

    /// In an earlier version, if the mouse moved in small steps, the striker moved along with it
    /// and was never pulled.
    #[test]
    fn in_practice_a_slow_drag_backwards_pulls_in_any_direction() {
        for direction in [0.0, 90.0, 200.0] {
            let options = Options::default().with(|it| it.setup.rules = Rules::Practice);
            let history = GameHistory::new(options.seeded(1));
            let mut game = ActiveGame::with(options, history);
            game.aim.put(DVec2::ZERO, game.history.game());
            game.aim.set_shown(direction, Seat::South);
            let aimed = game.aim;
            game.take_hold(aimed.place);
            for step in 1..24 {
                game.lead(aimed.place - 0.005 * f64::from(step) * aimed.heading(Seat::South));
                assert_eq!(game.aim.place, aimed.place, "{direction}°, step {step}");
            }
            assert!(game.is_drawn(), "{direction}°");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn a_pull_along_the_aim_keeps_it_and_has_at_least_24_strengths(
            seat in prop::sample::select(Seat::ALL.to_vec()),
            direction in 20.0..160.0_f64,
            along in -0.1..0.1_f64,
        ) {
            let cx = Context::new(Settings::default(), 1);
            let mut game = at_turn_of(seat);
            let place = game.game().base_lines().at(along);
            game.aim.put(place, game.history.game());
            game.aim.set_shown(direction + seat.turned_by_deg(), seat);
            let aimed = game.aim;
            let drag = |game: &mut ActiveGame, kind, cell| {
                let _ = game.aim_at(&Mouse::over(kind, cell), BOARD, &cx);
            };
            drag(&mut game, MouseKind::Down, over(aimed.place).unwrap());
            let behind = aimed.place - seat.turn(DVec2::new(0.0, 0.09));
            drag(&mut game, MouseKind::Drag, over(behind).unwrap());
            prop_assert!(game.is_pulling());
            let mut speeds = Vec::new();
            for cell in (0..WINDOW.0).flat_map(|x| (0..WINDOW.1).map(move |y| (x, y))) {
                drag(&mut game, MouseKind::Drag, cell);
                let off = game.aim.shown_deg(seat) - aimed.shown_deg(seat);
                if game.is_drawn() && off.abs() < 0.3 {
                    speeds.push((10.0 * game.aim.speed).round() as u32);
                }
            }
            speeds.sort_unstable();
            speeds.dedup();
            prop_assert!(speeds.len() >= 24, "{speeds:?}");

            // Straight back along the aim, cell by cell.
            let back = |metres: f64| aimed.place - metres * aimed.heading(seat);
            for step in 6..18 {
                drag(&mut game, MouseKind::Drag, over(back(0.01 * f64::from(step))).unwrap());
                if game.is_drawn() {
                    prop_assert_eq!(game.aim.shown_deg(seat), aimed.shown_deg(seat));
                }
            }
        }
    }
}
