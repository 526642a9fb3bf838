//! The rulings that the referee announces.

use std::fmt;

use crate::game::pieces::{Coin, Colour};
use crate::game::seat::{Seat, Team};

/// The number of a law, as in "70b".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Law {
    /// Number of the law.
    pub number: u8,
    /// The clause, if the law has several.
    pub(crate) clause: Option<char>,
}

impl Law {
    pub(super) const fn new(number: u8) -> Self {
        Self {
            number,
            clause: None,
        }
    }

    pub(super) const fn clause(number: u8, clause: char) -> Self {
        Self {
            number,
            clause: Some(clause),
        }
    }

    /// A due waits until a pocketed coin can pay it.
    pub(in crate::game) const DUE_WAITS: Self = Self::clause(45, 'b');
    /// A due is paid as soon as a pocketed coin can pay it.
    pub(in crate::game) const DUE_IS_PAID: Self = Self::clause(51, 'a');
    /// A game is 25 points or eight boards.
    pub(in crate::game) const GAME: Self = Self::clause(29, 'a');
    /// An extra board decides a tie.
    pub(in crate::game) const EXTRA_BOARD: Self = Self::clause(29, 'b');
    /// A match is the best of three games.
    pub(in crate::game) const MATCH: Self = Self::new(30);
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.number)?;
        self.clause.map_or(Ok(()), |clause| write!(f, "{clause}"))
    }
}

/// One decision of the referee: the law, the reason and the effects.
#[derive(Debug, Clone, PartialEq)]
pub struct Ruling {
    /// The law; `None` for a house rule.
    pub law: Option<Law>,
    /// What happened and the reason for the decision.
    pub text: String,
    /// The changes to the board and to the score, in that order.
    pub effects: Vec<RulingEffect>,
}

impl Ruling {
    /// The announcement, with the number of the law: "Nothing fell, so White's turn passes
    /// (law 21)."
    pub fn announced(&self) -> String {
        let Some(law) = self.law else {
            return self.text.clone();
        };
        match self.text.split_once(". ") {
            Some((first, rest)) => format!("{first} (law {law}). {rest}"),
            None => format!("{} (law {law}).", self.text.trim_end_matches('.')),
        }
    }
}

/// A change made by a ruling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RulingEffect {
    /// A coin or the queen was put back at this position.
    PutBack(Coin),
    /// The colour still owes this number of coins, because none of its coins is in a pocket.
    StillOwed(Colour, u8),
    /// The queen is covered and belongs to this colour.
    QueenCovered(Colour),
    /// The queen must be covered by the next stroke.
    MustCover,
    /// The same player strikes again.
    TurnContinues(Seat),
    /// This player strikes next.
    TurnPasses(Seat),
    /// The board has ended.
    BoardWon(BoardWon),
    /// The game has ended.
    GameWon(Team),
    /// The game is tied after its last board, so an extra board decides.
    ExtraBoard,
    /// The match has ended.
    MatchWon(Team),
}

/// How a board ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BoardWon {
    /// The team that won the board.
    pub winner: Team,
    /// The points for the board: at most 12 (28), or the winner's total in point carrom.
    pub points: u8,
}
