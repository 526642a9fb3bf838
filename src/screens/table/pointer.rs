//! The coin and pocket that a hint or the computer refers to, for marking them on the board.

use glam::DVec2;

use crate::game::opponent::Story;
use crate::game::{Game, Strike};
use crate::physics::Board;
use crate::widgets::board;

/// The coin that is spoken of, and its way into the pocket.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pointer {
    /// Which coin, counted as the game counts them: the one that falls, else the one
    /// that is met first.
    pub(super) coin: usize,
    /// Corners of its way into the pocket; empty if it does not fall.
    pub(super) way: Vec<DVec2>,
    /// The middle of the pocket.
    pub(super) pocket: Option<DVec2>,
}

impl Pointer {
    /// What this story of a stroke in `game` speaks of; `None` if no coin is met.
    pub(super) fn of(story: &Story, stroke: &Strike, game: &Game) -> Option<Self> {
        let Some(fall) = story.fall else {
            return Some(Self {
                coin: story.first_hit?.coin,
                way: Vec::new(),
                pocket: None,
            });
        };
        let pocket = board::pocket(&Board::default(), fall.corner);
        let mut way = vec![game.coins().get(fall.coin)?.at];
        if let Ok(shot) = stroke.shot(game) {
            // Disc 0 is the striker.
            way.extend(shot.path(fall.coin + 1).map(|leg| leg.to));
        }
        way.extend(pocket);
        Some(Self {
            coin: fall.coin,
            way,
            pocket,
        })
    }
}
