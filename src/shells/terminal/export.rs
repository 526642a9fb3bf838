//! Writing what the player exports.

use std::fs::OpenOptions;
use std::io::{self, Write};

/// How many names are tried before giving up.
const MOST: u32 = 1000;

/// Writes a text to a file of this name in the current folder, or, where there is one
/// already, with a number behind its name: nothing is ever overwritten. Gives the path
/// of the file, or why there is none.
pub(super) fn write(name: &str, content: &str) -> Result<String, String> {
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, "txt"));
    for number in 1..=MOST {
        let name = match number {
            1 => format!("{stem}.{ending}"),
            number => format!("{stem}-{number}.{ending}"),
        };
        match OpenOptions::new().write(true).create_new(true).open(&name) {
            Ok(mut file) => {
                let written = file.write_all(content.as_bytes());
                let path = std::path::absolute(&name);
                let place = path.map_or(name, |path| path.display().to_string());
                return written.map(|()| place).map_err(|error| error.to_string());
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error.to_string()),
        }
    }
    Err(format!("there are {MOST} files of this name already"))
}
