//! A screen for another renderer, such as a browser's canvas: cells in their final colours, and the
//! pictures among the cells as vectors.

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Modifier;

use super::{colour::colours, shape, vector};
use crate::widgets::Charset;
use crate::widgets::ink::gallery::DrawnPicture;
use crate::widgets::theme::{Rgb, Role, Theme};

/// A cell with its final colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PaintedCell {
    /// The foreground colour, 0xRRGGBB.
    pub ink: u32,
    /// The background colour, 0xRRGGBB.
    pub paper: u32,
    /// Bold, underlined and so on; the reverse and dim modifiers have already been applied to the
    /// colours.
    pub modifier: Modifier,
    /// Whether the cell shows nothing but part of a picture that is also drawn with vectors.
    pub is_vector: bool,
}

/// A picture among the cells.
#[derive(Debug, Clone, PartialEq)]
pub struct PaintedPicture {
    /// The area that the picture fills.
    pub area: Rect,
    /// The background colour, 0xRRGGBB.
    pub paper: u32,
    /// The elements for an SVG of the whole screen, in which a cell is 9 units wide and 18 units
    /// high; empty in ASCII, or if something has been drawn over most of the picture.
    pub svg: String,
}

/// The cells of a screen, row by row, and the pictures that were drawn in it. In ASCII the
/// pictures have no vectors.
pub fn painted(
    screen: &Buffer,
    pictures: &[DrawnPicture],
) -> (Vec<PaintedCell>, Vec<PaintedPicture>) {
    let mut cells: Vec<_> = screen
        .content()
        .iter()
        .map(|cell| {
            let [ink, paper] = colours(cell).map(code);
            PaintedCell {
                ink,
                paper,
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
pub fn inks(theme: &Theme) -> Vec<(Role, u32)> {
    let ink = |role: &Role| (*role, code(theme.rgb(*role)));
    Role::ALL.iter().map(ink).collect()
}

/// The shape of a glyph: an SVG path in a cell 9 units wide and 18 units high, and its opacity from
/// 0 to 1. `None` if the glyph is written as text.
pub fn glyph_shape(symbol: &str) -> Option<(String, f64)> {
    let mut path = String::new();
    let strength = shape::strength(symbol);
    shape::draw(symbol, (0, 0), &mut path).then_some((path, strength))
}

impl DrawnPicture {
    /// Whether something has been drawn over most of the picture.
    fn is_erased(&self, screen: &Buffer) -> bool {
        let drawn = |at: &Position| self.cells[*at].symbol() != " ";
        let (mut all, mut gone) = (0, 0);
        for at in self.cells.area.positions().filter(drawn) {
            all += 1;
            gone += usize::from(screen.cell(at) != self.cells.cell(at));
        }
        2 * gone > all
    }

    /// The cells that nothing covers. In each row these are the cells outside the range of changed
    /// cells, because spaces in a page drawn over a picture may leave cells unchanged.
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
    use crate::widgets::Look;
    use crate::widgets::ink::gallery::gather;
    use crate::widgets::picture::{Picture, View};

    const AREA: Rect = Rect::new(0, 0, 20, 10);

    fn drawn(charset: Charset) -> (Buffer, Vec<DrawnPicture>) {
        let mut screen = Buffer::empty(AREA);
        let look = Look {
            charset,
            ..Look::default()
        };
        let mut picture = Picture::new(View::new(Rect::new(2, 1, 16, 8), DVec2::ZERO, 1.0));
        picture.disc(DVec2::ZERO, 5.0, Role::Coin, 'C');
        let ((), pictures) = gather(false, || picture.draw(&mut screen, &look));
        (screen, pictures)
    }

    #[test]
    fn a_picture_is_painted_where_nothing_covers_it() {
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
            "spaces within the range are covered too"
        );
        let erased = Buffer::empty(AREA);
        let (cells, left) = painted(&erased, &pictures);
        assert!(left[0].svg.is_empty() && cells.iter().all(|cell| !cell.is_vector));
    }

    #[test]
    fn in_ascii_there_are_only_cells_and_pictures_are_collected_on_request() {
        let (screen, pictures) = drawn(Charset::Ascii);
        let (cells, vectors) = painted(&screen, &pictures);
        assert!(vectors[0].svg.is_empty() && cells.iter().all(|cell| !cell.is_vector));
        let ((), none) = gather(false, || ());
        assert!(none.is_empty());
    }
}
