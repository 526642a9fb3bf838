//! The drawn things: everything between a number and a cell of the screen.
//!
//! A widget knows how to look, never what a screen or the app is doing. Two
//! choices of the player reach every one of them: the [`Charset`] (which glyphs)
//! and the [`Theme`] (which colours).

pub mod bar;
pub mod charset;
pub mod ink;
pub mod keys;
pub mod panel;
pub mod theme;

pub use charset::Charset;
pub use theme::{Depth, Palette, Role, Theme};
