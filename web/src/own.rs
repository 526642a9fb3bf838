//! A teacher's own levels, chapters and questions, and other opened files.

use std::sync::Arc;

use carrom::app::Data;
use carrom::files::FileLibrary;
use carrom::lessons::{Book, ChapterLibrary};
use carrom::levels::{LevelLibrary, Shelf};
use carrom::measure::{self, Given, Measurement, Reading};
use carrom::messages::FileKind;
use carrom::quiz::concepts::Library;
use carrom::screens::KeptSettings;
use carrom::store::FileBytes;

use crate::keeping::{Change, OWN, PageStorage};

/// The path of the database of answers.
pub(crate) const PROGRESS: &str = "progress.db";

/// The first bytes of every SQLite database.
const DATABASE: &[u8] = b"SQLite format 3\0";

/// All levels, chapters and questions: the built-in ones and those in these files,
/// `levels/PACK/FILE.toml`, `lessons/FILE.md` and `concepts/SUBJECT.toml`.
pub(crate) fn data(files: &[FileBytes]) -> Data {
    let folder = Some("This browser.".to_owned());
    if files.iter().all(|(path, _)| path == KeptSettings::FILE) {
        return Data {
            folder,
            ..Data::default()
        };
    }
    let mut levels = LevelLibrary::embedded();
    let mut chapters = ChapterLibrary::embedded();
    let mut concepts = Library::default();
    for (path, bytes) in files {
        let path = path.strip_prefix(OWN).unwrap_or(path);
        let (folder, rest) = path.split_once('/').unwrap_or(("", path));
        match folder {
            "levels" => levels.add_bytes(rest.as_ref(), bytes),
            "lessons" => chapters.add_bytes(rest.as_ref(), bytes),
            "concepts" => {
                let subject = rest.trim_end_matches(".toml");
                concepts.add(subject, rest, bytes);
            }
            _ => {}
        }
    }
    Data {
        shelf: Shelf::new(levels),
        book: Book::new(chapters),
        own: Arc::new(concepts),
        folder,
    }
}

/// The settings among these files; an invalid settings file is ignored.
pub(crate) fn settings(files: &[FileBytes]) -> KeptSettings {
    let file = files.iter().find(|(path, _)| path == KeptSettings::FILE);
    let read = file.and_then(|(path, bytes)| KeptSettings::read(path, bytes).ok());
    read.unwrap_or_default()
}

/// The path at which [`data`] expects a teacher's file with this content; `None` if the file is of
/// another kind.
pub(crate) fn path(name: &str, bytes: &[u8]) -> Option<String> {
    let text = str::from_utf8(bytes).ok()?;
    let begins = |line: &str| text.lines().any(|it| it.trim_start().starts_with(line));
    Some(match () {
        () if name.ends_with(".md") => format!("lessons/{name}"),
        () if !name.ends_with(".toml") => return None,
        () if begins("[[disc]]") => format!("levels/own/{name}"),
        () if begins("[[item]]") => format!("concepts/{name}"),
        () => return None,
    })
}

/// The measured collision in a file of tracks; `None` if the file is of another kind.
pub(crate) fn measured(name: &str, bytes: &[u8]) -> Option<Result<Measurement, String>> {
    let is_table = [".txt", ".csv", ".tsv"]
        .iter()
        .any(|ending| name.ends_with(ending));
    is_table.then(|| {
        let reading = Reading {
            takes_pixels: true,
            ..Reading::default()
        };
        let tracks = measure::read(&[(name, bytes)], &reading);
        let tracks = tracks.map_err(|errors| errors.to_string())?;
        let measured = Measurement::new(tracks, Given::default());
        measured.map_err(|fault| fault.of_file(name).to_string())
    })
}

/// Adds a file that the player has opened. Returns a notice, and whether carrom has to be opened
/// again to show the contents.
///
/// # Errors
/// The error in words.
pub(crate) fn take_in(
    keeping: &mut PageStorage,
    name: &str,
    bytes: &[u8],
) -> Result<(String, bool), String> {
    let wrong = |error: String| format!("{name} cannot be opened: {error}");
    if bytes.starts_with(DATABASE) || name.ends_with(".db") {
        let progress = Change::Progress(bytes.to_vec());
        keeping.take_in(progress).map_err(wrong)?;
        let words = format!("The progress in {name} has been added to your progress here.");
        return Ok((words, true));
    }
    if let Some(path) = path(name, bytes) {
        let data = data(&[(path.clone(), bytes.to_vec())]);
        let problems = data.shelf.library().problems.iter();
        let problems = problems
            .chain(&data.book.library().problems)
            .chain(&data.own.problems);
        let problems: Vec<_> = problems.map(ToString::to_string).collect();
        if !problems.is_empty() {
            return Err(wrong(problems.join(" ")));
        }
        let file = (format!("{OWN}{path}"), bytes.to_vec());
        keeping.take_in(Change::Own(file)).map_err(wrong)?;
        let found = match path.split('/').next() {
            Some("levels") => "Its level is under Levels, in the pack \u{201c}own\u{201d}",
            Some("lessons") => "Its chapter is under Learn",
            _ => "Its questions are under Quiz, in the round \u{201c}your own questions\u{201d}",
        };
        return Ok((format!("{name} is saved. {found}."), true));
    }
    if name.ends_with(".toml") {
        // In every format, class rounds have this field and saved games do not.
        let is_class = String::from_utf8_lossy(bytes).contains("\nstep = ");
        let file = (name.to_owned(), bytes.to_vec());
        let (kind, place) = match is_class {
            true => (FileKind::Class, "the earlier rounds of a class"),
            false => (FileKind::Game, "the saved games"),
        };
        let taken = keeping.take_in(Change::File(kind, file)).map_err(wrong);
        return taken.map(|()| (format!("{name} has been added to {place}."), false));
    }
    Err(format!(
        "carrom cannot open {name}. It opens progress.db, a saved game, a round of a class, a level, a \
         chapter, a file of questions and the tracks of a collision."
    ))
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;

    #[test]
    fn each_kind_of_a_teachers_file_is_recognized_by_its_content() {
        let questions = include_bytes!("../../assets/examples/questions/our-coins.toml");
        let level = include_bytes!("../../assets/examples/levels/our-pack/a-glance.toml");
        let chapter = include_bytes!("../../assets/examples/chapters/01-our-coins.md");
        for (name, bytes, expected) in [
            ("our-coins.toml", &questions[..], "concepts/our-coins.toml"),
            ("a-glance.toml", level, "levels/own/a-glance.toml"),
            ("01-our-coins.md", chapter, "lessons/01-our-coins.md"),
        ] {
            assert_eq!(path(name, bytes).as_deref(), Some(expected));
        }
        let own = data(&[("own/concepts/our-coins.toml".into(), questions.to_vec())]).own;
        assert!(own.problems.is_empty() && !own.concepts.is_empty());
        // The number of a pack only determines its position, as in the program.
        let numbered = ("levels/2-our-pack/a-glance.toml".into(), level.to_vec());
        let shelf = data(&[numbered]).shelf;
        let pack = shelf.library().packs.last();
        assert_eq!(pack.map(|it| it.name.as_str()), Some("our-pack"));
        let tracks = include_bytes!("../../assets/examples/measured/pucks.txt");
        assert!(measured("pucks.txt", tracks).is_some_and(|it| it.is_ok()));
        // Positions in pixels are accepted: the player sets the scale later, on the screen.
        let pixels = include_bytes!("../../assets/examples/measured/careless.csv");
        assert!(measured("careless.csv", pixels).is_some_and(|it| it.is_ok()));
        assert!(measured("notes.txt", b"hello").is_some_and(|it| it.is_err()));
        assert!(measured("a.toml", level).is_none());
        assert_eq!(path("saved.toml", b"format = 1\nmoves = []\n"), None);
        assert_eq!(path("picture.png", b"\x89PNG"), None);
    }

    #[test]
    fn rounds_and_games_of_every_format_are_taken_in() {
        let mut keeping = PageStorage::new(&Arc::default(), false);
        let saves = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/saves");
        let mut found = [0; 2];
        for entry in fs::read_dir(saves).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap();
            let kinds = ["class-", "format-"];
            let Some(kind) = kinds.iter().position(|kind| name.starts_with(kind)) else {
                continue;
            };
            let place = ["earlier rounds", "saved games"][kind];
            let taken = take_in(&mut keeping, name, &fs::read(&path).unwrap());
            assert!(
                taken.as_ref().is_ok_and(|(it, _)| it.contains(place)),
                "{name}: {taken:?}"
            );
            found[kind] += 1;
        }
        assert_eq!(found, [7, 3]);
    }
}
