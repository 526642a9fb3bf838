//! `carrom progress`: opens the screen, prints the answers or writes a report.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;

use anyhow::anyhow;
use serde_json::Value;

use super::written::{NamedFile, named_file, write_beside};
use super::{Failure, GlobalOptions, print};
use crate::files::{Document, escape_control_lines};
use crate::game::Results;
use crate::lessons::Bookmark;
use crate::levels::Starred;
use crate::messages::{FileKind, History, StoreCall, StoreReply, StoreRequest};
use crate::paper::report::{Report, Sources};
use crate::path::{NextStep, PathSoFar};
use crate::progress::{csv, json};
use crate::store::Store;

/// Open your progress, or print it
///
/// carrom keeps every answer, for each player by name (--player). --csv prints the answers,
/// one per row; --json prints them with a summary as one JSON object; --report writes a page
/// for a portfolio or a teacher. None of these opens a screen.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Print one JSON object: a summary, and every answer
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Print every answer as comma-separated values, for a spreadsheet
    #[arg(long)]
    csv: bool,
    /// Include everyone who plays on this computer
    #[arg(long)]
    everyone: bool,
    /// Write a one-page report with pictures, to print (.html) or to edit (.md); with
    /// --everyone one page per player
    #[arg(long, value_name = "FILE", conflicts_with_all = ["json", "csv"])]
    #[arg(value_parser = |path: &str| named_file(path, ["html", "md"]))]
    report: Option<NamedFile>,
    /// Replace an existing report and its pictures
    #[arg(long, requires = "report")]
    force: bool,
}

impl Args {
    /// Whether the command prints or writes something rather than opening a screen.
    pub(super) fn prints(&self) -> bool {
        self.json || self.csv || self.report.is_some()
    }
}

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let mut store = options.store().only_looking();
    let player = options.player_name();
    let whose = (!args.everyone).then(|| player.clone());
    let history = recall(&mut store, whose)?;
    if let Some(file) = &args.report {
        let players = match args.everyone {
            true => players(&history),
            false => vec![player.clone()],
        };
        let documents = reports(&players, &history, &mut store, file, options)?;
        return write_beside(&documents, args.force);
    }
    let text = if args.csv {
        csv(&history.attempts).map_err(|reason| anyhow!(reason))?
    } else {
        let (next, games) = match args.everyone {
            true => (None, Value::Null),
            false => {
                let next = next(&history, &kept(&player, &mut store)?, options);
                (Some(next), games(&player, &mut store)?)
            }
        };
        let (attempts, observed) = (&history.attempts, &history.observations);
        let text = json(attempts, observed, next.as_deref(), games);
        text.map_err(|reason| anyhow!(reason))? + "\n"
    };
    print(text.as_bytes())
}

/// The answers of a player, or of everyone.
pub(super) fn recall(store: &mut Store, whose: Option<String>) -> anyhow::Result<History> {
    match ask(store, StoreRequest::Recall(whose)) {
        StoreReply::Recalled(recalled) => Ok(*recalled.map_err(|reason| anyhow!(reason))?),
        _ => Err(anyhow!("the answers could not be read")),
    }
}

/// Everyone who has answered a question, sorted by name.
fn players(history: &History) -> Vec<String> {
    let names = history.attempts.iter().map(|it| it.player.clone());
    names.collect::<BTreeSet<_>>().into_iter().collect()
}

/// A report for each of these players, one page each.
fn reports(
    players: &[String],
    history: &History,
    store: &mut Store,
    file: &NamedFile,
    options: &GlobalOptions,
) -> anyhow::Result<Vec<Document>> {
    let (shelf, book) = (options.shelf(), options.book());
    let mut all = Vec::new();
    for player in players {
        let kept = kept(player, store)?;
        let own = history.attempts.iter().filter(|it| it.player == *player);
        let seen = { history.observations.iter() }.filter(|it| it.player == *player);
        let history = History {
            attempts: own.cloned().collect(),
            observations: seen.cloned().collect(),
            calendar: history.calendar.clone(),
        };
        let next = next(&history, &kept, options);
        all.push((player, history, kept, next));
    }
    let reports = all.iter().map(|(player, history, (marks, stars), next)| {
        Report::new(&Sources {
            player,
            history,
            marks,
            stars,
            next,
            levels: shelf.library(),
            lessons: book.library(),
        })
    });
    Ok(documents(&reports.collect::<Vec<_>>(), file))
}

type MarksAndStars = (BTreeMap<String, Bookmark>, Vec<Starred>);

fn kept(player: &str, store: &mut Store) -> anyhow::Result<MarksAndStars> {
    let stars = match ask(store, StoreRequest::Stars(player.to_owned())) {
        StoreReply::Stars(stars) => stars.map_err(|reason| anyhow!(reason))?,
        _ => return Err(anyhow!("the stars could not be read")),
    };
    let marks = match ask(store, StoreRequest::Marks(player.to_owned())) {
        StoreReply::Marks(marks) => marks.map_err(|reason| anyhow!(reason))?,
        _ => return Err(anyhow!("the bookmarks could not be read")),
    };
    Ok((marks, stars))
}

/// The player's results at the table.
fn games(player: &str, store: &mut Store) -> anyhow::Result<Value> {
    let games = match ask(store, StoreRequest::List(FileKind::Game)) {
        StoreReply::Games(games) => games.map_err(|reason| anyhow!(reason))?,
        _ => return Err(anyhow!("the saved games could not be read")),
    };
    let games = games.iter().filter_map(|kept| kept.content.as_deref().ok());
    Ok(serde_json::to_value(Results::of(player, games))?)
}

/// What the player should do next, and why.
fn next(history: &History, (marks, stars): &MarksAndStars, options: &GlobalOptions) -> String {
    let (mut shelf, mut book) = (options.shelf(), options.book());
    book.recall(marks.clone());
    for starred in stars {
        shelf.recall(starred);
    }
    let so_far = PathSoFar {
        attempts: &history.attempts,
        calendar: &history.calendar,
        book: &book,
        shelf: &shelf,
    };
    let NextStep { words, why, .. } = so_far.next_step();
    format!("{words}. {why}")
}

/// Asks the store, and prints its notice if there is one.
fn ask(store: &mut Store, request: StoreRequest) -> StoreReply {
    let answer = store.answer(&StoreCall { ticket: 0, request });
    if let Some(notice) = answer.notice {
        eprintln!("carrom: {}", escape_control_lines(&notice));
    }
    answer.done
}

/// The reports in one file. Pictures of Markdown reports go into a folder such as `report-pictures`
/// beside that file; if there are several reports, each has its own subfolder.
fn documents(reports: &[Report], file: &NamedFile) -> Vec<Document> {
    let path = &file.path;
    if !file.is_second {
        return vec![(path.clone(), Report::html(reports))];
    }
    let stem = path.file_stem().and_then(OsStr::to_str);
    let all = format!("{}-pictures", stem.unwrap_or("report"));
    let (mut texts, mut pictures) = (Vec::new(), Vec::new());
    for (number, report) in (1..).zip(reports) {
        let folder = match reports {
            [_] => all.clone(),
            _ => format!("{all}/{number}"),
        };
        texts.push(report.markdown(&folder));
        for picture in report.pictures() {
            let name = format!("{}.svg", picture.name);
            let picture_path = path.with_file_name(&folder).join(name);
            pictures.push((picture_path, picture.svg.file()));
        }
    }
    let text = (path.clone(), texts.join("\n---\n\n"));
    std::iter::once(text).chain(pictures).collect()
}
