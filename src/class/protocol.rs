//! The messages between a pupil's device and the host, in JSON.
//!
//! Every message from the host, except a refusal, is the pupil's whole state, so voting, joining
//! late, reconnecting and going back a question all work the same way. A device shows the latest
//! state. `n` is a number that a device increments with each vote and receives back with its state:
//! a state whose `n` is at least that of a vote confirms that the host has handled the vote. The
//! vote counts, and the host has tried to save it, unless no such vote was open or, with `misfit`,
//! it does not fit the question. `rev` counts the states of one connection. A pupil can also hand
//! in the answers that they gave while playing alone: the file has its own `n`, which comes back in
//! `handed` once the file is on the host's disk, or with the reason why it is not.
//!
//! ```text
//! > {"t":"join","v":1,"code":"BCDFGH","name":"Ada","seat":TOKEN?}
//! > {"t":"vote","q":3,"vote":"first","said":"sure rays 60 still","n":17}   "" withdraws it
//! > {"t":"hand-in","n":1,"file":{…}}
//! > {"t":"leave"}
//! < {"t":"state","v":1,"rev":4,"seat":TOKEN,"name":"Ada","q":3,"of":10,"step":"first-vote","n":17,…}
//! < {"t":"no","why":"code"}                                                then it closes
//! ```

use serde::{Deserialize, Serialize};
use serde_json::Value;
use thiserror::Error;

use super::asked::{AskedQuestion, RevealedTruth};
use super::ballot::{Said, Vote};
use super::join_code::SeatToken;
use super::step::ClassStep;

/// The version of the protocol.
pub const VERSION: u32 = 1;

/// The port of a host, if it is free and no other port is given.
pub(crate) const PORT: u16 = 8090;

/// The largest message from a device, in bytes.
pub const LARGEST_MESSAGE: usize = 1024;

/// The largest hand-in, in bytes: about two thousand answers.
pub const LARGEST_HAND_IN: usize = 1 << 20;

/// A message from a pupil's device.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "t", rename_all = "kebab-case")]
pub enum ClientMessage {
    /// A request to join, which must be the first message.
    Join {
        /// The device's version of the protocol.
        v: u32,
        /// The code of the class, as typed.
        code: String,
        /// The pupil's name, as typed.
        name: String,
        /// The pupil's seat token, if they joined before.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        seat: Option<SeatToken>,
    },
    /// A vote.
    Vote {
        /// The question, counted from 0.
        q: usize,
        /// The first or the second vote.
        vote: Vote,
        /// The vote, as [`Said::to_text`](super::Said::to_text) writes it; an empty text withdraws
        /// it.
        said: String,
        /// The number of the vote, larger than that of every earlier vote.
        n: u64,
    },
    /// The answers that the pupil gave while playing alone, for the teacher.
    HandIn {
        /// The number of the hand-in, larger than that of every earlier one.
        n: u64,
        /// The file, as the gradebook reads it.
        file: Value,
    },
    /// The device leaves.
    Leave,
}

impl ClientMessage {
    /// Reads a message.
    ///
    /// # Errors
    /// If it is not a message, has another version, or is too long: only a hand-in may be longer
    /// than [`LARGEST_MESSAGE`].
    pub fn read(text: &str) -> Result<Self, Refusal> {
        if text.len() > LARGEST_HAND_IN {
            return Err(Refusal::Format);
        }
        match serde_json::from_str(text) {
            Ok(Self::Join { v, .. }) if v != VERSION => Err(Refusal::Version),
            Ok(message @ Self::HandIn { .. }) => Ok(message),
            Ok(message) if text.len() <= LARGEST_MESSAGE => Ok(message),
            _ => Err(Refusal::Format),
        }
    }

    /// The text of the message.
    pub fn to_text(&self) -> String {
        // Every field can be written as JSON.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// Why a pupil is refused or removed, with the message for the pupil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Error)]
#[serde(rename_all = "kebab-case")]
pub enum Refusal {
    /// The code is wrong.
    #[error("This is not the code of the class. Look at the board again.")]
    Code,
    /// The class is full.
    #[error("The class is full.")]
    Full,
    /// The name has no visible letter.
    #[error("Type a name with at least one visible character.")]
    Name,
    /// The device uses another version of the protocol.
    #[error(
        "Your carrom and the teacher's are different versions. Open the page from the address on \
         the board."
    )]
    Version,
    /// The message is not valid.
    #[error("{NOT_UNDERSTOOD}")]
    Format,
    /// The device sent another message before it asked to join, or did not ask in time.
    #[error("{NOT_UNDERSTOOD}")]
    Join,
    /// The pupil has joined on another device or in another tab.
    #[error("You have joined on another device or in another tab. Continue there.")]
    Elsewhere,
    /// Nobody can join at the moment, or the round is over.
    #[error("Nobody can join the class at the moment.")]
    Closed,
    /// The teacher has removed the pupil.
    #[error("Your teacher has removed you from this round. Ask your teacher to let you in again.")]
    Kicked,
    /// Too many devices at this address have joined, or there were too many wrong codes.
    #[error(
        "Too many devices on your network are joining at once or typing wrong codes. carrom tries \
         again automatically."
    )]
    Later,
}

const NOT_UNDERSTOOD: &str = "The teacher's carrom did not understand yours. Open the page from \
                              the address on the board.";

impl Refusal {
    /// Whether another attempt may succeed without any action by the user.
    pub const fn is_passing(self) -> bool {
        matches!(self, Self::Join | Self::Later)
    }
}

/// A message from the host.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "t", rename_all = "kebab-case")]
pub enum HostMessage {
    /// The state of this pupil.
    State(Box<PupilState>),
    /// The pupil is refused or removed.
    No {
        /// The reason.
        why: Refusal,
    },
}

impl HostMessage {
    /// Reads a message; `None` if the text is invalid.
    pub fn read(text: &str) -> Option<Self> {
        serde_json::from_str(text).ok()
    }

    /// The text of the message.
    pub fn to_text(&self) -> String {
        // Every field can be written as JSON.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// The state of one pupil.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PupilState {
    /// The version of the protocol.
    pub v: u32,
    /// The number of this state on its connection.
    pub rev: u64,
    /// The pupil's seat token.
    pub seat: SeatToken,
    /// The pupil's name in this class.
    pub name: String,
    /// The question, counted from 0.
    pub q: usize,
    /// The number of questions.
    pub of: usize,
    /// The current step of the class.
    pub step: PupilStep,
    /// The number of the pupil's last vote that was handled.
    pub n: u64,
    /// Whether the last vote does not fit the question and was not counted.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub misfit: bool,
    /// Their first vote on this question.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first: Option<Said>,
    /// Their second vote.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second: Option<Said>,
    /// The current question; `None` in the lobby and at the end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub question: Option<AskedQuestion>,
    /// During the discussion and the second vote: the number of first votes for each choice; empty
    /// if the question has no choices.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub spread: Vec<u32>,
    /// The right answer, once it is revealed.
    #[serde(rename = "told", default, skip_serializing_if = "Option::is_none")]
    pub revealed: Option<RevealedTruth>,
    /// The pupil's points so far and their rank, at the scoreboard and at the end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub score: Option<(f64, usize)>,
    /// The result of the last hand-in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub handed: Option<HandedIn>,
}

/// The result of a pupil's last hand-in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct HandedIn {
    /// The number of the hand-in.
    pub n: u64,
    /// The number of its answers, all on the host's disk, or the reason why it was not saved.
    pub kept: Result<usize, NotTaken>,
}

/// Why the host refuses a hand-in, with the message for the pupil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Error)]
#[serde(rename_all = "kebab-case")]
pub enum NotTaken {
    /// The file is not a valid hand-in, is from a newer version, or contains no answers.
    #[error(
        "The teacher's carrom could not read what yours sent. Open the page from the address on \
         the board."
    )]
    Format,
    /// This pupil has made too many hand-ins, or those of the class are too large in all.
    #[error("The teacher's carrom accepts no more hand-ins today.")]
    TooMany,
    /// The hand-in could not be written.
    #[error("The teacher's carrom could not save it. Tell your teacher.")]
    NotWritten,
}

/// The phase of a round, for a pupil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PupilStep {
    /// The class is gathering, or has paused.
    Lobby,
    /// The round is over.
    End,
    /// The class is at a step of a question.
    #[serde(untagged)]
    Asked(ClassStep),
}

impl PupilStep {
    /// The vote that is open.
    pub const fn vote(self) -> Option<Vote> {
        match self {
            Self::Asked(step) => step.vote(),
            Self::Lobby | Self::End => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_read_back_as_written() {
        let join = r#"{"t":"join","v":1,"code":"bcdfgh","name":"Ada"}"#;
        let message = ClientMessage::read(join).unwrap();
        assert_eq!(message.to_text(), join);
        let vote = r#"{"t":"vote","q":3,"vote":"first","said":"rays 60 still","n":17}"#;
        assert_eq!(ClientMessage::read(vote).unwrap().to_text(), vote);
        assert_eq!(
            ClientMessage::read(r#"{"t":"leave"}"#),
            Ok(ClientMessage::Leave)
        );
        let handed = r#"{"t":"hand-in","n":1,"file":{"carrom":"hand-in"}}"#;
        assert_eq!(ClientMessage::read(handed).unwrap().to_text(), handed);
    }

    #[test]
    fn only_hand_ins_may_be_long() {
        let hand_in = |bytes: usize| {
            let text = r#"{"t":"hand-in","n":1,"file":""}"#;
            let filling = "x".repeat(bytes - text.len());
            ClientMessage::read(&text.replace("\"\"}", &format!("\"{filling}\"}}")))
        };
        assert!(hand_in(LARGEST_MESSAGE + 1).is_ok() && hand_in(LARGEST_HAND_IN).is_ok());
        assert_eq!(hand_in(LARGEST_HAND_IN + 1), Err(Refusal::Format));
        let said = "x".repeat(LARGEST_MESSAGE);
        let vote = format!(r#"{{"t":"vote","q":3,"vote":"first","said":"{said}","n":17}}"#);
        assert_eq!(ClientMessage::read(&vote), Err(Refusal::Format));
    }

    #[test]
    fn invalid_messages_are_refused() {
        for text in [
            "",
            "{}",
            "[]",
            "null",
            r#"{"t":"x"}"#,
            r#"{"t":"vote","q":-1}"#,
        ] {
            assert_eq!(ClientMessage::read(text), Err(Refusal::Format), "{text}");
        }
        let newer = r#"{"t":"join","v":2,"code":"BCDFGH","name":"Ada"}"#;
        assert_eq!(ClientMessage::read(newer), Err(Refusal::Version));
        let long = format!(
            r#"{{"t":"join","v":1,"code":"{}","name":""}}"#,
            "B".repeat(2000)
        );
        assert_eq!(ClientMessage::read(&long), Err(Refusal::Format));
        let deep = "[".repeat(1000);
        assert_eq!(ClientMessage::read(&deep), Err(Refusal::Format));
    }
}
