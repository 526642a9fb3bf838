//! The board of a level.

use glam::DVec2;
use ratatui::layout::Rect;

use super::made_shot::{MadeShot, asked};
use crate::levels::{Dial, Level, Scene};
use crate::physics::Shot;
use crate::physics::units::m_from_mm;
use crate::quiz::Ray;
use crate::screens::levels::words::face;
use crate::widgets::picture::{Body, DrawLayer, LabelSide, Pen, Picture, View};
use crate::widgets::replay::{ShotImpact, impacts};
use crate::widgets::{Role, board, sheet};

/// Length of the arrow of the shot, in metres per m/s.
const ARROW: f64 = 0.03;
/// Length of a predicted ray, in metres.
const RAY: f64 = 0.14;
/// Length of a predicted ray in an enlarged picture of the discs, in metres.
const NEAR_RAY: f64 = 0.055;

/// Space around the discs, in metres, for levels in which only the first collision matters, so that
/// the discs can be seen leaving.
const MARGIN: f64 = 0.02;

/// The part of the board that is shown: the whole board, or an enlarged part with the discs if only
/// their first collision matters.
pub(super) fn view(level: &Level, area: Rect) -> View {
    let scene = &level.scene;
    if !level.is_of_the_first_hit() {
        return board::view(board::square(area), &scene.board);
    }
    let mut corners = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    let mut take_in = |at: DVec2, room: f64| {
        corners[0] = corners[0].min(at - DVec2::splat(room));
        corners[1] = corners[1].max(at + DVec2::splat(room));
    };
    for (number, piece) in scene.pieces.iter().enumerate() {
        if number == scene.stroke.disc {
            let places = level.adjust.range(Dial::Place);
            let ends = places.map(|range| [range.from, range.to].map(m_from_mm));
            let ends = ends.unwrap_or([piece.at.x; 2]);
            for x in ends {
                take_in(DVec2::new(x, piece.at.y), piece.disc.radius);
            }
        } else {
            // The striker may touch the disc from any side.
            let striker = scene.pieces.get(scene.stroke.disc);
            let beside = 2.0 * striker.map_or(0.0, |striker| striker.disc.radius);
            take_in(piece.at, piece.disc.radius + beside + MARGIN);
        }
    }
    let view = View::fit(area, corners[0], corners[1]);
    let mut pieces = scene.pieces.iter().enumerate();
    let target = pieces.find(|(disc, _)| *disc != scene.stroke.disc);
    target.map_or(view, |(_, target)| view.with_in_a_middle(target.at))
}

/// The empty board with the circles of the goals.
fn ground(level: &Level, area: Rect) -> Picture {
    let view = view(level, area);
    let mut picture = Picture::new(view);
    let board = &level.scene.board;
    board::ground(&mut picture, board);
    for (circle, _) in level.goals.iter().filter_map(|goal| goal.circle()) {
        let pen = Pen::new(Role::Good).on(DrawLayer::Ground);
        picture.circle(circle.centre, circle.radius, pen);
    }
    picture
}

/// Labels the circles, and numbers the discs if there are several of one kind.
fn labels(level: &Level, picture: &mut Picture, discs: &[(usize, DVec2)]) {
    let circles = level.goals.iter().filter_map(|goal| goal.circle());
    let circles: Vec<_> = circles.collect();
    for (circle, disc) in &circles {
        // A single circle is labelled "goal"; several are labelled with the names of their discs.
        let name = level.scene.name(*disc);
        let text = match circles.as_slice() {
            [_] => "goal",
            _ => name.trim_start_matches("the ").trim_end_matches(" coin"),
        };
        let anchor = circle.centre + circle.radius * DVec2::Y;
        let up = LabelSide::towards(DVec2::Y);
        picture.label(text, anchor, &up, Role::Good);
    }
    let pieces = &level.scene.pieces;
    for (disc, at) in discs {
        let Some(piece) = pieces.get(*disc) else {
            continue;
        };
        let alike = |&(_, other): &(usize, &crate::levels::PlacedDisc)| other.kind == piece.kind;
        let numbers = || pieces.iter().enumerate().filter(alike);
        if numbers().count() > 1 {
            let number = numbers().filter(|(other, _)| other <= disc).count();
            let role = face(piece.kind).role;
            picture.label(number.to_string(), *at, &LabelSide::ALL, role);
        }
    }
}

fn discs(level: &Level, picture: &mut Picture, discs: &[(usize, DVec2)]) {
    sheet::next_picture_shows(|| {
        let discs = discs.iter();
        board::places_in_words(discs.map(|(disc, at)| (level.scene.name(*disc), *at)))
    });
    let body = |&(disc, at): &(usize, DVec2)| {
        let piece = level.scene.pieces.get(disc)?;
        let face = face(piece.kind);
        Some(Body::new(at, piece.disc.radius, face.role, face.letter))
    };
    picture.discs(discs.iter().filter_map(body));
}

/// The board with the aimed shot, up to the first contact.
pub(super) fn of_aim(level: &Level, scene: &Scene, met: Option<FirstMet>, area: Rect) -> Picture {
    let mut picture = ground(level, area);
    let places = scene.pieces.iter().map(|piece| piece.at).enumerate();
    let places: Vec<_> = places.collect();
    let velocity = scene.stroke.velocity();
    let aimed = scene.pieces.get(scene.stroke.disc);
    let aimed = aimed.zip(velocity.try_normalize());
    if let (Some((piece, _)), Some(met)) = (aimed, met) {
        picture.line(piece.at, met.at, Pen::new(Role::Aim).dotted());
        if met.impact.is_some() {
            board::ghost(&mut picture, met.at, piece.disc.radius, Role::Predicted);
        }
    }
    discs(level, &mut picture, &places);
    if let Some((piece, heading)) = aimed {
        let from = piece.at + piece.disc.radius * heading;
        picture.arrow(from, from + ARROW * velocity, Role::Incoming);
    }
    labels(level, &mut picture, &places);
    picture
}

/// Where a disc first meets something or stops.
#[derive(Debug, Clone, Copy)]
pub(super) struct FirstMet {
    at: DVec2,
    /// The impact, if the disc meets another disc.
    pub(super) impact: Option<ShotImpact>,
}

/// Where the disc played in a scene's shot first meets something or stops.
pub(super) fn first_met(scene: &Scene) -> Option<FirstMet> {
    let (shot, aimed) = (scene.play_for_a_moment(), scene.stroke.disc);
    let (time, touches) = shot.events().iter().find_map(|event| {
        let touches = event.kind.partner(aimed).is_some();
        (touches || event.kind.discs().0 == aimed).then_some((event.time, touches))
    })?;
    Some(FirstMet {
        at: shot.at(aimed, time).position,
        impact: impacts(&shot, aimed).next().filter(|_| touches),
    })
}

/// A shot at the time of its clock, with the paths so far.
pub(super) fn of_made(level: &Level, made: &MadeShot, area: Rect) -> Picture {
    let mut picture = ground(level, area);
    let player = &made.player;
    let (shot, now) = (player.shot(), player.clock().time());
    for disc in 0..shot.discs().len() {
        let role = if disc == level.scene.stroke.disc {
            Role::StrikerOut
        } else {
            Role::CoinOut
        };
        trail(&mut picture, shot, disc, now, role);
    }
    let places: Vec<_> = player.discs().collect();
    if level.is_of_the_first_hit()
        && let Some(impact) = player.impacts().first().filter(|impact| impact.time < now)
    {
        // The discs soon leave the picture, so their positions at the contact are drawn too.
        for disc in impact.discs {
            let at = shot.at(disc, impact.time).position;
            let radius = shot.discs().get(disc).map_or(0.0, |disc| disc.radius);
            board::ghost(&mut picture, at, radius, Role::Trail);
        }
    }
    discs(level, &mut picture, &places);
    said(&mut picture, level, made);
    labels(level, &mut picture, &places);
    picture
}

/// The path of a disc so far.
fn trail(picture: &mut Picture, shot: &Shot, disc: usize, now: f64, role: Role) {
    let pen = Pen::new(role).on(DrawLayer::Trail).dotted();
    for leg in shot.path(disc).take_while(|leg| leg.start < now) {
        let to = if leg.end <= now {
            leg.to
        } else {
            shot.at(disc, now).position
        };
        picture.line(leg.from, to, pen);
    }
}

/// The prediction for the first impact, once it has happened.
fn said(picture: &mut Picture, level: &Level, made: &MadeShot) {
    let player = &made.player;
    let (Some(said), Some(impact)) = (&made.said, player.impacts().first()) else {
        return;
    };
    let Some(heading) = impact.collision.u1.try_normalize() else {
        return;
    };
    if player.clock().time() < impact.time {
        return;
    }
    for ray in asked(said) {
        let Some(angle) = said.so_far().get(ray) else {
            continue;
        };
        // The scattering angle is positive anticlockwise, the recoil angle clockwise.
        let [first, second] = impact.discs;
        let (turn, disc) = match ray {
            Ray::Striker => (angle, first),
            Ray::Target => (-angle, second),
        };
        let way = DVec2::from_angle(turn).rotate(heading);
        let centre = player.shot().at(disc, impact.time).position;
        let length = match level.is_of_the_first_hit() {
            true => NEAR_RAY,
            false => RAY,
        };
        let tip = centre + length * way;
        picture.line(centre, tip, Pen::new(Role::Predicted).dashed());
        picture.label("you", tip, &LabelSide::towards(way), Role::Predicted);
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;
    use crate::files::FileLibrary;
    use crate::levels::LevelLibrary;
    use crate::physics::Board;
    use crate::widgets::ink::centres::{Drawn, centre_errors};
    use crate::widgets::svg::Svg;
    use crate::widgets::{Charset, Look};

    /// Every piece is a circle, and no number is NaN.
    #[test]
    fn the_board_of_every_level_can_be_drawn_as_svg() {
        let look = Look::default();
        let library = LevelLibrary::embedded();
        for level in library.packs.iter().flat_map(|pack| &pack.levels) {
            let picture = of_aim(level, &level.scene, None, Rect::new(0, 0, 80, 36));
            let file = Svg::new(&level.title, &picture, &look, 1.0).file();
            let read = roxmltree::Document::parse(&file).unwrap();
            let circles = read.descendants().filter(|it| it.has_tag_name("circle"));
            assert!(circles.count() >= level.scene.pieces.len(), "{}", level.id);
            assert!(!file.contains("NaN"), "{}", level.id);
        }
    }

    /// The areas of a board in windows of 80 × 24, 100 × 30, 120 × 40 and 200 × 60.
    const AREAS: [Rect; 4] = [
        Rect::new(1, 2, 39, 20),
        Rect::new(1, 2, 51, 26),
        Rect::new(1, 2, 71, 36),
        Rect::new(1, 2, 111, 56),
    ];

    /// A board with all its discs at random places, none overlapping another.
    fn scattered(area: Rect, seed: u64) -> Picture {
        let mut places: Vec<DVec2> = Vec::new();
        let mut rng = Pcg64::seed_from_u64(seed);
        while places.len() < 20 {
            let [x, y] = [(); 2].map(|()| rng.random_range(-0.34..0.34));
            let at = DVec2::new(x, y);
            if places.iter().all(|other| other.distance(at) > 0.042) {
                places.push(at);
            }
        }
        let mut picture = Picture::new(board::view(board::square(area), &Board::default()));
        picture.discs(places.into_iter().enumerate().map(|(number, at)| {
            let (radius, face) = match number {
                0 => (0.020_65, (Role::Striker, 'S')),
                1 => (0.0159, (Role::Queen, 'Q')),
                _ => (0.0159, (Role::Coin, 'W')),
            };
            Body::new(at, radius, face.0, face.1)
        }));
        picture
    }

    #[test]
    fn discs_are_drawn_at_their_true_places() {
        let library = LevelLibrary::embedded();
        let levels: Vec<&Level> = library.packs.iter().flat_map(|pack| &pack.levels).collect();
        println!("charset, area, discs: number, mean and worst error in columns and in rows");
        for charset in [Charset::Unicode, Charset::Ascii] {
            for area in AREAS {
                let of_levels = levels
                    .iter()
                    .map(|level| of_aim(level, &level.scene, None, area));
                let boards = (0..60).map(|seed| scattered(area, seed));
                let pictures = of_levels.chain(boards);
                let errors: Vec<_> = pictures
                    .flat_map(|picture| centre_errors(&picture, charset))
                    .collect();
                for (drawn, most) in [(Drawn::Round, 0.25), (Drawn::Token, 0.5)] {
                    let errors = errors.iter().filter(|it| it.1 == drawn);
                    let errors: Vec<DVec2> = errors.map(|it| it.2.abs()).collect();
                    let worst = errors.iter().copied().reduce(DVec2::max);
                    let Some(worst) = worst else { continue };
                    let count = errors.len();
                    let mean = errors.iter().sum::<DVec2>() / count as f64;
                    println!("{charset:?} {area} {drawn:?}: {count}, {mean:.3}, {worst:.3}");
                    assert!(worst.max_element() <= most);
                }
            }
        }
    }

    /// A striker that is aimed at the drawn centre of a round disc hits it nearly head-on.
    #[test]
    fn an_aim_read_off_the_picture_hits_as_drawn() {
        let library = LevelLibrary::embedded();
        let levels = library.packs.iter().flat_map(|pack| &pack.levels);
        for (number, level) in (1..).zip(levels) {
            // The limits are in degrees. The smaller the discs are drawn, the larger the angle to
            // which a quarter of a cell corresponds.
            for (area, most) in AREAS.into_iter().zip([16.0, 6.0, 6.0, 6.0]) {
                let picture = of_aim(level, &level.scene, None, area);
                let discs = centre_errors(&picture, Charset::Unicode);
                let per_cell =
                    DVec2::new(view(level, area).per_column(), -view(level, area).per_row());
                let drawn = |disc: usize| discs[disc].0.at + discs[disc].2 * per_cell;
                let aimed = level.scene.stroke.disc;
                for (target, (body, kind, _)) in discs.iter().enumerate() {
                    assert_eq!(*kind, Drawn::Round, "level {number}");
                    let from = discs[aimed].0;
                    let Some(way) = (drawn(target) - drawn(aimed)).try_normalize() else {
                        continue;
                    };
                    let offset = way.perp_dot(body.at - from.at) / (body.radius + from.radius);
                    let angle = offset.asin().to_degrees().abs();
                    assert!(angle < most, "level {number}, {area}: {angle}");
                    if number == 49 {
                        println!("level {number}, {area}: {angle:.1}°");
                    }
                }
            }
        }
    }

    #[test]
    fn if_only_the_first_collision_matters_the_discs_are_complete_and_enlarged() {
        let library = LevelLibrary::embedded();
        let mut fitted = 0;
        for level in library.packs.iter().flat_map(|pack| &pack.levels) {
            if !level.is_of_the_first_hit() {
                continue;
            }
            fitted += 1;
            for area in [
                Rect::new(1, 2, 32, 15),
                Rect::new(1, 2, 48, 20),
                Rect::new(1, 2, 80, 36),
            ] {
                let view = view(level, area);
                for piece in &level.scene.pieces {
                    for way in [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y] {
                        // Rounding to the middle of a cell may cut off half a cell.
                        let edge = piece.at + piece.disc.radius * way;
                        let cell = view.to_cell(edge);
                        let inside = |low: u16, at: f64, high: u16| {
                            (f64::from(low) - 0.5..f64::from(high) + 0.5).contains(&at)
                        };
                        let shown = inside(area.left(), cell.x, area.right())
                            && inside(area.top(), cell.y, area.bottom());
                        assert!(shown, "{}: {cell}", level.id);
                    }
                }
                let whole = board::view(board::square(area), &level.scene.board);
                assert!(view.per_row() < whole.per_row(), "{}", level.id);
            }
        }
        assert!(fitted > 15);
    }
}
