//! The simulation of a stroke: the engine plays it, the laws judge it.

use super::wants::wants;
use crate::game::{Game, Piece, Stroke};
use crate::physics::{Board, Disc, Engine, Limits, Motion, Shot};

/// A copy of the board on which strokes are simulated.
pub(super) struct Rehearsal<'a> {
    board: Board,
    game: &'a Game,
    discs: Vec<Disc>,
    motions: Vec<Motion>,
    engine: Engine,
    /// The record of the last stroke.
    pub(super) shot: Shot,
}

/// The result of a simulated stroke.
pub(super) struct Tried {
    pub(super) after: Game,
    /// Whether a wanted piece fell, and the striker did not.
    pub(super) pocketed: bool,
    /// Whether the striker fell.
    pub(super) fouled: bool,
}

impl<'a> Rehearsal<'a> {
    pub(super) fn new(game: &'a Game) -> Self {
        let (discs, motions) = game.discs(Motion::default());
        Self {
            board: game.board(),
            game,
            discs,
            motions,
            engine: Engine::default(),
            shot: Shot::default(),
        }
    }

    /// Plays a stroke; `None` if the engine or the laws refuse it.
    pub(super) fn play(&mut self, striker: Motion) -> Option<Tried> {
        if let Some(first) = self.motions.first_mut() {
            *first = striker;
        }
        let (discs, motions, limits) = (&self.discs, &self.motions, Limits::default());
        let played = (self.engine).play_into(&mut self.shot, &self.board, discs, motions, limits);
        played.ok()?;
        let stroke = Stroke::from_shot(self.game.coins(), &self.shot).ok()?;
        let mut after = self.game.clone();
        after.apply(&stroke).ok()?;
        let fallen = &stroke.pocketed;
        let fouled = fallen.contains(&Piece::Striker);
        let pocketed = !fouled && fallen.iter().any(|piece| wants(self.game, *piece));
        Some(Tried {
            after,
            pocketed,
            fouled,
        })
    }
}
