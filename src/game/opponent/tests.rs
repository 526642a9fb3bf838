//! Tests of the whole opponent in various positions.

use glam::DVec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::sight::Sight;
use super::{FASTEST, PlayerHand, Strength, hint, think};
use crate::game::laws::{Rules, Taken};
use crate::game::pack::pack;
use crate::game::steps::on_steps;
use crate::game::{Coin, Game, GameSetup, Hands, Piece, PieceSet, Seat, Strike, Stroke, Team};
use crate::numbers::{FNV_START, fnv1a};
use crate::physics::{Board, Engine, Limits, Motion, Shot};

/// A board in play with some of its coins scattered anywhere on it.
fn scattered(seed: u64) -> Game {
    let mut chance = Pcg64::seed_from_u64(seed);
    let setup = GameSetup {
        rules: [Rules::Tournament, Rules::Friendly, Rules::Practice][(seed % 3) as usize],
        hands: [Hands::Two, Hands::Four][(seed / 3 % 2) as usize],
        set: [PieceSet::Tournament, PieceSet::EqualMass][(seed / 6 % 2) as usize],
        ..GameSetup::default()
    };
    let mut game = Game::new(setup);
    let reach = Board::default().side / 2.0 - setup.set.coin_radius();
    let mut coins: Vec<Coin> = Vec::new();
    for (i, coin) in pack(setup.set, Seat::South).into_iter().enumerate() {
        if i > 2 && chance.random_bool(0.4) {
            continue;
        }
        let mut anywhere = || chance.random_range(-reach..reach);
        let at = DVec2::new(anywhere(), anywhere());
        if coins.iter().all(|c| c.at.distance(at) > 0.0319) {
            coins.push(Coin { at, ..coin });
        }
    }
    game.play.coins = coins;
    game.play.break_tries = None;
    game
}

fn apply(game: &mut Game, striker: Motion) {
    let (discs, motions) = game.discs(striker);
    let mut shot = Shot::default();
    Engine::default()
        .play_into(
            &mut shot,
            &Board::default(),
            &discs,
            &motions,
            Limits::default(),
        )
        .unwrap();
    let stroke = Stroke::from_shot(game.coins(), &shot).unwrap();
    game.apply(&stroke).unwrap();
}

#[test]
fn every_decision_is_a_legal_stroke() {
    for seed in 0..60 {
        let game = scattered(seed);
        for strength in [Strength::Beginner, Strength::Club, Strength::Expert] {
            let decision = think(&game, strength, seed).unwrap();
            for motion in [decision.meant, decision.struck()] {
                assert_eq!(game.check_place(motion.position), Ok(()));
                let speed = motion.velocity.length();
                assert!(speed > 0.0 && speed <= FASTEST * (1.0 + 1e-12), "{speed}");
            }
            let said = decision.afterwards(&decision.reason.story);
            assert!(said.ends_with('.') && !said.contains("NaN"), "{said}");
            apply(&mut game.clone(), decision.struck());
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_decision_and_another_seed_a_different_one() {
    let game = scattered(1);
    for strength in Strength::ALL {
        let decide = |seed| think(&game, strength, seed).unwrap();
        assert_eq!(decide(7), decide(7));
        assert_ne!(decide(7).slip, decide(8).slip);
    }
    assert_eq!(
        hint(&game, PlayerHand::Exact, 3),
        hint(&game, PlayerHand::Exact, 3)
    );
}

#[test]
fn the_opponent_breaks_the_pack() {
    for strength in Strength::ALL {
        let mut game = Game::new(GameSetup::default());
        let decision = think(&game, strength, 2).unwrap();
        assert!(decision.reason.breaking && decision.reason.story.first_hit.is_some());
        apply(&mut game, decision.meant);
        assert!(!game.play().is_unbroken());
    }
}

#[test]
fn every_strength_sees_a_coin_in_front_of_a_pocket() {
    let mut game = scattered(0);
    game.play.coins = vec![
        coin(Piece::White, 290.0, 290.0),
        coin(Piece::Black, -100.0, 100.0),
    ];
    game.play.queen_covered_by = Some(Team::First);
    for strength in Strength::ALL {
        let decision = think(&game, strength, 4).unwrap();
        let fall = decision.reason.story.fall.unwrap();
        assert_eq!((fall.piece, fall.corner), (Piece::White, 3), "{strength}");
    }
    let hint = hint(&game, PlayerHand::Exact, 4).unwrap();
    assert_eq!(
        hint.which(),
        "Look at the white coin and the top right pocket."
    );
    apply(&mut game, hint.stroke);
    let won = game.play().won.unwrap();
    assert_eq!((won.winner, won.points), (Team::First, 4), "the hint works");
}

#[test]
fn in_points_carrom_a_coin_of_either_colour_is_seen_and_the_one_that_wins_is_chosen() {
    let mut game = Game::new(GameSetup {
        rules: Rules::Points,
        ..GameSetup::default()
    });
    game.play.break_tries = None;
    game.play.queen_covered_by = Some(Team::First);
    // With 15 points, a white coin wins.
    game.play.taken[Team::First] = Taken { white: 5, black: 0 };
    let black = coin(Piece::Black, 290.0, 290.0);
    let white = coin(Piece::White, -290.0, 290.0);
    for (coins, expected) in [
        (vec![black], Piece::Black),
        (vec![black, white], Piece::White),
    ] {
        game.play.coins = coins;
        let hint = hint(&game, PlayerHand::Exact, 4).unwrap();
        assert_eq!(hint.reason.story.fall.unwrap().piece, expected);
        for strength in Strength::ALL {
            let decision = think(&game, strength, 4).unwrap();
            let fall = decision.reason.story.fall.unwrap();
            assert_eq!(fall.piece, expected, "{strength}");
        }
    }
}

/// A hint for an unsteady hand is a stroke that tolerates the errors of this hand.
#[test]
fn a_hint_for_an_unsteady_hand_works_more_often_with_that_hand() {
    let mut fell = [0_u32; 2];
    for seed in 0..12 {
        let game = scattered(3 * seed);
        for (hand, fell) in [PlayerHand::Steady, PlayerHand::Club]
            .into_iter()
            .zip(&mut fell)
        {
            let hint = hint(&game, hand, seed).unwrap();
            assert_eq!(on_steps(hint.stroke, game.seat()), Some(hint.stroke));
            for slip in 0..40 {
                let errors = PlayerHand::Club.errors().unwrap();
                let struck = errors.slip_of(slip).applied_to(hint.stroke);
                let (discs, motions) = game.discs(struck);
                let shot = crate::physics::play(&game.board(), &discs, &motions, Limits::default())
                    .unwrap();
                let story = super::Story::of(&game, &shot);
                *fell += u32::from(story.fall.is_some());
            }
        }
    }
    assert!(fell[1] >= fell[0], "{fell:?}");
}

/// A player who sets the stroke of a hint with the keys plays exactly that stroke, without a foul.
#[test]
fn a_hint_can_be_set_and_keeps_the_striker_on_the_board() {
    let board = Board::default();
    let mut clean = 0;
    for seed in 0..12 {
        let game = scattered(seed);
        let hint = hint(&game, PlayerHand::Exact, seed).unwrap();
        let stroke = hint.stroke;
        assert_eq!(game.check_place(stroke.position), Ok(()));
        let lines = game.base_lines();
        assert_eq!(
            lines.nearest_on_steps(stroke.position),
            Some(stroke.position)
        );
        assert_eq!(on_steps(stroke, game.seat()), Some(stroke));
        let (discs, motions) = game.discs(stroke);
        let shot = crate::physics::play(&board, &discs, &motions, Limits::default()).unwrap();
        let fell = Stroke::from_shot(game.coins(), &shot).unwrap().pocketed;
        assert_eq!(fell.contains(&Piece::Striker), hint.fouls, "seed {seed}");
        assert_eq!(hint.reason.story, super::Story::of(&game, &shot));
        clean += usize::from(!hint.fouls);
    }
    assert_eq!(clean, 12);
}

#[test]
fn plans_and_hints_use_the_restitution_of_the_game() {
    let mut elastic = scattered(0);
    let setup = GameSetup {
        restitution: 0.4,
        ..elastic.setup
    };
    elastic.play.coins = vec![
        coin(Piece::White, 100.0, 100.0),
        coin(Piece::Black, -200.0, 150.0),
        coin(Piece::Queen, -100.0, 200.0),
    ];
    let lossy = Game {
        setup,
        ..elastic.clone()
    };
    for game in [&elastic, &lossy] {
        let thought = think(game, Strength::Expert, 1).unwrap();
        let hinted = hint(game, PlayerHand::Exact, 1).unwrap();
        for (stroke, story) in [
            (thought.meant, thought.reason.story),
            (hinted.stroke, hinted.reason.story),
        ] {
            let strike = Strike {
                place: stroke.position,
                velocity: stroke.velocity,
                call: None,
            };
            let shot = strike.shot(game).unwrap();
            assert_eq!(shot.board().restitution, game.setup.restitution);
            assert_eq!(story, super::Story::of(game, &shot));
        }
    }
    // A full hit gives a coin (1 + e) m₁/(m₁ + m₂) of the striker's speed, so the planned stroke
    // must be harder in the lossy game.
    let passed_on = |game| Sight::of(game).passed_on(Piece::Striker);
    let ratio = passed_on(&lossy) / passed_on(&elastic);
    assert!((ratio - 1.4 / 2.0).abs() < 1e-12, "{ratio}");
}

#[test]
fn a_hopeless_position_has_a_stroke_and_a_blocked_base_line_has_none() {
    let mut game = scattered(0);
    // The player's coin and the queen are near the far cushion, behind a row of the opponent's
    // coins.
    let row = |i: i32| coin(Piece::Black, f64::from(i) * 32.0, -180.0);
    game.play.coins = (-4..=4).map(row).collect();
    game.play.coins.push(coin(Piece::White, 0.0, 350.0));
    game.play.coins.push(coin(Piece::Queen, 32.0, 350.0));
    for strength in Strength::ALL {
        assert!(think(&game, strength, 1).is_some());
    }

    let bar = |i: i32| coin(Piece::Black, f64::from(i) * 55.0, -252.6);
    game.play.coins = (-4..=4).map(bar).collect();
    game.play.coins.push(coin(Piece::White, 0.0, 0.0));
    assert_eq!(think(&game, Strength::Champion, 1), None);
    assert_eq!(hint(&game, PlayerHand::Exact, 1), None);

    let mut empty = scattered(2);
    empty.play.coins.clear();
    assert!(
        think(&empty, Strength::Champion, 1).is_some(),
        "in a practice game a stroke may hit nothing"
    );
}

#[test]
fn a_finished_board_has_no_stroke() {
    let mut game = scattered(0);
    game.play.won = Some(crate::game::BoardWon {
        winner: Team::First,
        points: 3,
    });
    assert_eq!(think(&game, Strength::Club, 1), None);
}

#[test]
fn the_last_coin_is_not_taken_before_the_queen() {
    let mut game = scattered(0);
    game.play.coins = vec![
        coin(Piece::White, 290.0, 290.0),
        coin(Piece::Queen, -200.0, 200.0),
        coin(Piece::Black, 100.0, 0.0),
        coin(Piece::Black, -300.0, -300.0),
    ];
    game.play.pocketed_before[Team::First] = true;
    for strength in [Strength::Expert, Strength::Champion] {
        let decision = think(&game, strength, 1).unwrap();
        assert_eq!(decision.reason.story.fall.unwrap().piece, Piece::Queen);
    }
}

/// A hash of all bits of a stroke.
fn bits(stroke: Motion) -> u64 {
    let (at, way) = (stroke.position, stroke.velocity);
    let numbers = [at.x, at.y, way.x, way.y].into_iter();
    numbers.fold(FNV_START, |hash, number| {
        fnv1a(hash, &number.to_bits().to_le_bytes())
    })
}

/// The search may get faster, but its results must not change. The test pins the stroke of each
/// strength, and the hint, in games begun by club players.
#[test]
fn decisions_do_not_change_by_a_single_bit() {
    use Hands::{Four, Two};
    use PieceSet::{EqualMass, Tournament};
    #[rustfmt::skip]
    let frozen: [(u64, Hands, PieceSet, [u64; 5], u64); 4] = [
        (0, Two, Tournament, [0x8aa12688c43f559c, 0x3936df2d5f816baf, 0x4a00c36e007cbdc8, 0x8b90239ca39dabcb, 0x8172ca8097607c7a], 0x1165241ed1bc9fdb),
        (3, Two, EqualMass, [0xe485aacdb8af8cbe, 0x68837243479c3af4, 0xe55a15aec47bf8f1, 0xa35a8b452e42b691, 0x7ccb7d6c411f122e], 0x119724e258a0fe7d),
        (9, Four, Tournament, [0x26c9e2c2ef121135, 0x26c9e2c2ef121135, 0x042606700528b16d, 0x3fdb5e37c4699001, 0x780d6f6371be1cb2], 0x7a53ba56acc43d91),
        (20, Two, Tournament, [0x4b82e6a2ce38f31b, 0x76748a83192a73fd, 0x031935dcfe8a8de3, 0x61fb8c20ec3467a5, 0x852300e780bded86], 0xcaf0c0a0e994e46a),
    ];
    for (seed, (strokes, hands, set, decided, hinted)) in (1..).zip(frozen) {
        let mut game = Game::new(GameSetup {
            seed: Some(seed),
            hands,
            set,
            ..GameSetup::default()
        });
        for stroke in 0..strokes {
            let decision = think(&game, Strength::Club, stroke).unwrap();
            apply(&mut game, decision.struck());
        }
        let meant = Strength::ALL.map(|strength| bits(think(&game, strength, 7).unwrap().meant));
        assert_eq!(meant, decided, "seed {seed}");
        assert_eq!(
            bits(hint(&game, PlayerHand::Exact, 7).unwrap().stroke),
            hinted,
            "seed {seed}"
        );
    }
}

/// `cargo bench --bench strength` runs the whole contest.
#[test]
fn an_expert_beats_a_player_that_shoots_at_random() {
    for seed in 0..4 {
        let mut chance = Pcg64::seed_from_u64(seed);
        let mut game = Game::new(GameSetup {
            seed: Some(seed),
            first_breaker: [Seat::South, Seat::North][(seed % 2) as usize],
            ..GameSetup::default()
        });
        for _ in 0..300 {
            let striker = if game.team(game.seat()) == Team::First {
                think(&game, Strength::Expert, chance.random()).map(|d| d.struck())
            } else {
                let lines = game.base_lines();
                let way = DVec2::from_angle(chance.random_range(0.0..3.0));
                lines.nearest(lines.at(0.0)).map(|position| Motion {
                    position,
                    velocity: game.seat().turn(way) * chance.random_range(0.5..FASTEST),
                })
            };
            match striker {
                Some(striker) => apply(&mut game, striker),
                None => drop(game.no_place().unwrap()),
            }
            if game.play().won.is_some() {
                break;
            }
        }
        let won = game.play().won.unwrap();
        assert_eq!(won.winner, Team::First, "seed {seed}");
    }
}

fn coin(piece: Piece, x_mm: f64, y_mm: f64) -> Coin {
    Coin {
        piece,
        at: DVec2::new(x_mm, y_mm) / 1000.0,
    }
}
