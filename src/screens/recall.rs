//! The player's record, requested from the store.

use super::Context;
use crate::messages::{History, StoreAnswer, StoreReply, StoreRequest};
use crate::progress::Observation;
use crate::widgets::Role;

/// The player's record, if it has been loaded.
#[derive(Debug, Clone)]
pub(super) enum Recall {
    /// It has been requested with this ticket.
    Asked(u64),
    /// It cannot be loaded, for this reason.
    Unknown(String),
    Known(Box<History>),
}

impl Recall {
    /// Requests the record.
    pub(super) fn ask(cx: &mut Context) -> Self {
        let player = cx.settings.player.clone();
        Self::Asked(cx.ask(StoreRequest::Recall(Some(player))))
    }

    /// Stores the result if `answer` belongs to this request.
    pub(super) fn take(&mut self, answer: &StoreAnswer) {
        if let (Self::Asked(ticket), StoreReply::Recalled(recalled)) = (&*self, &answer.done)
            && *ticket == answer.ticket
        {
            *self = match recalled {
                Ok(history) => Self::Known(history.clone()),
                Err(reason) => Self::Unknown(reason.clone()),
            };
        }
    }

    /// The message shown while the record is being loaded, or if it cannot be loaded.
    pub(super) fn unknown(&self) -> Option<(String, Role)> {
        match self {
            Self::Asked(_) => Some(("Loading …".into(), Role::Dim)),
            Self::Unknown(reason) => {
                let message = format!("Your progress cannot be loaded: {reason}.");
                Some((message, Role::Warn))
            }
            Self::Known(_) => None,
        }
    }

    /// What the player saw in hits; empty until the record has been loaded.
    pub(super) fn observations(&self) -> &[Observation] {
        match self {
            Self::Known(history) => &history.observations,
            Self::Asked(_) | Self::Unknown(_) => &[],
        }
    }

    /// The player's history, if it has been loaded and contains any attempts.
    pub(super) fn history(&self) -> Option<&History> {
        match self {
            Self::Known(history) if !history.attempts.is_empty() => Some(history),
            _ => None,
        }
    }
}
