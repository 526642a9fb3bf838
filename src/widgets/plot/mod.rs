//! Plots: curves, bars and points over two axes with names and units.
//!
//! A [`Plot`] takes everything in the units of its axes, whether they are linear or
//! logarithmic, and is drawn at the end. It can say which values a cell of the screen
//! stands for, so that a point on a curve can be dragged.

mod answers;
mod axis;
mod canvas;
mod ticks;

pub(crate) use answers::{REACH, errors_picture, sureness_picture};
pub(crate) use axis::Axis;
pub(crate) use canvas::Plot;
