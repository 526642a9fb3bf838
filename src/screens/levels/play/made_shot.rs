//! A shot that was made, and its replay.

use crate::levels::{Judgement, Level, Win, judge};
use crate::physics::{Event, EventKind, Shot};
use crate::quiz::{Ray, RayGrade, Rays};
use crate::screens::Context;
use crate::screens::levels::words::face_of;
use crate::widgets::RayInput;
use crate::widgets::replay::{ShotAction, ShotClock, ShotImpact, ShotPlayer, WatchRate};

/// The time at which the replay of a shot ends. If only the first collision matters, the replay
/// ends at the next cushion contact after that collision.
fn end(level: &Level, shot: &Shot) -> f64 {
    if !level.is_of_the_first_hit() {
        return shot.duration();
    }
    let hit = |event: &Event| matches!(event.kind, EventKind::Impact { .. });
    let cushion = |event: &&Event| matches!(event.kind, EventKind::Cushion { .. });
    let events = shot.events();
    // The collision may itself come after a cushion contact.
    let since = events.iter().position(hit).unwrap_or(0);
    let next = events.iter().skip(since).find(cushion);
    next.map_or(shot.duration(), |event| event.time)
}

/// The rays that the player has to predict.
pub(super) fn asked(said: &RayInput) -> impl Iterator<Item = Ray> + '_ {
    Ray::BOTH.into_iter().filter(|ray| said.asks(*ray))
}

/// Whether all predicted rays are right.
fn is_right(said: &RayInput, impact: &ShotImpact) -> bool {
    let truth = Rays::from(&impact.collision.outcome());
    asked(said).all(|ray| {
        let error = said.so_far().apart(&truth, ray);
        RayGrade { error }.is_right()
    })
}

/// A shot that was made.
#[derive(Debug, Clone)]
pub(super) struct MadeShot {
    pub(super) player: ShotPlayer,
    pub(super) verdict: Judgement,
    /// The player's prediction for the first impact.
    pub(super) said: Option<RayInput>,
    /// The kind of win, if the level was won.
    pub(super) win: Option<Win>,
    /// Whether the shot was watched to its end, so that its outcome may be shown.
    pub(super) watched: bool,
}

impl MadeShot {
    /// The shot with this number, counted from 1, made after this many hints; replayed at `rate`,
    /// if the player has chosen one. `to_say` says whether a prediction was possible.
    pub(super) fn new(
        level: &Level,
        shot: Shot,
        (number, hints): (u32, usize),
        to_say: bool,
        said: Option<RayInput>,
        (rate, reduced): (Option<WatchRate>, bool),
    ) -> Self {
        let verdict = judge(level, &shot);
        // A first collision alone is short and small.
        let usual = match level.is_of_the_first_hit() {
            true => WatchRate::QUARTER,
            false => WatchRate::REAL,
        };
        let clock = ShotClock::new(end(level, &shot), rate.unwrap_or(usual), reduced);
        let faces = (0..shot.discs().len()).map(|disc| face_of(&level.scene, disc));
        let faces = faces.collect();
        let player = ShotPlayer::new(shot, level.scene.stroke.disc, clock)
            .with_faces(faces)
            .with_said(said.as_ref().map(RayInput::so_far));
        let right = || Some(is_right(said.as_ref()?, player.impacts().first()?));
        let win = Win {
            shots: number,
            hints,
            said_right: to_say.then(|| right().unwrap_or(false)),
        };
        Self {
            win: verdict.won().then_some(win),
            verdict,
            said,
            watched: clock.is_over(),
            player,
        }
    }

    /// Controls the clock, or the replay of an impact.
    pub(super) fn watch(&mut self, action: ShotAction, level: usize, cx: &mut Context) {
        let pace = cx.settings.pace();
        self.player.act(action, &mut cx.settings.watch_rate, pace);
        self.keep_if_watched(level, cx);
    }

    /// Records whether the shot has been watched to its end, and then saves a win in the level with
    /// this number.
    pub(super) fn keep_if_watched(&mut self, level: usize, cx: &mut Context) {
        self.watched |= self.player.zoom().is_none() && self.player.clock().is_over();
        if self.watched {
            self.keep(level, cx);
        }
    }

    /// Saves a win, even if the shot was not watched to its end.
    pub(super) fn keep(&self, level: usize, cx: &mut Context) {
        if let Some(win) = self.win {
            cx.won(level, win);
        }
    }

    /// The result: the first goal that was missed.
    pub(super) fn in_short(&self) -> Option<String> {
        let findings = &self.verdict.findings;
        let unmet = findings.iter().find(|finding| !finding.met);
        let finding = unmet.or(findings.first())?;
        Some(finding.text.clone())
    }
}
