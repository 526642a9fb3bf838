//! Keeping the game: saved after each move, exported when asked, gone on with later.

use super::ActiveGame;
use crate::game::{Fingerprint, RecordError, SavedGame};
use crate::messages::{StoreAnswer, StoreReply, StoreRequest};
use crate::screens::Context;
use crate::screens::table::options::Options;

/// How a game is kept.
#[derive(Debug, Clone, Default)]
pub(in crate::screens::table) struct Keeping {
    /// The ticket it is saved with, once it has been.
    ticket: Option<u64>,
    /// The answer to the last save; `None` while it is awaited for the first time.
    saved: Option<Result<(), String>>,
    /// What the player has to know, until the next stroke.
    trouble: Option<String>,
}

impl Keeping {
    /// What the player has to know: why the game cannot be saved.
    pub(in crate::screens::table) fn trouble(&self) -> Option<&str> {
        self.trouble.as_deref()
    }

    /// Whether the game as it stands can be gone on with later.
    pub(in crate::screens::table) fn is_safe(&self) -> bool {
        matches!(self.saved, Some(Ok(())))
    }

    /// Takes in how a save went; a failure is told once, not after each stroke.
    fn take(&mut self, result: &Result<(), String>) {
        let failed_before = matches!(self.saved, Some(Err(_)));
        if let Err(reason) = result
            && !failed_before
        {
            self.trouble = Some(format!(
                "This game cannot be saved: {reason}. You can play on, but it would be lost when you leave."
            ));
        }
        self.saved = Some(result.clone());
    }
}

impl ActiveGame {
    /// Sits down to a game that was saved, and keeps it with the ticket it was
    /// loaded with.
    ///
    /// # Errors
    /// If it cannot be played.
    pub(in crate::screens::table) fn resume_saved(
        saved: &SavedGame,
        ticket: u64,
    ) -> Result<Self, RecordError> {
        let mut active = Self::resume(Options::of(saved), saved.record.clone())?;
        active.keeping.ticket = Some(ticket);
        active.keeping.saved = Some(Ok(()));
        if let Some(number) = active.history.stroke_before(active.history.len())
            && let Some(strike) = active.history.strike(number)
            && !active.game().play().is_unbroken()
        {
            // The strength stands where it was left.
            active.aim.set_speed(strike.velocity.length());
        }
        Ok(active)
    }

    /// Has the game saved if anything was done since.
    pub(super) fn save(&mut self, cx: &mut Context) {
        if self.history.take_unsaved() {
            let ticket = self.keeping.ticket.unwrap_or_else(|| cx.ticket());
            self.keeping.ticket = Some(ticket);
            self.keeping.trouble = None;
            cx.keep(ticket, StoreRequest::Save(Box::new(self.saved(cx))));
        }
    }

    /// The game as it is kept.
    pub(super) fn saved(&self, cx: &Context) -> SavedGame {
        SavedGame {
            player: cx.settings.player.clone(),
            company: self.options.company(),
            record: self.record().clone(),
            end: Fingerprint::of(self.game()),
        }
    }

    /// Takes in what came of saving and exporting.
    pub(super) fn take_answer(&mut self, answer: &StoreAnswer) {
        match &answer.done {
            StoreReply::Saved(result) if self.keeping.ticket == Some(answer.ticket) => {
                self.keeping.take(result);
            }
            StoreReply::Exported(Ok(place)) => {
                self.notice = Some(format!("The game is written to {place}"));
            }
            StoreReply::Exported(Err(reason)) => {
                self.notice = Some(format!("The game cannot be exported: {reason}."));
            }
            _ => {}
        }
    }
}
