//! Watching a stroke: the one just made or an earlier one.

use glam::DVec2;

use super::words;
use crate::game::{Game, Piece};
use crate::physics::Shot;
use crate::quiz::Rays;
use crate::screens::Settings;
use crate::widgets::replay::{ShotClock, ShotPlayer, WatchRate};

/// A stroke being watched.
#[derive(Debug, Clone)]
pub(super) struct StrokeReplay {
    /// The number of the move it was.
    pub(super) number: usize,
    /// Whether it was made just now: then the game waits, and there is nothing to go back
    /// to but the question whether to leave it.
    pub(super) live: bool,
    /// What each disc of the shot is.
    pub(super) pieces: Vec<Piece>,
    /// Its shot, its clock and its impacts.
    pub(super) player: ShotPlayer,
}

impl StrokeReplay {
    /// A stroke on the board as it lay in `before`, with what was called of its first
    /// impact; from its beginning, or `at_end`.
    pub(super) fn new(
        number: usize,
        shot: Shot,
        before: &Game,
        called: Option<Rays>,
        at_end: bool,
        settings: &Settings,
    ) -> Self {
        let coins = before.coins().iter().map(|coin| coin.piece);
        let pieces: Vec<_> = std::iter::once(Piece::Striker).chain(coins).collect();
        let faces = pieces
            .iter()
            .map(|piece| words::face(Some(*piece)))
            .collect();
        let rate = settings.watch_rate.unwrap_or(WatchRate::REAL);
        let clock = ShotClock::new(shot.duration(), rate, at_end);
        let player = ShotPlayer::new(shot, 0, clock).with_faces(faces);
        Self {
            number,
            live: false,
            pieces,
            player: player.with_said(called).with_list(),
        }
    }

    /// The same as a stroke that was made just now.
    pub(super) fn live(self) -> Self {
        Self { live: true, ..self }
    }

    /// The discs on the board now, with where they are.
    pub(super) fn discs(&self) -> impl Iterator<Item = (usize, Piece, DVec2)> + '_ {
        let discs = self.player.discs();
        discs.filter_map(|(disc, at)| Some((disc, *self.pieces.get(disc)?, at)))
    }
}
