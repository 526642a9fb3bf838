//! The drawn things: everything between a number and a cell of the screen.
//!
//! A widget knows how to look, never what a screen or the app is doing. Two
//! choices of the player reach every one of them: the [`Charset`] (which glyphs)
//! and the [`Theme`] (which colours).

pub mod bar;
pub mod big;
pub mod board;
pub mod cells;
pub mod charset;
pub mod ink;
pub mod keys;
pub mod panel;
pub(crate) mod panels;
pub mod picture;
pub mod plot;
pub mod replay;
pub mod svg;
pub mod theme;

pub mod flow;
pub mod formula;
pub mod hit;
pub mod input;
mod lines;
mod look;
mod question_picture;
mod scroll;
pub(crate) mod signs;
mod split_layout;
pub mod text;
pub mod tracks;

pub use charset::Charset;
pub use input::{AnswerInput, NumberEntry, NumberInput, Outcome, RayInput, brief, shown};
pub use lines::{Lines, Spare};
pub use look::Look;
pub use question_picture::{draw_question, question_picture};
pub use scroll::{Scroll, overflow};
pub use split_layout::SplitLayout;
pub use theme::{Depth, Palette, Role, Theme};
