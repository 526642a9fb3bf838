//! Vector pictures for paper.

use std::fmt::Write;

use glam::DVec2;
use maud::{Markup, Render, html};
use unicode_width::UnicodeWidthStr;

use super::clean;

/// Height of letters in pictures, in units of the picture.
pub const LETTERS: f64 = 11.0;
/// Length and half the width of an arrow's head.
const HEAD: (f64, f64) = (9.0, 3.4);
/// Letters of a label; longer ones are cut.
const LABEL: usize = 80;

/// What a line is drawn with: a strength first, so that it tells things apart in black
/// and white too, and in one case a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ink {
    /// Nearly black: what matters.
    Text,
    /// Dark grey: names, ticks, lines to measure from.
    Dim,
    /// Light grey: frames and grids.
    Faint,
    /// The one colour: a dark blue that is a dark grey in black and white.
    Accent,
    /// The palest blue, for areas.
    Wash,
    /// The paper itself.
    Paper,
}

impl Ink {
    /// As CSS has it.
    #[must_use]
    pub const fn css(self) -> &'static str {
        match self {
            Self::Text => "#1c2230",
            Self::Dim => "#5b6372",
            Self::Faint => "#c9cdd5",
            Self::Accent => "#00609c",
            Self::Wash => "#dfecf6",
            Self::Paper => "#ffffff",
        }
    }
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    ink: Ink,
    width: f64,
    dashes: &'static str,
}

impl Stroke {
    /// A plain line, one unit wide.
    #[must_use]
    pub const fn new(ink: Ink) -> Self {
        Self {
            ink,
            width: 1.0,
            dashes: "",
        }
    }

    /// The same line, so many units wide.
    #[must_use]
    pub const fn wide(self, width: f64) -> Self {
        Self { width, ..self }
    }

    /// The same line in dashes.
    #[must_use]
    pub const fn dashed(self) -> Self {
        Self {
            dashes: "5 3.5",
            ..self
        }
    }

    /// The same line in dots.
    #[must_use]
    pub const fn dotted(self) -> Self {
        Self {
            dashes: "1.2 3",
            ..self
        }
    }

    /// The same line in dashes and dots, as drawings have the line through centres.
    #[must_use]
    pub const fn centre_line(self) -> Self {
        Self {
            dashes: "9 3 1.5 3",
            ..self
        }
    }

    fn dashes(&self) -> Option<&'static str> {
        (!self.dashes.is_empty()).then_some(self.dashes)
    }
}

/// Which end of a label stands at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The label begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// The label ends there.
    End,
}

/// A vector picture.
///
/// Its units are CSS pixels (96 to the inch, 3.78 to the millimetre) and y points
/// **down**, as paper is read. It can be put into [`maud::html!`] as it is, or be
/// [a file](Self::file) of its own.
#[derive(Debug, Clone)]
pub struct Svg {
    words: String,
    corner: DVec2,
    size: DVec2,
    body: String,
}

impl Svg {
    /// An empty picture with its corner at the origin. `words` say what is to be seen,
    /// to whoever cannot see it.
    #[must_use]
    pub fn new(words: &str, width: f64, height: f64) -> Self {
        Self {
            words: clean(words, 400),
            corner: DVec2::ZERO,
            size: DVec2::new(width, height),
            body: String::new(),
        }
    }

    /// The same picture, showing what lies between these corners.
    #[must_use]
    pub fn framed(self, least: DVec2, most: DVec2) -> Self {
        Self {
            corner: least,
            size: most - least,
            ..self
        }
    }

    /// Width and height.
    #[must_use]
    pub fn size(&self) -> DVec2 {
        self.size
    }

    /// What is to be seen.
    #[must_use]
    pub fn words(&self) -> &str {
        &self.words
    }

    /// A straight line.
    pub fn line(&mut self, from: DVec2, to: DVec2, stroke: Stroke) -> &mut Self {
        self.polyline([from, to], stroke)
    }

    /// A line through several points.
    pub fn polyline(
        &mut self,
        points: impl IntoIterator<Item = DVec2>,
        stroke: Stroke,
    ) -> &mut Self {
        let mut path = String::new();
        for (i, point) in points.into_iter().enumerate() {
            let order = if i == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{order}{} {}", Number(point.x), Number(point.y));
        }
        if !path.is_empty() {
            self.path(&path, None, Some(stroke));
        }
        self
    }

    /// An area with this outline.
    pub fn polygon(&mut self, points: &[DVec2], fill: Ink) -> &mut Self {
        let mut path = String::new();
        for (i, point) in points.iter().enumerate() {
            let order = if i == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{order}{} {}", Number(point.x), Number(point.y));
        }
        path.push('Z');
        self.path(&path, Some(fill), None)
    }

    /// A rectangle between two corners.
    pub fn rectangle(&mut self, a: DVec2, b: DVec2, fill: Ink) -> &mut Self {
        let (least, size) = (a.min(b), (a - b).abs());
        self.push(&html! {
            rect x=(Number(least.x)) y=(Number(least.y)) width=(Number(size.x))
                height=(Number(size.y)) fill=(fill.css()) {}
        })
    }

    /// A circle, with an outline, filled, or both.
    pub fn circle(
        &mut self,
        centre: DVec2,
        radius: f64,
        fill: Option<Ink>,
        stroke: Option<Stroke>,
    ) -> &mut Self {
        self.push(&html! {
            circle cx=(Number(centre.x)) cy=(Number(centre.y)) r=(Number(radius))
                fill=(fill.map_or("none", Ink::css)) stroke=[stroke.map(|it| it.ink.css())]
                stroke-width=[stroke.map(|it| Number(it.width))]
                stroke-dasharray=[stroke.and_then(|it| it.dashes())] {}
        })
    }

    /// An arc of a circle from the angle `from` to the angle `to`, in radians as they
    /// are seen on paper: 0 to the right, positive upwards (anticlockwise).
    pub fn arc(
        &mut self,
        centre: DVec2,
        radius: f64,
        from: f64,
        to: f64,
        stroke: Stroke,
    ) -> &mut Self {
        let at = |angle: f64| centre + radius * DVec2::new(angle.cos(), -angle.sin());
        let (start, end) = (at(from), at(to));
        let long = u8::from((to - from).abs() > std::f64::consts::PI);
        let sweep = u8::from(to < from);
        let path = format!(
            "M{} {}A{r} {r} 0 {long} {sweep} {} {}",
            Number(start.x),
            Number(start.y),
            Number(end.x),
            Number(end.y),
            r = Number(radius),
        );
        self.path(&path, None, Some(stroke))
    }

    /// An arrow with its tip at `to`; nothing where it has no length.
    pub fn arrow(&mut self, from: DVec2, to: DVec2, stroke: Stroke) -> &mut Self {
        let Some(along) = (to - from).try_normalize() else {
            return self;
        };
        let size = (0.6 + 0.4 * stroke.width).min((to - from).length() / HEAD.0);
        let neck = to - size * HEAD.0 * along;
        let across = size * HEAD.1 * along.perp();
        // The line ends within the head, so that it does not blunt the tip.
        self.line(from, to - 0.7 * size * HEAD.0 * along, stroke);
        self.polygon(&[to, neck + across, neck - across], stroke.ink)
    }

    /// A label; `at` is on its middle line.
    pub fn label(&mut self, text: &str, at: DVec2, anchor: Anchor, ink: Ink) -> &mut Self {
        self.text(text, at, anchor, ink, false)
    }

    /// A label in bold.
    pub fn strong(&mut self, text: &str, at: DVec2, anchor: Anchor, ink: Ink) -> &mut Self {
        self.text(text, at, anchor, ink, true)
    }

    /// How wide a label will be, near enough to keep others clear of it: fonts differ.
    #[must_use]
    pub fn label_width(text: &str) -> f64 {
        0.6 * LETTERS * text.width() as f64
    }

    /// The picture as a file of its own, on paper: it may be shown on anything.
    #[must_use]
    pub fn file(&self) -> String {
        let mut paper = Self {
            body: String::new(),
            ..self.clone()
        };
        paper.rectangle(self.corner, self.corner + self.size, Ink::Paper);
        paper.body.push_str(&self.body);
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}\n",
            paper.render().into_string()
        )
    }

    fn text(&mut self, text: &str, at: DVec2, anchor: Anchor, ink: Ink, bold: bool) -> &mut Self {
        let anchor = match anchor {
            Anchor::Start => None,
            Anchor::Middle => Some("middle"),
            Anchor::End => Some("end"),
        };
        // Half the height of a small letter below the middle line. The rim of paper keeps
        // it readable where a line runs behind it.
        self.push(&html! {
            text x=(Number(at.x)) y=(Number(at.y + 0.35 * LETTERS)) text-anchor=[anchor]
                fill=(ink.css()) font-weight=[bold.then_some("bold")]
                stroke=(Ink::Paper.css()) stroke-width="3" stroke-linejoin="round"
                paint-order="stroke" { (clean(text, LABEL)) }
        })
    }

    fn path(&mut self, path: &str, fill: Option<Ink>, stroke: Option<Stroke>) -> &mut Self {
        self.push(&html! {
            path d=(path) fill=(fill.map_or("none", Ink::css))
                stroke=[stroke.map(|it| it.ink.css())]
                stroke-width=[stroke.map(|it| Number(it.width))]
                stroke-dasharray=[stroke.and_then(|it| it.dashes())] {}
        })
    }

    fn push(&mut self, markup: &Markup) -> &mut Self {
        self.body.push_str(&markup.0);
        self
    }
}

/// The picture as part of an HTML document.
impl Render for Svg {
    fn render(&self) -> Markup {
        let view = [self.corner.x, self.corner.y, self.size.x, self.size.y];
        let view = view.map(|number| Number(number).to_string()).join(" ");
        html! {
            svg xmlns="http://www.w3.org/2000/svg" width=(Number(self.size.x))
                height=(Number(self.size.y)) viewBox=(view) role="img"
                font-family="Helvetica Neue,Helvetica,Arial,Liberation Sans,DejaVu Sans,sans-serif"
                font-size=(Number(LETTERS)) {
                title { (self.words) }
                (maud::PreEscaped(&self.body))
            }
        }
    }
}

/// A number of a picture: two decimals are finer than any printer, and nothing but a
/// number can come out.
struct Number(f64);

impl std::fmt::Display for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let rounded = (100.0 * self.0).round() / 100.0;
        // Adding 0 makes a plain 0 of −0.
        let number = if rounded.is_finite() {
            rounded + 0.0
        } else {
            0.0
        };
        write!(f, "{number}")
    }
}

impl Render for Number {
    fn render_to(&self, buffer: &mut String) {
        let _ = write!(buffer, "{self}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

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
    fn labels_are_text() {
        let mut picture = Svg::new("<&>\u{1}", 10.0, 10.0);
        picture.label(
            "</text><script>\u{0}",
            DVec2::ZERO,
            Anchor::Middle,
            Ink::Text,
        );
        let file = picture.file();
        assert!(file.contains("<title>&lt;&amp;&gt;</title>"), "{file}");
        assert!(
            file.contains(">&lt;/text&gt;&lt;script&gt;</text>"),
            "{file}"
        );
    }

    #[test]
    fn arcs_turn_as_they_are_seen() {
        // A quarter up from the right: it ends above its centre, where y is less.
        let mut picture = Svg::new("", 10.0, 10.0);
        picture.arc(
            dvec2(5.0, 5.0),
            2.0,
            0.0,
            std::f64::consts::FRAC_PI_2,
            Stroke::new(Ink::Text),
        );
        assert!(
            picture.body.contains("M7 5A2 2 0 0 0 5 3"),
            "{}",
            picture.body
        );
    }

    #[test]
    fn an_arrow_without_length_is_none() {
        let mut picture = Svg::new("", 10.0, 10.0);
        picture.arrow(DVec2::ONE, DVec2::ONE, Stroke::new(Ink::Text));
        assert!(picture.body.is_empty());
    }
}
