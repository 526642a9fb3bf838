//! Keeping what is answered.

use super::spoken::verbatim;
use super::talk::{Leave, Talk};
use crate::messages::{Done, Request, Wish};
use crate::progress::Attempt;
use crate::store::Store;

/// Who plays, and where what is answered is kept.
pub struct Keeper<'a> {
    /// The name of the player.
    pub player: &'a str,
    /// Where it is kept.
    pub store: &'a mut Store,
    /// Whether it has been said why something could not be kept.
    complained: bool,
    /// How many answers could not be kept.
    lost: usize,
}

impl<'a> Keeper<'a> {
    /// A keeper of what this player does.
    pub fn new(player: &'a str, store: &'a mut Store) -> Self {
        Self {
            player,
            store,
            complained: false,
            lost: 0,
        }
    }

    /// Asks the store, and says what is wrong with it, its reasons once.
    pub(super) fn wish(&mut self, talk: &mut Talk, wish: Wish) -> Result<Done, Leave> {
        let answer = self.store.answer(&Request { ticket: 0, wish });
        if let Some(notice) = answer.notice {
            talk.say(&verbatim(&notice))?;
        }
        if let Done::Noted(Err(reason)) = &answer.done
            && !std::mem::replace(&mut self.complained, true)
        {
            let reason = verbatim(reason);
            talk.say(&format!("What you do cannot be kept: {reason}."))?;
        }
        Ok(answer.done)
    }

    /// Keeps an answer, before anything is said about it. Each one that is lost is told.
    pub(super) fn record(&mut self, talk: &mut Talk, attempt: Attempt) -> Result<(), Leave> {
        if let Done::Noted(Err(_)) = self.wish(talk, Wish::Record(Box::new(attempt)))? {
            self.lost += 1;
            talk.say(&match self.lost {
                1 => "This answer is not kept.".to_owned(),
                lost => format!("This answer is not kept either: {lost} are lost by now."),
            })?;
        }
        Ok(())
    }
}
