//! The picture before the hit: what is given, and the rays that are turned.

use glam::DVec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::labels::Labels;
use super::mark::Mark;
use super::stage::Stage;
use super::watch::Face;
use crate::physics::Collision;
use crate::quiz::{AimTask, Ray};
use crate::widgets::ink::{Pen, Sheet, Side};
use crate::widgets::{Look, RayInput, Role};

pub use crate::quiz::Markings;

/// Draws a striker and a coin about to meet, and the rays being turned.
pub fn draw_setup(
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
    collision: &Collision,
    given: Markings,
    rays: Option<&RayInput>,
) {
    let faces = Face::STRIKER_AND_COIN;
    draw_setup_of(faces, area, buf, look, collision, given, rays);
}

/// Draws a striker and a coin about to meet at an offset in metres that is being set,
/// and where one of them is to be sent.
pub fn draw_aim(
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
    (aim, offset): (&AimTask, f64),
    given: Markings,
) {
    let given = Markings {
        offset: true,
        ..given
    };
    let saying = Saying::Shot(Mark::from(aim));
    let faces = Face::STRIKER_AND_COIN;
    draw(faces, area, buf, look, &aim.with(offset), given, saying);
}

/// Draws two discs of any kind about to meet, and the rays being turned.
pub fn draw_setup_of(
    faces: [Face; 2],
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
    collision: &Collision,
    given: Markings,
    rays: Option<&RayInput>,
) {
    let saying = rays.map_or(Saying::Nothing, Saying::Rays);
    draw(faces, area, buf, look, collision, given, saying);
}

/// What is being said of a hit.
#[derive(Clone, Copy)]
enum Saying<'a> {
    /// Nothing, or nothing that is seen.
    Nothing,
    /// Where both will go.
    Rays(&'a RayInput),
    /// The offset that sends one of them to a mark.
    Shot(Mark),
}

fn draw(
    faces: [Face; 2],
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
    collision: &Collision,
    given: Markings,
    saying: Saying,
) {
    let stage = Stage::new(area, collision);
    let mut sheet = Sheet::new(stage.view, look.charset);
    let mut labels = Labels::default();
    let [c1, c2] = stage.centres;
    let (p1, p2) = before(&stage);
    let along = collision.relative_velocity().try_normalize();
    if let Some(along) = along {
        let line = |from: DVec2| {
            let ahead = from + stage.room(from, along) * along;
            (from, ahead)
        };
        let (from, to) = line(p1);
        sheet.line(from, to, Pen::new(Role::Aim).dotted());
        if given.offset {
            offset(&mut sheet, &mut labels, &stage, along, given.figures);
        }
    }
    for (body, (place, face)) in [p1, p2].into_iter().zip(faces).enumerate() {
        sheet.disc(place, stage.radius(body), face.role, face.letter);
    }
    if collision.alpha().is_some() {
        sheet.circle(c1, stage.radius(0), Pen::new(Role::Trail).dotted());
        if p2 != c2 {
            sheet.circle(c2, stage.radius(1), Pen::new(Role::Trail).dotted());
        }
        if given.angle {
            impact_angle(&mut sheet, &mut labels, &stage, given.figures);
        }
    }
    moving(&mut sheet, &mut labels, &stage, [p1, p2], given.figures);
    match saying {
        Saying::Nothing => {}
        Saying::Rays(rays) => turned(&mut sheet, &mut labels, &stage, faces, rays),
        Saying::Shot(mark) => mark.draw(&mut sheet, &mut labels, &stage),
    }
    labels.write(&mut sheet);
    sheet.draw(buf, &look.theme);
}

/// Where the two are drawn before the hit: far enough apart to see both whole, near
/// enough that both are in the picture.
fn before(stage: &Stage) -> (DVec2, DVec2) {
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
        collision.positions_before(time)
    } else {
        (stage.centres[0], stage.centres[1])
    }
}

/// The impact parameter: the line through the coin's centre beside the striker's,
/// and the distance between them.
fn offset(sheet: &mut Sheet, labels: &mut Labels, stage: &Stage, along: DVec2, figures: bool) {
    let [c1, c2] = stage.centres;
    let ahead = c2 + stage.room(c2, along) * along;
    sheet.line(c2, ahead, Pen::new(Role::Aim).dotted());
    let across = along.perp() * (c2 - c1).dot(along.perp());
    if across.length() < 0.7 * stage.view.per_row() {
        return;
    }
    // Measured ahead of the coin, where nothing else is.
    let foot = c2 + (1.35 * stage.radius(1)) * along;
    sheet.line(foot, foot - across, Role::Arc);
    let text = match figures {
        true => format!("b = {:.1} mm", stage.collision.offset.abs() * 1000.0),
        false => "b".into(),
    };
    labels.add(&text, foot - 0.5 * across, Side::towards(along), Role::Arc);
}

/// The line of impact where the two will meet, and the angle to it.
fn impact_angle(sheet: &mut Sheet, labels: &mut Labels, stage: &Stage, figures: bool) {
    let [c1, c2] = stage.centres;
    let (Some(n), Some(alpha)) = (stage.collision.normal(), stage.collision.alpha()) else {
        return;
    };
    let end = c2 + 1.5 * stage.radius(1) * n;
    sheet.line(c1, end, Pen::new(Role::LineOfImpact).dashed());
    let Some(along) = stage.collision.relative_velocity().try_normalize() else {
        return;
    };
    if alpha.abs() > 0.05 {
        let radius = 0.8 * stage.radius(0);
        let start = along.to_angle();
        sheet.arc(c1, radius, start, start - alpha, Role::Arc);
    }
    let text = match figures {
        true => format!("α = {:.1}°", alpha.to_degrees().abs()),
        false => "α".into(),
    };
    labels.add(&text, end, Side::towards(n), Role::LineOfImpact);
}

/// An arrow ahead of each disc that moves.
fn moving(
    sheet: &mut Sheet,
    labels: &mut Labels,
    stage: &Stage,
    places: [DVec2; 2],
    figures: bool,
) {
    let collision = &stage.collision;
    let speeds = [collision.u1, collision.u2];
    let fastest = speeds[0].length().max(speeds[1].length());
    for (body, name) in ["u", "u₂"].into_iter().enumerate() {
        let v = speeds[body];
        let Some(direction) = v.try_normalize() else {
            continue;
        };
        let length = 1.1 * stage.unit() * v.length() / fastest;
        let from = places[body] + stage.radius(body) * direction;
        sheet.arrow(
            from,
            from + length * direction,
            Pen::new(Role::Incoming).bold(),
        );
        let text = match figures {
            true => format!("{name} = {:.2} m/s", v.length()),
            false => name.into(),
        };
        let away = direction.perp() * stage.side();
        let anchor = places[body] + stage.radius(body) * away;
        labels.add(&text, anchor, Side::towards(away), Role::Incoming);
    }
}

/// The rays as said so far, from where the discs will meet.
fn turned(
    sheet: &mut Sheet,
    labels: &mut Labels,
    stage: &Stage,
    faces: [Face; 2],
    rays: &RayInput,
) {
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
            labels.add(&text, centre, Side::towards(DVec2::Y), Role::Predicted);
            continue;
        };
        let direction = stage.direction(ray, angle);
        let tip = centre + ray_length(stage, centre, direction) * direction;
        let pen = Pen::new(Role::Predicted);
        let active = ray == rays.turning();
        sheet.arrow(
            centre + stage.radius(body) * direction,
            tip,
            if active { pen.bold() } else { pen.dashed() },
        );
        let text = format!("{name} {}", rays.shown(ray));
        labels.add(&text, tip, Side::towards(direction), Role::Predicted);
    }
}

/// How far from a centre a ray that is being turned reaches.
fn ray_length(stage: &Stage, centre: DVec2, direction: DVec2) -> f64 {
    stage.room(centre, direction).min(2.9 * stage.unit())
}

/// Points the ray at a cell of the picture: the one whose tip is nearer when the
/// button goes down (`choose`), else the one being turned.
pub fn point_at(
    area: Rect,
    collision: &Collision,
    rays: &mut RayInput,
    cell: (u16, u16),
    choose: bool,
) {
    let stage = Stage::new(area, collision);
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
pub fn drag_offset(area: Rect, collision: &Collision, cell: (u16, u16)) -> f64 {
    let stage = Stage::new(area, collision);
    let at = stage.view.world_at(cell.0, cell.1);
    let Some(along) = collision.relative_velocity().try_normalize() else {
        return collision.offset;
    };
    // To the right of the way counts as positive. The contact point is in the
    // middle, so the coin's centre has but its own share of the offset.
    -at.dot(along.perp()) * collision.reach() / collision.target.radius
}
