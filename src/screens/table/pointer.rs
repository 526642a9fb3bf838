//! The coin and the pocket that a hint or the computer's stroke is about, to be marked on the
//! board.

use glam::DVec2;

use crate::game::opponent::Story;
use crate::game::{Game, Strike};
use crate::physics::Board;
use crate::widgets::board;

/// A coin, and its path into a pocket.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pointer {
    /// The index of the coin in the game: the one that is pocketed, otherwise the one that is hit
    /// first.
    pub(super) coin: usize,
    /// The corners of the coin's path into the pocket; empty if the coin is not pocketed.
    pub(super) way: Vec<DVec2>,
    /// The middle of the pocket.
    pub(super) pocket: Option<DVec2>,
}

impl Pointer {
    /// The coin and pocket in this story of a stroke in `game`; `None` if the stroke hits no coin.
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
