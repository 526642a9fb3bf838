//! Aiming with the mouse or a finger: pointing, moving the striker, or pulling it back and letting
//! go.

use glam::DVec2;

use super::{ActiveGame, After};
use crate::physics::angle::signed_angle;
use crate::screens::Context;
use crate::screens::table::aim::{Aim, SPEEDS};

/// The distance within which the mouse takes hold of the striker, in radii of the striker.
const HOLD: f64 = 1.6;
/// The shortest pull that makes a stroke, in radii of the striker.
const LEAST_PULL: f64 = 1.5;
/// The additional pull for the hardest stroke, in metres; a full pull ends beside the board.
const FULL_PULL: f64 = 0.15;
/// The largest angle between a pull and the aim that does not change the aim, in radians (20°):
/// a cell is too coarse for aiming.
const STEADY: f64 = 0.35;
/// The largest angle from straight back at which a drag pulls the striker rather than moving it,
/// in radians (45°), if the striker may be moved anywhere.
const BACKWARDS: f64 = 0.79;

/// What the mouse is dragging.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum Grip {
    /// Nothing.
    #[default]
    Free,
    /// The aim.
    Aim,
    /// The striker.
    Striker,
    /// The striker, pulled back.
    Pull {
        /// The position of the mouse.
        to: DVec2,
        /// The aim to restore if the pull is cancelled.
        before: Aim,
    },
}

impl ActiveGame {
    /// Whether the striker is pulled back.
    pub(super) fn is_pulling(&self) -> bool {
        matches!(self.grip, Grip::Pull { .. })
    }

    /// Whether the striker is pulled far enough to be struck on release.
    pub(super) fn is_drawn(&self) -> bool {
        matches!(self.grip, Grip::Pull { to, .. } if self.pull(to) > 0.0)
    }

    /// Handles a press of the mouse button at a point on the board.
    pub(super) fn take_hold(&mut self, at: DVec2) {
        let reach = HOLD * self.set().striker_radius();
        self.grip = match self.aim.place.distance(at) < reach {
            true => Grip::Striker,
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
            Grip::Striker if self.pulls(at) => {
                let before = self.aim;
                self.draw_back(at, before);
            }
            Grip::Striker => self.aim.put(at, self.history.game()),
            Grip::Pull { before, .. } => self.draw_back(at, before),
        }
    }

    /// Handles the release of the mouse button at a point on the board.
    pub(super) fn let_go(&mut self, at: DVec2, cx: &Context) -> After {
        let Grip::Pull { before, .. } = self.grip else {
            self.grip = Grip::Free;
            return After::Ignored;
        };
        self.draw_back(at, before);
        if self.is_drawn() {
            self.grip = Grip::Free;
            return self.strike(cx).into();
        }
        self.let_slip();
        After::Same
    }

    /// Ends a pull without a stroke.
    pub(super) fn let_slip(&mut self) {
        if let Grip::Pull { before, .. } = std::mem::take(&mut self.grip) {
            self.aim = before;
        }
    }

    /// Whether a drag of the striker to this point pulls it back rather than moving it: in a game
    /// if the point is behind the base lines, in a practice game if it is opposite to the aim.
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

    /// The fraction of the full strength for a pull to this point; 0 if it is too short.
    fn pull(&self, to: DVec2) -> f64 {
        let least = LEAST_PULL * self.set().striker_radius();
        ((self.aim.place.distance(to) - least) / FULL_PULL).clamp(0.0, 1.0)
    }

    /// Pulls the striker back to this point.
    fn draw_back(&mut self, to: DVec2, before: Aim) {
        let seat = self.seat();
        self.aim = before;
        let pull = self.pull(to);
        if pull > 0.0 {
            let way = self.aim.place - to;
            let off = signed_angle(way, self.aim.heading(seat));
            if off.is_none_or(|off| off.abs() > STEADY) {
                self.aim.point_at(self.aim.place + way, seat);
            }
            self.aim.set_speed(SPEEDS.0 + pull * (SPEEDS.1 - SPEEDS.0));
        }
        self.grip = Grip::Pull { to, before };
    }
}
