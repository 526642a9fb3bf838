//! One board, from the break to its end.

use glam::DVec2;

use super::free_place;
use super::laws::{
    BoardWon, Case, Law, QueenBefore, QueenFate, Rules, Ruling, RulingEffect, Side, Taken,
    TurnFate, Verdict,
};
use super::pieces::{COINS_EACH, Coin, Colour, Piece, count};
use super::score::Score;
use super::seat::{ByTeam, Seat, Team};
use super::stroke::Stroke;
use super::table::GameSetup;

/// A board in play: the positions, whose turn it is and the dues.
#[derive(Debug, Clone, PartialEq)]
pub struct BoardInPlay {
    /// The coins on the board; the striker is never among them.
    pub coins: Vec<Coin>,
    /// The seat whose turn it is; after the end of the board, the seat that struck last.
    pub seat: Seat,
    /// The team that broke and therefore plays white (16).
    pub(super) white: Team,
    /// Strokes made at the unbroken pack in this turn; `None` after the break.
    pub(super) break_tries: Option<u8>,
    /// The number of coins that each team owes because it has no pocketed coin to give back (45b).
    pub owed: ByTeam<u8>,
    /// For each team, whether one of its coins has been pocketed in this board, even if it was put
    /// back.
    pub(super) pocketed_before: ByTeam<bool>,
    /// In point carrom, the coins that each team has pocketed.
    pub(super) taken: ByTeam<Taken>,
    /// The team that has pocketed and covered the queen.
    pub queen_covered_by: Option<Team>,
    /// How the board ended, once it has.
    pub won: Option<BoardWon>,
}

impl BoardInPlay {
    /// A board on which the player at `seat` strikes first, and the team `white` plays white.
    pub(super) fn new(coins: Vec<Coin>, seat: Seat, white: Team) -> Self {
        Self {
            coins,
            seat,
            white,
            break_tries: Some(0),
            owed: ByTeam::default(),
            pocketed_before: ByTeam::default(),
            taken: ByTeam::default(),
            queen_covered_by: None,
            won: None,
        }
    }

    /// The colour that a team plays (16).
    pub(super) fn colour(&self, team: Team) -> Colour {
        if team == self.white {
            Colour::White
        } else {
            Colour::Black
        }
    }

    /// Whether the pack is still unbroken (17).
    pub fn is_unbroken(&self) -> bool {
        self.break_tries.is_some()
    }

    /// Coins of `colour` on the board.
    pub fn on_board(&self, colour: Colour) -> u8 {
        count(&self.coins, colour.piece())
    }

    /// Coins of `colour` in the pockets.
    pub fn in_pockets(&self, colour: Colour) -> u8 {
        COINS_EACH.saturating_sub(self.on_board(colour))
    }

    /// A team's points for this board in point carrom.
    pub(crate) fn points_taken(&self, team: Team) -> u8 {
        self.taken[team].points(self.queen_covered_by == Some(team))
    }

    /// In point carrom, the coins that a team has pocketed.
    pub(crate) fn taken(&self, team: Team) -> Vec<Piece> {
        let Taken { white, black } = self.taken[team];
        let coins = |piece, count: u8| vec![piece; count.into()];
        [coins(Piece::White, white), coins(Piece::Black, black)].concat()
    }

    /// Whether the queen is on the board.
    pub fn queen_on_board(&self) -> bool {
        count(&self.coins, Piece::Queen) > 0
    }

    /// Whether the player whose turn it is must cover the queen now.
    pub fn queen_to_cover(&self) -> bool {
        self.won.is_none() && !self.queen_on_board() && self.queen_covered_by.is_none()
    }

    /// The facts about a stroke that the rules use; `score` is the score before this board.
    pub(super) fn case(&self, team: Team, score: &Score, stroke: &Stroke) -> Case {
        let colour = self.colour(team);
        let side = |colour: Colour, team| Side {
            before: self.on_board(colour),
            fell: stroke.fallen(colour.piece()),
            score: score.points[team],
            taken: self.taken[team],
        };
        Case {
            colour,
            own: side(colour, team),
            other: side(colour.other(), team.other()),
            queen: match self.queen_covered_by {
                Some(by) => QueenBefore::Covered(self.colour(by)),
                None if self.queen_on_board() => QueenBefore::OnBoard,
                None => QueenBefore::ToCover,
            },
            queen_fell: stroke.fallen(Piece::Queen) > 0,
            striker_fell: stroke.fallen(Piece::Striker) > 0,
            touched: stroke.touched,
            break_tries: self.break_tries,
            owes: self.owed[team] > 0,
            may_take_queen: self.pocketed_before[team],
        }
    }

    /// Sets the positions after a stroke; the verdict is carried out afterwards.
    pub(super) fn take_in(&mut self, setup: &GameSetup, stroke: &Stroke) {
        self.coins.clone_from(&stroke.left);
        self.break_tries = self
            .break_tries
            .filter(|_| !stroke.touched)
            .map(|tries| tries.saturating_add(1));
        for team in Team::BOTH {
            self.pocketed_before[team] |= stroke.fallen(self.colour(team).piece()) > 0;
        }
        if setup.rules == Rules::Points {
            let [white, black] = [Piece::White, Piece::Black].map(|piece| stroke.fallen(piece));
            let taken = &mut self.taken[setup.hands.team(self.seat)];
            *taken = taken.with(white, black);
        }
    }

    /// Carries out a verdict: puts pieces back, and passes the turn or ends the board.
    pub(super) fn carry_out(&mut self, setup: &GameSetup, verdict: Verdict) -> Vec<Ruling> {
        let team = setup.hands.team(self.seat);
        let colour = self.colour(team);
        let mut main = Ruling {
            law: verdict.law,
            text: verdict.text,
            effects: Vec::new(),
        };
        if verdict.queen == QueenFate::Covered {
            self.queen_covered_by = Some(team);
            main.effects.push(RulingEffect::QueenCovered(colour));
        }
        if verdict.queen == QueenFate::GoesBack && !self.queen_on_board() {
            let at = free_place::for_the_queen(setup.set, &self.coins);
            self.put_back(Piece::Queen, at, &mut main);
        }
        for _ in 0..verdict.own_back {
            self.give_back(setup, team, &mut main);
        }
        if let TurnFate::Ends { won, points } = verdict.turn {
            let winner = if won { team } else { team.other() };
            let won = BoardWon { winner, points };
            self.won = Some(won);
            // All dues are cancelled (28).
            self.owed = ByTeam::default();
            main.effects.push(RulingEffect::BoardWon(won));
            return vec![main];
        }
        let old_dues = self.pay_old_dues(setup);
        for _ in 0..verdict.dues {
            if !self.give_back(setup, team, &mut main) {
                self.owed[team] = self.owed[team].saturating_add(1);
            }
        }
        if verdict.turn == TurnFate::Passes {
            self.seat = setup.hands.next(self.seat);
            self.break_tries = self.break_tries.map(|_| 0);
            main.effects.push(RulingEffect::TurnPasses(self.seat));
        } else {
            main.effects.push(RulingEffect::TurnContinues(self.seat));
            if self.queen_to_cover() {
                main.effects.push(RulingEffect::MustCover);
            }
        }

        let mut rulings = vec![main];
        rulings.extend(old_dues);
        if verdict.dues > 0 && self.owed[team] > 0 {
            rulings.push(Ruling {
                law: Some(Law::DUE_WAITS),
                text: format!(
                    "{colour} has no coin in the pockets to give back, so the due waits until there is one."
                ),
                effects: vec![RulingEffect::StillOwed(colour, self.owed[team])],
            });
        }
        rulings
    }

    /// Pays earlier dues, as far as the pocketed coins suffice (51a).
    fn pay_old_dues(&mut self, setup: &GameSetup) -> Vec<Ruling> {
        let mut rulings = Vec::new();
        for team in Team::BOTH {
            let colour = self.colour(team);
            let mut ruling = Ruling {
                law: Some(Law::DUE_IS_PAID),
                text: format!(
                    "Now that a {} coin has been pocketed, {colour} pays what was owed.",
                    colour.adjective()
                ),
                effects: Vec::new(),
            };
            while self.owed[team] > 0 && self.give_back(setup, team, &mut ruling) {
                self.owed[team] -= 1;
            }
            if !ruling.effects.is_empty() {
                if self.owed[team] > 0 {
                    let still = RulingEffect::StillOwed(colour, self.owed[team]);
                    ruling.effects.push(still);
                }
                rulings.push(ruling);
            }
        }
        rulings
    }

    /// Puts a pocketed coin of `team` back into the outer circle, if there is one, as far as
    /// possible from the player who struck or, for the other team, from the player who plays next.
    fn give_back(&mut self, setup: &GameSetup, team: Team, ruling: &mut Ruling) -> bool {
        let own = self.colour(team);
        let colour = match setup.rules {
            Rules::Points => self.taken[team].give_back(),
            _ => Some(own).filter(|_| self.in_pockets(own) > 0),
        };
        if let Some(colour) = colour {
            let owner = match setup.hands.team(self.seat) == team {
                true => self.seat,
                false => setup.hands.next(self.seat),
            };
            let at = free_place::for_a_due(setup.set, &self.coins, owner);
            self.put_back(colour.piece(), at, ruling);
        }
        colour.is_some()
    }

    fn put_back(&mut self, piece: Piece, at: DVec2, ruling: &mut Ruling) {
        let coin = Coin { piece, at };
        self.coins.push(coin);
        ruling.effects.push(RulingEffect::PutBack(coin));
    }
}
