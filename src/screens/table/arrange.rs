//! Practice: laying the coins out by hand.

use glam::DVec2;

use crate::game::pieces::{COINS_EACH, count};
use crate::game::{Coin, Game, GameError, Piece};
use crate::physics::Board;

/// A hand over the board, maybe with a coin in it; at first empty, over the middle.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Arrange {
    /// Where the hand is, in metres.
    pub(super) hand: DVec2,
    /// The coin that goes with the hand, counted as the game counts them.
    pub(super) held: Option<usize>,
}

impl Arrange {
    /// The coin under the hand: the nearest one it touches.
    pub(super) fn under(&self, game: &Game) -> Option<usize> {
        let reach = 1.2 * game.setup().set.coin_radius();
        let distance = |coin: &Coin| coin.at.distance(self.hand);
        let coins = game.coins().iter().map(distance).enumerate();
        let touched = coins.filter(|(_, distance)| *distance <= reach);
        let nearest = touched.min_by(|(_, a), (_, b)| a.total_cmp(b));
        nearest.map(|(i, _)| i)
    }

    /// Puts the hand over the next coin, if it is empty.
    pub(super) fn reach_next(&mut self, game: &Game) {
        let next = self.under(game).map_or(0, |i| i + 1);
        let coin = game.coins().get(next).or(game.coins().first());
        if let Some(coin) = coin.filter(|_| self.held.is_none()) {
            self.hand = coin.at;
        }
    }

    /// The coins with the held one where the hand is; `None` if nothing is held.
    pub(super) fn moved(&self, game: &Game) -> Option<Vec<Coin>> {
        let mut coins = game.coins().to_vec();
        coins.get_mut(self.held?)?.at = self.hand;
        Some(coins)
    }

    /// The coins without the one in or under the hand.
    pub(super) fn taken(&self, game: &Game) -> Option<Vec<Coin>> {
        let gone = self.held.or_else(|| self.under(game))?;
        let mut coins = game.coins().to_vec();
        coins.get(gone)?;
        coins.remove(gone);
        Some(coins)
    }

    /// The coins with one more of a kind where the hand is.
    ///
    /// # Errors
    /// If the set holds no more of them.
    pub(super) fn added(&self, game: &Game, piece: Piece) -> Result<Vec<Coin>, GameError> {
        let most = if piece == Piece::Queen { 1 } else { COINS_EACH };
        let found = count(game.coins(), piece);
        if found >= most {
            let found = found + 1;
            return Err(GameError::TooMany { piece, found, most });
        }
        let at = self.hand;
        Ok([game.coins(), &[Coin { piece, at }]].concat())
    }

    /// Moves the hand, to whole millimetres and within the frame.
    pub(super) fn put_hand(&mut self, at: DVec2, game: &Game) {
        let room = Board::default().side / 2.0 - game.setup().set.coin_radius();
        let whole = (at * 1000.0).round() / 1000.0;
        self.hand = whole.clamp(DVec2::splat(-room), DVec2::splat(room));
    }
}
