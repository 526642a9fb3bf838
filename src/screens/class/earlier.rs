//! The list of earlier rounds, to take one up again.

use super::play::Play;
use super::set_up::SetUp;
use crate::class::ClassRound;
use crate::messages::{Kept, Key, StoreAnswer, StoreReply, StoreRequest};
use crate::screens::Context;

/// The list.
#[derive(Debug, Clone)]
pub(super) struct Earlier {
    /// The page to go back to.
    pub(super) set_up: SetUp,
    pub(super) rounds: Rounds,
    pub(super) at: usize,
    /// A round on its way.
    loading: Option<u64>,
    /// Whether it was asked if the chosen one is to be removed.
    pub(super) removing: bool,
    pub(super) notice: Option<String>,
}

/// The rounds there are.
#[derive(Debug, Clone)]
pub(super) enum Rounds {
    /// They have been asked for.
    Asked,
    /// Nobody can say, and why.
    Unknown(String),
    /// These.
    Known(Vec<Kept<ClassRound>>),
}

/// What follows from an input.
pub(super) enum Step {
    Stay,
    Ignored,
    Back(Box<SetUp>),
    TakeUp(Box<Play>),
}

impl Earlier {
    /// The list, which is asked for.
    pub(super) fn ask(set_up: SetUp, cx: &mut Context) -> Self {
        cx.ask(StoreRequest::ListClasses);
        Self {
            set_up,
            rounds: Rounds::Asked,
            at: 0,
            loading: None,
            removing: false,
            notice: None,
        }
    }

    pub(super) fn known(&self) -> &[Kept<ClassRound>] {
        match &self.rounds {
            Rounds::Known(rounds) => rounds,
            _ => &[],
        }
    }

    /// The one the mark is at.
    pub(super) fn chosen(&self) -> Option<&Kept<ClassRound>> {
        self.known().get(self.at)
    }

    /// Takes a key.
    pub(super) fn key(&mut self, key: Key, cx: &mut Context) -> Step {
        self.notice = None;
        if std::mem::take(&mut self.removing) {
            if let Key::Char('y' | 'Y') = key
                && let Some(kept) = self.chosen()
            {
                let wish = StoreRequest::RemoveClass(kept.name.clone());
                cx.ask(wish);
            }
            return Step::Stay;
        }
        let last = self.known().len().saturating_sub(1);
        match key {
            Key::Up | Key::BackTab => self.at = self.at.saturating_sub(1),
            Key::Down | Key::Tab => self.at = (self.at + 1).min(last),
            Key::Home => self.at = 0,
            Key::End => self.at = last,
            Key::Enter => self.load(cx),
            Key::Char('d' | 'D') | Key::Delete => self.removing = self.chosen().is_some(),
            Key::Escape => return Step::Back(Box::new(self.set_up.clone())),
            _ => return Step::Ignored,
        }
        Step::Stay
    }

    fn load(&mut self, cx: &mut Context) {
        if let Some(kept) = self.chosen()
            && kept.content.is_ok()
        {
            let wish = StoreRequest::LoadClass(kept.name.clone());
            self.loading = Some(cx.ask(wish));
        }
    }

    /// Takes in what came of what was asked.
    pub(super) fn take_answer(&mut self, answer: &StoreAnswer, cx: &mut Context) -> Step {
        match &answer.done {
            StoreReply::Classes(Ok(rounds)) => {
                self.at = self.at.min(rounds.len().saturating_sub(1));
                self.rounds = Rounds::Known(rounds.clone());
            }
            StoreReply::Classes(Err(reason)) => self.rounds = Rounds::Unknown(reason.clone()),
            StoreReply::Class(loaded) if self.loading == Some(answer.ticket) => {
                self.loading = None;
                match loaded {
                    Ok(round) => {
                        let round = round.as_ref().clone();
                        let play = Play::with_ticket(round, answer.ticket, cx);
                        return Step::TakeUp(Box::new(play));
                    }
                    Err(reason) => {
                        self.notice = Some(format!("It cannot be taken up: {reason}."));
                    }
                }
            }
            StoreReply::Removed(result) => {
                if let Err(reason) = result {
                    self.notice = Some(format!("It cannot be removed: {reason}."));
                }
                cx.ask(StoreRequest::ListClasses);
            }
            _ => {}
        }
        Step::Stay
    }
}
