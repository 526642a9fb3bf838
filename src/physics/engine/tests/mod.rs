//! What the engine must show, against closed forms and conservation laws.

mod known_answers;
mod properties;
mod tables;
