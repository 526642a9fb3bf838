//! A picture of a collision under construction, with the elements that all of these pictures share.

use glam::DVec2;

use super::stage::HitLayout;
use crate::quiz::AimTask;
use crate::widgets::Role;
use crate::widgets::picture::{DrawLayer, Label, LabelSide, Pen, Picture, around};

/// The length of the longest arrow, in radii of the larger disc.
const LONGEST: f64 = 2.8;
/// The length of the longest arrow of a velocity that is drawn with its components, in radii of
/// the larger disc.
const LONGEST_ROOTED: f64 = 2.9;
/// The length of the longest component along n that begins at a disc's centre, as a fraction of the
/// distance to the other centre, where the component of the other disc begins.
const LONGEST_ALONG: f64 = 0.96;
/// The distance between a leading disc's rim and the arrow drawn beside that disc, in radii of the
/// larger disc.
const BESIDE: f64 = 0.4;
/// The space for the head of an arrow, in radii of the larger disc.
const HEAD: f64 = 0.3;
/// The radius of an arc, in radii of its disc.
const ARC: f64 = 1.55;
/// The smallest angle for which an arc is drawn, in radians.
const LEAST_ARC: f64 = 1e-6;
/// The tolerance for a right angle: the largest cosine that still counts as 0.
const SQUARE: f64 = 1e-9;
/// The fraction of the greatest speed below which a disc counts as at rest.
const STILL: f64 = 1e-9;
/// A speed below this, in m/s, is printed as 0.00.
const LEAST_SPEED: f64 = 0.005;
/// The greatest width and height of the triangle of momenta, as fractions of those of the picture.
const INSET: DVec2 = DVec2::new(0.26, 0.30);

/// The scale of velocity arrows.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArrowScale {
    /// Metres in the picture per m/s.
    per_speed: f64,
    /// The greatest speed in the picture.
    fastest: f64,
}

impl ArrowScale {
    /// The largest scale at which the arrows of `after`, drawn outwards from the rims at contact,
    /// fit into the picture.
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

    /// The largest scale at which velocities attached at their roots fit into the picture, and at
    /// which a component `along` the line of impact that begins at one disc's centre does not reach
    /// the other disc's centre.
    pub(super) fn fit_rooted(
        stage: &HitLayout,
        along: DVec2,
        velocities: &[(Root, DVec2)],
    ) -> Self {
        let speeds = velocities.iter().map(|(_, v)| v.length());
        let fastest = speeds.fold(0.0, f64::max);
        let short = LONGEST_ALONG * stage.collision.contact_distance();
        let short = short * fastest / along.length();
        let room = velocities.iter().filter_map(|(root, v)| {
            let (at, outwards) = match root {
                Root::From(at) => (*at, v.try_normalize()?),
                Root::UpTo(at) => (*at, -v.try_normalize()?),
            };
            Some(stage.room(at, outwards) * fastest / v.length())
        });
        let longest = (LONGEST_ROOTED * stage.unit()).min(short);
        Self::scaled(room.fold(longest, f64::min), fastest)
    }

    /// The scale at which an arrow for the greatest speed has the length `longest`, in metres in
    /// the picture.
    fn scaled(longest: f64, fastest: f64) -> Self {
        let per_speed = if fastest > 0.0 {
            longest / fastest
        } else {
            0.0
        };
        Self { per_speed, fastest }
    }

    /// Whether `v` is negligible compared with the other speeds.
    pub(super) fn is_still(&self, v: DVec2) -> bool {
        v.length() <= STILL * self.fastest
    }

    /// The direction of `v`; `None` if it is negligible compared with the other speeds.
    pub(super) fn direction(&self, v: DVec2) -> Option<DVec2> {
        v.try_normalize().filter(|_| !self.is_still(v))
    }
}

/// The point at which a velocity and its components are attached.
#[derive(Debug, Clone, Copy)]
pub(super) enum Root {
    /// The velocity and its components begin at this point.
    From(DVec2),
    /// The velocity ends at this point; its components begin where the velocity begins.
    UpTo(DVec2),
}

impl Root {
    /// The point at which the arrow of the velocity begins.
    fn tail(self, way: DVec2) -> DVec2 {
        match self {
            Self::From(tail) => tail,
            Self::UpTo(tip) => tip - way,
        }
    }
}

/// A velocity with its name and the appearance of its arrow.
#[derive(Debug, Clone)]
pub(super) struct NamedVelocity {
    pub(super) name: String,
    pub(super) v: DVec2,
    pub(super) role: Role,
}

/// A picture of a collision under construction.
pub(super) struct Sketch {
    pub(super) stage: HitLayout,
    pub(super) picture: Picture,
}

impl Sketch {
    pub(super) fn new(stage: HitLayout) -> Self {
        let picture = Picture::new(stage.view);
        Self { stage, picture }
    }

    /// Adds a label beside its anchor, preferably in the given direction.
    pub(super) fn label(
        &mut self,
        text: impl Into<String>,
        anchor: DVec2,
        towards: DVec2,
        role: Role,
    ) -> &mut Label {
        self.picture
            .label(text, anchor, &LabelSide::towards(towards), role)
    }

    /// Draws the arc from one direction to another around the centre of `body`, with a line in the
    /// first direction, and the angle as a label.
    pub(super) fn arc(&mut self, body: usize, [from, to]: [DVec2; 2], name: &str, pen: Pen) {
        let (Some(from), Some(to)) = (from.try_normalize(), to.try_normalize()) else {
            return;
        };
        let turn = from.angle_to(to);
        if !Self::has_arc(from, to) {
            return;
        }
        let (centre, rim) = (self.stage.centres[body], self.stage.radius(body));
        let (radius, start) = (ARC * rim, from.to_angle());
        let measured = [rim, 1.25 * radius].map(|away| centre + away * from);
        self.picture.line(measured[0], measured[1], pen.dotted());
        self.picture.arc(centre, radius, start, start + turn, pen);
        let middle = centre + radius * DVec2::from_angle(start + turn / 2.0);
        self.angle(name, turn, middle, middle - centre);
    }

    /// Whether the angle between two directions is large enough for an arc.
    pub(super) fn has_arc(from: DVec2, to: DVec2) -> bool {
        from.angle_to(to).abs() >= LEAST_ARC
    }

    /// Writes the size of an angle, given in radians, beside `at`.
    pub(super) fn angle(&mut self, name: &str, angle: f64, at: DVec2, towards: DVec2) {
        let text = format!("{name}{:.1}°", angle.to_degrees().abs());
        self.label(text, at, towards, Role::Arc);
    }

    /// Draws the right-angle mark between the two final paths. Its corner is at the striker's
    /// centre, where the striker's path begins; the target's path lies on the line of impact, which
    /// passes through that centre.
    pub(super) fn square_corner(&mut self, v1: DVec2, v2: DVec2, pen: Pen) {
        if let (Some(a), Some(b)) = (v1.try_normalize(), v2.try_normalize())
            && a.dot(b).abs() <= SQUARE
        {
            let size = 0.42 * self.stage.radius(0);
            let corner = self.stage.centres[0];
            self.picture.square_corner(corner, [a, b], size, pen);
        }
    }

    /// Draws the target mark, and the required path to it as a dashed line from the disc's position
    /// at contact.
    pub(super) fn wanted_way(&mut self, aim: &AimTask) {
        let (direction, [rim, end]) = self.stage.ray(aim.ray, aim.wanted);
        // This radius is too small for a round disc, so a token is drawn instead.
        let radius = 0.01 * self.stage.view.per_row();
        self.picture.line(rim, end, Pen::new(Role::Good).dashed());
        self.picture.disc(end, radius, Role::Marble, ' ');
        self.label("mark", end, direction, Role::Good);
    }

    /// Draws an arrow that ends at the rim of an arriving disc, with the speed beside the visible
    /// part of the arrow. If the other disc is right behind this one, the arrow is drawn beside the
    /// disc.
    pub(super) fn incoming(
        &mut self,
        scale: &ArrowScale,
        name: &str,
        (body, at): (usize, DVec2),
        v: DVec2,
    ) {
        let Some(direction) = scale.direction(v) else {
            return;
        };
        let stage = &self.stage;
        let radius = stage.radius(body);
        let way = scale.per_speed * v;
        // The label is beside the arrow; the striker's is on the side away from the coin.
        let side = stage.collision.side();
        let across = DVec2::from_angle(side).rotate(direction).perp() * side;
        let (tip, anchor, across) = if stage.runs_ahead(body, v) {
            let out = direction.perp();
            let out = out * 1.0_f64.copysign(out.dot(stage.centres[body]));
            let middle = at + (radius + BESIDE * stage.unit()) * out;
            (middle + way / 2.0, middle, out)
        } else {
            let room = stage.room(at, -direction);
            let anchor = at - (radius + 0.55 * (room - radius).max(0.0)) * direction;
            (at - radius * direction, anchor, across)
        };
        let pen = Pen::new(Role::Incoming).bold();
        self.picture.arrow(tip - way, tip, pen);
        let text = format!("{name} = {:.2} m/s", v.length());
        self.label(text, anchor, across, Role::Incoming).short(name);
    }

    /// Draws an arrow from the rim of a departing disc, with the speed at its tip, or writes that
    /// the disc stops. The arrow never extends beyond the picture, and is left out if there is no
    /// space for its head. `room` is the distance from the disc's centre to a label beside or below
    /// the disc.
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
                format!("{name} = 0: at rest"),
                centre + room * DVec2::NEG_Y,
                DVec2::NEG_Y,
            ),
        };
        // The label may also be beside the disc, because after a head-on collision the arrow may
        // overlap the other disc.
        let across = v.perp().normalize_or_zero();
        let across = across * 1.0_f64.copysign(across.y);
        self.picture
            .label(text, anchor, &LabelSide::towards(towards), role)
            .or(centre + room * across, &LabelSide::towards(across));
    }

    /// Draws a velocity of a disc and its components along n and t, with the sides that complete
    /// the rectangle. If one of the components is zero, a single arrow is drawn, with both names.
    pub(super) fn split(
        &mut self,
        scale: &ArrowScale,
        (body, root): (usize, Root),
        whole: NamedVelocity,
        parts: &[NamedVelocity; 2],
    ) {
        let some = parts.iter().filter(|part| part.v.length() >= LEAST_SPEED);
        match some.collect::<Vec<_>>().as_slice() {
            [] => {
                let below = self.stage.centres[body] + self.stage.radius(body) * DVec2::NEG_Y;
                let text = format!("{} = 0: at rest", whole.name);
                self.label(text, below, DVec2::NEG_Y, whole.role);
            }
            [part] => {
                let name = match part.name == whole.name {
                    true => whole.name,
                    false => format!("{} = {}", whole.name, part.name),
                };
                self.velocity(scale, root, &NamedVelocity { name, ..whole });
            }
            both => {
                let tail = root.tail(scale.per_speed * whole.v);
                let end = |v: DVec2| tail + scale.per_speed * v;
                // The side that begins at the tip of one component has the length and colour of the
                // other component.
                for (part, other) in both.iter().zip(both.iter().rev()) {
                    let pen = Pen::new(other.role).dotted();
                    let closing = pen.on(DrawLayer::Construction);
                    self.picture.line(end(part.v), end(whole.v), closing);
                }
                // The longest arrow is drawn first, because all arrows share cells near the root.
                // Its name is written last, so that the names of the components have priority.
                let pen = Pen::new(whole.role).bold();
                self.picture.arrow(tail, end(whole.v), pen);
                for part in both {
                    let tip = end(part.v);
                    match root {
                        Root::From(_) => self.velocity(scale, root, part),
                        Root::UpTo(_) => {
                            self.picture.arrow(tail, tip, Pen::new(part.role).bold());
                            // The name is outside the rectangle, on the side away from the other
                            // disc.
                            let aside = (tip - end(whole.v / 2.0)).normalize_or_zero();
                            self.name(part, tip, aside + tip.normalize_or_zero());
                        }
                    }
                }
                let (at, towards) = self.free_end(root, [tail, end(whole.v)]);
                self.name(&whole, at, towards);
            }
        }
    }

    /// Draws a velocity as an arrow, with the speed at its free end.
    pub(super) fn velocity(&mut self, scale: &ArrowScale, root: Root, velocity: &NamedVelocity) {
        if scale.is_still(velocity.v) {
            return;
        }
        let way = scale.per_speed * velocity.v;
        let tail = root.tail(way);
        let tip = tail + way;
        self.picture
            .arrow(tail, tip, Pen::new(velocity.role).bold());
        let (at, towards) = self.free_end(root, [tail, tip]);
        self.name(velocity, at, towards);
    }

    /// The free end of an arrow, and the direction in which this end points. An end inside a disc
    /// is moved ahead to the rim if the arrow begins at its root, because labels never cover discs.
    fn free_end(&self, root: Root, [tail, tip]: [DVec2; 2]) -> (DVec2, DVec2) {
        let direction = (tip - tail).normalize_or_zero();
        if let Root::UpTo(_) = root {
            return (tail, -direction);
        }
        // A point outside one disc may be inside the other.
        let outside = (0..2).chain([0]).fold(tip, |at, body| {
            let (centre, radius) = (self.stage.centres[body], self.stage.radius(body));
            let to = centre - at;
            if to.length() >= radius {
                return at;
            }
            let across = to.perp_dot(direction);
            let half = radius.mul_add(radius, -across * across).max(0.0).sqrt();
            at + (to.dot(direction) + half) * direction
        });
        (outside, direction)
    }

    /// Writes the name and the magnitude of a velocity beside `at`, in the direction `towards`.
    fn name(&mut self, velocity: &NamedVelocity, at: DVec2, towards: DVec2) {
        let text = format!("{} = {:.2} m/s", velocity.name, velocity.v.length());
        self.label(text, at, towards, velocity.role)
            .short(&velocity.name);
    }

    /// Draws the triangle of momenta in kg·m/s, tail to tip, with total = p₁ + p₂. It is in the
    /// corner farthest from `busy`, the directions in which something else is drawn.
    pub(super) fn triangle(&mut self, p1: DVec2, p2: DVec2, busy: &[DVec2]) {
        let total = p1 + p2;
        let points = [DVec2::ZERO, p1, total];
        let [low, high] = around(points.map(|point| (point, 0.0)));
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
        // The name goes below the lowest corner, where there is no side of the triangle.
        let below = tail.y.min(joint.y).min(tip.y);
        let caption = DVec2::new(middle.x, below);
        let sides = [LabelSide::Below, LabelSide::Above];
        picture
            .label("p = p₁ + p₂", caption, &sides, Role::Dim)
            .apart();
    }
}

/// The corner, as signs of x and y, that is farthest from all busy directions.
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
    fn the_corner_furthest_from_busy_directions_is_chosen() {
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
