//! How fast the engine plays: `cargo bench --bench engine`.
//!
//! A printed time is that of the fastest of many rounds on one core, the round that other programs
//! disturbed least. The median of the rounds is printed beside it.

mod scenes;

use std::hint::black_box;
use std::time::Instant;

use carrom::physics::{Board, Engine, EventKind, Limits, Shot};
use scenes::{Table, breaks, closed_board, crowd, mid_game};

fn main() {
    let closed = closed_board();
    many("break, 4 m/s, 19 coins", &closed, &breaks(), 200);
    let board = Board::default();
    many("mid-game, 2.5 m/s, 19 coins", &board, &mid_game(), 1000);
    for count in [20, 60, 200, 600, 2000] {
        let (board, table) = crowd(count);
        one(&format!("{count} discs, all moving"), &board, &table);
    }
}

/// Plays every table once per round.
fn many(name: &str, board: &Board, tables: &[Table], rounds: usize) {
    let mut engine = Engine::default();
    let mut shot = Shot::default();
    let mut events = 0;
    let mut impacts = 0;
    for table in tables {
        play(&mut engine, &mut shot, board, table);
        events += shot.events().len();
        let hit = |kind: &EventKind| matches!(kind, EventKind::Impact { .. });
        impacts += shot.events().iter().filter(|e| hit(&e.kind)).count();
    }
    let (best, median) = time(rounds, || {
        for table in tables {
            play(&mut engine, &mut shot, board, table);
        }
    });
    let count = tables.len() as f64;
    println!(
        "{name:<28} {:8.2} µs a shot (median {:.2}), {:.0} shots a second, \
         {:.1} events ({:.1} impacts) a shot, {:.0} ns an event",
        best / count * 1e6,
        median / count * 1e6,
        count / best,
        events as f64 / count,
        impacts as f64 / count,
        best / events as f64 * 1e9,
    );
}

fn one(name: &str, board: &Board, table: &Table) {
    let mut engine = Engine::default();
    let mut shot = Shot::default();
    let rounds = 20_000 / table.discs.len();
    let (best, median) = time(rounds.clamp(7, 200), || {
        play(&mut engine, &mut shot, board, table);
    });
    let events = shot.events().len() as f64;
    println!(
        "{name:<28} {:8.0} µs (median {:.0}), {events} events, {:.0} ns an event",
        best * 1e6,
        median * 1e6,
        best / events * 1e9
    );
}

fn play(engine: &mut Engine, shot: &mut Shot, board: &Board, table: &Table) {
    let limits = Limits::default();
    let played = engine.play_into(shot, board, &table.discs, &table.start, limits);
    black_box(&*shot);
    if let Err(error) = played {
        panic!("{error}");
    }
}

/// The best and the median time of a round, in seconds.
fn time(rounds: usize, mut work: impl FnMut()) -> (f64, f64) {
    let mut times: Vec<f64> = (0..rounds)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    (times[0], times[rounds / 2])
}
