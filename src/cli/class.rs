//! `carrom class`: opens a round for a class, writes a report of one, or deletes what is kept about
//! a class.

use std::io::{self, BufRead, IsTerminal, Write};
use std::path::PathBuf;

use anyhow::anyhow;

use super::written::{NamedFile, named_file, write_named_beside};
use super::{Failure, GlobalOptions, Teams, print};
use crate::class::{ClassRound, is_same_class, team_names};
use crate::files::{escape_control_lines, quoted};
use crate::messages::{FileKind, Kept, StoreCall, StoreReply, StoreRequest};
use crate::numbers::counted;
use crate::paper::class_report;
use crate::quiz::Code;
use crate::screens::Route;
use crate::store::{Forgetting, Store};

/// Open a round for a class: teams at one keyboard, hands or cards, or everyone on their own device
///
/// --report writes a page about a saved round, and --forget deletes what is kept about a class;
/// neither opens a screen.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  carrom class --host --class 10b --nicknames
                                everyone on their own device, with a nickname from carrom
  carrom class --report 10b --out 10b.html
                                the latest round of 10b, to read or print
  carrom class --forget 10b     delete the rounds, votes, hand-ins and tables of 10b

carrom guide class explains a round, carrom guide privacy what is kept.")]
pub(super) struct Args {
    /// Let everyone vote on their own phone or laptop, on the local network
    #[arg(long)]
    host: bool,
    /// The port for the class's devices (default: the port of the round you continue, or the first
    /// free one from 8090 on)
    #[arg(long, value_name = "PORT")]
    pub(super) port: Option<u16>,
    /// The page for the class's browsers (default: the one in this program, or carrom.html
    /// beside it)
    #[arg(long, value_name = "FILE")]
    pub(super) page: Option<PathBuf>,
    /// Give the devices nicknames, such as Blue Otter, instead of asking for names
    #[arg(long, requires = "host")]
    nicknames: bool,
    /// The round to play, by its code, such as mixed-7
    #[arg(long, value_name = "CODE", value_parser = Code::read)]
    pub(super) code: Option<Code>,
    /// The file of the set to play: questions that you have chosen
    #[arg(long, value_name = "FILE", conflicts_with = "code")]
    pub(super) set: Option<PathBuf>,
    /// The names of 1 to 8 teams, separated by commas
    #[arg(long, value_name = "A,B,C", conflicts_with = "host")]
    #[arg(value_parser = |names: &str| team_names(names.split(',')))]
    teams: Option<Teams>,
    /// The name of the class, for the exported tables and the pupils' hand-ins
    #[arg(long, value_name = "NAME")]
    class: Option<String>,
    /// Write a report of a round: class-3, or the name of a class for its latest round
    #[arg(long, value_name = "ROUND", requires = "out", conflicts_with_all = OPENING)]
    report: Option<String>,
    /// The file of the report, .html
    #[arg(long, value_name = "FILE", requires = "report")]
    #[arg(value_parser = |path: &str| named_file(path, ["html", "htm"]))]
    out: Option<NamedFile>,
    /// List the results of each participant in the report, too
    #[arg(long, requires = "report")]
    names: bool,
    /// Replace an existing report
    #[arg(long, requires = "report")]
    force: bool,
    /// Delete the rounds, votes, hand-ins and tables of this class
    #[arg(long, value_name = "CLASS", conflicts_with_all = OPENING, conflicts_with = "report")]
    forget: Option<String>,
    /// Delete without asking
    #[arg(long, requires = "forget")]
    yes: bool,
}

/// The options that make sense only for opening a round on the screen.
const OPENING: [&str; 8] = [
    "host",
    "port",
    "page",
    "nicknames",
    "code",
    "set",
    "teams",
    "class",
];

impl Args {
    /// Whether the command prints or writes something rather than opening a screen.
    pub(super) fn prints(&self) -> bool {
        self.report.is_some() || self.forget.is_some()
    }

    /// The screen to open; `code` is the complete code of the round.
    ///
    /// # Errors
    /// If the round cannot be the same for everyone.
    pub(super) fn route(&self, code: Option<Code>) -> Result<Route, String> {
        let name = self.class.clone().unwrap_or_default();
        let code = code.map(Code::same_for_all).transpose()?;
        let teams = self.teams.clone().unwrap_or_default();
        let nicknames = self.nicknames;
        Ok(match self.host {
            true => Route::Host {
                name,
                code,
                nicknames,
            },
            false => Route::Class { name, code, teams },
        })
    }
}

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    match (&args.forget, &args.report, &args.out) {
        (Some(class), ..) => forget(class, args.yes, options),
        (None, Some(round), Some(out)) => report(round, out, args, options),
        // clap requires both.
        _ => Ok(()),
    }
}

/// Deletes what is kept about a class.
fn forget(class: &str, yes: bool, options: &GlobalOptions) -> Result<(), Failure> {
    if is_same_class(class, "") {
        return Err(Failure::input("expected the name of a class, such as 10b"));
    }
    let folder = options
        .data_dir()
        .ok_or_else(|| Failure::input("no data folder is known; set one with --data-dir"))?;
    let found = Forgetting::find(&folder, class).map_err(|reason| anyhow!(reason))?;
    let charset = options.printed();
    let line = |text: String| charset.text(&escape_control_lines(&text)).into_owned();
    if found.files.is_empty() {
        let text = line(format!("nothing is kept about {class}")) + "\n";
        return print(text.as_bytes());
    }
    if !yes {
        let names: String = { found.files.iter() }
            .map(|it| format!("  {it}\n"))
            .collect();
        let count = counted(found.files.len(), "file");
        if !io::stdin().is_terminal() {
            return Err(Failure::input(format!(
                "--yes deletes {count} of {class} without asking:\n{names}"
            )));
        }
        let question = format!(
            "carrom will delete {count} of {class} in {}:\n{names}This cannot be undone. \
             Delete them? Type yes: ",
            folder.display()
        );
        let mut out = io::stderr().lock();
        out.write_all(line(question).as_bytes())?;
        out.flush()?;
        let mut answer = String::new();
        io::stdin().lock().read_line(&mut answer)?;
        if !answer.trim().eq_ignore_ascii_case("yes") {
            return print(b"nothing was deleted\n");
        }
    }
    let (deleted, trouble) = found.delete();
    let deleted = { deleted.iter() }.map(|file| line(format!("deleted {file}")) + "\n");
    print(deleted.collect::<String>().as_bytes())?;
    match trouble {
        Some(reason) => Err(anyhow!(reason).into()),
        None => Ok(()),
    }
}

/// Writes the report of a stored round.
fn report(
    name: &str,
    out: &NamedFile,
    args: &Args,
    options: &GlobalOptions,
) -> Result<(), Failure> {
    let mut store = options.store().with_own(&options.own());
    let kept = rounds(&mut store)?;
    let is_named = |it: &&Kept<ClassRound>| it.name == name;
    let is_of_class = |it: &&Kept<ClassRound>| {
        let round = it.content.as_ref();
        round.is_ok_and(|round| is_same_class(round.class(), name))
    };
    let found = kept.iter().find(is_named);
    let Some(found) = found.or_else(|| kept.iter().find(is_of_class)) else {
        let known = kept.iter().filter_map(|it| {
            let round = it.content.as_ref().ok()?;
            Some(match round.class() {
                "" => it.name.clone(),
                class => format!("{} ({class})", it.name),
            })
        });
        let known: Vec<_> = known.collect();
        return Err(Failure::input(match known.as_slice() {
            [] => "no class round is kept here".to_owned(),
            known => format!(
                "expected one of {}, found {}",
                known.join(", "),
                quoted(name)
            ),
        }));
    };
    let round = match &found.content {
        Ok(round) => round,
        Err(error) => return Err(Failure::input(format!("{}: {error}", found.name))),
    };
    let about = class_report::About {
        day: found.day,
        with_names: args.names,
    };
    let document = (out.path.clone(), class_report::html(round, &about));
    write_named_beside(&[document], args.force)
}

/// The stored rounds, the latest first.
fn rounds(store: &mut Store) -> Result<Vec<Kept<ClassRound>>, Failure> {
    let request = StoreRequest::List(FileKind::Class);
    match store.answer(&StoreCall { ticket: 0, request }).done {
        StoreReply::Classes(kept) => kept.map_err(|reason| anyhow!(reason).into()),
        _ => Err(anyhow!("the rounds could not be read").into()),
    }
}
