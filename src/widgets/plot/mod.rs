//! Plots: curves, bars and points over two axes with names and units.
//!
//! A [`Plot`] takes everything in the units of its axes, whether they are linear or
//! logarithmic, and is drawn at the end. It can say which values a cell of the screen
//! stands for, so that a point on a curve can be dragged.
//!
//! ```
//! use carrom::widgets::{Charset, Look, Role, Theme};
//! use carrom::widgets::picture::LabelSide;
//! use carrom::widgets::plot::{Axis, Plot};
//! use glam::dvec2;
//! use ratatui::{buffer::Buffer, layout::Rect};
//!
//! let mut buffer = Buffer::empty(Rect::new(0, 0, 50, 18));
//! let look = Look { charset: Charset::Ascii, theme: Theme::default() };
//! let alpha = Axis::linear("impact angle α (°)", 0.0, 90.0).every(30.0);
//! let speed = Axis::linear("speed / u", 0.0, 1.0).every(0.5);
//! let mut plot = Plot::new(buffer.area, look, alpha, speed);
//! plot.function(|alpha| Some(alpha.to_radians().sin()), Role::StrikerOut);
//! plot.upright(30.0, Role::Aim);
//! plot.mark(dvec2(30.0, 0.5), 'O', Role::Contact);
//! plot.label("v₁ / u", dvec2(60.0, 0.87), &[LabelSide::AboveLeft], Role::StrikerOut);
//! plot.draw(&mut buffer);
//! ```

mod answers;
mod axis;
mod canvas;
mod ticks;

pub(crate) use answers::{REACH, errors_picture, sureness_picture};
pub(crate) use axis::Axis;
pub(crate) use canvas::Plot;
