//! The glyphs that best show a pattern of ink.

pub(super) mod ascii;
pub(super) mod block;
