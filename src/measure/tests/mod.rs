//! Tests with simulated measurements.

mod coverage;
mod simulated;
