//! The momenta of two discs that coalesce, and those of the pieces of an explosion, which is a
//! collision of that kind in reverse. The sum of the momenta is the same before and after.

use glam::DVec2;
use ratatui::layout::Rect;

use super::FigureArea;
use crate::lessons::FigureKind;
use crate::numbers::{degrees, significant, with_unit};
use crate::physics::Collision;
use crate::physics::angle::angle_between;
use crate::physics::impact::{kinetic_energy, reduced_mass};
use crate::physics::units::{deg_from_rad, g_from_kg, kg_from_g, rad_from_deg};
use crate::widgets::Role;
use crate::widgets::picture::{LabelSide, Pen, Picture, View};

/// An arrow that is shorter than this fraction of the longest one has no label.
const SHORTEST: f64 = 0.05;

/// The same discs, with the whole picture turned and, if necessary, reflected so that their centre
/// of mass moves to the right and the first disc upwards.
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
/// first piece and the original direction; 0 if a disc at rest has no direction.
pub(super) fn angle_deg(kind: FigureKind, collision: &Collision) -> f64 {
    let Collision { u1, u2, .. } = collision;
    let angle = match kind {
        FigureKind::Explosion { third_g: None } => (*u1 - *u2).to_angle(),
        _ => angle_between(*u1, *u2).unwrap_or(0.0),
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

/// A momentum: the ends of its arrow, its name and its style.
type Arrow = (DVec2, DVec2, &'static str, Role);

/// The arrows; the last one is hidden until the page's question is answered. For a body at rest that
/// breaks into two pieces, both arrows begin at the same point, because if they were drawn tip to
/// tail, one would cover the other.
fn arrows(kind: FigureKind, collision: &Collision) -> Vec<Arrow> {
    let [p1, p2] = of_both(collision);
    let (first, second, sum) = (Role::StrikerOut, Role::CoinOut, Role::Incoming);
    let end = p1 + p2;
    match kind {
        FigureKind::Explosion { third_g: Some(_) } => vec![
            (DVec2::ZERO, p1, "p₁", first),
            (p1, end, "p₂", second),
            (end, DVec2::ZERO, "p₃", sum),
        ],
        FigureKind::Explosion { .. } if end.length() < 1e-9 * p1.length() => vec![
            (DVec2::ZERO, p1, "p₁", first),
            (DVec2::ZERO, p2, "p₂", second),
        ],
        FigureKind::Explosion { .. } => vec![
            (DVec2::ZERO, end, "before", sum),
            (DVec2::ZERO, p1, "p₁", first),
            (p1, end, "p₂", second),
        ],
        _ => vec![
            (DVec2::ZERO, p1, "p₁", first),
            (p1, end, "p₂", second),
            (DVec2::ZERO, end, "together", sum),
        ],
    }
}

/// A view that contains the arrows at every angle, so that the scale does not change.
fn view(kind: FigureKind, collision: &Collision, area: Rect) -> View {
    let [p1, p2] = of_both(collision);
    let sum = p1 + p2;
    // The point where the arrows meet, or the tip of the second one, moves on a circle.
    let (centre, radius, lowest) = match kind {
        FigureKind::Explosion { third_g: None } => {
            let [m1, m2] = [collision.striker.mass, collision.target.mass];
            let centre = m1 / (m1 + m2) * sum;
            let radius = (p1 - centre).length();
            let is_at_rest = sum.length() < 1e-9 * p1.length();
            (centre, radius, if is_at_rest { -radius } else { 0.0 })
        }
        _ => (p1, p2.length(), 0.0),
    };
    let low = DVec2::new((centre.x - radius).min(0.0), lowest);
    let high = DVec2::new((centre.x + radius).max(sum.x), radius);
    let edge = 0.12 * (high - low).max_element();
    View::fit(area, low - edge, high + edge)
}

/// The arrows with their magnitudes, and below them three lines of text, or only the first line
/// while the result is hidden.
pub(super) fn lay_out(kind: FigureKind, collision: &Collision, figure: FigureArea) -> Picture {
    let hidden = figure.hidden;
    let (area, mut lines) = figure.split(3);
    let mut picture = Picture::new(view(kind, collision, area));
    let mut shown = arrows(kind, collision);
    if hidden {
        shown.pop();
    }
    let centre = |from: DVec2, to: DVec2| (from + to) / 2.0;
    let centres = shown.iter().map(|(from, to, ..)| centre(*from, *to));
    let middle = centres.sum::<DVec2>() / shown.len().max(1) as f64;
    let lengths = shown.iter().map(|(from, to, ..)| from.distance(*to));
    let size = lengths.fold(0.0, f64::max);
    for &(from, to, _, role) in &shown {
        picture.arrow(from, to, Pen::new(role).bold());
    }
    for (from, to, name, role) in shown {
        let length = from.distance(to);
        if length >= SHORTEST * size {
            let centre = centre(from, to);
            let out = (centre - middle).normalize_or(DVec2::Y);
            let text = format!("{name} = {}", significant(length));
            picture.label(&text, centre, &LabelSide::towards(out), role);
        }
    }
    let shown = if hidden { 1 } else { 3 };
    for line in &words(kind, collision)[..shown] {
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
    use super::super::{FigureAction, LiveFigure};
    use super::*;
    use crate::lessons::Figure;
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
    fn a_disc_at_rest_stays_at_rest_when_the_angle_is_set() {
        let figure = Figure::from_words("coalesce").unwrap();
        let mut live = LiveFigure::new(figure, None, false);
        assert_eq!(live.collision.u2, DVec2::ZERO);
        live.act(FigureAction::Dial(1));
        assert_eq!(live.collision.u2, DVec2::ZERO);
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
            let sum: DVec2 = three.iter().map(|(from, to, ..)| *to - *from).sum();
            assert!(sum.length() < 1e-9);
        }
    }
}
