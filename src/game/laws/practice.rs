//! Practice, with no turns, no dues and no cover for the queen. Fallen pieces stay down, and play
//! continues until the board is empty.

use super::case::{Case, QueenBefore, QueenFate, Verdict};

/// The verdict on a stroke in a practice game.
pub(super) fn judge(case: &Case) -> Verdict {
    let queen_left = case.queen == QueenBefore::OnBoard && !case.queen_fell;
    if case.own.left() == 0 && case.other.left() == 0 && !queen_left {
        return Verdict::ends(None, "The board is empty: well played.".to_owned(), true, 0);
    }
    let fell = case.own.fell + case.other.fell + u8::from(case.queen_fell);
    let text = match (fell, case.striker_fell) {
        (0, true) => "The striker fell; in a game that would cost a coin.".to_owned(),
        (0, false) => "Nothing fell; try again.".to_owned(),
        (_, true) => "The striker fell too; in a game that would cost a coin.".to_owned(),
        (1, false) => "One piece is down; play on.".to_owned(),
        (more, false) => format!("{more} pieces are down; play on."),
    };
    Verdict::continues(None, text).queen_if(case.queen_fell, QueenFate::Covered)
}
