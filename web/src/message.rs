//! The page's commands and the replies: JSON, then a zero byte and the bytes of files.

use carrom::messages::{JoinCall, JoinNews};
use carrom::widgets::{PictureSizes, Role, Section, SheetKind};
use serde::{Deserialize, Serialize};

use crate::report::RoundReport;

/// A command from the page.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "do", rename_all = "kebab-case")]
pub enum Command {
    /// Open carrom, or open it again.
    Open(Opening),
    /// A key was pressed.
    Key {
        /// The name of the key: "a", "Right", "Shift+Tab".
        key: String,
    },
    /// The mouse or a finger was used.
    Mouse {
        /// "down", "drag", "up", "scroll-up" or "scroll-down".
        kind: String,
        /// The position in columns from the left edge.
        x: f64,
        /// The position in rows from the top edge.
        y: f64,
    },
    /// Text was pasted.
    Paste {
        /// The text.
        text: String,
    },
    /// The size of the screen has changed.
    Resize {
        /// The number of columns.
        columns: u16,
        /// The number of rows.
        rows: u16,
        /// The sizes of pictures, if the page lays out the screen itself.
        #[serde(default)]
        pictures: Option<PictureSizes>,
    },
    /// Time has passed.
    Pass {
        /// The elapsed time in milliseconds.
        ms: f64,
    },
    /// The current time.
    Now {
        /// Seconds since the start of 1970, UTC.
        time_s: i64,
        /// The number of seconds by which local time is ahead of UTC; negative if it is behind.
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
        /// Whether the system prefers a light theme.
        light: bool,
        /// Whether the system prefers reduced motion.
        still: bool,
    },
    /// Draw the screen.
    Paint {
        /// The number of the last frame that the page painted: only later changes are sent.
        #[serde(default)]
        since: u64,
    },
    /// The files that the browser has saved; their bytes follow.
    Files {
        /// The paths and lengths of the files.
        files: Vec<FileLength>,
    },
    /// Send the files that have to be saved.
    Changed,
    /// The save has ended.
    Kept {
        /// The reason in words, if the save failed.
        failed: Option<String>,
    },
    /// Saving is taking a long time.
    Slow,
    /// A file was opened; its bytes follow.
    File {
        /// The name of the file.
        name: String,
    },
    /// Send the database for the player to download.
    Progress,
    /// Send the shape of a glyph as two lines of text: its path and its opacity. No lines are sent
    /// if the glyph is drawn as a letter.
    Glyph {
        /// The glyph.
        letter: String,
    },
    /// A line was entered in plain mode.
    Line {
        /// The text of the line.
        text: String,
    },
    /// There is news from the class.
    Joined {
        /// The news.
        news: JoinNews,
    },
    /// Send the report of a round, for a learning platform.
    Round {
        /// The code of the round.
        code: String,
        /// The answers given so far, as in a link.
        said: String,
    },
    /// Show a notice to the player.
    Tell {
        /// The text of the notice.
        words: String,
    },
}

/// How to open carrom.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
pub struct Opening {
    /// The part of the page's address after `#`, still percent-encoded.
    pub fragment: String,
    /// The seed for random choices.
    pub seed: u64,
    /// The number of columns of the screen.
    pub columns: u16,
    /// The number of rows of the screen.
    pub rows: u16,
    /// The sizes of pictures, if the page lays out the screen itself.
    pub pictures: Option<PictureSizes>,
    /// Whether the player's system prefers a light theme.
    pub light: bool,
    /// Whether the player's system prefers reduced motion.
    pub still: bool,
    /// For tests: there is no clock, and everything is saved at once.
    pub simulated: bool,
    /// A teacher's own files, and the settings; their bytes follow.
    pub own: Vec<FileLength>,
}

/// A file whose bytes follow the message.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct FileLength {
    /// The path of the file.
    pub path: String,
    /// The length of the file in bytes.
    pub bytes: usize,
}

/// The reply to a command.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Reply {
    /// The time in ms after which the app needs to run again; `None` while nothing moves.
    pub wake_ms: Option<f64>,
    /// Whether there are changes to save.
    pub keep: bool,
    /// The number of things that could not be saved so far.
    pub unsaved: usize,
    /// Whether the player has quit carrom.
    pub quit: bool,
    /// Requests on behalf of a pupil in a class, in order.
    pub calls: Vec<JoinCall>,
    /// Text files for the player to download.
    pub downloads: Vec<Download>,
    /// The frame, if the command was to draw one.
    pub painted: Option<Painted>,
    /// Files to save; their bytes follow.
    pub files: Vec<FileLength>,
    /// The paths of files to delete.
    pub gone: Vec<String>,
    /// Lines of plain mode, or the shape of a glyph.
    pub lines: Vec<String>,
    /// The address of the current screen, as in a link; any answers given there follow `&said=`.
    pub address: String,
    /// The number of open screens.
    pub depth: usize,
    /// The report of a round.
    pub round: Option<RoundReport>,
    /// A notice for the player, to show after the page has opened carrom again with the contents of
    /// a new file.
    pub renewed: Option<String>,
    /// An error, in words.
    pub fault: Option<String>,
    /// The bytes of the files.
    #[serde(skip)]
    pub bytes: Vec<u8>,
}

impl Reply {
    /// Adds a file whose bytes follow the reply.
    pub(crate) fn attach(&mut self, path: String, content: &[u8]) {
        let bytes = content.len();
        self.files.push(FileLength { path, bytes });
        self.bytes.extend(content);
    }
}

/// A text file for the player to download.
#[derive(Debug, Clone, Serialize)]
pub struct Download {
    /// The name of the file.
    pub name: String,
    /// The content of the file.
    pub content: String,
}

/// A frame, without its cells.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Painted {
    /// The number of the frame.
    pub number: u64,
    /// The numbers of columns and rows.
    pub size: [u16; 2],
    /// The pictures on the screen.
    pub pictures: Vec<PictureMessage>,
    /// The current keys, if they have changed.
    pub keys: Option<Vec<Keys>>,
    /// The colours of plain text and of the background, 0xRRGGBB.
    pub colours: [u32; 2],
    /// The colour of each role, if any has changed.
    pub inks: Option<Vec<(Role, u32)>>,
    /// The text of the screen and of the layer over it, if any of the text has changed.
    pub sheets: Option<Vec<SheetMessage>>,
}

/// The text of a screen, or of the layer over it.
#[derive(Debug, Clone, Serialize)]
pub struct SheetMessage {
    /// The screen itself, or the kind of the layer over it.
    pub kind: SheetKind,
    /// The title.
    pub title: String,
    /// The status line.
    pub status: String,
    /// The sections; `None` for a section that has not changed.
    pub sections: Vec<Option<Section>>,
}

/// A picture among the cells.
#[derive(Debug, Clone, Serialize)]
pub struct PictureMessage {
    /// Left column, top row, number of columns, number of rows.
    pub area: [u16; 4],
    /// The background colour, 0xRRGGBB.
    pub paper: u32,
    /// The vectors as SVG, in which a cell is 9 by 18 units; `None` if they have not changed.
    pub svg: Option<String>,
}

/// Keys with a common action.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Keys {
    /// The name of the action in `keys.toml`: "everywhere.help".
    pub id: String,
    /// The names of the keys.
    pub keys: Vec<String>,
    /// The action's name on the bottom line.
    pub name: &'static str,
    /// The action's description on the help page.
    pub help: &'static str,
    /// The label of each key's button, if the keys have separate labels.
    pub words: &'static [&'static str],
}

/// Reads a command; returns it with the bytes that follow it.
///
/// # Errors
/// The reason why the command is invalid.
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

/// Writes a reply that reports an error.
pub(crate) fn fault(words: &str) -> Vec<u8> {
    let reply = Reply {
        fault: Some(words.to_owned()),
        ..Reply::default()
    };
    serde_json::to_vec(&reply).unwrap_or_default()
}

/// Splits the bytes into files; incomplete files are left out.
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
