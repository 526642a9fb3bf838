//! A shot that is to be set: the striker on its way, a scale of offsets across it, and
//! where one of the two is to go.

use glam::DVec2;

use super::before;
use super::sheet::Sheet;
use super::stage::Stage;
use crate::paper::{Ink, Stroke};
use crate::physics::units::m_from_mm;
use crate::quiz::words::degrees;
use crate::quiz::{AimTask, Ray};

/// How much larger than other hits it is drawn, so that the scale can be read.
pub(super) const LARGER: f64 = 1.3;
/// Millimetres between two ticks of the scale, and between two that are numbered.
const TICK_MM: i32 = 5;
const NUMBER_MM: i32 = 10;
/// Length of the wanted way, in radii of the larger disc.
const WAY: f64 = 2.8;
/// Radius of its arc.
const ARC: f64 = 1.9;

/// Draws the shot. The target's place is the student's to mark on the scale; at 0, where
/// it is hit head-on, it is drawn in dashes.
pub(super) fn shot(sheet: &mut Sheet, stage: &Stage, aim: &AimTask) {
    let [striker, target] = [stage.start[0], stage.contact[1]];
    let heading = stage.along();
    let thin = Stroke::new(Ink::Dim).dashed();
    let end = target + (ARC + 0.6) * stage.unit() * heading;
    sheet.line(striker, end, thin);
    sheet.disc(target, stage.radius(1), None, thin);
    let solid = Stroke::new(Ink::Text).wide(1.5);
    sheet.disc(striker, stage.radius(0), Some(Ink::Wash), solid);
    scale(sheet, stage, target);
    before::velocities(sheet, stage);
    wanted(sheet, stage, aim, target);
}

/// The scale, across the striker's way through the target's centre.
fn scale(sheet: &mut Sheet, stage: &Stage, zero: DVec2) {
    let heading = stage.along();
    let right = -heading.perp();
    let reach = stage.collision.reach();
    sheet.line(
        zero - reach * right,
        zero + reach * right,
        Stroke::new(Ink::Text),
    );
    let unit = stage.unit();
    let last = (1e3 * reach / f64::from(TICK_MM)).floor() as i32;
    for tick in -last..=last {
        let offset_mm = TICK_MM * tick;
        let at = zero + m_from_mm(f64::from(offset_mm)) * right;
        let numbered = offset_mm % NUMBER_MM == 0;
        let length = if numbered { 0.2 } else { 0.1 } * unit;
        sheet.line(
            at - length * heading,
            at + length * heading,
            Stroke::new(Ink::Text),
        );
        // Every second number where there is no room for each.
        let crowded = sheet.length(m_from_mm(f64::from(NUMBER_MM))) < 22.0;
        if numbered && offset_mm != 0 && !(crowded && offset_mm % (2 * NUMBER_MM) != 0) {
            let text = offset_mm.abs().to_string();
            sheet.mark(&text, at - 0.5 * unit * heading, Ink::Dim);
        }
    }
    let beyond = 0.25 * unit;
    for (side, name) in [(-right, "left, mm"), (right, "right, mm")] {
        sheet.label(name, zero + (reach + beyond) * side, side, Ink::Dim);
    }
}

/// Where one of the two is to go, and how far that turns from the striker's way.
fn wanted(sheet: &mut Sheet, stage: &Stage, aim: &AimTask, from: DVec2) {
    let heading = stage.along();
    let (name, turn) = match aim.ray {
        Ray::Striker => ("striker", aim.wanted),
        Ray::Target => ("target", -aim.wanted),
    };
    let direction = DVec2::from_angle(turn).rotate(heading);
    let tip = from + WAY * stage.unit() * direction;
    sheet.arrow(from, tip, Stroke::new(Ink::Accent).wide(2.2));
    sheet.label(&format!("{name}'s way"), tip, direction, Ink::Accent);
    if turn.abs() > 1e-6 {
        let radius = ARC * stage.unit();
        sheet.arc(from, radius, heading, direction, Stroke::new(Ink::Dim));
        let middle = DVec2::from_angle(turn / 2.0).rotate(heading);
        let at = from + radius * middle;
        sheet.arc_label(&degrees(turn.abs()), at, middle, Ink::Text);
    }
}
