//! Calling the first impact before the stroke.

use super::{ActiveGame, TablePhase};
use crate::game::{Move, Strike};
use crate::messages::{Mouse, MouseKind};
use crate::screens::Context;
use crate::screens::table::calls::call;
use crate::widgets::hit::point_at;
use crate::widgets::input::RayAction;
use crate::widgets::{Outcome, SplitLayout};

impl ActiveGame {
    pub(super) fn act_on_call(&mut self, action: RayAction, cx: &Context) {
        if let TablePhase::Call(calling) = &mut self.phase
            && let Outcome::Done(()) = calling.rays.act(action)
            && let Some(said) = calling.rays.said()
        {
            let (of, call) = (calling.of.take(), Some(call(&said)));
            self.phase = TablePhase::Aim;
            match of {
                Some(stroke) => self.play_for_the_computer(&stroke, call, cx),
                None => {
                    let strike = self.aim.strike(self.seat());
                    self.play(Move::Strike(Strike { call, ..strike }), cx);
                }
            }
        }
    }

    /// Away from a call: back to the aim, or to the computer's.
    pub(super) fn leave_call(&mut self, cx: &Context) {
        let TablePhase::Call(calling) = &mut self.phase else {
            return;
        };
        match calling.of.take() {
            Some(stroke) => self.show(*stroke, cx),
            None => self.phase = TablePhase::Aim,
        }
    }

    pub(super) fn calling_mouse(&mut self, mouse: &Mouse, cx: &Context) -> bool {
        let picture = SplitLayout::new(cx.room()).picture;
        let cell = mouse.cell();
        let pressed = mouse.kind == MouseKind::Down;
        let held = pressed || mouse.kind == MouseKind::Drag;
        match &mut self.phase {
            TablePhase::Call(calling) if held && picture.contains(cell.into()) => {
                let collision = &calling.hit.impact.collision;
                point_at(
                    picture,
                    collision,
                    &mut calling.rays,
                    mouse.place(),
                    pressed,
                );
                true
            }
            _ => false,
        }
    }
}
