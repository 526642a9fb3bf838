//! The facts that the rules use, and the possible decisions.

use super::Law;
use super::points::Taken;
use crate::game::pieces::{COINS_EACH, Colour};
use crate::numbers::{capital, counted};

/// The points for the queen if the winner's score allows them (25b).
pub(super) const QUEEN_POINTS: u8 = 3;
/// From this score on, the queen is worth no points (27).
pub(super) const QUEEN_WORTHLESS_FROM: u8 = 22;

/// The state of the queen just before a stroke.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum QueenBefore {
    OnBoard,
    /// She has been pocketed but not yet covered, so this stroke must cover her.
    ToCover,
    /// She has been pocketed and covered by this colour.
    Covered(Colour),
}

/// A stroke in numbers: the pieces on the board before the stroke, the pieces that fell, the score
/// and the dues.
///
/// "Own" is the colour of the player who struck.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Case {
    /// The colour of the player who struck.
    pub colour: Colour,
    /// The player's coins and score.
    pub own: Side,
    /// The opponent's coins and score.
    pub other: Side,
    /// The queen before the stroke.
    pub queen: QueenBefore,
    pub(crate) queen_fell: bool,
    pub(crate) striker_fell: bool,
    /// Whether the striker touched any piece.
    pub(crate) touched: bool,
    /// How many strokes the player has already made at the unbroken pack in this turn; `None` after
    /// the break.
    pub(crate) break_tries: Option<u8>,
    /// Whether the player owes a coin.
    pub owes: bool,
    /// Whether a coin of the player's colour had been pocketed in this board before this stroke:
    /// that gives the player the right to the queen (65).
    pub(crate) may_take_queen: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Side {
    /// The coins of this side on the board before the stroke.
    pub before: u8,
    /// The coins of this side that fell.
    pub fell: u8,
    /// The side's score in the game before this board.
    pub score: u8,
    /// In point carrom, the coins that this side had pocketed before the stroke.
    pub(crate) taken: Taken,
}

impl Side {
    /// The number of the side's coins left on the board after the stroke.
    pub(super) const fn left(&self) -> u8 {
        self.before.saturating_sub(self.fell)
    }

    /// Whether all nine of the side's coins were on the board before the stroke.
    pub(super) const fn had_all(&self) -> bool {
        self.before == COINS_EACH
    }

    /// The value of the queen if this side wins the board (25b, 27).
    pub(super) const fn queen_worth(&self) -> u8 {
        if self.score < QUEEN_WORTHLESS_FROM {
            QUEEN_POINTS
        } else {
            0
        }
    }
}

/// What becomes of the queen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum QueenFate {
    /// She stays as she is: on the board, covered, or pocketed and to be covered next.
    Stays,
    /// She goes back to the centre.
    GoesBack,
    /// She is covered by the player.
    Covered,
}

/// Who strikes next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TurnFate {
    /// The same player strikes again.
    Continues,
    /// The next player strikes.
    Passes,
    /// Nobody strikes: the board is over.
    Ends {
        /// Whether the player who struck won the board.
        won: bool,
        points: u8,
    },
}

/// The decision of the rules on a stroke.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Verdict {
    /// The law that decides; `None` for a house rule.
    pub law: Option<Law>,
    /// What happened and its consequence.
    pub text: String,
    /// The player's own coins that are put back at once.
    pub(crate) own_back: u8,
    /// Dues: further coins of the player to put back, now or as soon as any are in the pockets.
    pub(crate) dues: u8,
    /// What becomes of the queen.
    pub queen: QueenFate,
    /// Who strikes next.
    pub turn: TurnFate,
}

impl Verdict {
    fn new(law: Option<Law>, text: String, turn: TurnFate) -> Self {
        Self {
            law,
            text,
            own_back: 0,
            dues: 0,
            queen: QueenFate::Stays,
            turn,
        }
    }

    /// The verdict that the player strikes again.
    pub(super) fn continues(law: impl Into<Option<Law>>, text: String) -> Self {
        Self::new(law.into(), text, TurnFate::Continues)
    }

    pub(super) fn passes(law: impl Into<Option<Law>>, text: String) -> Self {
        Self::new(law.into(), text, TurnFate::Passes)
    }

    /// The verdict that ends the board.
    pub(super) fn ends(law: impl Into<Option<Law>>, text: String, won: bool, points: u8) -> Self {
        Self::new(law.into(), text, TurnFate::Ends { won, points })
    }

    /// The verdict with `own_back` of the player's coins put back at once.
    pub(super) fn own_back(self, own_back: u8) -> Self {
        Self { own_back, ..self }
    }

    pub(super) fn one_due(self) -> Self {
        Self { dues: 1, ..self }
    }

    /// The verdict, which also reports that any fallen coins of the other side stay in the pockets.
    pub(super) fn with_others(mut self, case: &Case) -> Self {
        let number = case.other.fell;
        if number > 0 {
            let others = capital(&coins(number, case.colour.other()));
            let stays = if number == 1 { "stays" } else { "stay" };
            self.text += &format!(" {others} fell and {stays} down.");
        }
        self
    }

    /// The verdict with this fate of the queen.
    pub(super) fn queen(self, queen: QueenFate) -> Self {
        self.queen_if(true, queen)
    }

    /// The verdict with this fate of the queen if `case` is true; otherwise the verdict unchanged.
    pub(super) fn queen_if(mut self, case: bool, queen: QueenFate) -> Self {
        if case {
            self.queen = queen;
        }
        self
    }
}

/// A number of coins in words: "one white coin", "two black coins".
pub(super) fn coins(number: u8, colour: Colour) -> String {
    let (adjective, plural) = (colour.adjective(), if number == 1 { "" } else { "s" });
    format!("{} {adjective} coin{plural}", in_words(number))
}

/// A number of pieces, written as a word up to nine.
pub(super) fn in_words(number: u8) -> String {
    const WORDS: [&str; 10] = [
        "no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine",
    ];
    let word = WORDS.get(usize::from(number));
    word.map_or_else(|| number.to_string(), |word| (*word).to_owned())
}

/// A number of points in words.
pub(super) fn points(number: u8) -> String {
    counted(number.into(), "point")
}
