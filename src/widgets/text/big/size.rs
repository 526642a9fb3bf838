//! The sizes of letters in large type.

use super::{HEIGHT, SMALL_LETTER, strokes};
use crate::widgets::Charset;

/// The back row can read a small letter such as x if its height is at least the picture's height
/// divided by this number: for example 1 cm on a picture 30 cm high, at nine metres.
const READ_FROM_THE_BACK: usize = 30;

/// The size of letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LetterSize {
    /// Letters made of strokes in ASCII, for long text only: names and headings are larger or in
    /// plain type.
    Strokes,
    /// A braille dot for each pixel, in Unicode, for long text.
    Dots,
    /// A cell for a square of four pixels, only in Unicode, which has characters for quarters of a
    /// cell.
    Small,
    /// A cell for two pixels, one above the other.
    Middle,
    /// Two adjacent cells for each pixel.
    Large,
}

impl LetterSize {
    /// The sizes of a charset for long text, the largest first.
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

    /// Whether names and headings may have this size.
    pub(crate) fn is_of_names(self, charset: Charset) -> bool {
        Self::of_name(charset).contains(&self)
    }

    /// The sizes that are legible from the back row on a screen with this many rows, the largest
    /// first; if none is, the largest size.
    pub(crate) fn legible(charset: Charset, screen_rows: u16) -> impl Iterator<Item = Self> {
        let sizes = Self::of_text(charset).iter().enumerate();
        let legible = sizes.filter(move |(i, size)| *i == 0 || size.is_legible(screen_rows));
        legible.map(|(_, size)| *size)
    }

    /// Whether this size is legible from the back row on a screen with this many rows.
    pub(crate) fn is_legible(self, screen_rows: u16) -> bool {
        let (parts, per_row) = self.small_letter();
        READ_FROM_THE_BACK * parts >= per_row * usize::from(screen_rows)
    }

    /// The height of a small letter: a number of parts, and the number of such parts in a row.
    /// There is space around dots, so half a space is lost above and below.
    const fn small_letter(self) -> (usize, usize) {
        match self {
            Self::Strokes => (1, 1),
            Self::Dots => (2 * SMALL_LETTER - 1, 8),
            Self::Small | Self::Middle => (SMALL_LETTER, 2),
            Self::Large => (SMALL_LETTER, 1),
        }
    }

    /// The number of rows that this many lines of letters occupy. There are two empty dots between
    /// lines of dots, so that every second line begins in the middle of a row.
    pub(super) const fn rows(self, lines: usize) -> usize {
        match self {
            Self::Dots => 5 * lines / 2,
            Self::Strokes => strokes::ROWS * lines,
            Self::Small | Self::Middle => HEIGHT / 2 * lines,
            Self::Large => HEIGHT * lines,
        }
    }

    /// The number of empty pixels above the letters in the first row of the line with this number,
    /// from 0.
    pub(super) const fn pixels_above(self, line: usize) -> usize {
        match self {
            Self::Dots => 2 * (line % 2),
            _ => 0,
        }
    }

    /// The number of columns that this many pixels occupy.
    pub(super) const fn columns(self, pixels: usize) -> usize {
        match self {
            Self::Small | Self::Dots => pixels.div_ceil(2),
            Self::Middle | Self::Strokes => pixels,
            Self::Large => 2 * pixels,
        }
    }
}
