//! A class round as it is kept in a file, so that it can be taken up again.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use toml::Spanned;

use super::{Ballot, ClassPlace, ClassRound, ClassStep, Vote, team_names};
use crate::files::{FileError, Source};
use crate::quiz::concepts::Library;
use crate::quiz::{Code, CourseKind, Question, Response};

/// The format of the files that are written now.
const FORMAT: u32 = 1;

/// Largest file that is read, in bytes; the fullest round takes some 60 kB.
const LARGEST: usize = 1 << 18;

/// What stands in a file.
#[derive(Serialize)]
struct Written<'a> {
    format: u32,
    code: String,
    teams: &'a [String],
    /// The question the class is at, counted from 1.
    number: usize,
    step: &'a str,
    /// The ids of questions of the teacher's own, whose files may change.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    asked: Vec<&'a str>,
    question: Vec<Votes>,
}

/// The votes on a question, a text a team, empty where there is none.
#[derive(Serialize)]
struct Votes {
    first: Vec<String>,
    second: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ReadRound {
    #[serde(rename = "format")]
    _format: u32,
    code: Spanned<String>,
    teams: Spanned<Vec<String>>,
    number: Option<Spanned<usize>>,
    step: Option<Spanned<String>>,
    #[serde(default)]
    asked: Option<Spanned<Vec<String>>>,
    #[serde(default)]
    question: Vec<ReadVotes>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ReadVotes {
    first: Vec<Spanned<String>>,
    second: Vec<Spanned<String>>,
}

impl ClassRound {
    /// Largest file that is read, in bytes.
    pub const LARGEST_FILE: usize = LARGEST;

    /// The text of the file that keeps it.
    ///
    /// # Errors
    /// None that can be met in practice; the reason, should it not be writable.
    pub fn text(&self) -> Result<String, String> {
        let votes = |question: usize, vote: Vote| {
            let said = |team| self.ballot(question, team).vote(vote);
            let text = |team| said(team).map(Response::to_text).unwrap_or_default();
            (0..self.teams().len()).map(text).collect()
        };
        let written = Written {
            format: FORMAT,
            code: self.code().to_string(),
            teams: self.teams(),
            number: self.place().question + 1,
            step: self.place().step.id(),
            asked: self.own_ids(),
            question: (0..self.questions().len())
                .map(|question| Votes {
                    first: votes(question, Vote::First),
                    second: votes(question, Vote::Second),
                })
                .collect(),
        };
        toml::to_string(&written).map_err(|error| error.to_string())
    }

    /// The ids of the questions, if they are a teacher's own.
    fn own_ids(&self) -> Vec<&str> {
        let own = matches!(self.code().course.kind, CourseKind::Own(_));
        let questions: &[Question] = if own { self.questions() } else { &[] };
        let ids = questions.iter().map(|question| question.figures.get("id"));
        ids.filter_map(|id| id?.as_str()).collect()
    }

    /// Reads such a file; `name` stands for it in messages, and `own` are the questions of
    /// the teacher's own there are.
    ///
    /// # Errors
    /// The first thing that is wrong with it: that it is no such file, or a newer one;
    /// that its code or its teams are none; that it asks questions of the teacher's own
    /// that are not there or have changed; that a vote says nothing, or something else
    /// than was asked for.
    pub fn read(name: &str, bytes: &[u8], own: &Arc<Library>) -> Result<Self, FileError> {
        let source = Source::of_bytes(name, bytes, LARGEST)?;
        let read: ReadRound = source.tables("a class round", FORMAT)?;
        let Some(code) = Code::parse(read.code.get_ref()) else {
            let message = "expected the code of a round, such as mixed-7";
            return Err(source.fault(read.code.span().start, "code", message));
        };
        let code = code
            .with_own(own)
            .map_err(|message| source.fault(read.code.span().start, "code", message))?;
        let at = read.teams.span().start;
        let teams = team_names(read.teams.get_ref().iter().map(String::as_str))
            .map_err(|trouble| source.fault(at, "teams", trouble.to_string()))?;
        if &teams != read.teams.get_ref() {
            let message = "expected names of 1 to 24 visible letters";
            return Err(source.fault(at, "teams", message));
        }
        let mut round = Self::new(code, teams);
        if let Some(asked) = &read.asked
            && round.own_ids() != *asked.get_ref()
        {
            let message =
                "expected the questions of your own as they were; their files have changed";
            return Err(source.fault(asked.span().start, "asked", message));
        }
        for (question, votes) in read.question.iter().enumerate() {
            for (vote, field, said) in [
                (Vote::First, "first", &votes.first),
                (Vote::Second, "second", &votes.second),
            ] {
                for (team, text) in said.iter().enumerate() {
                    round
                        .take(question, team, vote, text.get_ref())
                        .map_err(|message| source.fault(text.span().start, field, message))?;
                }
            }
        }
        let place = round.read_place(source, &read)?;
        round.go(place);
        Ok(round)
    }

    /// The place in the round that a file gives: without one the first question that
    /// nobody has voted on.
    fn read_place(&self, source: Source, read: &ReadRound) -> Result<ClassPlace, FileError> {
        let last = self.questions().len().saturating_sub(1);
        let question = match &read.number {
            None => self.begun().min(last),
            Some(number) => {
                let question = number.get_ref().checked_sub(1);
                question.filter(|it| *it <= last).ok_or_else(|| {
                    let message = format!(
                        "expected the number of a question, 1 to {}, found {}",
                        last + 1,
                        number.get_ref()
                    );
                    source.fault(number.span().start, "number", message)
                })?
            }
        };
        let step = match &read.step {
            None => ClassStep::default(),
            Some(step) => ClassStep::with_id(step.get_ref()).ok_or_else(|| {
                let ids: Vec<_> = ClassStep::ALL.into_iter().map(ClassStep::id).collect();
                let message = format!(
                    "expected one of {}, found \"{}\"",
                    ids.join(", "),
                    step.get_ref().escape_debug()
                );
                source.fault(step.span().start, "step", message)
            })?,
        };
        Ok(ClassPlace { question, step })
    }

    /// Takes a vote from a file.
    fn take(&mut self, question: usize, team: usize, vote: Vote, text: &str) -> Result<(), String> {
        if question >= self.questions().len() || team >= self.teams().len() {
            return Err(format!(
                "expected votes of {} teams on {} questions, found more",
                self.teams().len(),
                self.questions().len()
            ));
        }
        if text.is_empty() {
            return Ok(());
        }
        let said = Response::parse(text);
        self.vote(question, team, vote, said);
        if said.is_none() || self.ballot(question, team).vote(vote) != said {
            return Err(format!(
                "expected a vote on this question, such as \"{}\", found \"{}\"",
                self.questions()[question].form.truth().to_text(),
                text.escape_debug()
            ));
        }
        Ok(())
    }

    /// Whether anybody has voted at all.
    pub fn is_begun(&self) -> bool {
        let voted = |ballot: Ballot| ballot.counts().is_some();
        let questions = 0..self.questions().len();
        questions
            .flat_map(|question| (0..self.teams().len()).map(move |team| (question, team)))
            .any(|(question, team)| voted(self.ballot(question, team)))
    }
}
