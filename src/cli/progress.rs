//! `carrom progress`: opens the screen, or prints what was done.

use std::process::ExitCode;

use anyhow::anyhow;

use super::{Failure, Options, print};
use crate::messages::{Done, Request, Wish};
use crate::progress::{csv, json};
use crate::store::Store;

/// Open what you have done so far, or print it.
///
/// Every answer is kept, of each player by name (--player). With --csv or --json
/// nothing is opened: the answers are printed, one a row, or with what follows from
/// them as one JSON object.
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
}

impl Args {
    /// Whether something is to be printed rather than opened.
    pub(super) fn prints(&self) -> bool {
        self.json || self.csv
    }
}

pub(super) fn run(args: &Args, options: &Options) -> Result<ExitCode, Failure> {
    let folder = options.data_dir();
    let mut store = folder.map_or_else(Store::nowhere, |folder| Store::in_folder(&folder));
    let player = (!args.everyone).then(|| options.player_name());
    let answer = store.answer(&Request {
        ticket: 0,
        wish: Wish::Recall(player),
    });
    if let Some(notice) = answer.notice {
        eprintln!("carrom: {notice}");
    }
    let Done::Recalled(recalled) = answer.done else {
        return Err(anyhow!("the answers could not be looked up").into());
    };
    let history = recalled.map_err(|reason| anyhow!(reason))?;
    let text = if args.csv {
        csv(&history.attempts).map_err(|reason| anyhow!(reason))?
    } else {
        format!("{}\n", json(&history.attempts, history.now_s))
    };
    print(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
