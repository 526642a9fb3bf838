//! Velocities as arrows, all to one scale.

use glam::DVec2;

use super::stage::Stage;
use crate::widgets::Role;
use crate::widgets::ink::{Pen, Sheet};

/// Longest arrow, in radii of the larger disc.
const LONGEST: f64 = 2.8;

/// Longest arrow along n inside the discs, as a share of the way between the centres.
const SHORT: f64 = 0.85;

/// Room for the head of an arrow, in the same radii.
const HEAD: f64 = 0.3;

/// A share of the greatest speed below which a disc counts as standing still.
const STILL: f64 = 1e-9;

/// The scale of the arrows and what they start from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arrows {
    /// Metres on the picture for each m/s.
    pub(super) per_speed: f64,
    /// The greatest speed in the picture.
    pub(super) fastest: f64,
}

impl Arrows {
    /// The largest scale at which arrows for `after`, drawn outwards from the rims
    /// at contact, stay within the picture.
    pub(super) fn fit(stage: &Stage, before: [DVec2; 2], after: [DVec2; 2]) -> Self {
        let fastest = before
            .iter()
            .chain(&after)
            .map(|v| v.length())
            .fold(0.0, f64::max);
        let longest = LONGEST * stage.unit();
        let room = after.iter().enumerate().filter_map(|(body, v)| {
            let direction = v.try_normalize()?;
            let room = stage.room(stage.centres[body], direction) - stage.radius(body);
            Some(room.max(0.0) * fastest / v.length())
        });
        let longest = room.fold(longest, f64::min);
        Self::scaled(longest, fastest)
    }

    /// The largest scale at which u and its parts, drawn from the striker's centre, stay
    /// within the picture, and the part along n short of the coin's letter.
    pub(super) fn fit_split(stage: &Stage, u: DVec2, n: DVec2) -> Self {
        let fastest = u.length();
        let from = stage.centres[0];
        let along = u.dot(n) * n;
        let room = |v: DVec2| {
            let direction = v.try_normalize()?;
            Some(stage.room(from, direction) * fastest / v.length())
        };
        let short = SHORT * stage.collision.contact_distance() * fastest / along.length();
        let longest = [u, along, u - along]
            .into_iter()
            .filter_map(room)
            .chain([short])
            .fold(LONGEST * stage.unit(), f64::min);
        Self::scaled(longest, fastest)
    }

    /// The scale at which the greatest speed is so long, in metres on the picture.
    fn scaled(longest: f64, fastest: f64) -> Self {
        let per_speed = if fastest > 0.0 {
            longest / fastest
        } else {
            0.0
        };
        Self { per_speed, fastest }
    }

    /// Whether `v` is nothing beside the other speeds.
    pub(super) fn is_still(&self, v: DVec2) -> bool {
        v.length() <= STILL * self.fastest
    }

    /// The direction of `v`; `None` where it is nothing beside the other speeds.
    fn direction(&self, v: DVec2) -> Option<DVec2> {
        if self.is_still(v) {
            return None;
        }
        v.try_normalize()
    }

    /// An arrow away from the rim of a disc, and where its tip is. It ends at the edge of
    /// the picture; where not even its head has room the tip is on the rim.
    pub(super) fn outwards(
        &self,
        sheet: &mut Sheet,
        stage: &Stage,
        centre: DVec2,
        radius: f64,
        v: DVec2,
        role: Role,
    ) -> Option<DVec2> {
        let direction = self.direction(v)?;
        let rim = centre + radius * direction;
        let whole = self.per_speed * v.length();
        let room = stage.room(centre, direction) - radius;
        let length = whole.min(room);
        if length < whole && length < HEAD * stage.unit() {
            return Some(rim);
        }
        let tip = rim + length * direction;
        sheet.arrow(rim, tip, Pen::new(role).bold());
        Some(tip)
    }

    /// An arrow up to the rim of a disc; says whether there is one.
    pub(super) fn inwards(
        &self,
        sheet: &mut Sheet,
        centre: DVec2,
        radius: f64,
        v: DVec2,
        role: Role,
    ) -> bool {
        let Some(direction) = self.direction(v) else {
            return false;
        };
        let rim = centre - radius * direction;
        sheet.arrow(rim - self.per_speed * v, rim, Pen::new(role).bold());
        true
    }
}

/// The striker's velocity and its parts along n and t, drawn from its centre, with
/// the sides that close the rectangle.
pub(super) fn split(
    sheet: &mut Sheet,
    stage: &Stage,
    arrows: &Arrows,
    u: DVec2,
    n: DVec2,
    t: DVec2,
) {
    let from = stage.centres[0];
    let scale = arrows.per_speed;
    let along = from + scale * u.dot(n) * n;
    let across = from + scale * u.dot(t) * t;
    let whole = from + scale * u;
    let closing = Pen::new(Role::TangentLine).dotted();
    sheet.line(along, whole, closing);
    sheet.line(across, whole, closing);
    sheet.arrow(from, whole, Pen::new(Role::Incoming));
    if !arrows.is_still(u.dot(n) * n) {
        sheet.arrow(from, along, Pen::new(Role::NormalPart).bold());
    }
    if !arrows.is_still(u.dot(t) * t) {
        sheet.arrow(from, across, Pen::new(Role::TangentPart).bold());
    }
}
