//! The families of the quiz over thousands of seeds: the truth is what a computation of its
//! own finds, every misconception is known by its answer, every text can be read.

#[path = "../common/mod.rs"]
mod common;

mod hit;
mod speeds;
mod where_to;
