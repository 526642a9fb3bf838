//! The families of the quiz over thousands of seeds: the truth is what a computation of its
//! own finds, every misconception is known by its answer, every text can be read.

#[path = "../common/mod.rs"]
mod common;

mod energy_share;
mod hit;
mod largest_deflection;
mod restitution;
mod separation;
mod speeds;
mod weigh;
mod where_to;
