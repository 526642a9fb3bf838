//! The discs before they meet, their ways, and the line of impact.

use glam::DVec2;

use super::After;
use super::sheet::Sheet;
use super::stage::Stage;
use crate::numbers::significant;
use crate::paper::{Ink, Stroke};
use crate::physics::units::g_from_kg;

/// Draws what lies under the discs: their ways and the line of impact.
pub(super) fn lines(sheet: &mut Sheet, stage: &Stage) {
    let way = Stroke::new(Ink::Dim).dashed();
    for body in 0..2 {
        if stage.start[body] != stage.contact[body] {
            sheet.line(stage.start[body], stage.contact[body], way);
        }
    }
    if let Some((from, to)) = line_of_impact(stage) {
        sheet.line(from, to, Stroke::new(Ink::Accent).centre_line());
    }
}

/// Names the line of impact.
pub(super) fn name_line(sheet: &mut Sheet, stage: &Stage) {
    if let Some((from, to)) = line_of_impact(stage)
        && stage.shown.line_of_impact
    {
        // At the end where less is going on.
        let (end, direction) = match stage.shown.after {
            After::Nothing => (to, to - from),
            _ => (from, from - to),
        };
        sheet.label("line of impact", end, direction, Ink::Accent);
    }
}

/// The ends of the line of impact, if it is shown.
fn line_of_impact(stage: &Stage) -> Option<(DVec2, DVec2)> {
    let normal = stage.outcome.normal?;
    if !stage.shown.line_of_impact && !stage.shown.angle {
        return None;
    }
    let [c1, c2] = stage.contact;
    let behind = if stage.shown.line_of_impact {
        stage.radius(0) + 0.5 * stage.unit()
    } else {
        0.0
    };
    let ahead = match stage.shown.after {
        After::Nothing => stage.radius(1) + 1.1 * stage.unit(),
        // Further on, the protractor would say where the target goes.
        After::Space => 0.0,
        After::Departures => stage.radius(1) + 0.4 * stage.unit(),
    };
    Some((c1 - behind * normal, c2 + ahead * normal))
}

/// Draws both discs before the hit, and where they are at contact.
pub(super) fn discs(sheet: &mut Sheet, stage: &Stage) {
    for body in 0..2 {
        let radius = stage.radius(body);
        let (start, contact) = (stage.start[body], stage.contact[body]);
        let fill = [Ink::Wash, Ink::Paper][body];
        sheet.disc(start, radius, Some(fill), Stroke::new(Ink::Text).wide(1.5));
        if start != contact {
            sheet.disc(contact, radius, None, Stroke::new(Ink::Text).dashed());
        }
    }
    for body in 0..2 {
        let (start, radius) = (stage.start[body], stage.radius(body));
        if stage.shown.masses {
            let mass = format!("{} g", significant(g_from_kg(stage.mass(body))));
            let free = (start - stage.contact[1 - body]).normalize_or(DVec2::Y);
            // Its own place at contact may lie across a disc that comes slowly.
            let moved = start.distance(stage.contact[body]);
            if moved == 0.0 || moved >= 2.0 * radius {
                sheet.upon(&mass, start, radius, free);
            } else {
                sheet.label(&mass, start + radius * free, free, Ink::Text);
            }
        }
    }
}

/// Draws the velocities before the hit.
pub(super) fn velocities(sheet: &mut Sheet, stage: &Stage) {
    for body in 0..2 {
        let u = stage.before(body);
        let Some(direction) = stage.direction(u) else {
            continue;
        };
        let rim = stage.start[body] + stage.radius(body) * direction;
        let tip = rim + stage.arrow(u);
        sheet.arrow(rim, tip, Stroke::new(Ink::Text).wide(1.8));
        let name = match (stage.both_move(), body) {
            (false, _) => "u",
            (true, 0) => "u₁",
            (true, _) => "u₂",
        };
        let text = speed(stage, name, u);
        // On the side away from the other disc.
        let across = direction.perp();
        let away = (stage.contact[body] - stage.contact[1 - body]).dot(across);
        let across = if away < -1e-9 { -across } else { across };
        sheet.label(&text, rim.midpoint(tip), across, Ink::Text);
    }
}

/// A velocity's letter, with its size where those are shown.
pub(super) fn speed(stage: &Stage, name: &str, v: DVec2) -> String {
    if stage.shown.speeds {
        format!("{name} = {} m/s", significant(v.length()))
    } else {
        name.to_owned()
    }
}
