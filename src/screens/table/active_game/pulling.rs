//! Aiming with the mouse or a finger: pointing, moving the striker, or pulling it back and letting
//! go.

use glam::DVec2;

use super::{ActiveGame, After};
use crate::physics::angle::signed_angle;
use crate::screens::Context;
use crate::screens::table::aim::{Aim, SPEEDS};

/// How near the mouse has to be to take hold of the striker, in its radii.
const HOLD: f64 = 1.6;
/// How far one has to pull for any stroke at all, in radii of the striker.
const LEAST_PULL: f64 = 1.5;
/// How much farther one pulls for the hardest stroke, in metres: it ends beside the board.
const FULL_PULL: f64 = 0.15;
/// Up to which angle off the aim a pull leaves it as it is, in radians (20°): a cell is too
/// coarse to aim with.
const STEADY: f64 = 0.35;
/// Within which angle off straight back a drag from the striker pulls, where the striker
/// may be moved anywhere, in radians (45°).
const BACKWARDS: f64 = 0.79;

/// What the mouse holds while its button is down.
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
        /// How far: where the mouse is.
        to: DVec2,
        /// The aim to go back to.
        before: Aim,
    },
}

impl ActiveGame {
    /// Whether the striker is pulled back.
    pub(super) fn is_pulling(&self) -> bool {
        matches!(self.grip, Grip::Pull { .. })
    }

    /// Whether it is pulled far enough to be struck when it is let go.
    pub(super) fn is_drawn(&self) -> bool {
        matches!(self.grip, Grip::Pull { to, .. } if self.pull(to) > 0.0)
    }

    /// The button went down at a point of the board.
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

    /// The mouse moved with its button down.
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

    /// The button was let go at a point of the board.
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

    /// Whether a drag of the striker to there pulls it back: in a game to behind its base
    /// lines, along which it is moved; in practice away from where it is aimed.
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

    /// The share of the whole strength that a pull to there has; 0 if it is none yet.
    fn pull(&self, to: DVec2) -> f64 {
        let least = LEAST_PULL * self.set().striker_radius();
        ((self.aim.place.distance(to) - least) / FULL_PULL).clamp(0.0, 1.0)
    }

    /// Pulls the striker back to there.
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
