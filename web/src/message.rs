//! What the page says, and what it is told: JSON, and behind a zero byte the bytes of files.

use carrom::widgets::{PictureSizes, Role, Section, SheetKind};
use serde::{Deserialize, Serialize};

/// Something the page says.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "do", rename_all = "kebab-case")]
pub enum Command {
    /// Begin, or begin anew.
    Open(Opening),
    /// A key was pressed, by its name.
    Key {
        /// The name: "a", "Right", "Shift+Tab".
        key: String,
    },
    /// The mouse or a finger did something.
    Mouse {
        /// "down", "drag", "up", "scroll-up" or "scroll-down".
        kind: String,
        /// Where, in columns from the left edge.
        x: f64,
        /// Where, in rows from the upper edge.
        y: f64,
    },
    /// Text was pasted.
    Paste {
        /// The text.
        text: String,
    },
    /// The screen has another size now.
    Resize {
        /// Columns.
        columns: u16,
        /// Rows.
        rows: u16,
        /// The sizes of pictures, where the page lays the screen out itself.
        #[serde(default)]
        pictures: Option<PictureSizes>,
    },
    /// Time has passed.
    Pass {
        /// How much of it.
        ms: f64,
    },
    /// What time it is.
    Now {
        /// Seconds since 1970 began.
        time_s: i64,
        /// By how many seconds days begin before those of UTC.
        offset_s: i32,
    },
    /// Set charset or colours, as a tape does.
    Set {
        /// "ascii" or "unicode".
        charset: Option<String>,
        /// "none", "16", "256" or "truecolor".
        color: Option<String>,
    },
    /// The preferences of the player's system have changed.
    Prefer {
        /// Whether it prefers a light theme.
        light: bool,
        /// Whether it prefers reduced motion.
        still: bool,
    },
    /// Draw the screen.
    Paint {
        /// The number of the last one that was painted: only what has changed since is told.
        #[serde(default)]
        since: u64,
    },
    /// The files that the browser keeps, whose bytes follow.
    Files {
        /// The files.
        files: Vec<FileLength>,
    },
    /// Say which files are to be kept.
    Changed,
    /// They are kept now, or why not.
    Kept {
        /// The reason, in words.
        failed: Option<String>,
    },
    /// Keeping takes long.
    Slow,
    /// A file was opened, whose bytes follow.
    File {
        /// Its name.
        name: String,
    },
    /// Give the database, to be taken along.
    Progress,
    /// Say how a glyph is drawn as a shape: its path and how much ink is laid on, as lines;
    /// none if it is a letter.
    Glyph {
        /// The glyph.
        letter: String,
    },
    /// A line was said, where carrom is read in plain lines.
    Line {
        /// The line.
        text: String,
    },
    /// Something was heard of the class.
    Joined {
        /// What.
        news: News,
    },
    /// Tell the player something.
    Tell {
        /// The words.
        words: String,
    },
}

/// What is heard of a class, of which this page was served.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "is", rename_all = "kebab-case")]
pub enum News {
    /// The host is reached.
    Reached,
    /// It says something.
    Heard {
        /// What.
        text: String,
    },
    /// It cannot be reached, or no longer.
    Lost {
        /// Why.
        reason: String,
    },
    /// What was remembered of an earlier time.
    Remembered {
        /// What brings the pupil back.
        seat: String,
        /// Their name.
        name: String,
    },
    /// The page was asleep, and is back.
    Awake,
}

/// What the page is to do for a pupil of a class.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "do", rename_all = "kebab-case")]
pub enum ClassCall {
    /// Reach the host that the page came from.
    Dial,
    /// Say this.
    Say {
        /// What.
        text: String,
    },
    /// Remember this.
    Remember {
        /// What brings the pupil back.
        seat: String,
        /// Their name.
        name: String,
        /// The code of the class.
        code: String,
    },
    /// Hang up.
    HangUp,
}

/// How carrom begins.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
pub struct Opening {
    /// What stands behind the # of the page's address, still spelt as it is there.
    pub fragment: String,
    /// What is left to chance.
    pub seed: u64,
    /// Columns of the screen.
    pub columns: u16,
    /// Rows of the screen.
    pub rows: u16,
    /// The sizes of pictures, where the page lays the screen out itself.
    pub pictures: Option<PictureSizes>,
    /// Whether the player likes it light.
    pub light: bool,
    /// Whether the player does not like things to move.
    pub still: bool,
    /// For tests: no clock, everything kept at once.
    pub simulated: bool,
    /// A teacher's own files, whose bytes follow.
    pub own: Vec<FileLength>,
}

/// A file among bytes.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct FileLength {
    /// Its path.
    pub path: String,
    /// How many of the bytes are its.
    pub bytes: usize,
}

/// What the page is told.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Reply {
    /// When to let time pass again, in ms; `None` while nothing moves.
    pub wake_ms: Option<f64>,
    /// Whether something is to be kept.
    pub keep: bool,
    /// How many things could not be saved so far.
    pub unsaved: usize,
    /// Whether carrom was left.
    pub quit: bool,
    /// What is to be done for a pupil of a class, in order.
    pub calls: Vec<ClassCall>,
    /// Texts for the player to take away.
    pub downloads: Vec<Download>,
    /// What was drawn, if that was asked for.
    pub painted: Option<Painted>,
    /// Files, whose bytes follow.
    pub files: Vec<FileLength>,
    /// Paths of files that are to be kept no longer.
    pub gone: Vec<String>,
    /// What is said in plain lines, or how a glyph is drawn.
    pub lines: Vec<String>,
    /// The address of the current screen, as in a link; after `&said=` the answers given there.
    pub address: String,
    /// How many screens are open.
    pub depth: usize,
    /// What to tell the player once the page has opened again, which shows what a file has
    /// changed.
    pub renewed: Option<String>,
    /// Something that is wrong, in words.
    pub fault: Option<String>,
    /// The bytes of the files.
    #[serde(skip)]
    pub bytes: Vec<u8>,
}

/// A text for the player to take away.
#[derive(Debug, Clone, Serialize)]
pub struct Download {
    /// The name of its file.
    pub name: String,
    /// The text.
    pub content: String,
}

/// What was drawn beside the cells.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Painted {
    /// Its number.
    pub number: u64,
    /// Columns and rows.
    pub size: [u16; 2],
    /// The pictures.
    pub pictures: Vec<PictureMessage>,
    /// The keys that mean something just now, if they are others than before.
    pub keys: Option<Vec<Keys>>,
    /// The colours of plain text and of what is behind it, 0xRRGGBB.
    pub colours: [u32; 2],
    /// The colour of each role, if they are others than before.
    pub inks: Option<Vec<(Role, u32)>>,
    /// What the screen says, and what lies over it, if that is not as before.
    pub sheets: Option<Vec<SheetMessage>>,
}

/// What a screen says, or what lies over it.
#[derive(Debug, Clone, Serialize)]
pub struct SheetMessage {
    /// What it is.
    pub kind: SheetKind,
    /// What it is called.
    pub title: String,
    /// How it stands.
    pub status: String,
    /// Its sections; `None` in place of one that is as it was.
    pub sections: Vec<Option<Section>>,
}

/// A picture among the cells.
#[derive(Debug, Clone, Serialize)]
pub struct PictureMessage {
    /// Column, row, columns, rows.
    pub area: [u16; 4],
    /// The colour behind it.
    pub paper: u32,
    /// Its vectors, in units of which a cell is 9 by 18; `None` if they are as before.
    pub svg: Option<String>,
}

/// Keys that belong together.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Keys {
    /// The name of what they do in `keys.toml`: "everywhere.help".
    pub id: String,
    /// Their names.
    pub keys: Vec<String>,
    /// What the bottom line calls them.
    pub name: &'static str,
    /// What the help page says of them.
    pub help: &'static str,
    /// What each of them is called on a button, if they have names.
    pub words: &'static [&'static str],
}

/// Reads what was said, and gives the bytes behind it.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn read(said: &[u8]) -> Result<(Command, &[u8]), String> {
    let end = said.iter().position(|byte| *byte == 0);
    let (json, bytes) = match end {
        Some(end) => (&said[..end], &said[end + 1..]),
        None => (said, &[][..]),
    };
    let command = serde_json::from_slice(json).map_err(|error| error.to_string())?;
    Ok((command, bytes))
}

/// Writes a reply, followed by its bytes.
pub(crate) fn write(reply: &Reply) -> Vec<u8> {
    match serde_json::to_vec(reply) {
        Ok(mut message) => {
            message.push(0);
            message.extend(&reply.bytes);
            message
        }
        Err(error) => fault(&error.to_string()),
    }
}

/// Writes a reply that reports a fault.
pub(crate) fn fault(words: &str) -> Vec<u8> {
    let reply = Reply {
        fault: Some(words.to_owned()),
        ..Reply::default()
    };
    serde_json::to_vec(&reply).unwrap_or_default()
}

/// The files among bytes; those that are not all there are left out.
pub(crate) fn split(files: &[FileLength], mut bytes: &[u8]) -> Vec<(String, Vec<u8>)> {
    let mut split = Vec::new();
    for file in files {
        let Some((own, rest)) = bytes.split_at_checked(file.bytes) else {
            break;
        };
        split.push((file.path.clone(), own.to_vec()));
        bytes = rest;
    }
    split
}
