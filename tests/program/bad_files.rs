//! Invalid files, each with the message that it must cause.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use carrom::files::FileError;
use proptest::prelude::*;

/// A folder of invalid files: `NAME.expected` contains the expected message for `NAME.ENDING`, or
/// for the folder `NAME`.
pub(crate) struct BadFiles {
    /// The folder's path below `tests`.
    pub(crate) folder: &'static str,
    /// The extension of the files.
    pub(crate) ending: &'static str,
}

impl BadFiles {
    pub(crate) fn path(&self) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests")
            .join(self.folder)
    }

    /// Runs carrom in the folder.
    pub(crate) fn carrom(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_carrom"))
            .args(arguments)
            .current_dir(self.path())
            .output()
            .expect("carrom runs")
    }

    /// The names of the message files without their extension.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.path()).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let names: Vec<_> = names.collect();
        let expected: Vec<_> = names
            .iter()
            .filter_map(|name| name.strip_suffix(".expected").map(str::to_owned))
            .collect();
        assert_eq!(
            2 * expected.len(),
            names.len(),
            "every bad file has a message, and every message a file"
        );
        expected
    }

    /// The expected message for a name.
    pub(crate) fn expected(&self, name: &str) -> String {
        let path = self.path().join(format!("{name}.expected"));
        fs::read_to_string(path).unwrap().trim_end().to_owned()
    }

    /// Runs a command with each file or folder. It must print the expected message and exit with
    /// status 2. `printed` is given the standard output, and whether the argument is a file.
    pub(crate) fn each(&self, command: [&str; 2], printed: impl Fn(&str, bool, &[u8])) {
        for name in self.names() {
            let file = format!("{name}.{}", self.ending);
            let is_file = self.path().join(&file).exists();
            let bad = if is_file { &file } else { &name };
            let output = self.carrom(&[command[0], command[1], bad]);
            assert_eq!(message(&output), self.expected(&name), "{name}");
            assert_eq!(output.status.code(), Some(2), "{name}");
            printed(&name, is_file, &output.stdout);
        }
    }
}

/// The message on standard error, without the program's name before it.
pub(crate) fn message(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr);
    let text = text.trim_end();
    text.strip_prefix("carrom: ").unwrap_or(text).to_owned()
}

/// The number of files in which these errors were found.
pub(crate) fn files(errors: &[FileError]) -> usize {
    let files: BTreeSet<_> = errors.iter().map(|error| &error.file).collect();
    files.len()
}

/// A valid file from a folder, with a part of it replaced with a `piece`.
pub(crate) fn mutated(
    folder: &str,
    piece: impl Strategy<Value = String>,
) -> impl Strategy<Value = Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = fs::read_dir(folder).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let files: Vec<_> = paths.iter().map(|path| fs::read(path).unwrap()).collect();
    let files = prop::sample::select(files);
    let at = any::<prop::sample::Index>();
    (files, at, 0_usize..8, piece).prop_map(|(mut bytes, at, length, piece)| {
        let start = at.index(bytes.len());
        let end = (start + length).min(bytes.len());
        bytes.splice(start..end, piece.bytes());
        bytes
    })
}
