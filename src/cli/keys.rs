//! `carrom keys`: all keys, as a file in which they can be changed.

use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;

use super::{Failure, Options};
use crate::files::{self, FileErrors, Source};
use crate::messages::Key;
use crate::shells::tour::all_keys;
use crate::widgets::input::Rebound;

/// Name of the file in the folder for data.
pub(super) const FILE: &str = "keys.toml";
/// Format of the file.
const FORMAT: u32 = 1;
/// Largest file that is read, in bytes.
const LARGEST: usize = 64 * 1024;

/// Print all keys, as a file to change some in
#[derive(Debug, clap::Args)]
pub(super) struct Args {}

pub(super) fn run(options: &Options) -> Result<ExitCode, Failure> {
    let place = options.data_dir().map(|folder| folder.join(FILE));
    let place = place.map_or(FILE.into(), |place| place.display().to_string());
    let mut text = format!(
        "# Keys of carrom. To change some, put their lines, with the two below, into\n\
         # {place}\n\
         # A key is a character, or one of Up Down Left Right Enter Escape Tab Shift+Tab\n\
         # Backspace Delete Space PageUp PageDown Home End F1 to F12 Ctrl+A to Ctrl+Z. Give as\n\
         # many as the line has, in the same order.\n\
         format = {FORMAT}\n\n[keys]\n"
    );
    for (id, (keys, help)) in all_keys() {
        let keys: Vec<_> = keys.into_iter().map(|key| quoted(&key.to_string())).collect();
        let _ = writeln!(text, "\"{id}\" = [{}]  # {help}", keys.join(", "));
    }
    super::print(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}

/// The keys that the player has chosen in a file; none where there is no such file.
///
/// # Errors
/// All that is wrong with the file.
pub(super) fn read(path: &Path) -> Result<Rebound, FileErrors> {
    if !path.exists() {
        return Ok(Rebound::new());
    }
    let bytes = files::read(path, LARGEST)?;
    let name = path.display().to_string();
    let source = Source::new(&name, &bytes, LARGEST)?;
    let all = all_keys();
    source.document("keys of carrom", FORMAT, &["format", "keys"], |fields| {
        let table = fields.table("keys", &[])?;
        let mut rebound = Rebound::new();
        for name in table.names() {
            let keys = table.texts(name, 16);
            let Some((usual, _)) = all.get(name) else {
                table.refuse::<()>(name, "no such action; carrom keys lists them all");
                continue;
            };
            let Some(keys) = keys else { continue };
            let parsed: Vec<_> = keys.iter().map(|key| Key::parse(key)).collect();
            for (item, key) in parsed.iter().enumerate() {
                if key.is_none() {
                    let expected = "expected a key, such as \"x\", \"Up\", \"F5\" or \"Ctrl+X\"";
                    table.refuse_item::<()>(name, item, expected);
                }
            }
            if keys.is_empty() || keys.len() > usual.len() {
                let most = usual.len();
                table.refuse::<()>(name, format!("expected 1 to {most} keys, found {}", keys.len()));
            }
            rebound.insert(name.to_owned(), parsed.into_iter().flatten().collect());
        }
        Some(rebound)
    })
}
