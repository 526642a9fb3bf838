//! One voter's answers to a question, one in each of the two votes.

use serde::{Deserialize, Serialize};
use strum::{EnumString, IntoStaticStr};

use crate::quiz::{Answer, Confidence, Question, Response, explain};

/// One of the two votes on a question; in files, "first" or "second".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, EnumString, IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Vote {
    /// The vote in silence.
    First,
    /// The vote after the discussion.
    Second,
}

impl Vote {
    /// Both votes, in order.
    pub const BOTH: [Self; 2] = [Self::First, Self::Second];
}

/// A vote: an answer, and how sure the voter is, if the voter was asked.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Said {
    /// The answer.
    pub response: Response,
    /// How sure the voter is.
    pub sure: Option<Confidence>,
}

impl From<Response> for Said {
    fn from(response: Response) -> Self {
        let sure = None;
        Self { response, sure }
    }
}

impl Said {
    /// The vote in the form in which it is stored and sent: "rays 60 still", "sure number 2.1".
    pub fn to_text(self) -> String {
        match self.sure {
            Some(sure) => format!("{} {}", sure.id(), self.response.to_text()),
            None => self.response.to_text(),
        }
    }

    /// Reads a vote from its text; `None` if the text is invalid.
    pub fn parse(text: &str) -> Option<Self> {
        let (first, rest) = text.split_once(' ').unwrap_or_default();
        let sure = Confidence::with_id(first);
        let response = Response::parse(if sure.is_some() { rest } else { text })?;
        Some(Self { response, sure })
    }
}

impl From<Said> for String {
    fn from(said: Said) -> Self {
        said.to_text()
    }
}

impl TryFrom<String> for Said {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        Self::parse(&text).ok_or("expected a vote, such as \"sure rays 60 still\"")
    }
}

/// The votes that a team, or a pupil on a device, gave on a question: the first and the second, if
/// any.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ballot([Option<Said>; 2]);

impl Ballot {
    /// The answer in one of the two votes.
    pub fn vote(&self, vote: Vote) -> Option<Response> {
        self.given(vote).map(|said| said.response)
    }

    /// Replaces an earlier vote; `None` withdraws it.
    pub(super) fn put(&mut self, vote: Vote, said: Option<Said>) {
        self.0[vote as usize] = said;
    }

    /// One of the two votes, with the voter's confidence.
    pub fn given(&self, vote: Vote) -> Option<Said> {
        self.0[vote as usize]
    }

    /// The team's answer in a vote. In the second vote, that is the first answer unless the team
    /// has changed it.
    pub fn said(&self, vote: Vote) -> Option<Response> {
        self.standing(vote).map(|said| said.response)
    }

    fn standing(&self, vote: Vote) -> Option<Said> {
        let [first, second] = self.0;
        match vote {
            Vote::First => first,
            Vote::Second => second.or(first),
        }
    }

    /// Like [`Self::said`], but as an [`Answer`].
    pub(super) fn answer(&self, vote: Vote) -> Option<Answer> {
        let said = self.standing(vote)?;
        Some(Answer::new(said.response, said.sure.unwrap_or(UNSURE)))
    }

    /// The vote that is scored: the second, or the first if there is no second.
    pub fn counts(&self) -> Option<Response> {
        self.said(Vote::Second)
    }
}

/// The confidence of voters who were not asked for it; it does not affect the credit for a vote.
const UNSURE: Confidence = Confidence::ThinkSo;

/// The explanation of a question, with the feedback on a vote if there is one.
pub(crate) fn feedback(question: &Question, said: Option<Response>) -> String {
    match said {
        Some(said) => explain(question, &unsure(said)).text,
        None => question.why.clone(),
    }
}

/// A vote as an answer without a stated confidence.
pub(super) fn unsure(said: Response) -> Answer {
    Answer::new(said, UNSURE)
}
