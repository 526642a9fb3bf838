//! One particle that passes the target, with some others beside it.

use std::f64::consts::PI;

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::cautions;
use super::setup::{FoilSetup, Obstacle};
use super::words::{count, rounded};
use crate::beams::{BeamTarget, ScatteringLaw};
use crate::physics::beam::Beam;
use crate::physics::rutherford::FM;
use crate::widgets::Role;
use crate::widgets::panel::Panel;
use crate::widgets::picture::{DrawLayer, LabelSide, Pen, Picture, View};
use crate::widgets::tracks::draw_way;

/// The number of other particles on each side of the middle.
const BESIDE: i32 = 4;

/// The title of the picture.
pub(super) fn title(setup: &FoilSetup) -> &'static str {
    match setup.obstacle {
        Obstacle::Hard => "past a hard target",
        Obstacle::Nucleus => "past a nucleus",
    }
}

/// A path, in the units of the picture: fm for a nucleus, touching distances for a hard
/// target.
struct Path {
    points: Vec<DVec2>,
    /// The nearest point to the target's centre; for a hard target, the point of contact.
    nearest: Option<DVec2>,
    /// Scattering angle Θ in radians.
    angle: f64,
}

/// The scale of the picture: half its height in units, the number of steps per unit when the mouse
/// sets the offset, the name of the unit, and the number of decimal places of an offset.
const fn scale(setup: &FoilSetup) -> (f64, f64, &'static str, usize) {
    match setup.obstacle {
        Obstacle::Hard => (1.9, 20.0, "R", 2),
        Obstacle::Nucleus => (62.0, 1.0, "fm", 1),
    }
}

fn view(area: Rect, setup: &FoilSetup) -> View {
    let (half, ..) = scale(setup);
    View::fit(area, dvec2(-half, -half), dvec2(half, half))
}

/// The offset at a cell of the picture, in the units of the picture.
pub(super) fn offset_at(area: Rect, setup: &FoilSetup, (column, row): (u16, u16)) -> f64 {
    let (_, per_unit, ..) = scale(setup);
    let y = view(area, setup).world_at(column, row).y;
    (y * per_unit).round() / per_unit
}

fn offset(setup: &FoilSetup) -> f64 {
    match setup.obstacle {
        Obstacle::Hard => setup.offset_share,
        Obstacle::Nucleus => setup.offset_fm,
    }
}

/// The path at an offset, from a distance `reach` before the target to the same distance after it.
fn path(setup: &FoilSetup, offset: f64, reach: f64) -> Path {
    match setup.obstacle {
        Obstacle::Hard => hard_path(offset, reach),
        Obstacle::Nucleus => {
            let path = setup.scatterer().path(offset * FM);
            let points = path.points(reach * FM, 160);
            Path {
                points: points.iter().map(|p| *p / FM).collect(),
                nearest: Some(path.nearest() / FM),
                angle: path.angle,
            }
        }
    }
}

/// A straight path; at the touching distance 1 it is reflected, as light is by a mirror.
fn hard_path(offset: f64, reach: f64) -> Path {
    let start = dvec2(-reach, offset);
    if offset.abs() > 1.0 {
        return Path {
            points: vec![start, dvec2(reach, offset)],
            nearest: None,
            angle: 0.0,
        };
    }
    let contact = dvec2(-(1.0 - offset * offset).sqrt(), offset);
    let law = ScatteringLaw {
        target: BeamTarget::Hard,
        beam: Beam::Board,
    };
    let angle = law.angle(offset.abs());
    let turned = if offset < 0.0 { -angle } else { angle };
    Path {
        points: vec![start, contact, contact + DVec2::from_angle(turned) * reach],
        nearest: Some(contact),
        angle,
    }
}

pub(super) fn picture(setup: &FoilSetup, area: Rect) -> Picture {
    let view = view(area, setup);
    let (half, ..) = scale(setup);
    let mut picture = Picture::new(view);
    // The paths reach the corners of a picture of any width.
    let wide = (view.to_world(dvec2(f64::from(area.right()), 0.0)).x).abs();
    let reach = 1.2 * wide.hypot(half).max(half);
    let axis = Pen::new(Role::Axis).dotted();
    picture.line(dvec2(-reach, 0.0), dvec2(reach, 0.0), axis);
    // A head-on particle would return along its own path, so its path is left out.
    for i in (-BESIDE..=BESIDE).filter(|i| *i != 0) {
        let beside = path(setup, 0.9 * half * f64::from(i) / f64::from(BESIDE), reach);
        picture.curve(beside.points, Pen::new(Role::Trail).dotted());
    }
    // For a hard target the disc has radius R; for a nucleus it only marks the position.
    let role = match setup.obstacle {
        Obstacle::Hard => Role::Coin,
        Obstacle::Nucleus => Role::Marble,
    };
    picture.disc(DVec2::ZERO, 1.0, role, ' ');
    draw_particle(setup, &mut picture, reach);
    picture
}

/// Draws the particle with the chosen offset, and its measurements.
fn draw_particle(setup: &FoilSetup, picture: &mut Picture, reach: f64) {
    let offset = offset(setup);
    let set = path(setup, offset, reach);
    let pen = Pen::new(Role::StrikerOut).on(DrawLayer::Vector);
    if let Some(nearest) = set.nearest {
        match setup.obstacle {
            Obstacle::Hard => {
                let pen = Pen::new(Role::LineOfImpact).dashed();
                picture.line(nearest, nearest * 1.7, pen);
            }
            Obstacle::Nucleus => picture.line(DVec2::ZERO, nearest, Role::LineOfImpact),
        }
    }
    // The undeflected path, from which the angle is measured.
    let straight = Pen::new(Role::Aim).dashed();
    let from = set.nearest.map_or(0.0, |nearest| nearest.x.max(-reach));
    picture.line(dvec2(from, offset), dvec2(reach, offset), straight);
    let Some((tip, direction)) = draw_way(picture, &set.points, pen) else {
        return;
    };
    let left = picture.view().world_at(picture.view().area().x + 1, 0).x;
    let (_, _, unit, decimals) = scale(setup);
    let angle = format!("Θ = {:.1}°", set.angle.to_degrees());
    let sides = LabelSide::towards(direction);
    picture.label(&angle, tip, &sides, Role::StrikerOut);
    let text = format!("b = {:.decimals$} {unit}", offset.abs());
    let sides = if offset < 0.0 {
        [LabelSide::BelowRight, LabelSide::AboveRight]
    } else {
        [LabelSide::AboveRight, LabelSide::BelowRight]
    };
    picture.label(&text, dvec2(left, offset), &sides, Role::Text);
    if let (Obstacle::Nucleus, Some(nearest)) = (setup.obstacle, set.nearest) {
        let text = format!("r_min = {:.1} fm", nearest.length());
        let sides = LabelSide::towards(-nearest.perp());
        picture.label(&text, nearest * 0.5, &sides, Role::Text);
    }
}

/// Writes the text below the settings.
pub(super) fn write<A>(setup: &FoilSetup, panel: &mut Panel<A>) {
    let set = path(setup, offset(setup), 1e4);
    panel.gap();
    let angle = format!("{:.1}°", set.angle.to_degrees());
    panel.coloured_fact("deflection Θ", angle, Role::StrikerOut);
    match setup.obstacle {
        Obstacle::Hard => write_hard(set.angle, setup.offset_share, panel),
        Obstacle::Nucleus => write_nucleus(setup, &set, panel),
    }
}

fn write_hard<A>(angle: f64, offset: f64, panel: &mut Panel<A>) {
    if offset.abs() <= 1.0 {
        let alpha = offset.abs().asin().to_degrees();
        panel.fact("angle α", format!("{alpha:.1}°"));
    }
    panel.gap();
    let text = if offset.abs() > 1.0 {
        "A miss: beyond R, the sum of the two radii, nothing touches and nothing is deflected. \
         A hard target acts only on contact."
    } else if angle >= PI - 1e-9 {
        "A head-on collision: straight in, then straight back. R is the sum of the two radii; the \
         target is so heavy that it stays where it is."
    } else {
        "The particle leaves like light from a mirror: at the same angle on the other side of the \
         line of impact. So Θ = 180° − 2 α, with sin α = b/R. The target is so heavy that it stays \
         at rest."
    };
    panel.paragraph(text, Role::Text);
}

fn write_nucleus<A>(setup: &FoilSetup, set: &Path, panel: &mut Panel<A>) {
    let d = setup.scatterer().head_on_approach / FM;
    let r_min = set.nearest.map_or(d, DVec2::length);
    panel.fact("closest r_min", format!("{r_min:.1} fm"));
    panel.fact("head-on d", format!("{d:.1} fm"));
    panel.gap();
    cautions::write(setup, panel);
    let twice = 2.0 * setup.offset_fm.abs();
    let text = if twice < 0.1 {
        "Straight on: the α-particle is slowed, stops for an instant at d, where all its energy \
         is potential energy, and flies straight back."
            .into()
    } else {
        format!(
            "Two positive charges repel: the α-particle is slowed, deflected and sped up \
             again, on a hyperbola. tan(Θ/2) = d/2b, here {d:.1}/{twice:.1}."
        )
    };
    panel.paragraph(text, Role::Text);
    panel.gap();
    // The radius of an atom of any of these metals is about 0.14 nm.
    let times = rounded(140_000.0 / d);
    let times = count((times / 100.0).round() as u64 * 100);
    let text = format!(
        "Even head-on, the α-particle comes no nearer than d. So the charge that deflects it lies \
         within d, and the radius of the atom is about {times} times d."
    );
    panel.paragraph(text, Role::Text);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setup(obstacle: Obstacle, offset: f64) -> FoilSetup {
        FoilSetup {
            obstacle,
            offset_share: offset,
            offset_fm: offset,
            ..FoilSetup::default()
        }
    }

    /// The drawn path leaves at the angle given by the law.
    #[test]
    fn a_drawn_path_ends_at_the_scattering_angle() {
        for (obstacle, offsets) in [
            (Obstacle::Hard, [-0.9, -0.3, 0.0, 0.5, 1.0, 1.2]),
            (Obstacle::Nucleus, [-50.0, -3.0, 0.0, 5.0, 20.0, 60.0]),
        ] {
            for offset in offsets {
                let path = path(&setup(obstacle, offset), offset, 1e9);
                let [.., before, last] = path.points[..] else {
                    panic!("no path at {offset}");
                };
                let direction = (last - before).to_angle();
                assert!((direction.abs() - path.angle).abs() < 1e-6, "{offset}");
                assert!(offset.abs() < 1e-9 || path.angle == 0.0 || direction * offset > 0.0);
            }
        }
    }

    /// On the disc's rim the angle of reflection equals the angle of incidence.
    #[test]
    fn a_hard_target_reflects_like_a_mirror() {
        for offset in [-0.95, -0.4, 0.1, 0.5, 0.8] {
            let path = hard_path(offset, 5.0);
            let contact = path.points[1];
            assert!((contact.length() - 1.0).abs() < 1e-12);
            let come = (contact - path.points[0]).normalize();
            let go = (path.points[2] - contact).normalize();
            assert!((go - come.reflect(contact)).length() < 1e-12, "{offset}");
        }
    }

    #[test]
    fn the_offset_set_by_a_click_is_drawn_in_the_clicked_row() {
        let area = Rect::new(1, 2, 48, 19);
        let nucleus = setup(Obstacle::Nucleus, 0.0);
        for row in area.top()..area.bottom() {
            let offset = offset_at(area, &nucleus, (9, row));
            let shown = view(area, &nucleus).cell_at(dvec2(0.0, offset));
            assert_eq!(shown.map(|(_, row)| row), Some(row));
        }
    }
}
