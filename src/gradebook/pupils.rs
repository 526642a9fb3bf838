//! The pupils who have handed in answers; each pupil and each answer occurs once.

use std::collections::{BTreeSet, HashSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::{ClassResults, HandIn, PupilResults};
use crate::files::{self, tidy_name};
use crate::numbers::counted;
use crate::progress::Attempt;
use crate::quiz::Figures;

/// A pupil with all answers from all hand-ins.
#[derive(Debug, Clone, PartialEq)]
pub struct Pupil {
    /// The name; a second pupil called Ada in the same class is "Ada (2)".
    pub name: String,
    /// The class, as the pupil wrote it.
    pub class: String,
    /// All answers, in chronological order.
    pub attempts: Vec<Attempt>,
    /// The name without the number that distinguishes pupils of the same name.
    own_name: String,
}

impl Pupil {
    /// Whether the hand-in is from this pupil: both have the same name, the same class (or one of
    /// them names no class), and an answer in common (or one of them has no answers).
    fn is(&self, other: &HandIn) -> bool {
        let shares = || {
            let handed_in: HashSet<_> = other.attempts.iter().map(identity).collect();
            { self.attempts.iter() }.any(|it| handed_in.contains(&identity(it)))
        };
        let empty = self.attempts.is_empty() || other.attempts.is_empty();
        self.is_called_as(other) && (empty || shares())
    }

    /// Whether the pupil and the hand-in have the same name and may be of the same class.
    fn is_called_as(&self, other: &HandIn) -> bool {
        let alike = |a: &str, b: &str| a.to_lowercase() == b.to_lowercase();
        let unnamed = self.class.is_empty() || other.class.is_empty();
        alike(&self.own_name, &other.name) && (unnamed || alike(&self.class, &other.class))
    }
}

/// The identity of an answer across files: its time and position, the question and the answer.
type Identity<'a> = ((Option<i64>, u64, u32), &'a str, [&'a Figures; 2]);

fn identity(it: &Attempt) -> Identity<'_> {
    (
        (it.time_s, it.seed, it.number),
        &it.family,
        [&it.question, &it.answer],
    )
}

/// All pupils, sorted by name.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Gradebook {
    /// The pupils.
    pub pupils: Vec<Pupil>,
    /// Notes for the teacher, on the files and on pupils who have handed in nothing.
    pub notes: Vec<String>,
}

/// The extension of files that are handed in.
const ENDING: &str = "json";

impl Gradebook {
    /// The hand-ins in a folder; if a class is given, only those of that class.
    ///
    /// # Errors
    /// If the folder cannot be read. Files that cannot be read are noted instead.
    pub fn of_folder(folder: &Path, class: Option<&str>) -> io::Result<Self> {
        let paths = fs::read_dir(folder)?.flatten().map(|entry| entry.path());
        let is_handed_in = |path: &PathBuf| {
            let ending = path.extension().and_then(|it| it.to_str());
            ending.is_some_and(|it| it.eq_ignore_ascii_case(ENDING))
        };
        let mut paths: Vec<PathBuf> = paths.filter(is_handed_in).collect();
        paths.sort();
        let mut book = Self::default();
        for path in &paths {
            // Reading a pipe or a device may never end.
            let bytes = match path.is_file() {
                true => files::read(path, HandIn::LARGEST_FILE),
                false => Err(files::not_a_file(path)),
            };
            let read = bytes
                .map_err(|error| error.message)
                .and_then(|bytes| HandIn::read(&bytes));
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let is_of_class = |it: &HandIn| {
                class.is_none_or(|wanted| it.class.to_lowercase() == wanted.to_lowercase())
            };
            if read.as_ref().is_ok_and(is_of_class) || read.is_err() {
                book.add(&name, read);
            }
        }
        Ok(book)
    }

    /// Adds the contents of a file, or the reason why it could not be read. A pupil or an answer
    /// that occurs again is counted once.
    pub fn add(&mut self, file: &str, read: Result<HandIn, String>) {
        let hand_in = match read {
            Ok(hand_in) => hand_in,
            Err(reason) => return self.notes.push(format!("{file}: left out; {reason}")),
        };
        let name = hand_in.name.clone();
        if let Some(pupil) = self.pupils.iter_mut().find(|it| it.is(&hand_in)) {
            let all = hand_in.attempts.len();
            let mut fresh = hand_in.attempts;
            let known: HashSet<_> = pupil.attempts.iter().map(identity).collect();
            fresh.retain(|it| !known.contains(&identity(it)));
            drop(known);
            let words = match fresh.len() {
                0 => "no new answers".to_owned(),
                new => format!("{} out of {all}", counted(new, "new answer")),
            };
            self.notes.push(format!("{file}: {name} again; {words}"));
            if pupil.class.is_empty() {
                pupil.class = hand_in.class;
            }
            pupil.attempts.extend(fresh);
            pupil.attempts.sort_by_key(|it| it.time_s);
            return;
        }
        let alike = { self.pupils.iter() }.filter(|it| it.is_called_as(&hand_in));
        let shown = match alike.count() {
            0 => name.clone(),
            others => {
                let shown = format!("{name} ({})", others + 1);
                self.notes.push(format!(
                    "{file}: another {name}, with no answer in common; shown as {shown}"
                ));
                shown
            }
        };
        let mut attempts = hand_in.attempts;
        attempts.sort_by_key(|it| it.time_s);
        self.pupils.push(Pupil {
            name: shown,
            class: hand_in.class,
            attempts,
            own_name: name,
        });
        self.pupils
            .sort_by_key(|it| (it.name.to_lowercase(), it.class.to_lowercase()));
    }

    /// The classes of all pupils: "10a; 10b".
    pub fn classes(&self) -> String {
        let named = self.pupils.iter().map(|it| it.class.as_str());
        let classes: BTreeSet<&str> = named.filter(|it| !it.is_empty()).collect();
        Vec::from_iter(classes).join("; ")
    }

    /// Notes which of these pupils have handed in nothing; upper and lower case and surrounding
    /// spaces do not matter.
    pub(crate) fn look_for<'a>(&mut self, names: impl IntoIterator<Item = &'a str>) {
        let known = self.pupils.iter().map(|it| it.own_name.to_lowercase());
        let known: HashSet<String> = known.collect();
        let mut missing: Vec<String> = names.into_iter().map(tidy_name).collect();
        missing.retain(|it| !it.is_empty() && !known.contains(&it.to_lowercase()));
        if !missing.is_empty() {
            let (count, names) = (counted(missing.len(), "pupil"), missing.join(", "));
            self.notes.push(format!(
                "{count} on the class list handed in nothing: {names}"
            ));
        }
    }

    /// The results of every pupil.
    pub fn results(&self) -> ClassResults<'_> {
        ClassResults {
            book: self,
            pupils: self.pupils.iter().map(PupilResults::of).collect(),
        }
    }
}
