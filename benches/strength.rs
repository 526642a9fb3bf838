//! How strong the computer opponents are: `cargo bench --bench strength`.
//!
//! Plays boards between neighbouring strengths, and between the strongest and a
//! player that shoots at random, then measures how long it takes to choose one stroke.
//! `-- 20` plays 20 boards per pair instead of 200.
//!
//! `-- 400 hands` instead lets a player follow the hints, with each [`PlayerHand`], against each
//! strength; `-- 40 lengths` plays games between equals with each set of rules, for the estimates
//! on the page of a new game.

use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use carrom::game::opponent::{FASTEST, PlayerHand, Strength, hint, think};
use carrom::game::{Game, GameSetup, GameStage, Rules, Seat, Stroke, Team};
use carrom::physics::{Board, Engine, Limits, Motion, Shot};
use glam::DVec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// The number of strokes after which a board counts as undecided.
const MOST_STROKES: u64 = 3000;

/// A player in the contest.
#[derive(Clone, Copy)]
enum Player {
    Strength(Strength),
    /// Follows the hints, with the errors of this hand.
    Hinted(PlayerHand),
    /// Shoots from a random legal position, in a random forward direction, at a random speed of at
    /// least 0.5 m/s.
    Random,
}

/// The results of several boards.
#[derive(Default)]
struct Tally {
    won: u32,
    lost: u32,
    undecided: u32,
    points: u32,
    points_against: u32,
    strokes: u64,
}

fn main() {
    let boards = std::env::args().filter_map(|arg| arg.parse().ok()).next();
    let boards = boards.unwrap_or(200);
    let asked = |word: &str| std::env::args().any(|arg| arg == word);
    if asked("lengths") {
        return lengths(boards);
    }
    println!("{boards} boards per pair; the two players break in turn\n");
    if asked("hands") {
        let hands = PlayerHand::ALL.into_iter().rev();
        let pairs = hands.flat_map(|hand| Strength::ALL.map(|strength| (hand, strength)));
        return pairs.for_each(|(hand, strength)| {
            report(Player::Hinted(hand), Player::Strength(strength), boards);
        });
    }
    let mut pairs: Vec<(Player, Player)> = Strength::ALL
        .windows(2)
        .map(|pair| (Player::Strength(pair[1]), Player::Strength(pair[0])))
        .collect();
    pairs.push((Player::Strength(Strength::Champion), Player::Random));
    for (strong, weak) in pairs {
        report(strong, weak, boards);
    }
    println!();
    for strength in Strength::ALL {
        thinking(strength);
    }
}

/// Plays boards between two players and prints the result.
fn report(strong: Player, weak: Player, boards: u64) {
    let start = Instant::now();
    let tally = contest(strong, weak, boards);
    println!(
        "{:>12} against {:<12} {:3} won, {:3} lost, {} undecided; {:4} points to {:<4} \
         {:5.1} strokes a board; {:.0} s",
        name(strong),
        name(weak),
        tally.won,
        tally.lost,
        tally.undecided,
        tally.points,
        tally.points_against,
        tally.strokes as f64 / boards as f64,
        start.elapsed().as_secs_f64(),
    );
}

/// Prints the mean number of strokes per board and of boards per game between equals.
fn lengths(games: u64) {
    println!("{games} games between equals\n");
    for rules in [Rules::Tournament, Rules::Friendly, Rules::Points] {
        for strength in Strength::ALL {
            let mut hand = Pcg64::seed_from_u64(0);
            let (mut strokes, mut boards) = (0.0, 0.0);
            for seed in 0..games {
                let mut game = Game::new(GameSetup {
                    rules,
                    seed: Some(seed),
                    ..GameSetup::default()
                });
                loop {
                    match game.stage() {
                        GameStage::Playing => {
                            stroke(&mut game, Player::Strength(strength), &mut hand);
                            strokes += 1.0;
                        }
                        GameStage::BoardOver(_) => {
                            boards += 1.0;
                            game.next_board().unwrap_or_else(|error| panic!("{error}"));
                        }
                        GameStage::GameOver(_) | GameStage::MatchOver(_) => break,
                    }
                }
                boards += 1.0;
            }
            println!(
                "{:>10} {:>12} {:5.1} strokes a board, {:4.2} boards a game",
                <&str>::from(rules),
                strength.to_string(),
                strokes / boards,
                boards / games as f64,
            );
        }
    }
}

/// Plays boards on all cores; the result for each seed does not depend on the number of cores.
fn contest(strong: Player, weak: Player, boards: u64) -> Tally {
    let next = AtomicU64::new(0);
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let tallies = thread::scope(|scope| {
        let work = || {
            let mut tally = Tally::default();
            loop {
                let seed = next.fetch_add(1, Ordering::Relaxed);
                if seed >= boards {
                    return tally;
                }
                tally.add(strong, weak, seed);
            }
        };
        let threads: Vec<_> = (0..cores).map(|_| scope.spawn(work)).collect();
        threads
            .into_iter()
            .filter_map(|thread| thread.join().ok())
            .collect::<Vec<_>>()
    });
    tallies.into_iter().fold(Tally::default(), |a, b| Tally {
        won: a.won + b.won,
        lost: a.lost + b.lost,
        undecided: a.undecided + b.undecided,
        points: a.points + b.points,
        points_against: a.points_against + b.points_against,
        strokes: a.strokes + b.strokes,
    })
}

impl Tally {
    /// Plays one board, with the stronger player at South.
    fn add(&mut self, strong: Player, weak: Player, seed: u64) {
        let mut game = new_game(seed);
        let mut hand = Pcg64::seed_from_u64(seed);
        for _ in 0..MOST_STROKES {
            let player = match game.team(game.seat()) {
                Team::First => strong,
                Team::Second => weak,
            };
            stroke(&mut game, player, &mut hand);
            self.strokes += 1;
            let Some(won) = game.play().won else {
                continue;
            };
            if won.winner == Team::First {
                self.won += 1;
                self.points += u32::from(won.points);
            } else {
                self.lost += 1;
                self.points_against += u32::from(won.points);
            }
            return;
        }
        self.undecided += 1;
    }
}

fn new_game(seed: u64) -> Game {
    Game::new(GameSetup {
        first_breaker: if seed.is_multiple_of(2) {
            Seat::South
        } else {
            Seat::North
        },
        seed: Some(seed),
        ..GameSetup::default()
    })
}

/// Plays one stroke of `player`, or passes the turn if there is no room for the striker.
fn stroke(game: &mut Game, player: Player, hand: &mut Pcg64) {
    let board = Board::default();
    let struck = match player {
        Player::Strength(strength) => {
            think(game, strength, hand.random()).map(|decision| decision.struck())
        }
        Player::Hinted(held) => {
            let seed = hand.random();
            hint(game, held, seed).map(|hint| match held.errors() {
                Some(errors) => errors.slip_of(seed).applied_to(hint.stroke),
                None => hint.stroke,
            })
        }
        Player::Random => random(game, hand),
    };
    let ruled = match struck {
        Some(striker) => {
            let (discs, motions) = game.discs(striker);
            let mut shot = Shot::default();
            let limits = Limits::default();
            let played = Engine::default().play_into(&mut shot, &board, &discs, &motions, limits);
            played.unwrap_or_else(|error| panic!("{error}"));
            let stroke = Stroke::from_shot(game.coins(), &shot);
            stroke.and_then(|stroke| game.apply(&stroke))
        }
        None => game.no_place(),
    };
    ruled.unwrap_or_else(|error| panic!("{error}"));
}

fn random(game: &Game, hand: &mut Pcg64) -> Option<Motion> {
    let lines = game.base_lines();
    let position = lines.nearest(lines.at(hand.random_range(-0.2..0.2)))?;
    let way = DVec2::from_angle(hand.random_range(0.0..std::f64::consts::PI));
    let velocity = game.seat().turn(way) * hand.random_range(0.5..FASTEST);
    Some(Motion { position, velocity })
}

/// Times the choice of each stroke of a few boards, on one core.
fn thinking(strength: Strength) {
    let mut hand = Pcg64::seed_from_u64(0);
    let mut times = Vec::new();
    for seed in 0..4 {
        let mut game = new_game(seed);
        while game.play().won.is_none() {
            let thought: u64 = hand.random();
            // The shortest of the three times is the one that other programs disturbed least.
            let time = (0..3).map(|_| {
                let start = Instant::now();
                std::hint::black_box(think(&game, strength, thought));
                start.elapsed()
            });
            times.extend(time.min());
            stroke(&mut game, Player::Strength(strength), &mut hand);
        }
    }
    times.sort();
    let ms = |time: Option<&Duration>| time.map_or(0.0, |t| t.as_secs_f64() * 1e3);
    println!(
        "{:>12} thinks {:6.2} ms a stroke (median), {:6.2} ms at most; up to {} shots a stroke",
        strength.to_string(),
        ms(times.get(times.len() / 2)),
        ms(times.last()),
        strength.most_rehearsals(),
    );
}

fn name(player: Player) -> String {
    match player {
        Player::Strength(strength) => strength.to_string(),
        Player::Hinted(hand) => format!("hints, {}", <&str>::from(hand)),
        Player::Random => "random".to_owned(),
    }
}
