//! Files that are not levels. Each causes only its own message, with file, line, field and what was
//! expected, and exit status 2.
//!
//! `tests/bad-levels/NAME.expected` contains the expected message for `NAME.toml`, or for the
//! folder `NAME`.

use carrom::files::FileLibrary;
use carrom::levels::{Level, LevelLibrary, Patience, Scene, judge};
use proptest::prelude::*;

use crate::bad_files::{self, BadFiles, message};
use crate::folder::Folder;

const BAD: BadFiles = BadFiles {
    folder: "bad-levels",
    ending: "toml",
};

#[test]
fn every_invalid_level_causes_its_message() {
    BAD.each(["level", "check"], |name, is_file, printed| {
        assert!(!is_file || printed.is_empty(), "{name}");
    });
}

#[test]
fn simulate_refuses_an_invalid_scene_with_the_same_message() {
    let name = "negative-mass.toml";
    let output = BAD.carrom(&["simulate", name, "--json"]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(output.stdout, b"");
    assert_eq!(message(&output), BAD.expected("negative-mass"));
}

#[test]
fn ten_megabytes_of_random_bytes_cause_one_message() {
    let folder = Folder::new("noise");
    let mut state = 1_u64;
    let noise: Vec<u8> = std::iter::repeat_with(|| {
        // Knuth's linear congruential generator; any random bytes would do.
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 56) as u8
    })
    .take(10_000_000)
    .collect();
    let name = folder.file("noise.toml", &noise);
    let output = BAD.carrom(&["level", "check", &name]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(output.stdout, b"");
    let expected = format!("{name}:1: expected a file of at most 1 MiB, found more");
    assert_eq!(message(&output), expected);
    // Random bytes of a size that is still parsed.
    let fault = Level::read("noise", &noise[..1 << 20]).unwrap_err();
    assert!(fault.to_string().starts_with("noise:1: "), "{fault}");
}

#[test]
fn a_missing_file_is_named() {
    let output = BAD.carrom(&["level", "check", "no-such-level.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(message(&output).starts_with("no-such-level.toml: cannot be read: "));
}

#[test]
fn the_other_files_in_a_folder_open_despite_an_invalid_one() {
    let mut library = LevelLibrary::default();
    library.add_dir(&BAD.path());
    // The folder with two levels that have the same id gives one level and one error.
    assert_eq!(library.packs.len(), 1);
    assert_eq!(library.packs[0].name, "duplicate-id");
    assert_eq!(library.packs[0].levels.len(), 1);
    assert_eq!(bad_files::files(&library.problems), BAD.names().len());
}

/// A level file with a part of it replaced.
fn mutated() -> impl Strategy<Value = Vec<u8>> {
    let piece = prop_oneof![
        "[0-9.eE+-]{0,6}",
        "\\PC{0,4}",
        Just("\n[[disc]]\n".to_owned()),
        Just("nan".to_owned()),
        Just("-".to_owned()),
    ];
    bad_files::mutated("levels/first-hits", piece)
}

fn is_level_or_message(bytes: &[u8]) -> Result<(), TestCaseError> {
    match Level::read("level", bytes) {
        Ok(level) => {
            // A level can be played, at least until there are too many events.
            if let Ok(shot) = level.aimed(&level.solution).play(Patience::AKey) {
                prop_assert_eq!(judge(&level, &shot).findings.len(), level.goals.len());
            }
            prop_assert_eq!(Scene::read("level", bytes), Ok(level.scene));
        }
        Err(errors) => {
            for error in errors {
                let message = error.to_string();
                prop_assert!(message.starts_with("level:"));
                prop_assert!(!message.contains(char::is_control), "{message:?}");
                prop_assert!(error.line.is_some() || message.ends_with(": there are more errors"));
            }
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn any_bytes_give_a_level_or_a_message(bytes in proptest::collection::vec(any::<u8>(), 0..2000)) {
        is_level_or_message(&bytes)?;
    }

    #[test]
    fn any_text_gives_a_level_or_a_message(text in "\\PC{0,200}") {
        is_level_or_message(format!("format = 1\n{text}").as_bytes())?;
    }

    #[test]
    fn any_change_to_a_level_gives_a_level_or_a_message(bytes in mutated()) {
        is_level_or_message(&bytes)?;
    }
}
