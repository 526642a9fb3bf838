//! `carrom concept`: work with written questions outside the game.

use std::fmt::Write;
use std::path::PathBuf;

use super::{Failure, GlobalOptions, given};
use crate::quiz::concepts::{Library, check};

/// Check questions in words: every field, every number, and that no right choice gives
/// itself away
#[derive(Debug, clap::Subcommand)]
pub(super) enum Command {
    /// Check questions in words: every field and misconception is known, every number in braces
    /// is defined, and no right choice gives itself away by its length, its position or a word
    ///
    /// Prints one line per question. Exit status: 0 if all questions are good, 2 if there are
    /// errors.
    Check {
        /// Files and folders of questions (default: the built-in questions)
        #[arg(value_name = "FILE|DIR")]
        paths: Vec<PathBuf>,
    },
}

pub(super) fn run(command: &Command, options: &GlobalOptions) -> Result<(), Failure> {
    let Command::Check { paths } = command;
    let library: Library = given::library(paths);
    let mut faults = library.problems.clone();
    let found = check(&library.concepts);
    let mut report = String::new();
    for concept in &library.concepts {
        let good = found.iter().all(|fault| !concept.is_at(fault));
        let outcome = if good { "good" } else { "NOT GOOD" };
        let (topic, difficulty) = (concept.topic(), concept.difficulty.id());
        writeln!(report, "{}: {outcome}: {topic}, {difficulty}", concept.id)?;
    }
    faults.extend(found);
    let found = (library.concepts.len(), "questions");
    given::conclude(&report, &faults, found, options)
}
