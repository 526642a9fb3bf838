//! Point carrom, as played by children and when the number of players is odd: either side may
//! pocket any coin.
//!
//! - A black coin counts 1 point, a white one 2, and the queen 5 if she is covered: 32 points in
//!   all. The first side with more than half of them (17 or more) wins the board.
//! - Pocket any piece, and you play on.
//! - The queen may be taken at any time and must be covered: with any coin in the same stroke or
//!   the next. Otherwise, or if the striker falls, she goes back to the centre.
//!
//! These values and the total are those of "Point Carrom" as described at carrom.wordpress.com in
//! 2007. House rules settle the rest:
//!
//! - Pocket the striker and one of your coins goes back, a white one if you have one; the turn
//!   passes. No debt remains.
//! - If no coin is left to cover the queen, she needs no cover.
//! - If each side has 16 points at the end, the side with the queen wins.

use crate::game::pieces::Colour;

use super::case::{Case, QueenBefore, QueenFate, Verdict, in_words, points};
use crate::numbers::capital;

/// The points that win a game: more than half of all.
pub(crate) const POINTS_TO_WIN: u8 = 17;
/// The points for the queen, once she is covered.
pub(super) const QUEEN: u8 = 5;

/// The coins that a side has pocketed in point carrom.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Taken {
    pub(crate) white: u8,
    pub(crate) black: u8,
}

impl Taken {
    /// The points for these coins, and for the queen if the side has her.
    pub(crate) const fn points(self, queen: bool) -> u8 {
        2 * self.white + self.black + if queen { QUEEN } else { 0 }
    }

    /// Adds coins that have fallen.
    pub(crate) const fn with(self, white: u8, black: u8) -> Self {
        Self {
            white: self.white + white,
            black: self.black + black,
        }
    }

    /// Removes the coin that is put back if the striker falls, and returns its colour; `None` if
    /// the side has no coin.
    pub(crate) const fn give_back(&mut self) -> Option<Colour> {
        if self.white > 0 {
            self.white -= 1;
            Some(Colour::White)
        } else if self.black > 0 {
            self.black -= 1;
            Some(Colour::Black)
        } else {
            None
        }
    }
}

/// The verdict on a stroke in point carrom.
pub(super) fn judge(case: &Case) -> Verdict {
    let fell = case.own.fell + case.other.fell;
    let is_empty = case.own.left() + case.other.left() == 0;
    let queen_open = case.queen_fell || case.queen == QueenBefore::ToCover;
    let covers = queen_open && !case.striker_fell && (fell > 0 || is_empty);
    let (white, black) = match case.colour {
        Colour::White => (case.own.fell, case.other.fell),
        Colour::Black => (case.other.fell, case.own.fell),
    };
    let mut taken = case.own.taken.with(white, black);
    let back = { case.striker_fell }.then(|| taken.give_back()).flatten();
    let has_queen = covers || case.queen == QueenBefore::Covered(case.colour);
    let other_queen = case.queen == QueenBefore::Covered(case.colour.other());
    let (own, other) = (
        taken.points(has_queen),
        case.other.taken.points(other_queen),
    );
    let text = told(case, fell, covers, own, back);
    let queen_left = !covers && !has_queen && !other_queen;
    if own >= POINTS_TO_WIN || (is_empty && !case.striker_fell && !queen_left) {
        // At 16 points each the queen decides.
        let won = (own, has_queen) > (other, other_queen);
        let (winner, loser) = (own.max(other), own.min(other));
        let text = format!("{text}. The board is won by {winner} points to {loser}.");
        return Verdict::ends(None, text, won, winner)
            .own_back(u8::from(case.striker_fell))
            .queen_if(covers, QueenFate::Covered);
    }
    let verdict = match case.striker_fell || fell == 0 && !case.queen_fell {
        true => Verdict::passes(None, text + ", so the turn passes."),
        false => Verdict::continues(None, text + ", so the turn continues."),
    };
    let missed = case.striker_fell || case.queen == QueenBefore::ToCover && fell == 0;
    verdict
        .own_back(u8::from(case.striker_fell))
        .queen_if(queen_open && missed, QueenFate::GoesBack)
        .queen_if(covers, QueenFate::Covered)
}

/// What happened in the stroke: a sentence without its full stop, so that it can be continued.
fn told(case: &Case, fell: u8, covers: bool, own: u8, back: Option<Colour>) -> String {
    let score = points(own);
    if case.striker_fell {
        let queen = case.queen_fell || case.queen == QueenBefore::ToCover;
        return match (back.map(Colour::adjective), queen) {
            (Some(colour), true) => format!(
                "The striker fell: the queen and one {colour} coin go back, which leaves {score}"
            ),
            (Some(colour), false) => {
                format!("The striker fell and one {colour} coin goes back, which leaves {score}")
            }
            (None, true) => "The striker fell and the queen goes back".into(),
            (None, false) => "The striker fell and there is no coin to put back".into(),
        };
    }
    match (fell, case.queen_fell, case.queen) {
        (0, true, _) if !covers => {
            "The queen fell, and the next stroke must cover her with any coin".into()
        }
        (0, true, _) => format!("The queen fell last and needs no cover, which makes {score}"),
        (0, false, QueenBefore::ToCover) => {
            "No coin fell to cover the queen: she goes back to the centre".into()
        }
        (0, false, _) => "Nothing fell".into(),
        _ if covers => format!("The queen is covered, which makes {score}"),
        (1, ..) => format!("One coin fell, which makes {score}"),
        _ => {
            let fell = capital(&in_words(fell));
            format!("{fell} coins fell, which makes {score}")
        }
    }
}
