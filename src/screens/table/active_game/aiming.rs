//! Aiming: the keys and the mouse.

use glam::DVec2;

use super::{ActiveGame, Calling, TablePhase};
use crate::game::Move;
use crate::game::steps::{PLACE_STEP, STEPS_PER_DEGREE, STEPS_PER_SPEED};
use crate::messages::{Mouse, MouseKind};
use crate::physics::units::m_from_mm;
use crate::screens::Context;
use crate::screens::table::aim::{Aim, along_the_screen, rightwards};
use crate::screens::table::arrange::Arrange;
use crate::screens::table::keys::TableAction;
use crate::screens::table::preview::Preview;
use crate::screens::table::replay::StrokeReplay;
use crate::widgets::RayInput;

/// A step of the speed, in m/s.
const SPEED_STEP: f64 = 1.0 / STEPS_PER_SPEED;
/// A step of the direction, in degrees.
const DIRECTION_STEP: f64 = 1.0 / STEPS_PER_DEGREE;

impl ActiveGame {
    /// Aims, or does what can be done beside it. A number that was typed is a direction,
    /// unless the key after it says that it is a place or a speed.
    pub(super) fn act_on_aim(&mut self, action: TableAction, cx: &Context) {
        if let Some(number) = self.entry.take() {
            match action {
                TableAction::Strength(1) => self.aim.set_speed(number),
                TableAction::Place(1) => self.stand(m_from_mm(number)),
                TableAction::Place(-1) => self.stand(-m_from_mm(number)),
                _ => self.aim.set_shown(number, self.seat()),
            }
            self.look_ahead();
            if let TableAction::Strength(1) | TableAction::Place(1 | -1) = action {
                return;
            }
        }
        let right = rightwards(self.seat());
        match action {
            TableAction::Turn(tenths) => self.turn(f64::from(tenths) * DIRECTION_STEP * right),
            TableAction::TurnFar(tens) => self.turn(10.0 * f64::from(tens) * right),
            TableAction::Strength(steps) => {
                let by = f64::from(steps) * SPEED_STEP;
                self.aim.set_speed(self.aim.speed + by);
                self.look_ahead();
            }
            TableAction::Place(steps) => self.shift(f64::from(steps) * PLACE_STEP, false),
            TableAction::PlaceUp(steps) => self.shift(f64::from(steps) * PLACE_STEP, true),
            TableAction::Aid(aid) => *aid.of(&mut self.options.aids) ^= true,
            TableAction::Call => self.options.call ^= true,
            TableAction::LayOut => self.phase = TablePhase::Arrange(Arrange::default()),
            TableAction::Undo => self.take_back(),
            TableAction::Hint => self.hint(),
            TableAction::Strike => self.strike(cx),
            _ => {}
        }
    }

    fn turn(&mut self, degrees: f64) {
        self.aim.turn(degrees);
        self.look_ahead();
    }

    /// Moves the striker along the screen, or up it.
    fn shift(&mut self, metres: f64, upwards: bool) {
        let along = if upwards {
            DVec2::Y
        } else {
            along_the_screen(self.seat(), self.game().setup().rules)
        };
        self.aim.move_by(metres * along, self.history.game());
        self.look_ahead();
    }

    /// Puts the striker so many metres beside the middle, to the right on the screen
    /// (or up it).
    fn stand(&mut self, metres: f64) {
        let game = self.history.game();
        let along = along_the_screen(game.seat(), game.setup().rules);
        let beside = self.aim.place - along * self.aim.place.dot(along);
        self.aim.put(beside + metres * along, game);
    }

    /// Takes the last move back; after a stroke, with its aim, to try it again.
    fn take_back(&mut self) {
        let last = self.history.len().checked_sub(1);
        let strike = last.and_then(|last| self.history.strike(last).copied());
        if self.history.undo() {
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
    pub(super) fn strike(&mut self, cx: &Context) {
        let lines = self.game().base_lines();
        if !self.is_practice() && lines.nearest(DVec2::ZERO).is_none() {
            self.pass();
            return;
        }
        if let Err(why) = self.aim.check(self.game()) {
            self.notice = Some(format!("Not from there: {why}."));
            return;
        }
        match self.preview.as_ref().and_then(Preview::first_hit) {
            Some(hit) if self.options.call => {
                let rays = RayInput::new(hit.impact.collision.side());
                let of = None;
                self.phase = TablePhase::Call(Box::new(Calling { hit, rays, of }));
            }
            _ => self.play(Move::Strike(self.aim.strike(self.seat())), cx),
        }
    }

    /// Plays a stroke and watches it.
    pub(super) fn play(&mut self, stroke: Move, cx: &Context) {
        let number = self.history.len();
        if let Some(shot) = self.make(stroke)
            && let Some(past) = self.history.past(number)
        {
            let at_end = cx.settings.reduced_motion;
            let replay = StrokeReplay::new(number, shot, past, at_end, &cx.settings);
            let live = true;
            self.phase = TablePhase::Watch(Box::new(StrokeReplay { live, ..replay }));
        }
    }

    pub(super) fn aiming_mouse(&mut self, mouse: &Mouse, cx: &Context) -> bool {
        let (at, inside) = Self::pointed(mouse, cx);
        match mouse.kind {
            MouseKind::ScrollUp => self.aim.set_speed(self.aim.speed + SPEED_STEP),
            MouseKind::ScrollDown => self.aim.set_speed(self.aim.speed - SPEED_STEP),
            MouseKind::Down if inside => self.take_hold(at),
            MouseKind::Drag => self.lead(at),
            MouseKind::Up => return self.let_go(at, cx),
            MouseKind::Down => return false,
        }
        self.look_ahead();
        true
    }
}
