//! Glyphs drawn as shapes: braille, block elements and box lines.

use std::fmt::Write;

use super::CELL;
use crate::widgets::text::blocks::{BRAILLE, QUARTERS, octants, sextants};

/// Adds the outline of a glyph in the cell whose upper left corner is at `corner`; returns whether
/// the glyph has a shape.
pub(super) fn draw(symbol: &str, corner: (usize, usize), path: &mut String) -> bool {
    let mut letters = symbol.chars();
    let (Some(glyph), None) = (letters.next(), letters.next()) else {
        return false;
    };
    let mut pen = CellPen {
        left: corner.0 as f64,
        top: corner.1 as f64,
        path,
    };
    let code = u32::from(glyph);
    match glyph {
        '\u{2801}'..='\u{28ff}' => pen.braille(code - 0x2800),
        '▀' => pen.block(0.0, 0.0, 1.0, 0.5),
        '▁'..='█' => pen.block(0.0, 1.0 - f64::from(code - 0x2580) / 8.0, 1.0, 1.0),
        '▉'..='▏' => pen.block(0.0, 0.0, f64::from(0x2590 - code) / 8.0, 1.0),
        '▐' => pen.block(0.5, 0.0, 1.0, 1.0),
        '░'..='▓' => pen.block(0.0, 0.0, 1.0, 1.0),
        '▔' => pen.block(0.0, 0.0, 1.0, 0.125),
        '▕' => pen.block(0.875, 0.0, 1.0, 1.0),
        '▖'..='▟' => {
            let bits = QUARTERS.iter().position(|it| *it == glyph).unwrap_or(0);
            pen.parts(2, bits as u8);
        }
        '\u{1fb00}'..='\u{1fb3b}' => pen.parts(3, bits(glyph, sextants())),
        '\u{1cd00}'..='\u{1cde5}' => pen.parts(4, bits(glyph, octants())),
        _ => match arms(glyph) {
            Some((arms, thick)) => pen.lines(arms, thick),
            None => return false,
        },
    }
    true
}

/// The bits that represent the parts of a glyph.
fn bits(glyph: char, mut glyphs: impl Iterator<Item = (char, u8)>) -> u8 {
    glyphs.find(|it| it.0 == glyph).map_or(0, |it| it.1)
}

/// Whether a glyph consists of round dots.
pub(super) fn is_dotted(symbol: &str) -> bool {
    matches!(symbol.chars().next(), Some('\u{2800}'..='\u{28ff}'))
}

/// The opacity of a glyph, which is less than 1 for shade characters.
pub(super) fn strength(symbol: &str) -> f64 {
    match symbol {
        "░" => 0.25,
        "▒" => 0.5,
        "▓" => 0.75,
        _ => 1.0,
    }
}

/// The directions of box lines from the middle of a cell.
mod arm {
    pub(super) const LEFT: u8 = 1;
    pub(super) const RIGHT: u8 = 2;
    pub(super) const UP: u8 = 4;
    pub(super) const DOWN: u8 = 8;
}

/// The arms of a box-drawing character, and their thickness. Double lines are drawn as thick lines,
/// and rounded corners as square corners.
fn arms(glyph: char) -> Option<(u8, f64)> {
    use arm::{DOWN, LEFT, RIGHT, UP};
    let arms = match glyph {
        '─' | '━' | '═' => LEFT | RIGHT,
        '│' | '┃' | '║' => UP | DOWN,
        '┌' | '┏' | '╔' | '╭' => RIGHT | DOWN,
        '┐' | '┓' | '╗' | '╮' => LEFT | DOWN,
        '└' | '┗' | '╚' | '╰' => RIGHT | UP,
        '┘' | '┛' | '╝' | '╯' => LEFT | UP,
        '├' | '┣' | '╠' => UP | DOWN | RIGHT,
        '┤' | '┫' | '╣' => UP | DOWN | LEFT,
        '┬' | '┳' | '╦' => LEFT | RIGHT | DOWN,
        '┴' | '┻' | '╩' => LEFT | RIGHT | UP,
        '┼' | '╋' | '╬' => LEFT | RIGHT | UP | DOWN,
        '╴' | '╸' => LEFT,
        '╵' | '╹' => UP,
        '╶' | '╺' => RIGHT,
        '╷' | '╻' => DOWN,
        _ => return None,
    };
    let light = "─│┌┐└┘├┤┬┴┼╭╮╰╯╴╵╶╷".contains(glyph);
    Some((arms, if light { 1.0 } else { 2.0 }))
}

struct CellPen<'a> {
    left: f64,
    top: f64,
    path: &'a mut String,
}

impl CellPen<'_> {
    /// Adds a rectangle between two corners, given as fractions of the cell's width and height.
    fn block(&mut self, x0: f64, y0: f64, x1: f64, y1: f64) {
        let (w, h) = (CELL.0 as f64, CELL.1 as f64);
        self.rectangle(x0 * w, y0 * h, (x1 - x0) * w, (y1 - y0) * h);
    }

    /// Adds a rectangle in units of the picture.
    fn rectangle(&mut self, x: f64, y: f64, width: f64, height: f64) {
        let (x, y) = (self.left + x, self.top + y);
        let _ = write!(self.path, "M{x} {y}h{width}v{height}h-{width}z");
    }

    /// Adds the dots of a braille pattern, with the bits in Unicode's order.
    fn braille(&mut self, bits: u32) {
        let radius = 1.6;
        let across = 2.0 * radius;
        for bit in (0..8).map(|bit| 1 << bit) {
            if let Some(dot) = BRAILLE.iter().position(|it| bits & bit & it != 0) {
                let (column, row) = ((dot % 2) as f64, (dot / 2) as f64);
                let x = self.left + (column + 0.5) * CELL.0 as f64 / 2.0 - radius;
                let y = self.top + (row + 0.5) * CELL.1 as f64 / 4.0;
                let _ = write!(
                    self.path,
                    "M{x:.2} {y:.2}a{radius} {radius} 0 1 0 {across} 0\
                     a{radius} {radius} 0 1 0 -{across} 0z"
                );
            }
        }
    }

    /// Adds the parts of a block element that has two columns and `rows` rows; each bit stands for
    /// one part.
    fn parts(&mut self, rows: u8, bits: u8) {
        for part in (0..2 * rows).filter(|part| bits >> part & 1 == 1) {
            let x = f64::from(part % 2) / 2.0;
            let [top, bottom] = [0, 1].map(|edge| f64::from(part / 2 + edge) / f64::from(rows));
            self.block(x, top, x + 0.5, bottom);
        }
    }

    fn lines(&mut self, arms: u8, thick: f64) {
        let (width, height) = (CELL.0 as f64, CELL.1 as f64);
        // Whole units make lines sharp and align them with the lines of adjacent cells.
        let x = ((width - thick) / 2.0).floor();
        let y = ((height - thick) / 2.0).floor();
        let bars = [
            (arm::LEFT, (0.0, y, x + thick, thick)),
            (arm::RIGHT, (x, y, width - x, thick)),
            (arm::UP, (x, 0.0, thick, y + thick)),
            (arm::DOWN, (x, y, thick, height - y)),
        ];
        for (_, (x, y, width, height)) in bars.into_iter().filter(|(arm, _)| arms & arm != 0) {
            self.rectangle(x, y, width, height);
        }
    }
}
