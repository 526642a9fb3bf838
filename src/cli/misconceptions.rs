//! `carrom misconceptions`: prints all known misconceptions.

use std::fmt::Write;

use super::{Failure, GlobalOptions, print_text};
use crate::quiz::{Misconception, Origin};

/// Print all misconceptions, each with a remedy and its origin
#[derive(Debug, clap::Args)]
#[command(after_help = "\
The first word is the misconception's name in your own question files and in the code of a round:
carrom quiz --code copied-angle-7 asks questions that can reveal that misconception.")]
pub(super) struct Args {}

pub(super) fn run(_args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let mut text = String::new();
    for misconception in Misconception::ALL {
        let (id, name) = (misconception.id(), misconception.name());
        writeln!(text, "{id}: {name}")?;
        writeln!(text, "    {}", misconception.advice())?;
        let origin = match misconception.origin() {
            Origin::Study(study) => format!("Study: {study}."),
            Origin::Slip => "A slip in algebra or reading, not a belief.".into(),
            Origin::Ours => "We know of no study: a plausible wrong step leads to it.".into(),
        };
        writeln!(text, "    {origin}")?;
    }
    print_text(text.trim_end(), options)
}
