//! `carrom level`: work with levels outside the game.

use std::fmt::{self, Write};
use std::path::PathBuf;

use anyhow::anyhow;

use super::{Failure, GlobalOptions, given};
use crate::levels::{Finding, Level, LevelLibrary, Trial, winning_share};

/// How many aims are tried to measure the difficulty.
const TRIES: u32 = 4000;

/// Check level files and prove that their levels can be won
#[derive(Debug, clap::Subcommand)]
pub(super) enum Command {
    /// Play the stored solution of each level to prove that it can be won
    ///
    /// Prints one line per level with the result. Exit status: 0 if all solutions win, 1 if
    /// one does not, 2 if a file is not a level.
    Check {
        /// Files and folders of levels (default: the built-in levels)
        #[arg(value_name = "FILE|DIR")]
        paths: Vec<PathBuf>,
        /// Show each goal too, and the share of all possible aims that win
        #[arg(long, short)]
        verbose: bool,
    },
}

pub(super) fn run(command: &Command, options: &GlobalOptions) -> Result<(), Failure> {
    let Command::Check { paths, verbose } = command;
    let library: LevelLibrary = given::library(paths);
    let mut report = String::new();
    let mut lost = 0;
    for pack in &library.packs {
        for level in &pack.levels {
            let won = check(&pack.name, level, *verbose, &mut report)?;
            lost += usize::from(!won);
        }
    }
    let packs = (library.packs.len(), "levels");
    given::conclude(&report, &library.problems, packs, options)?;
    let reason = match lost {
        0 => return Ok(()),
        1 => anyhow!("the solution of 1 level does not win it"),
        n => anyhow!("the solutions of {n} levels do not win them"),
    };
    Err(Failure::Work(reason))
}

/// Plays a level's solution, reports the result and returns whether the solution wins.
fn check(pack: &str, level: &Level, verbose: bool, out: &mut String) -> Result<bool, fmt::Error> {
    let name = match pack {
        "" => level.id.clone(),
        pack => format!("{pack}/{}", level.id),
    };
    let trial = match Trial::of(level) {
        Ok(trial) => trial,
        Err(error) => {
            writeln!(out, "{name}: cannot be played: {error}")?;
            return Ok(false);
        }
    };
    let won = trial.verdict.won();
    let outcome = if won { "won" } else { "NOT WON" };
    let findings = &trial.verdict.findings;
    writeln!(out, "{name}: {outcome}: {}", summary(findings))?;
    if trial.opens_won {
        writeln!(out, "  note: the initial aim already wins")?;
    }
    if verbose {
        for (goal, finding) in level.goals.iter().zip(findings) {
            let sign = if finding.met { '+' } else { '-' };
            let goal = goal.describe(&level.scene);
            writeln!(out, "  {sign} {goal} ({})", finding.text)?;
        }
        let share = 100.0 * winning_share(level, TRIES);
        writeln!(out, "  {share:.2} % of {TRIES} aims win")?;
    }
    Ok(won)
}

/// The results of the goals, unmet goals first.
fn summary(findings: &[Finding]) -> String {
    let text = |met| {
        let findings = findings.iter().filter(move |finding| finding.met == met);
        findings.map(|finding| finding.text.as_str())
    };
    let all: Vec<_> = text(false).chain(text(true)).collect();
    all.join("; ")
}
