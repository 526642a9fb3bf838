//! `carrom lesson`: work with chapters outside the game.

use std::fmt::Write;
use std::path::PathBuf;

use super::{Failure, GlobalOptions, given};
use crate::lessons::ChapterLibrary;

/// Check chapters: every directive, every number, every page
#[derive(Debug, clap::Subcommand)]
pub(super) enum Command {
    /// Check chapters: every directive is known, every number in braces is what the engine
    /// computes, and every page fits an 80x24 screen in both charsets
    ///
    /// Prints one line per chapter. Exit status: 0 if all chapters are good, 2 if there are errors.
    Check {
        /// Files and folders of chapters (default: the built-in chapters)
        #[arg(value_name = "FILE|DIR")]
        paths: Vec<PathBuf>,
    },
}

pub(super) fn run(command: &Command, options: &GlobalOptions) -> Result<(), Failure> {
    let Command::Check { paths } = command;
    let library: ChapterLibrary = given::library(paths);
    let mut report = String::new();
    let mut faults = library.problems.clone();
    for chapter in &library.chapters {
        let found = crate::screens::learn::check(chapter);
        let outcome = if found.is_empty() { "good" } else { "NOT GOOD" };
        let (title, pages) = (&chapter.title, chapter.pages.len());
        writeln!(report, "{}: {outcome}: {title}, {pages} pages", chapter.id)?;
        faults.extend(found);
    }
    let found = (library.chapters.len(), "chapters");
    given::conclude(&report, &faults, found, options)
}
