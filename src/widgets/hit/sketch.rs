//! A picture of a hit being made: its stage, and the parts that all such pictures have.

use glam::DVec2;

use super::stage::HitLayout;
use crate::quiz::AimTask;
use crate::widgets::Role;
use crate::widgets::picture::{LabelSide, Pen, Picture};

/// Longest arrow, in radii of the larger disc.
const LONGEST: f64 = 2.8;
/// Longest arrow along n inside the discs, as a share of the way between the centres.
const SHORT: f64 = 0.85;
/// Room for the head of an arrow, in the same radii.
const HEAD: f64 = 0.3;
/// Radius of an arc, in radii of its disc.
const ARC: f64 = 1.55;
/// An angle this near 90° is square, in radians.
const SQUARE: f64 = 1e-9;
/// A share of the greatest speed below which a disc counts as standing still.
const STILL: f64 = 1e-9;
/// Width and height of the triangle of momenta as a share of the picture.
const INSET: DVec2 = DVec2::new(0.26, 0.30);

/// The scale of velocities as arrows.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArrowScale {
    /// Metres on the picture for each m/s.
    per_speed: f64,
    /// The greatest speed in the picture.
    fastest: f64,
}

impl ArrowScale {
    /// The largest scale at which arrows for `after`, drawn outwards from the rims
    /// at contact, stay within the picture.
    pub(super) fn fit(stage: &HitLayout, before: [DVec2; 2], after: [DVec2; 2]) -> Self {
        let speeds = before.iter().chain(&after).map(|v| v.length());
        let fastest = speeds.fold(0.0, f64::max);
        let room = after.iter().enumerate().filter_map(|(body, v)| {
            let direction = v.try_normalize()?;
            let room = stage.room(stage.centres[body], direction) - stage.radius(body);
            Some(room.max(0.0) * fastest / v.length())
        });
        Self::scaled(room.fold(LONGEST * stage.unit(), f64::min), fastest)
    }

    /// The largest scale at which u and its parts, drawn from the striker's centre, stay
    /// within the picture, and the part along n short of the coin's letter.
    pub(super) fn fit_split(stage: &HitLayout, u: DVec2, n: DVec2) -> Self {
        let fastest = u.length();
        let along = u.dot(n) * n;
        let room = |v: DVec2| {
            let direction = v.try_normalize()?;
            Some(stage.room(stage.centres[0], direction) * fastest / v.length())
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
    pub(super) fn direction(&self, v: DVec2) -> Option<DVec2> {
        v.try_normalize().filter(|_| !self.is_still(v))
    }
}

/// A picture of a hit being made.
pub(super) struct Sketch {
    pub(super) stage: HitLayout,
    pub(super) picture: Picture,
}

impl Sketch {
    pub(super) fn new(stage: HitLayout) -> Self {
        let picture = Picture::new(stage.view);
        Self { stage, picture }
    }

    /// A label on the side of its anchor that lies in a direction.
    pub(super) fn label(
        &mut self,
        text: impl Into<String>,
        anchor: DVec2,
        towards: DVec2,
        role: Role,
    ) {
        self.picture
            .label(text, anchor, &LabelSide::towards(towards), role);
    }

    /// The arc from the striker's direction to `v`, round the centre of `body`, with the
    /// line it is measured from. Gives the middle of the arc.
    pub(super) fn arc(&mut self, body: usize, v: DVec2, pen: Pen) -> Option<DVec2> {
        let heading = self.stage.heading();
        let turn = heading.angle_to(v.try_normalize()?);
        if turn.abs() < 1e-6 {
            return None;
        }
        let (centre, rim) = (self.stage.centres[body], self.stage.radius(body));
        let (radius, start) = (ARC * rim, heading.to_angle());
        let measured = [rim, 1.25 * radius].map(|away| centre + away * heading);
        self.picture.line(measured[0], measured[1], pen.dotted());
        self.picture.arc(centre, radius, start, start + turn, pen);
        let middle = centre + radius * DVec2::from_angle(start + turn / 2.0);
        self.angle(turn, middle, middle - centre);
        Some(middle)
    }

    /// An angle in radians, without its sign, beside `at`.
    pub(super) fn angle(&mut self, angle: f64, at: DVec2, towards: DVec2) {
        let text = format!("{:.1}°", angle.to_degrees().abs());
        self.label(text, at, towards, Role::Arc);
    }

    /// The square corner between two departures, at the striker's centre: both lines
    /// pass through it, the one along the tangent, the other along the line of impact.
    pub(super) fn square_corner(&mut self, v1: DVec2, v2: DVec2, pen: Pen) {
        if let (Some(a), Some(b)) = (v1.try_normalize(), v2.try_normalize())
            && a.dot(b).abs() <= SQUARE
        {
            let size = 0.42 * self.stage.radius(0);
            let corner = self.stage.centres[0];
            self.picture.square_corner(corner, [a, b], size, pen);
        }
    }

    /// A dashed way from the disc at the contact, and the mark where it is to be sent.
    pub(super) fn wanted_way(&mut self, aim: &AimTask) {
        let (direction, [rim, end]) = self.stage.ray(aim.ray, aim.wanted);
        // Too small to be a disc: a token.
        let radius = 0.01 * self.stage.view.per_row();
        self.picture.line(rim, end, Pen::new(Role::Good).dashed());
        self.picture.disc(end, radius, Role::Marble, ' ');
        self.label("mark", end, direction, Role::Good);
    }

    /// An arrow up to the rim of a disc that arrives, and its speed beside the visible
    /// part of it.
    pub(super) fn incoming(
        &mut self,
        scale: &ArrowScale,
        name: &str,
        (at, radius): (DVec2, f64),
        v: DVec2,
    ) {
        let Some(direction) = scale.direction(v) else {
            return;
        };
        let rim = at - radius * direction;
        let tail = rim - scale.per_speed * v;
        let pen = Pen::new(Role::Incoming).bold();
        self.picture.arrow(tail, rim, pen);
        let stage = &self.stage;
        let room = stage.room(at, -direction);
        let anchor = at - (radius + 0.55 * (room - radius).max(0.0)) * direction;
        // Across the arrow, on the side away from the coin.
        let across = DVec2::from_angle(stage.side()).rotate(direction).perp() * stage.side();
        let text = format!("{name} = {:.2} m/s", v.length());
        self.label(text, anchor, across, Role::Incoming);
    }

    /// An arrow away from the rim of a disc that leaves, with its speed at the tip; or
    /// that it stops. The arrow ends at the edge of the picture; where not even its head
    /// has room there is none. `room` is that around the disc's centre for the label.
    pub(super) fn outgoing(
        &mut self,
        scale: &ArrowScale,
        name: &str,
        (centre, radius, room): (DVec2, f64, f64),
        v: DVec2,
        role: Role,
    ) {
        let tip = scale.direction(v).map(|direction| {
            let rim = centre + radius * direction;
            let whole = scale.per_speed * v.length();
            let length = whole.min(self.stage.room(centre, direction) - radius);
            if length < whole && length < HEAD * self.stage.unit() {
                return rim;
            }
            let tip = rim + length * direction;
            self.picture.arrow(rim, tip, Pen::new(role).bold());
            tip
        });
        let (text, anchor, towards) = match tip {
            Some(tip) => (format!("{name} = {:.2} m/s", v.length()), tip, v),
            None => (
                format!("{name} = 0: it stands still"),
                centre + room * DVec2::NEG_Y,
                DVec2::NEG_Y,
            ),
        };
        // Beside the disc, as after a head-on hit the arrow may be on the other disc.
        let across = v.perp().normalize_or_zero();
        let across = across * 1.0_f64.copysign(across.y);
        self.picture
            .label(text, anchor, &LabelSide::towards(towards), role)
            .or(centre + room * across, &LabelSide::towards(across));
    }

    /// The striker's velocity and its parts along n and t, drawn from its centre, with
    /// the sides that close the rectangle.
    pub(super) fn split(&mut self, scale: &ArrowScale, u: DVec2, n: DVec2, t: DVec2) {
        let stage = &self.stage;
        let from = stage.centres[0];
        // Labels stand beyond the discs, which they never cover.
        let beyond = [
            stage.collision.contact_distance() + stage.radius(1),
            stage.radius(0),
        ];
        let end = |v: DVec2| from + scale.per_speed * v;
        let parts = [n, t].map(|axis| u.dot(axis) * axis);
        let closing = Pen::new(Role::TangentLine).dotted();
        for part in parts {
            self.picture.line(end(part), end(u), closing);
        }
        self.picture.arrow(from, end(u), Pen::new(Role::Incoming));
        let names = [("uₙ", Role::NormalPart), ("uₜ", Role::TangentPart)];
        for ((part, beyond), (name, role)) in parts.into_iter().zip(beyond).zip(names) {
            if scale.is_still(part) {
                continue;
            }
            self.picture.arrow(from, end(part), Pen::new(role).bold());
            let text = format!("{name} = {:.2} m/s", part.length());
            let reach = (scale.per_speed * part.length()).max(beyond);
            self.label(text, from + reach * part.normalize(), part, role);
        }
    }

    /// The speed that is split, where no arrow outside the disc tells it.
    pub(super) fn whole(&mut self, scale: &ArrowScale, u: DVec2) {
        let stage = &self.stage;
        let reach = (scale.per_speed * u.length()).max(stage.radius(0));
        let end = stage.centres[0] + reach * u.normalize_or_zero();
        let away = u.perp() * stage.side();
        let text = format!("u = {:.2} m/s", u.length());
        self.label(text, end, u + 0.5 * away, Role::Incoming);
    }

    /// The triangle of momenta in kg·m/s: total = p₁ + p₂, tail to tip, in the corner
    /// furthest from `busy`, the directions in which something is drawn.
    pub(super) fn triangle(&mut self, p1: DVec2, p2: DVec2, busy: &[DVec2]) {
        let total = p1 + p2;
        let points = [DVec2::ZERO, p1, total];
        let low = points.into_iter().fold(DVec2::INFINITY, DVec2::min);
        let high = points.into_iter().fold(DVec2::NEG_INFINITY, DVec2::max);
        let half = self.stage.half_extent();
        let size = 2.0 * INSET * half;
        let spread = high - low;
        let scale = (size.x / spread.x).min(size.y / spread.y);
        if !scale.is_finite() || scale <= 0.0 {
            return;
        }
        let middle = freest_corner(half, busy) * (half - size / 2.0);
        let place = |p: DVec2| middle + scale * (p - (low + high) / 2.0);
        let [tail, joint, tip] = points.map(place);
        let picture = &mut self.picture;
        picture.line(tail, tip, Role::Incoming);
        picture.line(tail, joint, Role::StrikerOut);
        picture.line(joint, tip, Role::CoinOut);
        let least = 0.05 * total.length();
        let side = 0.16 * p1.length().min(p2.length()) * scale;
        if p1.length().min(p2.length()) > least
            && p1.normalize().dot(p2.normalize()).abs() < 1e-9
            && side > 1.2 * self.stage.view.per_column()
        {
            picture.square_corner(joint, [tail - joint, tip - joint], side, Role::SquareCorner);
        }
        // The name goes below the base, where no side of the triangle is.
        let below = tail.y.min(joint.y).min(tip.y);
        let caption = DVec2::new(middle.x, below);
        let sides = [LabelSide::Below, LabelSide::Above];
        picture
            .label("p = p₁ + p₂", caption, &sides, Role::Dim)
            .apart();
    }
}

/// The corner, as signs of x and y, that keeps furthest from all busy directions.
fn freest_corner(half: DVec2, busy: &[DVec2]) -> DVec2 {
    let corners = [(-1.0, 1.0), (-1.0, -1.0), (1.0, 1.0), (1.0, -1.0)].map(DVec2::from);
    let crowding = |corner: &DVec2| {
        let direction = (corner * half).normalize();
        busy.iter()
            .filter_map(|b| b.try_normalize())
            .map(|b| b.dot(direction))
            .fold(-1.0, f64::max)
    };
    corners
        .into_iter()
        .min_by(|a, b| crowding(a).total_cmp(&crowding(b)))
        .unwrap_or(DVec2::NEG_ONE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corner_away_from_everything_is_taken() {
        let half = DVec2::new(4.0, 3.0);
        let busy = [DVec2::new(1.0, 1.0), DVec2::new(1.0, -0.5), DVec2::NEG_X];
        let corner = freest_corner(half, &busy);
        assert!(corner.x < 0.0);
        let busy = [
            DVec2::new(-1.0, 0.4),
            DVec2::new(1.0, 1.0),
            DVec2::new(1.0, -1.0),
        ];
        assert_eq!(freest_corner(half, &busy), DVec2::new(-1.0, -1.0));
    }
}
