//! `carrom replay`: replays a saved or exported game and prints what happens.

use std::path::PathBuf;

use anyhow::anyhow;
use serde::{Serialize, Serializer};
use serde_json::json;

use super::{Failure, given, print, print_json};
use crate::game::pieces::pocketed;
use crate::game::{
    Coin, Fingerprint, Game, GameSetup, Piece, RecordError, Ruling, SavedGame, Seat, SeatNames,
    Strike, Team,
};
use crate::numbers::counted;
use crate::physics::units::mm_from_m;

/// Replay a saved or exported game and print what the referee says
///
/// carrom plays every move again with the engine and the laws, and the game has to end as
/// the file states, bit for bit: the same coins in the same positions. If it does not, or if
/// a move is impossible, the exit status is 2 and the message names the line.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The saved or exported game; - reads standard input
    file: PathBuf,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let (saved, game) = given::read(&args.file, SavedGame::LARGEST_FILE, SavedGame::read)?;
    let moves = happenings(&saved).map_err(|error| anyhow!("{}: {error}", args.file.display()))?;
    let report = ReplayReport::of(&saved, &game, moves);
    match args.json {
        true => print_json(&report),
        false => print(report.text(saved.record.strokes()).as_bytes()),
    }
}

#[derive(Debug, Serialize)]
struct ReplayedMove {
    r#move: usize,
    seat: Seat,
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    strike: Option<Strike>,
    pocketed: Vec<Piece>,
    #[serde(serialize_with = "announcements")]
    rulings: Vec<Ruling>,
}

/// What the referee announced, without the effects.
fn announcements<S: Serializer>(rulings: &[Ruling], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(rulings.iter().map(|it| {
        let law = it.law.map(|law| law.to_string());
        json!({ "law": law, "text": it.text })
    }))
}

/// What `--json` prints.
#[derive(Debug, Serialize)]
struct ReplayReport {
    player: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    names: Option<SeatNames>,
    setup: GameSetup,
    moves: Vec<ReplayedMove>,
    r#final: ReplayEnd,
}

/// The state of the game after the last move.
#[derive(Debug, Serialize)]
struct ReplayEnd {
    stage: &'static str,
    board: u8,
    turn: Seat,
    points: [u8; 2],
    games: [u8; 2],
    coins: Vec<Lying>,
    fingerprint: String,
}

#[derive(Debug, Serialize)]
struct Lying {
    piece: Piece,
    at_mm: [f64; 2],
}

/// All moves, replayed.
fn happenings(saved: &SavedGame) -> Result<Vec<ReplayedMove>, RecordError> {
    let mut happenings = Vec::new();
    saved.record.play_through(|before, made, shot, rulings| {
        happenings.push(ReplayedMove {
            r#move: happenings.len() + 1,
            seat: before.seat(),
            kind: made.into(),
            strike: made.strike().copied(),
            pocketed: shot.map_or_else(Vec::new, |shot| pocketed(before.coins(), &shot)),
            rulings,
        });
    })?;
    Ok(happenings)
}

impl ReplayReport {
    fn of(saved: &SavedGame, game: &Game, moves: Vec<ReplayedMove>) -> Self {
        let score = game.score();
        let lying = |coin: &Coin| Lying {
            piece: coin.piece,
            at_mm: coin.at.to_array().map(mm_from_m),
        };
        Self {
            player: saved.player.clone(),
            names: Some(&saved.company.names)
                .filter(|names| **names != SeatNames::default())
                .cloned(),
            setup: saved.record.setup,
            moves,
            r#final: ReplayEnd {
                stage: game.stage().into(),
                board: game.board_number(),
                turn: game.seat(),
                points: Team::BOTH.map(|team| game.points()[team]),
                games: Team::BOTH.map(|team| score.games[team]),
                coins: game.coins().iter().map(lying).collect(),
                fingerprint: Fingerprint::of(game).to_string(),
            },
        }
    }

    /// The report as text, for a game of `strokes` strokes.
    fn text(&self, strokes: usize) -> String {
        let mut text = String::new();
        let name = |seat| match self.names.as_ref().map_or("", |names| names.of(seat)) {
            "" => format!("{seat:?}"),
            name => name.to_owned(),
        };
        for made in &self.moves {
            let who = name(made.seat);
            let what = match (&made.strike, made.kind) {
                (Some(strike), _) => {
                    let speed = strike.velocity.length();
                    format!("{who} strikes at {speed:.2} m/s")
                }
                (None, "no_place") => format!("{who} has no position for the striker"),
                (None, "next_board") => "the next board".into(),
                (None, _) => format!("{who} lays the coins out"),
            };
            text += &format!("{:4}  {what}\n", made.r#move);
            for ruling in &made.rulings {
                text += &format!("      {}\n", ruling.announced());
            }
        }
        let end = &self.r#final;
        let [points, games] = [end.points, end.games].map(|[a, b]| format!("{a} : {b}"));
        text += &format!(
            "\nafter {}: board {}, points {points}, games {games}, turn {}\n",
            counted(strokes, "stroke"),
            end.board,
            name(end.turn),
        );
        for Lying { piece, at_mm } in &end.coins {
            let [x, y] = at_mm;
            text += &format!("      {:8} {x:9.2} {y:9.2} mm\n", piece.to_string());
        }
        text + &format!("fingerprint {}, the same as in the file\n", end.fingerprint)
    }
}
