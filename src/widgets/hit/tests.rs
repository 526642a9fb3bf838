//! Tests of printed pictures for all kinds of collisions.

use glam::{DVec2, dvec2};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Color;
use roxmltree::Document;

use super::explanation_step::ExplanationStep;
use super::*;
use crate::physics::{Bond, Collision, Disc, Frame};
use crate::quiz::{AimTask, Ray};
use crate::widgets::ink::Canvas;
use crate::widgets::picture::{Mark, Picture};
use crate::widgets::svg::Svg;
use crate::widgets::{Charset, Depth, Look, Palette, Role, Theme};

const AREA: Rect = Rect::new(0, 0, 44, 18);

const PIECES: [(f64, f64, f64, f64); 6] = [
    (15.0, 15.0, 15.0, 15.0),
    (15.0, 20.65, 5.5, 15.9),
    (20.0, 12.4, 40.0, 15.6),
    (1.0, 4.0, 1000.0, 20.0),
    (1000.0, 20.0, 1.0, 4.0),
    (15.0, 15.0, 15.0, 6.0),
];

fn collisions() -> Vec<Collision> {
    let mut all = Vec::new();
    for (m1, r1, m2, r2) in PIECES {
        let (striker, target) = (Disc::from_g_mm(m1, r1), Disc::from_g_mm(m2, r2));
        for direction in [0.0_f64, 125.0] {
            let u1 = 4.0 * DVec2::from_angle(direction.to_radians());
            for alpha in [
                -89.0_f64, -60.0, -33.0, -5.0, 0.0, 1.0, 15.0, 30.0, 45.0, 75.0, 90.0,
            ] {
                all.push(Collision::at_angle(striker, target, u1, alpha.to_radians()));
            }
            let beside = 1.3 * (striker.radius + target.radius);
            all.push(Collision::at_offset(striker, target, u1, beside));
            let hit = Collision::at_angle(striker, target, u1, 0.5);
            let u2 = dvec2(-1.0, 0.7);
            all.push(Collision { u2, ..hit });
            all.push(Collision { u2: -u1, ..hit });
            let (u1, u2) = (DVec2::ZERO, -u1);
            all.push(Collision { u1, u2, ..hit });
            let bond = Bond::Stick;
            all.push(Collision { bond, ..hit });
            let restitution = 0.3;
            all.push(Collision { restitution, ..hit });
        }
    }
    all
}

/// A printed picture, as an SVG file.
fn file(picture: &Picture) -> String {
    let look = Look::default();
    Svg::new("a hit", picture, &look, 0.75).file()
}

/// The labels of a picture. This also checks that the picture fits the paper, and that the file is
/// well-formed, contains a circle and has only finite coordinates.
fn labels(picture: &Picture) -> Vec<String> {
    let area = picture.area();
    assert!(area.width.min(area.height) >= 10, "{area}");
    assert!(area.width <= 100 && area.height <= 50, "{area}");
    let file = file(picture);
    assert!(!file.contains("NaN") && !file.contains("inf"), "{file}");
    let read = Document::parse(&file).unwrap();
    assert!(read.descendants().any(|it| it.has_tag_name("circle")));
    let texts = read.descendants().filter(|it| it.has_tag_name("text"));
    texts
        .map(|it| it.text().unwrap_or_default().to_owned())
        .collect()
}

fn revealed(collision: &Collision) -> Picture {
    let mut layers = Overlays::default();
    layers.toggle(Overlay::Triangle);
    let watch = Watch::revealed(*collision).with_layers(layers);
    watch.with_measures().picture(AREA)
}

const GIVEN: Markings = Markings {
    offset: true,
    angle: true,
    figures: true,
};

#[test]
fn every_collision_can_be_printed_before_and_after_the_contact() {
    for collision in collisions() {
        let before = labels(&protractor_picture(&collision, GIVEN));
        for angle in ["30", "60", "90", "120", "150"] {
            let marks = before.iter().filter(|it| *it == angle).count();
            assert!(marks >= 1, "{angle} {before:?} {collision:?}");
        }
        if collision.alpha().is_some() {
            let is_revealed = before.iter().any(|it| it.starts_with("α = "));
            assert!(is_revealed, "{before:?} {collision:?}");
        }
        let after = labels(&revealed(&collision));
        let masses = after.iter().filter(|it| it.ends_with(" g")).count();
        assert_eq!(masses, 2, "{after:?} {collision:?}");
    }
}

#[test]
fn an_observed_collision_shows_only_its_angles() {
    for collision in collisions() {
        // At twice the speed and with twice the masses the picture looks the same.
        let heavier = |disc: Disc| Disc {
            mass: 2.0 * disc.mass,
            ..disc
        };
        let other = Collision {
            striker: heavier(collision.striker),
            target: heavier(collision.target),
            u1: 2.0 * collision.u1,
            u2: 2.0 * collision.u2,
            ..collision
        };
        let [one, two] = [collision, other].map(|it| after_picture(AREA, &it));
        assert_eq!(file(&one), file(&two));
        assert!(!labels(&one).iter().any(|it| it.contains("m/s")));
    }
}

#[test]
fn a_shot_to_set_up_shows_its_angle_and_a_scale_in_true_size() {
    for (m1, r1, m2, r2) in PIECES {
        let (striker, target) = (Disc::from_g_mm(m1, r1), Disc::from_g_mm(m2, r2));
        for turn in 0..12 {
            let u1 = 4.0 * DVec2::from_angle(f64::from(30 * turn).to_radians());
            for wanted_deg in [-120.0_f64, -80.0, -35.0, 15.0, 45.0, 75.0, 130.0] {
                for ray in Ray::BOTH {
                    let aim = AimTask {
                        collision: Collision::at_offset(striker, target, u1, 0.0),
                        ray,
                        wanted: wanted_deg.to_radians(),
                        offset: 0.01,
                    };
                    let found = labels(&scale_picture(&aim));
                    let angle = format!("{:.1}°", wanted_deg.abs());
                    for text in [&angle, "left, mm", "right, mm", "u = 4.00 m/s"] {
                        assert!(
                            found.iter().any(|it| it == text),
                            "{text} {found:?} {aim:?}"
                        );
                    }
                    // The solution is not revealed.
                    let other = AimTask {
                        offset: -0.02,
                        ..aim
                    };
                    assert_eq!(file(&scale_picture(&other)), file(&scale_picture(&aim)));
                }
            }
        }
    }
}

#[test]
fn discs_that_graze_each_other_are_shown_as_two_even_if_their_rims_stick() {
    let piece = Disc::from_g_mm(15.0, 15.0);
    let smooth = Collision::at_offset(piece, piece, dvec2(4.0, 0.0), 0.03);
    let sticky = Collision {
        bond: Bond::Stick,
        ..smooth
    };
    for frame in [Frame::Laboratory, Frame::CentreOfMass] {
        let [one, two] = [smooth, sticky].map(|it| Watch::revealed(it).seen_from(frame));
        assert_eq!(labels(&one.picture(AREA)), labels(&two.picture(AREA)));
    }
    let line = ExplanationStep::Line;
    let [one, two] = [smooth, sticky].map(|it| Watch::revealed(it).step_words(line));
    assert_eq!(one, two);
}

#[test]
fn letters_and_numbers_match_the_collision() {
    let piece = Disc::from_g_mm(15.0, 15.0);
    let hit = Collision::at_angle(piece, piece, dvec2(4.0, 0.0), 30_f64.to_radians());
    // The components are 4 m/s times sin 30° and cos 30°.
    let mut found = labels(&revealed(&hit));
    found.sort();
    let mut expected = [
        "S",
        "C",
        "15.0 g",
        "15.0 g",
        "n",
        "t",
        "α = 30.0°",
        "u = 4.00 m/s",
        "v₁ = 2.00 m/s",
        "v₂ = 3.46 m/s",
        "60.0°",
        "30.0°",
    ];
    expected.sort_unstable();
    assert_eq!(found, expected);
    // The answer is not revealed.
    let found = labels(&protractor_picture(&hit, Markings::default()));
    let is_letter = |it: &String| it.parse::<f64>().is_err();
    let letters: Vec<_> = found.into_iter().filter(is_letter).collect();
    assert_eq!(letters, ["S", "C", "u"]);
    let angle = Markings {
        angle: true,
        ..Markings::default()
    };
    let found = labels(&protractor_picture(&hit, angle));
    assert!(found.contains(&"α".to_owned()) && !found.iter().any(|it| it.contains('=')));
}

#[test]
fn a_disc_at_rest_and_a_miss_are_labelled() {
    let piece = Disc::from_g_mm(15.0, 15.0);
    let head_on = Collision::at_offset(piece, piece, dvec2(4.0, 0.0), 0.0);
    let found = labels(&revealed(&head_on));
    let still = "v₁ = 0: at rest".to_owned();
    assert!(found.contains(&still), "{found:?}");
    let miss = Collision::at_offset(piece, piece, dvec2(4.0, 0.0), 0.04);
    assert!(!labels(&revealed(&miss)).iter().any(|it| it.contains('α')));
}

/// A picture drawn into cells, on the background of its theme.
fn cells(picture: &Picture, look: &Look) -> Buffer {
    let mut buffer = Buffer::empty(picture.area());
    buffer.set_style(picture.area(), look.theme.base());
    picture.draw(&mut buffer, look);
    buffer
}

/// The distances from the tail, in columns along an arrow, of the cells that show the arrow's
/// colour on a background of another colour.
fn seen_along(
    buffer: &Buffer,
    picture: &Picture,
    [from, to]: [DVec2; 2],
    colour: Color,
) -> Vec<f64> {
    let column = picture.view().per_column();
    let along = (to - from).normalize();
    let cells = buffer.area.positions().filter(|at| {
        let cell = &buffer[*at];
        cell.symbol() != " " && cell.fg == colour && cell.bg != colour
    });
    let offsets = cells.map(|at: Position| (picture.view().world_at(at.x, at.y) - from) / column);
    let near = offsets.filter(|offset| offset.perp_dot(along).abs() < 1.6);
    near.map(|offset| offset.dot(along)).collect()
}

/// The six steps that explain a frictionless hit, with their pictures, in the given frame.
fn steps(
    collision: &Collision,
    frame: Frame,
    area: Rect,
) -> impl Iterator<Item = (String, Picture)> {
    let mut watch = Watch::new(*collision, None, HitPace::Still).seen_from(frame);
    (0..6).map(move |step| {
        if step > 0 {
            watch.act(WatchAction::Step(1));
        }
        (format!("step {}", step + 1), watch.picture(area))
    })
}

#[test]
fn each_arrow_is_visible_from_end_to_end_in_the_colour_of_its_label() {
    let themes = [
        (Palette::Dark, Depth::True),
        (Palette::Dark, Depth::Indexed256),
        (Palette::Dark, Depth::Ansi16),
        (Palette::Light, Depth::True),
        (Palette::Light, Depth::Ansi16),
    ];
    let areas = [Rect::new(0, 0, 48, 20), Rect::new(0, 0, 74, 36)];
    let mut arrows = 0;
    let (board, centre) = (Frame::Laboratory, Frame::CentreOfMass);
    for (m2, alpha_deg, frame) in [
        (15.0, 30.0_f64, board),
        (15.0, 50.0, board),
        (5.0, 40.0, board),
        (45.0, -35.0, board),
        (15.0, 30.0, centre),
        (10.0, -50.0, centre),
    ] {
        let (striker, coin) = (Disc::from_g_mm(15.0, 15.0), Disc::from_g_mm(m2, 15.0));
        let hit = Collision::at_angle(striker, coin, dvec2(4.0, 0.0), alpha_deg.to_radians());
        for (charset, (palette, depth), area) in [Charset::Ascii, Charset::Unicode]
            .into_iter()
            .flat_map(|charset| themes.map(|theme| (charset, theme)))
            .flat_map(|(charset, theme)| areas.map(|area| (charset, theme, area)))
        {
            let theme = Theme::new(palette, depth);
            let look = Look {
                charset,
                theme,
                ..Look::default()
            };
            for (step, picture) in steps(&hit, frame, area) {
                let buffer = cells(&picture, &look);
                let canvas = Canvas::of(&picture, &look);
                let place = format!(
                    "{m2} g {alpha_deg} {frame:?} {charset:?} {palette:?} {depth:?} {step}"
                );
                for mark in &picture.marks {
                    let Mark::Arrow { from, to, pen } = mark else {
                        continue;
                    };
                    let colour = theme.colour(pen.role);
                    let labels = canvas.labels.iter();
                    let own = labels.filter(|label| label.role == pen.role);
                    let like = |it: &&Mark| matches!(it, Mark::Arrow { pen: other, .. } if other.role == pen.role);
                    let arrows_like = picture.marks.iter().filter(like).count();
                    assert_eq!(own.clone().count(), arrows_like, "{place}: {:?}", pen.role);
                    for label in own {
                        assert_eq!(buffer[label.place.as_position()].fg, colour, "{place}");
                    }
                    let length = from.distance(*to) / picture.view().per_column();
                    let seen = seen_along(&buffer, &picture, [*from, *to], colour);
                    let (first, last) = (
                        seen.iter().copied().fold(f64::INFINITY, f64::min),
                        seen.iter().copied().fold(f64::NEG_INFINITY, f64::max),
                    );
                    let role = pen.role;
                    assert!(
                        last > length - 2.0,
                        "{place}: {role:?} ends at {last} of {length}"
                    );
                    // An incoming arrow may begin outside the picture.
                    if role != Role::Incoming || picture.view().cell_at(*from).is_some() {
                        let shared = f64::max(3.0, 0.5 * length);
                        assert!(first < shared, "{place}: {role:?} begins at {first}");
                    }
                    arrows += 1;
                }
            }
        }
    }
    assert!(arrows > 500, "{arrows}");
}

#[test]
fn an_arrow_of_one_step_has_the_same_length_in_the_next() {
    let piece = Disc::from_g_mm(15.0, 15.0);
    let hit = Collision::at_angle(piece, piece, dvec2(4.0, 0.0), 30_f64.to_radians());
    let steps: Vec<_> = steps(&hit, Frame::Laboratory, AREA)
        .map(|(_, picture)| picture)
        .collect();
    let length = |step: usize, role: Role| {
        steps[step].marks.iter().find_map(|mark| match mark {
            Mark::Arrow { from, to, pen } if pen.role == role => Some(from.distance(*to)),
            _ => None,
        })
    };
    let part = length(2, Role::NormalPart).unwrap();
    assert_eq!(length(3, Role::NormalPart), Some(part));
    // The coin gains what the striker loses: v₂ = u₁ₙ, v₁ = u₁ₜ.
    assert!((length(3, Role::CoinOut).unwrap() - part).abs() < 1e-12);
    let across = length(2, Role::TangentPart).unwrap();
    assert!((length(4, Role::StrikerOut).unwrap() - across).abs() < 1e-12);
}

/// If both discs move, each has its arrows and their names on its own side.
#[test]
fn no_name_is_beside_the_other_disc() {
    let piece = Disc::from_g_mm(15.0, 15.0);
    let at = |alpha_deg: f64| {
        let alpha = alpha_deg.to_radians();
        Collision::at_angle(piece, piece, dvec2(3.0, 0.0), alpha)
    };
    // The striker catches up with the coin.
    let chase = Collision {
        u2: dvec2(1.0, 0.0),
        ..at(0.0)
    };
    let seen = [
        (chase, Frame::Laboratory, ["u₁", "u₂"]),
        (at(30.0), Frame::CentreOfMass, ["u − V", "−V"]),
    ];
    for (collision, frame, names) in seen {
        for area in [(36, 22), (48, 20), (74, 36)].map(|(w, h)| Rect::new(0, 0, w, h)) {
            let look = Look::default();
            for (step, picture) in steps(&collision, frame, area).take(3) {
                let canvas = Canvas::of(&picture, &look);
                let (c1, c2) = collision.placed_at_contact();
                for (body, name) in names.into_iter().enumerate() {
                    let mut labels = canvas.labels.iter();
                    let label = labels
                        .find(|it| it.text == name || it.text.starts_with(&format!("{name} =")));
                    // In a narrow picture there may be no room for a label.
                    let Some(label) = label else {
                        continue;
                    };
                    // The end of the label that is closer to the disc's own side.
                    let ends = [label.place.left(), label.place.right()];
                    let end = ends[usize::from([c1.x, c2.x][body] > 0.0)];
                    let x = picture.view().world_at(end, label.place.y).x;
                    let side = (x - (c1.x + c2.x) / 2.0) * [c1.x - c2.x, c2.x - c1.x][body];
                    assert!(side > 0.0, "{area} {step}: {name} at {x}");
                }
            }
        }
    }
}

/// Before a head-on collision, an arrow stops short of the other disc.
#[test]
fn no_arrow_before_the_collision_runs_into_the_other_disc() {
    let piece = Disc::from_g_mm(15.0, 15.0);
    let head_on = Collision::at_angle(piece, piece, dvec2(3.0, 0.0), 0.0);
    for u2 in [dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(-2.0, 0.0)] {
        let collision = Collision { u2, ..head_on };
        let picture = setup_picture(AREA, Face::STRIKER_AND_COIN, &collision, GIVEN, None);
        let bodies = picture.marks.iter().filter_map(|mark| match mark {
            Mark::Disc(body) => Some(body),
            _ => None,
        });
        let discs: Vec<_> = bodies.collect();
        for mark in &picture.marks {
            if let Mark::Arrow { to, .. } = mark {
                let free = discs.iter().all(|it| it.at.distance(*to) > it.radius);
                assert!(free, "{u2}: {to}");
            }
        }
    }
}
