//! Large type, which is legible from the back row of a class.
//!
//! The letters are those of the public-domain font "8x8" (crate `font8x8`), set close together. A
//! pixel is an eighth (a braille dot), a quarter or half of a cell, or two cells. In ASCII, half a
//! cell is a quotation mark or a full stop, and the smallest letters are those of `strokes`,
//! because there are no smaller parts of a cell. In Unicode, the smallest letters have a braille
//! dot for each pixel.

mod letters;
mod measured;
mod pages;
mod size;
mod strokes;

use std::ops::Range;
use std::rc::Rc;

use ratatui::{buffer::Buffer, layout::Rect};

use crate::widgets::text::blocks::{QUARTERS, braille};
use crate::widgets::{Charset, Look, Role, areas, text};
use letters::pixels_of;
pub(crate) use measured::BigText;
pub(crate) use pages::{BigPages, BigParagraph};
pub(crate) use size::LetterSize;

/// The number of pixels between two letters.
const GAP: usize = 1;
/// The width of a space between two words, in pixels.
const BLANK: usize = 4;
/// The height of a letter, in pixels.
const HEIGHT: usize = 8;
/// The height of a capital, in pixels.
const CAPITAL: usize = 7;
/// The height of a lower-case letter such as x, in pixels.
const SMALL_LETTER: usize = 5;

/// The horizontal alignment of text in its area.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Align {
    Left,
    /// Centred.
    Centre,
    Right,
}

/// Text in large type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Big {
    text: Rc<BigText>,
    size: LetterSize,
    lines: Vec<BigLine>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
struct BigLine {
    words: Range<usize>,
    columns: usize,
    /// The rows of the line, counted from the top of the text. Lines of strokes may share rows.
    rows: Range<usize>,
    /// The number of rows at the top that are left out.
    left_out: usize,
}

impl Big {
    /// Sets a name or a heading in the largest letters that fit into `columns` columns and `rows`
    /// rows, broken at spaces; `None` if the text does not fit at all or contains letters without a
    /// large form.
    pub(crate) fn fit(text: &str, columns: u16, rows: u16, charset: Charset) -> Option<Self> {
        Self::fit_all(&[text], columns, rows, charset)?.pop()
    }

    /// Sets several names in letters of the same size, each in this many columns and rows; `None`
    /// in the same cases as for [`Self::fit`].
    pub(crate) fn fit_all(
        texts: &[&str],
        columns: u16,
        rows: u16,
        charset: Charset,
    ) -> Option<Vec<Self>> {
        let texts = { texts.iter() }.map(|text| Rc::new(BigText::new(text, charset)));
        let texts: Vec<_> = texts.collect();
        let sizes = LetterSize::of_text(charset).iter();
        sizes.filter(|size| size.is_of_names()).find_map(|size| {
            let set = |text| Self::set(text, *size, columns).filter(|big| big.rows() <= rows);
            texts.iter().map(set).collect()
        })
    }

    /// Sets text in lines of `columns` columns, broken between words but, if possible, not between
    /// a number and its unit; `None` if a word is too long for a line, or any letter has no large
    /// form.
    fn set(text: &Rc<BigText>, size: LetterSize, columns: u16) -> Option<Self> {
        Self::begin(text, 0, size, (columns, u16::MAX), false)
            .filter(|big| big.words() == text.len())
    }

    /// Sets the text from the word at index `from` on, up to the first word that is too long for a
    /// line of `columns` columns, or up to and including the first line that does not fit into
    /// `rows` rows. `at_top` means that the text is at the top of a page, without an empty row
    /// above.
    fn begin(
        text: &Rc<BigText>,
        from: usize,
        size: LetterSize,
        (columns, rows): (u16, u16),
        at_top: bool,
    ) -> Option<Self> {
        let mut big = Self {
            text: Rc::clone(text),
            size,
            lines: Vec::new(),
        };
        let (mut end, mut above) = (0, None);
        for (number, words) in (0..).zip(text.lines(from, size, columns.into())?) {
            if end > rows.into() {
                break;
            }
            let (rows, left_out) = match size {
                LetterSize::Strokes => {
                    let ink = text.strokes(words.clone())?;
                    let (start, left_out) = match big.lines.last().zip(above) {
                        None => (0, strokes::empty_rows(&ink).min(usize::from(at_top))),
                        Some((line, above)) => {
                            let apart = strokes::apart(&above, &ink);
                            (line.rows.start + apart - line.left_out, 0)
                        }
                    };
                    let end = start + strokes::rows_of(&ink) - left_out;
                    above = Some(ink);
                    (start..end, left_out)
                }
                _ => (size.rows(number)..size.rows(number + 1), 0),
            };
            end = rows.end;
            big.lines.push(BigLine {
                columns: text.columns(words.clone(), size)?,
                words,
                rows,
                left_out,
            });
        }
        Some(big)
    }

    /// The number of words.
    fn words(&self) -> usize {
        self.lines.iter().map(|line| line.words.len()).sum()
    }

    /// The number of lines that fit into a given number of rows.
    fn lines_in(&self, rows: u16) -> usize {
        let fits = |line: &&BigLine| line.rows.end <= rows.into();
        self.lines.iter().take_while(fits).count()
    }

    pub(crate) fn columns(&self) -> u16 {
        let widest = self.lines.iter().map(|line| line.columns).max();
        u16::try_from(widest.unwrap_or(0)).unwrap_or(u16::MAX)
    }

    pub(crate) fn rows(&self) -> u16 {
        let end = self.lines.last().map_or(0, |line| line.rows.end);
        u16::try_from(end).unwrap_or(u16::MAX)
    }

    /// Draws the text at the top of an area.
    pub(crate) fn draw(&self, area: Rect, buf: &mut Buffer, look: &Look, role: Role, align: Align) {
        let style = look.theme.style(role);
        for (number, line) in self.lines.iter().enumerate() {
            let free = usize::from(area.width).saturating_sub(line.columns);
            let start = match align {
                Align::Left => 0,
                Align::Centre => free / 2,
                Align::Right => free,
            };
            let rows = self.symbols(number, line, look.charset).unwrap_or_default();
            for (row, y) in rows.iter().zip(line.rows.clone()) {
                let [_, place] = areas::upper(area, y as u16);
                let mut column = start;
                // Lines of strokes may share rows, so the spaces of large letters are left out.
                let is_blank = |c| c == ' ' && self.size != LetterSize::Plain;
                for letters in row.split_inclusive(is_blank) {
                    let [_, place] = areas::left(place, column as u16);
                    let place = place.intersection(buf.area);
                    if !place.is_empty() {
                        let (letters, room) = (letters.trim_end_matches(' '), place.width.into());
                        buf.set_stringn(place.x, place.y, letters, room, style);
                    }
                    column += text::width(letters);
                }
            }
        }
    }

    /// The rows of characters that make up a line, whose number is counted from 0.
    fn symbols(&self, number: usize, line: &BigLine, charset: Charset) -> Option<Vec<String>> {
        let words = line.words.clone();
        let rows = line.left_out..line.left_out + line.rows.len();
        Some(match self.size {
            LetterSize::Plain => vec![self.text.plain(words)],
            LetterSize::Strokes => {
                let strokes = self.text.strokes(words)?;
                strokes[rows]
                    .iter()
                    .map(|row| row.iter().collect())
                    .collect()
            }
            size => {
                let pixels = self.text.pixels(words)?;
                let above = size.pixels_above(number);
                let symbol = |row, column| symbol(&pixels, column, row, above, size, charset);
                rows.map(|row| {
                    (0..line.columns)
                        .map(|column| symbol(row, column))
                        .collect()
                })
                .collect()
            }
        })
    }
}

/// The character for a cell in a line of pixels, with `above` empty pixels above the letters.
fn symbol(
    line: &[u8],
    column: usize,
    row: usize,
    above: usize,
    size: LetterSize,
    charset: Charset,
) -> char {
    let pixel = |x: usize, y: usize| line.get(x).is_some_and(|it| y < HEIGHT && it >> y & 1 == 1);
    let halves = |x, y| usize::from(pixel(x, y)) | usize::from(pixel(x, y + 1)) << 1;
    match (size, charset) {
        (LetterSize::Large, _) if !pixel(column / 2, row) => ' ',
        (LetterSize::Large, Charset::Ascii) => '#',
        (LetterSize::Large, Charset::Unicode) => '█',
        (LetterSize::Middle, Charset::Ascii) => [' ', '"', '.', '#'][halves(column, 2 * row)],
        (LetterSize::Middle, Charset::Unicode) => [' ', '▀', '▄', '█'][halves(column, 2 * row)],
        (LetterSize::Dots, _) => {
            let dots = (0..8).filter(|dot| {
                let y = (4 * row + dot / 2).checked_sub(above);
                y.is_some_and(|y| pixel(2 * column + dot % 2, y))
            });
            match dots.fold(0, |bits, dot| bits | 1 << dot) {
                0 => ' ',
                bits => braille(bits),
            }
        }
        (LetterSize::Small | LetterSize::Strokes | LetterSize::Plain, _) => {
            let quarters = (0..4).filter(|at| pixel(2 * column + at % 2, 2 * row + at / 2));
            QUARTERS[quarters.fold(0, |bits, at| bits | 1 << at)]
        }
    }
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
            ..Look::default()
        };
        big.draw(buf.area, &mut buf, &look, Role::Title, Align::Left);
        Some(text(&buf))
    }

    #[test]
    fn letters_are_drawn_in_both_charsets() {
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
    fn a_text_is_as_large_as_possible_or_none_if_it_does_not_fit() {
        let size = |columns, rows, charset| Some(Big::fit("Scores", columns, rows, charset)?.size);
        assert_eq!(size(300, 8, Charset::Ascii), Some(LetterSize::Large));
        assert_eq!(size(60, 8, Charset::Ascii), Some(LetterSize::Middle));
        assert_eq!(size(30, 8, Charset::Ascii), None);
        assert_eq!(size(30, 8, Charset::Unicode), Some(LetterSize::Small));
        assert_eq!(size(300, 3, Charset::Unicode), None);
        assert_eq!(Big::fit("蟻 ants", 300, 100, Charset::Unicode), None);
        assert!(Big::fit("40° at α, 2 − 1", 300, 100, Charset::Unicode).is_some());
    }

    #[test]
    fn lines_of_dots_have_space_between_them() {
        let pages = |rows| {
            let room = [(30, rows), (30, rows)];
            let paragraph = BigParagraph {
                text: BigText::new("One coin and two", Charset::Unicode).into(),
                whole: true,
                size: LetterSize::Dots,
                gap: 0,
            };
            BigPages::set(&[paragraph], room, usize::MAX)
        };
        let look = Look {
            charset: Charset::Unicode,
            theme: Theme::new(Palette::Dark, Depth::None),
            ..Look::default()
        };
        let shown = |rows: u16, page| {
            let mut buf = Buffer::empty(Rect::new(0, 0, 30, rows));
            let pages = pages(rows).unwrap();
            for part in pages.page(page) {
                let [area, _] = part.split(buf.area);
                part.big
                    .draw(area, &mut buf, &look, Role::Title, Align::Left);
            }
            (pages.count(), text(&buf))
        };
        // The second line begins in the middle of a row.
        let (count, both) = shown(5, 0);
        assert_eq!((count, both.lines().count()), (1, 5));
        let (count, first) = shown(4, 0);
        assert_eq!(count, 2);
        assert_eq!(
            both.lines().take(2).collect::<Vec<_>>(),
            first.lines().take(2).collect::<Vec<_>>()
        );
        assert!(pages(1).is_none());
    }

    #[test]
    fn only_sufficiently_large_letters_count_as_legible_from_the_back_row() {
        let smallest = |charset, rows| LetterSize::legible(charset, rows).last();
        assert_eq!(smallest(Charset::Unicode, 24), Some(LetterSize::Dots));
        assert_eq!(smallest(Charset::Unicode, 40), Some(LetterSize::Small));
        assert_eq!(smallest(Charset::Ascii, 24), Some(LetterSize::Strokes));
        assert_eq!(smallest(Charset::Ascii, 40), Some(LetterSize::Middle));
        assert_eq!(smallest(Charset::Ascii, 300), Some(LetterSize::Large));
    }

    #[test]
    fn any_text_at_any_size_stays_within_its_area() {
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
