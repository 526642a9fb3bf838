//! Printed pictures that students complete with a pencil: a protractor for two directions, or a
//! scale for an offset.

use glam::DVec2;

use super::setup::{about_to_meet, moving};
use super::sketch::Sketch;
use super::{Face, HitLayout, Markings};
use crate::physics::{Collision, units::m_from_mm};
use crate::quiz::{AimTask, Ray};
use crate::widgets::Role;
use crate::widgets::picture::{Pen, Picture, around};

/// The radius of the larger disc in a picture with a protractor, in columns.
const COLUMNS: f64 = 4.7;
/// The radius of the larger disc in a picture with a scale, in columns.
const LARGE_COLUMNS: f64 = 6.0;
/// The distance between two ticks of the scale, in millimetres.
const TICK_MM: i32 = 5;
/// The distance between two numbered ticks of the scale, in millimetres.
const NUMBER_MM: i32 = 10;
/// The length of the required path, in radii of the larger disc.
const WAY: f64 = 2.8;
/// The radius of the arc to the required path, in radii of the larger disc.
const ARC: f64 = 1.9;

fn along(collision: &Collision) -> DVec2 {
    let relative = collision.relative_velocity();
    relative.try_normalize().unwrap_or(DVec2::X)
}

/// Two discs that are about to collide, with an empty protractor around the position of the striker
/// at contact. The student draws both final paths from the centre of the protractor, including the
/// target's.
pub(crate) fn protractor_picture(collision: &Collision, given: Markings) -> Picture {
    let unit = collision.striker.radius.max(collision.target.radius);
    let (c1, c2) = collision.placed_at_contact();
    let radius = collision.contact_distance() + collision.target.radius + 0.45 * unit;
    let fastest = collision.u1.length().max(collision.u2.length());
    // The discs start so far away that the arrow is outside the protractor too.
    let time = (radius + 2.9 * unit) / fastest;
    let places: [DVec2; 2] = match time.is_finite() {
        true => collision.positions_before(time).into(),
        false => [c1, c2],
    };
    let along = along(collision);
    let far = radius + 1.2 * unit;
    let offset_room = if given.offset { 1.4 * unit } else { 0.0 };
    let corners = around([
        (c1, radius + 0.9 * unit),
        (places[0], 1.4 * unit),
        (places[1], 1.4 * unit),
        (c1 + far * along, offset_room),
    ]);
    let mut sketch = Sketch::new(HitLayout::between(collision, corners, COLUMNS));
    let stage = sketch.stage;
    let heading = collision.u1.try_normalize().unwrap_or(along);
    let picture = &mut sketch.picture;
    picture.circle(c1, radius, Role::BoardLine);
    for angle in (-170..=180).step_by(10) {
        let direction = DVec2::from_angle(f64::from(angle).to_radians()).rotate(heading);
        let (length, role) = match angle % 30 {
            0 => (0.26, Role::Dim),
            _ => (0.14, Role::BoardLine),
        };
        let from = c1 + (radius - length * unit) * direction;
        picture.line(from, c1 + radius * direction, Pen::new(role));
        let at = c1 + (radius + 0.4 * unit) * direction;
        let under = |body: usize| at.distance(places[body]) < stage.radius(body) + 0.4 * unit;
        // There is no label for straight back, because the striker's initial path is there.
        if angle % 30 == 0 && angle != 180 && !under(0) && !under(1) {
            picture.text(at, i32::abs(angle).to_string(), Role::Dim);
        }
    }
    picture.dot(c1, Role::Contact);
    let ahead = far - (c2 - c1).dot(along);
    let faces = Face::STRIKER_AND_COIN;
    about_to_meet(&mut sketch, faces, places, given, [ahead, 0.0]);
    sketch.picture
}

/// A shot whose offset the student chooses: the striker on its path, a perpendicular scale of
/// offsets in millimetres, drawn to the same scale as the discs, and the required path of one disc.
/// The student marks the position of the target on the scale; the head-on position at 0 is dotted.
pub(crate) fn scale_picture(aim: &AimTask) -> Picture {
    let collision = aim.with(0.0);
    let unit = collision.striker.radius.max(collision.target.radius);
    let (start, zero) = collision.placed_at_contact();
    let (heading, reach) = (along(&collision), collision.contact_distance());
    let start = start - (0.9 * collision.striker.radius + 2.1 * unit) * heading;
    let right = -heading.perp();
    let (name, turn) = match aim.ray {
        Ray::Striker => ("striker", aim.wanted),
        Ray::Target => ("target", -aim.wanted),
    };
    let way = DVec2::from_angle(turn).rotate(heading);
    let tip = zero + WAY * unit * way;
    let corners = around([
        (start, 1.6 * unit),
        (zero, (ARC + 0.9) * unit),
        (tip, 1.2 * unit),
        (zero - reach * right, 1.3 * unit),
        (zero + reach * right, 1.3 * unit),
    ]);
    let mut sketch = Sketch::new(HitLayout::between(&collision, corners, LARGE_COLUMNS));
    let picture = &mut sketch.picture;
    let dotted = Pen::new(Role::Trail).dotted();
    picture.line(start, zero + (ARC + 0.6) * unit * heading, dotted);
    picture.circle(zero, collision.target.radius, dotted);
    let ([face, _], radius) = (Face::STRIKER_AND_COIN, collision.striker.radius);
    picture.disc(start, radius, face.role, face.letter);
    picture.line(zero - reach * right, zero + reach * right, Role::Text);
    let last = (1e3 * reach / f64::from(TICK_MM)).floor() as i32;
    // If space is tight, only every second number is printed.
    let crowded = m_from_mm(f64::from(NUMBER_MM)) / unit * LARGE_COLUMNS < 3.5;
    let every = if crowded { 2 * NUMBER_MM } else { NUMBER_MM };
    for offset_mm in (-last..=last).map(|tick| TICK_MM * tick) {
        let at = zero + m_from_mm(f64::from(offset_mm)) * right;
        let long = offset_mm % NUMBER_MM == 0;
        let length = if long { 0.2 } else { 0.1 } * unit * heading;
        picture.line(at - length, at + length, Role::Text);
        if offset_mm != 0 && offset_mm % every == 0 {
            let below = at - 0.5 * unit * heading;
            picture.text(below, offset_mm.abs().to_string(), Role::Dim);
        }
    }
    picture.arrow(zero, tip, Pen::new(Role::CoinOut).bold());
    if turn.abs() > 1e-6 {
        let start = heading.to_angle();
        picture.arc(zero, ARC * unit, start, start + turn, Role::Arc);
        let middle = DVec2::from_angle(turn / 2.0).rotate(heading);
        sketch.angle("", turn, zero + ARC * unit * middle, middle);
    }
    sketch.label(format!("{name}'s path"), tip, way, Role::CoinOut);
    for (side, name) in [(-right, "left, mm"), (right, "right, mm")] {
        sketch.label(name, zero + (reach + 0.25 * unit) * side, side, Role::Dim);
    }
    moving(&mut sketch, [start, zero], true);
    sketch.picture
}
