//! The tracks of two bodies.

use glam::DVec2;

/// The position of a body at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The time in seconds.
    pub t: f64,
    /// The position in metres.
    pub at: DVec2,
    /// The number of rows that were averaged to give the point.
    pub weight: f64,
    /// The line of the file.
    pub line: u32,
}

/// The points of a body, in order of time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Track {
    /// The name of the body.
    pub name: String,
    /// The points at which the body was marked.
    pub points: Vec<Point>,
}

/// A part of a track; as text, "before" or "after".
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::Display)]
#[strum(serialize_all = "lowercase")]
pub enum Leg {
    /// The part before the contact.
    Before,
    /// The part after the contact.
    After,
}

/// Both legs, in order.
pub(super) const LEGS: [Leg; 2] = [Leg::Before, Leg::After];

/// If there are more points than this, neighbours are averaged: the mean of points on a straight
/// line is on the line, and the fit then takes little longer for a million rows than for this
/// number.
const MOST_POINTS: usize = 5_000;
/// The number of groups of points, on each side of the contact, that are not averaged.
const SINGLE: usize = 3;

/// The points with neighbours averaged, except near the contact.
pub(super) fn thinned(points: &[Point], contact: f64) -> Vec<Point> {
    let group = points.len().div_ceil(MOST_POINTS);
    if group <= 1 {
        return points.to_vec();
    }
    let split = points.partition_point(|point| point.t < contact);
    let near = SINGLE * group;
    let (from, to) = (split.saturating_sub(near), (split + near).min(points.len()));
    let (before, rest) = points.split_at(from);
    let (single, after) = rest.split_at(to - from);
    let means = |part: &[Point]| -> Vec<Point> { part.chunks(group).map(mean).collect() };
    [means(before), single.to_vec(), means(after)].concat()
}

fn mean(points: &[Point]) -> Point {
    let weight = points.len() as f64;
    Point {
        t: points.iter().map(|point| point.t).sum::<f64>() / weight,
        at: points.iter().map(|point| point.at).sum::<DVec2>() / weight,
        weight,
        line: points.first().map_or(0, |point| point.line),
    }
}
