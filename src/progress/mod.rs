//! The player's record: all answers, and the conclusions that carrom draws from them.
//!
//! An [`Attempt`] is one answer with everything known about it. Each [`Observation`] and each
//! [`NotedHit`] is stored as well. The conclusions are derived from the attempts of a player, in
//! order, and are never stored: a [`Tally`] of any attempts, the state of each topic, how well
//! [`Confidence`](crate::quiz::Confidence) matches the answers, misconceptions and whether they
//! fade, and what is [`Due`] for review.

mod attempt;
mod beliefs;
mod calendar;
mod calibration;
mod due;
mod export;
mod notebook;
mod observation;
mod prediction;
mod schedule;
mod summary;
mod tally;
mod topics;
pub(crate) mod words;

pub use attempt::{Attempt, LESSON};
pub(crate) use attempt::{REVIEWED_BY, ROUND, figures_text};
pub use beliefs::beliefs;
pub(crate) use beliefs::{HeldBelief, Trend, UnsettledBelief, page_about, unsettled};
pub use calendar::Calendar;
pub(crate) use calendar::long_day;
pub(crate) use calibration::{Calibrated, calibration_over_time};
pub use calibration::{calibration, calibration_words};
pub use due::Due;
pub use export::{csv, json, utc};
pub use notebook::NotedHit;
pub(crate) use notebook::{rays_of_text, rays_text};
pub use observation::{Observation, ObservationCounts, ObservationPlace};
pub(crate) use prediction::Predicted;
pub use prediction::{LEVEL, TABLE};
pub use schedule::Review;
pub(crate) use schedule::reviews;
pub use summary::Summary;
pub use tally::Tally;
pub(crate) use tally::{ENOUGH_ANGLES, discrimination, ends_deg, smoothed_errors_deg};
pub use topics::topics;
pub(crate) use topics::{LATELY, Mastery, TopicStanding};
