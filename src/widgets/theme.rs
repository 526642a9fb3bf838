//! Styles by purpose.

use ratatui::style::Style;

/// Colours by purpose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Palette {
    Dark,
    Light,
    Mono,
}

/// How many colours the screen has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Depth {
    None,
    Ansi16,
    Indexed256,
    True,
}

/// What a style is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Role {
    Text,
    Dim,
    Title,
    Key,
    Border,
    Selected,
}

/// Palette and depth together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Theme;

impl Theme {
    /// A theme.
    pub fn new(_: Palette, _: Depth) -> Self {
        Self
    }
    /// The style for `role`.
    pub fn style(&self, _: Role) -> Style {
        Style::default()
    }
}
