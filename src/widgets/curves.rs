//! Plots of the outcome against the impact angle, each with a draggable point; the collision at
//! that point is drawn below the plot.

use glam::DVec2;
use ratatui::layout::{Margin, Rect};

use crate::lessons::FigureKind;
use crate::numbers::{fixed, tidy};
use crate::physics::units::{deg_from_rad, rad_from_deg};
use crate::physics::{Collision, RestingTarget};
use crate::widgets::hit::{Overlay, Overlays, Watch};
use crate::widgets::picture::{LabelSide, Pen, Picture};
use crate::widgets::plot::{Axis, Plot};
use crate::widgets::{Charset, Look, Role, areas};

/// One curve: its name, its colour, and its value at an angle in degrees.
struct Curve {
    name: &'static str,
    role: Role,
    at: fn(&RestingTarget, f64) -> Option<f64>,
}

const SPEEDS: [Curve; 2] = [
    Curve {
        name: "v₁/u",
        role: Role::StrikerOut,
        at: |pair, alpha| Some(pair.striker_speed(alpha)),
    },
    Curve {
        name: "v₂/u",
        role: Role::CoinOut,
        at: |pair, alpha| Some(pair.target_speed(alpha)),
    },
];

const SHARES: [Curve; 3] = [
    Curve {
        name: "striker",
        role: Role::StrikerOut,
        at: |pair, alpha| Some(pair.energy_shares(alpha).kept),
    },
    Curve {
        name: "coin",
        role: Role::CoinOut,
        at: |pair, alpha| Some(pair.energy_shares(alpha).passed),
    },
    Curve {
        name: "lost",
        role: Role::Warn,
        at: |pair, alpha| (pair.restitution < 1.0).then(|| pair.energy_shares(alpha).lost),
    },
];

/// The impact angle at a cell of the picture, in degrees.
pub(crate) fn alpha_at(
    kind: FigureKind,
    collision: &Collision,
    area: Rect,
    look: &Look,
    cell: (u16, u16),
) -> Option<f64> {
    let [plot, _] = rooms(area);
    let plot = empty(kind, &collision.into(), plot, look);
    Some(plot.values_at(cell)?.x)
}

/// The areas for the plot and for the collision.
fn rooms(area: Rect) -> [Rect; 2] {
    areas::upper(area, area.height * 11 / 20)
}

fn empty(kind: FigureKind, pair: &RestingTarget, area: Rect, look: &Look) -> Plot {
    let (name, most) = match kind {
        FigureKind::Angles => {
            // If e m₂ > m₁, the striker rebounds from a head-on collision.
            let most = if pair.k() > 1.0 + 1e-9 { 180.0 } else { 90.0 };
            let theta2 = Axis::linear("coin θ₂ (°)", 0.0, 90.0).every(15.0);
            let theta1 = Axis::linear("striker θ₁ (°)", 0.0, most).every(most / 6.0);
            return Plot::new(area, *look, theta2, theta1);
        }
        FigureKind::Energy => ("share of the energy", 1.0),
        _ => ("speed, in units of u", pair.target_speed(0.0).max(1.0)),
    };
    let alpha = Axis::linear("impact angle α (°)", 0.0, 90.0).every(15.0);
    Plot::new(area, *look, alpha, Axis::linear(name, 0.0, most))
}

/// The curves of one kind of figure, with a point at the impact angle of the given collision, and a
/// picture of that collision below. The target is at rest.
pub(crate) fn curves_and_hit(
    kind: FigureKind,
    collision: &Collision,
    area: Rect,
    look: &Look,
) -> [Picture; 2] {
    use Overlay::{Angles, Lines, Trails, Triangle};
    let [room, hit] = rooms(area);
    // Only the overlays that are readable in a small picture are shown.
    let layers = Overlays::default().without([Lines, Angles, Triangle, Trails]);
    let watch = Watch::revealed(*collision).with_layers(layers);
    let hit = watch.picture(hit.inner(Margin::new(1, 0)));
    [curves_picture(kind, collision, room, look), hit]
}

/// The directions, energy shares or speeds plotted against the impact angle, with the point.
pub(crate) fn curves_picture(
    kind: FigureKind,
    collision: &Collision,
    room: Rect,
    look: &Look,
) -> Picture {
    let pair = RestingTarget::from(collision);
    let mut plot = empty(kind, &pair, room, look);
    let alpha_deg = tidy(collision.alpha().map_or(0.0, deg_from_rad)).abs();
    match kind {
        FigureKind::Angles => {
            let theta1 = |deg: f64| pair.theta1(rad_from_deg(deg)).map(deg_from_rad);
            plot.function(theta1, Pen::new(Role::StrikerOut));
            if let Some(theta1) = theta1(alpha_deg) {
                let at = DVec2::new(alpha_deg, theta1);
                mark(&mut plot, look, at, Role::Title);
                let theta1_deg = fixed(theta1, 1);
                let text = format!("θ₁ = {theta1_deg}°, θ₂ = {alpha_deg:.1}°");
                plot.label(&text, at, &LabelSide::towards(DVec2::ONE), Role::Text);
            }
        }
        FigureKind::Energy => curves(&mut plot, look, &SHARES, &pair, alpha_deg),
        _ => curves(&mut plot, look, &SPEEDS, &pair, alpha_deg),
    }
    plot.picture()
}

/// Draws curves against α, each with a point at the given angle.
fn curves(plot: &mut Plot, look: &Look, curves: &[Curve], pair: &RestingTarget, alpha_deg: f64) {
    use LabelSide::{Above, Below, BelowLeft, BelowRight, Left, Right};
    plot.vline(alpha_deg, Pen::new(Role::Aim).dotted());
    let point = |curve: &Curve, deg: f64| {
        let value = (curve.at)(pair, rad_from_deg(deg))?;
        Some(DVec2::new(deg, value))
    };
    for curve in curves {
        plot.function(|deg| Some(point(curve, deg)?.y), Pen::new(curve.role));
    }
    for curve in curves {
        if let Some(at) = point(curve, alpha_deg) {
            mark(plot, look, at, curve.role);
        }
    }
    for curve in curves {
        // The name is placed near the end at which the curve is higher.
        let ends = [8.0, 82.0].into_iter().filter_map(|deg| point(curve, deg));
        if let Some(at) = ends.max_by(|a, b| a.y.total_cmp(&b.y)) {
            let sides = [Below, BelowLeft, BelowRight, Above, Left, Right];
            plot.label(curve.name, at, &sides, curve.role);
        }
    }
}

fn mark(plot: &mut Plot, look: &Look, at: DVec2, role: Role) {
    let symbol = match look.charset {
        Charset::Ascii => 'O',
        Charset::Unicode => '●',
    };
    plot.mark(at, symbol, role);
}
