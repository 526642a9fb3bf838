//! What a pupil's device and the host say to each other, in JSON.
//!
//! Every message of the host is the pupil's whole state, so that taking a vote, coming late,
//! coming back and going back a question are one and the same; a device shows what it was told
//! last. `n` is a number that a device counts up with each vote and gets back with its state:
//! a state whose `n` is not smaller says that the vote is in, on the disk of the host, or with
//! `misfit` that it does not fit the question and was not taken. `rev`
//! counts the states of one connection. What was answered alone can be handed in: a file with
//! an `n` of its own, which comes back in `handed` once the file is on the disk of the host, or
//! with why it is not.
//!
//! ```text
//! > {"t":"join","v":1,"code":"BCDFGH","name":"Ada","seat":TOKEN?}
//! > {"t":"vote","q":3,"vote":"first","said":"sure rays 60 still","n":17}   "" takes it back
//! > {"t":"hand-in","n":1,"file":{…}}
//! > {"t":"leave"}
//! < {"t":"state","v":1,"rev":4,"seat":TOKEN,"name":"Ada","q":3,"of":10,"step":"first-vote","n":17,…}
//! < {"t":"no","why":"code"}                                                then it closes
//! ```

use serde::{Deserialize, Serialize};
use serde_json::Value;
use strum::IntoStaticStr;

use super::asked::{AskedQuestion, ToldTruth};
use super::ballot::Vote;
use super::door::SeatToken;
use super::step::ClassStep;

/// The version of what is said.
pub const VERSION: u32 = 1;

/// Most bytes of what a device says at once.
pub const LARGEST_SAYING: usize = 1024;

/// Most bytes of what is handed in, some two thousand answers.
pub const LARGEST_HAND_IN: usize = 1 << 20;

/// What a pupil's device says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "t", rename_all = "kebab-case")]
pub enum Saying {
    /// May I come in? Comes first.
    Join {
        /// The version it speaks.
        v: u32,
        /// The code of the class, as typed.
        code: String,
        /// The pupil's name, as typed.
        name: String,
        /// What brings the pupil back to their place, if they were here.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        seat: Option<SeatToken>,
    },
    /// A vote.
    Vote {
        /// The question, counted from 0.
        q: usize,
        /// Which vote.
        vote: Vote,
        /// What is said, as [`Said::to_text`](super::Said::to_text) writes it; nothing takes
        /// it back.
        said: String,
        /// Larger than that of each vote before.
        n: u64,
    },
    /// What was answered alone, for the teacher.
    HandIn {
        /// Larger than that of each before.
        n: u64,
        /// The file, as the gradebook reads it.
        file: Value,
    },
    /// Good bye.
    Leave,
}

impl Saying {
    /// What a message says.
    ///
    /// # Errors
    /// If it is none, one of another version, or too long: only what is handed in may be longer
    /// than [`LARGEST_SAYING`].
    pub fn read(text: &str) -> Result<Self, Refusal> {
        if text.len() > LARGEST_HAND_IN {
            return Err(Refusal::Format);
        }
        match serde_json::from_str(text) {
            Ok(Self::Join { v, .. }) if v != VERSION => Err(Refusal::Version),
            Ok(saying @ Self::HandIn { .. }) => Ok(saying),
            Ok(saying) if text.len() <= LARGEST_SAYING => Ok(saying),
            _ => Err(Refusal::Format),
        }
    }

    /// The message.
    pub fn to_text(&self) -> String {
        // There is nothing in it that could not be written.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// Why somebody is not let in, or no longer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Refusal {
    /// The code is another one.
    Code,
    /// There is no room.
    Full,
    /// Nothing is left of the name.
    Name,
    /// They speak another version.
    Version,
    /// What was said is none of what can be said.
    Format,
    /// Something else was said before joining, or nothing for too long.
    Join,
    /// They are here on another device, or in another tab.
    Elsewhere,
    /// The teacher lets nobody in any more, or the round is over.
    Closed,
    /// The teacher has removed them.
    Kicked,
    /// Too many have come from where they are, or have said wrong codes there.
    Later,
}

impl Refusal {
    /// What the pupil is told.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Code => "This is not the code of the class. Look at the board again.",
            Self::Full => "The class is full.",
            Self::Name => "Type a name with at least one visible character.",
            Self::Version => {
                "Your carrom and the teacher's are different versions. Open the page from the \
                 address on the board."
            }
            Self::Format | Self::Join => {
                "The teacher's carrom did not understand yours. Open the page from the address \
                 on the board."
            }
            Self::Elsewhere => {
                "You have joined on another device or in another tab. Continue there."
            }
            Self::Closed => "Nobody can join the class at the moment.",
            Self::Kicked => {
                "Your teacher has removed you from this round. Ask your teacher to let you in \
                 again."
            }
            Self::Later => {
                "Too many devices on your network are joining at once or typing wrong codes. \
                 carrom tries again by itself."
            }
        }
    }

    /// Whether another try may go better, without anybody doing anything.
    pub const fn is_passing(self) -> bool {
        matches!(self, Self::Join | Self::Later)
    }
}

/// What the host says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "t", rename_all = "kebab-case")]
pub enum HostSaying {
    /// How things stand for this pupil.
    State(Box<PupilState>),
    /// They are not let in, or no longer.
    No {
        /// Why.
        why: Refusal,
    },
}

impl HostSaying {
    /// What a message says; `None` if it is none.
    pub fn read(text: &str) -> Option<Self> {
        serde_json::from_str(text).ok()
    }

    /// The message.
    pub fn to_text(&self) -> String {
        // There is nothing in it that could not be written.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// How things stand for one pupil.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PupilState {
    /// The version.
    pub v: u32,
    /// Counts the states of this connection.
    pub rev: u64,
    /// What brings this pupil back.
    pub seat: SeatToken,
    /// What they are called here.
    pub name: String,
    /// The question, counted from 0.
    pub q: usize,
    /// How many questions there are.
    pub of: usize,
    /// The step at which the class is.
    pub step: PupilStep,
    /// The last of their votes that was handled.
    pub n: u64,
    /// Whether their last vote does not fit the question: it was not taken.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub misfit: bool,
    /// Their first vote on this question, as text; empty if there is none.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub first: String,
    /// Their second vote.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub second: String,
    /// What is asked, where something is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub question: Option<AskedQuestion>,
    /// While the class talks: how many were for each choice, where there are any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub spread: Vec<u32>,
    /// The truth, once it is told.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub told: Option<ToldTruth>,
    /// Their points in the round so far, and their place, once there are any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub score: Option<(f64, usize)>,
    /// What came of the last that they handed in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub handed: Option<HandedIn>,
}

/// What came of the last that a pupil handed in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct HandedIn {
    /// Its number.
    pub n: u64,
    /// How many answers are on the disk of the host, or why none are.
    pub kept: Result<usize, NotTaken>,
}

/// Why the host does not take what is handed in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NotTaken {
    /// It is no such file, or one of another version.
    Format,
    /// They have handed in too often, or all of them too much.
    TooMany,
    /// It could not be written.
    NotWritten,
}

impl NotTaken {
    /// What the pupil is told.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Format => {
                "The teacher's carrom could not read what yours has sent. Open the page from the \
                 address on the board."
            }
            Self::TooMany => "The teacher's carrom accepts no more today.",
            Self::NotWritten => "The teacher's carrom could not save it. Tell your teacher.",
        }
    }
}

/// Where a class is, for a pupil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PupilStep {
    /// The class gathers, or has paused.
    Lobby,
    /// The round is over.
    End,
    /// At a step of a question.
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
    fn what_is_said_is_read_as_it_is_written() {
        let join = r#"{"t":"join","v":1,"code":"bcdfgh","name":"Ada"}"#;
        let saying = Saying::read(join).unwrap();
        assert_eq!(saying.to_text(), join);
        let vote = r#"{"t":"vote","q":3,"vote":"first","said":"rays 60 still","n":17}"#;
        assert_eq!(Saying::read(vote).unwrap().to_text(), vote);
        assert_eq!(Saying::read(r#"{"t":"leave"}"#), Ok(Saying::Leave));
        let handed = r#"{"t":"hand-in","n":1,"file":{"carrom":"hand-in"}}"#;
        assert_eq!(Saying::read(handed).unwrap().to_text(), handed);
    }

    #[test]
    fn only_what_is_handed_in_may_be_long() {
        let hand_in = |bytes: usize| {
            let text = r#"{"t":"hand-in","n":1,"file":""}"#;
            let filling = "x".repeat(bytes - text.len());
            Saying::read(&text.replace("\"\"}", &format!("\"{filling}\"}}")))
        };
        assert!(hand_in(LARGEST_SAYING + 1).is_ok() && hand_in(LARGEST_HAND_IN).is_ok());
        assert_eq!(hand_in(LARGEST_HAND_IN + 1), Err(Refusal::Format));
        let said = "x".repeat(LARGEST_SAYING);
        let vote = format!(r#"{{"t":"vote","q":3,"vote":"first","said":"{said}","n":17}}"#);
        assert_eq!(Saying::read(&vote), Err(Refusal::Format));
    }

    #[test]
    fn anything_else_is_refused() {
        for text in [
            "",
            "{}",
            "[]",
            "null",
            r#"{"t":"x"}"#,
            r#"{"t":"vote","q":-1}"#,
        ] {
            assert_eq!(Saying::read(text), Err(Refusal::Format), "{text}");
        }
        let newer = r#"{"t":"join","v":2,"code":"BCDFGH","name":"Ada"}"#;
        assert_eq!(Saying::read(newer), Err(Refusal::Version));
        let long = format!(
            r#"{{"t":"join","v":1,"code":"{}","name":""}}"#,
            "B".repeat(2000)
        );
        assert_eq!(Saying::read(&long), Err(Refusal::Format));
        let deep = "[".repeat(1000);
        assert_eq!(Saying::read(&deep), Err(Refusal::Format));
    }
}
