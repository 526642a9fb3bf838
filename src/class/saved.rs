//! A class round as it is kept in a file, so that it can be taken up again.

use std::sync::Arc;

use serde::Serialize;
use strum::VariantArray;

use super::{ClassPlace, ClassRound, ClassStep, Vote, team_names};
use crate::files::{Fields, FileErrors, Source};
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

/// The fields of a file.
const FIELDS: [&str; 7] = [
    "format", "code", "teams", "number", "step", "asked", "question",
];

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
            step: self.place().step.into(),
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
    /// All that is wrong with it: that it is no such file, or a newer one; that its code or
    /// its teams are none; that it asks questions of the teacher's own that are not there
    /// or have changed; that a vote says nothing, or something else than was asked for.
    pub fn read(name: &str, bytes: &[u8], own: &Arc<Library>) -> Result<Self, FileErrors> {
        let source = Source::of_bytes(name, bytes, LARGEST)?;
        source.document("a class round", FORMAT, &FIELDS, |fields| {
            Self::from_fields(fields, own)
        })
    }

    fn from_fields(fields: &Fields, own: &Arc<Library>) -> Option<Self> {
        let code = fields.text_as("code", |code| match Code::parse(code) {
            Some(code) => code.with_own(own)?.same_for_all(),
            None => Err("expected the code of a round, such as mixed-7".into()),
        });
        let teams =
            fields
                .any_texts("teams")
                .and_then(|found| match team_names(found.iter().copied()) {
                    Ok(teams) if teams == found => Some(teams),
                    Ok(_) => fields.refuse("teams", "expected names of 1 to 24 visible letters"),
                    Err(error) => fields.refuse("teams", error.to_string()),
                });
        let asked = fields.or("asked", None, |name| fields.any_texts(name).map(Some));
        let votes = fields.or("question", Vec::new(), |name| {
            fields.tables(name, 0..=usize::MAX, &["first", "second"])
        });
        let mut round = Self::new(code?, teams?);
        if asked?.is_some_and(|asked| round.own_ids() != asked) {
            let message =
                "expected the questions of your own as they were; their files have changed";
            return fields.refuse("asked", message);
        }
        for (question, votes) in votes?.iter().enumerate() {
            for (vote, field) in Vote::BOTH.into_iter().zip(["first", "second"]) {
                let said = votes.any_texts(field).unwrap_or_default();
                for (team, text) in said.into_iter().enumerate() {
                    if let Err(message) = round.take(question, team, vote, text) {
                        votes.refuse_item::<()>(field, team, message);
                    }
                }
            }
        }
        let last = round.questions().len().saturating_sub(1);
        // Without one, the first question that nobody has voted on.
        let question = fields.or("number", round.begun().min(last), |name| {
            let expected = format!("the number of a question, 1 to {}", last + 1);
            Some(fields.whole(name, &expected, 1..=last + 1)? - 1)
        });
        let step = fields.or("step", ClassStep::default(), |name| {
            let steps = ClassStep::VARIANTS.iter().map(|step| (step.into(), *step));
            fields.word(name, &steps.collect::<Vec<_>>())
        });
        round.go(ClassPlace {
            question: question?,
            step: step?,
        });
        Some(round)
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
}
