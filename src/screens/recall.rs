//! The player's record, requested from the store.

use super::Context;
use crate::messages::{History, StoreAnswer, StoreReply, StoreRequest};
use crate::progress::Observation;
use crate::widgets::Role;

/// The player's record, if it has been loaded.
#[derive(Debug, Clone, Default)]
pub(super) struct Recall {
    /// The ticket of the latest request.
    pub(super) ticket: u64,
    /// The record, or the reason why it cannot be loaded; `None` until the first answer.
    record: Option<Result<Box<History>, String>>,
}

impl Recall {
    /// Requests the record.
    pub(super) fn ask(cx: &mut Context) -> Self {
        let player = cx.settings.player.clone();
        Self {
            ticket: cx.ask(StoreRequest::Recall(Some(player))),
            record: None,
        }
    }

    /// Stores the result if `answer` belongs to the latest request.
    pub(super) fn take(&mut self, answer: &StoreAnswer) {
        if let StoreReply::Recalled(recalled) = &answer.done
            && answer.ticket == self.ticket
        {
            self.record = Some(recalled.clone());
        }
    }

    /// The message shown while the record is being loaded, or if it cannot be loaded.
    pub(super) fn unknown(&self) -> Option<(String, Role)> {
        match &self.record {
            None => Some(("Loading …".into(), Role::Dim)),
            Some(Err(reason)) => {
                let message = format!("Your progress cannot be loaded: {reason}.");
                Some((message, Role::Warn))
            }
            Some(Ok(_)) => None,
        }
    }

    /// The record, if it has been loaded.
    pub(super) fn known(&self) -> Option<&History> {
        self.record.as_ref()?.as_deref().ok()
    }

    /// What the player saw in hits; empty until the record has been loaded.
    pub(super) fn observations(&self) -> &[Observation] {
        self.known().map_or(&[], |it| &it.observations)
    }

    /// The player's history, if it has been loaded and contains any attempts.
    pub(super) fn history(&self) -> Option<&History> {
        self.known().filter(|it| !it.attempts.is_empty())
    }
}
