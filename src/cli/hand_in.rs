//! `carrom hand-in` and `carrom gather`: the answers of a class.

use std::path::PathBuf;

use anyhow::{Context, anyhow};

use super::written::{NamedFile, named_file, write_named_beside};
use super::{Failure, GlobalOptions, progress};
use crate::files::{self, Document, escape_control_lines};
use crate::gradebook::{Gradebook, HandIn, beliefs_csv, items_csv, learning_csv, pupils_csv};
use crate::numbers::counted;
use crate::paper;
use crate::quiz::Code;

/// Write your answers to one small file for your teacher
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  carrom hand-in --player Ada --class 10b
                                writes hand-in-ada.json, with all of Ada's answers
  carrom hand-in --code mixed-7 --out ada.json
                                the answers of one round

The file contains your name, your class, and each answer with its question, the true answer and
the points. Your teacher puts all files into one folder, then runs
carrom gather FOLDER --out class.html")]
pub(super) struct HandInArgs {
    /// The name of your class, as your teacher writes it
    #[arg(long, value_name = "NAME")]
    class: Option<String>,
    /// Only the answers of this round; can be repeated
    #[arg(long, value_name = "CODE", value_parser = Code::read)]
    code: Vec<Code>,
    /// The file to write [default: hand-in-NAME.json]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Replace an existing file
    #[arg(long)]
    force: bool,
}

/// Combine the files of a class into a gradebook
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  carrom gather handed-in --out class.html
                                tables to print, and a page for each pupil
  carrom gather handed-in --out class.csv
                                class.csv, class-items.csv and class-beliefs.csv, and
                                class-learning.csv after the rounds before-1 and after-1

  carrom gather ~/.local/share/carrom/handed-in --class 10b --out class.html
                                what 10b has handed in from devices (carrom class --host)

carrom reads every .json file in the folder. A pupil or an answer that occurs twice is counted
once; pupils with the same name are distinguished by their answers. carrom reports files that it
cannot read and continues with the others. Exit status: 0 success, 2 if no file can be read.")]
pub(super) struct GatherArgs {
    /// The folder with the files
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// The file to write, .html or .csv
    #[arg(long, value_name = "FILE")]
    #[arg(value_parser = |path: &str| named_file(path, ["html", "csv"]))]
    out: NamedFile,
    /// Only the files of this class, as named in the files
    #[arg(long, value_name = "NAME")]
    class: Option<String>,
    /// A list of the pupils, one name per line, to report who has handed in nothing
    #[arg(long, value_name = "FILE")]
    class_list: Option<PathBuf>,
    /// Replace existing files
    #[arg(long)]
    force: bool,
}

pub(super) fn hand_in(args: &HandInArgs, options: &GlobalOptions) -> Result<(), Failure> {
    let player = options.player_name();
    let mut attempts = progress::recall(&mut options.store(), Some(player.clone()))?.attempts;
    if !args.code.is_empty() {
        let codes: Vec<String> = args.code.iter().map(ToString::to_string).collect();
        attempts.retain(|it| codes.contains(&it.round()));
    }
    let answered = attempts.len();
    let hand_in = HandIn::new(&player, args.class.as_deref().unwrap_or_default(), attempts);
    let left_out = answered - hand_in.attempts.len();
    if left_out > 0 {
        let answers = counted(left_out, "answer");
        eprintln!("carrom: left out {answers} that match no question in this version");
    }
    if hand_in.attempts.is_empty() {
        let of = if args.code.is_empty() {
            ""
        } else {
            " in this round"
        };
        let message =
            format!("{player} has no answers{of} to hand in; use --player for another name");
        return Err(Failure::input(message));
    }
    let usual = || hand_in.file_name().into();
    let path = args.out.clone().unwrap_or_else(usual);
    let text = hand_in.text().map_err(|reason| anyhow!(reason))?;
    write_named_beside(&[(path, text)], args.force)
}

pub(super) fn gather(args: &GatherArgs, options: &GlobalOptions) -> Result<(), Failure> {
    let shown = args.folder.display();
    let book = Gradebook::of_folder(&args.folder, args.class.as_deref());
    let book = book.with_context(|| format!("cannot read {shown}"));
    let mut book = book.map_err(Failure::Input)?;
    if let Some(path) = &args.class_list {
        let list = files::read(path, files::LARGEST).map_err(Failure::input)?;
        let list = String::from_utf8_lossy(&list);
        book.look_for(list.trim_start_matches('\u{feff}').lines());
    }
    for note in &book.notes {
        let note = options.printed().text(note);
        eprintln!("carrom: {}", escape_control_lines(&note));
    }
    if book.pupils.is_empty() {
        let of = match &args.class {
            Some(name) => format!(" for the class {name}"),
            None => String::new(),
        };
        let message = format!("{shown} contains no file from carrom hand-in{of}");
        return Err(Failure::input(message));
    }
    let documents = documents(&book, &args.out).map_err(|reason| anyhow!(reason))?;
    write_named_beside(&documents, args.force)
}

/// The gradebook in one file, or as tables.
fn documents(book: &Gradebook, out: &NamedFile) -> Result<Vec<Document>, String> {
    let (path, results) = (&out.path, book.results());
    if !out.is_second {
        return Ok(vec![(path.clone(), paper::gradebook::html(&results))]);
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let beside = |what: &str| path.with_file_name(format!("{stem}-{what}.csv"));
    let mut documents = vec![
        (path.clone(), pupils_csv(&results)?),
        (beside("items"), items_csv(&results)?),
        (beside("beliefs"), beliefs_csv(&results)?),
    ];
    documents.extend(learning_csv(&results)?.map(|text| (beside("learning"), text)));
    Ok(documents)
}
