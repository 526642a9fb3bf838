//! Damaged files of many kinds: each is read, or refused with a message.
//! `cargo test --test program damaged_files -- --nocapture` prints how many files of each kind were
//! read and refused; `--include-ignored` adds a run with 1,430 files.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use carrom::cli;
use carrom::game::SavedGame;
use carrom::messages::{FileKind, PlayerAction, StoreCall, StoreReply, StoreRequest};
use carrom::shells::Headless;
use carrom::store::Store;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::damage::change;
use crate::folder::Folder;
use crate::handed_in::hand_in;
use crate::thorough::cases;

/// The result for a file: `None` if it was read, otherwise carrom's message.
type Refusal = Option<String>;

/// Undamaged files of one kind, and how carrom opens one.
struct Kind {
    name: &'static str,
    models: Vec<Vec<u8>>,
    open: fn(&Folder, &[u8]) -> Refusal,
}

/// All files below a folder of the project whose names end in `ending` and contain `part`.
fn files(folder: &str, ending: &str, part: &str) -> Vec<Vec<u8>> {
    fn add(found: &mut Vec<Vec<u8>>, folder: &Path, ending: &str, part: &str) {
        let entries = fs::read_dir(folder).unwrap();
        let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        for path in paths {
            let name = path.file_name().unwrap().to_str().unwrap();
            if path.is_dir() {
                add(found, &path, ending, part);
            } else if name.ends_with(ending) && name.contains(part) {
                found.push(fs::read(&path).unwrap());
            }
        }
    }
    let mut found = Vec::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    add(&mut found, &folder, ending, part);
    assert!(!found.is_empty());
    found
}

/// Runs carrom; a refusal is what it prints, which must name this file.
fn run(arguments: &[&str], file: &str) -> Refusal {
    let output = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(!message.contains("panicked"), "{message}");
    match output.status.code() {
        Some(0) => None,
        Some(1 | 2) => {
            let said = [message, String::from_utf8(output.stdout).unwrap()].concat();
            assert!(said.contains(file), "{said}");
            Some(said)
        }
        other => panic!("{other:?}: {message}"),
    }
}

/// Runs a command for a file with this name and these bytes.
fn check(folder: &Folder, command: &[&str], name: &str, bytes: &[u8]) -> Refusal {
    let path = folder.file(name, bytes);
    run(&[command, &[&path]].concat(), name)
}

/// Opens the game with this file in its data folder; a refusal is a notice on the first screen.
fn first_screen(folder: &Folder, name: &str, bytes: &[u8]) -> Refusal {
    folder.file(name, bytes);
    let data = folder.path().display();
    let app = cli::open(&format!("--data-dir '{data}' --charset ascii")).unwrap();
    let screen = Headless::new(app, 100, 60).screen();
    // The notice at the bottom of the screen is in a frame.
    let note = screen
        .lines()
        .skip_while(|line| !line.contains("please note"));
    let note: Vec<_> = note.collect();
    (!note.is_empty()).then(|| note.join("\n"))
}

/// A store's refusal of a request about the file with this name in its data folder.
fn kept(folder: &Folder, name: &str, bytes: &[u8], request: StoreRequest) -> Refusal {
    let path = folder.path().join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, bytes).unwrap();
    let mut store = Store::in_folder(folder.path()).timeless();
    match store.answer(&StoreCall { ticket: 0, request }).done {
        StoreReply::Game(loaded) => loaded.err(),
        StoreReply::Class(loaded) => loaded.err(),
        StoreReply::Recalled(recalled) => recalled.err(),
        other => panic!("{other:?}"),
    }
}

fn kinds() -> Vec<Kind> {
    vec![
        Kind {
            name: "progress.db",
            models: vec![database()],
            open: |folder, bytes| {
                folder.file("progress.db", bytes);
                let data = folder.path().to_str().unwrap();
                let printed = run(
                    &["progress", "--csv", "--everyone", "--data-dir", data],
                    "progress.db",
                );
                let mended = kept(folder, "progress.db", bytes, StoreRequest::Recall(None));
                // A database that can be printed can also be opened.
                assert!(printed.is_some() || mended.is_none(), "{mended:?}");
                mended
            },
        },
        Kind {
            name: "saved games",
            models: files("tests/saves", ".toml", "")
                .into_iter()
                .filter(|bytes| SavedGame::read("game", bytes).is_ok())
                .collect(),
            open: |folder, bytes| {
                let replayed = check(folder, &["replay"], "game.toml", bytes);
                let request = StoreRequest::Load(FileKind::Game, "game-1".into());
                let loaded = kept(folder, "games/game-1.toml", bytes, request);
                loaded.or(replayed)
            },
        },
        Kind {
            name: "rounds of classes",
            models: files("tests/saves", ".toml", "class"),
            open: |folder, bytes| {
                let request = StoreRequest::Load(FileKind::Class, "class-1".into());
                kept(folder, "classes/class-1.toml", bytes, request)
            },
        },
        Kind {
            name: "settings",
            models: vec![
                b"format = 1\nplayer = \"Ada\"\ncolours = \"256\"\nmotion = \"reduced\"\nforetold = \"2\"\n"
                    .into(),
            ],
            open: |folder, bytes| first_screen(folder, "settings.toml", bytes),
        },
        Kind {
            name: "keys.toml",
            models: vec![
                b"format = 1\n[keys]\n\"lab.next-set\" = [\"z\"]\n\"everywhere.help\" = [\"F9\"]\n"
                    .into(),
            ],
            open: |folder, bytes| first_screen(folder, "keys.toml", bytes),
        },
        Kind {
            name: "hand-ins",
            models: vec![
                hand_in(1, "Ada", 10, 7).text().unwrap().into_bytes(),
                hand_in(2, "Bo", 3, 0).text().unwrap().into_bytes(),
            ],
            open: |folder, bytes| {
                fs::create_dir_all(folder.path().join("in")).unwrap();
                folder.file("in/pupil.json", bytes);
                let [from, out] = ["in", "out.html"].map(|it| folder.path().join(it));
                let [from, out] = [&from, &out].map(|it| it.to_str().unwrap());
                run(&["gather", from, "--out", out, "--force"], "pupil.json")
            },
        },
        Kind {
            name: "levels",
            models: files("levels", ".toml", ""),
            open: |folder, bytes| check(folder, &["level", "check"], "level.toml", bytes),
        },
        Kind {
            name: "scenes",
            models: files("levels", ".toml", ""),
            open: |folder, bytes| check(folder, &["simulate"], "scene.toml", bytes),
        },
        Kind {
            name: "chapters",
            models: files("assets/lessons", ".md", ""),
            open: |folder, bytes| check(folder, &["lesson", "check"], "01-chapter.md", bytes),
        },
        Kind {
            name: "written questions",
            models: files("tests/own-concepts", ".toml", "our"),
            open: |folder, bytes| check(folder, &["concept", "check"], "questions.toml", bytes),
        },
        Kind {
            name: "sets",
            models: files("assets/examples/sets", ".toml", ""),
            open: |folder, bytes| check(folder, &["set", "check"], "set.toml", bytes),
        },
    ]
}

/// The bytes of an undamaged database.
fn database() -> Vec<u8> {
    let folder = Folder::new("damaged-database");
    let mut store = Store::in_folder(folder.path()).timeless();
    for attempt in hand_in(1, "Ada", 10, 7).attempts {
        let request = StoreRequest::Note(PlayerAction::Record(Box::new(attempt)));
        store.answer(&StoreCall { ticket: 0, request });
    }
    drop(store);
    fs::read(folder.path().join("progress.db")).unwrap()
}

/// Damages `each` files of each kind.
fn damage(each: usize) {
    let mut chance = Pcg64Mcg::seed_from_u64(23);
    let mut counts = BTreeMap::new();
    println!("| files | damaged | read | refused with a message |\n|---|---:|---:|---:|");
    for kind in kinds() {
        for model in &kind.models {
            assert_eq!(
                (kind.open)(&Folder::new("sound"), model),
                None,
                "{}",
                kind.name
            );
        }
        let mut refused = 0;
        for _ in 0..each {
            let mut bytes = kind.models.choose(&mut chance).unwrap().clone();
            let most = if chance.random() { 1 } else { 5 };
            for _ in 0..chance.random_range(1..=most) {
                change(&mut bytes, &mut chance);
            }
            let folder = Folder::new("damaged");
            if let Some(message) = (kind.open)(&folder, &bytes) {
                refused += 1;
                assert_clear(&message);
            }
        }
        println!(
            "| {} | {each} | {} | {refused} |",
            kind.name,
            each - refused
        );
        counts.insert(kind.name, refused);
    }
    // A damaged database is nearly always mended, so if there are only a few, all of them may be
    // read.
    if each < 100 {
        counts.remove("progress.db");
    }
    assert!(counts.values().all(|refused| *refused > 0), "{counts:?}");
}

/// Asserts that a message has only lines that a terminal and a person can read.
fn assert_clear(message: &str) {
    let strange = |c: char| c != '\n' && (c.is_control() || c == '\u{202e}');
    assert!(!message.contains(strange), "{message:?}");
    assert!(message.trim().len() > 10, "{message:?}");
    assert!(message.lines().count() < 100, "{message}");
}

#[test]
fn damaged_files_are_read_or_refused_with_a_message() {
    damage(cases(4, 13));
}

#[test]
#[ignore = "damages 1,430 files"]
fn many_damaged_files_are_read_or_refused_with_a_message() {
    damage(130);
}
