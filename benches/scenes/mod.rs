//! The tables for the benchmarks. Not every benchmark uses every table.

#![allow(dead_code)]

use carrom::physics::{Board, Disc, Motion};
use glam::DVec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

pub(crate) const COIN: Disc = Disc::from_g_mm(5.5, 15.9);
pub(crate) const STRIKER: Disc = Disc::from_g_mm(15.0, 20.65);

/// Discs and their initial motions.
#[derive(Debug, Clone, Default)]
pub(crate) struct Table {
    pub(crate) discs: Vec<Disc>,
    pub(crate) start: Vec<Motion>,
}

impl Table {
    fn push(&mut self, disc: Disc, position: DVec2, velocity: DVec2) {
        self.discs.push(disc);
        self.start.push(Motion { position, velocity });
    }

    /// A striker with a velocity and a coin at rest.
    pub(crate) fn pair(striker: (f64, f64), velocity: (f64, f64), coin: (f64, f64)) -> Self {
        let mut table = Self::default();
        table.push(STRIKER, striker.into(), velocity.into());
        table.push(COIN, coin.into(), DVec2::ZERO);
        table
    }

    fn is_free(&self, disc: Disc, position: DVec2) -> bool {
        self.discs
            .iter()
            .zip(&self.start)
            .all(|(other, at)| at.position.distance(position) > other.radius + disc.radius + 1e-4)
    }

    /// Adds a disc at a random free position on a square board.
    fn scatter(&mut self, disc: Disc, side: f64, velocity: DVec2, rng: &mut Pcg64) {
        let reach = 0.5 * side - disc.radius;
        loop {
            let position = DVec2::new(
                rng.random_range(-reach..reach),
                rng.random_range(-reach..reach),
            );
            if self.is_free(disc, position) {
                return self.push(disc, position, velocity);
            }
        }
    }
}

/// The board of the break: friction 0.12, e = 1, cushions 0.8, no pockets.
pub(crate) fn closed_board() -> Board {
    Board {
        pocket_diameter: 0.0,
        ..Board::default()
    }
}

/// 64 breaks: the striker starts at 4 m/s towards the pack of 19 coins, which have gaps of 0.1 mm
/// between them. It starts from different positions on the base line and is aimed at different
/// points of the pack.
pub(crate) fn breaks() -> Vec<Table> {
    let mut rng = Pcg64::seed_from_u64(1);
    (0..64).map(|_| one_break(&mut rng)).collect()
}

fn one_break(rng: &mut Pcg64) -> Table {
    let mut table = Table::default();
    let from = DVec2::new(rng.random_range(-0.2..0.2), -0.26);
    let to = DVec2::new(rng.random_range(-0.05..0.05), -0.05);
    table.push(STRIKER, from, (to - from).normalize() * 4.0);
    let pitch = 2.0 * COIN.radius + 1e-4;
    for row in -2..=2_i32 {
        let count = 5 - row.abs();
        for i in 0..count {
            let x = f64::from(i) - 0.5 * f64::from(count - 1);
            let place = DVec2::new(x, f64::from(row) * 0.75_f64.sqrt()) * pitch;
            table.push(COIN, place, DVec2::ZERO);
        }
    }
    table
}

/// 64 strokes from the middle of a game, with 19 scattered coins: from the base line, the striker
/// is aimed at one of them at 2.5 m/s.
pub(crate) fn mid_game() -> Vec<Table> {
    let mut rng = Pcg64::seed_from_u64(2);
    (0..64)
        .map(|_| {
            let mut table = Table::default();
            let from = DVec2::new(rng.random_range(-0.2..0.2), -0.26);
            table.push(STRIKER, from, DVec2::ZERO);
            for _ in 0..19 {
                table.scatter(COIN, 0.740, DVec2::ZERO, &mut rng);
            }
            let target = table.start[rng.random_range(1..20)].position;
            table.start[0].velocity = (target - from).normalize() * 2.5;
            table
        })
        .collect()
}

/// `count` coins scattered as densely as 20 on a board, each moving at 1 m/s.
pub(crate) fn crowd(count: u32) -> (Board, Table) {
    let mut rng = Pcg64::seed_from_u64(u64::from(count));
    let side = 0.740 * f64::from(count / 20).sqrt();
    let board = Board {
        side,
        ..closed_board()
    };
    let mut table = Table::default();
    for _ in 0..count {
        let angle = rng.random_range(0.0..std::f64::consts::TAU);
        table.scatter(COIN, side, DVec2::from_angle(angle), &mut rng);
    }
    (board, table)
}
