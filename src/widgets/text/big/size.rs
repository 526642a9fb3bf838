//! The sizes of letters in large type.

use super::{BLANK, CAPITAL, HEIGHT, SMALL_LETTER, strokes};
use crate::widgets::Charset;

/// A lower-case letter such as x is legible from the back row if its height is at least the height
/// of the projected picture divided by this number: for example, 5 cm in a picture 1.5 m high, seen
/// from nine metres.
const READ_FROM_THE_BACK: usize = 30;

/// Letters are large enough for a page that has to show everything at once if the height of a
/// capital, or of a row of plain text, is at least the height of the projected picture divided by
/// this number.
const READ_WITH_CARE: usize = 24;

/// The size of letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LetterSize {
    /// Plain text, on pages that have to show everything at once.
    Plain,
    /// Letters made of strokes, in ASCII and for long text only: names and headings are either
    /// larger or in plain type.
    Strokes,
    /// One braille dot for each pixel, in Unicode and for long text.
    Dots,
    /// One cell for a square of four pixels. Only Unicode has this size, because it has characters
    /// for quarters of a cell.
    Small,
    /// One cell for two pixels, one above the other.
    Middle,
    /// Two adjacent cells for each pixel.
    Large,
}

impl LetterSize {
    /// The sizes for long text in a charset, largest first.
    pub(super) const fn of_text(charset: Charset) -> &'static [Self] {
        match charset {
            Charset::Ascii => &[Self::Large, Self::Middle, Self::Strokes],
            Charset::Unicode => &[Self::Large, Self::Middle, Self::Small, Self::Dots],
        }
    }

    /// Whether names and headings can have this size.
    pub(crate) const fn is_of_names(self) -> bool {
        matches!(self, Self::Large | Self::Middle | Self::Small)
    }

    /// The sizes that are legible from the back row on a screen with `screen_rows` rows, largest
    /// first; if there are none, only the largest size.
    pub(crate) fn legible(charset: Charset, screen_rows: u16) -> impl Iterator<Item = Self> {
        let sizes = Self::of_text(charset).iter().enumerate();
        let legible = sizes.filter(move |(i, size)| *i == 0 || size.is_legible(screen_rows));
        legible.map(|(_, size)| *size)
    }

    /// The sizes that are large enough for a page that has to show everything at once, on a screen
    /// with `screen_rows` rows, largest first.
    pub(crate) fn for_one_page(charset: Charset, screen_rows: u16) -> Vec<Self> {
        let sizes = Self::of_text(charset).iter().chain([&Self::Plain]);
        let sizes = sizes.filter(|size| size.is_large_enough(screen_rows));
        sizes.copied().collect()
    }

    /// Whether this size is large enough for a page that has to show everything at once.
    pub(crate) fn is_large_enough(self, screen_rows: u16) -> bool {
        let (parts, per_row) = match self {
            Self::Plain => (1, 1),
            // The first of the three rows of a capital holds only a stroke at its bottom.
            Self::Strokes => (2, 1),
            Self::Dots => (CAPITAL, 4),
            Self::Small | Self::Middle => (CAPITAL, 2),
            Self::Large => (CAPITAL, 1),
        };
        READ_WITH_CARE * parts >= per_row * usize::from(screen_rows)
    }

    /// Whether this size is legible from the back row on a screen with `screen_rows` rows.
    pub(crate) fn is_legible(self, screen_rows: u16) -> bool {
        let (parts, per_row) = self.small_letter();
        READ_FROM_THE_BACK * parts >= per_row * usize::from(screen_rows)
    }

    /// The height of a lower-case letter such as x as a fraction of a row: the numerator and the
    /// denominator. There is a gap between dots, so half a gap is lost both at the top and at the
    /// bottom.
    const fn small_letter(self) -> (usize, usize) {
        match self {
            Self::Plain => (1, 2),
            Self::Strokes => (1, 1),
            Self::Dots => (2 * SMALL_LETTER - 1, 8),
            Self::Small | Self::Middle => (SMALL_LETTER, 2),
            Self::Large => (SMALL_LETTER, 1),
        }
    }

    /// The number of rows that `lines` lines of letters occupy. Lines of braille dots are two empty
    /// dots apart, so that every second line begins in the middle of a row.
    pub(super) const fn rows(self, lines: usize) -> usize {
        match self {
            Self::Plain => lines,
            Self::Dots => 5 * lines / 2,
            Self::Strokes => strokes::ROWS * lines,
            Self::Small | Self::Middle => HEIGHT / 2 * lines,
            Self::Large => HEIGHT * lines,
        }
    }

    /// The number of empty pixels above the letters in the first row of a line, for lines counted
    /// from 0.
    pub(super) const fn pixels_above(self, line: usize) -> usize {
        match self {
            Self::Dots => 2 * (line % 2),
            _ => 0,
        }
    }

    /// The width of a space between two words, in the unit of [`Self::columns`].
    pub(super) const fn blank(self) -> usize {
        match self {
            Self::Plain => 1,
            Self::Strokes => strokes::BLANK,
            Self::Dots | Self::Small | Self::Middle | Self::Large => BLANK,
        }
    }

    /// The number of columns that text of this length occupies. Plain text and strokes are measured
    /// in columns, all other letters in pixels.
    pub(super) const fn columns(self, length: usize) -> usize {
        match self {
            Self::Small | Self::Dots => length.div_ceil(2),
            Self::Middle | Self::Strokes | Self::Plain => length,
            Self::Large => 2 * length,
        }
    }
}
