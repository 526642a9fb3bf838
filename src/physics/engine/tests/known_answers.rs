//! Shots whose outcome is known in closed form.

use glam::DVec2;

use super::tables::{COIN, STRIKER, Table, assert_close, assert_near, closed_board, rack};
use crate::physics::slide::stopping_time;
use crate::physics::{
    Board, Disc, DiscState, Engine, EngineError, EventKind, Limits, Motion, Shot, play,
    stopping_distance,
};

fn impacts(shot: &Shot) -> Vec<[usize; 2]> {
    let pair = |kind| match kind {
        EventKind::Impact { discs, .. } => Some(discs),
        _ => None,
    };
    shot.events().iter().filter_map(|e| pair(e.kind)).collect()
}

/// The time in seconds in which a disc covers `distance` metres, which is the smaller root of s = v
/// t − ½ a t².
fn time_to_cover(distance: f64, speed: f64, deceleration: f64) -> Option<f64> {
    let left = speed_after(distance, speed, deceleration)?;
    Some(2.0 * distance / (speed + left))
}

/// The speed after `distance` metres, √(v² − 2as).
fn speed_after(distance: f64, speed: f64, deceleration: f64) -> Option<f64> {
    let left = speed * speed - 2.0 * deceleration * distance;
    (left >= 0.0).then(|| left.sqrt())
}

#[test]
fn one_disc_stops_at_the_predicted_distance() {
    let board = closed_board();
    let a = board.deceleration();
    let shot = Table::default()
        .with(COIN, (-0.3, 0.1), (0.6, -0.8))
        .play(&Board { side: 2.0, ..board });
    let end = shot.at(0, shot.duration());
    let way = stopping_distance(1.0, a);
    assert_close(shot.duration(), stopping_time(1.0, a), 1e-15);
    let place = DVec2::new(-0.3 + 0.6 * way, 0.1 - 0.8 * way);
    assert_near(end.position, place, 1e-15);
    assert_eq!(end.state, DiscState::Resting);
    assert_eq!(shot.events().len(), 1);
    assert_eq!(shot.events()[0].kind, EventKind::Rest { disc: 0 });
}

#[test]
fn one_disc_hits_the_cushion_and_comes_back() {
    let board = closed_board();
    let a = board.deceleration();
    let shot = Table::default()
        .with(COIN, (0.1, 0.0), (1.5, 0.0))
        .play(&board);
    let to_wall = 0.37 - COIN.radius - 0.1;
    let hit = shot.events()[0];
    let expected = time_to_cover(to_wall, 1.5, a).expect("the disc gets there");
    assert_close(hit.time, expected, 1e-15);
    let arrives = speed_after(to_wall, 1.5, a).expect("the disc gets there");
    let EventKind::Cushion {
        before,
        after,
        normal,
        ..
    } = hit.kind
    else {
        panic!("{hit:?}");
    };
    assert_eq!(normal, DVec2::X);
    assert_near(before, DVec2::new(arrives, 0.0), 1e-15);
    assert_near(after, DVec2::new(-0.8 * arrives, 0.0), 1e-15);
    let back = stopping_distance(0.8 * arrives, a);
    let end = shot.at(0, shot.duration()).position;
    assert_near(end, DVec2::new(0.37 - COIN.radius - back, 0.0), 1e-15);
}

#[test]
fn one_disc_falls_into_a_pocket() {
    let board = Board::default();
    let shot = Table::default()
        .with(COIN, (0.0, 0.0), (-2.0, 2.0))
        .play(&board);
    // The centre of the pocket is one radius away from both sides; the disc falls when its centre
    // reaches the edge of the pocket.
    let hole = 0.5 * board.pocket_diameter;
    let way = (0.37 - hole) * 2_f64.sqrt() - hole;
    let speed = 8_f64.sqrt();
    let time = time_to_cover(way, speed, board.deceleration()).expect("the disc gets there");
    assert_eq!(shot.events().len(), 1);
    assert_close(shot.events()[0].time, time, 1e-15);
    let fall = EventKind::Pocket { disc: 0, corner: 2 };
    assert_eq!(shot.events()[0].kind, fall);
    assert_eq!(shot.at(0, 9.0).state, DiscState::Pocketed);
    assert_near(
        shot.at(0, 9.0).position,
        DVec2::new(-way, way) / 2_f64.sqrt(),
        1e-15,
    );
}

#[test]
fn two_discs_with_friction_meet_as_the_closed_form_predicts() {
    let board = closed_board();
    let a = board.deceleration();
    for degrees in [0.0, 10.0, 30.0, 45.0, 60.0, 80.0, 89.0_f64] {
        let alpha = degrees.to_radians();
        let reach = STRIKER.radius + COIN.radius;
        let b = reach * alpha.sin();
        let shot = Table::default()
            .with(STRIKER, (-0.2, 0.0), (2.0, 0.0))
            .with(COIN, (0.05, -b), (0.0, 0.0))
            .play(&board);
        let way = 0.25 - reach * alpha.cos();
        let time = time_to_cover(way, 2.0, a).expect("the disc gets there");
        let hit = shot.events()[0];
        assert_close(hit.time, time, 1e-14);
        assert_near(
            shot.at(0, hit.time).position,
            DVec2::new(way - 0.2, 0.0),
            1e-14,
        );
        // The discs leave as predicted by the closed forms for a target at rest.
        let speed = speed_after(way, 2.0, a).expect("the disc gets there");
        let EventKind::Impact {
            discs,
            normal,
            after,
            ..
        } = hit.kind
        else {
            panic!("{hit:?}");
        };
        assert_eq!(discs, [0, 1]);
        assert_near(normal, DVec2::new(alpha.cos(), -alpha.sin()), 1e-12);
        let k = 2.0 * 5.5 / 20.5;
        let across = k * alpha.sin() * alpha.cos();
        let along = 1.0 - k * alpha.cos() * alpha.cos();
        assert_near(after[0], DVec2::new(along, across) * speed, 1e-12);
        let coin = normal * (speed * 2.0 * 15.0 / 20.5 * alpha.cos());
        assert_near(after[1], coin, 1e-12);
    }
}

#[test]
fn two_sliding_discs_meet_at_the_predicted_time() {
    // The discs move at right angles to each other with equal speeds. Their centres are at (−x, 0)
    // and (0, −x), so they are √2 x apart and meet at x = R/√2, where R is the sum of their radii,
    // after sliding through the same distance.
    let board = closed_board();
    let shot = Table::default()
        .with(COIN, (-0.2, 0.0), (1.7, 0.0))
        .with(COIN, (0.0, -0.2), (0.0, 1.7))
        .play(&board);
    let way = 0.2 - 2.0 * COIN.radius / 2_f64.sqrt();
    let time = time_to_cover(way, 1.7, board.deceleration()).expect("the disc gets there");
    assert_close(shot.events()[0].time, time, 1e-14);
    assert_near(shot.at(0, time).position, DVec2::new(way - 0.2, 0.0), 1e-14);
    assert_near(shot.at(1, time).position, DVec2::new(0.0, way - 0.2), 1e-14);
}

#[test]
fn a_row_of_equal_discs_passes_the_motion_on() {
    // At e = 1, as many discs leave the row as arrive (one, two or three), whether the discs touch
    // or have gaps between them.
    let board = Board {
        friction: 0.0,
        ..Board::open(1.0)
    };
    for gap in [0.0, 1e-4] {
        for moving in 1..=3 {
            let mut table = Table::default();
            for i in 0..6_u32 {
                let x = f64::from(i) * (2.0 * COIN.radius + gap);
                let comes = i < moving;
                let back = if comes { -0.05 } else { 0.0 };
                table = table.with(COIN, (x + back, 0.0), (if comes { 1.0 } else { 0.0 }, 0.0));
            }
            let shot = table.play(&board);
            for (i, end) in shot.final_states().enumerate() {
                let goes = i >= 6 - moving as usize;
                let expected = if goes { DVec2::X } else { DVec2::ZERO };
                assert_near(end.velocity, expected, 1e-15);
            }
            assert_eq!(impacts(&shot).len(), (moving * (6 - moving)) as usize);
        }
    }
}

#[test]
fn two_discs_sliding_side_by_side_do_not_disturb_each_other() {
    let board = closed_board();
    let apart = 2.0 * COIN.radius;
    for turn in [0.0, 0.3, 1.0, 2.5_f64] {
        let direction = DVec2::new(turn.cos(), turn.sin());
        let place = direction.perp() * apart;
        for other in [place, direction * apart] {
            let shot = Table::default()
                .with(COIN, (0.0, 0.0), (0.5 * direction).into())
                .with(COIN, other.into(), (0.5 * direction).into())
                .play(&board);
            assert_eq!(impacts(&shot), Vec::<[usize; 2]>::new());
            let way = direction * stopping_distance(0.5, board.deceleration());
            assert_near(shot.at(0, 9.0).position, way, 1e-15);
            assert_near(shot.at(1, 9.0).position, other + way, 1e-15);
        }
    }
}

#[test]
fn a_pair_pressed_together_while_it_slides_stays_apart_and_comes_to_rest() {
    // Two touching discs have the same velocity component along the line of centres. The front disc
    // is slower overall, so friction reduces its component faster, and the rear disc is pressed
    // against it. The result is a lasting, sliding contact.
    let board = closed_board();
    let reach = 2.0 * COIN.radius;
    let shot = Table::default()
        .with(COIN, (0.0, 0.0), (0.10, 0.06))
        .with(COIN, (reach, 0.0), (0.10, 0.02))
        .play(&board);
    assert!(!impacts(&shot).is_empty());
    assert!(shot.events().len() < 20_000, "{}", shot.events().len());
    let mut time = 0.0;
    while time < shot.duration() {
        let apart = shot
            .at(0, time)
            .position
            .distance(shot.at(1, time).position);
        assert!(apart > reach - 1e-9, "{} at {time}", reach - apart);
        time += 1e-5;
    }
}

#[test]
fn a_gap_of_1e_19_m_is_closed() {
    // The discs are so small that an `f64` can represent a gap of this size.
    let small = Disc {
        mass: 1e-6,
        radius: 5e-5,
    };
    for friction in [0.0, 0.12] {
        let board = Board {
            friction,
            ..Board::open(1.0)
        };
        for gap in [0.0, 1e-19, 3e-19, 1e-17, 1e-13, 1e-12] {
            for across in [0.0, 0.4] {
                let table = Table::default()
                    .with(small, (0.0, 0.0), (0.3, across))
                    .with(small, (1e-4 + gap, 0.0), (0.0, 0.0));
                let shot = table.play(&board);
                assert_eq!(impacts(&shot), [[0, 1]]);
                assert!(shot.events()[0].time <= gap / 0.3 * 1.001, "{gap}");
                let both = Table::default()
                    .with(small, (0.0, 0.0), (0.3, across))
                    .with(small, (1e-4 + gap, 0.0), (-0.2, 0.1));
                let shot = both.play(&board);
                assert_eq!(impacts(&shot), [[0, 1]]);
                assert!(shot.events()[0].time <= gap / 0.5 * 1.001, "{gap}");
            }
        }
    }
}

#[test]
fn touching_discs_that_move_apart_do_not_meet() {
    let board = closed_board();
    let reach = 2.0 * COIN.radius;
    let shot = Table::default()
        .with(COIN, (0.0, 0.0), (-0.3, 0.2))
        .with(COIN, (reach, 0.0), (0.3, 0.2))
        .play(&board);
    assert_eq!(impacts(&shot), Vec::<[usize; 2]>::new());
}

#[test]
fn a_symmetric_break_stays_symmetric() {
    for gap in [0.0, 1e-4] {
        let table = rack(gap, (0.0, 4.0));
        let shot = table.play(&closed_board());
        let mirror: Vec<usize> = table
            .start
            .iter()
            .map(|m| {
                let image = DVec2::new(-m.position.x, m.position.y);
                let at = |n: &Motion| n.position.distance(image) < 1e-12;
                table.start.iter().position(at).expect("a mirror image")
            })
            .collect();
        let mut worst = 0.0_f64;
        for step in 0..=1000 {
            let time = shot.duration() * f64::from(step) / 1000.0;
            for (i, &j) in mirror.iter().enumerate() {
                let (a, b) = (shot.at(i, time).position, shot.at(j, time).position);
                worst = worst.max(DVec2::new(-a.x, a.y).distance(b));
            }
        }
        assert!(
            worst <= 1e-9,
            "gap {gap}: {worst} m, {} events",
            shot.events().len()
        );
    }
}

#[test]
fn an_impossible_shot_is_refused_with_a_reason() {
    let says = |board: &Board, table: &Table, limits: Limits| {
        play(board, &table.discs, &table.start, limits)
            .expect_err("the input is unusable")
            .to_string()
    };
    let limits = Limits::default();
    let board = Board::default();
    let good = Table::default().with(COIN, (0.0, 0.0), (1.0, 0.0));
    let heavy = Disc {
        mass: f64::NAN,
        ..COIN
    };
    let bad = good.clone().with(heavy, (0.1, 0.0), (0.0, 0.0));
    assert_eq!(
        says(&board, &bad, limits),
        "disc 1: the mass must be finite and greater than 0"
    );
    let off = good.clone().with(COIN, (0.36, 0.0), (0.0, 0.0));
    assert!(says(&board, &off, limits).starts_with("disc 1 reaches 5.9"));
    let over = good.clone().with(COIN, (0.03, 0.0), (0.0, 0.0));
    assert!(says(&board, &over, limits).starts_with("discs 0 and 1 overlap by 1.8"));
    let ice = Board {
        friction: 0.0,
        ..board
    };
    assert!(says(&ice, &good, limits).contains("horizon"));
    let few = Limits {
        events: 0,
        ..limits
    };
    assert!(says(&board, &good, few).starts_with("more than 0 events"));
}

/// In a touching pack whose masses differ by a factor of 1000, nearly all the work is needed to
/// find the impulses of simultaneous contacts. The record keeps the part of the shot that was
/// played before the limit was reached.
#[test]
fn a_shot_that_takes_too_much_work_stops_and_keeps_its_record() {
    let mut table = rack(0.0, (0.3, 4.0));
    for (i, disc) in table.discs.iter_mut().enumerate() {
        disc.mass = if i % 3 == 0 { 1e-5 } else { 1e-2 };
    }
    let board = closed_board();
    let whole = table.play(&board);
    let mut engine = Engine::default();
    let mut shot = Shot::default();
    for work in [0, 100, 3_000, 30_000, 300_000] {
        let limits = Limits {
            work,
            ..Limits::default()
        };
        let (discs, start) = (&table.discs, &table.start);
        let given_up = engine.play_into(&mut shot, &board, discs, start, limits);
        let Err(EngineError::TooMuchWork { time, .. }) = given_up else {
            panic!("{work} tests: {given_up:?}");
        };
        let played = shot.events();
        assert!(whole.events().starts_with(played), "{work}");
        assert!(played.iter().all(|event| event.time <= time));
    }
}
