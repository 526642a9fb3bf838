//! The loop: from event to event until nothing is left to happen.

use glam::DVec2;

use super::super::shot::{Event, EventKind};
use super::super::{Board, Motion};
use super::bodies::Bodies;
use super::contact::contact;
use super::frame::{End, Side, end};
use super::impulse::{Contact, simultaneous, single};
use super::record::Record;
use super::schedule::{Forecast, SAME_TIME, Schedule};
use super::{EngineError, Limits};

/// On a board with friction discs that approach slower than this (m/s) part again as
/// fast as they came, whatever e is: otherwise they could meet infinitely often
/// before friction stops them.
const GENTLE: f64 = 2e-3;

/// On a board with friction a disc that leaves an impact slower than this (m/s) is
/// at rest: it would stop within a hundredth of a micrometre.
const REST: f64 = 1e-4;

/// One shot under way.
pub(super) struct Play<'a, R> {
    pub(super) board: &'a Board,
    pub(super) limits: Limits,
    pub(super) bodies: &'a mut Bodies,
    pub(super) schedule: &'a mut Schedule,
    /// Working memory of the screening of pairs.
    pub(super) margins: &'a mut Vec<f64>,
    pub(super) record: &'a mut R,
    pub(super) deceleration: f64,
    pub(super) events: usize,
}

impl<R: Record> Play<'_, R> {
    /// Plays the shot and returns how long it took, in seconds.
    pub(super) fn run(mut self) -> Result<f64, EngineError> {
        for i in 0..self.bodies.len() {
            self.settle(i, 0.0);
        }
        for i in 0..self.bodies.len() {
            if self.bodies.moving[i] {
                self.end_alone(i);
            }
        }
        for i in 0..self.bodies.len() {
            if self.bodies.moving[i] {
                self.meet_others(i, 0.0);
            }
        }
        let mut last = 0.0;
        while let Some((disc, time)) = self.schedule.first() {
            if time > self.limits.horizon {
                return Ok(self.limits.horizon);
            }
            last = time;
            match self.schedule.forecast(disc) {
                Forecast::Alone(end) => self.finish(disc, time, end),
                Forecast::Meet { partner, version } => {
                    if self.bodies.version[partner] == version {
                        self.impact(disc, partner, time);
                    } else {
                        self.end_alone(disc);
                        self.meet_others(disc, time);
                    }
                }
            }
            if self.events > self.limits.events {
                return Err(EngineError::TooManyEvents {
                    events: self.limits.events,
                    time,
                });
            }
        }
        let drifts = self.bodies.moving.iter().any(|&moving| moving);
        Ok(if drifts && self.limits.horizon.is_finite() {
            self.limits.horizon
        } else {
            last
        })
    }

    /// Forecasts the end of a disc's slide if no other interferes.
    fn end_alone(&mut self, i: usize) {
        let since = self.bodies.since[i];
        let start = self.bodies.at(i, since);
        let (time, end) = end(self.board, self.bodies.radius[i], start);
        self.schedule.set(i, since + time, Forecast::Alone(end));
    }

    /// Forecasts whom a disc meets, for it and for them.
    fn meet_others(&mut self, i: usize, now: f64) {
        self.bodies
            .screen(i, now, self.schedule.times(), self.margins);
        for k in 0..self.bodies.len() {
            if self.margins[k] > 0.0 || k == i {
                continue;
            }
            let known = self.schedule.time(i).min(self.schedule.time(k));
            // A little beyond, so that contacts at the same time are found by both.
            let until = known - now + SAME_TIME;
            if let Some(time) = contact(self.bodies, i, k, now, until) {
                let time = now + time;
                for (disc, partner) in [(i, k), (k, i)] {
                    if time < self.schedule.time(disc) {
                        let version = self.bodies.version[partner];
                        self.schedule
                            .set(disc, time, Forecast::Meet { partner, version });
                    }
                }
            }
        }
    }

    /// Ends a slide that no other disc interfered with.
    fn finish(&mut self, i: usize, time: f64, end: End) {
        let now = self.bodies.at(i, time);
        match end {
            End::Never => return,
            End::Stop => {
                self.launch(i, time, Motion::at_rest(now.position));
                self.event(time, EventKind::Rest { disc: i });
            }
            End::Cushion(side) => self.cushion(i, time, now, side),
            End::Pocket(corner) => {
                self.record
                    .turn(i, time, Motion::at_rest(now.position), true);
                self.event(time, EventKind::Pocket { disc: i, corner });
                self.bodies.remove(i);
                self.end_alone(i);
                return;
            }
        }
        self.settle(i, time);
        self.end_alone(i);
        self.meet_others(i, time);
    }

    fn cushion(&mut self, i: usize, time: f64, now: Motion, side: Side) {
        let wall = 0.5 * self.board.side - self.bodies.radius[i];
        let mut after = now;
        let along = match side {
            Side::Left | Side::Right => &mut after.velocity.x,
            Side::Bottom | Side::Top => &mut after.velocity.y,
        };
        let e = self.restitution(self.board.cushion_restitution, along.abs());
        *along *= -e;
        match side {
            Side::Left => after.position.x = -wall,
            Side::Right => after.position.x = wall,
            Side::Bottom => after.position.y = -wall,
            Side::Top => after.position.y = wall,
        }
        self.launch(i, time, after);
        self.event(
            time,
            EventKind::Cushion {
                disc: i,
                normal: side.normal(),
                before: now.velocity,
                after: after.velocity,
            },
        );
    }

    /// Resolves the contact of two discs, with all others at the same instant that
    /// share a disc with it.
    fn impact(&mut self, i: usize, k: usize, time: f64) {
        let mut pairs = vec![[i.min(k), i.max(k)]];
        self.gather(&mut pairs, time);
        let mut discs: Vec<usize> = pairs.concat();
        discs.sort_unstable();
        discs.dedup();
        let contacts: Vec<Contact> = pairs
            .iter()
            .filter_map(|&pair| self.approaching(pair, time))
            .collect();
        if !contacts.is_empty() {
            self.collide(&contacts, &discs, time);
        }
        for &disc in &discs {
            self.end_alone(disc);
        }
        for &disc in &discs {
            self.meet_others(disc, time);
        }
    }

    /// Adds the pairs that meet at the same time and share a disc with those given,
    /// directly or through others.
    fn gather(&self, pairs: &mut Vec<[usize; 2]>, time: f64) {
        // Whoever meets now is due now; most often these are just the two.
        if self.schedule.until(time + SAME_TIME).count() <= 2 {
            return;
        }
        let mut asked = 0;
        let mut discs = pairs.concat();
        while let Some(&disc) = discs.get(asked) {
            asked += 1;
            for k in 0..self.bodies.len() {
                let pair = [disc.min(k), disc.max(k)];
                if k != disc
                    && !pairs.contains(&pair)
                    && contact(self.bodies, disc, k, time, SAME_TIME).is_some()
                {
                    pairs.push(pair);
                    if !discs.contains(&k) {
                        discs.push(k);
                    }
                }
            }
        }
    }

    fn approaching(&self, discs: [usize; 2], time: f64) -> Option<Contact> {
        let [a, b] = discs.map(|disc| self.bodies.at(disc, time));
        let apart = b.position - a.position;
        let normal = apart / apart.length();
        let approach = (a.velocity - b.velocity).dot(normal);
        (approach > 0.0).then(|| Contact {
            discs,
            normal,
            approach,
            restitution: self.restitution(self.board.restitution, approach),
        })
    }

    fn collide(&mut self, contacts: &[Contact], discs: &[usize], time: f64) {
        let mut motions: Vec<Motion> = discs.iter().map(|&i| self.bodies.at(i, time)).collect();
        let impulses = match contacts {
            [contact] => vec![single(contact, &self.bodies.inverse_mass)],
            _ => simultaneous(contacts, &self.bodies.inverse_mass),
        };
        let place = |disc: usize| discs.partition_point(|&d| d < disc);
        for (contact, impulse) in contacts.iter().zip(impulses) {
            let [a, b] = contact.discs;
            let push = |disc: usize| contact.normal * (impulse * self.bodies.inverse_mass[disc]);
            let before = [motions[place(a)].velocity, motions[place(b)].velocity];
            let after = [before[0] - push(a), before[1] + push(b)];
            motions[place(a)].velocity = after[0];
            motions[place(b)].velocity = after[1];
            self.event(
                time,
                EventKind::Impact {
                    discs: contact.discs,
                    normal: contact.normal,
                    before,
                    after,
                },
            );
        }
        for (&disc, &motion) in discs.iter().zip(&motions) {
            let moved = self.bodies.moving[disc];
            self.launch(disc, time, motion);
            if motion.velocity == DVec2::ZERO && moved {
                self.event(time, EventKind::Rest { disc });
            }
            self.settle(disc, time);
        }
    }

    /// The restitution at a speed of approach in m/s.
    fn restitution(&self, board: f64, approach: f64) -> f64 {
        if self.deceleration > 0.0 && approach < GENTLE {
            1.0
        } else {
            board
        }
    }

    /// Puts a disc to rest that moves too slowly to matter.
    fn settle(&mut self, disc: usize, time: f64) {
        let Motion { position, velocity } = self.bodies.at(disc, time);
        let slow = velocity.length_squared() < REST * REST;
        if self.deceleration > 0.0 && self.bodies.moving[disc] && slow {
            self.launch(disc, time, Motion::at_rest(position));
            self.event(time, EventKind::Rest { disc });
        }
    }

    fn launch(&mut self, disc: usize, time: f64, motion: Motion) {
        self.bodies.launch(disc, time, motion, self.deceleration);
        self.record.turn(disc, time, motion, false);
    }

    fn event(&mut self, time: f64, kind: EventKind) {
        self.record.event(Event { time, kind });
        self.events += 1;
    }
}
