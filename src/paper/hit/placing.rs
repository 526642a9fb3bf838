//! A free place for a label.

use glam::{DVec2, dvec2};

/// Distances from its anchor at which a label is tried, in units of the picture.
const DISTANCES: [f64; 7] = [4.0, 8.0, 13.0, 20.0, 30.0, 44.0, 62.0];
/// Directions in which it is tried, in steps of 15° from the wanted one.
const STEPS: i32 = 12;
/// How far a label keeps from an arrow's tip.
pub(super) const TIP: f64 = 7.0;
/// How far it keeps from a disc's rim.
const RIM: f64 = 2.0;

/// A rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Area {
    pub(super) least: DVec2,
    pub(super) most: DVec2,
}

impl Area {
    pub(super) fn around(middle: DVec2, half: DVec2) -> Self {
        Self {
            least: middle - half,
            most: middle + half,
        }
    }

    pub(super) fn between(a: DVec2, b: DVec2) -> Self {
        Self {
            least: a.min(b),
            most: a.max(b),
        }
    }

    pub(super) fn include(&mut self, other: Self) {
        self.least = self.least.min(other.least);
        self.most = self.most.max(other.most);
    }

    pub(super) fn half(&self) -> DVec2 {
        (self.most - self.least) / 2.0
    }

    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.least.cmplt(other.most).all() && other.least.cmplt(self.most).all()
    }

    /// Distance from a point; 0 within.
    pub(super) fn distance(&self, point: DVec2) -> f64 {
        point.distance(self.nearest(point))
    }

    /// The point of it that is nearest to another.
    pub(super) fn nearest(&self, point: DVec2) -> DVec2 {
        point.clamp(self.least, self.most)
    }

    /// Whether a line crosses it.
    fn is_crossed(&self, (from, to): (DVec2, DVec2)) -> bool {
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        let step = to - from;
        for axis in 0..2 {
            if step[axis].abs() < 1e-12 {
                if from[axis] < self.least[axis] || from[axis] > self.most[axis] {
                    return false;
                }
                continue;
            }
            let a = (self.least[axis] - from[axis]) / step[axis];
            let b = (self.most[axis] - from[axis]) / step[axis];
            first = first.max(a.min(b));
            last = last.min(a.max(b));
        }
        first <= last
    }
}

/// What labels keep clear of, on paper.
#[derive(Default)]
pub(super) struct Obstacles {
    pub(super) lines: Vec<(DVec2, DVec2)>,
    pub(super) discs: Vec<(DVec2, f64)>,
    /// Tips of arrows.
    pub(super) points: Vec<DVec2>,
}

impl Obstacles {
    /// The middle of the best place for a label near `at`: it covers no other label, no
    /// disc and no arrow's tip, then no line if that can be, and is near its anchor on
    /// the wanted side.
    pub(super) fn free_place(
        &self,
        at: DVec2,
        towards: DVec2,
        half: DVec2,
        labels: &[Area],
    ) -> DVec2 {
        let mut best = (f64::INFINITY, at);
        for distance in DISTANCES {
            for step in -STEPS..=STEPS {
                let turn = f64::from(step) * std::f64::consts::PI / f64::from(STEPS);
                let direction = DVec2::from_angle(turn).rotate(towards);
                // Out to where the area's rim is at that distance.
                let out = (half.x * direction.x.abs()).hypot(half.y * direction.y.abs());
                let nearest = (half / direction.abs().max(dvec2(1e-9, 1e-9))).min_element();
                let middle =
                    at + (distance + f64::midpoint(out, nearest.min(half.length()))) * direction;
                let area = Area::around(middle, half);
                let cost = self.cost(&area, labels) + distance + 5.0 * turn.abs();
                if cost < best.0 {
                    best = (cost, middle);
                }
            }
        }
        best.1
    }

    fn cost(&self, area: &Area, labels: &[Area]) -> f64 {
        let count = |number: usize, each: f64| each * number as f64;
        let labels = labels.iter().filter(|it| it.overlaps(area)).count();
        let discs = self
            .discs
            .iter()
            .filter(|(centre, radius)| area.distance(*centre) < radius + RIM)
            .count();
        let tips = self
            .points
            .iter()
            .filter(|tip| area.distance(**tip) < TIP)
            .count();
        let lines = self.lines.iter().filter(|line| area.is_crossed(**line));
        count(labels, 4000.0)
            + count(discs, 2000.0)
            + count(tips, 2000.0)
            + count(lines.count(), 25.0)
    }
}
