//! The momenta of two discs that coalesce, and those of the pieces of an explosion, which is a
//! collision of that kind in reverse. The sum of the momenta is the same before and after.

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

/// An arrow that is shorter than this fraction of the longest one has no label.
const SHORTEST: f64 = 0.05;

/// The same discs, with the whole picture turned so that their centre of mass moves to the right and
/// the first disc upwards.
pub(super) fn moving_to_the_right(mut collision: Collision) -> Collision {
    let drift = collision.centre_of_mass_velocity().normalize_or(DVec2::X);
    let back = DVec2::new(drift.x, -drift.y);
    collision.u1 = back.rotate(collision.u1);
    collision.u2 = back.rotate(collision.u2);
    let angle = angle_deg(FigureKind::Explosion { third_g: None }, &collision);
    turn_pieces(&mut collision, angle);
    collision
}

/// The angle that the student sets: the angle between the velocities of the two discs or, in an
/// explosion into two pieces, the angle in the centre-of-mass frame between the velocity of the
/// first piece and the original direction.
pub(super) fn angle_deg(kind: FigureKind, collision: &Collision) -> f64 {
    let Collision { u1, u2, .. } = collision;
    let angle = match kind {
        FigureKind::Explosion { third_g: None } => (*u1 - *u2).to_angle(),
        _ => u1.angle_to(*u2),
    };
    deg_from_rad(angle.abs())
}

/// Turns the velocity of the second disc until it makes this angle with that of the first.
pub(super) fn turn_second(collision: &mut Collision, angle_deg: f64) {
    let turn = DVec2::from_angle(rad_from_deg(angle_deg));
    let ahead = collision.u1.normalize_or(DVec2::X);
    collision.u2 = collision.u2.length() * turn.rotate(ahead);
}

/// Turns the velocities of both pieces in the centre-of-mass frame, the first one to this angle.
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
    /// Whether the arrow is hidden until the page's question is answered.
    is_asked: bool,
}

/// The arrows. For a body at rest that breaks into two pieces, both arrows begin at the same point,
/// because tip to tail one would cover the other.
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

/// Whether this is an explosion into only two pieces.
fn third_is_absent(kind: FigureKind) -> bool {
    kind == FigureKind::Explosion { third_g: None }
}

/// A view that contains the arrows at every angle, so that the scale does not change.
fn view(kind: FigureKind, collision: &Collision, area: Rect) -> View {
    let [p1, p2] = of_both(collision);
    let sum = p1 + p2;
    // The point where the arrows meet, or the tip of the second one, moves on a circle.
    let (centre, radius) = match kind {
        FigureKind::Explosion { third_g: None } => {
            let [m1, m2] = [collision.striker.mass, collision.target.mass];
            let centre = m1 / (m1 + m2) * sum;
            (centre, (p1 - centre).length())
        }
        _ => (p1, p2.length()),
    };
    let is_at_rest = third_is_absent(kind) && sum.length() < 1e-9 * p1.length();
    let lowest = if is_at_rest { -radius } else { 0.0 };
    let low = DVec2::new((centre.x - radius).min(0.0), lowest);
    let high = DVec2::new((centre.x + radius).max(sum.x), radius);
    let edge = 0.12 * (high - low).max_element();
    View::fit(area, low - edge, high + edge)
}

/// The arrows with their magnitudes, and below them three lines of text, or only the first line
/// while the result is `hidden`.
pub(super) fn lay_out(
    kind: FigureKind,
    collision: &Collision,
    hidden: bool,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> Picture {
    let [area, below] = areas::upper(area, area.height.saturating_sub(3));
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
        .take(if hidden { 1 } else { 3 })
    {
        lines.line(line, Role::Text);
    }
    picture
}

/// Three lines of text: what is given, the result, and the energy.
pub(super) fn words(kind: FigureKind, collision: &Collision) -> [String; 3] {
    let Collision { u1, u2, .. } = *collision;
    let sum = of_both(collision).into_iter().sum::<DVec2>().length();
    let [m1, m2] = [collision.striker.mass, collision.target.mass];
    let drift = collision.centre_of_mass_velocity();
    let relative = 0.5 * reduced_mass(m1, m2) * collision.relative_velocity().length_squared();
    let common = kinetic_energy(m1 + m2, drift);
    let speed = |v: f64| with_unit(&significant(v), "m/s");
    let grams = |m: f64| with_unit(&significant(g_from_kg(m)), "g");
    let gained = |energy: f64| format!("energy gained: {} mJ", significant(1e3 * energy));
    let apart = degrees(u1.angle_to(u2).abs());
    let momentum = significant(sum);
    match kind {
        FigureKind::Explosion {
            third_g: Some(third_g),
        } => {
            let m3 = kg_from_g(third_g);
            let v3 = (m1 + m2) / m3 * drift;
            let mass = grams(m3);
            [
                format!("At rest before; p₁, p₂ {apart} apart"),
                format!("v₃ = {momentum} g m/s / {mass} = {}", speed(v3.length())),
                gained(common + relative + kinetic_energy(m3, v3)),
            ]
        }
        FigureKind::Explosion { .. } => [
            match sum > 1e-9 {
                true => format!("Before: {} at {}", grams(m1 + m2), speed(drift.length())),
                false => format!("Before: {} at rest", grams(m1 + m2)),
            },
            format!("v₁ = {}, v₂ = {}", speed(u1.length()), speed(u2.length())),
            gained(relative),
        ],
        _ => {
            let mass = grams(m1 + m2);
            let lost = significant(100.0 * relative / (common + relative));
            [
                format!("p₁ and p₂ in g m/s, {apart} apart"),
                format!("V = {momentum} g m/s / {mass} = {}", speed(drift.length())),
                format!("{lost} % of the energy lost"),
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
