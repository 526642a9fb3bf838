//! Options that every command takes.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;
use std::{env, iter};

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use etcetera::BaseStrategy;
use strum::VariantNames;

use super::settings;
use crate::files::{FileError, FileLibrary, tidy_name};
use crate::game::is_player_name;
use crate::lessons::{Book, ChapterLibrary};
use crate::levels::{LevelLibrary, Shelf};
use crate::quiz::concepts::Library;
use crate::screens::{KeptSettings, Settings};
use crate::shells::terminal;
use crate::store::Store;
use crate::widgets::{Charset, Depth, Palette};

/// Options that every command takes.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Global options")]
pub struct GlobalOptions {
    /// Glyphs to draw with; auto: unicode in a UTF-8 locale
    #[arg(long, global = true, value_name = "SET", default_value = "auto",
          value_parser = choice::<Charset>())]
    charset: Choice<Charset>,
    /// Colours to draw with; auto: what the terminal shows, and none with NO_COLOR
    #[arg(long, global = true, value_name = "DEPTH", default_value = "auto",
          value_parser = choice::<Depth>())]
    color: Choice<Depth>,
    /// Dark for a desk, light for a projector in a bright room
    #[arg(long, global = true, value_name = "PALETTE", value_parser = palette())]
    palette: Option<Palette>,
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

/// One of the names of something; nothing is said by `auto`.
type Choice<T> = Option<T>;

/// Reads a [`Choice`].
fn choice<T: FromStr + VariantNames + Clone + Send + Sync + 'static>()
-> impl TypedValueParser<Value = Choice<T>> {
    let names = iter::once("auto").chain(T::VARIANTS.iter().copied());
    PossibleValuesParser::new(names).map(|name| name.parse().ok())
}

/// Reads the name of a palette with colours.
fn palette() -> impl TypedValueParser<Value = Palette> {
    PossibleValuesParser::new(["dark", "light"]).map(|name| match name.as_str() {
        "light" => Palette::Light,
        _ => Palette::Dark,
    })
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
        let any = |own: Vec<PathBuf>, outer| if own.is_empty() { outer } else { own };
        Self {
            charset: self.charset.or(other.charset),
            color: self.color.or(other.color),
            palette: self.palette.or(other.palette),
            seed: self.seed.or(other.seed),
            player: self.player.or(other.player),
            lessons: any(self.lessons, other.lessons),
            levels: any(self.levels, other.levels),
            concepts: any(self.concepts, other.concepts),
            data_dir: self.data_dir.or(other.data_dir),
        }
    }

    /// The glyphs to write with, with `auto` standing for the given ones.
    pub(super) fn charset(&self, auto: Charset) -> Charset {
        self.charset.unwrap_or(auto)
    }

    /// The glyphs to print with.
    pub(super) fn printed(&self) -> Charset {
        self.charset(terminal::charset(|name| env::var(name).ok()))
    }

    /// The folders of own questions, as a shell takes them.
    pub(super) fn concepts(&self) -> Vec<String> {
        let folders = self
            .concepts
            .iter()
            .map(|folder| folder.display().to_string());
        let quoted = |folder: String| match shlex::try_quote(&folder) {
            Ok(quoted) => quoted.into_owned(),
            Err(_) => folder,
        };
        folders.map(quoted).collect()
    }

    /// The name of the player: the one given, or else who played last.
    pub(super) fn player_name(&self) -> String {
        let kept = || {
            let file = self.data_dir()?.join(KeptSettings::FILE);
            Some(settings::read(&file).ok()?.over(Settings::default()).player)
        };
        let name = self.player.clone().or_else(kept);
        name.unwrap_or_else(|| Settings::default().player)
    }

    /// What the player has set, with `auto` standing for the given look.
    /// What they leave open is as it was `kept` from the run before.
    pub(super) fn settings(&self, auto: Auto, kept: &KeptSettings) -> Settings {
        let found = kept.over(Settings {
            charset: auto.charset,
            depth: auto.depth,
            ..Settings::default()
        });
        Settings {
            charset: self.charset(found.charset),
            depth: self.color.unwrap_or(found.depth),
            palette: self.palette.unwrap_or(found.palette),
            player: self.player.clone().unwrap_or(found.player),
            ..found
        }
    }

    /// The levels of the program and those of the folders given. Files that are no
    /// good are left out and listed on the screen of the levels.
    pub(super) fn shelf(&self) -> Shelf {
        match self.levels.as_slice() {
            [] => Shelf::default(),
            dirs => Shelf::new(LevelLibrary::embedded().with(dirs)),
        }
    }

    /// The chapters of the program and those of the folders given. Files that are no
    /// good are left out and listed in the contents.
    pub(super) fn book(&self) -> Book {
        match self.lessons.as_slice() {
            [] => Book::default(),
            dirs => Book::new(ChapterLibrary::embedded().with(dirs)),
        }
    }

    /// The written questions of the folders given. Files that are no good are left out
    /// and listed where a round of them is chosen.
    pub(super) fn own(&self) -> Arc<Library> {
        Arc::new(Library::default().with(&self.concepts))
    }

    /// The folders given with levels, chapters and written questions.
    pub(super) fn own_folders(&self) -> [&[PathBuf]; 3] {
        [&self.levels, &self.lessons, &self.concepts]
    }

    /// What is wrong with files in them.
    pub(super) fn problems(&self) -> Vec<FileError> {
        [
            self.shelf().library().problems.as_slice(),
            &self.book().library().problems,
            &self.own().problems,
        ]
        .concat()
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
fn folder(path: &str) -> Result<PathBuf, &'static str> {
    let path = Some(PathBuf::from(path)).filter(|path| path.is_dir());
    path.ok_or("expected a folder that is there")
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
