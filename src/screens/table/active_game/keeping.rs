//! Saving the game after each move, exporting it, and resuming it later.

use super::{ActiveGame, GameHistory, Options};
use crate::game::{Fingerprint, RecordError, SavedGame, opponent};
use crate::messages::{FileContent, StoreAnswer, StoreReply, StoreRequest};
use crate::screens::Context;
use crate::screens::table::words;

/// Whether the game is saved, and with which ticket.
#[derive(Debug, Clone, Default)]
pub(super) struct GameKeeping {
    /// The ticket with which the game is saved, once it has been saved.
    ticket: Option<u64>,
    /// Whether the current game can be resumed later; `None` until the result of the first
    /// save is known.
    pub(super) saved: Option<bool>,
    /// A message, shown until the next move, that says why the game cannot be saved.
    pub(super) trouble: Option<String>,
}

impl ActiveGame {
    /// Resumes a saved game; it will be saved again with the ticket it was loaded with.
    ///
    /// # Errors
    /// If the saved game cannot be played through.
    pub(crate) fn resume_saved(saved: &SavedGame, ticket: u64) -> Result<Self, RecordError> {
        let history = GameHistory::from_record(saved.record.clone(), saved.hints.clone())?;
        let mut active = Self::with(Options::of(saved), history);
        active.par = active.board_code().and_then(opponent::par);
        active.keeping.ticket = Some(ticket);
        active.keeping.saved = Some(true);
        if let Some(number) = active.history.stroke_before(active.history.len())
            && let Some(strike) = active.history.strike(number)
            && !active.game().play().is_unbroken()
        {
            // The strength of the last stroke is restored.
            active.aim.set_speed(strike.velocity.length());
            active.look_ahead();
        }
        Ok(active)
    }

    /// Saves the game if anything has changed.
    pub(super) fn save(&mut self, cx: &mut Context) {
        if self.history.take_unsaved() {
            let ticket = self.keeping.ticket.unwrap_or_else(|| cx.ticket());
            self.keeping.ticket = Some(ticket);
            self.keeping.trouble = None;
            cx.keep(ticket, StoreRequest::Save(self.saved(cx)));
        }
    }

    /// The game in the form in which it is saved.
    pub(super) fn saved(&self, cx: &Context) -> FileContent {
        FileContent::Game(Box::new(SavedGame {
            player: cx.settings.player.clone(),
            company: self.options.saved_company(),
            record: self.history.record().clone(),
            hints: self.history.hints().to_vec(),
            end: Fingerprint::of(self.game()),
        }))
    }

    /// Handles the results of saving and exporting.
    pub(crate) fn take_answer(&mut self, answer: &StoreAnswer) {
        match &answer.done {
            StoreReply::Saved(result) if self.keeping.ticket == Some(answer.ticket) => {
                // A failure is reported once, not after each move.
                if let Err(reason) = result
                    && self.keeping.saved != Some(false)
                {
                    self.keeping.trouble = Some(format!(
                        "This game cannot be saved: {reason}. You can play on, but it will be lost when you leave."
                    ));
                }
                self.keeping.saved = Some(result.is_ok());
            }
            StoreReply::Exported(result) => self.notice = Some(words::exported(result)),
            _ => {}
        }
    }
}
