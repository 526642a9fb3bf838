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
    let failed = |error: io::Error| error.to_string();
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, "txt"));
    let draft = UnplacedFile::write(Path::new("."), content, false).map_err(failed)?;
    for number in 1..=MOST {
        let name = match number {
            1 => format!("{stem}.{ending}"),
            number => format!("{stem}-{number}.{ending}"),
        };
        if draft.place(Path::new(&name)).map_err(failed)? {
            let path = std::path::absolute(&name);
            return Ok(path.map_or(name, |path| path.display().to_string()));
        }
    }
    Err(format!("there are already {MOST} files with this name"))
}
