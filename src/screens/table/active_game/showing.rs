//! The computer's stroke before it is struck: where it stands, where it aims, how hard, so
//! that one can say first what will happen.

use std::time::Duration;

use super::{ActiveGame, Calling, TablePhase};
use crate::game::Move;
use crate::messages::{Mouse, MouseKind};
use crate::screens::Context;
use crate::screens::table::computer_stroke::ComputerStroke;
use crate::screens::table::options::Player;
use crate::screens::table::preview::Preview;
use crate::widgets::RayInput;

/// How long each part of the aim is seen before the next, and the whole at last.
const PARTS: [Duration; 3] = [
    Duration::from_millis(250),
    Duration::from_millis(250),
    Duration::from_millis(700),
];

/// A stroke that is about to be struck.
#[derive(Debug, Clone)]
pub(in crate::screens::table) struct ShownStroke {
    pub(in crate::screens::table) stroke: ComputerStroke,
    /// How many of its parts are seen: the place, the direction, the strength.
    pub(in crate::screens::table) parts: usize,
    /// Until the next part, or the stroke; `None` where it waits for a key.
    left: Option<Duration>,
}

impl ShownStroke {
    pub(super) fn wake(&self) -> Option<Duration> {
        self.left
    }
}

impl ActiveGame {
    /// Shows what the computer is about to strike.
    pub(super) fn show(&mut self, stroke: ComputerStroke, cx: &Context) {
        let parts = match cx.settings.reduced_motion {
            true => PARTS.len(),
            false => 1,
        };
        let left = self.part_lasts(parts, cx);
        let shown = ShownStroke {
            stroke,
            parts,
            left,
        };
        self.phase = TablePhase::Show(Box::new(shown));
    }

    /// How long a stroke is seen of which so many parts are there. Whoever calls strokes is
    /// left the time to do so; whoever watches them fast sees this faster too.
    fn part_lasts(&self, parts: usize, cx: &Context) -> Option<Duration> {
        let waits = self.options.call && self.options.count(Player::Person) > 0;
        if waits && parts == PARTS.len() {
            return None;
        }
        let rate = cx.settings.watch_rate.map_or(1.0, |rate| rate.seconds());
        let lasts = PARTS.get(parts - 1).copied().unwrap_or_default();
        Some(lasts.div_f64(rate.max(1.0)))
    }

    /// Lets time pass over a stroke that is shown.
    pub(super) fn advance_shown(&mut self, passed: Duration, cx: &Context) {
        let TablePhase::Show(shown) = &self.phase else {
            return;
        };
        let mut shown = shown.clone();
        let mut passed = passed;
        while let Some(left) = shown.left {
            if passed < left {
                shown.left = Some(left - passed);
                break;
            }
            passed -= left;
            if shown.parts == PARTS.len() {
                return self.strike_shown(cx);
            }
            shown.parts += 1;
            shown.left = self.part_lasts(shown.parts, cx);
        }
        self.phase = TablePhase::Show(shown);
    }

    /// Strikes what was shown, at once.
    pub(super) fn strike_shown(&mut self, cx: &Context) {
        if let TablePhase::Show(shown) = &self.phase {
            let stroke = shown.stroke.clone();
            self.play_for_the_computer(&stroke, None, cx);
        }
    }

    /// Lets the player say where the two of its first hit will go. What is called is the
    /// stroke as the hand makes it.
    pub(super) fn call_shown(&mut self, cx: &Context) {
        let TablePhase::Show(shown) = &self.phase else {
            return;
        };
        let [struck, _] = shown.stroke.strikes();
        let preview = Preview::of(&struck, self.game());
        let Some(hit) = preview.as_ref().and_then(Preview::first_hit) else {
            return self.strike_shown(cx);
        };
        self.phase = TablePhase::Call(Box::new(Calling {
            hit,
            rays: RayInput::new(hit.impact.collision.side()),
            of: Some(Box::new(shown.stroke.clone())),
        }));
    }

    /// Plays what the computer has decided, with what was called of it.
    pub(super) fn play_for_the_computer(
        &mut self,
        stroke: &ComputerStroke,
        call: Option<crate::game::Call>,
        cx: &Context,
    ) {
        self.phase = TablePhase::Aim;
        let number = self.history.len();
        for strike in stroke.strikes() {
            self.play(Move::Strike(crate::game::Strike { call, ..strike }), cx);
            if self.history.len() > number {
                self.history.tell(number, stroke.clone());
                self.notice = None;
                return;
            }
        }
        // Neither can be played.
        self.hand_to_person();
    }

    /// A click strikes at once.
    pub(super) fn showing_mouse(&mut self, mouse: &Mouse, cx: &Context) -> bool {
        let clicked = mouse.kind == MouseKind::Down;
        if clicked {
            self.strike_shown(cx);
        }
        clicked
    }
}
