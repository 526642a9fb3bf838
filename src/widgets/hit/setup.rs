//! The picture before the collision, with the given information and the predicted rays.

use glam::DVec2;
use ratatui::layout::Rect;

use super::sketch::Sketch;
use super::{Face, HitLayout, VelocityNames};
use crate::physics::{Collision, Frame};
use crate::quiz::{AimTask, Ray};
use crate::widgets::picture::{Pen, Picture, View, around};
use crate::widgets::{RayInput, Role};

pub(crate) use crate::quiz::Markings;

/// The minimum length of the faster disc's arrow, in radii of the larger disc.
const SHORTEST: f64 = 0.5;
/// The maximum length of the faster disc's arrow, in radii of the larger disc.
const LONGEST: f64 = 1.1;

/// Two discs that are about to collide, with the given information and the rays that the player is
/// turning.
pub(crate) fn setup_picture(
    area: Rect,
    faces: [Face; 2],
    collision: &Collision,
    given: Markings,
    rays: Option<&RayInput>,
) -> Picture {
    let mut sketch = setup(area, faces, collision, given);
    if let Some(rays) = rays {
        turned(&mut sketch, faces, rays);
    }
    sketch.picture
}

/// The title of [`contact_picture`].
pub(crate) const CONTACT: &str = "the contact, enlarged";

/// The striker's path to the target and the striker's outline at contact, which show the aim when
/// the discs on the board are small.
pub(crate) fn contact_picture(area: Rect, faces: [Face; 2], collision: &Collision) -> Picture {
    let [striker, target]: [DVec2; 2] = collision.placed_at_contact().into();
    let [r1, r2] = [collision.striker, collision.target].map(|disc| disc.radius);
    let [low, high] = around([(striker, r1), (target, r2)]);
    let mut picture = Picture::new(View::fit(area, low, high));
    let along = collision.relative_velocity().normalize_or_zero();
    let start = striker - 2.0 * (high - low).length() * along;
    picture.line(start, striker, Pen::new(Role::Aim).dotted());
    let [_, face] = faces;
    picture.disc(target, r2, face.role, face.letter);
    picture.circle(striker, r1, Role::Predicted);
    picture
}

/// A striker and a coin that are about to collide at `offset`, in metres, with the required path of
/// one of them.
pub(crate) fn aim_picture(area: Rect, aim: &AimTask, offset: f64, given: Markings) -> Picture {
    let mut sketch = setup(area, Face::STRIKER_AND_COIN, &aim.with(offset), given);
    sketch.wanted_way(aim);
    sketch.picture
}

fn setup(area: Rect, faces: [Face; 2], collision: &Collision, given: Markings) -> Sketch {
    let mut sketch = Sketch::new(HitLayout::new(area, collision));
    let radius = sketch.stage.radius(1);
    let places = before(&sketch.stage);
    let lengths = [1.35 * radius, 1.5 * radius];
    about_to_meet(&mut sketch, faces, places, given, lengths);
    sketch
}

/// Draws two discs before the contact, labelled with the given quantities. The offset is drawn at
/// the distance `ahead` beyond the centre of the target at contact, and the line of impact extends
/// beyond that centre by the distance `beyond`.
pub(super) fn about_to_meet(
    sketch: &mut Sketch,
    faces: [Face; 2],
    [p1, p2]: [DVec2; 2],
    given: Markings,
    [ahead, beyond]: [f64; 2],
) {
    let stage = sketch.stage;
    let [c1, c2] = stage.centres;
    if let Some(along) = stage.collision.relative_velocity().try_normalize() {
        let end = p1 + stage.room(p1, along) * along;
        sketch.picture.line(p1, end, Pen::new(Role::Aim).dotted());
        if given.offset {
            offset(sketch, along, ahead, given.figures);
        }
    }
    for (body, (place, face)) in [p1, p2].into_iter().zip(faces).enumerate() {
        let radius = stage.radius(body);
        sketch.picture.disc(place, radius, face.role, face.letter);
    }
    if stage.collision.alpha().is_some() {
        let ghost = Pen::new(Role::Trail).dotted();
        sketch.picture.circle(c1, stage.radius(0), ghost);
        if p2 != c2 {
            sketch.picture.circle(c2, stage.radius(1), ghost);
        }
        if given.angle {
            impact_angle(sketch, beyond, given.figures);
        }
    }
    moving(sketch, [p1, p2], given.figures);
    let spins = stage.collision.rims.spins;
    for (body, place) in [p1, p2].into_iter().enumerate() {
        if spins[body] != 0.0 {
            sketch.spin(body, spins, place, given.figures);
        }
    }
}

/// The positions at which the two discs are drawn before the collision, chosen so that both discs
/// are completely inside the picture.
fn before(stage: &HitLayout) -> [DVec2; 2] {
    let speed = stage.collision.relative_velocity().length();
    if speed > 0.0 {
        let time = 1.35 * stage.unit() / speed;
        let collision = &stage.collision;
        // Neither disc may begin outside the picture.
        let whole = |body: usize, v: DVec2| {
            let room = stage.room(stage.centres[body], -v.normalize_or_zero());
            (room - stage.radius(body)).max(0.0) / v.length()
        };
        let time = time.min(whole(0, collision.u1)).min(whole(1, collision.u2));
        collision.positions_before(time).into()
    } else {
        stage.centres
    }
}

/// Draws the impact parameter: the line through the coin's centre parallel to the striker's path,
/// and the distance between this line and the path.
fn offset(sketch: &mut Sketch, along: DVec2, ahead: f64, figures: bool) {
    let stage = sketch.stage;
    let [c1, c2] = stage.centres;
    let end = c2 + stage.room(c2, along) * along;
    sketch.picture.line(c2, end, Pen::new(Role::Aim).dotted());
    let across = along.perp() * (c2 - c1).dot(along.perp());
    if across.length() < 0.7 * stage.view.per_row() {
        return;
    }
    let foot = c2 + ahead * along;
    sketch.picture.line(foot, foot - across, Role::Arc);
    let offset_mm = stage.collision.offset.abs() * 1000.0;
    let text = named("b", figures.then(|| format!("{offset_mm:.1} mm")));
    sketch.label(text, foot - 0.5 * across, along, Role::Arc);
}

/// The name of a quantity, followed by its value if one is given.
fn named(name: &str, value: Option<String>) -> String {
    value.map_or(name.to_owned(), |value| format!("{name} = {value}"))
}

/// Draws the line of impact at the future contact, and the angle between it and the striker's path.
fn impact_angle(sketch: &mut Sketch, beyond: f64, figures: bool) {
    let stage = sketch.stage;
    let [c1, c2] = stage.centres;
    let (Some(n), Some(alpha)) = (stage.collision.normal(), stage.collision.alpha()) else {
        return;
    };
    let end = c2 + beyond * n;
    let pen = Pen::new(Role::LineOfImpact).dashed();
    sketch.picture.line(c1, end, pen);
    let Some(along) = stage.collision.relative_velocity().try_normalize() else {
        return;
    };
    if alpha.abs() > 0.05 {
        let (radius, start) = (0.8 * stage.radius(0), along.to_angle());
        let picture = &mut sketch.picture;
        picture.arc(c1, radius, start, start - alpha, Role::Arc);
    }
    let alpha_deg = alpha.to_degrees().abs();
    let text = named("α", figures.then(|| format!("{alpha_deg:.1}°")));
    sketch.label(text, end, n, Role::LineOfImpact);
}

/// Draws an arrow ahead of each moving disc.
pub(super) fn moving(sketch: &mut Sketch, places: [DVec2; 2], figures: bool) {
    let stage = sketch.stage;
    let speeds = [stage.collision.u1, stage.collision.u2];
    let fastest = speeds[0].length().max(speeds[1].length());
    let names = VelocityNames::new(&stage.collision, Frame::Laboratory);
    // An arrow stops short of a disc in its way; two arrows that point at each other share the
    // space.
    let facing = (0..2).filter(|body| stage.is_towards(places, *body, speeds[*body]));
    let apart = places[0].distance(places[1]) - stage.radius(0) - stage.radius(1);
    let room = match facing.count() {
        0 => f64::INFINITY,
        count => 0.9 * apart / count as f64,
    };
    let longest = room.clamp(SHORTEST * stage.unit(), LONGEST * stage.unit());
    for (body, name) in names.before.into_iter().enumerate() {
        let v = speeds[body];
        let Some(direction) = v.try_normalize() else {
            continue;
        };
        let length = longest * v.length() / fastest;
        let from = places[body] + stage.radius(body) * direction;
        let pen = Pen::new(Role::Incoming).bold();
        sketch.picture.arrow(from, from + length * direction, pen);
        let text = named(name, figures.then(|| format!("{:.2} m/s", v.length())));
        let beside = direction.perp() * stage.collision.side();
        // The label is beside its own disc, on the side away from the other disc.
        let away = match body {
            1 if beside.dot(places[1] - places[0]) < 0.0 => -beside,
            _ => beside,
        };
        let anchor = places[body] + stage.radius(body) * away;
        sketch.label(text, anchor, away, Role::Incoming);
    }
}

/// Draws the rays predicted so far, each starting at the rim of its disc at contact.
fn turned(sketch: &mut Sketch, faces: [Face; 2], rays: &RayInput) {
    let said = rays.so_far();
    for ray in Ray::BOTH.into_iter().filter(|ray| rays.asks(*ray)) {
        let name = faces[ray as usize].letter;
        let Some(angle) = said.get(ray) else {
            let still = rays.is_said(ray);
            let text = format!("{name} {}", if still { "stays still" } else { "?" });
            let centre = sketch.stage.centres[ray as usize];
            sketch.label(text, centre, DVec2::Y, Role::Predicted);
            continue;
        };
        let (direction, [rim, tip]) = sketch.stage.ray(ray, angle);
        let pen = match ray == rays.turning {
            true => Pen::new(Role::Predicted).bold(),
            false => Pen::new(Role::Predicted).dashed(),
        };
        sketch.picture.arrow(rim, tip, pen);
        let text = format!("{name} {}", rays.shown(ray));
        sketch.label(text, tip, direction, Role::Predicted);
    }
}

/// Points a ray at a position on the screen (in cells): if the button was just pressed (`choose`),
/// the ray whose tip is nearer, otherwise the ray that is already being turned.
pub(crate) fn point_at(
    area: Rect,
    collision: &Collision,
    rays: &mut RayInput,
    place: DVec2,
    choose: bool,
) {
    let stage = HitLayout::new(area, collision);
    let at = stage.view.to_world(place);
    let said = rays.so_far();
    let distance = |ray: Ray| {
        let tip = said.get(ray).map(|angle| stage.ray(ray, angle).1[1]);
        tip.unwrap_or(stage.centres[ray as usize]).distance(at)
    };
    let ray = if !choose {
        rays.turning
    } else if distance(Ray::Striker) <= distance(Ray::Target) {
        Ray::Striker
    } else {
        Ray::Target
    };
    if let Some(direction) = (at - stage.centres[ray as usize]).try_normalize() {
        rays.point(ray, stage.angle_deg_of(ray, direction));
    }
}

/// The offset in metres for which the coin is drawn at the given cell beside the striker's path.
pub(crate) fn drag_offset(area: Rect, collision: &Collision, place: DVec2) -> f64 {
    let stage = HitLayout::new(area, collision);
    let at = stage.view.to_world(place);
    let Some(along) = collision.relative_velocity().try_normalize() else {
        return collision.offset;
    };
    // A positive offset is to the right of the path. The contact point stays in the middle of the
    // picture, so the coin's centre moves by only a fraction of the offset.
    -at.dot(along.perp()) * collision.contact_distance() / collision.target.radius
}
