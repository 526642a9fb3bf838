//! Options that every command takes.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;
use std::{env, iter};

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use etcetera::BaseStrategy;
use strum::VariantNames;

use super::given;
use crate::files::{FileError, FileLibrary, tidy_name};
use crate::game::is_player_name;
use crate::lessons::{Book, ChapterLibrary};
use crate::levels::{LevelLibrary, Shelf};
use crate::quiz::concepts::Library;
use crate::screens::{KeptSettings, Settings};
use crate::shells::terminal;
use crate::store::Store;
use crate::widgets::{Blocks, Charset, Depth, Palette};

/// Options that every command takes.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Global options")]
pub(crate) struct GlobalOptions {
    /// Glyphs to draw with; auto: unicode in a UTF-8 locale
    #[arg(long, global = true, value_name = "SET", default_value = "auto",
          value_parser = choice::<Charset>())]
    charset: Choice<Charset>,
    /// Block elements for discs in Unicode; auto: the finest that the terminal is known to draw
    #[arg(long, global = true, value_name = "SET", default_value = "auto",
          value_parser = choice::<Blocks>())]
    blocks: Choice<Blocks>,
    /// Colours to draw with; auto: what the terminal supports, and none with NO_COLOR
    #[arg(long, global = true, value_name = "DEPTH", default_value = "auto",
          value_parser = choice::<Depth>())]
    color: Choice<Depth>,
    /// Colour palette: dark for a desk, light for a projector in a bright room
    #[arg(long, global = true, value_name = "PALETTE", value_parser = palette())]
    palette: Option<Palette>,
    /// Seed for everything random, such as the questions of a quiz
    #[arg(long, global = true, value_name = "N", value_parser = seed,
          allow_negative_numbers = true)]
    pub(super) seed: Option<u64>,
    /// Name of the player
    #[arg(long, global = true, value_name = "NAME", value_parser = player)]
    player: Option<String>,
    /// Folder with your own levels, added to the built-in ones; can be repeated
    #[arg(long, global = true, value_name = "DIR", value_parser = folder)]
    pub(super) levels: Vec<PathBuf>,
    /// Folder with your own chapters, added to the built-in ones; can be repeated
    #[arg(long, global = true, value_name = "DIR", value_parser = folder)]
    pub(super) lessons: Vec<PathBuf>,
    /// Folder with your own questions in words, asked in separate rounds; can be repeated
    #[arg(long, global = true, value_name = "DIR", value_parser = folder)]
    pub(super) concepts: Vec<PathBuf>,
    /// Folder for carrom's data, such as saved games and every answer (default: the
    /// system's folder for application data)
    #[arg(long, global = true, value_name = "DIR")]
    data_dir: Option<PathBuf>,
}

/// The value of an option that has a fixed list of names; `None` for `auto`.
type Choice<T> = Option<T>;

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
    /// ASCII without colour, which works everywhere.
    pub(super) const PLAINEST: Self = Self {
        charset: Charset::Ascii,
        depth: Depth::None,
    };
}

impl GlobalOptions {
    /// These options; those that are not given are taken from `other`.
    pub(super) fn or(self, other: &Self) -> Self {
        let other = other.clone();
        let any = |own: Vec<PathBuf>, outer| if own.is_empty() { outer } else { own };
        Self {
            charset: self.charset.or(other.charset),
            blocks: self.blocks.or(other.blocks),
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

    /// The charset for printed text.
    pub(super) fn printed(&self) -> Charset {
        let auto = || terminal::charset(|name| env::var(name).ok());
        self.charset.unwrap_or_else(auto)
    }

    /// The options that open the teacher's own questions on a screen: " --concepts my-folder".
    pub(super) fn of_own(&self, set: Option<&Path>) -> String {
        let folders = self.concepts.iter().map(|it| ("concepts", it.as_path()));
        let set = set.map(|it| ("set", it));
        let option = |(name, path): (&str, &Path)| {
            let path = path.display().to_string();
            let quoted = shlex::try_quote(&path).map_or(path.clone(), Into::into);
            format!(" --{name} {quoted}")
        };
        set.into_iter().chain(folders).map(option).collect()
    }

    /// The player's name: the given one, or else that of the last player.
    pub(super) fn player_name(&self) -> String {
        let kept = || {
            let kept = given::settings(&self.data_dir()?).ok()?;
            Some(kept.over(Settings::default()).player)
        };
        let name = self.player.clone().or_else(kept);
        name.unwrap_or_else(|| Settings::default().player)
    }

    /// The settings that these options give. An option that is missing or `auto` keeps the setting
    /// from earlier runs; if there is none, the charset and the colours are those in the
    /// argument `auto`.
    pub(super) fn settings(&self, auto: Auto, kept: &KeptSettings) -> Settings {
        let found = kept.over(Settings {
            charset: auto.charset,
            depth: auto.depth,
            ..Settings::default()
        });
        Settings {
            charset: self.charset.unwrap_or(found.charset),
            blocks: self.blocks.or(found.blocks),
            depth: self.color.unwrap_or(found.depth),
            palette: self.palette.unwrap_or(found.palette),
            player: self.player.clone().unwrap_or(found.player),
            ..found
        }
    }

    /// The built-in levels and those in the given folders. Files with errors are left out and
    /// listed on the levels screen.
    pub(super) fn shelf(&self) -> Shelf {
        match self.levels.as_slice() {
            [] => Shelf::default(),
            dirs => Shelf::new(LevelLibrary::embedded().with(dirs)),
        }
    }

    /// The built-in chapters and those in the given folders. Files with errors are left out and
    /// listed in the contents.
    pub(super) fn book(&self) -> Book {
        match self.lessons.as_slice() {
            [] => Book::default(),
            dirs => Book::new(ChapterLibrary::embedded().with(dirs)),
        }
    }

    /// The written questions in the given folders. Files with errors are left out and listed where
    /// rounds are chosen.
    pub(super) fn own(&self) -> Arc<Library> {
        Arc::new(Library::default().with(&self.concepts))
    }

    /// Like [`Self::own`], but with the set in this file added.
    ///
    /// # Errors
    /// All errors in the file of the set.
    pub(super) fn own_with(&self, set: Option<&Path>) -> Result<Arc<Library>, String> {
        let mut own = Library::default().with(&self.concepts);
        if let Some(set) = set {
            own.add_set(set).map_err(|errors| errors.to_string())?;
        }
        Ok(Arc::new(own))
    }

    /// The errors in the files of the given folders.
    pub(super) fn problems(&self) -> Vec<FileError> {
        [
            self.shelf().library().problems.as_slice(),
            &self.book().library().problems,
            &self.own().problems,
        ]
        .concat()
    }

    /// The data folder, if one is given.
    pub(super) fn given_data_dir(&self) -> Option<&Path> {
        self.data_dir.as_deref()
    }

    /// The data folder; `None` if none is given and the system has no home folder.
    pub(super) fn data_dir(&self) -> Option<PathBuf> {
        self.data_dir.clone().or_else(|| {
            let system = etcetera::choose_base_strategy().ok()?;
            Some(system.data_dir().join("carrom"))
        })
    }

    /// The store; if no folder is known, it stores nothing.
    pub(super) fn store(&self) -> Store {
        let folder = self.data_dir();
        folder.map_or_else(Store::nowhere, |folder| Store::in_folder(&folder))
    }
}

/// Reads the path of an existing folder.
fn folder(path: &str) -> Result<PathBuf, &'static str> {
    let path = Some(PathBuf::from(path)).filter(|path| path.is_dir());
    path.ok_or("expected an existing folder")
}

/// Reads a name that can be shown: not empty, not too long, only visible characters.
fn player(name: &str) -> Result<String, String> {
    if !is_player_name(name.trim()) {
        return Err("expected a name of 1 to 40 visible characters".into());
    }
    Ok(tidy_name(name))
}

fn seed(text: &str) -> Result<u64, String> {
    let expected = || format!("expected a whole number from 0 to {}", u64::MAX);
    text.parse().map_err(|_| expected())
}
