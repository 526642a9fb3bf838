//! The engine: plays a whole shot exactly, from event to event.
//!
//! Friction slows every disc at the same constant rate along its straight path, so between events
//! each position is a quadratic function of time and the next event is the root of a polynomial:
//! linear for a stop, quadratic for cushions, pockets and discs at rest, quartic for two moving
//! discs. There are no time steps, so nothing is missed and nothing overlaps.
//!
//! Only + − × ÷ and √ are used, which IEEE 754 rounds the same way everywhere: every
//! machine and every build plays the same shot bit for bit.

mod body;
mod broad_phase;
mod check;
mod contact;
mod error;
mod frame;
mod grid;
mod impacts;
mod impulse;
mod lanes;
mod play;
mod quartic;
mod schedule;
mod work;

#[cfg(test)]
mod tests;

pub(super) use check::check;
pub(crate) use error::EngineError;

use super::{Board, Disc, Motion, Shot};
use body::Body;
use broad_phase::BroadPhase;
use grid::Grid;
use play::ShotInPlay;
use schedule::Schedule;
use work::Work;

/// The limits for playing a shot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Stop after this many seconds; may be infinite if the shot ends by itself.
    pub(crate) horizon: f64,
    /// Give up with an error after this many events.
    pub events: usize,
    /// Give up with an error after this much work, counted in tests of a pair of discs: a few
    /// nanoseconds each, and the same number on every machine. Unlike the number of events it also
    /// bounds the search for the impulses of many contacts at once, which takes long if masses
    /// differ by many powers of ten.
    pub work: u64,
}

impl Default for Limits {
    /// To the end, with at most 200,000 events and a billion tests of a pair, which take a few
    /// seconds.
    fn default() -> Self {
        Self {
            horizon: f64::INFINITY,
            events: 200_000,
            work: 1_000_000_000,
        }
    }
}

impl Limits {
    /// Up to `horizon` seconds.
    pub fn until(horizon: f64) -> Self {
        Self {
            horizon,
            ..Self::default()
        }
    }
}

/// Plays a shot and returns its record.
///
/// The discs start with the motions `start`, in the same order. On a board with friction the shot
/// ends when all discs are at rest. Without friction it ends at the horizon, or when nothing more
/// can happen on an open sheet.
///
/// # Errors
///
/// If a number is unusable, a disc is off the board or overlaps another, the shot
/// would have no end, or it takes too many events or too much work.
pub fn play(
    board: &Board,
    discs: &[Disc],
    start: &[Motion],
    limits: Limits,
) -> Result<Shot, EngineError> {
    let mut shot = Shot::default();
    Engine::default().play_into(&mut shot, board, discs, start, limits)?;
    Ok(shot)
}

/// An engine that keeps its working memory from shot to shot.
#[derive(Debug, Default, Clone)]
pub struct Engine {
    bodies: Vec<Body>,
    schedule: Schedule,
    grid: Grid,
    broad_phase: BroadPhase,
}

impl Engine {
    /// Plays a shot into a record and reuses its memory, for a search through many shots. See
    /// [`play()`].
    ///
    /// # Errors
    ///
    /// As for [`play()`]. The record then contains the shot up to the error.
    pub fn play_into(
        &mut self,
        shot: &mut Shot,
        board: &Board,
        discs: &[Disc],
        start: &[Motion],
        limits: Limits,
    ) -> Result<(), EngineError> {
        check(board, discs, start, limits)?;
        shot.begin(board, discs, start);
        let deceleration = board.deceleration();
        self.bodies.clear();
        let slides = discs.iter().zip(start);
        self.bodies
            .extend(slides.map(|(disc, &start)| Body::new(disc, start, deceleration)));
        self.schedule.begin(discs.len());
        self.broad_phase.begin(discs.len());
        self.grid.begin(board, discs, start);
        let duration = ShotInPlay {
            board,
            limits,
            bodies: &mut self.bodies,
            schedule: &mut self.schedule,
            grid: &mut self.grid,
            broad_phase: &mut self.broad_phase,
            shot,
            deceleration,
            events: 0,
            work: Work::up_to(limits.work),
        }
        .run()?;
        shot.end(duration);
        Ok(())
    }
}
