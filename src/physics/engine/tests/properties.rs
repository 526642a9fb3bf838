//! Properties that hold for any table.

use glam::DVec2;
use proptest::prelude::*;

use super::tables::{Table, rack};
use crate::physics::{Board, Disc, DiscState, EventKind, Limits, Motion, Shot, play};

/// The maximum permitted overlap of a disc with another disc or with the frame, in metres.
const DEEPEST: f64 = 1e-9;

fn a_disc() -> impl Strategy<Value = (Disc, Motion)> {
    let place = (-0.33..0.33, -0.33..0.33);
    let way = (0.0..std::f64::consts::TAU, prop_oneof![Just(0.0), 0.0..4.0]);
    (0.5..50.0, 8.0..25.0, place, way).prop_map(|(mass_g, radius_mm, (x, y), (angle, speed))| {
        let start = Motion {
            position: DVec2::new(x, y),
            velocity: DVec2::from_angle(angle) * speed,
        };
        (Disc::from_g_mm(mass_g, radius_mm), start)
    })
}

/// A table with two to twenty discs, from which any disc that would overlap an earlier disc has
/// been removed.
fn a_table() -> impl Strategy<Value = Table> {
    prop::collection::vec(a_disc(), 2..=20).prop_map(|all| {
        let mut table = Table::default();
        for (disc, start) in all {
            let free = table.discs.iter().zip(&table.start).all(|(other, at)| {
                at.position.distance(start.position) > other.radius + disc.radius
            });
            if free {
                table.discs.push(disc);
                table.start.push(start);
            }
        }
        table
    })
}

fn a_board() -> impl Strategy<Value = Board> {
    let e = || prop_oneof![Just(1.0), Just(0.0), 0.0..1.0];
    let pockets = prop_oneof![Just(0.0), Just(0.0445)];
    (pockets, 0.02..0.5, e(), e()).prop_map(
        |(pocket_diameter, friction, restitution, cushion_restitution)| Board {
            pocket_diameter,
            friction,
            restitution,
            cushion_restitution,
            ..Board::default()
        },
    )
}

/// The times to be checked: those of all events, and evenly spaced times throughout the shot.
fn times(shot: &Shot) -> Vec<f64> {
    let mut times: Vec<f64> = shot.events().iter().map(|event| event.time).collect();
    times.extend((0..=300).map(|i| shot.duration() * f64::from(i) / 300.0));
    times.sort_by(f64::total_cmp);
    times
}

fn assert_apart(shot: &Shot) {
    let radii = || shot.discs().iter().map(|disc| disc.radius);
    let longest_reach = 2.0 * radii().fold(0.0, f64::max);
    for time in times(shot) {
        let now = radii().enumerate().map(|(i, r)| (i, r, shot.at(i, time)));
        let mut now: Vec<_> = now
            .filter(|(.., it)| it.state != DiscState::Pocketed)
            .map(|(i, r, it)| (i, r, it.position))
            .collect();
        assert!(now.iter().all(|(.., it)| it.is_finite()), "{now:?}");
        now.sort_by(|(.., a), (.., b)| a.x.total_cmp(&b.x));
        for (k, &(j, r, b)) in now.iter().enumerate() {
            let near = now[..k].iter().rev();
            for &(i, other, a) in near.take_while(|(.., a)| b.x - a.x <= longest_reach) {
                let overlap = r + other - a.distance(b);
                assert!(overlap <= DEEPEST, "{i} and {j}: {overlap} m at {time} s");
            }
        }
    }
}

fn assert_on_the_board(shot: &Shot) {
    for time in times(shot) {
        for (i, disc) in shot.discs().iter().enumerate() {
            let reach = shot.at(i, time).position.abs().max_element() + disc.radius;
            let beyond = reach - 0.5 * shot.board().side;
            assert!(beyond <= DEEPEST, "disc {i} is {beyond} m beyond the frame");
        }
    }
}

fn assert_balanced(shot: &Shot) {
    // Simultaneous contacts exchange energy, so it is checked for all of them together.
    let mut gained = 0.0;
    let mut since = f64::NAN;
    for event in shot.events() {
        if let EventKind::Impact {
            discs,
            normal,
            before,
            after,
        } = event.kind
        {
            let [m1, m2] = discs.map(|i| shot.discs()[i].mass);
            let momentum = |v: [DVec2; 2]| m1 * v[0] + m2 * v[1];
            let energy = |v: [DVec2; 2]| m1 * v[0].length_squared() + m2 * v[1].length_squared();
            let scale = m1 * before[0].length() + m2 * before[1].length();
            let lost = momentum(before).distance(momentum(after));
            assert!(lost <= 1e-14 * scale, "{lost} of {scale} kg m/s");
            if event.time > since || since.is_nan() {
                assert!(gained <= 1e-13 * shot.energy_before(), "{event:?}");
                (gained, since) = (0.0, event.time);
            }
            gained += 0.5 * (energy(after) - energy(before));
            // The discs are smooth, so the perpendicular components do not change.
            for (u, v) in before.into_iter().zip(after) {
                let across = (v - u).perp_dot(normal).abs();
                assert!(across <= 1e-14 * (u.length() + v.length()));
            }
        }
    }
    assert!(gained <= 1e-13 * shot.energy_before(), "{gained} J");
    let mut energy = shot.energy_before();
    let slack = 1e-13 * energy;
    for time in times(shot) {
        let now = shot.energy_at(time);
        assert!(
            now <= energy + slack,
            "{energy} J, then {now} J at {time} s"
        );
        energy = now;
    }
}

fn assert_sound(table: &Table, board: &Board) {
    let shot = play(board, &table.discs, &table.start, Limits::default());
    let shot = shot.unwrap_or_else(|error| panic!("{error}: {table:?} {board:?}"));
    assert!(shot.duration().is_finite());
    assert!(shot.events().is_sorted_by(|a, b| a.time <= b.time));
    // The shot ends with its last event, even if a forecast made for a later time was outdated.
    let last = shot.events().last().map_or(0.0, |event| event.time);
    assert_eq!(shot.duration(), last);
    assert!(
        shot.final_states()
            .all(|end| end.state != DiscState::Moving)
    );
    assert_apart(&shot);
    assert_on_the_board(&shot);
    assert_balanced(&shot);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_table_obeys_the_laws_to_its_end((table, board) in (a_table(), a_board())) {
        assert_sound(&table, &board);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn any_break_obeys_the_laws(
        (board, gap) in (a_board(), prop_oneof![Just(0.0), Just(1e-19), Just(1e-12), 0.0..1e-3]),
        (across, speed) in (-0.6..0.6, 0.1..6.0),
    ) {
        assert_sound(&rack(gap, (across * speed, speed)), &board);
    }
}

/// Packs whose discs stay together, press against each other and come to rest one by one are the
/// hardest case.
#[test]
fn collapsing_packs_obey_the_laws() {
    for (gap, friction, e, cushion, velocity) in [
        (7.932992e-4, 0.2206, 0.0, 1.0, (0.4178, 2.3016)),
        (0.0, 0.2213, 0.0, 1.0, (0.0, 1.2933)),
        (0.0, 0.4319, 0.0, 1.0, (0.6318, 2.4165)),
        (0.0, 0.1504, 0.0, 0.0, (-0.4804, 4.2808)),
        (0.0, 0.2278, 0.3447, 1.0, (-0.0167, 1.3150)),
    ] {
        let board = Board {
            pocket_diameter: 0.0,
            friction,
            restitution: e,
            cushion_restitution: cushion,
            ..Board::default()
        };
        assert_sound(&rack(gap, velocity), &board);
    }
}

/// The table is large enough for the grid, and every disc is moving.
#[test]
fn a_crowd_obeys_the_laws() {
    for e in [1.0, 0.6] {
        let mut table = Table::default();
        for i in 0..400 {
            let angle = f64::from(i * i) * 0.7;
            let place = (f64::from(i % 20) - 9.5, f64::from(i / 20) - 9.5);
            let radius_mm = 12.0 + f64::from(i % 7);
            let disc = Disc::from_g_mm(3.0 + f64::from(i % 5), radius_mm);
            let velocity = DVec2::from_angle(angle) * 1.5;
            table = table.with(disc, (place.0 * 0.06, place.1 * 0.06), velocity.into());
        }
        let board = Board {
            side: 1.25,
            restitution: e,
            ..Board::default()
        };
        assert_sound(&table, &board);
    }
}

/// Without friction no energy is lost at e = 1, regardless of how long the shot lasts.
#[test]
fn without_friction_energy_is_conserved() {
    let board = Board {
        friction: 0.0,
        pocket_diameter: 0.0,
        cushion_restitution: 1.0,
        ..Board::default()
    };
    let limits = Limits {
        horizon: 5.0,
        ..Limits::default()
    };
    let table = rack(1e-4, (0.5, 3.0));
    let shot = play(&board, &table.discs, &table.start, limits).expect("a playable table");
    assert!(shot.events().len() > 100, "{}", shot.events().len());
    assert!((shot.duration() - 5.0).abs() < f64::EPSILON);
    let (before, after) = (shot.energy_before(), shot.energy_after());
    assert!((after / before - 1.0).abs() < 1e-12);
    assert_apart(&shot);
}
