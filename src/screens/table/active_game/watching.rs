//! Watching strokes, and looking into their impacts.

use std::time::Duration;

use super::{ActiveGame, TablePhase};
use crate::messages::{Mouse, MouseKind};
use crate::screens::Context;
use crate::screens::table::options::Player;
use crate::screens::table::replay::StrokeReplay;
use crate::screens::table::{panel, view};
use crate::widgets::hit::HitPace;
use crate::widgets::replay::ShotAction;

impl ActiveGame {
    /// The number of the stroke that is watched.
    pub(super) fn watched(&self) -> usize {
        match &self.phase {
            TablePhase::Watch(replay) => replay.number,
            _ => 0,
        }
    }

    /// Watches all strokes, one after the other.
    pub(in crate::screens::table) fn watch_all(&mut self, cx: &Context) {
        let first = self.history.stroke_from(0);
        self.look_at(first, cx.settings.reduced_motion, cx);
    }

    /// Watches a stroke that was made, at its end or from its beginning.
    pub(super) fn look_at(&mut self, stroke: Option<usize>, at_end: bool, cx: &Context) {
        let Some(number) = stroke else {
            self.notice = Some("There is no stroke to look at yet.".into());
            return;
        };
        if let Some(past) = self.history.past(number)
            && let Some(shot) = self.history.shot(number)
        {
            let replay = StrokeReplay::new(number, shot, past, at_end, &cx.settings);
            self.phase = TablePhase::Watch(Box::new(replay));
        }
    }

    /// From a stroke that was seen to its end to the next one, or on with the game.
    pub(super) fn go_on_from_stroke(&mut self, cx: &Context) {
        match self.history.stroke_from(self.watched() + 1) {
            None => self.go_on(),
            next => self.look_at(next, cx.settings.reduced_motion, cx),
        }
    }

    /// When a game of computers alone goes on from the end of a stroke: by itself, unless
    /// all is to wait for a key.
    pub(super) fn end_left(&self, pace: HitPace) -> Option<Duration> {
        let alone = self.options.count(Player::Person) == 0 && pace == HitPace::Flowing;
        match &self.phase {
            TablePhase::Watch(replay) if alone => replay.end_left(),
            _ => None,
        }
    }

    /// Lets time pass over the end of a stroke.
    pub(super) fn advance_end(&mut self, passed: Duration, cx: &Context) {
        let pace = cx.settings.pace();
        if self.end_left(pace).is_none() {
            return;
        }
        if let TablePhase::Watch(replay) = &mut self.phase {
            replay.end_seen += passed;
        }
        if self.end_left(pace) == Some(Duration::ZERO) {
            self.go_on_from_stroke(cx);
        }
    }

    pub(super) fn act_on_replay(&mut self, action: ShotAction, cx: &mut Context) {
        if let TablePhase::Watch(replay) = &mut self.phase {
            let settings = &mut cx.settings;
            let pace = settings.pace();
            replay.player.act(action, &mut settings.watch_rate, pace);
        }
    }

    pub(super) fn watching_mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> bool {
        let TablePhase::Watch(replay) = &self.phase else {
            return false;
        };
        let layout = view::layout(self, cx.room());
        let on_picture = layout.picture.contains(mouse.cell().into());
        let line = panel::impact_at(replay, layout.panel, mouse.cell());
        let ended = replay.player.clock().is_over() && replay.player.chosen().is_none();
        match replay.player.pointed(mouse, on_picture, line) {
            Some(action) => self.act_on_replay(action, cx),
            None if ended && on_picture && mouse.kind == MouseKind::Down => {
                self.go_on_from_stroke(cx);
            }
            None => return false,
        }
        true
    }
}
