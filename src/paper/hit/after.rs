//! Where both go.

use glam::DVec2;

use super::After;
use super::before::speed;
use super::sheet::Sheet;
use super::stage::Stage;
use crate::numbers::degrees;
use crate::paper::{Ink, Stroke};

/// Radius of an angle's arc, in radii of its disc.
const ARC: f64 = 1.5;
/// An angle this near 90° is square, in radians.
const SQUARE: f64 = 1e-9;

/// Draws both departures with their angles.
pub(super) fn departures(sheet: &mut Sheet, stage: &Stage) {
    if stage.shown.after != After::Departures {
        return;
    }
    if stage.as_one() {
        return as_one(sheet, stage);
    }
    square_corner(sheet, stage);
    for (body, names) in [("v₁", "θ₁"), ("v₂", "θ₂")].into_iter().enumerate() {
        let v = stage.after(body);
        let (centre, radius) = (stage.contact[body], stage.radius(body));
        match stage.direction(v) {
            Some(direction) => {
                angle(sheet, stage, (centre, ARC * radius), names.1, v);
                // From the middle to the rim it is the way, and then the velocity.
                let rim = centre + radius * direction;
                sheet.line(centre, rim, Stroke::new(Ink::Accent));
                arrow(sheet, stage, rim, names.0, v);
            }
            None => still(sheet, stage, body, names.0),
        }
    }
}

/// Two discs that stick go on as one, from their common centre of mass.
fn as_one(sheet: &mut Sheet, stage: &Stage) {
    let [m1, m2] = [stage.mass(0), stage.mass(1)];
    let [c1, c2] = stage.contact;
    let centre = c1 + (c2 - c1) * (m2 / (m1 + m2));
    let v = stage.after(0);
    match stage.direction(v) {
        Some(direction) => {
            angle(sheet, stage, (centre, ARC * stage.unit()), "θ", v);
            let rim = [0, 1]
                .map(|body| way_out(stage.contact[body] - centre, stage.radius(body), direction));
            let rim = centre + rim[0].max(rim[1]) * direction;
            sheet.line(centre, rim, Stroke::new(Ink::Accent));
            arrow(sheet, stage, rim, "V", v);
        }
        None => still(sheet, stage, 0, "V"),
    }
}

/// How far it is from the origin along `direction` to where that leaves a circle for
/// good; 0 where it never meets it.
fn way_out(centre: DVec2, radius: f64, direction: DVec2) -> f64 {
    let along = centre.dot(direction);
    let across = centre.perp_dot(direction);
    let half = (radius * radius - across * across).max(0.0).sqrt();
    (along + half).max(0.0)
}

fn arrow(sheet: &mut Sheet, stage: &Stage, from: DVec2, name: &str, v: DVec2) {
    let tip = from + stage.arrow(v);
    sheet.arrow(from, tip, Stroke::new(Ink::Accent).wide(2.2));
    sheet.label(&speed(stage, name, v), tip, v, Ink::Accent);
}

/// The arc from the striker's line of motion to where a disc goes.
pub(super) fn angle(sheet: &mut Sheet, stage: &Stage, arc: (DVec2, f64), name: &str, v: DVec2) {
    let (Some(heading), Some(direction)) = (stage.heading(), stage.direction(v)) else {
        return;
    };
    let (centre, radius) = arc;
    let turn = heading.angle_to(direction);
    let text = if stage.shown.numbers {
        format!("{name} = {}", degrees(turn.abs()))
    } else {
        name.to_owned()
    };
    let end = centre + 1.3 * radius * heading;
    sheet.line(centre, end, Stroke::new(Ink::Dim).dotted());
    if turn.abs() < 1e-6 {
        return sheet.label(&text, end, heading, Ink::Dim);
    }
    sheet.arc(centre, radius, heading, direction, Stroke::new(Ink::Dim));
    let middle = DVec2::from_angle(turn / 2.0).rotate(heading);
    sheet.arc_label(&text, centre + radius * middle, middle, Ink::Text);
}

fn still(sheet: &mut Sheet, stage: &Stage, body: usize, name: &str) {
    let (centre, radius) = (stage.contact[body], stage.radius(body));
    let free = (centre - stage.contact[1 - body]).normalize_or(DVec2::Y);
    let across = free.perp();
    let text = format!("{name} = 0: it stands still");
    sheet.label(&text, centre + radius * across, across, Ink::Accent);
}

/// The square corner between two departures, at the striker's centre: both lines pass
/// through it, for the target's runs along the line of impact.
fn square_corner(sheet: &mut Sheet, stage: &Stage) {
    let directions = [0, 1].map(|body| stage.direction(stage.after(body)));
    let ([Some(a), Some(b)], false) = (directions, stage.both_move()) else {
        return;
    };
    if a.dot(b).abs() > SQUARE {
        return;
    }
    let (corner, size) = (stage.contact[0], 0.34 * stage.radius(0));
    let stroke = Stroke::new(Ink::Accent).wide(1.3);
    sheet.line(corner + size * a, corner + size * (a + b), stroke);
    sheet.line(corner + size * b, corner + size * (a + b), stroke);
    sheet.line(
        corner,
        corner + stage.collision.contact_distance() * b,
        Stroke::new(Ink::Accent),
    );
}
