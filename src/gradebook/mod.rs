//! The hand-ins of a class: files from individual pupils, combined.
//!
//! A pupil's [`HandIn`] contains all answers so far, so a later hand-in contains every earlier one.
//! A [`Gradebook`] counts each pupil and each answer once. For a question in a round the first
//! answer counts, because a pupil who plays a round again has seen the right answers.

mod beliefs;
mod gain;
mod hand_in;
mod items;
mod learning;
mod pupils;
mod results;
mod tables;

pub(crate) use beliefs::BeliefCount;
pub use beliefs::beliefs;
pub(crate) use gain::FEWEST;
pub use gain::{NoGain, NormalizedGain};
pub use hand_in::HandIn;
pub(crate) use items::ItemStatistics;
pub use items::items;
pub use learning::{Learning, Matched, learning};
pub use pupils::{Gradebook, Pupil};
pub(crate) use results::{ClassResults, PupilResults};
pub use tables::{beliefs_csv, items_csv, learning_csv, pupils_csv};
