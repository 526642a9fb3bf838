//! `carrom misconceptions`: all that the program knows.

use std::fmt::Write;

use super::{Failure, GlobalOptions, print_text};
use crate::quiz::Misconception;

/// Print all misconceptions, with a remedy for each
#[derive(Debug, clap::Args)]
#[command(after_help = "\
The first word is the misconception's name in your own question files and in the code of a round:
carrom quiz --code copied-angle-7 asks questions that can show that one.")]
pub(super) struct Args {}

pub(super) fn run(_args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let mut text = String::new();
    for misconception in Misconception::ALL {
        let (id, name) = (misconception.id(), misconception.name());
        writeln!(text, "{id}: {name}")?;
        writeln!(text, "    {}", misconception.advice())?;
    }
    Ok(print_text(text.trim_end(), options)?)
}
