//! A hit as somebody has seen it: the ways in and out, and how far each was turned. It
//! gives away neither masses nor speeds.

use super::after::angle;
use super::sheet::Sheet;
use super::stage::Stage;
use crate::paper::{Ink, Stroke};

/// Length of every arrow, in radii of the larger disc: none tells of a speed.
const ARROW: f64 = 2.1;
/// Radius of an angle's arc, in radii of its disc.
const ARC: f64 = 1.5;

/// Draws both discs at contact, and the ways they came and went.
pub(super) fn ways(sheet: &mut Sheet, stage: &Stage) {
    for body in 0..2 {
        let fill = [Ink::Wash, Ink::Paper][body];
        let stroke = Stroke::new(Ink::Text).wide(1.5);
        sheet.disc(stage.contact[body], stage.radius(body), Some(fill), stroke);
    }
    for body in 0..2 {
        way_in(sheet, stage, body);
        way_out(sheet, stage, body);
    }
}

fn way_in(sheet: &mut Sheet, stage: &Stage, body: usize) {
    let (centre, radius) = (stage.contact[body], stage.radius(body));
    if let Some(direction) = stage.direction(stage.before(body)) {
        let rim = centre - radius * direction;
        let tail = rim - ARROW * stage.unit() * direction;
        sheet.arrow(tail, rim, Stroke::new(Ink::Text).wide(1.8));
        sheet.label("before", tail, -direction, Ink::Text);
    }
}

fn way_out(sheet: &mut Sheet, stage: &Stage, body: usize) {
    let (centre, radius) = (stage.contact[body], stage.radius(body));
    let v = stage.after(body);
    let Some(direction) = stage.direction(v) else {
        let free = (centre - stage.contact[1 - body]).normalize_or(glam::DVec2::Y);
        let across = free.perp();
        return sheet.label(
            "stands still",
            centre + radius * across,
            across,
            Ink::Accent,
        );
    };
    angle(sheet, stage, (centre, ARC * radius), ["θ₁", "θ₂"][body], v);
    let rim = centre + radius * direction;
    let tip = rim + ARROW * stage.unit() * direction;
    sheet.line(centre, rim, Stroke::new(Ink::Accent));
    sheet.arrow(rim, tip, Stroke::new(Ink::Accent).wide(2.2));
    sheet.label("after", tip, direction, Ink::Accent);
}
