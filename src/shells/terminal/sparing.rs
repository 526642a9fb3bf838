//! Writes the cells that have changed with few bytes: only what changes of a style, and the
//! shortest move of the cursor. Over a slow line, or recorded, a picture is its bytes.
//!
//! The sequences are those of ECMA-48 that every terminal knows: CUP, CUF, CUB and SGR, and
//! the line feed, which in raw mode goes straight down.

use std::fmt::Write as _;
use std::io::{self, Write};

use ratatui::backend::{Backend, ClearType, CrosstermBackend, WindowSize};
use ratatui::buffer::Cell;
use ratatui::layout::{Position, Size};
use ratatui::style::{Color, Modifier};

/// How modifiers are switched on. (SGR 7 and the like; all go with 0.)
const MODIFIERS: [(Modifier, &str); 9] = [
    (Modifier::BOLD, "1"),
    (Modifier::DIM, "2"),
    (Modifier::ITALIC, "3"),
    (Modifier::UNDERLINED, "4"),
    (Modifier::SLOW_BLINK, "5"),
    (Modifier::RAPID_BLINK, "6"),
    (Modifier::REVERSED, "7"),
    (Modifier::HIDDEN, "8"),
    (Modifier::CROSSED_OUT, "9"),
];
/// Modifiers by which a blank is seen.
const ON_BLANKS: Modifier = Modifier::UNDERLINED
    .union(Modifier::REVERSED)
    .union(Modifier::CROSSED_OUT);

/// A backend that differs from crossterm's in how it draws.
pub(super) struct SparingBackend<W: Write> {
    inner: CrosstermBackend<W>,
    /// What is written of a picture, before it goes out at once.
    text: String,
}

/// The style in which the terminal writes, and where.
struct Written {
    foreground: Color,
    background: Color,
    modifier: Modifier,
    /// Where the cursor is, if that is known for certain.
    at: Option<Position>,
}

impl<W: Write> SparingBackend<W> {
    pub(super) fn new(writer: W) -> Self {
        Self {
            inner: CrosstermBackend::new(writer),
            text: String::new(),
        }
    }
}

impl<W: Write> Write for SparingBackend<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.inner.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Write::flush(&mut self.inner)
    }
}

impl<W: Write> Backend for SparingBackend<W> {
    type Error = io::Error;

    fn draw<'a, I>(&mut self, content: I) -> io::Result<()>
    where
        I: Iterator<Item = (u16, u16, &'a Cell)>,
    {
        let columns = self.inner.size().map_or(0, |size| size.width);
        self.text.clear();
        encode(content, columns, &mut self.text);
        self.inner.write_all(self.text.as_bytes())
    }

    fn hide_cursor(&mut self) -> io::Result<()> {
        self.inner.hide_cursor()
    }

    fn show_cursor(&mut self) -> io::Result<()> {
        self.inner.show_cursor()
    }

    fn get_cursor_position(&mut self) -> io::Result<Position> {
        self.inner.get_cursor_position()
    }

    fn set_cursor_position<P: Into<Position>>(&mut self, position: P) -> io::Result<()> {
        self.inner.set_cursor_position(position)
    }

    fn clear(&mut self) -> io::Result<()> {
        self.inner.clear()
    }

    fn clear_region(&mut self, clear_type: ClearType) -> io::Result<()> {
        self.inner.clear_region(clear_type)
    }

    fn size(&self) -> io::Result<Size> {
        self.inner.size()
    }

    fn window_size(&mut self) -> io::Result<WindowSize> {
        self.inner.window_size()
    }

    fn flush(&mut self) -> io::Result<()> {
        Backend::flush(&mut self.inner)
    }
}

/// Writes cells of a terminal with so many columns, from left to right and from top to bottom.
/// It starts and ends with the plain style.
fn encode<'a>(content: impl Iterator<Item = (u16, u16, &'a Cell)>, columns: u16, out: &mut String) {
    let mut pen = Written {
        foreground: Color::Reset,
        background: Color::Reset,
        modifier: Modifier::empty(),
        at: None,
    };
    for (x, y, cell) in content {
        pen.go(Position { x, y }, out);
        pen.style(cell, out);
        out.push_str(cell.symbol());
        // At the end of a line, and after letters whose width terminals disagree about, nobody
        // knows where the cursor is.
        let next = x + 1;
        pen.at = (next < columns && is_one_cell(cell.symbol())).then_some(Position { x: next, y });
    }
    out.push_str("\x1b[m");
}

/// Whether every terminal gives this one cell: ASCII, lines, blocks and braille.
fn is_one_cell(symbol: &str) -> bool {
    let mut letters = symbol.chars();
    let first = letters.next();
    letters.next().is_none()
        && first.is_some_and(
            |c| matches!(c, ' '..='~' | '\u{2500}'..='\u{259f}' | '\u{2800}'..='\u{28ff}'),
        )
}

/// How many letters a number has.
fn digits(number: u16) -> usize {
    number.checked_ilog10().map_or(1, |log| log as usize + 1)
}

impl Written {
    /// Moves the cursor.
    fn go(&self, to: Position, out: &mut String) {
        if self.at == Some(to) {
            return;
        }
        let (row, column) = (to.y + 1, to.x + 1);
        let absolute = match to.x {
            0 => 3 + digits(row),
            _ => 4 + digits(row) + digits(column),
        };
        if let Some(at) = self.at.filter(|at| at.y <= to.y) {
            let down = usize::from(to.y - at.y);
            let across = to.x.abs_diff(at.x);
            let sideways = |across: u16| match across {
                0 => 0,
                1 => 3,
                more => 3 + digits(more),
            };
            // Straight down, or to the beginning of the line and from there.
            let returns = down > 0 && 1 + sideways(to.x) < sideways(across);
            let relative = match returns {
                true => down + 1 + sideways(to.x),
                false => down + sideways(across),
            };
            if relative < absolute {
                let (across, way) = match returns {
                    true => (to.x, 'C'),
                    false if to.x > at.x => (across, 'C'),
                    false => (across, 'D'),
                };
                if returns {
                    out.push('\r');
                }
                out.extend(std::iter::repeat_n('\n', down));
                // Writing to a text cannot fail.
                let _ = match across {
                    0 => Ok(()),
                    1 => write!(out, "\x1b[{way}"),
                    more => write!(out, "\x1b[{more}{way}"),
                };
                return;
            }
        }
        let _ = match to.x {
            0 => write!(out, "\x1b[{row}H"),
            _ => write!(out, "\x1b[{row};{column}H"),
        };
    }

    /// Takes the style of a cell, as far as it is seen.
    fn style(&mut self, cell: &Cell, out: &mut String) {
        let start = out.len();
        let modifier = cell.modifier;
        let is_blank = cell.symbol() == " " && !modifier.intersects(ON_BLANKS);
        // A blank is not bold: what is on may stay.
        let is_kept = is_blank && !self.modifier.intersects(ON_BLANKS);
        if !is_kept && !modifier.contains(self.modifier) {
            add(out, start, "0");
            self.modifier = Modifier::empty();
            (self.foreground, self.background) = (Color::Reset, Color::Reset);
        }
        if !is_kept {
            for (switched, code) in MODIFIERS {
                if modifier.contains(switched) && !self.modifier.contains(switched) {
                    add(out, start, code);
                }
            }
            self.modifier = modifier;
        }
        if cell.fg != self.foreground && !is_blank {
            colour(out, start, cell.fg, 30);
            self.foreground = cell.fg;
        }
        if cell.bg != self.background {
            colour(out, start, cell.bg, 40);
            self.background = cell.bg;
        }
        if out.len() > start {
            out.push('m');
        }
    }
}

/// Adds a parameter to the style that began at `start`.
fn add(out: &mut String, start: usize, code: &str) {
    out.push_str(if out.len() == start { "\x1b[" } else { ";" });
    out.push_str(code);
}

/// Adds a colour: of what is written (`base` 30) or of what lies behind it (40).
fn colour(out: &mut String, start: usize, colour: Color, base: u8) {
    let named = match colour {
        Color::Reset => 9,
        Color::Black => 0,
        Color::Red => 1,
        Color::Green => 2,
        Color::Yellow => 3,
        Color::Blue => 4,
        Color::Magenta => 5,
        Color::Cyan => 6,
        Color::Gray => 7,
        Color::DarkGray => 60,
        Color::LightRed => 61,
        Color::LightGreen => 62,
        Color::LightYellow => 63,
        Color::LightBlue => 64,
        Color::LightMagenta => 65,
        Color::LightCyan => 66,
        Color::White => 67,
        Color::Indexed(index) => {
            return add(out, start, &format!("{};5;{index}", base + 8));
        }
        Color::Rgb(r, g, b) => {
            return add(out, start, &format!("{};2;{r};{g};{b}", base + 8));
        }
    };
    add(out, start, &(base + named).to_string());
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;
    use ratatui::buffer::Buffer;
    use ratatui::layout::Rect;
    use ratatui::style::Style;

    use super::*;

    const SIZE: Rect = Rect::new(0, 0, 30, 8);

    /// Scatters letters of many styles over a screen.
    fn scatter(buffer: &mut Buffer, chance: &mut Pcg64Mcg) {
        let colours = [
            Color::Reset,
            Color::Red,
            Color::White,
            Color::Indexed(200),
            Color::Rgb(1, 22, 133),
        ];
        let modifiers = [
            Modifier::empty(),
            Modifier::BOLD,
            Modifier::UNDERLINED,
            Modifier::REVERSED | Modifier::BOLD,
            Modifier::DIM,
        ];
        for _ in 0..chance.random_range(0..120) {
            let at = (
                chance.random_range(0..SIZE.width),
                chance.random_range(0..SIZE.height),
            );
            let symbol = ["a", " ", " ", "⣿", "█", "é", "▄"][chance.random_range(0..7)];
            let style = Style::new()
                .fg(colours[chance.random_range(0..5)])
                .bg(colours[chance.random_range(0..5)])
                .add_modifier(modifiers[chance.random_range(0..5)]);
            buffer[at].reset();
            buffer[at].set_symbol(symbol).set_style(style);
        }
    }

    /// What a terminal shows of these cells: all that can be seen of each.
    fn seen(screen: &vt100::Screen) -> Vec<String> {
        let cell = |(row, column)| {
            let cell = screen.cell(row, column).unwrap();
            let blank = cell.contents().trim().is_empty();
            let plain = blank && !cell.underline() && !cell.inverse();
            let ink = (!plain).then(|| (cell.fgcolor(), cell.bold(), cell.dim()));
            let letters = cell.contents().trim_end().to_owned();
            let back = (cell.bgcolor(), cell.underline(), cell.inverse());
            format!("{letters:?} {ink:?} {back:?}")
        };
        let places = (0..SIZE.height).flat_map(|row| (0..SIZE.width).map(move |it| (row, it)));
        places.map(cell).collect()
    }

    /// A terminal shows the same of it as of crossterm's own way to write it, at four
    /// fifths of the bytes or less.
    #[test]
    fn a_terminal_shows_the_same_at_fewer_bytes() {
        let mut chance = Pcg64Mcg::seed_from_u64(7);
        let sizes = || {
            (
                std::num::NonZeroU16::new(8).unwrap(),
                std::num::NonZeroU16::new(30).unwrap(),
            )
        };
        let new = || vt100::Parser::new(sizes().0, sizes().1, 0);
        let (mut expected, mut found) = (new(), new());
        let (mut before, mut usual, mut sparing) = (Buffer::empty(SIZE), 0, 0);
        for picture in 0..300 {
            let mut after = before.clone();
            scatter(&mut after, &mut chance);
            let mut bytes = Vec::new();
            let mut backend = CrosstermBackend::new(&mut bytes);
            crossterm::style::force_color_output(true);
            backend.draw(before.diff(&after).into_iter()).unwrap();
            expected.process(&bytes);
            let mut text = String::new();
            encode(before.diff(&after).into_iter(), SIZE.width, &mut text);
            found.process(text.as_bytes());
            assert_eq!(
                seen(found.screen()),
                seen(expected.screen()),
                "{picture}: {text:?}"
            );
            usual += bytes.len();
            sparing += text.len();
            before = after;
        }
        assert!(sparing * 5 < usual * 4, "{sparing} of {usual}");
    }
}
