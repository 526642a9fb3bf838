//! Watching a stroke: the one just made or an earlier one.

use glam::DVec2;

use super::game_history::Past;
use super::words;
use crate::game::Piece;
use crate::physics::Shot;
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
    /// A stroke that was made, with what was called of its first impact; from its
    /// beginning, or `at_end`.
    pub(super) fn new(
        number: usize,
        shot: Shot,
        past: &Past,
        at_end: bool,
        settings: &Settings,
    ) -> Self {
        let coins = past.before.coins().iter().map(|coin| coin.piece);
        let pieces: Vec<_> = std::iter::once(Piece::Striker).chain(coins).collect();
        let faces = pieces.iter().copied().map(words::face).collect();
        let rate = settings.watch_rate.unwrap_or(WatchRate::REAL);
        let clock = ShotClock::new(shot.duration(), rate, at_end);
        let called = past.called.as_ref().map(|called| called.said);
        let player = ShotPlayer::new(shot, 0, clock).with_faces(faces);
        Self {
            number,
            live: false,
            pieces,
            player: player.with_said(called).with_list(),
        }
    }

    /// The discs on the board now, with where they are.
    pub(super) fn discs(&self) -> impl Iterator<Item = (Piece, DVec2)> {
        let discs = self.player.discs();
        discs.filter_map(|(disc, at)| Some((*self.pieces.get(disc)?, at)))
    }
}
