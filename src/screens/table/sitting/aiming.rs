//! Aiming: the keys and the mouse.

use glam::DVec2;

use super::{Calling, Grip, Phase, Sitting, Taken};
use crate::game::Move;
use crate::game::steps::{PLACE_STEP, STEPS_PER_DEGREE, STEPS_PER_SPEED};
use crate::messages::{Key, Mouse, MouseKind};
use crate::physics::Board;
use crate::physics::units::m_from_mm;
use crate::screens::Context;
use crate::screens::table::aim::{Aim, along_the_screen, rightwards};
use crate::screens::table::arrange::Arrange;
use crate::screens::table::replay::Replay;
use crate::screens::table::view;
use crate::widgets::hit::side;
use crate::widgets::{Outcome, RayInput, board};

/// A large step of the striker, in metres.
const FAR: f64 = 10.0 * PLACE_STEP;
/// A step of the speed, in m/s.
const SPEED_STEP: f64 = 1.0 / STEPS_PER_SPEED;
/// A step of the direction, in degrees.
const DIRECTION_STEP: f64 = 1.0 / STEPS_PER_DEGREE;
/// How near the mouse has to be to take hold of the striker, in its radii.
const HOLD: f64 = 1.6;

impl Sitting {
    pub(super) fn aiming_key(&mut self, key: Key, cx: &mut Context) -> Taken {
        match key {
            Key::Char('-' | '_') if !self.entry.is_open() => {
                self.aim.set_speed(self.aim.speed - SPEED_STEP);
            }
            _ => match self.entry.update(key) {
                Outcome::Used => {}
                Outcome::Done(degrees) => self.aim.set_direction(degrees),
                Outcome::Ignored => return self.command(key, cx),
            },
        }
        self.look_ahead();
        Taken::Used
    }

    /// A number that was typed is a direction, unless the key after it says that it is
    /// a place or a speed.
    fn command(&mut self, key: Key, cx: &mut Context) -> Taken {
        if let Some(number) = self.entry.take() {
            match key {
                Key::Char('+' | '=') => self.aim.set_speed(number),
                Key::Char(']') => self.stand(m_from_mm(number)),
                Key::Char('[') => self.stand(-m_from_mm(number)),
                _ => self.aim.set_direction(number),
            }
            self.look_ahead();
            if let Key::Char('+' | '=' | ']' | '[') = key {
                return Taken::Used;
            }
        }
        let right = rightwards(self.seat());
        match key {
            Key::Char('+' | '=') => {
                self.aim.set_speed(self.aim.speed + SPEED_STEP);
                self.look_ahead();
            }
            Key::Right => self.turn(right),
            Key::Left => self.turn(-right),
            Key::Up => self.turn(-DIRECTION_STEP * right),
            Key::Down => self.turn(DIRECTION_STEP * right),
            Key::PageUp => self.turn(-10.0 * right),
            Key::PageDown => self.turn(10.0 * right),
            Key::Char(']' | 'd' | 'D') => self.shift(PLACE_STEP, false),
            Key::Char('[' | 'a' | 'A') => self.shift(-PLACE_STEP, false),
            Key::Char('}') => self.shift(FAR, false),
            Key::Char('{') => self.shift(-FAR, false),
            Key::Char('w' | 'W') if self.is_practice() => self.shift(PLACE_STEP, true),
            Key::Char('s' | 'S') if self.is_practice() => self.shift(-PLACE_STEP, true),
            Key::Char('l' | 'L') => self.options.aids.line ^= true,
            Key::Char('g' | 'G') => self.options.aids.ghost ^= true,
            Key::Char('r' | 'R') => self.options.aids.rays ^= true,
            Key::Char('c' | 'C') => self.options.call ^= true,
            Key::Char('i' | 'I') => self.look_back(self.session.len()),
            Key::Char('p' | 'P') if self.is_practice() => {
                self.phase = Phase::Arrange(Arrange::new());
            }
            Key::Char('z' | 'Z') if self.is_practice() => self.take_back(),
            Key::Char('h' | 'H') => self.ask_for_hint(cx),
            Key::Char(' ') | Key::Enter => self.strike(cx),
            Key::Escape => return Taken::Leave,
            _ => return Taken::Ignored,
        }
        Taken::Used
    }

    fn turn(&mut self, degrees: f64) {
        self.aim.set_direction(self.aim.direction_deg + degrees);
        self.look_ahead();
    }

    /// Moves the striker along the screen, or up it.
    fn shift(&mut self, metres: f64, upwards: bool) {
        let along = if upwards {
            DVec2::Y
        } else {
            along_the_screen(self.seat(), self.game().setup().rules)
        };
        self.aim.move_by(metres * along, self.session.game());
        self.look_ahead();
    }

    /// Puts the striker so many metres beside the middle, to the right on the screen
    /// (or up it).
    fn stand(&mut self, metres: f64) {
        let game = self.session.game();
        let along = along_the_screen(game.seat(), game.setup().rules);
        let beside = self.aim.place - along * self.aim.place.dot(along);
        self.aim.put(beside + metres * along, game);
    }

    /// Takes the last move back; after a stroke, with its aim, to try it again.
    fn take_back(&mut self) {
        let last = self.session.len().checked_sub(1);
        let strike = last.and_then(|last| self.session.strike(last).copied());
        if self.session.undo() {
            self.begin_turn();
            if let Some(strike) = strike {
                self.aim = Aim::of(&strike, self.seat());
                self.look_ahead();
            }
        } else {
            self.notice = Some("There is nothing to take back.".into());
        }
    }

    /// From aiming to the stroke, or to the call before it.
    fn strike(&mut self, cx: &Context) {
        let board = Board::default();
        if !self.is_practice()
            && self
                .game()
                .base_lines(&board)
                .nearest(DVec2::ZERO)
                .is_none()
        {
            self.pass();
            return;
        }
        if let Err(why) = self.aim.check(self.game()) {
            self.notice = Some(format!("Not from there: {why}."));
            return;
        }
        let hit = self
            .preview
            .as_ref()
            .and_then(|preview| preview.first_hit());
        match hit {
            Some(hit) if self.options.call => {
                self.phase = Phase::Call(Box::new(Calling {
                    hit: *hit,
                    rays: RayInput::new(side(&hit.impact.collision)),
                }));
            }
            _ => self.play(Move::Strike(self.aim.strike(self.seat())), cx),
        }
    }

    /// Plays a stroke and watches it.
    pub(super) fn play(&mut self, stroke: Move, cx: &Context) {
        let number = self.session.len();
        if let Some(shot) = self.make(stroke)
            && let Some(past) = self.session.past(number)
        {
            let reduced = cx.settings.reduced_motion;
            let replay = Replay::new(number, shot, &past.before, reduced);
            self.phase = Phase::Watch(Box::new(replay));
        }
    }

    pub(super) fn aiming_mouse(&mut self, mouse: &Mouse, cx: &Context) -> Taken {
        let area = board::square(view::layout(cx.body, false).picture);
        let at = board::view(area, &Board::default()).world_at(mouse.column, mouse.row);
        let inside = area.contains((mouse.column, mouse.row).into());
        match mouse.kind {
            MouseKind::ScrollUp => self.aim.set_speed(self.aim.speed + SPEED_STEP),
            MouseKind::ScrollDown => self.aim.set_speed(self.aim.speed - SPEED_STEP),
            MouseKind::Down if inside => {
                let reach = HOLD * self.game().setup().set.striker_radius();
                self.grip = if self.aim.place.distance(at) < reach {
                    Grip::Striker
                } else {
                    Grip::Aim
                };
                self.lead(at);
            }
            MouseKind::Drag => self.lead(at),
            _ => return Taken::Ignored,
        }
        self.look_ahead();
        Taken::Used
    }

    /// Moves what the mouse holds.
    fn lead(&mut self, at: DVec2) {
        self.entry.take();
        self.notice = None;
        match self.grip {
            Grip::Striker => self.aim.put(at, self.session.game()),
            Grip::Aim => self.aim.point_at(at, self.session.game().seat()),
        }
    }
}
