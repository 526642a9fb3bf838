//! `carrom set`: work with sets of questions outside the game, and lists of questions.

use std::fmt::Write;
use std::path::PathBuf;

use serde::Serialize;

use super::{Failure, GlobalOptions, given, print_json, print_text};
use crate::files::{LARGEST, read};
use crate::quiz::concepts::QuestionSet;
use crate::quiz::{Code, Form, Question, Round};

/// Check sets of questions
#[derive(Debug, clap::Subcommand)]
pub(super) enum Command {
    /// Check sets of questions: every field, that each question exists, and that no question
    /// occurs twice
    ///
    /// Prints the questions of each set. For questions of your own, give their folder with
    /// --concepts. Exit status: 0 if all sets are good, 2 if there are errors.
    Check {
        /// Files of sets
        #[arg(value_name = "FILE", required = true)]
        paths: Vec<PathBuf>,
    },
}

pub(super) fn run(command: &Command, options: &GlobalOptions) -> Result<(), Failure> {
    let Command::Check { paths } = command;
    let own = options.own();
    let mut errors = own.problems.clone();
    let mut report = String::new();
    let mut found = 0;
    for path in paths {
        let name = path.display().to_string();
        let set = read(path, LARGEST)
            .map_err(Into::into)
            .and_then(|bytes| QuestionSet::read(&name, &bytes, &own));
        match set {
            Ok(set) => {
                found += 1;
                writeln!(report, "{name}: good: {}", set.title)?;
                for (number, chosen) in (1..).zip(&set.questions) {
                    write_question(number, &chosen.question, &mut report)?;
                    if id(&chosen.question) != Some(&chosen.source) {
                        writeln!(report, "    from {}", chosen.source)?;
                    }
                    if let Some(reason) = &chosen.reason {
                        writeln!(report, "    reason: {reason}")?;
                    }
                }
            }
            Err(faults) => errors.extend(faults),
        }
    }
    given::conclude(&report, &errors, (found, "sets"), options)
}

/// A list of questions, for `--json`.
#[derive(Serialize)]
struct QuestionList<'a> {
    code: String,
    questions: Vec<ListedQuestion<'a>>,
}

#[derive(Serialize)]
struct ListedQuestion<'a> {
    number: usize,
    family: &'static str,
    topic: &'a str,
    difficulty: &'static str,
    /// The id of a question in words.
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<&'a str>,
    text: &'a str,
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    choices: &'a [String],
}

/// Prints the questions for a code, without their answers.
pub(super) fn list(code: &Code, json: bool, options: &GlobalOptions) -> Result<(), Failure> {
    let code = code.clone().with_own(&options.own());
    let code = code.and_then(Code::same_for_all).map_err(Failure::input)?;
    let round = Round::of(code);
    let questions = || (1..).zip(round.questions());
    if json {
        let questions = questions().map(|(number, question)| ListedQuestion {
            number,
            family: question.family.id(),
            topic: question.topic.id(),
            difficulty: question.difficulty.id(),
            id: id(question),
            text: &question.text,
            choices: match &question.form {
                Form::Choice { options, .. } => options,
                _ => &[],
            },
        });
        let list = QuestionList {
            code: round.code().to_string(),
            questions: questions.collect(),
        };
        return print_json(&list);
    }
    let mut text = String::new();
    for (number, question) in questions() {
        write_question(number, question, &mut text)?;
    }
    print_text(text.trim_end(), options)
}

/// The id of a question in words.
fn id(question: &Question) -> Option<&str> {
    question.figures.get("id")?.as_str()
}

/// Writes a question with its number, its kind and its text.
fn write_question(number: usize, question: &Question, out: &mut String) -> std::fmt::Result {
    let (family, difficulty) = (question.family.name(), question.difficulty.id());
    write!(out, "{number}. {family}: {}, {difficulty}", question.topic)?;
    if let Some(id) = id(question) {
        write!(out, ", id {id}")?;
    }
    writeln!(out, "\n    {}", question.text)
}
