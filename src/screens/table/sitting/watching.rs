//! Watching strokes, and looking into their impacts.

use super::{Phase, Sitting, Taken, Zoom};
use crate::messages::{Key, Mouse, MouseKind};
use crate::screens::Context;
use crate::screens::table::replay::Replay;
use crate::screens::table::{panel, view, words};
use crate::widgets::hit::Watch;

impl Sitting {
    /// Watches the stroke before the move of this number, at its end.
    pub(super) fn look_back(&mut self, number: usize) {
        match self.session.stroke_before(number) {
            Some(stroke) => self.look_at(stroke, true),
            None => self.notice = Some("There is no stroke to look at yet.".into()),
        }
    }

    /// Watches all strokes, one after the other.
    pub(in crate::screens::table) fn watch_all(&mut self, cx: &Context) {
        let first = self.session.strike(0).map(|_| 0);
        match first.or_else(|| self.session.stroke_after(0)) {
            Some(stroke) => self.look_at(stroke, cx.settings.reduced_motion),
            None => self.notice = Some("There is no stroke to look at yet.".into()),
        }
    }

    /// Watches a stroke that was made, at its end or from its beginning.
    fn look_at(&mut self, number: usize, at_end: bool) {
        if let Some(past) = self.session.past(number)
            && let Some(shot) = self.session.shot(number)
        {
            let replay = Replay::new(number, shot, &past.before, at_end);
            self.phase = Phase::Watch(Box::new(replay));
        }
    }

    pub(super) fn watching_key(&mut self, key: Key, cx: &Context) -> Taken {
        let Phase::Watch(replay) = &mut self.phase else {
            return Taken::Ignored;
        };
        if replay.update(key) {
            return Taken::Used;
        }
        let number = replay.number;
        match key {
            Key::Enter if replay.chosen.is_some() => self.zoom_in(cx),
            Key::Enter | Key::Char(' ') if replay.clock.is_over() => {
                match self.session.stroke_after(number) {
                    Some(next) => self.look_at(next, cx.settings.reduced_motion),
                    None => self.go_on(),
                }
            }
            Key::Escape if replay.clock.is_over() => self.go_on(),
            Key::Enter | Key::Escape => replay.clock.seek(f64::INFINITY),
            Key::Char('p' | 'P') => self.look_back(number),
            Key::Char('n' | 'N') => {
                if let Some(stroke) = self.session.stroke_after(number) {
                    self.look_at(stroke, true);
                }
            }
            _ => return Taken::Ignored,
        }
        Taken::Used
    }

    pub(super) fn watching_mouse(&mut self, mouse: &Mouse, cx: &Context) -> Taken {
        let layout = view::layout(cx.body, false);
        let cell = (mouse.column, mouse.row);
        let key = match mouse.kind {
            MouseKind::ScrollUp => Key::Char('.'),
            MouseKind::ScrollDown => Key::Char(','),
            MouseKind::Down if layout.picture.contains(cell.into()) => Key::Char(' '),
            MouseKind::Down => {
                let Phase::Watch(replay) = &mut self.phase else {
                    return Taken::Ignored;
                };
                let Some(number) = panel::impact_at(replay, layout.panel, cell) else {
                    return Taken::Ignored;
                };
                if replay.chosen == Some(number) {
                    self.zoom_in(cx);
                } else {
                    replay.choose_number(number);
                }
                return Taken::Used;
            }
            _ => return Taken::Ignored,
        };
        self.watching_key(key, cx)
    }

    /// Enlarges the impact that is chosen.
    fn zoom_in(&mut self, cx: &Context) {
        let Phase::Watch(replay) = &self.phase else {
            return;
        };
        let (Some(chosen), Some(impact)) = (replay.chosen, replay.impact()) else {
            return;
        };
        // What was called belongs to the first impact.
        let said = self
            .called(replay.number)
            .filter(|_| chosen == 0)
            .map(|called| called.said);
        let pieces = impact.discs.map(|disc| replay.pieces.get(disc).copied());
        let watch = Watch::new(impact.collision, said, cx.settings.reduced_motion)
            .with_faces(pieces.map(words::face));
        let replay = (**replay).clone();
        self.phase = Phase::Impact(Box::new(Zoom { watch, replay }));
    }

    pub(super) fn impact_key(&mut self, key: Key) -> Taken {
        let Phase::Impact(zoom) = &mut self.phase else {
            return Taken::Ignored;
        };
        if zoom.watch.update(key) {
            return Taken::Used;
        }
        match key {
            Key::Escape | Key::Enter | Key::Char('i' | 'I' | ' ') => {
                self.phase = Phase::Watch(Box::new(zoom.replay.clone()));
                Taken::Used
            }
            _ => Taken::Ignored,
        }
    }

    pub(super) fn impact_mouse(&mut self, mouse: &Mouse) -> Taken {
        let key = match mouse.kind {
            MouseKind::ScrollUp => Key::Char('.'),
            MouseKind::ScrollDown => Key::Char(','),
            MouseKind::Down => Key::Char(' '),
            _ => return Taken::Ignored,
        };
        self.impact_key(key)
    }
}
