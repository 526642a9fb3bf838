//! Options that every command takes.

use std::env;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::{Args, ValueEnum};
use etcetera::BaseStrategy;

use crate::files::tidy_name;
use crate::game::is_player_name;
use crate::lessons::Book;
use crate::levels::Shelf;
use crate::quiz::concepts::Library;
use crate::screens::Settings;
use crate::shells::terminal;
use crate::store::Store;
use crate::widgets::{Charset, Depth, Palette};
use crate::{lessons, levels};

/// Options that every command takes.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Global options")]
pub struct GlobalOptions {
    /// Glyphs to draw with; auto: unicode in a UTF-8 locale
    #[arg(long, global = true, value_enum, default_value_t, value_name = "SET")]
    charset: CharsetChoice,
    /// Colours to draw with; auto: what the terminal shows, and none with NO_COLOR
    #[arg(long, global = true, value_enum, default_value_t, value_name = "DEPTH")]
    color: ColorChoice,
    /// Dark for a desk, light for a projector in a bright room
    #[arg(long, global = true, value_enum, value_name = "PALETTE")]
    palette: Option<PaletteChoice>,
    /// Fix everything that is left to chance, such as the questions of a quiz
    #[arg(long, global = true, value_name = "N", value_parser = seed,
          allow_negative_numbers = true)]
    pub(super) seed: Option<u64>,
    /// Name of the player
    #[arg(long, global = true, value_name = "NAME", value_parser = player)]
    player: Option<String>,
    /// Folder with levels of your own, added to those of the program; may be given
    /// several times
    #[arg(long, global = true, value_name = "DIR", value_parser = folder)]
    levels: Vec<PathBuf>,
    /// Folder with chapters of your own, added to those of the program; may be given
    /// several times
    #[arg(long, global = true, value_name = "DIR", value_parser = folder)]
    lessons: Vec<PathBuf>,
    /// Folder with written questions of your own, asked in rounds of their own; may be
    /// given several times
    #[arg(long, global = true, value_name = "DIR", value_parser = folder)]
    concepts: Vec<PathBuf>,
    /// Folder for what carrom keeps, such as saved games and every answer (default: the
    /// system's place for a program's data)
    #[arg(long, global = true, value_name = "DIR")]
    data_dir: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
enum CharsetChoice {
    #[default]
    Auto,
    Ascii,
    Unicode,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
enum ColorChoice {
    #[default]
    Auto,
    None,
    #[value(name = "16")]
    Sixteen,
    #[value(name = "256")]
    Cube,
    Truecolor,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum PaletteChoice {
    Dark,
    Light,
}

/// What `auto` means for charset and colours.
#[derive(Debug, Clone, Copy)]
pub(super) struct Auto {
    pub(super) charset: Charset,
    pub(super) depth: Depth,
}

impl Auto {
    /// What shows anywhere.
    pub(super) const PLAINEST: Self = Self {
        charset: Charset::Ascii,
        depth: Depth::None,
    };
}

impl GlobalOptions {
    /// These options, with the other's where these leave something open.
    pub(super) fn or(self, other: &Self) -> Self {
        let other = other.clone();
        Self {
            charset: match self.charset {
                CharsetChoice::Auto => other.charset,
                chosen => chosen,
            },
            color: match self.color {
                ColorChoice::Auto => other.color,
                chosen => chosen,
            },
            palette: self.palette.or(other.palette),
            seed: self.seed.or(other.seed),
            player: self.player.or(other.player),
            lessons: if self.lessons.is_empty() {
                other.lessons
            } else {
                self.lessons
            },
            levels: if self.levels.is_empty() {
                other.levels
            } else {
                self.levels
            },
            concepts: if self.concepts.is_empty() {
                other.concepts
            } else {
                self.concepts
            },
            data_dir: self.data_dir.or(other.data_dir),
        }
    }

    /// The glyphs to write with, with `auto` standing for the given ones.
    pub(super) fn charset(&self, auto: Charset) -> Charset {
        match self.charset {
            CharsetChoice::Auto => auto,
            CharsetChoice::Ascii => Charset::Ascii,
            CharsetChoice::Unicode => Charset::Unicode,
        }
    }

    /// The glyphs to print with.
    pub(super) fn printed(&self) -> Charset {
        self.charset(terminal::charset(|name| env::var(name).ok()))
    }

    /// The name of the player.
    pub(super) fn player_name(&self) -> String {
        let name = self.player.clone();
        name.unwrap_or_else(|| Settings::default().player)
    }

    /// What the player has set, with `auto` standing for the given look.
    pub(super) fn settings(&self, auto: Auto) -> Settings {
        let defaults = Settings::default();
        Settings {
            charset: self.charset(auto.charset),
            depth: match self.color {
                ColorChoice::Auto => auto.depth,
                ColorChoice::None => Depth::None,
                ColorChoice::Sixteen => Depth::Ansi16,
                ColorChoice::Cube => Depth::Indexed256,
                ColorChoice::Truecolor => Depth::True,
            },
            palette: match self.palette {
                Some(PaletteChoice::Light) => Palette::Light,
                Some(PaletteChoice::Dark) => Palette::Dark,
                None => defaults.palette,
            },
            player: self.player_name(),
            ..defaults
        }
    }

    /// The levels of the program and those of the folders given. Files that are no
    /// good are left out and listed on the screen of the levels.
    pub(super) fn shelf(&self) -> Shelf {
        if self.levels.is_empty() {
            return Shelf::default();
        }
        let mut library = levels::LevelLibrary::embedded();
        for dir in &self.levels {
            library.add_dir(dir);
        }
        Shelf::new(library)
    }

    /// The chapters of the program and those of the folders given. Files that are no
    /// good are left out and listed in the contents.
    pub(super) fn book(&self) -> Book {
        if self.lessons.is_empty() {
            return Book::default();
        }
        let mut library = lessons::ChapterLibrary::embedded();
        for dir in &self.lessons {
            library.add_dir(dir);
        }
        Book::new(library)
    }

    /// The written questions of the folders given. Files that are no good are left out
    /// and listed where a round of them is chosen.
    pub(super) fn own(&self) -> Arc<Library> {
        let mut library = Library::default();
        for dir in &self.concepts {
            library.add_dir(dir);
        }
        Arc::new(library)
    }

    /// The folder for what carrom keeps, if one is given.
    pub(super) fn given_data_dir(&self) -> Option<&Path> {
        self.data_dir.as_deref()
    }

    /// The folder for what carrom keeps; `None` if none is given and the system
    /// knows no home for the user.
    pub(super) fn data_dir(&self) -> Option<PathBuf> {
        self.data_dir.clone().or_else(|| {
            let system = etcetera::choose_base_strategy().ok()?;
            Some(system.data_dir().join("carrom"))
        })
    }

    /// Where carrom keeps things; it refuses everything where no folder is known.
    pub(super) fn store(&self) -> Store {
        let folder = self.data_dir();
        folder.map_or_else(Store::nowhere, |folder| Store::in_folder(&folder))
    }
}

/// A folder that is there.
fn folder(path: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(path);
    if path.is_dir() {
        Ok(path)
    } else {
        Err("expected a folder that is there".into())
    }
}

/// A name that can be shown: not empty, not endless, nothing but visible letters.
fn player(name: &str) -> Result<String, String> {
    if !is_player_name(name.trim()) {
        return Err("expected a name of 1 to 40 visible letters".into());
    }
    Ok(tidy_name(name))
}

/// A seed. Numbers may be as large as they are anywhere.
fn seed(text: &str) -> Result<u64, String> {
    let expected = || format!("expected a whole number from 0 to {}", u64::MAX);
    text.parse().map_err(|_| expected())
}
