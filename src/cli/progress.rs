//! `carrom progress`: opens the screen, or prints what was done.

use std::ffi::OsStr;
use std::path::PathBuf;

use anyhow::anyhow;

use super::{Failure, GlobalOptions, print, written};
use crate::files::{Document, escape_control_lines};
use crate::messages::{StoreCall, StoreReply, StoreRequest};
use crate::paper::report::{Report, Sources};
use crate::progress::{csv, json};
use crate::store::Store;

/// Open what you have done so far, or print it.
///
/// Every answer is kept, of each player by name (--player). With --csv or --json
/// nothing is opened: the answers are printed, one a row, or with what follows from
/// them as one JSON object. With --report a page for a portfolio or a teacher is written.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Print one JSON object: a summary, and every answer
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Print every answer as comma-separated values, for a spreadsheet
    #[arg(long)]
    csv: bool,
    /// The answers of everyone who plays on this computer
    #[arg(long)]
    everyone: bool,
    /// Write a one-page report with pictures, to be printed (.html) or read on (.md)
    #[arg(long, value_name = "FILE", value_parser = report_file,
          conflicts_with_all = ["json", "csv", "everyone"])]
    report: Option<ReportFile>,
    /// Replace a report that is there already, with its pictures
    #[arg(long, requires = "report")]
    force: bool,
}

/// Where a report is written; its ending says what it is written as.
#[derive(Debug, Clone)]
struct ReportFile {
    path: PathBuf,
    is_markdown: bool,
}

fn report_file(path: &str) -> Result<ReportFile, String> {
    let path = PathBuf::from(path);
    let ending = path.extension().and_then(OsStr::to_str);
    let is_markdown = match ending.map(str::to_lowercase).as_deref() {
        Some("html") => false,
        Some("md") => true,
        _ => return Err("expected a name that ends in .html or .md".into()),
    };
    Ok(ReportFile { path, is_markdown })
}

impl Args {
    /// Whether something is to be printed or written rather than opened.
    pub(super) fn prints(&self) -> bool {
        self.json || self.csv || self.report.is_some()
    }
}

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let mut store = options.store().only_looking();
    let player = options.player_name();
    let whose = (!args.everyone).then(|| player.clone());
    let history = match ask(&mut store, StoreRequest::Recall(whose)) {
        StoreReply::Recalled(recalled) => recalled.map_err(|reason| anyhow!(reason))?,
        _ => return Err(anyhow!("the answers could not be looked up").into()),
    };
    if let Some(file) = &args.report {
        let stars = match ask(&mut store, StoreRequest::Stars(player.clone())) {
            StoreReply::Stars(stars) => stars.map_err(|reason| anyhow!(reason))?,
            _ => return Err(anyhow!("the stars could not be looked up").into()),
        };
        let marks = match ask(&mut store, StoreRequest::Marks(player.clone())) {
            StoreReply::Marks(marks) => marks.map_err(|reason| anyhow!(reason))?,
            _ => return Err(anyhow!("the bookmarks could not be looked up").into()),
        };
        let (shelf, book) = (options.shelf(), options.book());
        let report = Report::new(&Sources {
            player: &player,
            history: &history,
            marks: &marks,
            stars: &stars,
            levels: shelf.library(),
            lessons: book.library(),
        });
        let documents = documents(&report, file);
        return Ok(written::write_beside(&file.path, &documents, args.force)?);
    }
    let text = if args.csv {
        csv(&history.attempts).map_err(|reason| anyhow!(reason))?
    } else {
        json(&history.attempts, &history.calendar).map_err(|reason| anyhow!(reason))? + "\n"
    };
    Ok(print(text.as_bytes())?)
}

/// What the store has to say, after what the player should know of it.
fn ask(store: &mut Store, wish: StoreRequest) -> StoreReply {
    let answer = store.answer(&StoreCall { ticket: 0, wish });
    if let Some(notice) = answer.notice {
        eprintln!("carrom: {}", escape_control_lines(&notice));
    }
    answer.done
}

/// The report in its file; the pictures of one in Markdown go into a folder beside it,
/// which has its name.
fn documents(report: &Report, file: &ReportFile) -> Vec<Document> {
    let path = &file.path;
    if !file.is_markdown {
        return vec![(path.clone(), report.html())];
    }
    let stem = path.file_stem().and_then(OsStr::to_str);
    let folder = format!("{}-pictures", stem.unwrap_or("report"));
    let mut documents = vec![(path.clone(), report.markdown(&folder))];
    for picture in report.pictures() {
        let picture_path = path
            .with_file_name(&folder)
            .join(format!("{}.svg", picture.name));
        documents.push((picture_path, picture.svg.file()));
    }
    documents
}
