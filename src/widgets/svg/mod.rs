//! Pictures and screens as SVG.
//!
//! A [`Picture`] becomes true lines, circles and text. The letters of a screen become text in any
//! available monospace font, with each word stretched to its cells. Braille, block elements and box
//! lines are drawn as shapes, so that no font can distort a picture made of them. All shapes that
//! are not round have hard edges, so that no seams are visible between cells.

mod colour;
pub(crate) mod painted;
mod shape;
mod vector;

use std::collections::BTreeMap;
use std::fmt::Write;

use maud::{Markup, PreEscaped, Render, html};
use ratatui::buffer::{Buffer, Cell};
use ratatui::layout::Rect;
use ratatui::style::Modifier;
use unicode_width::UnicodeWidthStr;

use super::cells::{rows, symbols};
use super::theme::{Rgb, Role};
use super::{Look, panels::draw_panel, picture::Picture};
use colour::{PAPER, colours};

/// The width and height of a cell, in units of the picture.
const CELL: (usize, usize) = (9, 18);
/// The columns and rows of a panel.
const PANEL: (u16, u16) = (84, 32);
/// The distance from the top of a cell to the baseline of its letters, in units of the picture.
const BASE: usize = 14;

/// A screen as an SVG file.
pub(crate) fn of_screen(cells: &Buffer) -> String {
    screen(cells, "")
}

/// A panel with pictures as an SVG file. `fill` writes the text into the cells of the panel and
/// returns the pictures to be drawn in it.
pub(crate) fn of_panel(
    title: &str,
    look: &Look,
    fill: impl FnOnce(Rect, &mut Buffer) -> Vec<Picture>,
) -> String {
    let area = Rect::new(0, 0, PANEL.0, PANEL.1);
    let mut cells = Buffer::empty(area);
    cells.set_style(area, look.theme.base());
    let inside = draw_panel(&mut cells, area, title, look);
    let pictures = fill(inside, &mut cells);
    let draw = |picture: &Picture| vector::draw(picture, look);
    screen(&cells, &pictures.iter().map(draw).collect::<String>())
}

/// The width and height of an area, in units of the picture.
fn size(area: Rect) -> [usize; 2] {
    let (columns, rows) = (usize::from(area.width), usize::from(area.height));
    [columns * CELL.0, rows * CELL.1]
}

fn screen(cells: &Buffer, vectors: &str) -> String {
    let [width, height] = size(cells.area);
    let mut grounds = Paths::default();
    let mut shapes = Paths::default();
    let mut dots = Paths::default();
    let mut words = String::new();
    for (row, line) in rows(cells).enumerate() {
        let y = row * CELL.1;
        let line: Vec<(usize, &Cell)> = symbols(line).collect();
        let taken = |cell: &Cell| cell.symbol().width().max(1) * CELL.0;
        let ground = |cell: &Cell| colours(cell)[1];
        for run in line.chunk_by(|(_, a), (_, b)| ground(a) == ground(b)) {
            let (column, cell) = run[0];
            if ground(cell) != PAPER {
                let x = column * CELL.0;
                let width: usize = run.iter().map(|(_, cell)| taken(cell)).sum();
                let path = grounds.of(ground(cell));
                let _ = write!(path, "M{x} {y}h{width}v{}h-{width}z", CELL.1);
            }
        }
        let mut letters = Vec::new();
        for (column, cell) in line {
            let x = column * CELL.0;
            let [ink, ground] = colours(cell);
            let taken = taken(cell);
            if cell.modifier.contains(Modifier::UNDERLINED) {
                let y = y + CELL.1 - 2;
                let _ = write!(shapes.of(ink), "M{x} {y}h{taken}v1h-{taken}z");
            }
            let blank = cell.symbol().trim().is_empty() || cell.modifier.contains(Modifier::HIDDEN);
            let faded = ground.mixed(ink, shape::strength(cell.symbol()));
            let dotted = shape::is_dotted(cell.symbol());
            let path = if dotted { &mut dots } else { &mut shapes }.of(faded);
            if !blank && !shape::draw(cell.symbol(), (x, y), path) {
                let style = (ink, cell.modifier & (Modifier::BOLD | Modifier::ITALIC));
                letters.push((x, cell, style));
            }
        }
        // Adjacent letters in one style are one word.
        for word in letters.chunk_by(|a, b| a.0 + taken(a.1) == b.0 && a.2 == b.2) {
            let (x, _, (ink, modifier)) = word[0];
            let text: String = word.iter().map(|(_, cell, _)| cell.symbol()).collect();
            let width: usize = word.iter().map(|(_, cell, _)| taken(cell)).sum();
            let set = |flag, text| if modifier.contains(flag) { text } else { "" };
            let bold = set(Modifier::BOLD, " font-weight=\"bold\"");
            let italic = set(Modifier::ITALIC, " font-style=\"italic\"");
            let (y, text) = (y + BASE, escape(&text));
            let _ = writeln!(
                words,
                "<text x=\"{x}\" y=\"{y}\" textLength=\"{width}\" lengthAdjust=\"spacingAndGlyphs\" \
                 fill=\"{ink}\"{bold}{italic}>{text}</text>"
            );
        }
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"{PAPER}\"/>\n\
         <g shape-rendering=\"crispEdges\">\n{grounds}{shapes}</g>\n{dots}\
         <g font-family=\"'DejaVu Sans Mono','Menlo','Consolas','Liberation Mono',monospace\" \
         font-size=\"15\">\n{words}</g>\n{vectors}</svg>\n"
    )
}

/// A picture as vectors, for use in [`maud::html!`] or as a separate file.
#[derive(Debug, Clone)]
pub struct Svg {
    words: String,
    /// The width and height of the drawing, before scaling.
    size: [f64; 2],
    scale: f64,
    paper: Rgb,
    body: String,
}

impl Svg {
    /// Creates the SVG of a picture whose area begins in the upper left corner of the screen.
    /// `words` is its text alternative. At a `scale` of 1, letters are 14 CSS pixels high.
    pub(crate) fn new(words: &str, picture: &Picture, look: &Look, scale: f64) -> Self {
        Self {
            words: words.to_owned(),
            size: size(picture.area()).map(|length| length as f64),
            scale,
            paper: look.theme.rgb(Role::Background),
            body: vector::draw(picture, look),
        }
    }

    /// The width and height at which the picture is shown, in CSS pixels.
    #[must_use]
    pub(crate) fn size(&self) -> [f64; 2] {
        self.size.map(|length| length * self.scale)
    }

    /// The text alternative.
    pub(crate) fn words(&self) -> &str {
        &self.words
    }

    /// The picture as an SVG file with an opaque background.
    pub fn file(&self) -> String {
        let paper = self.paper;
        let [width, height] = self.size;
        let ground = format!("<rect width=\"{width}\" height=\"{height}\" fill=\"{paper}\"/>\n");
        let file = Self {
            body: ground + &self.body,
            ..self.clone()
        };
        let declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";
        format!("{declaration}\n{}\n", file.render().into_string())
    }
}

/// The picture as part of an HTML document.
impl Render for Svg {
    fn render(&self) -> Markup {
        let [width, height] = self.size;
        let [shown_width, shown_height] = self.size().map(Number);
        html! {
            svg xmlns="http://www.w3.org/2000/svg" width=(shown_width) height=(shown_height)
                viewBox=(format_args!("0 0 {width} {height}")) role="img" {
                title { (self.words) }
                (PreEscaped(&self.body))
            }
        }
    }
}

/// A number in a picture. It is rounded to two decimal places, which is finer than any printer can
/// resolve; a number that is not finite becomes 0.
struct Number(f64);

impl std::fmt::Display for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let number = if self.0.is_finite() { self.0 } else { 0.0 };
        let hundredths = (100.0 * number).round() as i64;
        let sign = if hundredths < 0 { "-" } else { "" };
        let size = hundredths.unsigned_abs();
        let (whole, part) = (size / 100, size % 100);
        match (part, part % 10) {
            (0, _) => write!(f, "{sign}{whole}"),
            (_, 0) => write!(f, "{sign}{whole}.{}", part / 10),
            _ => write!(f, "{sign}{whole}.{part:02}"),
        }
    }
}

/// Outlines to be filled, with one path per colour.
#[derive(Default)]
struct Paths(BTreeMap<Rgb, String>);

impl Paths {
    fn of(&mut self, colour: Rgb) -> &mut String {
        self.0.entry(colour).or_default()
    }
}

impl std::fmt::Display for Paths {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (colour, path) in self.0.iter().filter(|(_, path)| !path.is_empty()) {
            writeln!(f, "<path fill=\"{colour}\" d=\"{path}\"/>")?;
        }
        Ok(())
    }
}

/// `text` escaped for XML; control characters, and others that XML does not allow, become question
/// marks.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push('?'),
            control if control.is_control() => escaped.push('?'),
            other => escaped.push(other),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratatui::style::{Color, Style};

    fn drawn(text: &str, style: Style) -> String {
        let mut buffer = Buffer::empty(Rect::new(0, 0, 12, 1));
        buffer.set_string(0, 0, text, style);
        of_screen(&buffer)
    }

    #[test]
    fn numbers_are_short_and_finite() {
        for (number, text) in [
            (1.0, "1"),
            (-0.001, "0"),
            (1.0 / 3.0, "0.33"),
            (f64::NAN, "0"),
            (f64::INFINITY, "0"),
        ] {
            assert_eq!(Number(number).to_string(), text);
        }
    }

    #[test]
    fn letters_are_in_their_cells() {
        let svg = drawn("ab  <&", Style::new());
        assert!(
            svg.contains("<text x=\"0\" y=\"14\" textLength=\"18\""),
            "{svg}"
        );
        assert!(svg.contains("<text x=\"36\""), "{svg}");
        assert!(svg.contains(">&lt;&amp;</text>"), "{svg}");
        assert!(svg.starts_with("<svg xmlns") && svg.ends_with("</svg>\n"));
    }

    #[test]
    fn colours_and_reverse_are_kept() {
        let red = Style::new().fg(Color::Rgb(255, 0, 1));
        assert!(drawn("x", red).contains("fill=\"#ff0001\""));
        let svg = drawn("x", red.add_modifier(Modifier::REVERSED | Modifier::BOLD));
        assert!(
            svg.contains("<path fill=\"#ff0001\" d=\"M0 0h9v18h-9z\"/>"),
            "{svg}"
        );
        assert!(
            svg.contains("fill=\"#101418\" font-weight=\"bold\">x<"),
            "{svg}"
        );
    }

    #[test]
    fn braille_blocks_and_box_lines_are_shapes() {
        for text in ["⠿", "▄", "▙", "█", "▒", "┌", "┼", "╭"] {
            let svg = drawn(text, Style::new());
            assert!(!svg.contains("<text"), "{text}: {svg}");
            assert!(svg.contains("<path"), "{text}: {svg}");
        }
    }
}
