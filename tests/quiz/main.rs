//! The quiz without a screen: every family of questions, whole rounds, their codes, and class
//! rounds.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod asked;
mod attributed;
mod class_round;
mod codes;
mod families;
mod find_out;
mod forms;
mod frozen;
mod path;
mod readability;
mod rounds;
#[path = "../../benches/students/mod.rs"]
mod students;
mod working;
