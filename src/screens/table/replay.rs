//! Watching a stroke: the one just made or an earlier one.

use std::time::Duration;

use glam::DVec2;

use super::game_history::Past;
use super::words;
use crate::game::Piece;
use crate::physics::{EventKind, Shot};
use crate::screens::Settings;
use crate::widgets::replay::{ShotClock, ShotPlayer, WatchRate};

/// Seconds for which a piece that has fallen is seen on its way to its tray.
pub(super) const FALL: f64 = 0.6;

/// Seconds for which the end of a stroke is seen, at real speed, before computers play on.
const END_SEEN: f64 = 4.0;

/// A piece that falls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FallingPiece {
    pub(super) piece: Piece,
    /// When, in seconds since the start of the stroke.
    pub(super) time: f64,
    /// Into which corner, as the engine counts them.
    pub(super) corner: usize,
}

/// A stroke being watched.
#[derive(Debug, Clone)]
pub(super) struct StrokeReplay {
    /// The number of the move it was.
    pub(super) number: usize,
    /// Whether it was made just now: then the game waits, and there is nothing to go back
    /// to but the question whether to leave it.
    pub(super) live: bool,
    /// How long its end has been seen while nobody had to press a key.
    pub(super) end_seen: Duration,
    /// What each disc of the shot is.
    pub(super) pieces: Vec<Piece>,
    /// What falls in it, in order.
    pub(super) falls: Vec<FallingPiece>,
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
        let falls = shot.events().iter().filter_map(|event| match event.kind {
            EventKind::Pocket { disc, corner } => Some(FallingPiece {
                piece: *pieces.get(disc)?,
                time: event.time,
                corner,
            }),
            _ => None,
        });
        let falls: Vec<_> = falls.collect();
        // The last one is seen on its way too.
        let last = falls.last().map_or(0.0, |fall| fall.time + FALL);
        let clock = ShotClock::new(shot.duration().max(last), rate, at_end);
        let called = past.called.as_ref().map(|called| called.said);
        let player = ShotPlayer::new(shot, 0, clock).with_faces(faces);
        Self {
            number,
            live: false,
            end_seen: Duration::ZERO,
            pieces,
            falls,
            player: player.with_said(called).with_list(),
        }
    }

    /// For how long the end of a stroke that was made just now is still to be seen; `None`
    /// while it is not.
    pub(super) fn end_left(&self) -> Option<Duration> {
        let clock = self.player.clock();
        let ended = self.live && clock.is_over() && self.player.chosen().is_none();
        let all = Duration::from_secs_f64(END_SEEN / clock.rate().seconds());
        ended.then(|| all.saturating_sub(self.end_seen))
    }

    /// The discs on the board now, with where they are.
    pub(super) fn discs(&self) -> impl Iterator<Item = (Piece, DVec2)> {
        let discs = self.player.discs();
        discs.filter_map(|(disc, at)| Some((*self.pieces.get(disc)?, at)))
    }
}
