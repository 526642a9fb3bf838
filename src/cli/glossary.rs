//! `carrom glossary`: the terms of mechanics.

use std::fmt::Write;

use serde::Serialize;

use super::{Failure, GlobalOptions, print_json, print_text};
use crate::files::quoted;
use crate::lessons::GlossaryEntry;

/// Explain the terms of mechanics, each in one sentence
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  carrom glossary              every term, by topic
  carrom glossary angle        the terms with this word in them
  carrom learn 2               read the chapter that introduces a term")]
pub(super) struct Args {
    /// Only the term with this name or symbol, or else all terms that contain these words
    #[arg(value_name = "TERM")]
    term: Vec<String>,
    /// Print one JSON object instead
    #[arg(long)]
    json: bool,
}

/// The JSON object that is printed.
#[derive(Serialize)]
struct GlossaryReport {
    entries: Vec<&'static GlossaryEntry>,
}

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let wanted = args.term.join(" ");
    let entries = matching(&wanted);
    if entries.is_empty() {
        let found = quoted(&wanted);
        let message =
            format!("expected a term of the glossary (carrom glossary prints all), found {found}");
        return Err(Failure::input(message));
    }
    if args.json {
        return print_json(&GlossaryReport { entries });
    }
    let book = options.book();
    let mut text = String::new();
    for entry in entries {
        text.push_str(&entry.term);
        if let Some(symbol) = &entry.symbol {
            write!(text, ", {symbol}")?;
        }
        if let Some(unit) = &entry.unit {
            write!(text, ", in {unit}")?;
        }
        writeln!(text, "\n    {}", entry.meaning)?;
        if let Some(page) = book.named(entry.introduced_by()) {
            writeln!(text, "    {page}")?;
        }
    }
    print_text(text.trim_end(), options)
}

/// The entries with exactly this term or symbol, or else all entries whose term contains the words.
fn matching(wanted: &str) -> Vec<&'static GlossaryEntry> {
    let words = wanted.to_lowercase();
    let all = GlossaryEntry::all().iter();
    let exact = |it: &&GlossaryEntry| it.term == words || it.symbol.as_deref() == Some(wanted);
    let same: Vec<_> = all.clone().filter(exact).collect();
    match same.is_empty() {
        true => all.filter(|it| it.term.contains(&words)).collect(),
        false => same,
    }
}
