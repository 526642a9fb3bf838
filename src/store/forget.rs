//! Deletes everything that is stored about a class.
//!
//! Files are recognized by their contents, not by their names, so that copies made by an editor,
//! and tables and gradebooks that a teacher has written into the data folder, are deleted too. So
//! are unfinished files that were left when carrom was killed.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::disk::LOCK;
use super::folder_lock::FolderLock;
use super::{CLASSES, HANDED_IN};
use crate::class::is_same_class;
use crate::files::{UNFINISHED, fsync_dir};
use crate::paper::CLASS_MARK;

/// The largest file that is examined, in bytes: more than carrom writes about a class.
const LARGEST: u64 = 1 << 26;
/// How many folders deep the data folder is examined.
const DEEPEST: usize = 4;

/// The files that are stored about a class.
#[derive(Debug)]
pub(crate) struct Forgetting {
    folder: PathBuf,
    /// The paths within the data folder, with slashes, sorted.
    pub(crate) files: Vec<String>,
}

impl Forgetting {
    /// Finds the data about a class that a data folder contains.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub(crate) fn find(folder: &Path, class: &str) -> Result<Self, String> {
        let mut files = Vec::new();
        if folder.is_dir() {
            look_through(folder, "", DEEPEST, class, &mut files)?;
        }
        files.sort();
        Ok(Self {
            folder: folder.to_owned(),
            files,
        })
    }

    /// Deletes the files; returns those that were deleted, and the first error.
    pub(crate) fn delete(&self) -> (Vec<String>, Option<String>) {
        let mut deleted = Vec::new();
        let mut trouble = None;
        for file in &self.files {
            let path = self.folder.join(file);
            match remove(&path) {
                Ok(()) => deleted.push(file.clone()),
                Err(error) => {
                    let _ = trouble.get_or_insert(format!("{}: {error}", path.display()));
                }
            }
        }
        (deleted, trouble)
    }
}

/// Removes a file for good, while no other copy of carrom writes to its folder.
fn remove(path: &Path) -> std::io::Result<()> {
    let parent = path.parent().unwrap_or(path);
    // A folder in which carrom keeps nothing has no lock file, and none is created.
    let has_lock = parent.join(LOCK).exists();
    let _guard = { has_lock.then(|| FolderLock::alone(parent, LOCK)) }.transpose()?;
    fs::remove_file(path)?;
    fsync_dir(parent)
}

/// Adds the files of a class in a folder and its subfolders. Links are not followed.
fn look_through(
    folder: &Path,
    within: &str,
    deeper: usize,
    class: &str,
    files: &mut Vec<String>,
) -> Result<(), String> {
    let report = |error: std::io::Error| format!("{}: {error}", folder.display());
    // Nobody uses the unfinished files that a killed copy of carrom left in these folders, but they
    // may contain names.
    let holds_pupils = [CLASSES, HANDED_IN, "exports"].contains(&within);
    for entry in fs::read_dir(folder).map_err(report)? {
        let entry = entry.map_err(report)?;
        let kind = entry.file_type().map_err(report)?;
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        let inner = match within {
            "" => name.clone(),
            within => format!("{within}/{name}"),
        };
        if kind.is_dir() && deeper > 0 {
            look_through(&entry.path(), &inner, deeper - 1, class, files)?;
        } else if kind.is_file() {
            let is_left_over = holds_pupils && name.starts_with(UNFINISHED);
            let is_small = entry.metadata().map_err(report)?.len() <= LARGEST;
            let is_of_class = || fs::read(entry.path()).is_ok_and(|it| is_of(&it, class));
            if is_left_over || (is_small && is_of_class()) {
                files.push(inner);
            }
        }
    }
    Ok(())
}

/// Whether this is the content of a file about the class.
fn is_of(bytes: &[u8], class: &str) -> bool {
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}').trim_start();
    is_round(text, class)
        || is_hand_in(text, class)
        || is_page(text, class)
        || is_table(text, class)
}

/// A saved round, complete or truncated; its head names the class.
fn is_round(text: &str, class: &str) -> bool {
    let head = text.lines().take_while(|line| !line.starts_with('['));
    let mut head = head.filter_map(|line| line.parse::<toml::Table>().ok());
    text.starts_with("format")
        && head.any(|line| names(line.get("class").and_then(|it| it.as_str()), class))
}

/// A hand-in; a truncated one is recognized by its beginning.
fn is_hand_in(text: &str, class: &str) -> bool {
    if !text.starts_with('{') {
        return false;
    }
    match serde_json::from_str::<Value>(text) {
        Ok(file) => {
            file.get("carrom").is_some() && names(file.get("class").and_then(Value::as_str), class)
        }
        Err(_) if !text.contains("\"carrom\"") => false,
        Err(_) => { text.match_indices("\"class\"") }.any(|(at, key)| {
            let value = text[at + key.len()..].trim_start().strip_prefix(':');
            let mut read =
                serde_json::Deserializer::from_str(value.unwrap_or_default()).into_iter::<String>();
            read.next()
                .is_some_and(|it| names(it.ok().as_deref(), class))
        }),
    }
}

/// A table with a column for the class, and a row of this class.
fn is_table(text: &str, class: &str) -> bool {
    let mut table = csv::ReaderBuilder::new()
        .flexible(true)
        .from_reader(text.as_bytes());
    let Ok(heads) = table.headers() else {
        return false;
    };
    let Some(column) = heads.iter().position(|head| head == "class") else {
        return false;
    };
    // A name that begins like a formula has an apostrophe before it.
    let is_named = |cell: &str| {
        let classes = cell
            .split("; ")
            .chain([cell, cell.strip_prefix('\'').unwrap_or(cell)]);
        classes.into_iter().any(|it| is_same_class(it, class))
    };
    let mut rows = table.records().map_while(Result::ok);
    rows.any(|row| row.get(column).is_some_and(is_named))
}

/// A page about classes, whose names are in its attributes.
fn is_page(text: &str, class: &str) -> bool {
    let starts = text.match_indices(CLASS_MARK);
    let mut named = starts.filter_map(|(at, mark)| {
        let value = text[at + mark.len()..].strip_prefix("=\"")?;
        let value = &value[..value.find('"')?];
        let plain = [
            ("&lt;", "<"),
            ("&gt;", ">"),
            ("&quot;", "\""),
            ("&amp;", "&"),
        ];
        Some(plain.iter().fold(value.to_owned(), |text, (mark, plain)| {
            text.replace(mark, plain)
        }))
    });
    text.starts_with("<!DOCTYPE html>") && named.any(|it| is_same_class(&it, class))
}

/// Whether this is the name of the class.
fn names(name: Option<&str>, class: &str) -> bool {
    name.is_some_and(|name| is_same_class(name, class))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_a_class_are_recognized_by_their_content() {
        for text in [
            "format = 6\ncode = \"mixed-7\"\nclass = \"10b\"\nway = \"devices\"\n\n[[then]]\nchange = '{\"join",
            "format = 3\nclass = \"10B\"\n",
            r#"{"format": 1, "carrom": "hand-in", "name": "Ada", "class": "10b ", "answers": []}"#,
            r#"{"format": 1, "carrom": "hand-in", "name": "Ada", "class" : "10b", "answ"#,
            "code,team,class\nmixed-7,Ants,10c\nmixed-7,Bees,10b\n",
            "round,class\nmixed-7,10a; 10b\n",
            "name,class,points\n\"Ada\",10b,3\n\"Bo",
            "<!DOCTYPE html><div data-class=\"10c\"></div><div data-class=\"10b\">",
        ] {
            assert!(is_of(text.as_bytes(), "10b"), "{text}");
            let other = text.replace("10b", "10d").replace("10B", "10d");
            assert!(!is_of(other.as_bytes(), "10b"), "{other}");
        }
        let odd = "<!DOCTYPE html><p data-class=\"a &amp; &quot;b&quot;\">";
        assert!(is_of(odd.as_bytes(), "A & \"B\""));
        assert!(is_of(b"class\n'=10b\n", "=10b"));
        for text in [
            "",
            "10b",
            "class\n",
            "{}",
            "{\"class\":",
            "[game]\nclass = \"10b\"\n",
            "{\"class\": \"10b\"}",
        ] {
            assert!(!is_of(text.as_bytes(), "10b"), "{text}");
        }
    }
}
