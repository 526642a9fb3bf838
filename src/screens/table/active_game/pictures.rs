//! Pictures of a game in progress: the aim, the computer's aim, the replay of a stroke.

use glam::DVec2;
use ratatui::layout::Rect;

use super::pulling::Grip;
use super::showing::ShownStroke;
use super::watching::{FALL, StrokeReplay};
use super::{ActiveGame, FirstHit, Pointer, Preview};
use crate::game::opponent::Slip;
use crate::game::{Piece, Seat};
use crate::physics::{Board, DiscState, stopping_distance};
use crate::screens::table::computer_stroke::ComputerStroke;
use crate::screens::table::picture::{bodies, body, ground};
use crate::screens::table::words;
use crate::widgets::picture::{DrawLayer, LabelSide, Pen, Picture};
use crate::widgets::{Role, board, sheet};

/// The time in which a trail fades, in seconds.
const FADE: f64 = 0.9;
/// The number of shades of a trail, each fainter than the next.
const SHADES: usize = 4;
/// The number of shades of the ring at a pocket after a disc has fallen into it.
const RING_SHADES: f64 = 4.0;
/// The greatest length of a path drawn after the first collision, in metres.
const LONGEST_RAY: f64 = 0.16;
/// Length of the arrow that shows the aim if the aim line is off, in metres.
const STUB: f64 = 0.09;
/// The distance from the frame to the line that marks the side of a seat, in metres.
const OWN_SIDE: f64 = 0.03;
/// Length of the arrow that shows the strength, in metres per m/s.
const ARROW: f64 = 0.03;

/// The board with the striker, its aim and the aids.
pub(super) fn of_aim(active: &ActiveGame, area: Rect) -> Picture {
    let mut picture = ground(area);
    let seat = active.seat();
    let aim = active.aimed();
    let place = aim.place;
    let radius = active.set().striker_radius();
    let heading = aim.heading(seat);
    let aids = active.options.company.aids;
    let hit = active.first_hit();
    if !active.is_practice() {
        own_side(&mut picture, seat);
    }
    let pointer = active.hint.as_ref().and_then(|it| it.pointer.as_ref());
    if let Some(pointer) = pointer {
        point_out(&mut picture, pointer);
    }
    if let Grip::Pull { to, .. } = active.grip {
        pulled(&mut picture, active, to);
    }
    if let Some(preview) = active.preview.as_ref().filter(|_| aids.line) {
        picture.curve(preview.way.iter().copied(), Pen::new(Role::Aim).dotted());
    } else {
        let from = place + radius * heading;
        picture.arrow(from, from + STUB * heading, Role::Aim);
    }
    let striker = body(active.set(), Piece::Striker, place);
    let mut discs: Vec<_> = bodies(active.set(), active.game().coins()).collect();
    if let Some(coin) = pointer.and_then(|pointer| discs.get_mut(pointer.coin)) {
        coin.pointed_out = true;
    }
    discs.push(striker);
    picture.discs(discs);
    sheet::next_picture_shows(|| {
        let coins = active.game().coins().iter();
        let coins = coins.map(|coin| (coin.piece.to_string(), coin.at));
        board::places_in_words(coins.chain([(Piece::Striker.to_string(), place)]))
    });
    if let Some(hit) = &hit {
        let ghost = hit.ghost();
        if aids.ghost {
            board::ghost(&mut picture, ghost, radius, Role::Predicted);
        }
        if aids.rays && !active.options.company.call {
            departures(&mut picture, hit, ghost);
        }
    }
    picture
}

/// Draws a line from the striker to the mouse that pulls it, and the speed of the stroke.
fn pulled(picture: &mut Picture, active: &ActiveGame, to: DVec2) {
    let place = active.aim.place;
    let pen = Pen::new(Role::Key).on(DrawLayer::Trail);
    picture.line(place, to, pen.dashed());
    let says = match active.is_drawn() {
        true => format!("{:.1} m/s", active.aim.speed),
        false => "no stroke".into(),
    };
    // The label is beside the striker, because the mouse may be outside the picture.
    let sides = LabelSide::towards(place - to);
    picture.label(says, place, &sides, Role::Key);
}

/// The board with the parts of the computer's next stroke that are visible so far.
pub(super) fn of_show(active: &ActiveGame, shown: &ShownStroke, area: Rect) -> Picture {
    let mut picture = ground(area);
    let seat = active.seat();
    own_side(&mut picture, seat);
    let (aim, radius) = (&shown.stroke.aim, active.set().striker_radius());
    if shown.parts > 1 {
        meant(&mut picture, &shown.stroke, Role::Aim);
        if let Some(Preview { hit: Ok(hit), .. }) = &shown.stroke.preview {
            board::ghost(&mut picture, hit.ghost(), radius, Role::Predicted);
        }
    }
    let striker = body(active.set(), Piece::Striker, aim.place);
    picture.discs(bodies(active.set(), active.game().coins()).chain([striker]));
    if shown.parts > 2 {
        let heading = aim.heading(seat);
        let from = aim.place + radius * heading;
        picture.arrow(from, from + ARROW * aim.speed * heading, Role::Incoming);
    }
    picture
}

/// Draws the path of the striker as the computer intended it.
fn meant(picture: &mut Picture, stroke: &ComputerStroke, role: Role) {
    let way = stroke.preview.iter().flat_map(|preview| &preview.way);
    let pen = Pen::new(role).on(DrawLayer::Trail);
    picture.curve(way.copied(), pen.dotted());
}

/// Draws the computer's intended stroke beside the actual one: the intended path, the error, and
/// the target pocket.
fn beside(picture: &mut Picture, stroke: &ComputerStroke) {
    if let Some(pointer) = &stroke.pointer {
        point_out(picture, pointer);
    }
    meant(picture, stroke, Role::Predicted);
    let way = stroke.preview.as_ref().map_or(&[][..], |it| &it.way);
    if let (&[from, to, ..], Some(off)) = (way, stroke.off()) {
        let out = (to - from).perp().normalize_or_zero();
        let sides = LabelSide::towards(out * stroke.decision.slip.turn.signum() * -1.0);
        let text = format!("meant: {off}");
        let label = picture.label(text, from.lerp(to, 0.6), &sides, Role::Predicted);
        label.or(to, &LabelSide::ALL);
    }
}

/// Draws the direction that a person intended, beside the first leg of the striker's path.
fn meant_by_hand(picture: &mut Picture, replay: &StrokeReplay, slip: Slip) {
    let shot = replay.player.shot();
    if let Some(leg) = shot.path(0).next() {
        let way = slip.meant_direction(shot.start(0).velocity);
        let to = leg.from + leg.from.distance(leg.to) * way;
        let pen = Pen::new(Role::Predicted).on(DrawLayer::Trail);
        picture.line(leg.from, to, pen.dotted());
    }
}

/// Draws the coin's path into the pocket that the pointer refers to, and marks the pocket.
fn point_out(picture: &mut Picture, pointer: &Pointer) {
    let pen = Pen::new(Role::Good).on(DrawLayer::Trail);
    picture.curve(pointer.way.iter().copied(), pen.dotted());
    if let Some(pocket) = pointer.pocket {
        picture.circle(pocket, Board::default().pocket_radius(), pen);
    }
}

/// Draws the paths of both discs after the first collision, as far as each would slide if it hit
/// nothing, but at most [`LONGEST_RAY`].
fn departures(picture: &mut Picture, hit: &FirstHit, ghost: DVec2) {
    let outcome = hit.impact.collision.outcome();
    let deceleration = Board::default().deceleration();
    let bodies = [
        (ghost, outcome.v1, Role::StrikerOut),
        (hit.at, outcome.v2, Role::CoinOut),
    ];
    for (from, v, role) in bodies {
        let way = stopping_distance(v.length(), deceleration).min(LONGEST_RAY);
        if way > 1.5 * picture.view().per_column() {
            // On the layer of trails the ray is drawn below the discs and hides none of them.
            let pen = Pen::new(role).on(DrawLayer::Trail);
            picture.arrow(from, from + way * v.normalize_or_zero(), pen);
        }
    }
}

/// Marks the seat whose turn it is, between its base line and the frame.
fn own_side(picture: &mut Picture, seat: Seat) {
    let edge = -Board::default().side / 2.0;
    let end = |along: f64| seat.turn(DVec2::new(along, edge + OWN_SIDE));
    let pen = Pen::new(Role::Striker).on(DrawLayer::Trail);
    picture.line(end(-0.2), end(0.2), pen);
}

/// The board during the replay of a stroke, at the time of its clock.
pub(super) fn of_replay(active: &ActiveGame, replay: &StrokeReplay, area: Rect) -> Picture {
    let mut picture = ground(area);
    for disc in 0..replay.pieces.len() {
        trail(&mut picture, replay, disc);
    }
    let (clock, zoomed) = (replay.player.clock(), replay.player.chosen().is_some());
    let past = active.history.past(replay.number);
    let meant = past.and_then(|past| past.meant.as_deref());
    if let Some(stroke) = meant.filter(|_| clock.is_over() && !zoomed) {
        beside(&mut picture, stroke);
    }
    let slip = active.slip(replay.number);
    if let Some(slip) = slip.filter(|_| clock.is_over() && !zoomed) {
        meant_by_hand(&mut picture, replay, slip);
    }
    for fall in &replay.falls {
        answer(&mut picture, (clock.time() - fall.time) / FALL, fall.corner);
    }
    let discs = replay.discs();
    picture.discs(discs.map(|(piece, at)| body(active.set(), piece, at)));
    if let Some((number, impact)) = replay.player.chosen() {
        let shot = replay.player.shot();
        let [a, b] = impact.discs.map(|disc| shot.at(disc, impact.time).position);
        let number = number + 1;
        let share = impact.collision.striker.radius / impact.collision.contact_distance();
        let contact = a.lerp(b, share);
        picture.label(format!("{number}"), contact, &LabelSide::ALL, Role::Contact);
    }
    picture
}

/// Draws a ring that spreads from a pocket after a disc has fallen into it. `share` is the elapsed
/// fraction of the ring's duration.
fn answer(picture: &mut Picture, share: f64, corner: usize) {
    let board = Board::default();
    if let Some(pocket) = board::pocket(&board, corner).filter(|_| (0.0..1.0).contains(&share)) {
        // A shade lasts for several frames, so that most frames repaint nothing.
        let age = (share * RING_SHADES).floor() / RING_SHADES;
        let pen = Pen::new(Role::Good).bold().aged(age);
        let radius = board.pocket_radius();
        picture.circle(pocket, radius * (0.4 + share), pen);
        picture.circle(pocket, radius, pen);
    }
}

/// Draws where a disc has been: as a fading trail while time runs; at the end, the whole paths of
/// the striker, the first coin that it hit and the pocketed pieces.
fn trail(picture: &mut Picture, replay: &StrokeReplay, disc: usize) {
    let (player, shot) = (&replay.player, replay.player.shot());
    let (now, shown) = (player.clock().time(), player.clock().is_over());
    let first = player.impacts().first().map(|impact| impact.discs[1]);
    let fell = || shot.at(disc, now).state == DiscState::Pocketed;
    if shown && disc != 0 && first != Some(disc) && !fell() {
        return;
    }

    let piece = replay.pieces.get(disc);
    let role = piece.map_or(Role::Trail, |piece| words::role(*piece));
    let pen = Pen::new(role).on(DrawLayer::Trail);
    for leg in shot.path(disc).filter(|leg| leg.start < now) {
        if shown {
            picture.line(leg.from, leg.to, pen.dotted());
            continue;
        }
        // The leg is straight; the shot computes the disc's position on it.
        let place = |time: f64| match time {
            _ if time <= leg.start => leg.from,
            _ if time >= leg.end => leg.to,
            _ => shot.at(disc, time).position,
        };
        // Each shade covers a fixed interval of time behind the disc. From frame to frame, only the
        // cells at the borders between shades change.
        let stretch = FADE / SHADES as f64;
        for shade in (0..SHADES).rev() {
            let since = now - stretch * (shade + 1) as f64;
            let (start, end) = (leg.start.max(since), leg.end.min(since + stretch));
            if start < end {
                let age = shade as f64 / SHADES as f64;
                picture.line(place(start), place(end), pen.aged(age));
            }
        }
    }
}
