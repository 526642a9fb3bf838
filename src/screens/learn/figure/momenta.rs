//! The momenta of two discs that coalesce, and of the pieces of an explosion, which is the same
//! collision backwards: before and after, the arrows have the same sum.

use glam::DVec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::lessons::FigureKind;
use crate::numbers::{degrees, significant, with_unit};
use crate::physics::Collision;
use crate::physics::impact::{kinetic_energy, reduced_mass};
use crate::physics::units::{deg_from_rad, g_from_kg, kg_from_g, rad_from_deg};
use crate::widgets::picture::{LabelSide, Pen, Picture, View};
use crate::widgets::{Lines, Look, Role, areas};

/// An arrow that is shorter than this share of the picture has no name.
const SHORTEST: f64 = 0.05;

/// The same discs, with the whole picture turned so that their centre of mass moves to the right.
pub(super) fn moving_to_the_right(mut collision: Collision) -> Collision {
    let drift = collision.centre_of_mass_velocity().normalize_or(DVec2::X);
    let back = DVec2::new(drift.x, -drift.y);
    collision.u1 = back.rotate(collision.u1);
    collision.u2 = back.rotate(collision.u2);
    collision
}

/// The angle that the student sets: between the two discs, or, in an explosion into two pieces,
/// between the first piece and the original direction, in the centre-of-mass frame.
pub(super) fn angle_deg(kind: FigureKind, collision: &Collision) -> f64 {
    let Collision { u1, u2, .. } = collision;
    let angle = match kind {
        FigureKind::Explosion { third_g: None } => (*u1 - *u2).to_angle(),
        _ => u1.angle_to(*u2),
    };
    deg_from_rad(angle.abs())
}

/// Turns the velocity of the second disc to this angle from that of the first.
pub(super) fn turn_second(collision: &mut Collision, angle_deg: f64) {
    let turn = DVec2::from_angle(rad_from_deg(angle_deg));
    let ahead = collision.u1.normalize_or(DVec2::X);
    collision.u2 = collision.u2.length() * turn.rotate(ahead);
}

/// Turns both pieces in the centre-of-mass frame.
pub(super) fn turn_pieces(collision: &mut Collision, angle_deg: f64) {
    let drift = collision.centre_of_mass_velocity();
    let apart = (collision.u1 - collision.u2).length() * DVec2::from_angle(rad_from_deg(angle_deg));
    let [m1, m2] = [collision.striker.mass, collision.target.mass];
    collision.u1 = drift + m2 / (m1 + m2) * apart;
    collision.u2 = drift - m1 / (m1 + m2) * apart;
}

/// The two momenta, in g m/s.
fn of_both(collision: &Collision) -> [DVec2; 2] {
    let Collision { u1, u2, .. } = *collision;
    let [m1, m2] = [collision.striker.mass, collision.target.mass].map(g_from_kg);
    [m1 * u1, m2 * u2]
}

/// A momentum with its name.
struct Arrow {
    from: DVec2,
    to: DVec2,
    name: &'static str,
    role: Role,
    /// Whether it is hidden until the page's question is answered.
    is_asked: bool,
}

/// The arrows. Two pieces of a body at rest begin at the same point, because one would cover the
/// other.
fn arrows(kind: FigureKind, collision: &Collision) -> Vec<Arrow> {
    let [p1, p2] = of_both(collision);
    let arrow = |from, to, name, role, is_asked| Arrow {
        from,
        to,
        name,
        role,
        is_asked,
    };
    let (first, second, sum) = (Role::StrikerOut, Role::CoinOut, Role::Incoming);
    let end = p1 + p2;
    match kind {
        FigureKind::Explosion { third_g: Some(_) } => vec![
            arrow(DVec2::ZERO, p1, "p₁", first, false),
            arrow(p1, end, "p₂", second, false),
            arrow(end, DVec2::ZERO, "p₃", sum, true),
        ],
        FigureKind::Explosion { .. } if end.length() < 1e-9 * p1.length() => vec![
            arrow(DVec2::ZERO, p1, "p₁", first, false),
            arrow(DVec2::ZERO, p2, "p₂", second, true),
        ],
        FigureKind::Explosion { .. } => vec![
            arrow(DVec2::ZERO, end, "before", sum, false),
            arrow(DVec2::ZERO, p1, "p₁", first, false),
            arrow(p1, end, "p₂", second, true),
        ],
        _ => vec![
            arrow(DVec2::ZERO, p1, "p₁", first, false),
            arrow(p1, end, "p₂", second, false),
            arrow(DVec2::ZERO, end, "together", sum, true),
        ],
    }
}

/// A view that contains the arrows at every angle, so that the scale does not change.
fn view(kind: FigureKind, collision: &Collision, area: Rect) -> View {
    let [p1, p2] = of_both(collision);
    let sum = p1 + p2;
    // The joint of the arrows, or the end of the second, moves on a circle.
    let (centre, radius) = match kind {
        FigureKind::Explosion { third_g: None } => {
            let [m1, m2] = [collision.striker.mass, collision.target.mass];
            let centre = m1 / (m1 + m2) * sum;
            (centre, (p1 - centre).length())
        }
        _ => (p1, p2.length()),
    };
    let ends = [DVec2::ZERO, p1, sum];
    let around = [centre - DVec2::splat(radius), centre + DVec2::splat(radius)];
    let all = ends.into_iter().chain(around);
    let (low, high) = all.fold((DVec2::ZERO, DVec2::ZERO), |(low, high), it| {
        (low.min(it), high.max(it))
    });
    let edge = 0.12 * (high - low).max_element();
    View::fit(area, low - edge, high + edge)
}

/// The momenta with their sizes, and the result in two lines below them.
pub(super) fn lay_out(
    kind: FigureKind,
    collision: &Collision,
    hidden: bool,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> Picture {
    let [area, below] = areas::upper(area, area.height.saturating_sub(2));
    let mut picture = Picture::new(view(kind, collision, area));
    let all = arrows(kind, collision);
    let shown = || all.iter().filter(|it| !(hidden && it.is_asked));
    let count = shown().count().max(1) as f64;
    let middle = shown().map(|it| (it.from + it.to) / 2.0).sum::<DVec2>() / count;
    let size = shown()
        .map(|it| (it.to - it.from).length())
        .fold(0.0, f64::max);
    for it in shown() {
        picture.arrow(it.from, it.to, Pen::new(it.role).bold());
    }
    for it in shown() {
        let length = (it.to - it.from).length();
        if length >= SHORTEST * size {
            let centre = (it.from + it.to) / 2.0;
            let out = (centre - middle).normalize_or(DVec2::Y);
            let text = format!("{} = {}", it.name, significant(length));
            picture.label(&text, centre, &LabelSide::towards(out), it.role);
        }
    }
    let mut lines = Lines::new(below, buf, *look);
    for line in words(kind, collision)
        .iter()
        .take(if hidden { 1 } else { 2 })
    {
        lines.line(line, Role::Text);
    }
    picture
}

/// What is given, and the result.
pub(super) fn words(kind: FigureKind, collision: &Collision) -> [String; 2] {
    let [p1, p2] = of_both(collision);
    let sum = (p1 + p2).length();
    let [m1, m2] = [collision.striker.mass, collision.target.mass];
    let total = m1 + m2;
    let speed = |v: f64| with_unit(&significant(v), "m/s");
    let drift = collision.centre_of_mass_velocity().length();
    let sizes = [p1, p2].map(|p| significant(p.length()));
    let angle = degrees(deg_from_rad(collision.u1.angle_to(collision.u2).abs()));
    let freed = 0.5 * reduced_mass(m1, m2) * collision.relative_velocity().length_squared();
    match kind {
        FigureKind::Explosion {
            third_g: Some(third_g),
        } => {
            let third = kg_from_g(third_g);
            let v3 = g_from_kg(total) * drift / third_g;
            let energies = [
                (m1, collision.u1.length()),
                (m2, collision.u2.length()),
                (third, v3),
            ];
            let energy: f64 = energies
                .map(|(m, v)| kinetic_energy(m, v * DVec2::X))
                .iter()
                .sum();
            [
                format!("At rest before. p₁ and p₂: {angle} apart (g m/s)"),
                format!(
                    "v₃ = {} g m/s / {} = {}; energy gained: {} mJ",
                    significant(sum),
                    with_unit(&significant(third_g), "g"),
                    speed(v3),
                    significant(1e3 * energy)
                ),
            ]
        }
        FigureKind::Explosion { third_g: None } => [
            format!(
                "Before: {} at {} (momenta in g m/s)",
                with_unit(&significant(g_from_kg(total)), "g"),
                speed(drift)
            ),
            format!(
                "v₁ = {}, v₂ = {}; energy gained: {} mJ",
                speed(collision.u1.length()),
                speed(collision.u2.length()),
                significant(1e3 * freed)
            ),
        ],
        _ => {
            let before = freed + kinetic_energy(total, drift * DVec2::X);
            [
                format!("p₁ = {}, p₂ = {} g m/s, {angle} apart", sizes[0], sizes[1]),
                format!(
                    "V = {} g m/s / {} = {}; {} % of the energy lost",
                    significant(sum),
                    with_unit(&significant(g_from_kg(total)), "g"),
                    speed(drift),
                    significant(100.0 * freed / before)
                ),
            ]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::CollisionSpec;

    fn shot() -> Collision {
        let mut shot = CollisionSpec::default();
        for (field, value) in [("m2_g", "30"), ("target_speed", "2"), ("target_deg", "60")] {
            shot.set(field, value).unwrap();
        }
        shot.collision()
    }

    #[test]
    fn turning_the_pieces_changes_neither_the_momentum_nor_the_energy() {
        let start = moving_to_the_right(shot());
        let energy = |it: &Collision| it.outcome().energy_before;
        assert!((energy(&start) - energy(&shot())).abs() < 1e-12);
        let of_all = |it: &Collision| of_both(it).into_iter().sum::<DVec2>();
        assert!(of_all(&start).y.abs() < 1e-9 && of_all(&start).x > 0.0);
        for angle in [0.0, 35.0, 180.0] {
            let mut turned = start;
            turn_pieces(&mut turned, angle);
            assert!((of_all(&turned) - of_all(&start)).length() < 1e-9);
            assert!((energy(&turned) - energy(&start)).abs() < 1e-12);
            let kind = FigureKind::Explosion { third_g: None };
            assert!((angle_deg(kind, &turned) - angle).abs() < 1e-9);
        }
    }

    #[test]
    fn the_arrows_close_at_every_angle() {
        let mut collision = shot();
        for angle in [0.0, 60.0, 135.0] {
            turn_second(&mut collision, angle);
            assert!((angle_deg(FigureKind::Coalesce, &collision) - angle).abs() < 1e-9);
            let three = arrows(
                FigureKind::Explosion {
                    third_g: Some(10.0),
                },
                &collision,
            );
            let sum: DVec2 = three.iter().map(|it| it.to - it.from).sum();
            assert!(sum.length() < 1e-9);
        }
    }
}
