//! `carrom lesson`: what can be done with chapters outside the game.

use std::fmt::Write;
use std::path::PathBuf;

use super::{Failure, GlobalOptions, given};
use crate::lessons::ChapterLibrary;

/// Check chapters: every directive, every number, every page
#[derive(Debug, clap::Subcommand)]
pub(super) enum Command {
    /// Check chapters: that every directive is known, that every number in the text is what
    /// the engine computes, and that every page fits an 80x24 screen in both charsets
    ///
    /// One line a chapter. Exit status: 0 all is well, 2 something is not.
    Check {
        /// Chapters and folders of them; without any, the chapters in the program
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
