//! A game in progress, with its history.

use std::mem;

use super::calls::Called;
use super::computer_stroke::ComputerStroke;
use crate::game::opponent::Story;
use crate::game::pieces::pocketed;
use crate::game::{Game, GameSetup, Move, MoveError, Piece, Record, RecordError, Ruling, Strike};
use crate::physics::Shot;

/// A game and its record, which always agree.
#[derive(Debug, Clone)]
pub(super) struct GameHistory {
    record: Record,
    game: Game,
    past: Vec<Past>,
    /// The numbers, from 0, of the moves that were made with a hint.
    hints: Vec<usize>,
    /// Whether the game has changed since it was last saved.
    unsaved: bool,
}

/// A move that was made.
#[derive(Debug, Clone)]
pub(super) struct Past {
    pub(super) before: Game,
    /// What the referee announced.
    pub(super) rulings: Vec<Ruling>,
    /// The player's call and its result, if there was a call and a collision.
    pub(super) called: Option<Called>,
    /// The pocketed pieces, which may include the striker.
    pub(super) fallen: Vec<Piece>,
    /// The story of the move, if it was a stroke.
    pub(super) story: Option<Story>,
    /// The computer's intention, if the computer made the move in this session.
    pub(super) meant: Option<Box<ComputerStroke>>,
}

impl Past {
    fn new(before: Game, made: &Move, shot: Option<&Shot>, rulings: Vec<Ruling>) -> Self {
        Self {
            rulings,
            called: { made.strike().zip(shot) }
                .and_then(|(strike, shot)| Called::new(strike, shot)),
            fallen: shot.map_or_else(Vec::new, |shot| pocketed(before.coins(), shot)),
            story: shot.map(|shot| Story::of(&before, shot)),
            meant: None,
            before,
        }
    }
}

impl GameHistory {
    pub(super) fn new(setup: GameSetup) -> Self {
        Self {
            record: Record::new(setup),
            game: Game::new(setup),
            past: Vec::new(),
            hints: Vec::new(),
            unsaved: false,
        }
    }

    /// The game that results from a record, with its history and the moves that were made with a
    /// hint.
    ///
    /// # Errors
    /// If the record cannot be played.
    pub(super) fn from_record(record: Record, hints: Vec<usize>) -> Result<Self, RecordError> {
        let mut past = Vec::new();
        let game = record.play_through(|before, made, shot, rulings| {
            past.push(Past::new(before, made, shot.as_ref(), rulings));
        })?;
        Ok(Self {
            record,
            game,
            past,
            hints,
            unsaved: false,
        })
    }

    /// Whether the game has changed since this function was last called.
    pub(super) fn take_unsaved(&mut self) -> bool {
        mem::take(&mut self.unsaved)
    }

    /// The game in its current state.
    pub(super) fn game(&self) -> &Game {
        &self.game
    }

    /// The record, which is sufficient to replay the game.
    pub(super) fn record(&self) -> &Record {
        &self.record
    }

    /// The moves that were made.
    pub(super) fn moves(&self) -> &[Past] {
        &self.past
    }

    /// A move that was made, by its number from 0.
    pub(super) fn past(&self, number: usize) -> Option<&Past> {
        self.past.get(number)
    }

    /// The number of moves made.
    pub(super) fn len(&self) -> usize {
        self.past.len()
    }

    /// Makes a move; returns the shot if it was a stroke.
    ///
    /// # Errors
    /// If the move cannot be made. The game is then unchanged.
    pub(super) fn make(&mut self, next: Move) -> Result<Option<Shot>, MoveError> {
        let before = self.game.clone();
        let (shot, rulings) = next.make(&mut self.game)?;
        self.past
            .push(Past::new(before, &next, shot.as_ref(), rulings));
        self.record.moves.push(next);
        self.unsaved = true;
        Ok(shot)
    }

    /// Adds the computer's intention to a stroke that it has made.
    pub(super) fn notify(&mut self, number: usize, meant: ComputerStroke) {
        if let Some(past) = self.past.get_mut(number) {
            past.meant = Some(Box::new(meant));
        }
    }

    /// Records that the player took a hint for the next move.
    pub(super) fn take_hint(&mut self) {
        if self.hints.last() != Some(&self.len()) {
            self.hints.push(self.len());
        }
    }

    /// The numbers, from 0, of the moves that were made with a hint.
    pub(super) fn hints(&self) -> &[usize] {
        &self.hints
    }

    /// The game after a move.
    pub(super) fn after(&self, number: usize) -> &Game {
        let next = self.past.get(number + 1);
        next.map_or(&self.game, |next| &next.before)
    }

    /// Takes the last move back; returns whether there was one.
    pub(super) fn undo(&mut self) -> bool {
        let Some(past) = self.past.pop() else {
            return false;
        };
        self.record.moves.pop();
        self.unsaved = true;
        self.game = past.before;
        true
    }

    /// The stroke of a move, if the move was one.
    pub(super) fn strike(&self, number: usize) -> Option<&Strike> {
        self.record.moves.get(number)?.strike()
    }

    /// The number of strokes before the move with this number.
    pub(super) fn strokes_before(&self, number: usize) -> usize {
        let moves = self.record.moves.iter().take(number);
        moves.filter_map(Move::strike).count()
    }

    /// Computes the shot of an earlier stroke again.
    pub(super) fn shot(&self, number: usize) -> Option<Shot> {
        let before = &self.past(number)?.before;
        self.strike(number)?.shot(before).ok()
    }

    /// The move number of the last stroke before `number`.
    pub(super) fn stroke_before(&self, number: usize) -> Option<usize> {
        (0..number.min(self.len()))
            .rev()
            .find(|i| self.strike(*i).is_some())
    }

    /// The move number of the first stroke from `number` on.
    pub(super) fn stroke_from(&self, number: usize) -> Option<usize> {
        (number..self.len()).find(|i| self.strike(*i).is_some())
    }
}
