//! What a player has done: every answer ever given, and what follows from them.
//!
//! An [`Attempt`] is one answer with all that is known of it, whatever asked for it.
//! Everything else here is worked out from the attempts of a player, in the order in
//! which they were made, and never stored: a [`Tally`] of any of them, how each
//! [`TopicStanding`] stands, how well [`Confidence`](crate::quiz::Confidence) and answers go
//! together, which [`HeldBelief`]s were held and whether they fade, what is [`Due`] for
//! [`review`](reviews), and what to do next.

mod advice;
mod attempt;
mod beliefs;
mod calendar;
mod calibration;
mod due;
mod export;
mod schedule;
mod summary;
mod tally;
mod topics;
pub(crate) mod words;

pub use advice::advice;
pub use attempt::{Attempt, LESSON};
pub(crate) use attempt::{ROUND, figures_text};
pub use beliefs::{HeldBelief, Trend, beliefs};
pub use calendar::{Calendar, long_day};
pub use calibration::{Calibrated, calibration, calibration_over_time, calibration_words};
pub use due::Due;
pub use export::{csv, json, utc};
pub use schedule::{Review, reviews};
pub use summary::Summary;
pub(crate) use tally::discrimination;
pub use tally::{ENOUGH_ANGLES, Tally, ends_deg, smoothed_errors_deg};
pub use topics::{LATELY, Mastery, TopicStanding, topics};
