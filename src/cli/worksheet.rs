//! `carrom worksheet`: a round of the quiz on paper.

use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Context, anyhow};

use super::{Failure, Options, print};
use crate::paper::worksheet::Worksheet;
use crate::quiz::{Code, Course, CourseKind, Round};

/// Write a round of the quiz as a worksheet, with its key
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  carrom worksheet --seed 7 --count 12 --out sheets
                                a mixed round of 12 questions
  carrom worksheet --code speeds-3 --title \"Physics 10b\" --out sheets
                                any round that has a code

Writes worksheet.html, the questions with room to answer, and key.html, the worked solutions
with the wrong answers to listen for: two files, so that the sheet can be printed and handed
on without the key. worksheet.md and key.md say the same in Markdown, with their pictures in
the folder pictures. Open an HTML file in a browser and print it on A4; nothing else is needed.

The code on the sheet opens the same round on a screen: carrom quiz --code mixed12-7")]
pub(super) struct Args {
    /// Questions of a mixed round, with --seed: 1 to 60 [default: 10]
    #[arg(long, value_name = "K", value_parser = count, allow_negative_numbers = true)]
    count: Option<usize>,
    /// A round by its code, in place of --seed and --count: mixed12-7, speeds-7, exam-7
    #[arg(long, value_name = "CODE", value_parser = super::code, conflicts_with = "count")]
    code: Option<Code>,
    /// The folder to write into; made where it is not there
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// The heading
    #[arg(long, value_name = "TEXT", allow_hyphen_values = true)]
    title: Option<String>,
    /// One document: the key in worksheet.html and worksheet.md too, behind the questions
    #[arg(long)]
    with_key: bool,
    /// Replace files of these names that are there already
    #[arg(long)]
    force: bool,
}

/// The folder of the pictures for Markdown.
const PICTURES: &str = "pictures";

pub(super) fn run(args: &Args, options: &Options) -> Result<ExitCode, Failure> {
    let code = code(args, options).map_err(Failure::Input)?;
    let code = code.with_own(&options.own());
    let round = Round::of(code.map_err(|error| Failure::Input(anyhow!(error)))?);
    let worksheet = Worksheet::new(&round, args.title.as_deref());
    let files = files(&worksheet, args.with_key);
    let written = write(args, &files)?;
    print(written.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

/// The code of the round that is asked for.
fn code(args: &Args, options: &Options) -> anyhow::Result<Code> {
    match (&args.code, options.seed) {
        (Some(_), Some(_)) => Err(anyhow!(
            "expected --seed or --code, not both: a code has its seed in it"
        )),
        (Some(code), None) => Ok(code.clone()),
        (None, Some(seed)) => {
            let kind = CourseKind::Mixed;
            let course = match args.count {
                Some(count) => Course::of(kind, count),
                None => Course::new(kind),
            };
            Ok(Code { course, seed })
        }
        (None, None) => Err(anyhow!(
            "expected --seed N or --code CODE, to fix the questions"
        )),
    }
}

/// What is to be written: names below the folder, with content.
fn files(worksheet: &Worksheet, with_key: bool) -> Vec<(String, String)> {
    let mut files = Vec::new();
    let mut file = |name: &str, content: String| files.push((name.to_owned(), content));
    let sheet = worksheet.sheet_markdown(PICTURES);
    let key = worksheet.key_markdown(PICTURES);
    if with_key {
        file("worksheet.html", worksheet.html_with_key());
        file("worksheet.md", format!("{sheet}\n---\n\n{key}"));
    } else {
        file("worksheet.html", worksheet.sheet_html());
        file("worksheet.md", sheet);
        file("key.html", worksheet.key_html());
        file("key.md", key);
    }
    for picture in worksheet.pictures() {
        let name = format!("{PICTURES}/{}.svg", picture.name);
        file(&name, picture.svg.file());
    }
    files
}

/// Writes all files, or none where one is there already and may not be replaced; gives
/// the names of the documents.
fn write(args: &Args, files: &[(String, String)]) -> anyhow::Result<String> {
    let there =
        |path: PathBuf| anyhow!("{}: is there already (--force replaces it)", path.display());
    if !args.force {
        for (name, _) in files {
            let path = args.out.join(name);
            // A link that leads nowhere is there too.
            if fs::symlink_metadata(&path).is_ok() {
                return Err(there(path));
            }
        }
    }
    let has_pictures = files.iter().any(|(name, _)| name.starts_with(PICTURES));
    let folder = match has_pictures {
        true => args.out.join(PICTURES),
        false => args.out.clone(),
    };
    fs::create_dir_all(&folder).with_context(|| folder.display().to_string())?;
    let mut written = String::new();
    for (name, content) in files {
        let path = args.out.join(name);
        let mut options = OpenOptions::new();
        options.write(true);
        if args.force {
            options.create(true).truncate(true);
        } else {
            options.create_new(true);
        }
        let mut file = match options.open(&path) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => return Err(there(path)),
            opened => opened.with_context(|| path.display().to_string())?,
        };
        file.write_all(content.as_bytes())
            .with_context(|| path.display().to_string())?;
        if !name.starts_with(PICTURES) {
            written += &format!("{}\n", path.display());
        }
    }
    Ok(written)
}

fn count(text: &str) -> Result<usize, String> {
    let most = Course::MOST;
    let count = text.parse().ok();
    count
        .filter(|count| (1..=most).contains(count))
        .ok_or_else(|| format!("expected a number from 1 to {most}"))
}
