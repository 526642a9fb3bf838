//! Blocks of text rows that are combined along a baseline.

use crate::widgets::text;

/// Rows of the same width, one of which is the baseline.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct FormulaBlock {
    pub(super) rows: Vec<String>,
    pub(super) base: usize,
}

impl FormulaBlock {
    /// A single row.
    pub(super) fn line(text: &str) -> Self {
        Self::of([text.to_owned()], 0)
    }

    /// A block of rows with this baseline.
    pub(super) fn of(rows: impl IntoIterator<Item = String>, base: usize) -> Self {
        let mut rows: Vec<_> = rows.into_iter().collect();
        let width = rows.iter().map(|row| text::width(row)).max().unwrap_or(0);
        for row in &mut rows {
            let missing = width - text::width(row);
            row.extend(std::iter::repeat_n(' ', missing));
        }
        Self { rows, base }
    }

    pub(super) fn width(&self) -> usize {
        self.rows.first().map_or(0, |row| text::width(row))
    }

    /// Whether the baseline ends in a letter.
    pub(super) fn ends_with_letter(&self) -> bool {
        let last = self.rows.get(self.base).and_then(|row| row.chars().last());
        last.is_some_and(char::is_alphabetic)
    }

    /// This block, with its last row as the baseline.
    pub(super) fn with_base_at_end(mut self) -> Self {
        self.base = self.rows.len().saturating_sub(1);
        self
    }

    /// This block followed by `right`, both on the same baseline.
    pub(super) fn beside(&self, right: &Self) -> Self {
        if self.rows.is_empty() {
            return right.clone();
        }
        let base = self.base.max(right.base);
        let after = |block: &Self| block.rows.len() - block.base;
        let height = base + after(self).max(after(right));
        let row = |block: &Self, i: usize| {
            let at = (i + block.base).checked_sub(base);
            let row = at.and_then(|at| block.rows.get(at)).cloned();
            row.unwrap_or_else(|| " ".repeat(block.width()))
        };
        Self::of((0..height).map(|i| row(self, i) + &row(right, i)), base)
    }

    /// This block above `under`, both centred; the baseline stays the same.
    pub(super) fn over(&self, under: &Self) -> Self {
        let width = self.width().max(under.width());
        let centred = |row: &String| {
            let left = (width - text::width(row)) / 2;
            " ".repeat(left) + row
        };
        let rows = self.rows.iter().chain(&under.rows).map(centred);
        Self::of(rows, self.base)
    }

    /// This block followed by a superscript above its first row and a subscript below its last row.
    pub(super) fn with_scripts(self, high: Option<&Self>, low: Option<&Self>) -> Self {
        if high.is_none() && low.is_none() {
            return self;
        }
        let nothing = Self::default();
        let (high, low) = (high.unwrap_or(&nothing), low.unwrap_or(&nothing));
        let blank = vec![String::new(); self.rows.len()];
        let rows = high.rows.iter().chain(&blank).chain(&low.rows).cloned();
        let scripts = Self::of(rows, high.rows.len() + self.base);
        self.beside(&scripts)
    }
}
