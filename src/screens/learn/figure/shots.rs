//! Many unaimed shots at one disc at rest: equal masses, no energy lost.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::FigureArea;
use crate::physics::units::rad_from_deg;
use crate::widgets::Role;
use crate::widgets::picture::{DrawLayer, LabelSide, Pen, Picture, View};

const ON_BOARD: u32 = 8;

const IN_SPACE: u32 = 60;

/// Half the width and height of the picture, in units of r₁ + r₂.
const ON_BOARD_EXTENT: DVec2 = dvec2(1.8, 1.6);
const IN_SPACE_EXTENT: DVec2 = dvec2(1.3, 1.1);

pub(super) fn title(space: bool) -> &'static str {
    match space {
        true => "the target, face on",
        false => "shots without aiming",
    }
}

/// Evenly spread shots. Unless the outcome is hidden, the shots deflected by more than `beyond_deg`
/// are highlighted, and their number is given below.
pub(super) fn lay_out(space: bool, beyond_deg: f64, figure: FigureArea) -> Picture {
    // A deflection of more than θ₁ = 90° − α requires an offset below sin α = cos θ₁.
    let near = (!figure.hidden).then(|| rad_from_deg(beyond_deg).cos());
    let (area, mut lines) = figure.split(1);
    let text = match near {
        Some(near) => {
            let offsets = if space { in_space() } else { on_board() };
            let counted = offsets.iter().filter(|at| at.length() < near).count();
            let all = offsets.len();
            format!(" {counted} of {all} deflected by over {beyond_deg:.0}°.")
        }
        None if space => " Evenly spread over the round target.".into(),
        None => " Evenly spread, from side to side.".into(),
    };
    lines.line(&text, Role::Text);
    match space {
        true => face(near, area),
        false => ways(near, area),
    }
}

/// The paths of shots on a board. Those with offsets below `near` are highlighted.
fn ways(near: Option<f64>, area: Rect) -> Picture {
    let view = View::fit(area, -ON_BOARD_EXTENT, ON_BOARD_EXTENT);
    let mut picture = Picture::new(view);
    picture.circle(DVec2::ZERO, 1.0, Pen::new(Role::Arc).dotted());
    picture.disc(DVec2::ZERO, 0.5, Role::Coin, 'C');
    for at in on_board() {
        let pen = match near {
            None => Pen::new(Role::StrikerOut),
            Some(near) if at.length() < near => Pen::new(Role::CoinOut),
            Some(_) => Pen::new(Role::StrikerOut).dotted(),
        };
        picture.curve(way(at.y), pen.on(DrawLayer::Vector));
    }
    picture.label("r₁ + r₂", DVec2::X, &[LabelSide::Right], Role::Arc);
    picture
}

/// The circular target of shots in space, and the points where the shots hit it. Those within
/// `near` are highlighted.
fn face(near: Option<f64>, area: Rect) -> Picture {
    let view = View::fit(area, -IN_SPACE_EXTENT, IN_SPACE_EXTENT);
    let mut picture = Picture::new(view);
    picture.circle(DVec2::ZERO, 1.0, Pen::new(Role::Arc).dotted());
    for at in in_space() {
        // A disc this small is drawn as a mark.
        let counted = near.is_some_and(|near| at.length() < near);
        let role = if counted { Role::Marble } else { Role::Coin };
        picture.disc(at, 1e-3, role, ' ');
    }
    picture.label(
        "r₁ + r₂",
        DVec2::from_angle(-PI / 4.0),
        &[LabelSide::BelowRight, LabelSide::Right],
        Role::Arc,
    );
    picture
}

/// Offsets evenly spread over the line from −1 to 1.
fn on_board() -> Vec<DVec2> {
    let offset = |i| (2.0 * f64::from(i) + 1.0) / f64::from(ON_BOARD) - 1.0;
    (0..ON_BOARD).map(|i| dvec2(0.0, offset(i))).collect()
}

/// Offsets evenly spread over a disc: rings of equal area contain equal numbers of points, and the
/// golden angle separates each point from the next (H. Vogel, 1979, on sunflower heads).
fn in_space() -> Vec<DVec2> {
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let at = |i| {
        let radius = ((f64::from(i) + 0.5) / f64::from(IN_SPACE)).sqrt();
        radius * DVec2::from_angle(golden * f64::from(i))
    };
    (0..IN_SPACE).map(at).collect()
}

/// The path of a striker's centre: straight on until the rims touch, then at θ₁ = 90° − α from its
/// original direction, away from the coin; sin α is the magnitude of the offset.
fn way(offset: f64) -> [DVec2; 3] {
    let far = 3.0 * ON_BOARD_EXTENT.length();
    let contact = dvec2(-(1.0 - offset * offset).sqrt(), offset);
    let turned = (FRAC_PI_2 - offset.abs().asin()) * offset.signum();
    [
        dvec2(-far, offset),
        contact,
        contact + far * DVec2::from_angle(turned),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::CollisionSpec;
    use crate::physics::beam::Beam;

    /// The deflection agrees with the engine.
    #[test]
    fn a_path_turns_by_the_deflection_angle() {
        for at in on_board() {
            let [from, contact, to] = way(at.y);
            let alpha = at.y.asin();
            let outcome = CollisionSpec::default()
                .collision()
                .with_alpha(alpha)
                .outcome();
            let turned = (contact - from).angle_to(to - contact);
            let expected = outcome.v1.to_angle();
            assert!((turned - expected).abs() < 1e-12, "{turned} {expected}");
        }
    }

    #[test]
    fn the_counted_share_agrees_with_the_law() {
        for (offsets, beam) in [(on_board(), Beam::Board), (in_space(), Beam::Space)] {
            let near = rad_from_deg(60.0).cos();
            let counted = offsets.iter().filter(|at| at.length() < near).count();
            let share = counted as f64 / offsets.len() as f64;
            assert!((share - beam.share_within(near)).abs() < 1e-12, "{share}");
        }
    }
}
