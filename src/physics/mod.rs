//! Discs, one impact, closed forms, frames, scattering, the event-driven engine
//! and the exact record of a shot.
//!
//! This module does not depend on the game, the terminal, a clock or random numbers. It calculates
//! in SI units (m, s, kg, rad); x points right and y up. Body 1 is the striker, body 2 the target;
//! u is a velocity before the impact, v after it.

pub mod angle;
pub mod beam;
mod board;
pub(crate) mod capture;
mod collision;
mod collision_shot;
pub(crate) mod direction;
mod disc;
mod engine;
pub(crate) mod frames;
pub(crate) mod hyperbola;
pub(crate) mod impact;
pub(crate) mod named;
pub(crate) mod resting_target;
pub(crate) mod rims;
pub mod rutherford;
mod shot;
mod slide;
mod spec;
mod spec_link;
pub mod units;
pub(crate) mod worked;

pub use board::{Board, G};
pub(crate) use collision::Meeting;
pub use collision::{Bond, Collision, CollisionOutcome};
pub use disc::{Disc, Motion};
pub(crate) use engine::EngineError;
pub use engine::{Engine, Limits, play};
pub use frames::Frame;
pub use resting_target::RestingTarget;
pub use rims::Rims;
pub(crate) use shot::{DiscState, Sample};
pub use shot::{Event, EventKind, Shot};
pub(crate) use slide::{Slide, stopping_distance};
pub use spec::ImpactPoint;
pub(crate) use spec::{CollisionSpec, FieldRange};
