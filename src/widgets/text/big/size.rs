//! How large the letters of large type are.

use super::{HEIGHT, SMALL_LETTER, strokes};
use crate::widgets::Charset;

/// The back row can read a small letter, such as an x, of at least this share of the picture's
/// height: like 1 cm of 30 cm seen from nine metres.
const READ_FROM_THE_BACK: usize = 30;

/// How large the letters are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LetterSize {
    /// Letters of strokes, in ASCII: for a long text, where names and headings are better
    /// short or plain.
    Strokes,
    /// A dot of braille for each pixel, where there are such: for a long text.
    Dots,
    /// A cell for a square of four pixels; only where there are quarters of cells.
    Small,
    /// A cell for two pixels, one above the other.
    Middle,
    /// Two cells beside each other for each pixel.
    Large,
}

impl LetterSize {
    /// The sizes of a charset for a long text, the largest first.
    pub(super) const fn of_text(charset: Charset) -> &'static [Self] {
        match charset {
            Charset::Ascii => &[Self::Large, Self::Middle, Self::Strokes],
            Charset::Unicode => &[Self::Large, Self::Middle, Self::Small, Self::Dots],
        }
    }

    /// The sizes for a name or a heading.
    pub(super) const fn of_name(charset: Charset) -> &'static [Self] {
        match charset {
            Charset::Ascii => &[Self::Large, Self::Middle],
            Charset::Unicode => &[Self::Large, Self::Middle, Self::Small],
        }
    }

    /// Whether a name or a heading may have it.
    pub(crate) fn is_of_names(self, charset: Charset) -> bool {
        Self::of_name(charset).contains(&self)
    }

    /// The sizes that the back row reads on a screen of so many rows, the largest first; on one
    /// of very many rows the largest there is.
    pub(crate) fn legible(charset: Charset, screen_rows: u16) -> impl Iterator<Item = Self> {
        let sizes = Self::of_text(charset).iter().enumerate();
        let legible = sizes.filter(move |(i, size)| *i == 0 || size.is_legible(screen_rows));
        legible.map(|(_, size)| *size)
    }

    /// Whether the back row reads it on a screen of so many rows.
    pub(crate) fn is_legible(self, screen_rows: u16) -> bool {
        let (parts, per_row) = self.small_letter();
        READ_FROM_THE_BACK * parts >= per_row * usize::from(screen_rows)
    }

    /// The height of a small letter: so many parts, of which a row has so many. Between dots
    /// there is air, of which the upper and the lower half are lost.
    const fn small_letter(self) -> (usize, usize) {
        match self {
            Self::Strokes => (1, 1),
            Self::Dots => (2 * SMALL_LETTER - 1, 8),
            Self::Small | Self::Middle => (SMALL_LETTER, 2),
            Self::Large => (SMALL_LETTER, 1),
        }
    }

    /// Rows of so many lines of letters. Lines of dots have two dots of air between them, so that
    /// the second of two begins in the middle of a row.
    pub(super) const fn rows(self, lines: usize) -> usize {
        match self {
            Self::Dots => 5 * lines / 2,
            Self::Strokes => strokes::ROWS * lines,
            Self::Small | Self::Middle => HEIGHT / 2 * lines,
            Self::Large => HEIGHT * lines,
        }
    }

    /// Pixels above the letters of a line of this number, from 0, in its first row.
    pub(super) const fn pixels_above(self, line: usize) -> usize {
        match self {
            Self::Dots => 2 * (line % 2),
            _ => 0,
        }
    }

    /// Columns of so many pixels.
    pub(super) const fn columns(self, pixels: usize) -> usize {
        match self {
            Self::Small | Self::Dots => pixels.div_ceil(2),
            Self::Middle | Self::Strokes => pixels,
            Self::Large => 2 * pixels,
        }
    }
}
