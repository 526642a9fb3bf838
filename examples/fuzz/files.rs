//! Damaged files of each kind that carrom reads.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use carrom::class::ClassRound;
use carrom::files::FileLibrary;
use carrom::game::SavedGame;
use carrom::gradebook::{Gradebook, HandIn, beliefs_csv, items_csv, pupils_csv};
use carrom::lessons::Chapter;
use carrom::levels::{Level, Patience, Scene};
use carrom::measure::{self, Given, Measurement, Reading};
use carrom::messages::{PlayerAction, StoreCall, StoreReply, StoreRequest};
use carrom::paper::{gradebook, measured_html};
use carrom::progress::{Attempt, csv, json};
use carrom::quiz::concepts::Library;
use carrom::quiz::{Answer, Code, Confidence, Round};
use carrom::shells::tape::Tape;
use carrom::store::Store;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::damage::change;
use crate::{Fault, watched};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Level,
    Chapter,
    Concept,
    Saved,
    Tape,
    HandIn,
    Settings,
    Keys,
    Tracks,
}

const SETTINGS: &str =
    "format = 1\nplayer = \"Ada\"\ncolours = \"256\"\nmotion = \"reduced\"\nforetold = \"2\"\n";
/// A file of rebound keys.
const KEYS: &str =
    "format = 1\n[keys]\n\"lab.next-set\" = [\"z\"]\n\"everywhere.help\" = [\"F9\"]\n";

/// An undamaged file.
#[derive(Debug)]
pub(crate) struct Model {
    kind: Kind,
    bytes: Vec<u8>,
}

/// One or more undamaged files of each kind.
pub(crate) fn models(home: &Path) -> Result<Vec<Vec<Model>>, Box<dyn Error>> {
    let folders = [
        (Kind::Level, "levels", "toml"),
        (Kind::Chapter, "assets/lessons", "md"),
        (Kind::Concept, "assets/concepts", "toml"),
        (Kind::Saved, "tests/saves", "toml"),
        (Kind::Tape, "tests/tapes", "tape"),
        (Kind::Tracks, "assets/examples/measured", "txt"),
        (Kind::Tracks, "assets/examples/measured", "csv"),
    ];
    let mut models = Vec::new();
    for (kind, folder, ending) in folders {
        let mut found = Vec::new();
        add(&mut found, kind, &home.join(folder), ending)?;
        models.push(found);
    }
    let hand_ins = ["mixed-7", "own-7", "7"].map(|code| {
        let bytes = HandIn::new("Ada", "10b", attempts(code))
            .text()?
            .into_bytes();
        Ok(Model {
            kind: Kind::HandIn,
            bytes,
        })
    });
    models.push(hand_ins.into_iter().collect::<Result<_, String>>()?);
    for (kind, text) in [(Kind::Settings, SETTINGS), (Kind::Keys, KEYS)] {
        let bytes = text.as_bytes().to_vec();
        models.push(vec![Model { kind, bytes }]);
    }
    Ok(models)
}

/// Answers to a round of ten questions, recorded under this code.
fn attempts(code: &str) -> Vec<Attempt> {
    let noted = Code::parse(code).unwrap_or_else(|| Code::hits(7));
    let round = Round::of(Code::hits(7));
    let asked = { 1.. }.zip(round.questions());
    let noted = asked.map(|(number, question)| {
        let answer = Answer::new(question.beliefs[0].said, Confidence::Sure);
        Attempt::of_quiz("Ada", &noted, number, question, &answer)
    });
    noted.collect()
}

fn add(models: &mut Vec<Model>, kind: Kind, folder: &Path, ending: &str) -> std::io::Result<()> {
    let mut paths = fs::read_dir(folder)?
        .map(|entry| Ok(entry?.path()))
        .collect::<std::io::Result<Vec<_>>>()?;
    paths.sort();
    for path in paths {
        if path.is_dir() {
            add(models, kind, &path, ending)?;
        } else if path.extension().is_some_and(|it| it == ending) {
            let bytes = fs::read(&path)?;
            models.push(Model { kind, bytes });
        }
    }
    Ok(())
}

/// Damages the file with this number and reads it; prints it if `told`.
pub(crate) fn damage(
    number: u64,
    models: &[Vec<Model>],
    folder: &Path,
    told: bool,
) -> Result<(), Fault> {
    let mut chance = Pcg64Mcg::seed_from_u64(!number);
    if chance.random_bool(0.002) {
        return database(&mut chance, folder);
    }
    let model = models
        .choose(&mut chance)
        .and_then(|of_kind| of_kind.choose(&mut chance));
    let model = model.ok_or("there are no files")?;
    let mut bytes = model.bytes.clone();
    for _ in 0..chance.random_range(1..6) {
        change(&mut bytes, &mut chance);
    }
    if told {
        println!("{:?}\n{}", model.kind, String::from_utf8_lossy(&bytes));
    }
    watched(|| {
        read(model.kind, &bytes, folder);
        Ok(())
    })
}

/// Reads a file and uses it like an undamaged one.
fn read(kind: Kind, bytes: &[u8], folder: &Path) {
    match kind {
        Kind::Level => {
            if let Ok(level) = Level::read("level", bytes) {
                let _ = level.aimed(&level.solution).play(Patience::AKey);
            } else if let Ok(scene) = Scene::read("scene", bytes) {
                let _ = scene.play(Patience::AKey);
            }
        }
        Kind::Chapter => drop(Chapter::read("chapter", bytes)),
        Kind::Concept => {
            let path = folder.join("concept.toml");
            if fs::write(&path, bytes).is_ok() {
                Library::default().add_file(&path);
            }
        }
        Kind::Saved => {
            drop(SavedGame::read("game", bytes));
            drop(ClassRound::read("class", bytes, &Arc::default()));
        }
        Kind::Tape => drop(Tape::parse(&String::from_utf8_lossy(bytes))),
        Kind::HandIn => {
            let mut book = Gradebook::default();
            book.add("hand-in", HandIn::read(bytes));
            let results = book.results();
            for table in [
                pupils_csv(&results),
                items_csv(&results),
                beliefs_csv(&results),
                Ok(gradebook::html(&results)),
            ] {
                assert!(table.is_ok(), "{table:?}");
            }
        }
        Kind::Settings => open_with("settings.toml", bytes, folder),
        Kind::Keys => open_with("keys.toml", bytes, folder),
        Kind::Tracks => {
            let reading = Reading {
                scale: Some([0.001, -0.001]),
                ..Reading::default()
            };
            let tracks = measure::read(&[("tracks", bytes)], &reading);
            let given = Given {
                radii: Some([0.025, 0.025]),
                ..Given::default()
            };
            if let Some(it) = tracks.ok().and_then(|it| Measurement::new(it, given).ok()) {
                let _ = (it.text(), it.json(), measured_html(&it, &[]));
            }
        }
    }
}

/// Opens the game with this file in its data folder.
fn open_with(name: &str, bytes: &[u8], folder: &Path) {
    let folder = folder.join("data");
    let path = folder.join(name);
    if fs::create_dir_all(&folder).is_ok() && fs::write(&path, bytes).is_ok() {
        let _ = carrom::cli::open(&format!("--data-dir '{}'", folder.display()));
        let _ = fs::remove_file(path);
    }
}

/// Damages a database, opens it as the game does, and reads its contents.
fn database(chance: &mut Pcg64Mcg, folder: &Path) -> Result<(), Fault> {
    let folder = folder.join("database");
    let path = folder.join("progress.db");
    let said = |error: std::io::Error| error.to_string();
    let _ = fs::remove_dir_all(&folder);
    let star = StoreRequest::Note(PlayerAction::Star(
        "Ada".into(),
        carrom::levels::Starred {
            pack: "first".into(),
            level: "one".into(),
            stars: 1,
        },
    ));
    let ask = |store: &mut Store, request| store.answer(&StoreCall { ticket: 0, request });
    let mut store = Store::in_folder(&folder).timeless();
    ask(&mut store, star.clone());
    for attempt in attempts("7") {
        ask(
            &mut store,
            StoreRequest::Note(PlayerAction::Record(Box::new(attempt))),
        );
    }
    drop(store);
    let mut bytes = fs::read(&path).map_err(said)?;
    for _ in 0..chance.random_range(1..6) {
        change(&mut bytes, chance);
    }
    fs::write(&path, &bytes).map_err(said)?;
    watched(|| {
        let mut store = Store::in_folder(&folder).timeless();
        for request in [
            StoreRequest::Recall(None),
            StoreRequest::Stars("Ada".into()),
            StoreRequest::Marks("Ada".into()),
            StoreRequest::Players,
            star,
        ] {
            if let StoreReply::Recalled(Ok(history)) = ask(&mut store, request).done {
                let attempts = &history.attempts;
                assert!(attempts.iter().all(|it| it.fault().is_none()));
                csv(attempts)?;
                json(attempts, &[], None, serde_json::Value::Null)?;
                HandIn::new("Ada", "", attempts.clone()).text()?;
            }
        }
        Ok(())
    })
}
