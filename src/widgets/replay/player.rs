//! Watching a shot, and examining its enlarged impacts individually.

use std::time::Duration;

use glam::DVec2;
use strum::{EnumMessage, IntoStaticStr};

use super::{ShotClock, ShotImpact, WatchRate, impacts};
use crate::messages::Key;
use crate::physics::{DiscState, Shot};
use crate::quiz::Rays;
use crate::widgets::hit::{FRAME, Face, HitPace, Watch, WatchAction};
use crate::widgets::input::{KeyTable, ListAction, ListView, Outcome};

/// The time by which the step keys move the replay, in seconds.
const STEP: f64 = 0.02;
/// The time by which the keys for bigger steps move the replay, in seconds.
const SCRUB: f64 = 0.25;

/// The action that goes to the end of the replay.
const END: ShotAction = ShotAction::Seek(f64::INFINITY);

/// A shot being watched.
#[derive(Debug, Clone)]
pub(crate) struct ShotPlayer {
    shot: Shot,
    clock: ShotClock,
    impacts: Vec<ShotImpact>,
    faces: Vec<Face>,
    said: Option<Rays>,
    lists: bool,
    list: ListView,
    showing: Showing,
    /// The time to return to when the board is shown again.
    left_at: f64,
}

/// The current view of the shot.
#[derive(Debug, Clone)]
enum Showing {
    Board,
    /// The board at the time of the impact that is selected in the list.
    Impacts,
    /// The selected impact on its own, enlarged.
    Impact(Box<Watch>),
}

/// What the keys do while a shot is being watched.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum ShotAction {
    /// go on; while the discs move, skip to the end
    GoOn,
    /// examine the impacts of the shot
    Impacts,
    /// step through the shot
    Step(i8),
    /// move through the shot in bigger steps
    Scrub(i8),
    /// faster or slower, here and for every shot you watch
    Speed(i8),
    /// replay the shot
    Again,
    /// go to the start or the end
    Seek(f64),
    /// choose an impact, and examine it
    List(ListAction),
    /// go to the next impact
    NextImpact(isize),
    /// control the enlarged impact
    Watch(WatchAction),
    /// leave the list of impacts
    Leave,
}

impl ShotPlayer {
    /// Creates a player for a shot; `set_off` is the index of the disc that was shot. Impacts after
    /// the end of the clock are left out.
    pub(crate) fn new(shot: Shot, set_off: usize, clock: ShotClock) -> Self {
        let seen = impacts(&shot, set_off).take_while(|impact| impact.time <= clock.end());
        Self {
            impacts: seen.collect(),
            shot,
            clock,
            faces: Vec::new(),
            said: None,
            lists: false,
            list: ListView::default(),
            showing: Showing::Board,
            left_at: 0.0,
        }
    }

    /// This shot with the given faces for its discs.
    #[must_use]
    pub(crate) fn with_faces(self, faces: Vec<Face>) -> Self {
        Self { faces, ..self }
    }

    /// This shot with a prediction for its first impact.
    #[must_use]
    pub(crate) fn with_said(self, said: Option<Rays>) -> Self {
        Self { said, ..self }
    }

    /// This shot with a list of impacts, from which the player selects an impact to enlarge.
    #[must_use]
    pub(crate) fn with_list(mut self) -> Self {
        self.lists = true;
        self
    }

    pub(crate) fn shot(&self) -> &Shot {
        &self.shot
    }

    pub(crate) fn clock(&self) -> &ShotClock {
        &self.clock
    }

    pub(crate) fn impacts(&self) -> &[ShotImpact] {
        &self.impacts
    }

    /// The selected impact and its index, if there is one.
    pub(crate) fn chosen(&self) -> Option<(usize, &ShotImpact)> {
        if let Showing::Board = self.showing {
            return None;
        }
        let number = self.list.chosen(self.impacts.len());
        Some((number, self.impacts.get(number)?))
    }

    /// The list of impacts, if it is being shown.
    pub(crate) fn list(&self) -> Option<&ListView> {
        matches!(self.showing, Showing::Impacts).then_some(&self.list)
    }

    /// The selected impact, if it is enlarged.
    pub(crate) fn zoom(&self) -> Option<&Watch> {
        match &self.showing {
            Showing::Impact(watch) => Some(watch),
            _ => None,
        }
    }

    /// The discs that are on the board at the current time, with their positions.
    pub(crate) fn discs(&self) -> impl Iterator<Item = (usize, DVec2)> + '_ {
        let now = |disc| self.shot.at(disc, self.clock.time());
        let all = (0..self.shot.discs().len()).map(move |disc| (disc, now(disc)));
        all.filter_map(|(disc, now)| {
            (now.state != DiscState::Pocketed).then_some((disc, now.position))
        })
    }

    /// The keys that control the replay.
    pub(crate) fn keys(&self) -> KeyTable<ShotAction> {
        use ShotAction::{Again, GoOn, Impacts, Leave, NextImpact, Scrub, Seek, Speed, Step};
        let table = KeyTable::new("shot");
        let (over, many) = (self.clock.is_over(), self.impacts.len() > 1);
        let running = self.clock.is_running();
        let go_on = if running { "skip" } else { "go on" };
        let speed = if over { "" } else { "speed" };
        let impacts = if self.lists { "impacts" } else { "impact" };
        match &self.showing {
            Showing::Board => table
                .on(' ', GoOn, go_on)
                .when(!over)
                .on('i', Impacts, impacts)
                .when(!self.impacts.is_empty())
                .on('a', Again, "again")
                .by([',', '.'], Step, [-1, 1], "step")
                .or([(Key::Left, Step(-1)), (Key::Right, Step(1))])
                .by(['<', '>'], Scrub, [-1, 1], "scrub")
                .by(['+', '-'], Speed, [1, -1], speed)
                .called(&["faster", "slower"])
                .or([('=', Speed(1))])
                .each([(Key::Home, Seek(0.0)), (Key::End, END)], ""),
            Showing::Impacts => table
                .with(ListView::keys("look closer"), ShotAction::List)
                .on(Key::Escape, Leave, "back")
                .or([('i', Leave)]),
            Showing::Impact(watch) => table
                .with(watch.keys(), ShotAction::Watch)
                .by([Key::Down, Key::Up], NextImpact, [1, -1], "other impact")
                .or([(Key::BackTab, NextImpact(-1)), (Key::Tab, NextImpact(1))])
                .when(many)
                .on(Key::Escape, Leave, "back")
                .or([Key::Char('i'), Key::Enter].map(|key| (key, Leave)))
                .or(watch.clock().is_over().then_some((' ', Leave))),
        }
    }

    /// The action triggered by clicking the picture: that of the space bar or, in the list of
    /// impacts, none.
    pub(crate) fn clicked(&self) -> Option<ShotAction> {
        match self.showing {
            Showing::Impacts => None,
            _ => self.keys().exact(Key::Char(' ')),
        }
    }

    /// The action triggered by turning the mouse wheel up (-1) or down (1): a step in time, or a
    /// move in the list of impacts.
    pub(crate) fn wheel(&self, by: i8) -> Option<ShotAction> {
        match self.showing {
            Showing::Impacts => Some(ShotAction::List(ListAction::Choose(by.into()))),
            _ => self.keys().exact(Key::Char(if by < 0 { '.' } else { ',' })),
        }
    }

    /// Carries out an action. If the speed changes, it is stored in `rate`; an enlarged impact is
    /// played at this `pace`.
    pub(crate) fn act(&mut self, action: ShotAction, rate: &mut Option<WatchRate>, pace: HitPace) {
        match action {
            ShotAction::GoOn => self.clock.go_on(),
            ShotAction::Step(by) => self.clock.step(STEP * f64::from(by)),
            ShotAction::Scrub(by) => self.clock.step(SCRUB * f64::from(by)),
            ShotAction::Seek(time) => self.clock.seek(time),
            ShotAction::Again => self.clock.rewind(),
            ShotAction::Speed(by) => {
                self.clock.rate = self.clock.rate.faster(by);
                *rate = Some(self.clock.rate);
            }
            ShotAction::Impacts => {
                self.left_at = self.clock.time();
                // This selects the last impact shown so far or, at the end of the replay, the
                // first impact.
                let is_over = self.clock.is_over();
                let now = if is_over { 0.0 } else { self.left_at };
                let seen = self.impacts.partition_point(|impact| impact.time <= now);
                self.list.choose(seen.saturating_sub(1));
                self.showing = Showing::Impacts;
                match self.lists {
                    true => self.show_chosen(),
                    false => self.enlarge(pace),
                }
            }
            ShotAction::List(action) => match self.list.act(action, self.impacts.len()) {
                Outcome::Done(_) => self.enlarge(pace),
                _ => self.show_chosen(),
            },
            ShotAction::NextImpact(by) => {
                self.list.act(ListAction::Choose(by), self.impacts.len());
                self.enlarge(pace);
            }
            ShotAction::Watch(action) => {
                if let Showing::Impact(watch) = &mut self.showing {
                    watch.act(action);
                }
            }
            ShotAction::Leave if self.lists && self.zoom().is_some() => {
                self.showing = Showing::Impacts;
            }
            ShotAction::Leave => {
                self.showing = Showing::Board;
                self.clock.seek(self.left_at);
            }
        }
    }

    /// Sets the clock to the time of the selected impact.
    fn show_chosen(&mut self) {
        if let Some((_, impact)) = self.chosen() {
            self.clock.seek(impact.time);
        }
    }

    fn enlarge(&mut self, pace: HitPace) {
        self.show_chosen();
        if let Some((number, impact)) = self.chosen() {
            let said = self.said.filter(|_| number == 0);
            let [_, coin] = Face::STRIKER_AND_COIN;
            let face = |disc: usize| self.faces.get(disc).copied().unwrap_or(coin);
            let faces = impact.discs.map(face);
            let watch = Watch::new(impact.collision, said, pace).with_faces(faces);
            self.showing = Showing::Impact(Box::new(watch));
        }
    }

    /// Advances by `passed` of screen time.
    pub(crate) fn advance(&mut self, passed: Duration, pace: HitPace) {
        match &mut self.showing {
            Showing::Impact(watch) => watch.advance(passed, pace),
            _ => self.clock.advance(passed),
        }
    }

    /// The time after which the replay has to advance again.
    pub(crate) fn wake(&self, pace: HitPace) -> Option<Duration> {
        match &self.showing {
            Showing::Impact(watch) => watch.wake(pace),
            _ => self.clock.is_running().then_some(FRAME),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Board, Disc, Limits, Motion, play};

    /// A shot with at least two impacts: a disc drives a second disc into a third.
    fn player(lists: bool) -> ShotPlayer {
        let disc = Disc::from_g_mm(15.0, 20.0);
        let mut start = [0.0, 0.1, 0.2].map(|x| Motion::at_rest(DVec2::new(x, 0.1 * x)));
        start[0].velocity = DVec2::new(3.0, 0.0);
        let shot = play(&Board::default(), &[disc; 3], &start, Limits::default()).unwrap();
        let clock = ShotClock::new(shot.duration(), WatchRate::REAL, false);
        let player = ShotPlayer::new(shot, 0, clock);
        assert!(player.impacts().len() >= 2);
        if lists { player.with_list() } else { player }
    }

    fn press(player: &mut ShotPlayer, key: Key) -> Option<WatchRate> {
        let mut rate = None;
        let action = player.keys().find(key).unwrap();
        player.act(action, &mut rate, HitPace::Still);
        rate
    }

    #[test]
    fn a_chosen_speed_is_stored_by_the_caller() {
        let mut player = player(false);
        assert_eq!(press(&mut player, Key::Char(' ')), None);
        let slower = Some(WatchRate::REAL.faster(-1));
        assert_eq!(press(&mut player, Key::Char('-')), slower);
        assert_eq!(Some(player.clock().rate), slower);
    }

    #[test]
    fn after_an_enlarged_impact_the_clock_returns_to_its_time() {
        let mut player = player(false);
        press(&mut player, Key::End);
        let end = player.clock().time();
        press(&mut player, Key::Char('i'));
        assert!(player.zoom().is_some());
        assert_eq!(player.chosen().unwrap().0, 0);
        assert_eq!(player.clock().time(), player.impacts()[0].time);
        press(&mut player, Key::Tab);
        assert_eq!(player.chosen().unwrap().0, 1);
        press(&mut player, Key::Escape);
        assert!(player.zoom().is_none() && player.chosen().is_none());
        assert_eq!(player.clock().time(), end);
    }

    #[test]
    fn impacts_are_listed_on_request() {
        let mut player = player(true);
        press(&mut player, Key::Char('i'));
        assert!(player.list().is_some() && player.zoom().is_none());
        press(&mut player, Key::Down);
        assert_eq!(player.clock().time(), player.impacts()[1].time);
        press(&mut player, Key::Char(' '));
        assert!(player.zoom().is_some());
        press(&mut player, Key::Escape);
        assert_eq!(player.list().unwrap().chosen(9), 1);
        press(&mut player, Key::Escape);
        assert!(player.list().is_none());
        assert_eq!(player.clock().time(), 0.0);
    }

    #[test]
    fn the_wheel_steps_and_a_click_continues_until_the_end() {
        let mut player = player(false);
        assert_eq!(player.wheel(-1), Some(ShotAction::Step(1)));
        assert_eq!(player.clicked(), Some(ShotAction::GoOn));
        press(&mut player, Key::End);
        assert_eq!(player.clicked(), None);
    }

    #[test]
    fn impacts_after_the_end_of_the_clock_are_left_out() {
        let whole = player(false);
        let until = whole.impacts()[0].time;
        let clock = ShotClock::new(until, WatchRate::REAL, false);
        let part = ShotPlayer::new(whole.shot().clone(), 0, clock);
        assert_eq!(part.impacts().len(), 1);
    }
}
