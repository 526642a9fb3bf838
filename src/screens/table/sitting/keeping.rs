//! Keeping the game: saved after each move, exported when asked, gone on with later.

use super::{Phase, Sitting, Taken};
use crate::game::{Fingerprint, RecordError, SavedGame};
use crate::messages::{Key, StoreAnswer, StoreReply, StoreRequest};
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

impl Sitting {
    /// Sits down to a game that was saved, and keeps it with the ticket it was
    /// loaded with.
    ///
    /// # Errors
    /// If it cannot be played.
    pub(in crate::screens::table) fn resume_saved(
        saved: &SavedGame,
        ticket: u64,
    ) -> Result<Self, RecordError> {
        let mut sitting = Self::resume(Options::of(saved), saved.record.clone())?;
        sitting.keeping.ticket = Some(ticket);
        sitting.keeping.saved = Some(Ok(()));
        if let Some(number) = sitting.session.stroke_before(sitting.session.len())
            && let Some(strike) = sitting.session.strike(number)
            && !sitting.game().play().is_unbroken()
        {
            // The strength stands where it was left.
            sitting.aim.set_speed(strike.velocity.length());
        }
        Ok(sitting)
    }

    /// Has the game saved if anything was done since.
    pub(super) fn save(&mut self, cx: &mut Context) {
        if self.session.take_unsaved() {
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

    /// Keys that have to do with the whole game.
    pub(super) fn keeping_key(&mut self, key: Key, cx: &mut Context) -> Taken {
        match key {
            Key::Char('v' | 'V')
                if matches!(self.phase, Phase::Aim | Phase::Watch(_) | Phase::Over) =>
            {
                self.watch_all(cx);
            }
            Key::Char('e' | 'E') => {
                let game = Box::new(self.saved(cx));
                cx.ask(StoreRequest::Export(game));
            }
            _ => return Taken::Ignored,
        }
        Taken::Used
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
