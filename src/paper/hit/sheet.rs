//! What is drawn on, in metres with y up: it remembers what is where, so that labels
//! keep clear of it and the picture is as large as its content.

use glam::{DVec2, dvec2};

use super::placing::{Area, Obstacles, TIP};
use crate::paper::{Anchor, Ink, Stroke, Svg};

/// Height of a label's area, and how far it reaches beyond its letters at both ends.
const LABEL: (f64, f64) = (13.0, 2.0);
/// What is left free at the edges.
const MARGIN: f64 = 5.0;
/// An arc's label further than this from it has a thin line leading to it.
const LEADER: f64 = 12.0;
/// Pieces that an arc is taken as.
const PIECES: u32 = 24;

/// The picture being made.
pub(super) struct Sheet {
    svg: Svg,
    /// Units of the picture for each metre.
    scale: f64,
    extent: Area,
    pub(super) obstacles: Obstacles,
    /// What is written just where it is, over all else.
    marks: Vec<(String, DVec2, Ink)>,
    /// What is to be written upon a disc: where that is, its radius, and where else.
    upon: Vec<(String, DVec2, f64, DVec2)>,
    waiting: Vec<Label>,
    /// Where the labels are, once they are.
    pub(super) labels: Vec<Area>,
}

struct Label {
    text: String,
    at: DVec2,
    towards: DVec2,
    ink: Ink,
    /// Whether a line leads to it, should it find no place near what it names.
    led: bool,
}

impl Sheet {
    pub(super) fn new(words: &str, scale: f64) -> Self {
        Self {
            svg: Svg::new(words, 0.0, 0.0),
            scale,
            extent: Area::around(DVec2::ZERO, DVec2::ZERO),
            obstacles: Obstacles::default(),
            marks: Vec::new(),
            upon: Vec::new(),
            waiting: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// A place on paper.
    fn place(&self, at: DVec2) -> DVec2 {
        self.scale * dvec2(at.x, -at.y)
    }

    /// A length on paper, in units of the picture.
    pub(super) fn length(&self, length: f64) -> f64 {
        self.scale * length
    }

    pub(super) fn line(&mut self, from: DVec2, to: DVec2, stroke: Stroke) {
        let (from, to) = (self.place(from), self.place(to));
        self.see(from, to);
        self.svg.line(from, to, stroke);
    }

    pub(super) fn arrow(&mut self, from: DVec2, to: DVec2, stroke: Stroke) {
        let (from, to) = (self.place(from), self.place(to));
        self.see(from, to);
        self.obstacles.points.push(to);
        self.svg.arrow(from, to, stroke);
    }

    /// An arc from one direction to another, the shorter way.
    pub(super) fn arc(
        &mut self,
        centre: DVec2,
        radius: f64,
        from: DVec2,
        to: DVec2,
        stroke: Stroke,
    ) {
        let (start, turn) = (from.to_angle(), from.angle_to(to));
        let point = |i: u32| {
            let angle = start + turn * f64::from(i) / f64::from(PIECES);
            self.place(centre + radius * DVec2::from_angle(angle))
        };
        let points: Vec<_> = (0..=PIECES).map(point).collect();
        for pair in points.windows(2) {
            self.see(pair[0], pair[1]);
        }
        let (centre, radius) = (self.place(centre), self.scale * radius);
        self.svg.arc(centre, radius, start, start + turn, stroke);
    }

    /// A whole circle that labels may lie in.
    pub(super) fn ring(&mut self, centre: DVec2, radius: f64, stroke: Stroke) {
        let (centre, radius) = (self.place(centre), self.scale * radius);
        self.extent
            .include(Area::around(centre, DVec2::splat(radius)));
        self.svg.circle(centre, radius, None, Some(stroke));
    }

    /// A disc; labels keep off it.
    pub(super) fn disc(&mut self, centre: DVec2, radius: f64, fill: Option<Ink>, stroke: Stroke) {
        let (centre, radius) = (self.place(centre), self.scale * radius);
        self.extent
            .include(Area::around(centre, DVec2::splat(radius)));
        self.obstacles.discs.push((centre, radius));
        self.svg.circle(centre, radius, fill, Some(stroke));
    }

    /// A word in the middle of a disc; beside it, where the disc is too small or an
    /// arrow ends there.
    pub(super) fn upon(&mut self, text: &str, centre: DVec2, radius: f64, beside: DVec2) {
        self.upon.push((text.to_owned(), centre, radius, beside));
    }

    fn write_upon(&mut self) {
        for (text, centre, radius, beside) in std::mem::take(&mut self.upon) {
            let area = Self::area(&text, self.place(centre));
            let mut tips = self.obstacles.points.iter();
            let is_free = !self.labels.iter().any(|it| it.overlaps(&area))
                && !tips.any(|tip| area.distance(*tip) < TIP);
            if is_free && 2.0 * self.scale * radius >= Svg::label_width(&text) + 6.0 {
                self.mark(&text, centre, Ink::Text);
            } else {
                self.label(&text, centre + radius * beside, beside, Ink::Text);
            }
        }
    }

    /// A label near a place, if possible on this side of it; written at the end, the
    /// first ones have the first choice.
    pub(super) fn label(&mut self, text: &str, at: DVec2, towards: DVec2, ink: Ink) {
        self.wait(text, at, towards, ink, false);
    }

    /// The same for an arc, to which a line leads where the label is further off.
    pub(super) fn arc_label(&mut self, text: &str, at: DVec2, towards: DVec2, ink: Ink) {
        self.wait(text, at, towards, ink, true);
    }

    fn wait(&mut self, text: &str, at: DVec2, towards: DVec2, ink: Ink, led: bool) {
        self.waiting.push(Label {
            text: text.to_owned(),
            at: self.place(at),
            towards: dvec2(towards.x, -towards.y).normalize_or(DVec2::X),
            ink,
            led,
        });
    }

    /// A label just there.
    pub(super) fn mark(&mut self, text: &str, at: DVec2, ink: Ink) {
        let at = self.place(at);
        let area = Self::area(text, at);
        self.extent.include(area);
        self.labels.push(area);
        self.marks.push((text.to_owned(), at, ink));
    }

    fn area(text: &str, middle: DVec2) -> Area {
        Area::around(
            middle,
            dvec2(Svg::label_width(text) / 2.0 + LABEL.1, LABEL.0 / 2.0),
        )
    }

    /// Finds a place for all labels, and writes them over all else.
    pub(super) fn place_labels(&mut self) {
        self.write_upon();
        for (text, at, ink) in std::mem::take(&mut self.marks) {
            self.svg.label(&text, at, Anchor::Middle, ink);
        }
        for label in std::mem::take(&mut self.waiting) {
            let half = Self::area(&label.text, DVec2::ZERO).half();
            let middle = self
                .obstacles
                .free_place(label.at, label.towards, half, &self.labels);
            let area = Area::around(middle, half);
            self.extent.include(area);
            self.labels.push(area);
            if label.led && area.distance(label.at) > LEADER {
                let end = area.nearest(label.at);
                self.svg
                    .line(label.at, end, Stroke::new(Ink::Dim).wide(0.6));
            }
            self.svg
                .label(&label.text, middle, Anchor::Middle, label.ink);
        }
    }

    /// The picture, as large as its content.
    pub(super) fn picture(self) -> Svg {
        let margin = DVec2::splat(MARGIN);
        let (least, most) = (self.extent.least - margin, self.extent.most + margin);
        self.svg.framed(least.floor(), most.ceil())
    }

    fn see(&mut self, from: DVec2, to: DVec2) {
        self.extent.include(Area::between(from, to));
        self.obstacles.lines.push((from, to));
    }
}
