//! The engine: plays a whole shot exactly, from event to event.
//!
//! Friction slows every disc at the same constant rate along its straight path, so between events
//! each position is a quadratic function of time and the next event is the root of a polynomial:
//! linear for a stop, quadratic for cushions, pockets and discs at rest, quartic for two moving
//! discs. There are no time steps, so nothing is missed and nothing overlaps.
//!
//! The engine uses only + − × ÷ and √, which IEEE 754 rounds in the same way everywhere. Every
//! machine and every build therefore plays the same shot, bit for bit.

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
    /// The time, in seconds, after which the shot stops; it may be infinite if the shot ends by
    /// itself.
    pub(crate) horizon: f64,
    /// The number of events after which the engine gives up with an error.
    pub events: usize,
    /// The amount of work after which the engine gives up with an error, measured as the number of
    /// tests of a pair of discs: each test takes a few nanoseconds, and the number is the same on
    /// every machine. Unlike the number of events, this also limits the search for the impulses of
    /// many simultaneous contacts, which takes a long time if the masses differ by many powers of
    /// ten.
    pub work: u64,
}

impl Default for Limits {
    /// The shot is played to its end, with at most 200,000 events and a billion tests of pairs,
    /// which take a few seconds.
    fn default() -> Self {
        Self {
            horizon: f64::INFINITY,
            events: 200_000,
            work: 1_000_000_000,
        }
    }
}

impl Limits {
    /// Limits the shot to `horizon` seconds.
    pub fn until(horizon: f64) -> Self {
        Self {
            horizon,
            ..Self::default()
        }
    }
}

/// Plays a shot and returns its record.
///
/// The discs start with the motions `start`, in the same order. The shot ends when all discs are at
/// rest, or at the horizon if that is earlier. Without friction and with an infinite horizon, it
/// ends when nothing more can happen.
///
/// # Errors
///
/// Returns an error if a number is unusable, if a disc is off the board or overlaps another disc,
/// if the shot would never end, or if it requires too many events or too much work.
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

/// An engine that keeps its working memory between shots.
#[derive(Debug, Default, Clone)]
pub struct Engine {
    bodies: Vec<Body>,
    schedule: Schedule,
    grid: Grid,
    broad_phase: BroadPhase,
}

impl Engine {
    /// Plays a shot and writes it into an existing record, whose memory is reused. This is useful
    /// for a search through many shots. See [`play()`].
    ///
    /// # Errors
    ///
    /// The errors are those of [`play()`]. If a limit is exceeded, the record contains the shot up
    /// to that moment; after any other error it is unchanged.
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
