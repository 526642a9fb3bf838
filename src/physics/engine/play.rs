//! The event loop of a shot.

use glam::DVec2;

use super::super::shot::{Event, EventKind};
use super::super::slide::slowed;
use super::super::{Board, Motion, Shot};
use super::body::Body;
use super::broad_phase::{BroadPhase, Scan, Seeker};
use super::contact::contact;
use super::frame::{FrameSide, SlideEnd, end};
use super::grid::Grid;
use super::schedule::{Forecast, SAME_TIME, Schedule};
use super::work::Work;
use super::{EngineError, Limits};

/// On a board with friction, discs whose approach speed is below this value (in m/s) separate at
/// the same speed, regardless of e: otherwise they could collide infinitely often before friction
/// stops them.
const ELASTIC_BELOW: f64 = 2e-3;

pub(super) struct ShotInPlay<'a> {
    pub(super) board: &'a Board,
    pub(super) limits: Limits,
    pub(super) bodies: &'a mut Vec<Body>,
    pub(super) schedule: &'a mut Schedule,
    pub(super) grid: &'a mut Grid,
    pub(super) broad_phase: &'a mut BroadPhase,
    pub(super) shot: &'a mut Shot,
    pub(super) deceleration: f64,
    pub(super) events: usize,
    pub(super) work: Work,
}

impl ShotInPlay<'_> {
    /// Plays the shot, and returns its duration in seconds.
    pub(super) fn run(mut self) -> Result<f64, EngineError> {
        self.set_off();
        let mut last = 0.0;
        while let Some((disc, time)) = self.schedule.first() {
            if time > self.limits.horizon {
                return Ok(self.limits.horizon);
            }
            match self.schedule.forecast(disc) {
                Forecast::Meet { partner, version } if self.bodies[partner].version != version => {
                    self.forecast(&[disc], time);
                }
                Forecast::Meet { partner, .. } => {
                    last = time;
                    self.impact(disc, partner, time);
                }
                Forecast::Alone(end) => {
                    last = time;
                    self.finish(disc, time, end);
                }
            }
            if self.events > self.limits.events {
                return Err(EngineError::TooManyEvents {
                    events: self.limits.events,
                    time,
                });
            }
            if self.work.is_too_much() {
                return Err(EngineError::TooMuchWork {
                    work: self.limits.work,
                    time,
                });
            }
        }
        let drifts = self.bodies.iter().any(|body| body.moving);
        Ok(if drifts && self.limits.horizon.is_finite() {
            self.limits.horizon
        } else {
            last
        })
    }

    fn set_off(&mut self) {
        for i in 0..self.bodies.len() {
            self.forecast_alone(i, 0.0);
        }
        for i in 0..self.bodies.len() {
            if self.bodies[i].moving {
                self.forecast_meetings(i, 0.0, &[]);
            }
        }
    }

    /// Forecasts the next event of each disc that is on a new slide or whose forecast was outdated.
    pub(super) fn forecast(&mut self, discs: &[usize], now: f64) {
        for &disc in discs {
            self.forecast_alone(disc, now);
        }
        for (n, &disc) in discs.iter().enumerate() {
            self.forecast_meetings(disc, now, &discs[..n]);
        }
    }

    /// Forecasts the end of a disc's slide if no other disc interferes.
    fn forecast_alone(&mut self, i: usize, now: f64) {
        let Body {
            start,
            since,
            radius,
            relative_deceleration,
            moving,
            ..
        } = self.bodies[i];
        let (mut time, mut end) = end(self.board, radius, start, relative_deceleration);
        if moving && self.grid.is_laid() {
            let (leaves, side) = self.grid.leaves(i, start);
            if let Some(leaves) = slowed(leaves, relative_deceleration).filter(|&t| t < time) {
                (time, end) = (leaves, SlideEnd::Cell(side));
            }
        }
        let time = since + time;
        self.schedule.set(i, time, Forecast::Alone(end));
        self.broad_phase.expect(i, &self.bodies[i], now, time);
    }

    /// Forecasts the contacts of a disc, for the disc itself and for its partners, except contacts
    /// with discs that have just been compared with it.
    fn forecast_meetings(&mut self, i: usize, now: f64, have_looked: &[usize]) {
        let seeker = Seeker::new(&self.bodies[i], now, self.schedule.time(i));
        let scan = Scan {
            seeker: &seeker,
            disc: i,
            have_looked,
            bodies: self.bodies,
            times: &self.schedule.times,
        };
        let count = self.broad_phase.find(&scan, self.grid, &mut self.work);
        for n in 0..count {
            self.forecast_meeting(&seeker, i, self.broad_phase.partner(n));
        }
    }

    /// Forecasts the contact between the seeker and another disc, unless another known event comes
    /// first.
    fn forecast_meeting(&mut self, seeker: &Seeker, i: usize, k: usize) {
        if !(seeker.moving || self.bodies[k].moving) {
            return;
        }
        let known = self.schedule.time(i).min(self.schedule.time(k));
        // The search goes slightly beyond the known event, so that a contact that coincides with it
        // is also found.
        let until = known - seeker.now + SAME_TIME;
        if let Some(time) = contact(seeker, &self.bodies[k], until) {
            let time = seeker.now + time;
            for (disc, partner) in [(i, k), (k, i)] {
                if time < self.schedule.time(disc) {
                    let version = self.bodies[partner].version;
                    let meet = Forecast::Meet { partner, version };
                    self.schedule.set(disc, time, meet);
                }
            }
        }
    }

    /// Ends a slide in which no other disc interfered.
    fn finish(&mut self, i: usize, time: f64, end: SlideEnd) {
        let now = self.bodies[i].at(time);
        match end {
            SlideEnd::Never => return,
            SlideEnd::Cell(side) => self.grid.cross(i, side),
            SlideEnd::Stop => self.release(i, time, Motion::at_rest(now.position)),
            SlideEnd::Cushion(side) => self.cushion(i, time, now, side),
            SlideEnd::Pocket(corner) => {
                let place = Motion::at_rest(now.position);
                self.shot.push_leg(i, time, place, true);
                self.event(time, EventKind::Pocket { disc: i, corner });
                self.bodies[i].launch(time, off_the_board(i), 0.0);
                self.grid.remove(i);
                return self.forecast_alone(i, time);
            }
        }
        self.forecast(&[i], time);
    }

    fn cushion(&mut self, i: usize, time: f64, now: Motion, side: FrameSide) {
        let wall = 0.5 * self.board.side - self.bodies[i].radius;
        let mut after = now;
        after.position[side.axis] = side.sign() * wall;
        let speed = &mut after.velocity[side.axis];
        *speed *= -self.restitution(self.board.cushion_restitution, speed.abs());
        self.event(
            time,
            EventKind::Cushion {
                disc: i,
                normal: side.normal(),
                before: now.velocity,
                after: after.velocity,
            },
        );
        self.release(i, time, after);
    }

    /// The coefficient of restitution at this approach speed, in m/s.
    pub(super) fn restitution(&self, board: f64, approach: f64) -> f64 {
        if self.deceleration > 0.0 && approach < ELASTIC_BELOW {
            1.0
        } else {
            board
        }
    }

    /// Starts the next slide of a disc after an event.
    pub(super) fn release(&mut self, disc: usize, time: f64, motion: Motion) {
        let moved = self.bodies[disc].moving;
        self.bodies[disc].launch(time, motion, self.deceleration);
        self.shot.push_leg(disc, time, motion, false);
        if moved && motion.velocity == DVec2::ZERO {
            self.event(time, EventKind::Rest { disc });
        }
    }

    pub(super) fn event(&mut self, time: f64, kind: EventKind) {
        self.shot.push_event(Event { time, kind });
        self.events += 1;
    }
}

/// The position to which the engine moves a pocketed disc: out of reach of all other discs, and
/// different for every disc.
fn off_the_board(i: usize) -> Motion {
    Motion::at_rest(DVec2::new(1e9 * (i + 1) as f64, 1e9))
}
