//! Packs of levels: the built-in packs, and a teacher's own packs from a folder.

use std::path::Path;
use std::sync::LazyLock;

use include_dir::{Dir, include_dir};

use super::level::Level;
use crate::files::{self, FileError, FileLibrary};
use crate::numbers::capital;

static EMBEDDED: Dir = include_dir!("$CARGO_MANIFEST_DIR/levels");

/// Levels that belong together, sorted by the names of their files.
#[derive(Debug, Clone, PartialEq)]
pub struct Pack {
    /// The name of the folder. A number in front of the name is left out, because it only
    /// determines the order.
    pub name: String,
    /// The levels; no two have the same id.
    pub levels: Vec<Level>,
}

impl Pack {
    /// The name as a title: `first-hits` becomes "First hits".
    pub(crate) fn title(&self) -> String {
        capital(&self.name.replace(['-', '_'], " "))
    }
}

/// All available levels.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LevelLibrary {
    /// The packs, in the order in which they are shown.
    pub packs: Vec<Pack>,
    /// The errors in the files that were left out.
    pub problems: Vec<FileError>,
}

impl LevelLibrary {
    /// The built-in packs. They never change, so they are read only once per process, when they are
    /// first needed.
    pub fn embedded_once() -> &'static Self {
        static READ: LazyLock<LevelLibrary> = LazyLock::new(LevelLibrary::embedded);
        &READ
    }

    /// Adds the level in a file to a pack, given the bytes of the file.
    fn add(&mut self, pack: &str, file: &str, bytes: &[u8]) {
        let known = self.packs.iter_mut().find(|known| known.name == pack);
        let others = known.as_ref().map_or(&[][..], |pack| &pack.levels);
        match (Level::read_beside(file, bytes, others), known) {
            (Err(errors), _) => self.problems.extend(errors),
            (Ok(level), Some(known)) => known.levels.push(level),
            (Ok(level), None) => self.packs.push(Pack {
                name: pack.into(),
                levels: vec![level],
            }),
        }
    }
}

impl FileLibrary for LevelLibrary {
    const ENDING: &'static str = "toml";
    const MOST_FILES: usize = 500;

    fn embedded() -> Self {
        let mut library = Self::default();
        let mut dirs: Vec<_> = EMBEDDED.dirs().collect();
        dirs.sort_by_key(|dir| order(dir.path()));
        for file in dirs
            .into_iter()
            .flat_map(|dir| files::embedded(dir, Self::ENDING))
        {
            library.add_bytes(file.path(), file.contents());
        }
        library
    }

    fn problems_mut(&mut self) -> &mut Vec<FileError> {
        &mut self.problems
    }

    /// Adds a level to the pack that is named after its folder.
    fn add_bytes(&mut self, path: &Path, bytes: &[u8]) {
        let (_, pack) = path.parent().map(order).unwrap_or_default();
        self.add(&pack, &path.display().to_string(), bytes);
    }

    /// Adds the level files in a folder as one pack, and those in each subfolder as a separate
    /// pack.
    fn add_dir(&mut self, folder: &Path) {
        let mut folders = self.add_files_of(folder);
        folders.sort_by_key(|folder| order(folder));
        for inner in folders {
            self.add_files_of(&inner);
        }
    }
}

/// The position and the name of a folder's pack: `2-right-angle` is the pack "right-angle" at
/// position 2. Folders without a number come first.
pub(crate) fn order(dir: &Path) -> (u32, String) {
    let name = dir
        .file_name()
        .map(|name| name.to_string_lossy().into_owned());
    let name = name.unwrap_or_default();
    let numbered = name.split_once('-').and_then(|(number, rest)| {
        let place = number.parse().ok()?;
        (!rest.is_empty()).then(|| (place, rest.to_owned()))
    });
    numbered.unwrap_or((0, name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_before_a_name_gives_the_position() {
        let ordered = |name: &str| order(Path::new(name));
        assert_eq!(ordered("levels/first-hits"), (0, "first-hits".into()));
        assert_eq!(ordered("2-right-angle"), (2, "right-angle".into()));
        assert!(ordered("10-design") > ordered("9-combinations"));
        for plain in ["2", "2-", "-2", "99999999999-a", "two-2"] {
            assert_eq!(ordered(plain), (0, plain.to_owned()));
        }
    }
}
