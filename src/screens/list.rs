//! Lists of lines one of which is chosen: what keys and the mouse mean to all of them.

use crate::messages::{Input, Key, MouseKind};

/// Lines that a page key goes by.
const PAGE: isize = 10;

/// What an input means to a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Chosen {
    /// Nothing.
    Nothing,
    /// Choose this line, from 0.
    Line(usize),
    /// Open the chosen line.
    Open,
}

/// What an input means to a list of so many lines, of which that `at` is chosen.
/// `line_at` says which line is at a cell, if one is.
pub(super) fn chosen(
    input: &Input,
    at: usize,
    lines: usize,
    line_at: impl FnOnce((u16, u16)) -> Option<usize>,
) -> Chosen {
    let last = lines.saturating_sub(1);
    let by = |by: isize| Chosen::Line(at.saturating_add_signed(by).min(last));
    match input {
        Input::Key(key) => match key {
            Key::Up | Key::BackTab => by(-1),
            Key::Down | Key::Tab => by(1),
            Key::PageUp => by(-PAGE),
            Key::PageDown => by(PAGE),
            Key::Home => by(isize::MIN),
            Key::End => by(isize::MAX),
            Key::Enter | Key::Char(' ') => Chosen::Open,
            _ => Chosen::Nothing,
        },
        Input::Mouse(mouse) => match mouse.kind {
            MouseKind::ScrollUp => by(-1),
            MouseKind::ScrollDown => by(1),
            MouseKind::Down => match line_at((mouse.column, mouse.row)) {
                Some(line) if line == at => Chosen::Open,
                Some(line) => Chosen::Line(line),
                None => Chosen::Nothing,
            },
            _ => Chosen::Nothing,
        },
        _ => Chosen::Nothing,
    }
}

/// The first of so many rows that is shown in a place of this height: the one `at` stands
/// in the middle where there are more rows than that.
pub(super) fn first_shown(at: usize, rows: usize, height: u16) -> usize {
    let height = usize::from(height);
    at.saturating_sub(height / 2)
        .min(rows.saturating_sub(height))
}
