//! Writes a game down, a thing a line.

use std::fmt::Write;

use serde::Serialize;
use toml::ser::ValueSerializer;

use super::company::Players;
use super::{FORMAT, SavedGame};

const HEAD: &str = "\
# A game of carrom. `carrom replay FILE` plays it again and checks every move.
";

/// The text of the file.
pub(super) fn text(saved: &SavedGame) -> String {
    let company = &saved.company;
    let [south, east, north, west] = company.players;
    let players = Players {
        south,
        east,
        north,
        west,
    };
    let mut text = HEAD.to_owned();
    line(&mut text, "format", &FORMAT);
    line(&mut text, "player", &saved.player);
    line(&mut text, "players", &players);
    line(&mut text, "computer", &company.strength);
    line(&mut text, "call", &company.call);
    line(&mut text, "aids", &company.aids);
    line(&mut text, "setup", saved.record.setup());
    text.push_str("moves = [\n");
    for made in saved.record.moves() {
        let _ = writeln!(text, "  {},", value(made));
    }
    text.push_str("]\n");
    line(&mut text, "end", &saved.end.to_string());
    text
}

fn line(text: &mut String, key: &str, of: &impl Serialize) {
    let _ = writeln!(text, "{key} = {}", value(of));
}

/// A value in one line. There is nothing in a game that TOML could not say; should
/// that ever change, what is written cannot be read, and a test would tell.
fn value(of: &impl Serialize) -> String {
    let mut text = String::new();
    match of.serialize(ValueSerializer::new(&mut text)) {
        Ok(_) => text,
        Err(error) => format!("# {error}"),
    }
}
