//! What changes in a round from one moment to the next: the lines of its journal.

use std::fmt;

use super::{ClassRound, SeatToken, Vote};
use crate::quiz::{Confidence, Response};

/// A vote: what is said, and how sure they are, where that is asked.
#[derive(Debug, Clone, Copy, PartialEq)]
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

    /// What such a text says; `None` if it is none.
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

/// One thing that changes in a round. Questions, people and choices are counted from 0; in
/// its text from 1.
///
/// A file of a round begins with how it stood when it was last written as a whole; the
/// changes since then are appended to it, so that a vote of 250 costs a line and not the
/// whole file.
#[derive(Debug, Clone, PartialEq)]
pub enum ClassChange {
    /// A vote, or that it is taken back.
    Vote {
        /// The question.
        question: usize,
        /// Which vote.
        vote: Vote,
        /// Who gave it.
        person: usize,
        /// What was said.
        said: Option<Said>,
    },
    /// Hands were counted, or that is taken back.
    Count {
        /// The question.
        question: usize,
        /// Which vote.
        vote: Vote,
        /// How many were for each choice.
        counts: Option<Vec<u32>>,
    },
    /// Somebody has come, behind all who were there.
    Join {
        /// What brings them back.
        seat: SeatToken,
        /// Their name, which nobody else has.
        name: String,
    },
    /// Somebody is called otherwise.
    Rename {
        /// Who.
        person: usize,
        /// Their new name.
        name: String,
    },
    /// Somebody is removed with all they said and stays out; those behind move up.
    Remove {
        /// Who.
        person: usize,
    },
    /// Somebody who was removed may come in again.
    Readmit {
        /// Which of those who were removed.
        removed: usize,
    },
    /// Somebody's place is freed, and they may come in again; those behind move up.
    Vacate {
        /// Who.
        person: usize,
    },
    /// Somebody had come back as a stranger.
    Merge {
        /// The stranger, who is removed.
        from: usize,
        /// Who they really are.
        into: usize,
    },
}

/// The text with which it is kept: "vote 3 first 17 rays 60 still".
impl fmt::Display for ClassChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vote {
                question,
                vote,
                person,
                said,
            } => {
                let vote: &str = vote.into();
                write!(f, "vote {} {vote} {}", question + 1, person + 1)?;
                said.map_or(Ok(()), |said| write!(f, " {}", said.to_text()))
            }
            Self::Count {
                question,
                vote,
                counts,
            } => {
                let vote: &str = vote.into();
                write!(f, "count {} {vote}", question + 1)?;
                let mut counts = counts.iter().flatten();
                counts.try_for_each(|count| write!(f, " {count}"))
            }
            Self::Join { seat, name } => write!(f, "join {seat} {name}"),
            Self::Rename { person, name } => write!(f, "rename {} {name}", person + 1),
            Self::Remove { person } => write!(f, "remove {}", person + 1),
            Self::Readmit { removed } => write!(f, "readmit {}", removed + 1),
            Self::Vacate { person } => write!(f, "vacate {}", person + 1),
            Self::Merge { from, into } => write!(f, "merge {} {}", from + 1, into + 1),
        }
    }
}

impl ClassChange {
    /// Whether the text of a change is that of a vote, whatever it says.
    pub(super) fn is_vote(text: &str) -> bool {
        text.starts_with("vote ")
    }

    /// What such a text says; `None` if it is none.
    pub fn parse(text: &str) -> Option<Self> {
        let from_one = |text: &str| text.parse::<usize>().ok()?.checked_sub(1);
        let (what, rest) = text.split_once(' ')?;
        let (first, behind) = match rest.split_once(' ') {
            Some((first, behind)) => (first, Some(behind)),
            None => (rest, None),
        };
        Some(match (what, behind) {
            ("vote", Some(behind)) => {
                let mut parts = behind.splitn(3, ' ');
                Self::Vote {
                    question: from_one(first)?,
                    vote: parts.next()?.parse().ok()?,
                    person: from_one(parts.next()?)?,
                    said: match parts.next() {
                        Some(said) => Some(Said::parse(said)?),
                        None => None,
                    },
                }
            }
            ("count", Some(behind)) => {
                let (vote, counts) = behind.split_once(' ').unwrap_or((behind, ""));
                let counts = counts.split(' ').filter(|count| !count.is_empty());
                let counts: Result<Vec<u32>, _> = counts.map(str::parse).collect();
                Self::Count {
                    question: from_one(first)?,
                    vote: vote.parse().ok()?,
                    counts: Some(counts.ok()?).filter(|counts| !counts.is_empty()),
                }
            }
            ("join", Some(name)) => Self::Join {
                seat: first.parse().ok()?,
                name: name.to_owned(),
            },
            ("rename", Some(name)) => Self::Rename {
                person: from_one(first)?,
                name: name.to_owned(),
            },
            ("remove", None) => Self::Remove {
                person: from_one(first)?,
            },
            ("readmit", None) => Self::Readmit {
                removed: from_one(first)?,
            },
            ("vacate", None) => Self::Vacate {
                person: from_one(first)?,
            },
            ("merge", Some(into)) => Self::Merge {
                from: from_one(first)?,
                into: from_one(into)?,
            },
            _ => return None,
        })
    }
}

impl ClassRound {
    /// Lets something change.
    ///
    /// # Errors
    /// If it does not fit the round, in words; then nothing has changed.
    pub fn change(&mut self, change: &ClassChange) -> Result<(), String> {
        let taken = |taken: bool, expected: &str| match taken {
            true => Ok(()),
            false => Err(format!("expected {expected}, found \"{change}\"")),
        };
        match change {
            ClassChange::Vote {
                question,
                vote,
                person,
                said,
            } => {
                let put = self.put(*question, *person, *vote, *said);
                taken(put, "a vote on one of its questions by one of its people")
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
    fn a_change_is_read_as_it_is_written() {
        let seat = SeatToken::of(7);
        for text in [
            "vote 3 first 17 rays -0.5 still",
            "vote 3 second 17 sure choice 2",
            "vote 3 first 1",
            "count 1 first 4 17 9 2",
            "count 1 second",
            &format!("join {seat} Ada Lovelace"),
            "rename 3 Bo  <b>",
            "remove 250",
            "readmit 1",
            "vacate 250",
            "merge 4 1",
        ] {
            let change = ClassChange::parse(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!(change.to_string(), text);
        }
        for text in [
            "",
            "vote",
            "vote 0 first 1",
            "vote 1 third 1",
            "vote 1 first 1 ",
            "vote 1 first 1 rays",
            "count 1 first x",
            "join 12 Ada",
            "remove 1 2",
            "merge 1",
            "leave 1",
        ] {
            assert_eq!(ClassChange::parse(text), None, "{text}");
        }
    }
}
