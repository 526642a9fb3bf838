//! Keeping what is answered.

use super::spoken::verbatim;
use super::talk::{Leave, Talk};
use crate::messages::{StoreAnswer, StoreCall, StoreReply, StoreRequest};
use crate::progress::Attempt;

/// Whoever keeps what is done, and does what is asked of it.
pub type Keeper<'a> = dyn FnMut(&StoreCall) -> StoreAnswer + 'a;

/// Who plays, how one talks with them, and where what is answered is kept.
pub struct AnswerRecorder<'a, 't> {
    /// The talk.
    pub(super) talk: &'a mut Talk<'t>,
    /// The name of the player.
    pub player: &'a str,
    /// Where it is kept.
    store: &'a mut Keeper<'a>,
    /// Whether it has been said why something could not be kept.
    complained: bool,
    /// How much could not be kept so far.
    owed: usize,
}

impl<'a, 't> AnswerRecorder<'a, 't> {
    /// Keeps what this player does, who is talked with so.
    pub fn new(talk: &'a mut Talk<'t>, player: &'a str, store: &'a mut Keeper<'a>) -> Self {
        Self {
            talk,
            player,
            store,
            complained: false,
            owed: 0,
        }
    }

    /// Asks the store, and says what is wrong with it, its reasons once.
    pub(super) fn wish(&mut self, wish: StoreRequest) -> Result<StoreReply, Leave> {
        let answer = (self.store)(&StoreCall { ticket: 0, wish });
        if let Some(notice) = answer.notice {
            self.talk.say(&verbatim(&notice))?;
        }
        if let StoreReply::Noted(Err(reason)) = &answer.done
            && !std::mem::replace(&mut self.complained, true)
        {
            let reason = verbatim(reason);
            self.talk
                .say(&format!("What you do cannot be kept: {reason}."))?;
        }
        let before = std::mem::replace(&mut self.owed, answer.owed);
        if before > 0 && answer.owed == 0 {
            self.complained = false;
            self.talk.say("All that was not kept is kept now.")?;
        }
        Ok(answer.done)
    }

    /// Keeps an answer, before anything is said about it. Each one that cannot be kept yet is
    /// told.
    pub(super) fn record(&mut self, attempt: Attempt) -> Result<(), Leave> {
        let kept = self.wish(StoreRequest::Record(Box::new(attempt)))?;
        if !matches!(kept, StoreReply::Noted(Err(_))) {
            return Ok(());
        }
        self.talk.say(&match self.owed {
            1 => "This answer is not kept yet.".to_owned(),
            owed => format!("This answer is not kept yet either: now there are {owed}."),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::{Answer, Confidence, Round};
    use crate::store::Store;

    #[test]
    fn every_answer_that_is_not_kept_is_told_and_the_reason_once() {
        let round = Round::hits(7);
        let question = &round.questions()[0];
        let answer = Answer::new(question.form.truth(), Confidence::Sure);
        let (mut input, mut output) = (&b""[..], Vec::new());
        let mut store = Store::nowhere();
        let mut talk = Talk::new(&mut input, &mut output);
        let mut keep = |call: &StoreCall| store.answer(call);
        let mut recorder = AnswerRecorder::new(&mut talk, "Ada", &mut keep);
        for number in 1..=3 {
            let attempt = Attempt::of_quiz("Ada", round.code(), number, question, &answer);
            recorder.record(attempt).unwrap();
        }
        assert_eq!(
            String::from_utf8(output).unwrap(),
            "What you do cannot be kept: no folder for data is known; --data-dir gives one.\n\
             This answer is not kept yet.\n\
             This answer is not kept yet either: now there are 2.\n\
             This answer is not kept yet either: now there are 3.\n"
        );
    }
}
