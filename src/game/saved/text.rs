//! Writes a game, one item per line.

use std::fmt::Write;

use serde::Serialize;
use toml::ser::ValueSerializer;

use super::company::BySeat;
use super::{FORMAT, SavedGame, SeatNames, TooLarge};

const HEAD: &str =
    "# A game of carrom. `carrom replay FILE` plays it again and checks every move.\n";

impl SavedGame {
    /// The text of the file.
    ///
    /// # Errors
    /// Returns an error if the file would be too large to be read again.
    pub fn text(&self) -> Result<String, TooLarge> {
        let company = &self.company;
        let mut text = HEAD.to_owned();
        line(&mut text, "format", &FORMAT);
        line(&mut text, "player", &self.player);
        line(&mut text, "players", &BySeat::from(company.players));
        let [first, others @ ..] = company.strengths;
        if others == [first; 3] {
            line(&mut text, "computer", &first);
        } else {
            line(&mut text, "computers", &BySeat::from(company.strengths));
        }
        if company.names != SeatNames::default() {
            line(&mut text, "names", &company.names);
        }
        line(&mut text, "hand", &company.hand);
        line(&mut text, "call", &company.call);
        line(&mut text, "aids", &company.aids);
        line(&mut text, "setup", &self.record.setup);
        if !self.hints.is_empty() {
            line(&mut text, "hints", &self.hints);
        }
        text.push_str("moves = [\n");
        for made in &self.record.moves {
            let _ = writeln!(text, "  {},", value(made));
        }
        text.push_str("]\n");
        line(&mut text, "end", &self.end.to_string());
        if text.len() > Self::LARGEST_FILE {
            return Err(TooLarge);
        }
        Ok(text)
    }
}

fn line(text: &mut String, key: &str, of: &impl Serialize) {
    let _ = writeln!(text, "{key} = {}", value(of));
}

/// A value on one line. TOML can express everything in a game; if it could not, the file would be
/// unreadable and a test would fail.
fn value(of: &impl Serialize) -> String {
    let mut text = String::new();
    match of.serialize(ValueSerializer::new(&mut text)) {
        Ok(_) => text,
        Err(error) => format!("# {error}"),
    }
}
