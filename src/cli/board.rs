//! `carrom board`: opens a board for one player, or prints it.

use jiff::Zoned;
use jiff::civil::Date;
use serde::Serialize;

use super::{Failure, print_json};
use crate::game::opponent::clearing;
use crate::game::{BoardCode, Fingerprint, Game, Move, Strike};
use crate::physics::units::mm_from_m;

/// Open the board of the day: six coins to clear in the fewest strokes
///
/// Every day has its own board, the same for everyone. Any number up to 999999 is the code of
/// another board. --json prints the board instead: its coins, its par, and the strokes with which
/// the computer clears it.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The board to open, by its code: a date or a number (default: today's board)
    #[arg(value_parser = BoardCode::parse)]
    code: Option<BoardCode>,
    /// The date of the board to open, such as 2026-11-26
    #[arg(long, value_name = "DATE", conflicts_with = "code", value_parser = day)]
    date: Option<BoardCode>,
    /// Print one JSON object instead of opening the board
    #[arg(long)]
    pub(super) json: bool,
}

fn day(text: &str) -> Result<BoardCode, String> {
    let day = text.parse::<Date>().ok();
    let code = day.and_then(|day| BoardCode::of_day(day).ok());
    code.ok_or_else(|| "expected a date from 2000 on, such as 2026-11-26".into())
}

impl Args {
    /// The code of the board; `None` for today's.
    pub(super) fn code(&self) -> Option<BoardCode> {
        self.code.or(self.date)
    }
}

/// What `--json` prints.
#[derive(Debug, Serialize)]
struct PrintedBoard {
    code: BoardCode,
    title: String,
    coins_mm: Vec<[f64; 2]>,
    /// The fingerprint of the board before the first stroke.
    fingerprint: String,
    par: Option<usize>,
    solution: Vec<SolutionStroke>,
}

#[derive(Debug, Serialize)]
struct SolutionStroke {
    #[serde(flatten)]
    strike: Strike,
    coins_left: usize,
    /// The fingerprint of the board after the stroke.
    fingerprint: String,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let today = || BoardCode::of_day(Zoned::now().date());
    let code = args.code().map_or_else(today, Ok);
    let code = code.map_err(|error| Failure::input(error.to_string()))?;
    let mut game = Game::new(code.setup());
    let at_mm = |at: glam::DVec2| at.to_array().map(mm_from_m);
    let strikes = clearing(code);
    let mut report = PrintedBoard {
        code,
        title: code.title(),
        coins_mm: game.coins().iter().map(|coin| at_mm(coin.at)).collect(),
        fingerprint: Fingerprint::of(&game).to_string(),
        par: strikes.as_ref().map(Vec::len),
        solution: Vec::new(),
    };
    for strike in strikes.unwrap_or_default() {
        let made = Move::Strike(strike).make(&mut game);
        made.map_err(|error| Failure::Work(error.into()))?;
        report.solution.push(SolutionStroke {
            strike,
            coins_left: game.coins().len(),
            fingerprint: Fingerprint::of(&game).to_string(),
        });
    }
    print_json(&report)
}
