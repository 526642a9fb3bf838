//! Learn: the contents, and a chapter being read.

mod check;
mod contents;
mod figure;
mod prose;
mod reading;
mod record;

pub use check::check;
pub(crate) use contents::Contents;
pub use figure::{FigureError, draw_figure};
pub(crate) use reading::Reading;
pub use record::attempt;
