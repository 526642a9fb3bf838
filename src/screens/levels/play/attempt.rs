//! A shot that was made, being watched.

use crate::levels::{Judgement, Level, Win, judge};
use crate::messages::Key;
use crate::physics::{Event, EventKind, Shot};
use crate::quiz::{Ray, RayGrade, Rays};
use crate::screens::levels::words::face_of;
use crate::widgets::RayInput;
use crate::widgets::hit::Watch;
use crate::widgets::replay::{Impact, ShotClock, WatchRate, impacts};

/// Seconds that the keys for steps go.
const STEP: f64 = 0.02;
/// Seconds that the keys for big steps go.
const SCRUB: f64 = 0.25;

/// What the player said of the first impact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Said {
    /// The rays; one that was not asked for reads as a disc that stays still.
    pub(super) rays: Rays,
    /// Which were asked for.
    asked: [bool; 2],
}

impl Said {
    pub(super) fn of(rays: &RayInput) -> Self {
        Self {
            rays: rays.so_far(),
            asked: Ray::BOTH.map(|ray| rays.asks(ray)),
        }
    }

    /// The rays that were asked for, each with its place in the pair.
    pub(super) fn asked(&self) -> impl Iterator<Item = (usize, Ray)> + use<> {
        let asked = self.asked;
        let both = Ray::BOTH.into_iter().enumerate();
        both.filter(move |(body, _)| asked.get(*body).is_some_and(|asked| *asked))
    }

    /// Both rays, if both were asked for.
    pub(super) fn both(&self) -> Option<Rays> {
        (self.asked == [true; 2]).then_some(self.rays)
    }

    /// Whether all that was asked for is right.
    fn is_right(&self, impact: &Impact) -> bool {
        let truth = Rays::from(&impact.collision.outcome());
        self.asked().all(|(_, ray)| {
            let error = self.rays.apart(&truth, ray);
            RayGrade { error }.is_right()
        })
    }
}

/// One impact, enlarged.
#[derive(Debug, Clone)]
pub(super) struct Zoom {
    /// Its place among the impacts of the shot.
    pub(super) number: usize,
    pub(super) watch: Watch,
}

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

/// A shot that was made.
#[derive(Debug, Clone)]
pub(super) struct Attempt {
    pub(super) shot: Shot,
    pub(super) verdict: Judgement,
    pub(super) impacts: Vec<Impact>,
    pub(super) said: Option<Said>,
    /// How it was won, if it was.
    pub(super) win: Option<Win>,
    pub(super) clock: ShotClock,
    /// Whether it was seen to its end, so that its outcome may be told.
    pub(super) told: bool,
    pub(super) zoom: Option<Zoom>,
}

impl Attempt {
    /// The shot numbered `number`, counted from 1. `to_say`: whether there was
    /// something to say of it.
    pub(super) fn new(
        level: &Level,
        shot: Shot,
        number: u32,
        to_say: bool,
        said: Option<Said>,
        reduced: bool,
    ) -> Self {
        let verdict = judge(level, &shot);
        let end = end(level, &shot);
        let impacts = impacts(&shot, level.scene.stroke.disc);
        let impacts: Vec<_> = impacts.take_while(|impact| impact.time <= end).collect();
        let right = || Some(said?.is_right(impacts.first()?));
        let win = Win {
            shots: number,
            said_right: to_say.then(|| right().unwrap_or(false)),
        };
        // What is seen of the first hit alone is small and near.
        let rate = match level.is_of_the_first_hit() {
            true => WatchRate::QUARTER,
            false => WatchRate::REAL,
        };
        let clock = ShotClock::new(end, rate, reduced);
        Self {
            win: verdict.won().then_some(win),
            verdict,
            impacts,
            said,
            told: clock.is_over(),
            clock,
            shot,
            zoom: None,
        }
    }

    /// The impact that is enlarged.
    pub(super) fn enlarged(&self) -> Option<&Impact> {
        self.impacts.get(self.zoom.as_ref()?.number)
    }

    /// Enlarges an impact; numbers beyond the ends count as the ends.
    fn enlarge(&mut self, level: &Level, number: usize, reduced: bool) {
        let number = number.min(self.impacts.len().saturating_sub(1));
        let Some(impact) = self.impacts.get(number) else {
            return;
        };
        let said = self.said.filter(|_| number == 0).map(|said| said.rays);
        let faces = impact.discs.map(|disc| face_of(&level.scene, disc));
        let watch = Watch::new(impact.collision, said, reduced).with_faces(faces);
        self.clock.seek(impact.time);
        self.zoom = Some(Zoom { number, watch });
    }

    /// Takes a key: time, and the impacts. Says whether it was one of them.
    pub(super) fn update(&mut self, level: &Level, key: Key, reduced: bool) -> bool {
        if let Some(zoom) = &mut self.zoom {
            let number = zoom.number;
            match key {
                Key::Down | Key::Tab => self.enlarge(level, number + 1, reduced),
                Key::Up | Key::BackTab => self.enlarge(level, number.saturating_sub(1), reduced),
                Key::Escape | Key::Enter | Key::Char('i' | 'I') => self.leave_zoom(),
                Key::Char(' ') if zoom.watch.clock().is_over() => self.leave_zoom(),
                _ => return zoom.watch.update(key),
            }
            return true;
        }
        match key {
            Key::Char(' ') => self.clock.go_on(),
            Key::Char(',') | Key::Left => self.clock.step(-STEP),
            Key::Char('.') | Key::Right => self.clock.step(STEP),
            Key::Char('<') => self.clock.step(-SCRUB),
            Key::Char('>') => self.clock.step(SCRUB),
            Key::Home => self.clock.seek(0.0),
            Key::End => self.clock.seek(f64::INFINITY),
            Key::Char('a' | 'A') => self.clock.rewind(),
            Key::Char('+' | '=') => self.clock.set_rate(self.clock.rate().faster(1)),
            Key::Char('-') => self.clock.set_rate(self.clock.rate().faster(-1)),
            Key::Char('i' | 'I') if !self.impacts.is_empty() => {
                // The one last seen; at the end the first, which was aimed at.
                let now = self.clock.time();
                let seen = self.impacts.partition_point(|impact| impact.time <= now);
                let last = seen.saturating_sub(1);
                let number = if self.clock.is_over() { 0 } else { last };
                self.enlarge(level, number, reduced);
            }
            _ => return false,
        }
        self.told |= self.clock.is_over();
        true
    }

    /// Back to the whole board: to the end of what was seen to the end already.
    fn leave_zoom(&mut self) {
        self.zoom = None;
        if self.told {
            self.clock.seek(f64::INFINITY);
        }
    }

    /// Lets time pass on the screen.
    pub(super) fn advance(&mut self, passed: std::time::Duration) {
        match &mut self.zoom {
            Some(zoom) => zoom.watch.advance(passed),
            None => {
                self.clock.advance(passed);
                self.told |= self.clock.is_over();
            }
        }
    }
}
