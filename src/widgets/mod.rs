//! The drawn things: everything between a number and a cell of the screen.
//!
//! A widget knows how to look, never what a screen or the app is doing. Two
//! choices of the player reach every one of them: the [`Charset`] (which glyphs)
//! and the [`Theme`] (which colours).

pub mod bar;
pub(crate) mod big;
pub(crate) mod board;
pub mod cells;
pub(crate) mod charset;
pub(crate) mod ink;
pub mod keys;
pub(crate) mod panel;
pub(crate) mod panels;
pub mod picture;
pub(crate) mod plot;
pub(crate) mod replay;
pub(crate) mod svg;
pub(crate) mod theme;

pub(crate) mod flow;
pub mod formula;
pub(crate) mod hit;
pub mod input;
mod lines;
mod look;
mod question_picture;
mod scroll;
pub(crate) mod signs;
mod split_layout;
pub mod text;
pub(crate) mod tracks;

pub use charset::Charset;
pub use input::{AnswerInput, NumberEntry, NumberInput, Outcome, RayInput, brief, shown};
pub use lines::{Lines, Spare};
pub use look::Look;
pub use question_picture::{draw_question, question_picture};
pub use scroll::{Scroll, overflow};
pub use split_layout::SplitLayout;
pub use theme::{Depth, Palette, Role, Theme};
