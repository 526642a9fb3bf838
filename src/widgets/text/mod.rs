//! Letters in cells: how they are spelt and broken into rows, formulas, large type, bars.

pub(crate) mod areas;
pub mod bar;
pub(crate) mod big;
pub(crate) mod blocks;
pub mod cells;
mod charset;
pub(crate) mod flow;
pub mod formula;
pub mod keys;
mod lines;
mod look;
mod scroll;
pub(crate) mod signs;
mod terms;
mod wrap;

pub use charset::Charset;
pub use lines::{Lines, Spare};
pub use look::Look;
pub use scroll::{Scroll, overflow, scroll_keys};
pub(crate) use scroll::{hint_below, rehearsed};
pub use terms::{held, unbroken};
pub use wrap::{ago, clipped, equation, width, wrap};
