//! The changes to a round: the lines of its journal.

use serde::{Deserialize, Serialize};

use super::ballot::{Said, Vote};
use super::join_code::SeatToken;
use super::round::ClassRound;

/// A change in a round. Questions, people and choices are counted from 0.
///
/// The file of a round begins with the state at the time of the last complete write. Later changes
/// are appended, so each of 250 votes adds one line instead of rewriting the file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ClassChange {
    /// A vote was given or withdrawn.
    Vote {
        /// The question.
        question: usize,
        /// The first or the second vote.
        vote: Vote,
        /// The voter.
        person: usize,
        /// The vote.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        said: Option<Said>,
    },
    /// Hands were counted, or the count was withdrawn.
    Count {
        /// The question.
        question: usize,
        /// The first or the second vote.
        vote: Vote,
        /// The number of votes for each choice.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        counts: Option<Vec<u32>>,
    },
    /// A participant joined and was added at the end of the list.
    Join {
        /// Their seat token, if they have a device.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        seat: Option<SeatToken>,
        /// Their name, which must be unique.
        name: String,
    },
    /// A participant was renamed.
    Rename {
        /// The participant.
        person: usize,
        /// Their new name.
        name: String,
    },
    /// A participant and all their votes were removed; later participants' indices shift by one.
    Remove {
        /// The participant.
        person: usize,
    },
    /// A removed participant may join again.
    Readmit {
        /// Their index among the removed participants.
        removed: usize,
    },
    /// A participant's seat was freed, and they may rejoin; later participants' indices shift.
    Vacate {
        /// The participant.
        person: usize,
    },
    /// A participant had joined twice.
    Merge {
        /// The duplicate, which is removed.
        from: usize,
        /// The original participant.
        into: usize,
    },
}

impl ClassChange {
    /// The line of JSON that stores the change.
    pub fn line(&self) -> String {
        // Every field can be written as JSON.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Reads a change from its line.
    ///
    /// # Errors
    /// The reason, if the line is not a change.
    pub fn read(line: &str) -> Result<Self, String> {
        serde_json::from_str(line).map_err(|error| format!("expected a change: {error}"))
    }

    /// Whether a line is a vote, valid or not.
    pub(super) fn is_vote(line: &str) -> bool {
        line.starts_with("{\"vote\":")
    }
}

/// A change in a file: one line of JSON.
#[derive(Serialize)]
pub(super) struct Then {
    change: String,
}

impl From<&ClassChange> for Then {
    fn from(change: &ClassChange) -> Self {
        let change = change.line();
        Self { change }
    }
}

/// The text that is appended to the file of a round for these changes.
///
/// # Errors
/// The reason if it cannot be written, which does not happen in practice.
pub fn appended(changes: &[ClassChange]) -> Result<String, String> {
    #[derive(Serialize)]
    struct Appended {
        then: Vec<Then>,
    }
    let then = changes.iter().map(Then::from).collect();
    toml::to_string(&Appended { then }).map_err(|error| error.to_string())
}

impl ClassRound {
    /// Applies a change.
    ///
    /// # Errors
    /// The reason, if the change does not fit the round; the round then stays unchanged.
    pub fn change(&mut self, change: &ClassChange) -> Result<(), String> {
        let taken = |taken: bool, expected: &str| match taken {
            true => Ok(()),
            false => Err(format!("expected {expected}, found {}", change.line())),
        };
        match change {
            ClassChange::Vote {
                question,
                vote,
                person,
                said,
            } => {
                let put = self.put(*question, *person, *vote, *said);
                taken(put, "a participant's vote on one of its questions")
            }
            ClassChange::Count {
                question,
                vote,
                counts,
            } => {
                let put = self.count(*question, *vote, counts.as_deref());
                taken(put, "a count for each choice of one of its questions")
            }
            ClassChange::Join { seat, name } => self.join(name, *seat),
            ClassChange::Rename { person, name } => self.rename(*person, name),
            ClassChange::Remove { person } => self.remove(*person),
            ClassChange::Readmit { removed } => self.readmit(*removed),
            ClassChange::Vacate { person } => self.vacate(*person),
            ClassChange::Merge { from, into } => self.merge(*from, *into),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_read_back_as_written() {
        let seat = SeatToken::of(7);
        for line in [
            r#"{"vote":{"question":2,"vote":"first","person":16,"said":"rays -0.5 still"}}"#,
            r#"{"vote":{"question":2,"vote":"second","person":16,"said":"sure choice 2"}}"#,
            r#"{"vote":{"question":2,"vote":"first","person":0}}"#,
            r#"{"count":{"question":0,"vote":"first","counts":[4,17,9,2]}}"#,
            r#"{"count":{"question":0,"vote":"second"}}"#,
            &format!(r#"{{"join":{{"seat":"{seat}","name":"Ada Lovelace"}}}}"#),
            r#"{"join":{"name":"Ants"}}"#,
            r#"{"rename":{"person":2,"name":"Bo  <b>"}}"#,
            r#"{"remove":{"person":249}}"#,
            r#"{"readmit":{"removed":0}}"#,
            r#"{"vacate":{"person":249}}"#,
            r#"{"merge":{"from":3,"into":0}}"#,
        ] {
            let change = ClassChange::read(line).unwrap_or_else(|it| panic!("{line}: {it}"));
            assert_eq!(change.line(), line);
        }
        for line in [
            "",
            "vote 1 first 1",
            r#"{"vote":{"question":-1,"vote":"first","person":0}}"#,
            r#"{"vote":{"question":0,"vote":"third","person":0}}"#,
            r#"{"vote":{"question":0,"vote":"first","person":0,"said":"rays"}}"#,
            r#"{"vote":{"question":0,"vote":"first","person":0,"sad":"rays 1 2"}}"#,
            r#"{"count":{"question":0,"vote":"first","counts":["x"]}}"#,
            r#"{"join":{"seat":"12","name":"Ada"}}"#,
            r#"{"merge":{"from":1}}"#,
            r#"{"leave":{"person":1}}"#,
        ] {
            assert!(ClassChange::read(line).is_err(), "{line}");
        }
    }
}
