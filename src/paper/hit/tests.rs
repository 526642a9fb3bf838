//! Pictures of all kinds of hits, and what must hold of each.

use glam::{DVec2, dvec2};
use roxmltree::Document;

use super::*;
use crate::physics::{Bond, Disc};

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
            all.push(Collision::at_offset(
                striker,
                target,
                u1,
                1.3 * (striker.radius + target.radius),
            ));
            let hit = Collision::at_angle(striker, target, u1, 0.5);
            all.push(Collision {
                u2: dvec2(-1.0, 0.7),
                ..hit
            });
            all.push(Collision { u2: -u1, ..hit });
            all.push(Collision {
                u1: DVec2::ZERO,
                u2: -u1,
                ..hit
            });
            all.push(Collision {
                bond: Bond::Stick,
                ..hit
            });
            all.push(Collision {
                restitution: 0.3,
                ..hit
            });
        }
    }
    all
}

fn each_choice() -> impl Iterator<Item = Shown> {
    (0..8_u8).flat_map(|bits| {
        [After::Nothing, After::Space, After::Departures].map(|after| Shown {
            offset: bits & 1 > 0,
            angle: bits & 2 > 0,
            line_of_impact: bits & 4 > 0,
            masses: true,
            numbers: true,
            speeds: true,
            after,
        })
    })
}

#[test]
fn no_label_covers_what_matters() {
    for collision in collisions() {
        for shown in each_choice() {
            let sheet = draw(&collision, &shown);
            assert!(sheet.labels.len() >= 3);
            labels_are_free(&sheet, &format!("{collision:?} {shown:?}"));
            for label in &sheet.labels {
                let told = || format!("{label:?} {collision:?} {shown:?}");
                // Upon a disc, or clear of all of them.
                let discs = &sheet.obstacles.discs;
                let upon = |(centre, radius): &(DVec2, f64)| {
                    let (a, b) = (label.least - *centre, label.most - *centre);
                    a.abs().max(b.abs()).length() <= radius + 4.0
                };
                let clear = |(centre, radius): &(DVec2, f64)| label.distance(*centre) >= *radius;
                let well = discs.iter().any(upon) || discs.iter().all(clear);
                assert!(well, "{}", told());
            }
            is_whole(sheet, &collision);
        }
    }
}

/// No label covers another one, nor an arrow's tip.
fn labels_are_free(sheet: &Sheet, told: &str) {
    for (i, label) in sheet.labels.iter().enumerate() {
        let others = &sheet.labels[i + 1..];
        assert!(
            !others.iter().any(|it| it.overlaps(label)),
            "{label:?} {told}"
        );
        let tips = &sheet.obstacles.points;
        let is_covered = |tip: &DVec2| label.distance(*tip) < 3.0;
        assert!(!tips.iter().any(is_covered), "{label:?} {told}");
    }
}

#[test]
fn a_hit_that_was_seen_tells_its_angles_alone() {
    for collision in collisions() {
        let sheet = draw_seen(&collision);
        labels_are_free(&sheet, &format!("{collision:?}"));
        is_whole(sheet, &collision);
        // As fast again, with masses twice as large, it looks the same.
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
        let pictures = [collision, other].map(|it| seen_picture(&it).file());
        assert_eq!(pictures[0], pictures[1]);
        assert!(!pictures[0].contains("m/s"));
    }
}

#[test]
fn a_shot_to_be_set_has_its_mark_and_a_scale_true_to_size() {
    for (m1, r1, m2, r2) in PIECES {
        let (striker, target) = (Disc::from_g_mm(m1, r1), Disc::from_g_mm(m2, r2));
        for turn in 0..12 {
            let u1 = 4.0 * DVec2::from_angle(f64::from(30 * turn).to_radians());
            for wanted_deg in [-120.0_f64, -80.0, -35.0, 15.0, 45.0, 75.0, 130.0] {
                for ray in crate::quiz::Ray::BOTH {
                    let aim = AimTask {
                        collision: Collision::at_offset(striker, target, u1, 0.0),
                        ray,
                        wanted: wanted_deg.to_radians(),
                        offset: 0.01,
                    };
                    let sheet = draw_aim(&aim);
                    labels_are_free(&sheet, &format!("{aim:?}"));
                    is_whole(sheet, &aim.collision);
                    let file = aim_picture(&aim).file();
                    assert!(file.contains(&format!(">{:.1}°<", wanted_deg.abs())));
                    // What does it is not given away.
                    let other = AimTask {
                        offset: -0.02,
                        ..aim
                    };
                    assert_eq!(aim_picture(&other).file(), file);
                }
            }
        }
    }
}

/// The picture is well-formed, shows all of its labels and is of a size for paper.
fn is_whole(sheet: Sheet, collision: &Collision) {
    let labels = sheet.labels.clone();
    let picture = sheet.picture();
    let size = picture.size();
    assert!(size.min_element() > 60.0, "{size} {collision:?}");
    assert!(size.max_element() < 600.0, "{size} {collision:?}");
    let file = picture.file();
    let read = Document::parse(&file).unwrap();
    let view = read.root_element().attribute("viewBox").unwrap();
    let view: Vec<f64> = view.split(' ').map(|it| it.parse().unwrap()).collect();
    let (least, size) = (dvec2(view[0], view[1]), dvec2(view[2], view[3]));
    for label in labels {
        assert!(label.least.cmpge(least).all());
        assert!(label.most.cmple(least + size).all());
    }
}

/// The labels of a picture.
fn labels(collision: &Collision, shown: &Shown) -> Vec<String> {
    let file = hit_picture(collision, shown).file();
    let read = Document::parse(&file).unwrap();
    let texts = read.descendants().filter(|it| it.has_tag_name("text"));
    texts
        .map(|it| it.text().unwrap_or_default().to_owned())
        .collect()
}

#[test]
fn letters_and_numbers_are_those_of_the_hit() {
    let piece = Disc::from_g_mm(15.0, 15.0);
    let hit = Collision::at_angle(piece, piece, dvec2(4.0, 0.0), 30_f64.to_radians());
    let all = Shown {
        offset: true,
        angle: true,
        line_of_impact: true,
        masses: true,
        numbers: true,
        speeds: true,
        after: After::Departures,
    };
    // 30 mm sin 30° = 15 mm; 4 m/s sin 30° and cos 30°.
    let mut found = labels(&hit, &all);
    found.sort();
    let mut expected = [
        "15.0 g",
        "15.0 g",
        "b = 15.0 mm",
        "α = 30.0°",
        "line of impact",
        "u = 4.00 m/s",
        "v₁ = 2.00 m/s",
        "v₂ = 3.46 m/s",
        "θ₁ = 60.0°",
        "θ₂ = 30.0°",
    ];
    expected.sort_unstable();
    assert_eq!(found, expected);
    // What is asked is not given away: a mass, say, by speeds beside the angles.
    let angles = Shown {
        numbers: true,
        after: After::Departures,
        ..Shown::default()
    };
    let mut found = labels(&hit, &angles);
    found.sort();
    assert_eq!(found, ["u", "v₁", "v₂", "θ₁ = 60.0°", "θ₂ = 30.0°"]);
    assert_eq!(labels(&hit, &Shown::default()), ["u"]);
    let given = Shown {
        angle: true,
        after: After::Space,
        ..Shown::default()
    };
    assert!(labels(&hit, &given).contains(&"α".to_owned()));
    assert!(!labels(&hit, &given).iter().any(|it| it.contains('=')));
}

#[test]
fn what_stands_still_and_what_misses_is_said() {
    let piece = Disc::from_g_mm(15.0, 15.0);
    let shown = Shown {
        angle: true,
        numbers: true,
        speeds: true,
        after: After::Departures,
        ..Shown::default()
    };
    let head_on = Collision::at_offset(piece, piece, dvec2(4.0, 0.0), 0.0);
    let found = labels(&head_on, &shown);
    assert!(
        found.contains(&"v₁ = 0: it stands still".to_owned()),
        "{found:?}"
    );
    let miss = Collision::at_offset(piece, piece, dvec2(4.0, 0.0), 0.04);
    assert!(!labels(&miss, &shown).iter().any(|it| it.contains('α')));
    assert!(hit_picture(&miss, &shown).words().contains("passes"));
}
