//! A shot that was made, being watched.

use crate::levels::{Judgement, Level, Win, judge};
use crate::physics::{Event, EventKind, Shot};
use crate::quiz::{Ray, RayGrade, Rays};
use crate::screens::Context;
use crate::screens::levels::words::face_of;
use crate::widgets::RayInput;
use crate::widgets::replay::{ShotAction, ShotClock, ShotImpact, ShotPlayer, WatchRate};

/// Until when a shot is seen. Where nothing counts but the first hit, that is to the next
/// cushion after it.
fn end(level: &Level, shot: &Shot) -> f64 {
    if !level.is_of_the_first_hit() {
        return shot.duration();
    }
    let hit = |event: &Event| matches!(event.kind, EventKind::Impact { .. });
    let cushion = |event: &&Event| matches!(event.kind, EventKind::Cushion { .. });
    let events = shot.events();
    // The hit may come off a cushion itself.
    let since = events.iter().position(hit).unwrap_or(0);
    let next = events.iter().skip(since).find(cushion);
    next.map_or(shot.duration(), |event| event.time)
}

/// The rays that were asked for.
pub(super) fn asked(said: &RayInput) -> impl Iterator<Item = Ray> + '_ {
    Ray::BOTH.into_iter().filter(|ray| said.asks(*ray))
}

/// Whether all that was asked for is right.
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
    /// What the player said of the first impact.
    pub(super) said: Option<RayInput>,
    /// How it was won, if it was.
    pub(super) win: Option<Win>,
    /// Whether it was seen to its end, so that its outcome may be told.
    pub(super) told: bool,
}

impl MadeShot {
    /// The shot numbered `number`, counted from 1, made after so many hints, watched at
    /// `rate` if that was chosen.
    /// `to_say`: whether there was something to say of it.
    pub(super) fn new(
        level: &Level,
        shot: Shot,
        (number, hints): (u32, usize),
        to_say: bool,
        said: Option<RayInput>,
        (rate, reduced): (Option<WatchRate>, bool),
    ) -> Self {
        let verdict = judge(level, &shot);
        // What is seen of a first hit alone is small and near.
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
            told: clock.is_over(),
            player,
        }
    }

    /// Works the clock, or an impact.
    pub(super) fn watch(&mut self, action: ShotAction, level: usize, cx: &mut Context) {
        let pace = cx.settings.pace();
        self.player.act(action, &mut cx.settings.watch_rate, pace);
        self.keep_if_told(level, cx);
    }

    /// Notes whether all has been seen, and then keeps a win in the level of this number.
    pub(super) fn keep_if_told(&mut self, level: usize, cx: &mut Context) {
        self.told |= self.player.zoom().is_none() && self.player.clock().is_over();
        if self.told {
            self.keep(level, cx);
        }
    }

    /// Keeps a win; one that was not watched to its end counts all the same.
    pub(super) fn keep(&self, level: usize, cx: &mut Context) {
        if let Some(win) = self.win {
            cx.won(level, win);
        }
    }

    /// What came about: of the goals the first that was missed.
    pub(super) fn in_short(&self) -> Option<String> {
        let findings = &self.verdict.findings;
        let unmet = findings.iter().find(|finding| !finding.met);
        let finding = unmet.or(findings.first())?;
        Some(finding.told.clone())
    }
}
