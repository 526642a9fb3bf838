//! The picture before the hit: what is given, and the rays that are turned.

use glam::DVec2;
use ratatui::layout::Rect;

use super::sketch::{Sketch, WantedWay, ray_length};
use super::stage::HitLayout;
use super::watch::Face;
use crate::physics::Collision;
use crate::quiz::Ray;
use crate::widgets::picture::{Pen, Picture};
use crate::widgets::{RayInput, Role};

pub(crate) use crate::quiz::Markings;

/// What is being said of a hit.
#[derive(Debug, Clone, Copy)]
pub(crate) enum HitResponse<'a> {
    /// Nothing, or nothing that is seen.
    Nothing,
    /// Where both will go.
    Rays(&'a RayInput),
    /// The offset that sends one of them where it is wanted.
    Shot(WantedWay),
}

impl<'a> From<Option<&'a RayInput>> for HitResponse<'a> {
    fn from(rays: Option<&'a RayInput>) -> Self {
        rays.map_or(Self::Nothing, Self::Rays)
    }
}

/// Two discs about to meet, with what is given of the hit and what is being said of it.
pub(crate) fn setup_picture<'a>(
    area: Rect,
    faces: [Face; 2],
    collision: &Collision,
    given: Markings,
    saying: impl Into<HitResponse<'a>>,
) -> Picture {
    let mut sketch = Sketch::new(HitLayout::new(area, collision));
    let radius = sketch.stage.radius(1);
    let places = before(&sketch.stage);
    about_to_meet(
        &mut sketch,
        faces,
        places,
        given,
        [1.35 * radius, 1.5 * radius],
    );
    match saying.into() {
        HitResponse::Nothing => {}
        HitResponse::Rays(rays) => turned(&mut sketch, faces, rays),
        HitResponse::Shot(wanted) => sketch.wanted_way(&wanted),
    }
    sketch.picture
}

/// Two discs on their way, and what is given. The offset is measured `ahead` of the
/// target's centre at contact, the line of impact is drawn so far `beyond` it.
pub(super) fn about_to_meet(
    sketch: &mut Sketch,
    faces: [Face; 2],
    [p1, p2]: [DVec2; 2],
    given: Markings,
    [ahead, beyond]: [f64; 2],
) {
    let stage = sketch.stage;
    let [c1, c2] = stage.centres;
    if let Some(along) = stage.collision.relative_velocity().try_normalize() {
        let end = p1 + stage.room(p1, along) * along;
        sketch.picture.line(p1, end, Pen::new(Role::Aim).dotted());
        if given.offset {
            offset(sketch, along, ahead, given.figures);
        }
    }
    for (body, (place, face)) in [p1, p2].into_iter().zip(faces).enumerate() {
        let radius = stage.radius(body);
        sketch.picture.disc(place, radius, face.role, face.letter);
    }
    if stage.collision.alpha().is_some() {
        let ghost = Pen::new(Role::Trail).dotted();
        sketch.picture.circle(c1, stage.radius(0), ghost);
        if p2 != c2 {
            sketch.picture.circle(c2, stage.radius(1), ghost);
        }
        if given.angle {
            impact_angle(sketch, beyond, given.figures);
        }
    }
    moving(sketch, [p1, p2], given.figures);
}

/// Where the two are drawn before the hit: far enough apart to see both whole, near
/// enough that both are in the picture.
fn before(stage: &HitLayout) -> [DVec2; 2] {
    let speed = stage.collision.relative_velocity().length();
    if speed > 0.0 {
        let time = 1.35 * stage.unit() / speed;
        let collision = &stage.collision;
        // Neither may begin outside the picture.
        let whole = |body: usize, v: DVec2| {
            let room = stage.room(stage.centres[body], -v.normalize_or_zero());
            (room - stage.radius(body)).max(0.0) / v.length()
        };
        let time = time.min(whole(0, collision.u1)).min(whole(1, collision.u2));
        collision.positions_before(time).into()
    } else {
        stage.centres
    }
}

/// The impact parameter: the line through the coin's centre beside the striker's,
/// and the distance between them.
fn offset(sketch: &mut Sketch, along: DVec2, ahead: f64, figures: bool) {
    let stage = sketch.stage;
    let [c1, c2] = stage.centres;
    let end = c2 + stage.room(c2, along) * along;
    sketch.picture.line(c2, end, Pen::new(Role::Aim).dotted());
    let across = along.perp() * (c2 - c1).dot(along.perp());
    if across.length() < 0.7 * stage.view.per_row() {
        return;
    }
    let foot = c2 + ahead * along;
    sketch.picture.line(foot, foot - across, Role::Arc);
    let text = match figures {
        true => format!("b = {:.1} mm", stage.collision.offset.abs() * 1000.0),
        false => "b".into(),
    };
    sketch.label(text, foot - 0.5 * across, along, Role::Arc);
}

/// The line of impact where the two will meet, and the angle to it.
fn impact_angle(sketch: &mut Sketch, beyond: f64, figures: bool) {
    let stage = sketch.stage;
    let [c1, c2] = stage.centres;
    let (Some(n), Some(alpha)) = (stage.collision.normal(), stage.collision.alpha()) else {
        return;
    };
    let end = c2 + beyond * n;
    let pen = Pen::new(Role::LineOfImpact).dashed();
    sketch.picture.line(c1, end, pen);
    let Some(along) = stage.collision.relative_velocity().try_normalize() else {
        return;
    };
    if alpha.abs() > 0.05 {
        let (radius, start) = (0.8 * stage.radius(0), along.to_angle());
        sketch
            .picture
            .arc(c1, radius, start, start - alpha, Role::Arc);
    }
    let text = match figures {
        true => format!("α = {:.1}°", alpha.to_degrees().abs()),
        false => "α".into(),
    };
    sketch.label(text, end, n, Role::LineOfImpact);
}

/// An arrow ahead of each disc that moves.
pub(super) fn moving(sketch: &mut Sketch, places: [DVec2; 2], figures: bool) {
    let stage = sketch.stage;
    let speeds = [stage.collision.u1, stage.collision.u2];
    let fastest = speeds[0].length().max(speeds[1].length());
    for (body, name) in ["u", "u₂"].into_iter().enumerate() {
        let v = speeds[body];
        let Some(direction) = v.try_normalize() else {
            continue;
        };
        let length = 1.1 * stage.unit() * v.length() / fastest;
        let from = places[body] + stage.radius(body) * direction;
        let pen = Pen::new(Role::Incoming).bold();
        sketch.picture.arrow(from, from + length * direction, pen);
        let text = match figures {
            true => format!("{name} = {:.2} m/s", v.length()),
            false => name.into(),
        };
        let away = direction.perp() * stage.side();
        let anchor = places[body] + stage.radius(body) * away;
        sketch.label(text, anchor, away, Role::Incoming);
    }
}

/// The rays as said so far, from where the discs will meet.
fn turned(sketch: &mut Sketch, faces: [Face; 2], rays: &RayInput) {
    let stage = sketch.stage;
    let said = rays.so_far();
    for (body, ray) in Ray::BOTH.into_iter().enumerate() {
        if !rays.asks(ray) {
            continue;
        }
        let name = faces[body].letter;
        let centre = stage.centres[body];
        let Some(angle) = said.get(ray) else {
            let still = rays.is_said(ray);
            let text = format!("{name} {}", if still { "stays still" } else { "?" });
            sketch.label(text, centre, DVec2::Y, Role::Predicted);
            continue;
        };
        let direction = stage.direction(ray, angle);
        let tip = centre + ray_length(&stage, centre, direction) * direction;
        let pen = match ray == rays.turning() {
            true => Pen::new(Role::Predicted).bold(),
            false => Pen::new(Role::Predicted).dashed(),
        };
        let rim = centre + stage.radius(body) * direction;
        sketch.picture.arrow(rim, tip, pen);
        let text = format!("{name} {}", rays.shown(ray));
        sketch.label(text, tip, direction, Role::Predicted);
    }
}

/// Points the ray at a cell of the picture: the one whose tip is nearer when the
/// button goes down (`choose`), else the one being turned.
pub(crate) fn point_at(
    area: Rect,
    collision: &Collision,
    rays: &mut RayInput,
    cell: (u16, u16),
    choose: bool,
) {
    let stage = HitLayout::new(area, collision);
    let at = stage.view.world_at(cell.0, cell.1);
    let said = rays.so_far();
    let distance = |body: usize, ray: Ray| {
        let centre = stage.centres[body];
        let tip = match said.get(ray) {
            Some(angle) => {
                let direction = stage.direction(ray, angle);
                centre + ray_length(&stage, centre, direction) * direction
            }
            None => centre,
        };
        tip.distance(at)
    };
    let ray = if !choose {
        rays.turning()
    } else if distance(0, Ray::Striker) <= distance(1, Ray::Target) {
        Ray::Striker
    } else {
        Ray::Target
    };
    let body = usize::from(ray == Ray::Target);
    if let Some(direction) = (at - stage.centres[body]).try_normalize() {
        rays.point(ray, stage.angle_deg_of(ray, direction));
    }
}

/// The offset in metres that puts the coin beside the striker's way where a cell
/// of the picture is.
pub(crate) fn drag_offset(area: Rect, collision: &Collision, cell: (u16, u16)) -> f64 {
    let stage = HitLayout::new(area, collision);
    let at = stage.view.world_at(cell.0, cell.1);
    let Some(along) = collision.relative_velocity().try_normalize() else {
        return collision.offset;
    };
    // To the right of the way counts as positive. The contact point is in the
    // middle, so the coin's centre has but its own share of the offset.
    -at.dot(along.perp()) * collision.contact_distance() / collision.target.radius
}
