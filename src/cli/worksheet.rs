//! `carrom worksheet`: a round of the quiz on paper.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Context;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use strum::VariantNames;

use super::{Failure, GlobalOptions, print_names, written};
use crate::files::Document;
use crate::paper::Paper;
use crate::paper::worksheet::{Worksheet, WorksheetPicture, cards};
use crate::quiz::{Code, Course, CourseKind, Round};

/// Write a round of the quiz as a worksheet with its answer key
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  carrom worksheet --seed 7 --count 12 --out sheets
                                a mixed round of 12 questions
  carrom worksheet --code speeds-3 --title \"Physics 10b\" --out sheets
                                a round on one topic, by its code
  carrom worksheet --set ours.toml --out sheets
                                the questions that you have chosen
  carrom worksheet --seed 7 --versions 2 --paper letter --out sheets
                                two versions, for pupils who sit side by side, on US paper
  carrom worksheet --code speeds-3 --moodle speeds.xml
                                the same questions for Moodle's question bank
  carrom worksheet --cards 32 --out sheets
                                cards A to D to vote with, one sheet per pupil to fold twice

Writes worksheet.html, the questions with space for the answers, and key.html, the worked
solutions with the wrong answers to listen for: two files, so that you can print and hand out
the sheet without the key. worksheet.md and key.md contain the same in Markdown, with their
pictures in the folder pictures. Open an HTML file in a browser and print it; nothing else is
needed. With several versions, each question is of the same kind and difficulty, with different
numbers: worksheet-a.html, key-a.html, worksheet-b.html and so on. The file for Moodle has all
answers with their feedback and the pictures; import it as Moodle XML (carrom guide worksheets).

The code on the sheet opens the same round on a screen: carrom quiz --code mixed12-7")]
pub(super) struct Args {
    /// Number of questions in a mixed round, with --seed: 1 to 60 [default: 10]
    #[arg(long, value_name = "K", value_parser = count, allow_negative_numbers = true)]
    count: Option<usize>,
    /// The code of the round, instead of --seed and --count: mixed12-7, speeds-7, exam-7
    #[arg(long, value_name = "CODE", value_parser = Code::read, conflicts_with = "count")]
    pub(super) code: Option<Code>,
    /// The file of the set for the worksheet: questions that you have chosen
    #[arg(long, value_name = "FILE", conflicts_with_all = ["code", "count"])]
    pub(super) set: Option<PathBuf>,
    /// The folder to write to; created if it does not exist
    #[arg(long, value_name = "DIR", required_unless_present = "moodle")]
    out: Option<PathBuf>,
    /// Write the questions for Moodle to this file, instead of the sheets or, with --out, in
    /// addition to them
    #[arg(long, value_name = "FILE.xml")]
    moodle: Option<PathBuf>,
    /// The heading
    #[arg(long, value_name = "TEXT", allow_hyphen_values = true)]
    title: Option<String>,
    /// Put the key after the questions, in worksheet.html and worksheet.md
    #[arg(long)]
    with_key: bool,
    /// Number of versions with different numbers, for pupils who sit side by side: 1 to 4
    #[arg(long, value_name = "N", default_value_t = 1,
          value_parser = clap::value_parser!(u8).range(1..=4))]
    versions: u8,
    /// The paper to print on
    #[arg(long, value_name = "PAPER", default_value = "a4",
          value_parser = PossibleValuesParser::new(Paper::VARIANTS.iter().copied()).map(|it| it.parse::<Paper>().unwrap_or_default()))]
    paper: Paper,
    /// Instead of a worksheet, write N sheets of voting cards A to D, to fold twice
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "1",
          value_parser = clap::value_parser!(u16).range(1..=200),
          requires = "out",
          conflicts_with_all = ["count", "code", "set", "with_key", "versions", "moodle"])]
    cards: Option<u16>,
    /// Replace an existing worksheet, its key and its pictures
    #[arg(long)]
    force: bool,
}

/// The folder with the pictures of the Markdown files.
const PICTURES: &str = "pictures";

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    if let (Some(count), Some(out)) = (args.cards, &args.out) {
        let path = out.join("cards.html");
        let document = (path, cards(count.into(), args.paper));
        return written::write_named(&[document], args.force);
    }
    let own = options
        .own_with(args.set.as_deref())
        .map_err(Failure::input)?;
    let code = match own.sets.first() {
        Some(set) => Ok(Code::of_set(set)),
        None => code(args, options),
    };
    let code = code.and_then(|code| code.with_own(&own)?.same_for_all());
    let round = Round::of(code.map_err(Failure::input)?);
    let own = match round.course().kind {
        CourseKind::Own(_) | CourseKind::Set(_) => options.of_own(args.set.as_deref()),
        _ => String::new(),
    };
    let versions: Vec<_> = (1..=args.versions)
        .map(|number| round.version(number.into()))
        .collect();
    let worksheet = |(round, letter)| Worksheet {
        version: (args.versions > 1).then_some(letter),
        own: own.clone(),
        paper: args.paper,
        ..Worksheet::new(round, args.title.as_deref())
    };
    let worksheets: Vec<_> = versions.iter().zip('A'..).map(worksheet).collect();
    let mut all = Vec::new();
    if let Some(out) = &args.out {
        all.extend(worksheets.iter().flat_map(|it| files(it, args, out)));
    }
    if let Some(moodle) = &args.moodle {
        all.push((moodle.clone(), Worksheet::moodle_xml(&worksheets)));
    }
    written::write(&all, args.force)?;
    if let Some(out) = args.out.as_ref().filter(|_| args.force) {
        for worksheet in &worksheets {
            remove_others(out, &ending(worksheet), &all)?;
        }
    }
    print_names(all.iter().filter(|(path, _)| !is_picture(path)))
}

fn code(args: &Args, options: &GlobalOptions) -> Result<Code, String> {
    if let Some(code) = &args.code {
        return Ok(code.clone());
    }
    let seed = options.seed;
    let seed =
        seed.ok_or("expected --seed N or --code CODE, to fix the questions, or --set FILE")?;
    let course = match args.count {
        Some(count) => Course::of(CourseKind::Mixed, count),
        None => Course::new(CourseKind::Mixed),
    };
    Ok(Code { course, seed })
}

/// The ending of a version's names: "-a"; empty if there is only one version.
fn ending(worksheet: &Worksheet) -> String {
    let version = worksheet.version.map(|it| it.to_ascii_lowercase());
    version.map_or_else(String::new, |letter| format!("-{letter}"))
}

/// The files to write into a folder.
fn files(worksheet: &Worksheet, args: &Args, out: &Path) -> Vec<Document> {
    let version = ending(worksheet);
    let mut files = Vec::new();
    let mut file = |name: &str, content: String| {
        let named = name.replacen('.', &format!("{version}."), 1);
        files.push((out.join(named), content));
    };
    let pictures = format!("{PICTURES}{version}");
    let sheet = worksheet.sheet_markdown(&pictures);
    let key = worksheet.key_markdown(&pictures);
    if args.with_key {
        file("worksheet.html", worksheet.html_with_key());
        file("worksheet.md", format!("{sheet}\n---\n\n{key}"));
    } else {
        file("worksheet.html", worksheet.sheet_html());
        file("worksheet.md", sheet);
        file("key.html", worksheet.key_html());
        file("key.md", key);
    }
    for picture in worksheet.pictures() {
        let path = out.join(&pictures).join(picture.name);
        files.push((path, picture.svg.file()));
    }
    files
}

fn is_picture(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "svg")
}

/// Removes files of another round's worksheet from the folder: a version's key that does not
/// belong to these questions, and unused pictures.
fn remove_others(out: &Path, version: &str, files: &[Document]) -> anyhow::Result<()> {
    let keys = ["html", "md"].map(|kind| out.join(format!("key{version}.{kind}")));
    let mut others: Vec<_> = keys.into_iter().filter(|path| path.is_file()).collect();
    let folder = out.join(format!("{PICTURES}{version}"));
    if let Ok(entries) = fs::read_dir(&folder) {
        let names = entries.flatten().map(|entry| entry.file_name());
        let pictures =
            names.filter(|name| name.to_str().is_some_and(WorksheetPicture::is_file_name));
        others.extend(pictures.map(|name| folder.join(name)));
    }
    for path in others {
        if !files.iter().any(|(written, _)| *written == path) {
            let removed = fs::remove_file(&path);
            removed.with_context(|| format!("cannot remove {}", path.display()))?;
        }
    }
    Ok(())
}

fn count(text: &str) -> Result<usize, String> {
    let most = Course::MOST;
    let count = text.parse().ok().filter(|it| (1..=most).contains(it));
    count.ok_or_else(|| format!("expected a number from 1 to {most}"))
}
