//! What can be wrong with a shot.

use thiserror::Error;

use crate::numbers::four_figures;

/// Why a shot cannot be played, or not to its end. Discs are numbered from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum EngineError {
    /// Not one motion a disc.
    #[error("{discs} discs but {motions} motions: expected one motion a disc")]
    Count {
        /// How many discs.
        discs: usize,
        /// How many motions.
        motions: usize,
    },
    /// The board has an unusable number.
    #[error("the board's {0}")]
    Board(&'static str),
    /// A disc has an unusable number.
    #[error("disc {disc}: the {expected}")]
    Disc {
        /// Which disc.
        disc: usize,
        /// The quantity and what was expected of it.
        expected: &'static str,
    },
    /// A disc does not lie wholly within the frame.
    #[error("disc {disc} reaches {beyond_mm} mm beyond the frame: expected it on the board")]
    OffBoard {
        /// Which disc.
        disc: usize,
        /// How far beyond, in millimetres.
        beyond_mm: f64,
    },
    /// Two discs overlap.
    #[error("discs {first} and {second} overlap by {depth_mm} mm: expected them apart or touching")]
    Overlap {
        /// One disc.
        first: usize,
        /// The other.
        second: usize,
        /// How far, in millimetres.
        depth_mm: f64,
    },
    /// The horizon is not a time.
    #[error("the horizon must be a number of seconds, at least 0")]
    Horizon,
    /// Nothing would ever stop the discs.
    #[error("without friction discs in a frame never stop: expected a finite horizon")]
    Endless,
    /// The cap on events was reached: the discs have most likely collapsed onto one
    /// another (restitution below 1 and no friction to end it).
    #[error("more than {events} events by {} s: given up", four_figures(*time))]
    TooManyEvents {
        /// The cap.
        events: usize,
        /// Time reached, in seconds.
        time: f64,
    },
    /// The shot took more work than was allowed.
    #[error("more than {work} looks at pairs of discs by {} s: given up", four_figures(*time))]
    TooMuchWork {
        /// How much was allowed, in looks at a pair of discs.
        work: u64,
        /// Time reached, in seconds.
        time: f64,
    },
}
