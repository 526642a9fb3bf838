//! The drawn things: ink, discs, vectors, panels, prompts; charset and theme.

mod charset;
mod panel;
pub mod text;
mod theme;

pub use charset::Charset;
pub use panel::panel;
pub use theme::{Depth, Palette, Role, Theme};
