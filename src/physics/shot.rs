//! The exact record of a shot: what happened, and where everything was at any time.

use glam::DVec2;
use strum::IntoStaticStr;

use super::impact::kinetic_energy;
use super::{Board, Disc, Motion, Slide};

mod capture;

use capture::StuckPair;

/// Something that happened during a shot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Seconds since the start of the shot.
    pub time: f64,
    /// What happened.
    pub kind: EventKind,
}

/// The kinds of event. Velocities are in m/s.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr)]
#[strum(serialize_all = "snake_case")]
pub enum EventKind {
    /// Two discs collided. Contacts at the same instant are listed one after another; each starts
    /// from the velocities after the previous contact.
    Impact {
        /// The indices of the two discs.
        discs: [usize; 2],
        /// The line of impact: the unit vector from the first centre to the second.
        normal: DVec2,
        /// The velocities before the contact, in the order of `discs`.
        before: [DVec2; 2],
        /// The velocities after the contact, in the same order.
        after: [DVec2; 2],
    },
    /// A disc hit the frame.
    Cushion {
        /// The index of the disc.
        disc: usize,
        /// The unit vector into the cushion.
        normal: DVec2,
        /// The disc's velocity before the event.
        before: DVec2,
        /// The disc's velocity after the event.
        after: DVec2,
    },
    /// A disc fell into a pocket.
    Pocket {
        /// The index of the disc.
        disc: usize,
        /// The corner: 0 lower left, 1 lower right, 2 upper left, 3 upper right.
        corner: usize,
    },
    /// A disc came to rest.
    Rest {
        /// The index of the disc.
        disc: usize,
    },
}

impl EventKind {
    /// The disc of the event and, for an impact, its partner.
    pub fn discs(&self) -> (usize, Option<usize>) {
        match *self {
            Self::Impact { discs: [a, b], .. } => (a, Some(b)),
            Self::Cushion { disc, .. } | Self::Pocket { disc, .. } | Self::Rest { disc } => {
                (disc, None)
            }
        }
    }

    /// The other disc of an impact in which this disc takes part.
    pub(crate) fn partner(&self, disc: usize) -> Option<usize> {
        match self.discs() {
            (a, Some(b)) if a == disc => Some(b),
            (a, Some(b)) if b == disc => Some(a),
            _ => None,
        }
    }
}

/// What a disc is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr)]
#[strum(serialize_all = "snake_case")]
pub enum DiscState {
    /// The disc is moving.
    Moving,
    /// The disc is at rest on the board.
    #[strum(serialize = "rest")]
    Resting,
    /// The disc has fallen into a pocket; its position is where it fell.
    Pocketed,
}

/// A disc at one moment of a shot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Centre in metres.
    pub position: DVec2,
    /// Velocity in m/s; zero unless moving.
    pub velocity: DVec2,
    /// Whether the disc is moving, at rest or in a pocket.
    pub state: DiscState,
}

/// A straight part of a disc's path, from one event of this disc to its next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// When the leg begins, in seconds since the start of the shot.
    pub start: f64,
    /// When the leg ends.
    pub end: f64,
    /// Centre at the start, in metres.
    pub from: DVec2,
    /// Centre at the end.
    pub to: DVec2,
}

/// The start of a new motion of a disc.
#[derive(Debug, Clone, Copy, PartialEq)]
struct LegStart {
    /// The time in seconds since the start of the shot.
    time: f64,
    /// The motion from then on.
    motion: Motion,
    /// Whether the disc fell into a pocket at this time.
    pocketed: bool,
}

/// The exact record of a shot.
///
/// Between its own events each disc slides on a parabola in time, so a few numbers per event give
/// its position at every moment: [`Shot::at`]. Pause, slow motion and rewind only choose other
/// times. A new record is empty; [`Engine::play_into`](super::Engine::play_into) fills it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shot {
    board: Board,
    discs: Vec<Disc>,
    legs: Vec<Vec<LegStart>>,
    events: Vec<Event>,
    duration: f64,
    capture: Option<StuckPair>,
}

impl Shot {
    /// Clears the record, keeps its memory and stores how the next shot starts.
    pub(super) fn begin(&mut self, board: &Board, discs: &[Disc], start: &[Motion]) {
        self.board = *board;
        self.discs.clear();
        self.discs.extend_from_slice(discs);
        self.events.clear();
        self.legs.resize_with(discs.len(), Vec::new);
        for (legs, &motion) in self.legs.iter_mut().zip(start) {
            legs.clear();
            legs.push(LegStart {
                time: 0.0,
                motion,
                pocketed: false,
            });
        }
        self.duration = 0.0;
        self.capture = None;
    }

    /// Records that a disc starts a new motion.
    #[inline]
    pub(super) fn push_leg(&mut self, disc: usize, time: f64, motion: Motion, pocketed: bool) {
        self.legs[disc].push(LegStart {
            time,
            motion,
            pocketed,
        });
    }

    #[inline]
    pub(super) fn push_event(&mut self, event: Event) {
        self.events.push(event);
    }

    /// Replaces the final velocities of two discs that collide once and do not meet again.
    pub(super) fn leave_with(&mut self, velocities: [DVec2; 2]) {
        for (legs, velocity) in self.legs.iter_mut().zip(velocities) {
            if let [_, .., last] = legs.as_mut_slice() {
                last.motion.velocity = velocity;
            }
        }
        for event in &mut self.events {
            if let EventKind::Impact { after, .. } = &mut event.kind {
                *after = velocities;
            }
        }
    }

    pub(super) fn end(&mut self, duration: f64) {
        self.duration = duration;
    }

    /// The board on which the shot was played.
    pub fn board(&self) -> &Board {
        &self.board
    }

    /// The discs, in the order of their numbers.
    pub fn discs(&self) -> &[Disc] {
        &self.discs
    }

    /// Seconds until everything is at rest, or until the horizon if that is earlier. Without
    /// friction and with an infinite horizon, this is the time of the last event.
    pub(crate) fn duration(&self) -> f64 {
        self.duration
    }

    /// All events in the order in which they happened.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The discs that fell into pockets, in order.
    pub(crate) fn fallen(&self) -> impl Iterator<Item = usize> + '_ {
        self.events.iter().filter_map(|event| match event.kind {
            EventKind::Pocket { disc, .. } => Some(disc),
            _ => None,
        })
    }

    /// The initial motion of a disc.
    pub fn start(&self, disc: usize) -> Motion {
        self.legs[disc][0].motion
    }

    /// The state of a disc at a time in seconds. Times before 0 count as the start, times after
    /// `Shot::duration` as the end; at the time of an event, this is the state after the event.
    pub fn at(&self, disc: usize, time: f64) -> Sample {
        let time = time.min(self.duration);
        if let Some(capture) = self.capture.as_ref().filter(|c| time >= c.time) {
            return sample(capture.at(disc, time), false);
        }
        let legs = &self.legs[disc];
        let next = legs.partition_point(|leg| leg.time <= time);
        let leg = &legs[next.saturating_sub(1)];
        let slide = Slide::new(leg.motion, self.board.deceleration());
        sample(slide.at(time - leg.time), leg.pocketed)
    }

    /// The path of a disc as straight legs, for drawing its trail; none for a disc that never
    /// moves. While a pair that sticks rotates, the path is cut into chords of a few degrees.
    pub fn path(&self, disc: usize) -> impl Iterator<Item = Leg> + '_ {
        let legs = &self.legs[disc];
        let capture = self.capture.as_ref();
        let free_until = capture.map_or(self.duration, |pair| pair.time);
        let slides = legs.iter().enumerate().filter_map(move |(i, leg)| {
            let end = legs.get(i + 1).map_or(free_until, |next| next.time);
            let moves = leg.motion.velocity != DVec2::ZERO && end > leg.time;
            moves.then(|| Leg {
                start: leg.time,
                end,
                from: leg.motion.position,
                to: Slide::new(leg.motion, self.board.deceleration())
                    .at(end - leg.time)
                    .position,
            })
        });
        let chords = capture.map(|pair| pair.chords(disc, self.duration));
        slides.chain(chords.into_iter().flatten())
    }

    /// The final state of each disc.
    pub(crate) fn final_states(&self) -> impl Iterator<Item = Sample> + '_ {
        (0..self.discs.len()).map(|disc| self.at(disc, self.duration))
    }

    /// Kinetic energy of all discs on the board at a time, in joules.
    pub(crate) fn energy_at(&self, time: f64) -> f64 {
        match self.capture.as_ref().filter(|c| time >= c.time) {
            Some(capture) => capture.energy,
            None => self.sum_energy(|disc| self.at(disc, time).velocity),
        }
    }

    /// Kinetic energy at the start, before anything has happened, in joules.
    pub fn energy_before(&self) -> f64 {
        self.sum_energy(|disc| self.start(disc).velocity)
    }

    /// Kinetic energy left at the end, in joules.
    pub fn energy_after(&self) -> f64 {
        self.energy_at(self.duration)
    }

    fn sum_energy(&self, velocity: impl Fn(usize) -> DVec2) -> f64 {
        let energy = |(i, disc): (usize, &Disc)| kinetic_energy(disc.mass, velocity(i));
        self.discs.iter().enumerate().map(energy).sum()
    }
}

fn sample(motion: Motion, pocketed: bool) -> Sample {
    let state = if pocketed {
        DiscState::Pocketed
    } else if motion.velocity == DVec2::ZERO {
        DiscState::Resting
    } else {
        DiscState::Moving
    };
    Sample {
        position: motion.position,
        velocity: motion.velocity,
        state,
    }
}
