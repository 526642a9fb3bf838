//! `carrom replay`: plays a saved or exported game again and prints what happens.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::anyhow;
use serde::Serialize;

use super::{Failure, given, print};
use crate::files::FileErrors;
use crate::game::pieces::piece_of;
use crate::game::{
    Coin, Fingerprint, Game, GameSetup, GameStage, Move, Piece, RecordError, Ruling, SavedGame,
    Seat, Strike, Team,
};
use crate::physics::Shot;
use crate::physics::units::mm_from_m;

/// Play a saved or exported game again and print what the referee says.
///
/// Every move goes through the engine and the laws once more, and the game has to
/// end as the file says, to the last bit: the same coins at the same places. If it
/// does not, or if a move cannot be made, the exit status is 2 and the message names
/// the line.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The game, as carrom keeps or exports it; - reads standard input
    file: PathBuf,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let (saved, game) = read(&args.file).map_err(|fault| Failure::Input(fault.into()))?;
    let moves = happenings(&saved).map_err(|error| anyhow!("{}: {error}", args.file.display()))?;
    let report = if args.json {
        let mut report = serde_json::to_string(&ReplayReport::of(&saved, &game, moves))?;
        report.push('\n');
        report
    } else {
        text(&saved, &game, &moves)
    };
    print(report.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

fn read(file: &Path) -> Result<(SavedGame, Game), FileErrors> {
    let (name, bytes) = given::bytes(file, SavedGame::LARGEST_FILE)?;
    SavedGame::read(&name, &bytes)
}

/// A move and what came of it.
#[derive(Debug, Serialize)]
struct ReplayedMove {
    r#move: usize,
    seat: Seat,
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    strike: Option<Strike>,
    pocketed: Vec<Piece>,
    rulings: Vec<Announced>,
}

/// What the referee announced.
#[derive(Debug, Serialize)]
struct Announced {
    law: Option<String>,
    text: String,
}

/// What `--json` prints.
#[derive(Debug, Serialize)]
struct ReplayReport {
    player: String,
    setup: GameSetup,
    moves: Vec<ReplayedMove>,
    r#final: ReplayEnd,
}

/// How the game stands after its last move.
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

impl From<Ruling> for Announced {
    fn from(ruling: Ruling) -> Self {
        Self {
            law: ruling.law.map(|law| law.to_string()),
            text: ruling.text,
        }
    }
}

/// All moves, made once more.
fn happenings(saved: &SavedGame) -> Result<Vec<ReplayedMove>, RecordError> {
    let mut happenings = Vec::new();
    saved.record.play_through(|before, made, shot, rulings| {
        happenings.push(ReplayedMove {
            r#move: happenings.len() + 1,
            seat: before.seat(),
            kind: kind(made),
            strike: match made {
                Move::Strike(strike) => Some(*strike),
                _ => None,
            },
            pocketed: shot.map_or_else(Vec::new, |shot| pocketed(&shot, &before)),
            rulings: rulings.into_iter().map(Announced::from).collect(),
        });
    })?;
    Ok(happenings)
}

/// What fell, in its order.
fn pocketed(shot: &Shot, before: &Game) -> Vec<Piece> {
    let piece = |disc| piece_of(before.coins(), disc);
    shot.fallen().filter_map(piece).collect()
}

const fn kind(made: &Move) -> &'static str {
    match made {
        Move::Strike(_) => "strike",
        Move::NoPlace => "no_place",
        Move::NextBoard => "next_board",
        Move::LayOut(_) => "lay_out",
    }
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
            setup: *saved.record.setup(),
            moves,
            r#final: ReplayEnd {
                stage: match game.stage() {
                    GameStage::Playing => "playing",
                    GameStage::BoardOver(_) => "board_over",
                    GameStage::GameOver(_) => "game_over",
                    GameStage::MatchOver(_) => "match_over",
                },
                board: game.board_number(),
                turn: game.seat(),
                points: Team::BOTH.map(|team| score.points[team]),
                games: Team::BOTH.map(|team| score.games[team]),
                coins: game.coins().iter().map(lying).collect(),
                fingerprint: Fingerprint::of(game).to_string(),
            },
        }
    }
}

fn text(saved: &SavedGame, game: &Game, moves: &[ReplayedMove]) -> String {
    let mut text = String::new();
    for happening in moves {
        let seat = format!("{:?}", happening.seat);
        let what = match (&happening.strike, happening.kind) {
            (Some(strike), _) => format!("{seat} strikes at {:.2} m/s", strike.velocity.length()),
            (None, "no_place") => format!("{seat} finds no place for the striker"),
            (None, "next_board") => "the next board".into(),
            (None, _) => format!("{seat} lays the coins out"),
        };
        let _ = writeln!(text, "{:4}  {what}", happening.r#move);
        for ruling in &happening.rulings {
            let law = ruling.law.as_ref();
            let law = law.map_or(String::new(), |law| format!(" (law {law})"));
            let _ = writeln!(text, "      {}{law}", ruling.text);
        }
    }
    let score = game.score();
    let both = |points: [u8; 2]| format!("{} : {}", points[0], points[1]);
    let _ = writeln!(
        text,
        "\nafter {} strokes: board {}, points {}, games {}, turn {:?}",
        saved.record.strokes(),
        game.board_number(),
        both(Team::BOTH.map(|team| score.points[team])),
        both(Team::BOTH.map(|team| score.games[team])),
        game.seat(),
    );
    for coin in game.coins() {
        let [x, y] = coin.at.to_array().map(mm_from_m);
        let _ = writeln!(
            text,
            "      {:8} {x:9.2} {y:9.2} mm",
            coin.piece.to_string()
        );
    }
    let _ = writeln!(text, "fingerprint {}, as the file says", saved.end);
    text
}
