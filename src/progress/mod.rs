//! What a player has done: every answer ever given, and what follows from them.
//!
//! An [`Attempt`] is one answer with all that is known of it, whatever asked for it.
//! Everything else here is worked out from the attempts of a player, in the order in
//! which they were made, and never stored: a [`Tally`] of any of them, how each
//! topic stands, how well [`Confidence`](crate::quiz::Confidence) and answers go
//! together, which beliefs were held and whether they fade, what is [`Due`] for
//! review, and what to do next.

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
pub use beliefs::beliefs;
pub(crate) use beliefs::{HeldBelief, Trend};
pub use calendar::Calendar;
pub(crate) use calendar::long_day;
pub(crate) use calibration::{Calibrated, calibration_over_time};
pub use calibration::{calibration, calibration_words};
pub use due::Due;
pub use export::{csv, json, utc};
pub use schedule::Review;
pub(crate) use schedule::reviews;
pub use summary::Summary;
pub use tally::Tally;
pub(crate) use tally::discrimination;
pub(crate) use tally::{ENOUGH_ANGLES, ends_deg, smoothed_errors_deg};
pub use topics::topics;
pub(crate) use topics::{LATELY, Mastery, TopicStanding};
