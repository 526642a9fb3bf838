//! Tests of the engine against closed forms and conservation laws.

mod known_answers;
mod pinned;
mod properties;
mod tables;
