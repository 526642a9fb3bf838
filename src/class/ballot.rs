//! What somebody says to a question, at each of its two votes.

use serde::{Deserialize, Serialize};
use strum::{EnumString, IntoStaticStr};

use crate::quiz::{Answer, Confidence, Response};

/// Which of the two votes on a question; its name in files is "first".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, EnumString, IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Vote {
    /// Predicted in silence.
    First,
    /// After talking.
    Second,
}

impl Vote {
    /// Both, in order.
    pub const BOTH: [Self; 2] = [Self::First, Self::Second];
}

/// A vote: what is said, and how sure they are, where that is asked.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Said {
    /// What is said.
    pub response: Response,
    /// How sure they are of it.
    pub sure: Option<Confidence>,
}

impl From<Response> for Said {
    fn from(response: Response) -> Self {
        let sure = None;
        Self { response, sure }
    }
}

impl Said {
    /// The text with which it is kept and sent: "rays 60 still", "sure number 2.1".
    pub fn to_text(self) -> String {
        match self.sure {
            Some(sure) => format!("{} {}", sure.id(), self.response.to_text()),
            None => self.response.to_text(),
        }
    }

    /// Reads such a text; `None` if it is not one.
    pub fn parse(text: &str) -> Option<Self> {
        let sure = text
            .split_once(' ')
            .and_then(|(first, rest)| Some((Confidence::with_id(first)?, rest)));
        let (sure, rest) = match sure {
            Some((sure, rest)) => (Some(sure), rest),
            None => (None, text),
        };
        let response = Response::parse(rest)?;
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

/// What a team, or somebody on a device, said to a question: the first vote and the second, where
/// they were given.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ballot([Option<Said>; 2]);

impl Ballot {
    /// One of its votes.
    pub fn vote(&self, vote: Vote) -> Option<Response> {
        self.given(vote).map(|said| said.response)
    }

    /// Puts a vote in the place of an earlier one; `None` takes that back.
    pub(super) fn put(&mut self, vote: Vote, said: Option<Said>) {
        self.0[vote as usize] = said;
    }

    /// A vote with how sure they were of it.
    pub fn given(&self, vote: Vote) -> Option<Said> {
        self.0[vote as usize]
    }

    /// What the team says at a vote: at the second what it said at first, unless it has
    /// changed that.
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

    /// What the team says at a vote, as an answer.
    pub(super) fn answer(&self, vote: Vote) -> Option<Answer> {
        let said = self.standing(vote)?;
        Some(Answer::new(said.response, said.sure.unwrap_or(UNSURE)))
    }

    /// The vote that scores: the second, or where there is none the first.
    pub fn counts(&self) -> Option<Response> {
        self.said(Vote::Second)
    }
}

/// The confidence of whom nobody asked; it changes nothing about the credit of a vote.
const UNSURE: Confidence = Confidence::ThinkSo;

/// A vote as an answer of whom nobody asked how sure they are.
pub(super) fn unsure(said: Response) -> Answer {
    Answer::new(said, UNSURE)
}
