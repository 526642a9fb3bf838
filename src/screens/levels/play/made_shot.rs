//! A shot that was made, and its replay.

use super::LevelPlay;
use crate::levels::{Judgement, Level, Win, judge};
use crate::numbers::capital;
use crate::physics::{Collision, Event, EventKind, Shot};
use crate::progress::{Attempt, LEVEL, Predicted};
use crate::quiz::{Ray, RayGrade, Rays};
use crate::screens::Context;
use crate::screens::levels::words::face_of;
use crate::widgets::RayInput;
use crate::widgets::replay::{ShotAction, ShotClock, ShotPlayer, WatchRate};

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

/// The speed in m/s below which nobody sees a disc move: on the board it stops within half a
/// millimetre. For such a disc, both the prediction that it stays still and its true direction
/// count as right.
const UNSEEN: f64 = 0.03;

/// Whether all predicted rays are right.
fn is_right(said: &RayInput, collision: &Collision) -> bool {
    let outcome = collision.outcome();
    let truth = Rays::from(&outcome);
    asked(said).all(|ray| {
        let speed = [outcome.v1, outcome.v2][ray as usize].length();
        if said.so_far().get(ray).is_none() && speed < UNSEEN {
            return true;
        }
        let error = said.so_far().apart(&truth, ray);
        RayGrade { error }.is_right()
    })
}

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
    /// Whether carrom played the shot to show a solution; such a shot is not a win.
    pub(super) is_shown: bool,
}

impl MadeShot {
    /// The latest shot in `play`; `to_say` says whether a prediction was possible.
    pub(super) fn new(
        play: &LevelPlay,
        shot: Shot,
        to_say: bool,
        said: Option<RayInput>,
        cx: &Context,
    ) -> Self {
        let (level, settings) = (play.level(), &cx.settings);
        let verdict = judge(level, &shot);
        // A first collision alone is over quickly, so its replay is slower.
        let usual = match level.is_of_the_first_hit() {
            true => WatchRate::QUARTER,
            false => WatchRate::REAL,
        };
        let rate = settings.watch_rate.unwrap_or(usual);
        let clock = ShotClock::new(end(level, &shot), rate, settings.reduced_motion);
        let faces = (0..shot.discs().len()).map(|disc| face_of(&level.scene, disc));
        let faces = faces.collect();
        let player = ShotPlayer::new(shot, level.scene.stroke.disc, clock)
            .with_faces(faces)
            .with_said(said.as_ref().map(RayInput::so_far));
        let first = said.as_ref().zip(player.impacts().first());
        let right = first.is_some_and(|(said, impact)| is_right(said, &impact.collision));
        let win = Win {
            shots: play.shots,
            hints: play.hints,
            said_right: to_say.then_some(right),
        };
        Self {
            win: verdict.won().then_some(win),
            verdict,
            said,
            watched: clock.is_over(),
            player,
            is_shown: false,
        }
    }

    /// The player's prediction as an answer, in the level with this number.
    pub(super) fn attempt(&self, level: usize, cx: &Context) -> Option<Attempt> {
        let (said, impact) = (self.said.as_ref()?, self.player.impacts().first()?);
        let (pack, named) = cx.shelf.get(level)?;
        let mut asked = asked(said);
        let predicted = Predicted {
            player: &cx.settings.player,
            family: LEVEL,
            seed: 0,
            number: u32::try_from(level + 1).unwrap_or(u32::MAX),
            only: asked.next().filter(|_| asked.next().is_none()),
        };
        let attempt = Attempt::of_prediction(&predicted, &impact.collision, &said.so_far());
        let mut attempt = attempt?;
        if !attempt.right && is_right(said, &impact.collision) {
            (attempt.right, attempt.credit, attempt.misconception) = (true, 1.0, None);
        }
        let names = [("pack", pack.name.as_str()), ("level", named.id.as_str())];
        let names = names.map(|(name, id)| (name.to_owned(), id.into()));
        attempt.question.extend(names);
        Some(attempt)
    }

    /// Controls the clock, or the replay of an impact.
    pub(super) fn watch(&mut self, action: ShotAction, level: usize, cx: &mut Context) {
        let pace = cx.settings.pace();
        self.player.act(action, &mut cx.settings.watch_rate, pace);
        self.keep_if_watched(level, cx);
    }

    /// Records whether the shot has been watched to its end. If it has, saves a win in the level
    /// with this number.
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

    /// A sentence on the first goal that was missed or, if none was, on the first goal.
    pub(super) fn in_short(&self) -> Option<String> {
        let findings = &self.verdict.findings;
        let unmet = findings.iter().find(|finding| !finding.met);
        let finding = unmet.or(findings.first())?;
        Some(format!("{}.", capital(&finding.text)))
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::physics::Disc;

    /// At α = 0.2° the striker moves on at 4 m/s × sin 0.2° = 0.014 m/s; at α = 2°, at 0.14 m/s.
    #[test]
    fn a_disc_too_slow_to_be_seen_may_be_predicted_to_stay_still() {
        let disc = Disc::from_g_mm(15.0, 15.0);
        let collision = |alpha_deg: f64| {
            Collision::at_angle(disc, disc, 4.0 * DVec2::X, alpha_deg.to_radians())
        };
        let still = Rays {
            striker: None,
            target: Some(0.0),
        };
        let said = RayInput::new(1.0).saying(&still);
        assert!(is_right(&said, &collision(0.2)));
        assert!(!is_right(&said, &collision(2.0)));
        // The disc's true direction is also right; a wrong direction is not.
        let turned = |deg: f64| RayInput::new(1.0).saying(&Rays::new(deg.to_radians(), 0.0));
        assert!(is_right(&turned(89.8), &collision(0.2)));
        assert!(!is_right(&turned(0.0), &collision(0.2)));
    }
}
