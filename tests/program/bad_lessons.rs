//! Chapters with errors. Each causes only its own message, with file and line, and exit
//! status 2; the other chapters still open.
//!
//! `tests/bad-lessons/NAME.expected` contains the expected message for `NAME.md`.

use carrom::cli;
use carrom::files::FileLibrary;
use carrom::lessons::{Chapter, ChapterLibrary};
use carrom::screens::learn::check;
use carrom::shells::Headless;
use proptest::prelude::*;

use crate::bad_files::{self, BadFiles, message};

const BAD: BadFiles = BadFiles {
    folder: "bad-lessons",
    ending: "md",
};

#[test]
fn every_invalid_chapter_causes_its_message() {
    BAD.each(["lesson", "check"], |_, _, _| {});
}

#[test]
fn the_other_chapters_open_despite_invalid_files() {
    let mut library = ChapterLibrary::embedded();
    let own = library.chapters.len();
    library.add_dir(&BAD.path());
    // Chapters whose only fault is that they do not fit a small screen can be read.
    let readable = ["too-long", "formula-too-wide"];
    assert_eq!(library.chapters.len(), own + readable.len());
    let bad = bad_files::files(&library.problems);
    assert_eq!(bad, BAD.names().len() - readable.len());

    let arguments = format!("learn --lessons '{}'", BAD.path().display());
    let mut game = Headless::new(cli::open(&arguments).unwrap(), 100, 60);
    let screen = game.screen();
    assert!(screen.contains("left out"), "{screen}");
    game.press("<End>");
    let screen = game.screen();
    // The length of the folder's name determines where the message is wrapped.
    assert!(
        screen.contains("what is wrong") && screen.contains("expected"),
        "{screen}"
    );
    game.press("<Home><Enter>");
    assert!(game.screen().contains("page 1 of"));
}

#[test]
fn the_built_in_chapters_are_valid() {
    let output = BAD.carrom(&["lesson", "check"]);
    assert_eq!(message(&output), "");
    assert_eq!(output.status.code(), Some(0));
    let report = String::from_utf8(output.stdout).unwrap();
    assert_eq!(
        report.lines().count(),
        ChapterLibrary::embedded().chapters.len()
    );
}

#[test]
fn a_missing_file_is_named() {
    let output = BAD.carrom(&["lesson", "check", "99-none.md"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(message(&output).starts_with("99-none.md: cannot be read: "));
}

#[test]
fn figures_are_drawn_without_a_terminal() {
    for figure in [
        "lab", "split", "triangle", "frames", "curves", "angles", "energy", "worked", "solve",
        "foil", "shots",
    ] {
        let output = BAD.carrom(&["figure", figure, "alpha_deg=40"]);
        assert_eq!(output.status.code(), Some(0), "{figure}");
        let svg = String::from_utf8(output.stdout).unwrap();
        assert!(
            svg.starts_with("<svg ") && svg.ends_with("</svg>\n"),
            "{figure}"
        );
    }
    for (words, expected) in [
        (["figure", "movie"], "expected a figure (lab, split,"),
        (["figure", "lab"], ""),
    ] {
        assert!(message(&BAD.carrom(&words)).starts_with(expected));
    }
    let output = BAD.carrom(&["figure", "curves", "m1_g=-1"]);
    assert_eq!(
        message(&output),
        "m1_g: expected a mass in g from 0.1 to 1000, found -1"
    );
    assert_eq!(output.status.code(), Some(2));
}

/// A chapter with a part of it replaced.
fn mutated() -> impl Strategy<Value = Vec<u8>> {
    let piece = prop_oneof![
        "[0-9.eE+-]{0,6}",
        "[-$\\{\\}:#*_`\\[\\]()=/^ ]{0,5}",
        "\\PC{0,4}",
        Just("\n# X\n".to_owned()),
        Just("\n:::choice\n".to_owned()),
        Just("\n::lab alpha_deg=90\n".to_owned()),
    ];
    bad_files::mutated("assets/lessons", piece)
}

fn is_chapter_or_message(bytes: &[u8], whole: bool) -> Result<(), TestCaseError> {
    match Chapter::read("01-any.md", bytes) {
        Ok(chapter) => {
            prop_assert!(!chapter.pages.is_empty());
            if whole {
                // The layout of every page must succeed.
                let _ = check(&chapter);
            }
        }
        Err(errors) => {
            for error in errors {
                let message = error.to_string();
                prop_assert!(message.starts_with("01-any.md:"), "{message}");
                prop_assert!(!message.contains(char::is_control), "{message:?}");
            }
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn any_bytes_give_a_chapter_or_a_message(bytes in proptest::collection::vec(any::<u8>(), 0..2000)) {
        is_chapter_or_message(&bytes, true)?;
    }

    #[test]
    fn any_text_gives_a_chapter_or_a_message(text in "[-a-z0-9 \n$\\{\\}:#*_`\\[\\]()=/^αθ.]{0,300}") {
        let header = "+++\nformat = 1\ntitle = \"T\"\nabout = \"A\"\n+++\n# P\n";
        is_chapter_or_message(format!("{header}{text}").as_bytes(), true)?;
    }

    #[test]
    fn any_change_to_a_chapter_gives_a_chapter_or_a_message(bytes in mutated()) {
        is_chapter_or_message(&bytes, false)?;
    }
}
