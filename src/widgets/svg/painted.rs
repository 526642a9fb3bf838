//! A screen for a painter of its own, such as a browser's canvas: cells in the colours they
//! are seen in, and the pictures among them as vectors.

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Modifier;

use super::{CellColours, shape, vector};
use crate::widgets::Charset;
use crate::widgets::ink::gallery::DrawnPicture;
use crate::widgets::theme::{Rgb, Role, Theme};

/// A cell, ready to be painted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PaintedCell {
    /// The colour of what is written, 0xRRGGBB.
    pub ink: u32,
    /// The colour behind it.
    pub paper: u32,
    /// Bold, underlined and the like; reversed and dim are in the colours already.
    pub modifier: Modifier,
    /// Whether it shows a part of a picture and nothing else: its vectors take its place.
    pub is_vector: bool,
}

/// A picture among the cells.
#[derive(Debug, Clone, PartialEq)]
pub struct PaintedPicture {
    /// The cells it takes up.
    pub area: Rect,
    /// The colour behind it, 0xRRGGBB.
    pub paper: u32,
    /// The elements of an SVG of the whole screen, in which a cell is 9 by 18; none in ASCII.
    pub svg: String,
}

/// The cells of a screen, row by row, and the pictures that were drawn in it. In ASCII all
/// is cells.
#[must_use]
pub fn painted(
    screen: &Buffer,
    pictures: &[DrawnPicture],
) -> (Vec<PaintedCell>, Vec<PaintedPicture>) {
    let mut cells: Vec<_> = screen
        .content()
        .iter()
        .map(|cell| {
            let colours = CellColours::of(cell);
            PaintedCell {
                ink: code(colours.ink),
                paper: code(colours.ground),
                modifier: cell.modifier,
                is_vector: false,
            }
        })
        .collect();
    let vectors = pictures.iter().map(|drawn| {
        let is_vector = drawn.look.charset == Charset::Unicode && !drawn.is_erased(screen);
        for at in drawn.uncovered(screen).filter(|_| is_vector) {
            if let Some(cell) = cells.get_mut(screen.index_of(at.x, at.y)) {
                cell.is_vector = true;
            }
        }
        PaintedPicture {
            area: drawn.cells.area,
            paper: code(drawn.look.theme.rgb(Role::Background)),
            svg: match is_vector {
                true => vector::draw_labelled(&drawn.picture, &drawn.look, &drawn.labels),
                false => String::new(),
            },
        }
    });
    let vectors = vectors.collect();
    (cells, vectors)
}

/// The colour of each role, 0xRRGGBB.
#[must_use]
pub fn inks(theme: &Theme) -> Vec<(Role, u32)> {
    let ink = |role: &Role| (*role, code(theme.rgb(*role)));
    Role::ALL.iter().map(ink).collect()
}

/// How a glyph is drawn as a shape: the path of an SVG, in a cell of 9 by 18, and how much
/// of the ink is laid on, from 0 to 1. `None` if it is to be written as a letter.
#[must_use]
pub fn glyph_shape(symbol: &str) -> Option<(String, f64)> {
    let mut path = String::new();
    let strength = shape::strength(symbol);
    shape::draw(symbol, (0, 0), &mut path).then_some((path, strength))
}

impl DrawnPicture {
    /// Whether most of it is covered by a page over it.
    fn is_erased(&self, screen: &Buffer) -> bool {
        let drawn = |at: &Position| {
            self.cells
                .cell(*at)
                .is_some_and(|cell| cell.symbol() != " ")
        };
        let (mut all, mut gone) = (0, 0);
        for at in self.cells.area.positions().filter(drawn) {
            all += 1;
            gone += usize::from(screen.cell(at) != self.cells.cell(at));
        }
        2 * gone > all
    }

    /// The cells that nothing was written over: in each row those outside of all that has
    /// changed since, for what lies over a picture may have blanks in it.
    fn uncovered(&self, screen: &Buffer) -> impl Iterator<Item = Position> {
        let area = self.cells.area;
        area.rows().flat_map(move |row| {
            let changed = |at: &Position| screen.cell(*at) != self.cells.cell(*at);
            let first = row.positions().find(changed);
            let last = first.and_then(|_| row.positions().filter(changed).last());
            row.positions().filter(move |at| {
                let ends = first.zip(last);
                ends.is_none_or(|(first, last)| !(first.x..=last.x).contains(&at.x))
            })
        })
    }
}

fn code(Rgb(red, green, blue): Rgb) -> u32 {
    u32::from_be_bytes([0, red, green, blue])
}

#[cfg(test)]
mod tests {
    use glam::DVec2;
    use ratatui::style::Style;

    use super::*;
    use crate::widgets::ink::gallery::gather;
    use crate::widgets::picture::{Picture, View};
    use crate::widgets::{Look, Theme};

    const AREA: Rect = Rect::new(0, 0, 20, 10);

    fn drawn(charset: Charset) -> (Buffer, Vec<DrawnPicture>) {
        let mut screen = Buffer::empty(AREA);
        let look = Look {
            charset,
            theme: Theme::default(),
        };
        let mut picture = Picture::new(View::new(Rect::new(2, 1, 16, 8), DVec2::ZERO, 1.0));
        picture.disc(DVec2::ZERO, 5.0, Role::Coin, 'C');
        let ((), pictures) = gather(false, || picture.draw(&mut screen, &look));
        (screen, pictures)
    }

    #[test]
    fn a_picture_is_painted_where_nothing_lies_over_it() {
        let (mut screen, pictures) = drawn(Charset::Unicode);
        let vectors = |screen: &Buffer| {
            let (cells, pictures) = painted(screen, &pictures);
            assert!(pictures[0].svg.contains("<circle"), "{pictures:?}");
            cells.iter().filter(|cell| cell.is_vector).count()
        };
        assert_eq!(vectors(&screen), 16 * 8);
        screen.set_string(4, 3, "a  b", Style::new());
        assert_eq!(
            vectors(&screen),
            16 * 8 - 4,
            "blanks within are covered too"
        );
        let erased = Buffer::empty(AREA);
        let (cells, left) = painted(&erased, &pictures);
        assert!(left[0].svg.is_empty() && cells.iter().all(|cell| !cell.is_vector));
    }

    #[test]
    fn in_ascii_all_is_cells_and_nobody_gathers_unasked() {
        let (screen, pictures) = drawn(Charset::Ascii);
        let (cells, vectors) = painted(&screen, &pictures);
        assert!(vectors[0].svg.is_empty() && cells.iter().all(|cell| !cell.is_vector));
        let ((), none) = gather(false, || ());
        assert!(none.is_empty());
    }
}
