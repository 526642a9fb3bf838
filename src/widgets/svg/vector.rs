//! Pictures as vectors: true lines and circles.

use std::f64::consts::{PI, TAU};
use std::fmt::{self, Display, Write};
use std::iter;

use glam::{DVec2, dvec2};

use super::{CELL, Number, escape};
use crate::widgets::ink::{Canvas, PlacedLabel};
use crate::widgets::picture::{Axes, Body, Dash, DrawLayer, Mark, Pen, Picture, Region, View};
use crate::widgets::theme::Rgb;
use crate::widgets::{Look, Role};

/// The height of letters, in units of the picture.
const LETTERS: f64 = 14.0;
/// The height of the letter of one of many discs, in radii of the disc.
const SIGN: f64 = 1.2;
/// The length and half the width of an arrow's head, in units of the picture.
const HEAD: (f64, f64) = (11.0, 4.2);
/// The radius of the ring around a marked disc, in radii of the disc.
const POINTED_OUT: f64 = 1.25;
/// The number of pieces used for an arc or a circle that is not completely in the view.
const PIECES: u32 = 180;
/// A point of a line, other than the last, is left out if it is closer than this to the previous
/// point, in units of the picture.
const NEAR: f64 = 0.3;
/// Half the width of a sign such as ● or ×, which is also the smallest radius of a disc.
const DOT: f64 = 3.5;

/// The elements of a picture, in units in which a cell has the size [`CELL`].
pub(super) fn draw(picture: &Picture, look: &Look) -> String {
    draw_labelled(picture, look, &Canvas::of(picture, look).labels)
}

/// The elements of a picture whose labels have already been placed.
pub(super) fn draw_labelled(picture: &Picture, look: &Look, labels: &[PlacedLabel]) -> String {
    let has_surface = |mark: &Mark| matches!(mark, Mark::Ground { .. });
    let paper = match picture.marks.iter().any(has_surface) {
        true => Role::Surface,
        false => Role::Background,
    };
    let mut vectors = Vectors {
        view: picture.view(),
        look,
        paper: look.theme.rgb(paper),
        body: String::new(),
    };
    let mut marks: Vec<&Mark> = picture.marks.iter().collect();
    marks.sort_by_key(|mark| layer(mark));
    vectors.put(format_args!(
        "<g font-family=\"Helvetica Neue,Helvetica,Arial,Liberation Sans,DejaVu Sans,sans-serif\" \
         font-size=\"{LETTERS}\">\n<g stroke-linecap=\"round\" \
         stroke-linejoin=\"round\">\n"
    ));
    for chain in marks.chunk_by(|one, next| goes_on(one, next)) {
        vectors.chain(chain);
    }
    vectors.put("</g>\n");
    // These marks may extend beyond the edges of the view.
    for mark in marks {
        match mark {
            Mark::Axes(axes) => vectors.axes(axes, picture),
            Mark::Text { at, text, role } => vectors.sign(*at, text, *role),
            Mark::Disc(body) => vectors.letter(body, body.at),
            Mark::Ring { body, letter } => vectors.letter(body, *letter),
            _ => {}
        }
    }
    for label in labels {
        let [left, right] = [label.place.left(), label.place.right()].map(f64::from);
        let (column, anchor) = match label.side.outwards() {
            (1, _) => (left, Anchor::Start),
            (0, _) => (f64::midpoint(left, right), Anchor::Middle),
            _ => (right, Anchor::End),
        };
        let at = dvec2(column, f64::from(label.place.y) + 0.5) * cell();
        vectors.text(&label.text, at, anchor, label.role);
    }
    vectors.put("</g>\n");
    vectors.body
}

fn layer(mark: &Mark) -> DrawLayer {
    match mark {
        Mark::Line { pen, .. }
        | Mark::Curve { pen, .. }
        | Mark::Arc { pen, .. }
        | Mark::Arrow { pen, .. }
        | Mark::Dot { pen, .. } => pen.layer,
        Mark::Disc(_) | Mark::Ring { .. } | Mark::Discs(_) => DrawLayer::Disc,
        Mark::Ground { .. } | Mark::Area { .. } | Mark::Axes(_) => DrawLayer::Ground,
        Mark::Text { .. } | Mark::Reserved(_) => DrawLayer::Mark,
    }
}

/// Whether a mark is a line that the next mark continues with the same pen.
fn goes_on(mark: &Mark, next: &Mark) -> bool {
    match (mark, next) {
        (Mark::Line { to, pen, .. }, Mark::Line { from, pen: own, .. }) => to == from && pen == own,
        _ => false,
    }
}

/// The part of a string that is aligned with the given position.
#[derive(Clone, Copy, strum::Display)]
#[strum(serialize_all = "lowercase")]
enum Anchor {
    Start,
    Middle,
    End,
}

fn cell() -> DVec2 {
    dvec2(CELL.0 as f64, CELL.1 as f64)
}

/// The part of a straight line that is inside a rectangle, if any.
fn clipped([from, to]: [DVec2; 2], low: DVec2, high: DVec2) -> Option<[DVec2; 2]> {
    let way = to - from;
    // The positions along the line at which the line crosses each pair of edges; a line parallel to
    // a pair of edges does not cross them.
    let [a, b] = [(low - from) / way, (high - from) / way];
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        if way[axis] == 0.0 {
            if !(low[axis]..=high[axis]).contains(&from[axis]) {
                return None;
            }
        } else {
            first = first.max(a[axis].min(b[axis]));
            last = last.min(a[axis].max(b[axis]));
        }
    }
    let end = |share: f64| match share {
        0.0 => from,
        1.0 => to,
        _ => from + share * way,
    };
    (way.is_finite() && first <= last).then(|| [end(first), end(last)])
}

/// A point in a path.
struct Point(DVec2);

impl Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", Number(self.0.x), Number(self.0.y))
    }
}

struct Vectors<'a> {
    view: &'a View,
    look: &'a Look,
    /// The background colour of lines and labels.
    paper: Rgb,
    body: String,
}

impl Vectors<'_> {
    fn put(&mut self, text: impl Display) {
        let _ = write!(self.body, "{text}");
    }

    fn at(&self, world: DVec2) -> DVec2 {
        self.view.to_cell(world) * cell()
    }

    fn length(&self, world: f64) -> f64 {
        world / self.view.per_column() * cell().x
    }

    fn rgb(&self, role: Role) -> Rgb {
        self.look.theme.rgb(role)
    }

    /// Draws a mark; a chain of connected lines, such as a trail, becomes a single path.
    fn chain(&mut self, marks: &[&Mark]) {
        let [Mark::Line { from, pen, .. }, _, ..] = marks else {
            return marks.iter().for_each(|mark| self.mark(mark));
        };
        let ends = marks.iter().filter_map(|mark| match mark {
            Mark::Line { to, .. } => Some(*to),
            _ => None,
        });
        let points: Vec<_> = iter::once(*from).chain(ends).collect();
        self.curve(&points, *pen);
    }

    fn mark(&mut self, mark: &Mark) {
        match mark {
            Mark::Line { from, to, pen } => self.curve(&[*from, *to], *pen),
            Mark::Curve { points, pen } => self.curve(points, *pen),
            Mark::Arc { circle, turn, pen } => self.arc(*circle, *turn, *pen),
            Mark::Arrow { from, to, pen } => self.arrow(*from, *to, *pen),
            Mark::Dot { at, pen } => {
                let radius = if pen.bold { 2.2 } else { 1.2 };
                self.circle(*at, radius, self.inked(*pen), "");
            }
            Mark::Disc(body) | Mark::Ring { body, .. } => self.disc(body),
            Mark::Discs(bodies) => bodies.iter().for_each(|body| self.solid(body)),
            Mark::Ground { region, role, .. } => self.ground(*region, *role),
            Mark::Area { low, high, pen } => {
                let (a, b) = (self.at(*low), self.at(*high));
                let (least, size) = (a.min(b), (a - b).abs());
                let [x, y, width, height] = [least.x, least.y, size.x, size.y].map(Number);
                let fill = self.inked(*pen);
                self.put(format_args!(
                    "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"{fill}\"/>\n"
                ));
            }
            Mark::Text { .. } | Mark::Axes(_) | Mark::Reserved(_) => {}
        }
    }

    /// The colour of a pen, faded by its age.
    fn inked(&self, pen: Pen) -> Rgb {
        self.rgb(pen.role).mixed(self.paper, 0.75 * pen.age)
    }

    fn stroke(&self, pen: Pen) -> String {
        let width = match pen.layer {
            _ if pen.bold => 2.6,
            DrawLayer::Ground => 1.1,
            _ => 1.5,
        };
        let dashes = match pen.dash {
            Dash::Solid => "",
            Dash::Dashed => " stroke-dasharray=\"6 4.5\"",
            Dash::Dotted => " stroke-dasharray=\"0.1 4\"",
        };
        format!(
            " stroke=\"{}\" stroke-width=\"{width}\"{dashes}",
            self.inked(pen)
        )
    }

    fn path(&mut self, path: &str, fill: impl Display, stroke: &str) {
        self.put(format_args!(
            "<path d=\"{path}\" fill=\"{fill}\"{stroke}/>\n"
        ));
    }

    fn circle(&mut self, centre: DVec2, radius: f64, fill: impl Display, stroke: &str) {
        let at = self.at(centre);
        let (x, y, r) = (Number(at.x), Number(at.y), Number(radius));
        self.put(format_args!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"{fill}\"{stroke}/>\n"
        ));
    }

    /// Draws a line through points in the world, clipped to the view.
    fn curve(&mut self, points: &[DVec2], pen: Pen) {
        let mut path = String::new();
        let mut last = None;
        let [low, high] = self.corners();
        let mut points: Vec<_> = points.iter().map(|point| self.at(*point)).collect();
        let end = points.pop();
        points.dedup_by(|next, kept| next.distance(*kept) < NEAR);
        points.extend(end);
        for pair in points.windows(2) {
            let Some([from, to]) = clipped([pair[0], pair[1]], low, high) else {
                continue;
            };
            if last != Some(from) {
                let _ = write!(path, "M{}", Point(from));
            }
            let _ = write!(path, "L{}", Point(to));
            last = Some(to);
        }
        if !path.is_empty() {
            let stroke = self.stroke(pen);
            self.path(&path, "none", &stroke);
        }
    }

    /// The corners of the view, in units of the picture.
    fn corners(&self) -> [DVec2; 2] {
        let area = self.view.area();
        let corner = |x: u16, y: u16| dvec2(f64::from(x), f64::from(y)) * cell();
        [
            corner(area.left(), area.top()),
            corner(area.right(), area.bottom()),
        ]
    }

    /// Fills a part of a board, clipped to the view.
    fn ground(&mut self, region: Region, role: Role) {
        let fill = self.rgb(role);
        let [low, high] = self.corners();
        let points: Vec<_> = match region {
            Region::Square(half) => {
                let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                corners.map(|(x, y)| half * dvec2(x, y)).to_vec()
            }
            Region::Circle(centre, radius) => {
                let (at, r) = (self.at(centre), self.length(radius));
                if (at - r).cmpge(low).all() && (at + r).cmple(high).all() {
                    return self.circle(centre, r, fill, "");
                }
                let angle = |i| TAU * f64::from(i) / f64::from(PIECES);
                let points = (0..PIECES).map(|i| centre + radius * DVec2::from_angle(angle(i)));
                points.collect()
            }
        };
        let mut path = String::new();
        for (i, point) in points.into_iter().enumerate() {
            let sign = if i == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{sign}{}", Point(self.at(point).clamp(low, high)));
        }
        path.push('Z');
        self.path(&path, fill, "");
    }

    fn arc(&mut self, (centre, radius): (DVec2, f64), [from, to]: [f64; 2], pen: Pen) {
        let r = self.length(radius);
        let (middle, [low, high]) = (self.at(centre), self.corners());
        let is_inside = (middle - r).cmpge(low).all() && (middle + r).cmple(high).all();
        if !is_inside {
            let at = |i: u32| from + (to - from) * f64::from(i) / f64::from(PIECES);
            let points = (0..=PIECES).map(|i| centre + radius * DVec2::from_angle(at(i)));
            return self.curve(&points.collect::<Vec<_>>(), pen);
        }
        let stroke = self.stroke(pen);
        if (to - from).abs() >= TAU {
            return self.circle(centre, r, "none", &stroke);
        }
        let end = |it| Point(self.at(centre + radius * DVec2::from_angle(it)));
        let (start, end, r) = (end(from), end(to), Number(r));
        let long = u8::from((to - from).abs() > PI);
        let sweep = u8::from(to < from);
        let path = format!("M{start}A{r} {r} 0 {long} {sweep} {end}");
        self.path(&path, "none", &stroke);
    }

    fn arrow(&mut self, from: DVec2, to: DVec2, pen: Pen) {
        let (tail, tip) = (self.at(from), self.at(to));
        let Some(along) = (tip - tail).try_normalize() else {
            return;
        };
        let full = if pen.bold { 1.2 } else { 1.0 };
        let size = f64::min(full, 0.6 * (tip - tail).length() / HEAD.0);
        let neck = tip - size * HEAD.0 * along;
        let across = size * HEAD.1 * along.perp();
        // The line ends inside the head, so that it does not blunt the tip.
        let end = tip - 0.8 * size * HEAD.0 * along;
        self.curve(&[from, self.view.to_world(end / cell())], pen);
        let [tip, left, right] = [tip, neck + across, neck - across].map(Point);
        let path = format!("M{tip}L{left}L{right}Z");
        self.path(&path, self.inked(pen), "");
    }

    /// Draws a disc of a collision, in a faint colour so that marks on it are clearly visible.
    fn disc(&mut self, body: &Body) {
        let radius = self.length(body.radius);
        let role = self.rgb(body.role);
        if radius <= DOT {
            return self.circle(body.at, DOT, role, "");
        }
        let stroke = format!(" stroke=\"{role}\" stroke-width=\"1.8\"");
        self.circle(body.at, radius, self.look.theme.faint(body.role), &stroke);
    }

    /// Writes the letter of a disc of a collision, on top of the marks on the disc.
    fn letter(&mut self, body: &Body, at: DVec2) {
        let radius = self.length(body.radius);
        if body.letter != ' ' && radius > DOT {
            let colours = [self.rgb(Role::Text), self.look.theme.faint(body.role)];
            let (at, letter) = (self.at(at), body.letter.to_string());
            self.write(LETTERS, &letter, at, Anchor::Middle, colours);
        }
    }

    /// Draws one of many discs, in its full colour.
    fn solid(&mut self, body: &Body) {
        let radius = self.length(body.radius).max(DOT);
        let role = self.rgb(body.role);
        let rim = self.paper.mixed(role, 0.4);
        let stroke = format!(" stroke=\"{rim}\" stroke-width=\"1\"");
        self.circle(body.at, radius, role, &stroke);
        if radius >= 0.5 * LETTERS {
            let at = self.at(body.at);
            let sign = body.letter.to_string();
            let colours = [role.ink(), role];
            self.write(SIGN * radius, &sign, at, Anchor::Middle, colours);
        }
        if body.pointed_out {
            let stroke = self.stroke(Pen::new(Role::Good).bold());
            self.circle(body.at, POINTED_OUT * radius, "none", &stroke);
        }
    }

    /// Writes text on the background, vertically centred at a point.
    fn text(&mut self, text: &str, at: DVec2, anchor: Anchor, role: Role) {
        let colours = [self.rgb(role), self.paper];
        self.write(LETTERS, text, at, anchor, colours);
    }

    /// Writes text in letters of the given size, but no larger than the usual size. The text has an
    /// outline in the background colour, so that it is readable on top of a line.
    fn write(&mut self, size: f64, text: &str, at: DVec2, anchor: Anchor, colours: [Rgb; 2]) {
        let [ink, rim] = colours;
        let size = size.min(LETTERS);
        self.put(format_args!(
            "<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\" fill=\"{ink}\" stroke=\"{rim}\" \
             stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
            Number(at.x),
            Number(at.y + 0.35 * size),
        ));
        if size < LETTERS {
            self.put(format_args!(" font-size=\"{}\"", Number(size)));
        }
        self.put(format_args!(">{}</text>\n", escape(text)));
    }

    /// Draws a sign, as a shape if the sign has one, otherwise as text.
    fn sign(&mut self, world: DVec2, text: &str, role: Role) {
        let ink = self.rgb(role);
        let at = self.at(world);
        let stroke = format!(" stroke=\"{ink}\" stroke-width=\"1.8\"");
        match text {
            "●" | "o" | "O" => self.circle(world, DOT, ink, ""),
            "○" => self.circle(world, DOT, self.rgb(Role::Background), &stroke),
            "×" | "x" => {
                let (x, y, size) = (Number(at.x - DOT), Number(at.y - DOT), Number(2.0 * DOT));
                let path = format!("M{x} {y}l{size} {size}m-{size} 0l{size} -{size}");
                self.path(&path, "none", &stroke);
            }
            _ => self.text(text, at, Anchor::Middle, role),
        }
    }

    fn axes(&mut self, axes: &Axes, picture: &Picture) {
        let (paper, area) = (self.view.area(), picture.area());
        if paper.is_empty() {
            return;
        }
        let pen = Pen::new(Role::Axis);
        let foot = paper.bottom() - 1;
        let origin = self.view.world_at(paper.x, foot);
        let corner = self.view.world_at(paper.right() - 1, paper.y);
        let ends = [dvec2(origin.x, corner.y), origin, dvec2(corner.x, origin.y)];
        self.curve(&ends, pen);
        let tick = dvec2(self.view.per_column(), self.view.per_row()) * dvec2(0.45, 0.22);
        let charset = self.look.charset;
        let names = axes.names.each_ref().map(|name| charset.text(name));
        for (place, text) in &axes.ticks[0] {
            let at = dvec2(*place, origin.y);
            self.curve(&[at, at - tick.y * DVec2::Y], pen);
            let below = self.at(at) + DVec2::Y * cell().y;
            self.text(&charset.text(text), below, Anchor::Middle, Role::Dim);
        }
        for (place, text) in &axes.ticks[1] {
            let at = dvec2(origin.x, *place);
            self.curve(&[at, at - tick.x * DVec2::X], pen);
            let beside = self.at(at) - 0.8 * DVec2::X * cell().x;
            self.text(&charset.text(text), beside, Anchor::End, Role::Dim);
        }
        let top = dvec2(f64::from(area.x), f64::from(area.y) + 0.5) * cell();
        self.text(&names[1], top, Anchor::Start, Role::Text);
        let middle = f64::midpoint(f64::from(paper.left()), f64::from(paper.right()));
        let below = dvec2(middle, f64::from(area.bottom()) - 0.5) * cell();
        self.text(&names[0], below, Anchor::Middle, Role::Text);
    }
}

#[cfg(test)]
mod tests {
    use ratatui::layout::Rect;

    use super::*;
    use crate::widgets::picture::LabelSide;

    fn drawn(make: impl Fn(&mut Picture)) -> String {
        // One metre is one column, or nine units; the origin is in the middle of cell (5, 2).
        let view = View::new(Rect::new(0, 0, 11, 5), DVec2::ZERO, 1.0);
        let mut picture = Picture::new(view);
        make(&mut picture);
        let look = Look::default();
        draw(&picture, &look)
    }

    /// A trail of many segments is drawn as a single path, unless its pen changes or it has a gap.
    #[test]
    fn connected_lines_are_one_path() {
        let [a, b, c, d] = [0.0, 1.0, 2.0, 3.0].map(|x| dvec2(x, 0.0));
        let (young, old) = (Pen::new(Role::Trail), Pen::new(Role::Trail).aged(0.5));
        let found = drawn(|it| {
            it.line(a, b, old);
            it.line(b, c, young);
            it.line(c, d, young);
            it.line(a, b, young);
        });
        let paths: Vec<_> = found.matches(" d=\"").collect();
        assert_eq!(paths.len(), 3, "{found}");
        assert!(found.contains("M58.5 45L67.5 45L76.5 45"), "{found}");
    }

    #[test]
    fn arcs_turn_in_the_visible_direction() {
        // A quarter turn that starts on the right ends above the centre, where y is smaller.
        let found = drawn(|it| it.arc(DVec2::ZERO, 2.0, 0.0, PI / 2.0, Role::Arc));
        assert!(found.contains("M67.5 45A18 18 0 0 0 49.5 27"), "{found}");
    }

    #[test]
    fn discs_and_whole_turns_are_circles() {
        let found = drawn(|it| {
            it.disc(DVec2::ZERO, 2.0, Role::Coin, 'C');
            it.circle(DVec2::ZERO, 1.0, Role::Arc);
        });
        assert!(
            found.contains("<circle cx=\"49.5\" cy=\"45\" r=\"18\""),
            "{found}"
        );
        assert!(found.contains("r=\"9\" fill=\"none\" stroke="), "{found}");
        assert!(found.contains(">C</text>"), "{found}");
    }

    #[test]
    fn an_arrow_of_zero_length_is_left_out_and_a_curve_is_interrupted_at_undefined_points() {
        let found = drawn(|it| it.arrow(DVec2::ONE, DVec2::ONE, Role::CoinOut));
        assert!(!found.contains("<path"), "{found}");
        let points = [DVec2::ZERO, DVec2::X, DVec2::NAN, DVec2::Y, DVec2::ONE];
        let found = drawn(|it| it.curve(points, Role::CoinOut));
        assert!(
            found.contains("M49.5 45L58.5 45M49.5 36L58.5 36"),
            "{found}"
        );
    }

    #[test]
    fn higher_layers_are_drawn_later_in_any_order() {
        let found = drawn(|it| {
            it.line(DVec2::ZERO, DVec2::X, Role::StrikerOut);
            it.disc(DVec2::ZERO, 2.0, Role::Coin, ' ');
        });
        assert!(found.find("<circle") < found.find("<path"), "{found}");
    }

    #[test]
    fn labels_are_text() {
        let found = drawn(|it| {
            it.label("<b>", DVec2::ZERO, &[LabelSide::Right], Role::Text);
        });
        assert!(found.contains(">&lt;b&gt;</text>"), "{found}");
    }
}
