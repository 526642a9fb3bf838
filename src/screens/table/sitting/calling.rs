//! Calling the first impact before the stroke.

use super::{Phase, Sitting, Taken};
use crate::game::{Move, Strike};
use crate::messages::{Key, Mouse, MouseKind};
use crate::screens::Context;
use crate::screens::table::calls::call;
use crate::screens::table::view;
use crate::widgets::Outcome;
use crate::widgets::hit::point_at;

impl Sitting {
    pub(super) fn calling_key(&mut self, key: Key, cx: &Context) -> Taken {
        let Phase::Call(calling) = &mut self.phase else {
            return Taken::Ignored;
        };
        match calling.rays.update(key) {
            Outcome::Used => {}
            Outcome::Done(()) => {
                let said = calling.rays.so_far();
                self.phase = Phase::Aim;
                let strike = Strike {
                    call: Some(call(&said)),
                    ..self.aim.strike(self.seat())
                };
                self.play(Move::Strike(strike), cx);
            }
            Outcome::Ignored if key == Key::Escape => self.phase = Phase::Aim,
            Outcome::Ignored => return Taken::Ignored,
        }
        Taken::Used
    }

    pub(super) fn calling_mouse(&mut self, mouse: &Mouse, cx: &Context) -> Taken {
        let picture = view::layout(cx.body, true).picture;
        let cell = (mouse.column, mouse.row);
        let pressed = mouse.kind == MouseKind::Down;
        let held = pressed || mouse.kind == MouseKind::Drag;
        match &mut self.phase {
            Phase::Call(calling) if held && picture.contains(cell.into()) => {
                let collision = &calling.hit.impact.collision;
                point_at(picture, collision, &mut calling.rays, cell, pressed);
                Taken::Used
            }
            _ => Taken::Ignored,
        }
    }
}
