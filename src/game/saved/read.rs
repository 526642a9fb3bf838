//! Reads a game from a file, and believes nothing of it.

use serde::Deserialize;
use toml::Spanned;

use super::company::Players;
use super::{Aids, Company, FORMAT, Fingerprint, SavedGame, is_player_name};
use crate::files::{FileError, Source};
use crate::game::opponent::Strength;
use crate::game::record::{Move, Record};
use crate::game::table::{Game, GameSetup};

/// A file of the present format.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(rename = "format")]
    _format: u32,
    player: Spanned<String>,
    players: Players,
    computer: Strength,
    call: bool,
    aids: Aids,
    setup: GameSetup,
    moves: Vec<Spanned<Move>>,
    end: Spanned<String>,
}

pub(super) fn read(name: &str, bytes: &[u8]) -> Result<(SavedGame, Game), FileError> {
    let source = Source::of_bytes(name, bytes, SavedGame::LARGEST_FILE)?;
    let file: File = source.tables("a saved game", FORMAT)?;
    if !is_player_name(file.player.get_ref()) {
        let message = "expected a name of 1 to 40 visible letters";
        return Err(source.fault(file.player.span().start, "player", message));
    }
    let Some(end) = Fingerprint::parse(file.end.get_ref()) else {
        let message = "expected a fingerprint of 16 hexadecimal digits";
        return Err(source.fault(file.end.span().start, "end", message));
    };
    let places: Vec<_> = file.moves.iter().map(|made| made.span().start).collect();
    let moves = file.moves.into_iter().map(Spanned::into_inner).collect();
    let record = Record::of(file.setup, moves);
    let game = record.replay().map_err(|error| {
        let at = places.get(error.number - 1).copied().unwrap_or_default();
        source.fault(at, "moves", error.to_string())
    })?;
    let found = Fingerprint::of(&game);
    if found != end {
        let message = format!("expected the moves to lead to {end}, but they lead to {found}");
        return Err(source.fault(file.end.span().start, "end", message));
    }
    let saved = SavedGame {
        player: file.player.into_inner(),
        company: Company {
            players: file.players.into(),
            strength: file.computer,
            call: file.call,
            aids: file.aids,
        },
        record,
        end,
    };
    Ok((saved, game))
}
