//! Watching strokes, and looking into their impacts.

use super::{ActiveGame, TablePhase};
use crate::messages::Mouse;
use crate::screens::Context;
use crate::screens::table::replay::StrokeReplay;
use crate::screens::table::{panel, view};
use crate::widgets::replay::ShotAction;

impl ActiveGame {
    /// Watches the stroke before the move of this number, at its end.
    pub(super) fn look_back(&mut self, number: usize, cx: &Context) {
        match self.history.stroke_before(number) {
            Some(stroke) => self.look_at(stroke, true, cx),
            None => self.notice = Some("There is no stroke to look at yet.".into()),
        }
    }

    /// Watches the stroke before or after the one that is watched, at its end.
    pub(super) fn look_beside(&mut self, after: bool, cx: &Context) {
        let TablePhase::Watch(replay) = &self.phase else {
            return;
        };
        let number = replay.number;
        match (after, self.history.stroke_after(number)) {
            (false, _) => self.look_back(number, cx),
            (true, Some(stroke)) => self.look_at(stroke, true, cx),
            (true, None) => {}
        }
    }

    /// Watches all strokes, one after the other.
    pub(in crate::screens::table) fn watch_all(&mut self, cx: &Context) {
        let first = self.history.strike(0).map(|_| 0);
        match first.or_else(|| self.history.stroke_after(0)) {
            Some(stroke) => self.look_at(stroke, cx.settings.reduced_motion, cx),
            None => self.notice = Some("There is no stroke to look at yet.".into()),
        }
    }

    /// Watches a stroke that was made, at its end or from its beginning.
    fn look_at(&mut self, number: usize, at_end: bool, cx: &Context) {
        if let Some(past) = self.history.past(number)
            && let Some(shot) = self.history.shot(number)
        {
            let called = past.called.as_ref().map(|called| called.said);
            let (before, settings) = (&past.before, &cx.settings);
            let replay = StrokeReplay::new(number, shot, before, called, at_end, settings);
            self.phase = TablePhase::Watch(Box::new(replay));
        }
    }

    /// From a stroke that was seen to its end to the next one, or on with the game.
    pub(super) fn go_on_from_stroke(&mut self, cx: &Context) {
        let TablePhase::Watch(replay) = &self.phase else {
            return;
        };
        match self.history.stroke_after(replay.number) {
            Some(next) => self.look_at(next, cx.settings.reduced_motion, cx),
            None => self.go_on(),
        }
    }

    pub(super) fn act_on_replay(&mut self, action: ShotAction, cx: &mut Context) {
        if let TablePhase::Watch(replay) = &mut self.phase {
            let settings = &mut cx.settings;
            let reduced = settings.reduced_motion;
            replay.player.act(action, &mut settings.watch_rate, reduced);
        }
    }

    pub(super) fn watching_mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> bool {
        let TablePhase::Watch(replay) = &self.phase else {
            return false;
        };
        let layout = view::layout(cx.body, view::is_enlarged(self));
        let cell = (mouse.column, mouse.row);
        let on_picture = layout.picture.contains(cell.into());
        let line = panel::impact_at(replay, layout.panel, cell);
        match replay.player.pointed(mouse, on_picture, line) {
            Some(action) => self.act_on_replay(action, cx),
            None => return false,
        }
        true
    }
}
