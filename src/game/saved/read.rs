//! Reads a game from a file, and believes nothing of it.

use super::company::Players;
use super::{Company, FORMAT, Fingerprint, SavedGame, is_player_name};
use crate::files::{Fields, FileErrors, Source};
use crate::game::record::Record;
use crate::game::table::Game;

/// What stands in a file.
const FIELDS: [&str; 9] = [
    "format", "player", "players", "computer", "call", "aids", "setup", "moves", "end",
];

impl SavedGame {
    /// Reads a file and plays all of it; gives it with the game it leads to. `name`
    /// stands for the file in messages.
    ///
    /// # Errors
    /// All that is wrong with it: that it is no such file, or a newer one; that one of
    /// its moves cannot be made; that it does not lead where it says.
    pub fn read(name: &str, bytes: &[u8]) -> Result<(Self, Game), FileErrors> {
        let source = Source::of_bytes(name, bytes, Self::LARGEST_FILE)?;
        source.document("a saved game", FORMAT, &FIELDS, from_fields)
    }
}

fn from_fields(fields: &Fields) -> Option<(SavedGame, Game)> {
    let player = fields.text_as("player", |name| match is_player_name(name) {
        true => Ok(name.to_owned()),
        false => Err("expected a name of 1 to 40 visible letters".into()),
    });
    let players = fields.parsed::<Players>("players", "who plays from each seat");
    let strength = fields.parsed("computer", "how strong the computer is");
    let call = fields.parsed("call", "true or false");
    let aids = fields.parsed("aids", "which helps are drawn");
    let setup = fields.parsed("setup", "what was agreed before the first break");
    let moves = fields.all_parsed("moves", "a list of moves");
    let end = fields.text_as("end", |end| {
        let expected = "expected a fingerprint of 16 hexadecimal digits";
        Fingerprint::parse(end).ok_or_else(|| expected.into())
    });
    let record = Record::of(setup?, moves?);
    let game = match record.replay() {
        Ok(game) => game,
        Err(error) => return fields.refuse_item("moves", error.number - 1, error.to_string()),
    };
    let (end, found) = (end?, Fingerprint::of(&game));
    if found != end {
        let message = format!("expected the moves to lead to {end}, but they lead to {found}");
        return fields.refuse("end", message);
    }
    let players = players?;
    let saved = SavedGame {
        player: player?,
        company: Company {
            players: [players.south, players.east, players.north, players.west],
            strength: strength?,
            call: call?,
            aids: aids?,
        },
        record,
        end,
    };
    Some((saved, game))
}
