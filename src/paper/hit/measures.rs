//! What is measured of a hit: the offset and the impact angle; and the protractor for
//! what is asked.

use glam::DVec2;

use super::After;
use super::sheet::Sheet;
use super::stage::Stage;
use crate::numbers::{degrees, millimetres};
use crate::paper::{Ink, Stroke};
use crate::physics::units::mm_from_m;

/// An offset below this share of r₁ + r₂ is head-on: there is nothing between the two
/// lines.
const HEAD_ON: f64 = 1e-9;

/// Draws an empty protractor, every 10° from the striker's direction, the numbers on
/// both sides.
pub(super) fn protractor(sheet: &mut Sheet, stage: &Stage) {
    if stage.shown.after != After::Space {
        return;
    }
    let (centre, radius) = (stage.contact[0], stage.protractor());
    let heading = stage.heading().unwrap_or(stage.along());
    sheet.ring(centre, radius, Stroke::new(Ink::Faint));
    let unit = stage.unit();
    for step in -17..=18 {
        let angle: i32 = 10 * step;
        let direction = DVec2::from_angle(f64::from(angle).to_radians()).rotate(heading);
        let (length, ink) = match angle % 30 {
            0 => (0.26, Ink::Dim),
            _ => (0.14, Ink::Faint),
        };
        let from = centre + (radius - length * unit) * direction;
        sheet.line(from, centre + radius * direction, Stroke::new(ink));
        // Straight back the striker comes in.
        let at = centre + (radius + 0.4 * unit) * direction;
        let under = |body: usize| at.distance(stage.start[body]) < stage.radius(body) + 0.4 * unit;
        if angle % 30 == 0 && angle != 180 && !under(0) && !under(1) {
            sheet.mark(&format!("{}", angle.abs()), at, Ink::Dim);
        }
    }
    let straight = centre + (radius - 0.26 * unit) * heading;
    sheet.line(centre, straight, Stroke::new(Ink::Faint));
    sheet.ring(centre, 0.035 * unit, Stroke::new(Ink::Text));
}

/// Draws the impact angle between the striker's line of motion and the line of impact.
pub(super) fn angle(sheet: &mut Sheet, stage: &Stage) {
    let (Some(normal), true) = (stage.outcome.normal, stage.shows_angle()) else {
        return;
    };
    let (centre, along) = (stage.contact[0], stage.along());
    let radius = arc_radius(stage);
    if stage.shown.after != After::Departures {
        let end = centre + (radius + 0.3 * stage.unit()) * along;
        sheet.line(centre, end, Stroke::new(Ink::Dim).dashed());
    }
    let alpha = stage.collision.alpha().unwrap_or_default();
    let text = if stage.shown.numbers {
        format!("α = {}", degrees(alpha.abs()))
    } else {
        "α".to_owned()
    };
    sheet.arc(
        centre,
        radius,
        along,
        normal,
        Stroke::new(Ink::Accent).wide(1.3),
    );
    let middle = (along + normal).normalize_or(along);
    sheet.arc_label(&text, centre + radius * middle, middle, Ink::Accent);
}

/// Radius of the arc of α: beyond the target, where there is room for it; within the
/// striker's place, where the departures are shown.
fn arc_radius(stage: &Stage) -> f64 {
    match stage.shown.after {
        After::Departures => 0.62 * stage.radius(0),
        After::Space => 0.5 * stage.radius(0).min(stage.unit()),
        After::Nothing => stage.collision.contact_distance() + stage.radius(1) + 0.5 * stage.unit(),
    }
}

/// Draws the offset: the striker's line of motion and the one through the target's
/// centre, with the distance between them.
pub(super) fn offset(sheet: &mut Sheet, stage: &Stage) {
    if !stage.shown.offset {
        return;
    }
    let (collision, along) = (&stage.collision, stage.along());
    let [c1, c2] = stage.contact;
    let text = if stage.shown.numbers {
        format!("b = {}", millimetres(mm_from_m(collision.offset.abs())))
    } else {
        "b".to_owned()
    };
    let thin = Stroke::new(Ink::Dim);
    // How far along the striker's line, from its place at contact.
    let target = (c2 - c1).dot(along);
    let unit = stage.unit();
    let far = match stage.shown.after {
        After::Nothing if stage.shows_angle() => arc_radius(stage) + 0.9 * unit,
        After::Nothing => target + stage.radius(1) + 0.7 * unit,
        After::Space => stage.protractor() + 1.1 * unit,
        // Behind, where nothing departs.
        After::Departures => {
            let start = (stage.start[0] - c1).dot(along);
            start.min(target) - stage.radius(0) - 0.7 * unit
        }
    };
    let over = 0.25 * unit * far.signum();
    let across = c2 - c1 - target * along;
    let (on_line, on_target) = (c1 + far * along, c1 + far * along + across);
    sheet.line(c1, on_line + over * along, thin.dotted());
    sheet.line(c2, on_target + over * along, thin.dotted());
    if collision.offset.abs() > HEAD_ON * collision.contact_distance() {
        let between = 0.5 * across;
        let stroke = Stroke::new(Ink::Accent).wide(1.3);
        sheet.arrow(on_line + between, on_line, stroke);
        sheet.arrow(on_line + between, on_target, stroke);
        sheet.label(&text, on_line + between, far.signum() * along, Ink::Accent);
    } else {
        sheet.label(
            &text,
            on_line + over * along,
            far.signum() * along,
            Ink::Accent,
        );
    }
}
