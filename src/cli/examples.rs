//! `carrom examples`: the built-in example files for new levels, chapters and questions.

use std::path::PathBuf;

use include_dir::{Dir, include_dir};

use super::{Failure, written};
use crate::files::Document;

/// The example files. The tests check each one in the same way as carrom does for a user.
static EXAMPLES: Dir = include_dir!("$CARGO_MANIFEST_DIR/assets/examples");

/// Write examples of a level, a chapter, questions in words, a set of questions, a scene and
/// filmed collisions
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The folder to write to; created if it does not exist
    #[arg(long, value_name = "DIR", default_value = "examples")]
    out: PathBuf,
    /// Replace existing examples
    #[arg(long)]
    force: bool,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let mut documents = Vec::new();
    gather(&EXAMPLES, args, &mut documents);
    written::write_named(&documents, args.force)
}

fn gather(folder: &Dir, args: &Args, documents: &mut Vec<Document>) {
    for file in folder.files() {
        let text = file.contents_utf8().unwrap_or_default();
        documents.push((args.out.join(file.path()), text.to_owned()));
    }
    for folder in folder.dirs() {
        gather(folder, args, documents);
    }
}

/// The text of the example at `path`; empty if there is none, but a test makes sure that there is
/// one.
pub(super) fn text(path: &str) -> &'static str {
    let file = EXAMPLES.get_file(path);
    file.and_then(|file| file.contents_utf8())
        .unwrap_or_default()
}
