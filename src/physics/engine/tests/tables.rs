//! Boards, discs and starting positions used in the tests.

use glam::DVec2;

use crate::physics::{Board, Disc, Limits, Motion, Shot, play};

pub(super) const COIN: Disc = Disc::from_g_mm(5.5, 15.9);
pub(super) const STRIKER: Disc = Disc::from_g_mm(15.0, 20.65);

/// A table: the discs and their initial motions.
#[derive(Debug, Clone, Default)]
pub(super) struct Table {
    pub(super) discs: Vec<Disc>,
    pub(super) start: Vec<Motion>,
}

impl Table {
    pub(super) fn with(mut self, disc: Disc, at: (f64, f64), velocity: (f64, f64)) -> Self {
        self.discs.push(disc);
        self.start.push(Motion {
            position: at.into(),
            velocity: velocity.into(),
        });
        self
    }

    pub(super) fn play(&self, board: &Board) -> Shot {
        play(board, &self.discs, &self.start, Limits::default()).expect("a playable table")
    }
}

/// The board for the break, without pockets.
pub(super) fn closed_board() -> Board {
    Board {
        pocket_diameter: 0.0,
        ..Board::default()
    }
}

/// A striker below a pack of 19 discs: one disc in the centre, six around it and twelve around
/// those, with gaps of `gap` metres. The pack is its own mirror image to the last bit.
pub(super) fn rack(gap: f64, velocity: (f64, f64)) -> Table {
    let mut table = Table::default().with(STRIKER, (0.0, -0.26), velocity);
    let pitch = 2.0 * COIN.radius + gap;
    let row = pitch * 0.75_f64.sqrt();
    for y in -2..=2_i32 {
        let count = 5 - y.abs();
        for i in 0..count {
            let x = pitch * (f64::from(i) - 0.5 * f64::from(count - 1));
            table = table.with(COIN, (x, row * f64::from(y)), (0.0, 0.0));
        }
    }
    table
}

pub(super) fn assert_close(a: f64, b: f64, tolerance: f64) {
    assert!(
        (a - b).abs() <= tolerance,
        "{a} and {b} differ by {}",
        (a - b).abs()
    );
}

pub(super) fn assert_near(a: DVec2, b: DVec2, tolerance: f64) {
    assert!(
        a.distance(b) <= tolerance,
        "{a} and {b} are {} apart",
        a.distance(b)
    );
}
