//! `carrom keys`: prints all keys as a file that the player can edit.

use std::collections::BTreeMap;
use std::path::Path;

use super::{Failure, GlobalOptions, given};
use crate::files::{self, Fields, FileErrors, Source};
use crate::messages::Key;
use crate::widgets::input::Rebound;

/// The name of the file in the data folder.
const FILE: &str = "keys.toml";
const FORMAT: u32 = 1;
/// The default keys and what they do. The tests of the screens compare this file with the key
/// tables of all screens, and rewrite it when snapshots are accepted.
const USUAL: &str = include_str!("../../assets/keys.toml");
/// The largest file that is read, in bytes.
const LARGEST: usize = 64 * 1024;

pub(super) fn run(options: &GlobalOptions) -> Result<(), Failure> {
    let place = options.data_dir().map(|folder| folder.join(FILE));
    let place = place.map_or(FILE.into(), |place| place.display().to_string());
    let text = format!(
        "# The keys of carrom. To change keys, copy their lines and the two lines below to\n\
         # {place}\n\
         # A key is a character, or one of Up Down Left Right Enter Escape Tab Shift+Tab\n\
         # Backspace Delete Space PageUp PageDown Home End F1 to F12 Ctrl+A to Ctrl+Z. Write as\n\
         # many keys as the line has here, in the same order.\n\
         format = {FORMAT}\n\n[keys]\n{USUAL}"
    );
    super::print(text.as_bytes())
}

/// The keys that the player has rebound in a file of the data folder; none if there is no file.
///
/// # Errors
/// All errors in the file.
pub(super) fn rebound(folder: &Path) -> Result<Rebound, FileErrors> {
    given::kept(&folder.join(FILE), LARGEST, read)
}

fn read(name: &str, bytes: &[u8]) -> Result<Rebound, FileErrors> {
    let source = Source::of_bytes(name, bytes, LARGEST)?;
    let known = ["format", "keys"];
    source.document("keys of carrom", FORMAT..=FORMAT, &known, |fields| {
        let table = fields.table("keys", &[])?;
        let all: BTreeMap<String, Vec<String>> = toml::from_str(USUAL).unwrap_or_default();
        let rows = table
            .names()
            .map(|id| Some((present(id).to_owned(), row(&table, id, &all)?)));
        files::all(rows.collect()).map(Rebound::from_iter)
    })
}

/// The current name of an action, given a current or an earlier name.
fn present(id: &str) -> &str {
    match id {
        "lab.scroll" | "table.scroll" => "everywhere.scroll",
        id => id,
    }
}

/// The keys of an action in a line of the file.
fn row(table: &Fields, id: &str, all: &BTreeMap<String, Vec<String>>) -> Option<Vec<Key>> {
    let Some(usual) = all.get(present(id)) else {
        return table.refuse(id, "unknown action; carrom keys lists all of them");
    };
    let keys = table.texts(id, 1..=usual.len(), 9)?;
    let key = |(item, text): (usize, &String)| {
        let expected = "expected a key, such as \"x\", \"Up\", \"F5\" or \"Ctrl+X\"";
        Key::parse(text).or_else(|| table.refuse_item(id, item, expected))
    };
    files::all(keys.iter().enumerate().map(key).collect())
}
