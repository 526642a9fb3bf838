//! `carrom new`: creates a file that passes its check unchanged.

use std::path::PathBuf;

use clap::ValueEnum;

use super::{Failure, examples, print, written};
use crate::files::is_id;
use crate::numbers::capital;

/// Start your own level, chapter, questions in words or set of questions
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  carrom new level long-way-round       writes long-way-round.toml
  carrom new chapter friction           writes 01-friction.md
  carrom new questions our-marbles      writes our-marbles.toml
  carrom new set my-set                 writes my-set.toml

The file is complete and passes its check; change it step by step and check it again. The formats:
carrom guide levels, carrom guide lessons, carrom guide concepts, carrom guide sets.")]
pub(super) struct Args {
    /// What to start
    #[arg(value_name = "KIND")]
    kind: Kind,
    /// Its name: lower-case letters, digits and hyphens
    #[arg(value_name = "NAME", value_parser = name)]
    name: String,
    /// The folder to write to; created if it does not exist
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
    /// Replace an existing file
    #[arg(long)]
    force: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// A level: a small puzzle on the board
    Level,
    /// A chapter: text, figures, questions
    Chapter,
    /// Questions in words
    Questions,
    /// A set: questions that you choose, built-in ones or your own
    Set,
}

impl Kind {
    /// The path of the example to copy, the name that it contains, and the command that checks it.
    fn example(self) -> [&'static str; 3] {
        match self {
            Self::Level => ["levels/our-pack/a-glance.toml", "a-glance", "level"],
            Self::Chapter => ["chapters/01-our-coins.md", "our-coins", "lesson"],
            Self::Questions => ["questions/our-coins.toml", "our-coins", "concept"],
            Self::Set => ["sets/first-lesson.toml", "first-lesson", "set"],
        }
    }
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let ([example, old, command], name) = (args.kind.example(), &args.name);
    let text = examples::text(example).replace(&format!("\"{old}"), &format!("\"{name}"));
    let line = |name: &str| format!("title = \"{}\"", title(name));
    let text = text.replace(&line(old), &line(name));
    let (_, file) = example.rsplit_once('/').unwrap_or(("", example));
    let path = args.out.join(file.replace(old, name));
    written::write(&[(path.clone(), text)], args.force)?;
    let path = path.display();
    print(format!("{path}\ncheck it: carrom {command} check {path}\n").as_bytes())
}

/// The maximum length of a name in characters; a chapter's title has no room for more.
const LONGEST: usize = 32;

fn name(text: &str) -> Result<String, String> {
    if is_id(text) && text.len() <= LONGEST {
        Ok(text.to_owned())
    } else {
        Err(format!(
            "expected at most {LONGEST} lower-case letters, digits and hyphens, such as our-marbles"
        ))
    }
}

/// Converts "long-way-round" to "Long way round".
fn title(name: &str) -> String {
    capital(&name.replace('-', " "))
}
