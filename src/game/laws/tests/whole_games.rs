//! Plays whole games of random strokes and checks that the state of the game stays valid.

use glam::DVec2;
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::laying::put_back;
use super::validity::flaw;
use crate::game::laws::{Rules, Ruling};
use crate::game::pieces::{Coin, Piece, count};
use crate::game::seat::{Hands, Seat};
use crate::game::stroke::Stroke;
use crate::game::table::{Game, GameSetup, GameStage};
use crate::physics::{Board, Engine, Limits, Motion, Shot};

/// A random stroke. Nine strokes in ten touch a piece: each coin is then pocketed with the
/// probability `luck`, and the others end at random positions.
fn random_stroke(game: &Game, luck: f64, hand: &mut Pcg64) -> Stroke {
    let touched = hand.random_bool(0.9);
    let mut spots: Vec<DVec2> = (0..256_i32)
        .map(|i| DVec2::new(f64::from(i % 16), f64::from(i / 16)) * 0.04 - 0.3)
        .collect();
    let mut pocketed = Vec::new();
    let mut left: Vec<Coin> = Vec::new();
    for coin in game.coins() {
        if touched && hand.random_bool(luck) {
            pocketed.push(coin.piece);
        } else if touched {
            let at = spots.swap_remove(hand.random_range(0..spots.len()));
            left.push(Coin { at, ..*coin });
        } else {
            left.push(*coin);
        }
    }
    if hand.random_bool(0.15) {
        pocketed.push(Piece::Striker);
    }
    Stroke {
        touched,
        pocketed,
        left,
    }
}

/// Plays until the match (in a tournament) or the board (with other rules) is over, and checks the
/// game after every stroke.
fn play_out(setup: GameSetup, luck: f64, seed: u64) -> (Game, Vec<Ruling>) {
    let mut hand = Pcg64::seed_from_u64(seed);
    let mut game = Game::new(setup);
    let mut announced = Vec::new();
    for _ in 0..100_000 {
        let before = game.clone();
        let stroke = random_stroke(&game, luck, &mut hand);
        let rulings = game.apply(&stroke).unwrap();
        let back = put_back(&rulings);
        for piece in [Piece::White, Piece::Black, Piece::Queen] {
            let returned = back.iter().filter(|p| **p == piece).count();
            assert_eq!(
                usize::from(count(game.coins(), piece) + stroke.fallen(piece)),
                usize::from(count(before.coins(), piece)) + returned
            );
        }
        assert_eq!(flaw(&game), None);
        assert!(!rulings.is_empty() && rulings.iter().all(|r| r.text.ends_with('.')));
        assert_eq!(
            rulings.iter().all(|r| r.law.is_none()),
            setup.rules != Rules::Tournament
        );
        announced.extend(rulings);
        if game.play().won.is_some() {
            match game.stage() {
                GameStage::BoardOver(_) if setup.rules == Rules::Tournament => {
                    game.next_board().unwrap();
                }
                GameStage::GameOver(_) if setup.rules == Rules::Tournament => {
                    game.next_board().unwrap();
                }
                _ => return (game, announced),
            }
        }
    }
    panic!("the game never ended");
}

fn setups() -> impl Strategy<Value = GameSetup> {
    let rules = prop_oneof![
        4 => Just(Rules::Tournament),
        1 => Just(Rules::Friendly),
        2 => Just(Rules::Points),
        1 => Just(Rules::Practice)
    ];
    let hands = prop_oneof![Just(Hands::Two), Just(Hands::Four)];
    (rules, hands, 0..4_usize, any::<Option<u64>>()).prop_map(|(rules, hands, seat, seed)| {
        GameSetup {
            rules,
            hands,
            first_breaker: Seat::ALL[seat],
            seed,
            ..GameSetup::default()
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn random_strokes_leave_a_valid_game_and_every_match_ends(
        setup in setups(),
        luck in 0.05..0.6_f64,
        seed in any::<u64>(),
    ) {
        let (game, announced) = play_out(setup, luck, seed);
        let (again, announced_again) = play_out(setup, luck, seed);
        prop_assert_eq!(&game, &again);
        prop_assert_eq!(announced, announced_again);
    }
}

/// Tests the rules together with the engine, on boards played with random strokes of 1 to 5 m/s
/// from legal positions.
#[test]
fn boards_played_with_the_engine_stay_valid_and_end() {
    let board = Board::default();
    let mut engine = Engine::default();
    let mut shot = Shot::default();
    for seed in 0..4_u64 {
        let mut hand = Pcg64::seed_from_u64(seed);
        let mut game = Game::new(GameSetup {
            hands: if seed % 2 == 0 {
                Hands::Two
            } else {
                Hands::Four
            },
            seed: Some(seed),
            ..GameSetup::default()
        });
        for _ in 0..20_000 {
            let lines = game.base_lines();
            let wanted = lines.at(hand.random_range(-0.2..0.2));
            let rulings = if let Some(position) = lines.nearest(wanted) {
                let way = DVec2::from_angle(hand.random_range(0.0..std::f64::consts::PI));
                let velocity = game.seat().turn(way) * hand.random_range(1.0..5.0);
                let (discs, motions) = game.discs(Motion { position, velocity });
                engine
                    .play_into(&mut shot, &board, &discs, &motions, Limits::default())
                    .unwrap();
                let stroke = Stroke::from_shot(game.coins(), &shot).unwrap();
                game.apply(&stroke).unwrap()
            } else {
                game.no_place().unwrap()
            };
            assert!(!rulings.is_empty());
            assert_eq!(flaw(&game), None);
            if game.play().won.is_some() {
                break;
            }
        }
        assert!(game.play().won.is_some(), "seed {seed}");
    }
}
