//! Plots: curves, bars and points over two axes with names and units.
//!
//! The coordinates of a [`Plot`] are in the units of its axes, which are linear or logarithmic. A
//! plot also converts a cell of the screen to values, so that a point on a curve can be dragged.

mod answers;
mod axis;
mod canvas;
mod ticks;

pub(crate) use answers::{REACH, errors_picture, sureness_picture};
pub(crate) use axis::Axis;
pub(crate) use canvas::Plot;
