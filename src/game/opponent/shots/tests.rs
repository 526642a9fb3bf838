//! Tests of the closed forms against the engine.

use glam::DVec2;

use super::super::sight::Sight;
use super::*;
use crate::game::{Coin, Piece, PieceSet};
use crate::physics::{Board, DiscState, EventKind, Limits, Motion, Shot, play};

const SETS: [PieceSet; 2] = [PieceSet::Tournament, PieceSet::EqualMass];
/// Upper right.
const CORNER: usize = 3;

fn coin(x: f64, y: f64) -> Coin {
    Coin {
        piece: Piece::White,
        at: DVec2::new(x, y),
    }
}

fn sight<'a>(board: &'a Board, set: PieceSet, coins: &'a [Coin]) -> Sight<'a> {
    Sight {
        board: *board,
        set,
        coins,
    }
}

fn clear(
    sight: &Sight,
    aims: impl Iterator<Item = Unchecked<ProposedStroke>>,
) -> Vec<ProposedStroke> {
    aims.filter_map(|aim| aim.if_clear(sight)).collect()
}

fn shoot(sight: &Sight, striker: Motion) -> Shot {
    let mut discs = vec![sight.set.disc(Piece::Striker)];
    let mut motions = vec![striker];
    for coin in sight.coins {
        discs.push(sight.set.disc(coin.piece));
        motions.push(Motion::at_rest(coin.at));
    }
    play(&sight.board, &discs, &motions, Limits::default()).unwrap()
}

/// The line of impact from disc `a` to disc `b` when they first meet.
fn line_of_impact(shot: &Shot, a: usize, b: usize) -> DVec2 {
    let found = shot.events().iter().find_map(|event| match event.kind {
        EventKind::Impact { discs, normal, .. } if discs == [a, b] => Some(normal),
        EventKind::Impact { discs, normal, .. } if discs == [b, a] => Some(-normal),
        _ => None,
    });
    found.unwrap()
}

fn falls(shot: &Shot, disc: usize) -> bool {
    shot.at(disc, shot.duration()).state == DiscState::Pocketed
}

fn fell_into(shot: &Shot, disc: usize) -> Option<usize> {
    shot.events().iter().find_map(|event| match event.kind {
        EventKind::Pocket { disc: d, corner } if d == disc => Some(corner),
        _ => None,
    })
}

fn cushions_of(shot: &Shot, disc: usize) -> usize {
    let met = |kind| matches!(kind, EventKind::Cushion { disc: d, .. } if d == disc);
    shot.events().iter().filter(|e| met(e.kind)).count()
}

fn into_the_corner(sight: &Sight, coin: usize) -> PocketPath {
    let pocket = sight.board.pockets().nth(CORNER).unwrap();
    let at = sight.coins[coin].at;
    straight(sight, coin)
        .find(|course| course.toward.dot(pocket - at) > 0.999 * pocket.distance(at))
        .unwrap()
}

#[test]
fn straight_shots_and_cuts_aim_at_the_ghost() {
    let board = Board::default();
    let coins = [coin(0.1, 0.1)];
    for set in SETS {
        let sight = sight(&board, set, &coins);
        let course = into_the_corner(&sight, 0);
        let diagonal = DVec2::splat(0.5_f64.sqrt());
        assert!((course.toward - diagonal).length() < 1e-15);

        let reach = set.striker_radius() + set.coin_radius();
        let ghost = ghost(&sight, &course).unwrap();
        assert!((ghost - (coins[0].at - diagonal * reach)).length() < 1e-15);

        for turn_deg in [0.0_f64, 31.0, -50.0] {
            let way = DVec2::from_angle(turn_deg.to_radians()).rotate(diagonal);
            let places = [ghost - way * 0.25];
            let aim = clear(&sight, strikes(&sight, &course, &places))[0];
            assert!((aim.toward - way).length() < 1e-14);
            let shot = shoot(&sight, aim.motion(1.3));
            assert!((line_of_impact(&shot, 0, 1) - diagonal).length() < 1e-9);
            assert_eq!(fell_into(&shot, 1), Some(CORNER));
        }
    }
}

#[test]
fn the_speed_is_just_sufficient() {
    let board = Board::default();
    let coins = [coin(0.05, 0.12)];
    for set in SETS {
        let sight = sight(&board, set, &coins);
        let course = into_the_corner(&sight, 0);
        let places = [DVec2::new(-0.05, -0.25), DVec2::new(0.0, -0.25)];
        let aims = clear(&sight, strikes(&sight, &course, &places));
        assert_eq!(aims.len(), 2);
        for aim in aims {
            assert!(!falls(&shoot(&sight, aim.motion(1.0 - 1e-6)), 1));
            assert!(falls(&shoot(&sight, aim.motion(1.0 + 1e-6)), 1));
        }
    }
}

#[test]
fn the_allowance_is_the_tolerance_of_the_pocket() {
    let board = Board::default();
    // The coin moves along the right cushion, so a turn to the left leads past the edge of the
    // pocket. For a straight shot the first-order approximation is correct to within 5 %, and a
    // striker of the same mass does not follow the coin.
    let far = board.side / 2.0 - board.pocket_diameter / 2.0;
    let coins = [coin(far, -0.25)];
    let sight = sight(&board, PieceSet::EqualMass, &coins);
    let course = into_the_corner(&sight, 0);
    let places = [DVec2::new(far, -0.31)];
    let aim = clear(&sight, strikes(&sight, &course, &places))[0];
    let lands_in = |share: f64| {
        let meant = aim.motion(1.1);
        // A striker that is too far to the right sends the coin to the left.
        let turn = DVec2::from_angle(-share * aim.allowance);
        let turned = Motion {
            velocity: turn.rotate(meant.velocity),
            ..meant
        };
        fell_into(&shoot(&sight, turned), 1)
    };
    assert_eq!(lands_in(0.95), Some(CORNER));
    assert_eq!(lands_in(1.05), None);
}

#[test]
fn a_coin_comes_off_a_cushion_into_its_pocket() {
    let coins = [coin(-0.05, -0.1)];
    for cushion_restitution in [1.0, 0.8, 0.5] {
        let board = Board {
            cushion_restitution,
            ..Board::default()
        };
        let sight = sight(&board, PieceSet::Tournament, &coins);
        let courses: Vec<PocketPath> = off_a_cushion(&sight, 0).collect();
        assert_eq!(courses.len(), 8, "four walls, two pockets each");
        let mut tried = 0;
        for course in courses {
            let places = [coins[0].at - course.toward * 0.1];
            for aim in clear(&sight, strikes(&sight, &course, &places)) {
                // The stroke is only just fast enough for the coin to fall, so the striker does not
                // interfere.
                let shot = shoot(&sight, aim.motion(1.0 + 1e-6));
                assert!(falls(&shot, 1), "{course:?}");
                assert_eq!(cushions_of(&shot, 1), 1);
                assert!(!falls(&shoot(&sight, aim.motion(1.0 - 1e-6)), 1));
                tried += 1;
            }
        }
        assert_eq!(tried, 8);
    }
}

#[test]
fn the_striker_comes_off_a_cushion_to_its_ghost() {
    let board = Board::default();
    let coins = [coin(0.1, -0.05)];
    let sight = sight(&board, PieceSet::Tournament, &coins);
    let course = into_the_corner(&sight, 0);
    let places = [DVec2::new(0.0, -0.25), DVec2::new(-0.15, -0.25)];
    let aims = clear(&sight, kicks(&sight, &course, &places));
    assert!(aims.len() >= 2);
    for aim in aims {
        let shot = shoot(&sight, aim.motion(1.0 + 1e-6));
        assert!((line_of_impact(&shot, 0, 1) - course.toward).length() < 1e-9);
        assert_eq!(fell_into(&shot, 1), Some(CORNER));
        assert_eq!(cushions_of(&shot, 1), 0);
        assert!(!falls(&shoot(&sight, aim.motion(1.0 - 1e-6)), 1));
    }
}

#[test]
fn one_coin_drives_another() {
    let board = Board::default();
    let coins = [coin(0.15, 0.15), coin(0.08, 0.06)];
    for set in SETS {
        let sight = sight(&board, set, &coins);
        let last = into_the_corner(&sight, 0);
        let course = combinations(&sight, &last).next().unwrap();
        assert_eq!(course.coin, 1);
        let places = [coins[1].at - course.toward * 0.15];
        let aim = clear(&sight, strikes(&sight, &course, &places))[0];
        let shot = shoot(&sight, aim.motion(1.0 + 1e-6));
        assert!((line_of_impact(&shot, 0, 2) - course.toward).length() < 1e-9);
        assert!((line_of_impact(&shot, 2, 1) - last.toward).length() < 1e-9);
        assert_eq!(fell_into(&shot, 1), Some(CORNER));
        assert!(!falls(&shoot(&sight, aim.motion(1.0 - 1e-6)), 1));
    }
}

#[test]
fn a_coin_in_the_way_blocks_a_path() {
    let board = Board::default();
    let open = [coin(0.1, 0.1)];
    let set = PieceSet::Tournament;
    let pockets = |coins: &[Coin]| straight(&sight(&board, set, coins), 0).count();
    assert_eq!(pockets(&open), 4);
    let barred = [open[0], coin(0.2, 0.215)];
    assert_eq!(pockets(&barred), 3);
    // The path is free if the coin is slightly more than two radii away from it.
    let beside = DVec2::splat(0.2) + DVec2::new(0.5, -0.5).normalize() * 0.0319;
    assert_eq!(pockets(&[open[0], coin(beside.x, beside.y)]), 4);
}

#[test]
fn a_ghost_in_the_frame_and_a_hit_from_the_wrong_side_are_rejected() {
    let board = Board::default();
    let coins = [coin(-0.354, 0.1), coin(0.1, 0.1)];
    let sight = sight(&board, PieceSet::Tournament, &coins);
    let upper_right = into_the_corner(&sight, 0);
    assert_eq!(ghost(&sight, &upper_right), None);

    let cut = into_the_corner(&sight, 1);
    let behind = [DVec2::new(0.0, -0.25)];
    let ahead = [DVec2::new(0.25, 0.2)];
    assert_eq!(strikes(&sight, &cut, &behind).count(), 1);
    assert_eq!(strikes(&sight, &cut, &ahead).count(), 0);
}
