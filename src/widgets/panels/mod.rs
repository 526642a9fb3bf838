//! What panels tell of one hit: its facts, and what was said of it beside what was true.

mod impact_facts;
mod said_true;

pub(crate) use impact_facts::{impact_angle, masses, offset, separation};
pub(crate) use said_true::said_and_true;
