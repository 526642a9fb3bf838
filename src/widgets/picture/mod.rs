//! Pictures: lists of marks in world coordinates, made once for each kind of figure.
//!
//! A [`Picture`] knows what is drawn, never how it looks. Two renderers draw it: the
//! cells of a terminal (`ink`) and vectors (`svg`).
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
//! let look = Look { charset: Charset::Unicode, theme: Theme::default() };
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

/// A mark of a picture.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Mark {
    Line {
        from: DVec2,
        to: DVec2,
        pen: Pen,
    },
    /// A line through many points. It breaks at points that are not finite.
    Curve {
        points: Vec<DVec2>,
        pen: Pen,
    },
    /// Part of a circle, given by its centre and radius, from one angle to another
    /// (radians, anticlockwise from +x; to < from goes clockwise). A whole turn or more is
    /// a circle.
    Arc {
        circle: (DVec2, f64),
        turn: [f64; 2],
        pen: Pen,
    },
    /// An arrow with its tip at `to`. Labels keep off the tip.
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
    /// A disc. It hides what lies on lower layers.
    Disc(Body),
    /// A disc that hides nothing, faint or an outline, with its letter at `letter`, for use behind
    /// other marks.
    Ring {
        body: Body,
        letter: DVec2,
    },
    /// Many discs, all drawn in one way, and each of them visible.
    Discs(Vec<Body>),
    /// A filled rectangle between its lower left and its upper right corner.
    Area {
        low: DVec2,
        high: DVec2,
        pen: Pen,
    },
    /// A sign or a few letters centred on a point. Labels keep off it.
    Text {
        at: DVec2,
        text: String,
        role: Role,
    },
    /// The axes of a plot, along the left and the lower edge of the view.
    Axes(Axes),
    /// An invisible mark: labels keep off this point.
    Reserved(DVec2),
}

/// A disc in a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Its centre.
    pub at: DVec2,
    /// Its radius, in the same unit as the world.
    pub radius: f64,
    /// What it is drawn as.
    pub role: Role,
    /// The letter in its middle where it is large; a space for none.
    pub letter: char,
    /// Whether it is pointed out among the others.
    pub pointed_out: bool,
}

/// The axes of a plot: of x, then of y.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axes {
    /// Where each tick is, and what is written beside it.
    pub(crate) ticks: [Vec<(f64, String)>; 2],
    /// What the axes measure.
    pub(crate) names: [String; 2],
}

/// What is drawn, in the order of drawing, and where the world is on the screen.
///
/// What lies outside the view's area is cut off there, and what is not a finite number
/// is not drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    area: Rect,
    view: View,
    pub(super) marks: Vec<Mark>,
    pub(super) labels: Vec<Label>,
}

impl Picture {
    /// An empty picture over the area of `view`.
    #[must_use]
    pub fn new(view: View) -> Self {
        Self {
            area: view.area(),
            view,
            marks: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// The same with so much room in all, for what is written beside its axes.
    #[must_use]
    pub fn within(self, area: Rect) -> Self {
        Self { area, ..self }
    }

    /// The cells that it takes up.
    #[must_use]
    pub fn area(&self) -> Rect {
        self.area
    }

    /// Where the world is in it.
    #[must_use]
    pub const fn view(&self) -> &View {
        &self.view
    }

    /// A straight line.
    pub fn line(&mut self, from: DVec2, to: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        self.marks.push(Mark::Line { from, to, pen });
    }

    /// A line through many points. It breaks at points that are not finite.
    pub fn curve(&mut self, points: impl IntoIterator<Item = DVec2>, pen: impl Into<Pen>) {
        let (points, pen) = (points.into_iter().collect(), pen.into());
        self.marks.push(Mark::Curve { points, pen });
    }

    /// A dot.
    pub fn dot(&mut self, at: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        self.marks.push(Mark::Dot { at, pen });
    }

    /// Part of a circle, see `Mark::Arc`.
    pub fn arc(&mut self, centre: DVec2, radius: f64, from: f64, to: f64, pen: impl Into<Pen>) {
        let (circle, turn, pen) = ((centre, radius), [from, to], pen.into());
        self.marks.push(Mark::Arc { circle, turn, pen });
    }

    /// A circle.
    pub fn circle(&mut self, centre: DVec2, radius: f64, pen: impl Into<Pen>) {
        self.arc(centre, radius, 0.0, TAU, pen);
    }

    /// An unfilled rectangle between two opposite corners.
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

    /// The square corner of a right angle at `corner`, between two directions.
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

    /// An arrow with its tip at `to`.
    pub fn arrow(&mut self, from: DVec2, to: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        self.marks.push(Mark::Arrow { from, to, pen });
    }

    /// A disc with a letter in its middle, a space for none.
    pub fn disc(&mut self, at: DVec2, radius: f64, role: Role, letter: char) {
        self.marks
            .push(Mark::Disc(Body::new(at, radius, role, letter)));
    }

    /// A disc that hides nothing, see `Mark::Ring`.
    pub fn ring(&mut self, at: DVec2, radius: f64, role: Role, (sign, letter): (char, DVec2)) {
        let body = Body::new(at, radius, role, sign);
        self.marks.push(Mark::Ring { body, letter });
    }

    /// Discs among others.
    pub fn discs(&mut self, bodies: impl IntoIterator<Item = Body>) {
        self.marks.push(Mark::Discs(bodies.into_iter().collect()));
    }

    /// A filled rectangle between its lower left and its upper right corner.
    pub fn fill(&mut self, low: DVec2, high: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        self.marks.push(Mark::Area { low, high, pen });
    }

    /// A sign or a few letters centred on a point.
    pub fn text(&mut self, at: DVec2, text: impl Into<String>, role: Role) {
        let text = text.into();
        self.marks.push(Mark::Text { at, text, role });
    }

    /// Keeps labels off a point.
    pub fn reserve(&mut self, at: DVec2) {
        self.marks.push(Mark::Reserved(at));
    }

    /// A label beside a point, on the first of `sides` that is free, else on another.
    /// Labels are placed when all else is drawn, in their order: the first ones have the
    /// first choice. One that finds no room is left out.
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
    /// A disc that is not pointed out.
    #[must_use]
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
