//! The strokes that clear a board for one player. Their number is the par of the board.

use super::seek;
use super::strength::{Skill, Strength};
use crate::game::{BoardCode, Game, Move, Strike};

/// After this number of strokes, a board counts as not cleared.
const MOST_STROKES: usize = 40;

/// Strokes that clear the board with this code. The champion chooses them from the strokes that a
/// player can set with the keys, and plays them exactly. `None` if they do not clear the board.
pub fn clearing(code: BoardCode) -> Option<Vec<Strike>> {
    let skill = Skill {
        on_steps: true,
        ..Strength::Champion.skill()
    };
    let mut game = Game::new(code.setup());
    let mut strikes = Vec::new();
    while game.play().won.is_none() && strikes.len() < MOST_STROKES {
        let (choice, _) = seek(&game, skill, code.seed())?;
        let strike = Strike::from(choice.motion);
        Move::Strike(strike).make(&mut game).ok()?;
        strikes.push(strike);
    }
    game.coins().is_empty().then_some(strikes)
}

/// The par of the board: the number of strokes in which the search clears it.
pub fn par(code: BoardCode) -> Option<usize> {
    clearing(code).map(|strikes| strikes.len())
}
