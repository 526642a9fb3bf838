//! Pictures: lists of marks in world coordinates, independent of how they are drawn.
//!
//! A [`Picture`] says what is drawn, not how it looks. There are two renderers: one for the cells
//! of a terminal (`ink`) and one for vectors (`svg`).
//!
//! ```
//! use carrom::widgets::{Charset, Look, Role, Theme};
//! use carrom::widgets::picture::{Pen, Picture, LabelSide, View};
//! use glam::dvec2;
//! use ratatui::{buffer::Buffer, layout::Rect};
//!
//! let mut buffer = Buffer::empty(Rect::new(0, 0, 40, 12));
//! let view = View::fit(buffer.area, dvec2(-0.04, -0.02), dvec2(0.04, 0.02));
//! let mut picture = Picture::new(view);
//! picture.disc(dvec2(0.0, 0.0), 0.015, Role::Striker, 'S');
//! picture.line(dvec2(-0.04, 0.01), dvec2(0.04, 0.01), Pen::new(Role::LineOfImpact).dashed());
//! let (tail, tip) = (dvec2(0.0, 0.0), dvec2(0.02, 0.018));
//! picture.arrow(tail, tip, Role::StrikerOut);
//! picture.label("v₁ = 2.00 m/s", tip, &LabelSide::towards(tip - tail), Role::StrikerOut);
//! let look = Look::default();
//! picture.draw(&mut buffer, &look);
//! ```

mod label;
mod pen;
mod view;

use std::f64::consts::TAU;

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::Role;
pub use label::{Label, LabelSide};
pub use pen::{Dash, DrawLayer, Pen};
pub use view::View;
pub(in crate::widgets) use view::{around, positive};

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Mark {
    Line {
        from: DVec2,
        to: DVec2,
        pen: Pen,
    },
    /// A line through many points, interrupted at points that are not finite.
    Curve {
        points: Vec<DVec2>,
        pen: Pen,
    },
    /// An arc, given by its centre and radius, from one angle to another (in radians, anticlockwise
    /// from +x; clockwise if to < from). An arc of a full turn or more becomes a circle.
    Arc {
        circle: (DVec2, f64),
        turn: [f64; 2],
        pen: Pen,
    },
    /// An arrow with its tip at `to`. Labels do not cover the tip.
    Arrow {
        from: DVec2,
        to: DVec2,
        pen: Pen,
    },
    /// A dot.
    Dot {
        at: DVec2,
        pen: Pen,
    },
    /// A disc, which hides everything on lower layers.
    Disc(Body),
    /// A disc drawn faintly or as an outline, with its letter at `letter`, for use behind other
    /// marks. In cells it hides nothing unless it is very small.
    Ring {
        body: Body,
        letter: DVec2,
    },
    /// A group of discs that are all drawn in the same way and are all visible.
    Discs(Vec<Body>),
    /// A part of a board. If the terminal has shades, the part is filled, below everything else;
    /// otherwise its outline is drawn, if it has one. In ASCII the outline is always drawn, and a
    /// part without an outline is left out.
    Ground {
        region: Region,
        role: Role,
        outline: Option<Role>,
    },
    /// A filled rectangle, given by its lower left and upper right corners.
    Area {
        low: DVec2,
        high: DVec2,
        pen: Pen,
    },
    /// A sign or a few letters, centred on a point. Labels do not cover this text.
    Text {
        at: DVec2,
        text: String,
        role: Role,
    },
    /// The axes of a plot, along the left and the lower edges of the view.
    Axes(Axes),
    /// An invisible mark at a point, which keeps the point free of labels.
    Reserved(DVec2),
}

/// The shape of a part of a board.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Region {
    /// The square centred on the origin, given by half the length of its side.
    Square(f64),
    /// The circle with this centre and radius.
    Circle(DVec2, f64),
}

/// A disc in a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// The centre of the disc.
    pub at: DVec2,
    /// The radius of the disc, in world units.
    pub radius: f64,
    /// The role, which determines the colour of the disc.
    pub role: Role,
    /// The letter in the middle of the disc if the disc is large enough; a space means no letter.
    pub letter: char,
    /// Whether a ring distinguishes the disc from the others.
    pub pointed_out: bool,
}

/// The axes of a plot: first x, then y.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axes {
    /// For each axis, the position and the text of each tick.
    pub(crate) ticks: [Vec<(f64, String)>; 2],
    /// The names of the axes, with their units.
    pub(crate) names: [String; 2],
}

/// Marks, in the order of drawing, and the mapping from the world to the screen.
///
/// In cells, marks are clipped at the edge of the view's area, and those with a coordinate that is
/// not finite are not drawn. As vectors, only lines and parts of boards are clipped.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    area: Rect,
    view: View,
    pub(super) marks: Vec<Mark>,
    pub(super) labels: Vec<Label>,
}

impl Picture {
    /// An empty picture that fills the area of `view`.
    pub fn new(view: View) -> Self {
        Self {
            area: view.area(),
            view,
            marks: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// This picture with a larger total area, which leaves room for the text beside the axes.
    #[must_use]
    pub fn within(self, area: Rect) -> Self {
        Self { area, ..self }
    }

    /// The area that the picture fills.
    pub fn area(&self) -> Rect {
        self.area
    }

    /// The mapping from the world to the picture's cells.
    pub const fn view(&self) -> &View {
        &self.view
    }

    /// Adds a straight line.
    pub fn line(&mut self, from: DVec2, to: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        self.marks.push(Mark::Line { from, to, pen });
    }

    /// Adds a line through many points, interrupted at points that are not finite.
    pub fn curve(&mut self, points: impl IntoIterator<Item = DVec2>, pen: impl Into<Pen>) {
        let (points, pen) = (points.into_iter().collect(), pen.into());
        self.marks.push(Mark::Curve { points, pen });
    }

    /// Adds a dot.
    pub fn dot(&mut self, at: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        self.marks.push(Mark::Dot { at, pen });
    }

    /// Adds an arc; see `Mark::Arc`.
    pub fn arc(&mut self, centre: DVec2, radius: f64, from: f64, to: f64, pen: impl Into<Pen>) {
        let (circle, turn, pen) = ((centre, radius), [from, to], pen.into());
        self.marks.push(Mark::Arc { circle, turn, pen });
    }

    /// Adds a circle.
    pub fn circle(&mut self, centre: DVec2, radius: f64, pen: impl Into<Pen>) {
        self.arc(centre, radius, 0.0, TAU, pen);
    }

    /// Adds an unfilled rectangle between two opposite corners.
    pub fn rectangle(&mut self, corner: DVec2, opposite: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        let corners = [
            corner,
            dvec2(opposite.x, corner.y),
            opposite,
            dvec2(corner.x, opposite.y),
        ];
        for i in 0..4 {
            self.line(corners[i], corners[(i + 1) % 4], pen);
        }
    }

    /// Adds the mark of a right angle at `corner`, between two directions.
    pub fn square_corner(
        &mut self,
        corner: DVec2,
        [along, across]: [DVec2; 2],
        side: f64,
        pen: impl Into<Pen>,
    ) {
        let along = along.normalize_or_zero() * side;
        let across = across.normalize_or_zero() * side;
        let points = [corner + along, corner + along + across, corner + across];
        self.curve(points, pen);
    }

    /// Adds an arrow with its tip at `to`.
    pub fn arrow(&mut self, from: DVec2, to: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        self.marks.push(Mark::Arrow { from, to, pen });
    }

    /// Adds a disc with a letter in its middle; a space means no letter.
    pub fn disc(&mut self, at: DVec2, radius: f64, role: Role, letter: char) {
        self.marks
            .push(Mark::Disc(Body::new(at, radius, role, letter)));
    }

    /// Adds a disc drawn faintly or as an outline; see `Mark::Ring`.
    pub fn ring(&mut self, at: DVec2, radius: f64, role: Role, (sign, letter): (char, DVec2)) {
        let body = Body::new(at, radius, role, sign);
        self.marks.push(Mark::Ring { body, letter });
    }

    /// Adds many discs; see `Mark::Discs`.
    pub fn discs(&mut self, bodies: impl IntoIterator<Item = Body>) {
        self.marks.push(Mark::Discs(bodies.into_iter().collect()));
    }

    /// Adds a part of a board; see `Mark::Ground`.
    pub(crate) fn ground(&mut self, region: Region, role: Role, outline: Option<Role>) {
        self.marks.push(Mark::Ground {
            region,
            role,
            outline,
        });
    }

    /// Adds a filled rectangle between its lower left and its upper right corner.
    pub fn fill(&mut self, low: DVec2, high: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        self.marks.push(Mark::Area { low, high, pen });
    }

    /// Adds a sign or a few letters centred on a point.
    pub fn text(&mut self, at: DVec2, text: impl Into<String>, role: Role) {
        let text = text.into();
        self.marks.push(Mark::Text { at, text, role });
    }

    /// Keeps a point free of labels.
    pub fn reserve(&mut self, at: DVec2) {
        self.marks.push(Mark::Reserved(at));
    }

    /// Adds a label beside a point: on the first of `sides` that is free, or otherwise on another
    /// side. Labels are placed after everything else is drawn, and earlier labels have priority. A
    /// label for which there is no room is left out.
    pub fn label(
        &mut self,
        text: impl Into<String>,
        anchor: DVec2,
        sides: &[LabelSide],
        role: Role,
    ) -> &mut Label {
        self.labels.push(Label {
            text: text.into(),
            role,
            places: vec![(anchor, sides.to_vec())],
            short: None,
            keeps_others_off: true,
        });
        let last = self.labels.len() - 1;
        &mut self.labels[last]
    }
}

impl Body {
    /// A disc without a ring around it.
    pub const fn new(at: DVec2, radius: f64, role: Role, letter: char) -> Self {
        Self {
            at,
            radius,
            role,
            letter,
            pointed_out: false,
        }
    }
}
