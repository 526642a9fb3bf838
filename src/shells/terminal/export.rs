//! Writes the files that the player exports.

use std::io;
use std::path::Path;

use crate::files::UnplacedFile;

/// How many names are tried before giving up.
const MOST: u32 = 1000;

/// Writes a file with this name to the current folder. If the file exists, a number is
/// added to the name, so nothing is ever overwritten. Returns the file's path, or why it could not
/// be written.
pub(in crate::shells) fn write(name: &str, content: impl AsRef<[u8]>) -> Result<String, String> {
    write_beside(name, content.as_ref())
        .map_err(|error| error.to_string())?
        .ok_or_else(|| format!("there are already {MOST} files with this name"))
}

/// Writes the file; `None` if files with all the tried names exist.
fn write_beside(name: &str, content: &[u8]) -> io::Result<Option<String>> {
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, "txt"));
    let draft = UnplacedFile::write(Path::new("."), content, false)?;
    for number in 1..=MOST {
        let name = match number {
            1 => format!("{stem}.{ending}"),
            number => format!("{stem}-{number}.{ending}"),
        };
        if draft.place(Path::new(&name))? {
            let path = std::path::absolute(&name);
            return Ok(Some(path.map_or(name, |path| path.display().to_string())));
        }
    }
    Ok(None)
}
