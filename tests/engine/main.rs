//! The physics and the levels, without a screen.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod boards;
mod collisions;
mod goals;
mod packs;
mod rare_laws;
mod rims;
mod scenes;
