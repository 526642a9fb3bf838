//! Large type, to be read from the back row.
//!
//! The letters are those of the public-domain font "8x8" (crate `font8x8`), set close
//! together, each pixel a quarter, a half or the whole of two cells. In ASCII half a
//! cell is a quotation mark or a full stop; there the smallest letters are those of
//! `strokes`, for no part of a cell is small enough for a pixel.

mod strokes;

use font8x8::{BASIC_FONTS, GREEK_FONTS, LATIN_FONTS, UnicodeFonts};
use ratatui::{buffer::Buffer, layout::Rect};

use crate::widgets::{Charset, Look, Role, text::blocks::QUARTERS};

/// Pixels between two letters.
const GAP: usize = 1;
/// Pixels of a blank.
const BLANK: usize = 4;
/// Pixels from the top of a letter to its foot.
const HEIGHT: usize = 8;

/// Rows of a line of letters of the usual sizes.
const LINE: u16 = 4;

/// How large the letters are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Size {
    /// Letters of strokes, in ASCII: for a long text, where names and headings are better
    /// short or plain.
    Strokes,
    /// A cell for a square of four pixels; only where there are quarters of cells.
    Small,
    /// A cell for two pixels, one above the other.
    Middle,
    /// Two cells beside each other for each pixel.
    Large,
}

impl Size {
    /// The sizes of a charset for a long text, the largest first.
    const fn of_text(charset: Charset) -> &'static [Self] {
        match charset {
            Charset::Ascii => &[Self::Large, Self::Middle, Self::Strokes],
            Charset::Unicode => Self::of_name(charset),
        }
    }

    /// The sizes for a name or a heading.
    const fn of_name(charset: Charset) -> &'static [Self] {
        match charset {
            Charset::Ascii => &[Self::Large, Self::Middle],
            Charset::Unicode => &[Self::Large, Self::Middle, Self::Small],
        }
    }

    /// Rows of a line of letters.
    const fn rows(self) -> usize {
        match self {
            Self::Strokes => strokes::ROWS,
            Self::Small | Self::Middle => HEIGHT / 2,
            Self::Large => HEIGHT,
        }
    }

    /// Columns of so many pixels.
    const fn columns(self, pixels: usize) -> usize {
        match self {
            Self::Small => pixels.div_ceil(2),
            Self::Middle | Self::Strokes => pixels,
            Self::Large => 2 * pixels,
        }
    }
}

/// Where a text stands in its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Align {
    /// At the left.
    Left,
    /// In the middle.
    Centre,
    /// At the right.
    Right,
}

/// A text in large type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Big {
    size: Size,
    /// The rows of cells of each line.
    lines: Vec<Vec<Vec<char>>>,
}

impl Big {
    /// A name or a heading as large as it fits into so many columns and rows, broken at
    /// blanks; `None` if it does not fit at all or has letters that there are no large ones
    /// of.
    #[must_use]
    pub(crate) fn fit(text: &str, columns: u16, rows: u16, charset: Charset) -> Option<Self> {
        let fits = |all: &[Self]| all.iter().all(|it| it.rows() <= rows);
        let sizes = Size::of_name(charset);
        Self::of_one_size(&[text], sizes, columns, charset, fits)?.pop()
    }

    /// Long texts in letters of one size, as large as they fit below each other with
    /// `gap` rows between any two; `None` as for one.
    #[must_use]
    pub(crate) fn fit_all(
        texts: &[&str],
        gap: u16,
        columns: u16,
        rows: u16,
        charset: Charset,
    ) -> Option<Vec<Self>> {
        let fits = |all: &[Self]| {
            let gaps = gap.saturating_mul(all.len().saturating_sub(1) as u16);
            let high = all
                .iter()
                .fold(gaps, |sum, it| sum.saturating_add(it.rows()));
            high <= rows
        };
        Self::of_one_size(texts, Size::of_text(charset), columns, charset, fits)
    }

    /// Several names in letters of one size, each in one line of at most four rows;
    /// `None` as for one.
    #[must_use]
    pub(crate) fn fit_lines(texts: &[&str], columns: u16, charset: Charset) -> Option<Vec<Self>> {
        let fits = |all: &[Self]| all.iter().all(|it| it.rows() <= LINE);
        Self::of_one_size(texts, Size::of_name(charset), columns, charset, fits)
    }

    /// The texts in the largest letters with which they are narrow enough and `fit`.
    fn of_one_size(
        texts: &[&str],
        sizes: &[Size],
        columns: u16,
        charset: Charset,
        fit: impl Fn(&[Self]) -> bool,
    ) -> Option<Vec<Self>> {
        let texts: Vec<_> = texts.iter().map(|text| charset.text(text)).collect();
        let set = |size: &Size| -> Option<Vec<Self>> {
            let each = texts.iter().map(|text| {
                Some(Self {
                    size: *size,
                    lines: set(text, *size, columns.into(), charset)?,
                })
            });
            each.collect()
        };
        sizes.iter().filter_map(set).find(|all| fit(all))
    }

    /// The columns it takes.
    #[must_use]
    pub(crate) fn columns(&self) -> u16 {
        let widest = self.lines.iter().map(|line| width(line)).max().unwrap_or(0);
        u16::try_from(widest).unwrap_or(u16::MAX)
    }

    /// The rows it takes.
    #[must_use]
    pub(crate) fn rows(&self) -> u16 {
        u16::try_from(self.size.rows() * self.lines.len()).unwrap_or(u16::MAX)
    }

    /// Draws it at the top of an area.
    pub(crate) fn draw(&self, area: Rect, buf: &mut Buffer, look: &Look, role: Role, align: Align) {
        let style = look.theme.style(role);
        for (i, line) in self.lines.iter().enumerate() {
            let free = usize::from(area.width).saturating_sub(width(line));
            let start = match align {
                Align::Left => 0,
                Align::Centre => free / 2,
                Align::Right => free,
            };
            for (row, cells) in line.iter().enumerate() {
                let y = i * self.size.rows() + row;
                for (column, symbol) in cells.iter().enumerate() {
                    let x = start + column;
                    if x >= area.width.into() || y >= area.height.into() {
                        continue;
                    }
                    let at = (area.x + x as u16, area.y + y as u16);
                    if *symbol != ' '
                        && let Some(cell) = buf.cell_mut(at)
                    {
                        cell.set_char(*symbol).set_style(style);
                    }
                }
            }
        }
    }
}

/// Columns of a line.
fn width(line: &[Vec<char>]) -> usize {
    line.first().map_or(0, Vec::len)
}

/// The cells of the lines of a text; `None` if a word is too long for any line, or a
/// letter is not to be had.
fn set(text: &str, size: Size, columns: usize, charset: Charset) -> Option<Vec<Vec<Vec<char>>>> {
    if size == Size::Strokes {
        let lines = strokes::set(text, columns)?;
        return Some(lines.into_iter().map(Vec::from).collect());
    }
    let lines = broken(&words(text)?, size, columns)?;
    let cells = |line: &Vec<u8>| {
        let row = |row| {
            let columns = 0..size.columns(line.len());
            columns
                .map(|column| symbol(line, column, row, size, charset))
                .collect()
        };
        (0..size.rows()).map(row).collect()
    };
    Some(lines.iter().map(cells).collect())
}

/// What stands in a cell of a line of pixels.
fn symbol(line: &[u8], column: usize, row: usize, size: Size, charset: Charset) -> char {
    let pixel = |x: usize, y: usize| line.get(x).is_some_and(|it| it >> y & 1 == 1);
    let halves = |x, y| usize::from(pixel(x, y)) | usize::from(pixel(x, y + 1)) << 1;
    match (size, charset) {
        (Size::Large, _) if !pixel(column / 2, row) => ' ',
        (Size::Large, Charset::Ascii) => '#',
        (Size::Large, Charset::Unicode) => '█',
        (Size::Middle, Charset::Ascii) => [' ', '"', '.', '#'][halves(column, 2 * row)],
        (Size::Middle, Charset::Unicode) => [' ', '▀', '▄', '█'][halves(column, 2 * row)],
        (Size::Small | Size::Strokes, _) => {
            let (x, y) = (2 * column, 2 * row);
            let quarters = [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)];
            let bits = quarters.into_iter().enumerate();
            let index: usize = bits
                .map(|(bit, (x, y))| usize::from(pixel(x, y)) << bit)
                .sum();
            QUARTERS[index]
        }
    }
}

/// The columns of pixels of each word; `None` where a letter has none.
fn words(text: &str) -> Option<Vec<Vec<u8>>> {
    let words = text.split_whitespace().map(|word| {
        let mut columns = Vec::new();
        for letter in word.chars() {
            let pixels = letter_columns(letter)?;
            if !columns.is_empty() {
                columns.extend([0; GAP]);
            }
            columns.extend(pixels);
        }
        Some(columns)
    });
    words.collect()
}

/// The words in lines; `None` if one is too long for any line.
fn broken(words: &[Vec<u8>], size: Size, columns: usize) -> Option<Vec<Vec<u8>>> {
    let mut lines: Vec<Vec<u8>> = Vec::new();
    for word in words {
        if size.columns(word.len()) > columns {
            return None;
        }
        match lines.last_mut() {
            Some(line) if size.columns(line.len() + BLANK + word.len()) <= columns => {
                line.extend([0; BLANK]);
                line.extend(word);
            }
            _ => lines.push(word.clone()),
        }
    }
    Some(lines)
}

/// The columns of pixels of a letter, without the empty ones beside it; `None` if the
/// font has no such letter.
fn letter_columns(letter: char) -> Option<Vec<u8>> {
    if letter.is_control() {
        return None;
    }
    let rows = BASIC_FONTS
        .get(letter)
        .or_else(|| LATIN_FONTS.get(letter))
        .or_else(|| GREEK_FONTS.get(letter))
        .or_else(|| {
            // What stands for it in ASCII, if that is a letter and not a riddle.
            let text = letter.to_string();
            let plain = Charset::Ascii.text(&text);
            let mut plain = plain.chars();
            match (plain.next(), plain.next()) {
                (Some('?'), _) => None,
                (Some(plain), None) => BASIC_FONTS.get(plain),
                _ => None,
            }
        })?;
    let column = |x: usize| {
        let bits = rows.iter().enumerate();
        bits.fold(0, |column, (y, row)| column | (row >> x & 1) << y)
    };
    let columns: Vec<u8> = (0..HEIGHT).map(column).collect();
    let first = columns.iter().position(|it| *it != 0)?;
    let last = columns.iter().rposition(|it| *it != 0)?;
    Some(columns[first..=last].to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::widgets::cells::text;
    use crate::widgets::{Depth, Palette, Theme};

    fn drawn(words: &str, columns: u16, rows: u16, charset: Charset) -> Option<String> {
        let big = Big::fit(words, columns, rows, charset)?;
        let mut buf = Buffer::empty(Rect::new(0, 0, big.columns(), big.rows()));
        let look = Look {
            charset,
            theme: Theme::new(Palette::Dark, Depth::None),
        };
        big.draw(buf.area, &mut buf, &look, Role::Title, Align::Left);
        Some(text(&buf))
    }

    #[test]
    fn letters_in_both_charsets() {
        assert_eq!(
            drawn("Question 3", 79, 4, Charset::Ascii).unwrap(),
            r###".#""#.                        .#    ""                   .#""#.
##  ## ##  ##  .#""#. .#"""" "##"" "##  .#""#. ##""#.      ..#"
"#.##" ##  ##  ##""""  """#.  ## .  ##  ##  ## ##  ##    ..  ##
   """  """ ""  """"  """""    ""  """"  """"  ""  ""     """"
"###
        );
        assert_eq!(
            drawn("Question 3 40°", 79, 4, Charset::Unicode).unwrap(),
            "\
▟▀▙            ▟  ▀         ▗▛▜▖  ▗█▌▗▛▀▙▗▛▙
█ █▐▌▐▌▗▛▜▖▟▀▀▝█▀▝█ ▟▀▙▐▛▜▖  ▗▟▘ ▗▛▐▌▐▌▟█▝▙▛
▜▟▛▐▌▐▌▐▛▀▘▝▀▙ █▗ █ █ █▐▌▐▌ ▗▖▐▌ ▝▀▜▛▐█▘█
 ▝▀ ▀▘▀ ▀▀ ▀▀▘ ▝▘▝▀▘▝▀▘▝▘▝▘  ▀▀    ▀▀ ▀▀▘
"
        );
    }

    #[test]
    fn as_large_as_it_fits_and_not_at_all_where_it_does_not() {
        let size = |columns, rows, charset| Some(Big::fit("Scores", columns, rows, charset)?.size);
        assert_eq!(size(300, 8, Charset::Ascii), Some(Size::Large));
        assert_eq!(size(60, 8, Charset::Ascii), Some(Size::Middle));
        assert_eq!(size(30, 8, Charset::Ascii), None);
        let text = |columns| {
            let all = Big::fit_all(&["Scores"], 0, columns, 8, Charset::Ascii)?;
            Some(all[0].size)
        };
        assert_eq!(text(30), Some(Size::Strokes));
        assert_eq!(text(15), None);
        assert_eq!(size(30, 8, Charset::Unicode), Some(Size::Small));
        assert_eq!(size(300, 3, Charset::Unicode), None);
        assert_eq!(Big::fit("蟻 ants", 300, 100, Charset::Unicode), None);
        assert!(Big::fit("40° at α, 2 − 1", 300, 100, Charset::Unicode).is_some());
    }

    #[test]
    fn any_text_at_any_size_stays_within_its_place() {
        let texts = ["", "a", "Question 10 of 10", "Õ~\u{202e}", "\n", "é\u{301}"];
        for text in texts {
            for charset in [Charset::Ascii, Charset::Unicode] {
                for columns in 0..90 {
                    for rows in 0..20 {
                        if let Some(big) = Big::fit(text, columns, rows, charset) {
                            assert!(big.columns() <= columns && big.rows() <= rows, "{text}");
                        }
                    }
                }
            }
        }
    }
}
