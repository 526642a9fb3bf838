//! The reasons why a shot cannot be played.

use thiserror::Error;

use crate::numbers::four_figures;

/// The reason why a shot cannot be played to its end. Discs are numbered from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum EngineError {
    /// The numbers of discs and motions differ.
    #[error("{discs} discs but {motions} motions: expected one motion per disc")]
    Count {
        /// The number of discs.
        discs: usize,
        /// The number of motions.
        motions: usize,
    },
    /// A number that describes the board is unusable.
    #[error("the board's {0}")]
    Board(&'static str),
    /// A number that describes a disc is unusable.
    #[error("disc {disc}: the {expected}")]
    Disc {
        /// The index of the disc.
        disc: usize,
        /// The quantity and its expected range.
        expected: &'static str,
    },
    /// A disc is not completely inside the frame.
    #[error("disc {disc} reaches {beyond_mm} mm beyond the frame: expected it on the board")]
    OffBoard {
        /// The index of the disc.
        disc: usize,
        /// How far the disc reaches beyond the frame, in millimetres.
        beyond_mm: f64,
    },
    /// Two discs overlap.
    #[error("discs {first} and {second} overlap by {depth_mm} mm: expected them apart or touching")]
    Overlap {
        /// The index of the first disc.
        first: usize,
        /// The index of the second disc.
        second: usize,
        /// The overlap, in millimetres.
        depth_mm: f64,
    },
    /// The horizon is negative or not a number.
    #[error("the horizon must be a number of seconds, at least 0")]
    Horizon,
    /// The discs would never stop.
    #[error("without friction, discs in a frame never stop: expected a finite horizon")]
    Endless,
    /// The maximum number of events was reached. The most likely reason is an inelastic collapse
    /// (restitution below 1 and no friction to end it).
    #[error("more than {events} events by {} s: abandoned", four_figures(*time))]
    TooManyEvents {
        /// The maximum number of events.
        events: usize,
        /// The time that was reached, in seconds.
        time: f64,
    },
    /// The shot took more work than permitted.
    #[error("more than {work} tests of pairs of discs by {} s: abandoned", four_figures(*time))]
    TooMuchWork {
        /// The permitted work, measured as the number of tests of a pair of discs.
        work: u64,
        /// The time that was reached, in seconds.
        time: f64,
    },
}
