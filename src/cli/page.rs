//! `carrom page`: carrom as one HTML file, including a teacher's own levels, chapters and
//! questions.

use std::path::{Path, PathBuf};

use super::{Failure, GlobalOptions, written};
use crate::files::{self, FileError};
use crate::levels::pack_order;
use crate::quiz::Code;
use crate::shells::{OwnFile, PageFile};

/// The maximum number of files that are read from one folder.
const MOST_FILES: usize = 500;

/// Write carrom as one HTML file for any browser
///
/// It contains the levels, chapters and questions in words from --levels, --lessons and --concepts,
/// so a class gets them by opening the file.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  carrom page --out carrom.html
  carrom page --concepts mine --out physics-10b.html
  carrom page --scorm quick-7 --out quick-7.zip

A SCORM package is a ZIP file to upload to a learning platform (Moodle: Add an activity, SCORM
package). It opens the round and reports the score for accuracy from 0 to 100, whether the round
is complete, the time, and each answer. A pupil who comes back continues where they stopped.")]
pub(super) struct Args {
    /// The file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// The page to start from (default: the one in this program, or carrom.html beside it)
    #[arg(long, value_name = "FILE")]
    page: Option<PathBuf>,
    /// Write a SCORM 1.2 package for a learning platform: it opens this round and reports the
    /// result
    #[arg(long, value_name = "CODE", value_parser = round)]
    scorm: Option<Code>,
    /// Replace an existing file
    #[arg(long)]
    force: bool,
}

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let own = own_files(options).map_err(Failure::input)?;
    let page = PageFile::find(args.page.as_deref(), Ok(own)).map_err(Failure::Input)?;
    let code = args.scorm.clone().map(|code| code.with_own(&options.own()));
    let code = code.transpose().map_err(Failure::input)?;
    let document = page.document(code.as_ref()).map_err(Failure::Input)?;
    written::write_named_beside(&[(args.out.clone(), document)], args.force)
}

/// Reads the code of a round whose questions are the same for everyone.
fn round(text: &str) -> Result<Code, String> {
    let code = Code::read(text).map_err(|error| error.to_string())?;
    code.same_for_all()
}

/// The files in the given folders, under the paths that a page uses for them; or the errors in them.
pub(super) fn own_files(options: &GlobalOptions) -> Result<Vec<OwnFile>, String> {
    let folders = [&options.levels, &options.lessons, &options.concepts];
    if folders.iter().all(|it| it.is_empty()) {
        return Ok(Vec::new());
    }
    let problems: Vec<_> = options.problems().iter().map(ToString::to_string).collect();
    if !problems.is_empty() {
        return Err(problems.join("\n"));
    }
    add_all(options).map_err(|error| error.to_string())
}

fn add_all(options: &GlobalOptions) -> Result<Vec<OwnFile>, FileError> {
    let mut own = Vec::new();
    for folder in &options.levels {
        let mut packs = add(&mut own, folder, "toml", &pack(folder))?;
        packs.sort_by_key(|inner| pack_order(inner));
        for inner in packs {
            add(&mut own, &inner, "toml", &pack(&inner))?;
        }
    }
    for folder in &options.lessons {
        add(&mut own, folder, "md", "lessons")?;
    }
    for folder in &options.concepts {
        add(&mut own, folder, "toml", "concepts")?;
    }
    Ok(own)
}

/// The path that a page uses for a folder of levels.
fn pack(folder: &Path) -> String {
    let name = folder.file_name().unwrap_or_default();
    format!("levels/{}", name.display())
}

/// Adds the files of a folder, and returns the folders in it.
fn add(
    own: &mut Vec<OwnFile>,
    folder: &Path,
    ending: &str,
    place: &str,
) -> Result<Vec<PathBuf>, FileError> {
    let list = files::list(folder, ending, MOST_FILES)?;
    for path in &list.files {
        let bytes = files::read(path, files::LARGEST)?;
        let name = path.file_name().unwrap_or_default().display();
        own.push((
            format!("{place}/{name}"),
            String::from_utf8_lossy(&bytes).into_owned(),
        ));
    }
    Ok(list.folders)
}
