//! Reads a game from an untrusted file.

use super::company::BySeat;
use super::{Company, FORMAT, Fingerprint, Player, SavedGame, SeatNames, is_player_name};
use crate::files::{Fields, FileErrors, NO_NAME, NumberSpec, Source, is_blank_name};
use crate::game::opponent::{PlayerHand, Strength};
use crate::game::record::Record;
use crate::game::score::Length;
use crate::game::table::{Game, GameSetup};
use crate::game::{BoardCode, Rules};

/// The fields of a file.
const FIELDS: [&str; 13] = [
    "format",
    "player",
    "players",
    "computer",
    "computers",
    "names",
    "hand",
    "call",
    "aids",
    "setup",
    "hints",
    "moves",
    "end",
];

/// The contents of `setup`.
const SETUP: [&str; 7] = [
    "rules",
    "hands",
    "length",
    "set",
    "restitution",
    "first_breaker",
    "seed",
];

const RESTITUTION: NumberSpec = NumberSpec::new("a coefficient of restitution", "", 0.0, 1.0);

impl SavedGame {
    /// Reads a file and plays all its moves; returns the saved game and the game that results.
    /// `name` is the name of the file in messages.
    ///
    /// # Errors
    /// Returns all errors: the file is not a saved game or is too new, a move is impossible, or the
    /// fingerprint at the end of the file does not match.
    pub fn read(name: &str, bytes: &[u8]) -> Result<(Self, Game), FileErrors> {
        let source = Source::of_bytes(name, bytes, Self::LARGEST_FILE)?;
        source.document("a saved game", 1..=FORMAT, &FIELDS, from_fields)
    }
}

fn from_fields(fields: &Fields) -> Option<(SavedGame, Game)> {
    let player = fields.text_as("player", |name| match is_player_name(name) {
        true => Ok(name.to_owned()),
        false if is_blank_name(name) => Ok(NO_NAME.to_owned()),
        false => Err("expected a name of 1 to 40 visible characters".into()),
    });
    let players = fields.parsed::<BySeat<Player>>("players", "the player at each seat");
    let strengths = if fields.has("computers") {
        let expected = "the computer's strength at each seat";
        fields
            .parsed::<BySeat<Strength>>("computers", expected)
            .map(Into::into)
    } else {
        let all = fields.parsed::<Strength>("computer", "the computer's strength");
        all.map(|strength| [strength; 4])
    };
    let names = fields.or("names", SeatNames::default(), |name| {
        let names: SeatNames = fields.table_parsed(name, "the names of South and North")?;
        match names.tidied() == names {
            true => Some(names),
            false => fields.refuse(name, "expected names of at most 12 visible letters"),
        }
    });
    let hand = fields.or("hand", PlayerHand::default(), |name| {
        fields.parsed(name, "exact, steady or club")
    });
    let call = fields.parsed("call", "true or false");
    let aids = fields.parsed("aids", "the aids that are drawn");
    let setup = fields.table("setup", &SETUP).and_then(|it| setup(&it));
    let moves = fields.all_parsed("moves", "a list of moves");
    let hints = fields.or("hints", Vec::new(), |name| {
        fields.all_parsed::<usize>(name, "the numbers of moves")
    });
    let end = fields.text_as("end", |end| {
        let expected = "expected a fingerprint of 16 hexadecimal digits";
        Fingerprint::parse(end).ok_or_else(|| expected.into())
    });
    let record = Record {
        setup: setup?,
        moves: moves?,
    };
    let game = match record.replay() {
        Ok(game) => game,
        Err(error) => return fields.refuse_item("moves", error.number - 1, error.to_string()),
    };
    let (end, found) = (end?, Fingerprint::of(&game));
    if found != end {
        let message = format!("expected the moves to lead to {end}, but they lead to {found}");
        return fields.refuse("end", message);
    }
    let saved = SavedGame {
        player: player?,
        company: Company {
            players: players?.into(),
            strengths: strengths?,
            names: names?,
            hand: hand?,
            call: call?,
            aids: aids?,
        },
        record,
        hints: hints?,
        end,
    };
    Some((saved, game))
}

/// The settings that were agreed before the first break.
fn setup(fields: &Fields) -> Option<GameSetup> {
    let rules = fields.parsed("rules", "the rules");
    let hands = fields.parsed("hands", "the number of players");
    let length = fields.or("length", Length::default(), |name| {
        fields.parsed(name, "board, game or match")
    });
    let set = fields.parsed("set", "the pieces");
    let usual = GameSetup::default().restitution;
    let restitution = fields.or("restitution", usual, |name| {
        fields.number(name, &RESTITUTION)
    });
    let first_breaker = fields.parsed("first_breaker", "the seat that breaks first");
    let seed = fields.or("seed", None, |name| {
        let bits = fields.parsed::<i64>(name, "a whole number")?;
        Some(Some(bits.cast_unsigned()))
    });
    let setup = GameSetup {
        rules: rules?,
        hands: hands?,
        length: length?,
        set: set?,
        restitution: restitution?,
        first_breaker: first_breaker?,
        seed: seed?,
    };
    if setup.rules == Rules::Solo && setup.board_code().map(BoardCode::setup) != Some(setup) {
        let expected = "expected the code of a board, and the setup that belongs to it";
        return fields.refuse("seed", expected);
    }
    Some(setup)
}
