//! Files of each kind that carrom reads, damaged.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use carrom::class::ClassRound;
use carrom::game::SavedGame;
use carrom::gradebook::{Gradebook, HandIn, beliefs_csv, items_csv, pupils_csv};
use carrom::lessons::Chapter;
use carrom::levels::{Level, Patience, Scene};
use carrom::messages::{StoreCall, StoreReply, StoreRequest};
use carrom::paper::gradebook;
use carrom::progress::{Attempt, csv, json};
use carrom::quiz::concepts::Library;
use carrom::quiz::{Answer, Code, Confidence, Round};
use carrom::shells::tape::Tape;
use carrom::store::Store;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::{Fault, watched};

/// Values that a number may be replaced by.
const NUMBERS: [&str; 14] = [
    "0",
    "-0.0",
    "-1",
    "1e300",
    "-1e300",
    "1e-300",
    "NaN",
    "inf",
    "-inf",
    "9999999999999999999",
    "0.1",
    "true",
    "\"x\"",
    "[]",
];

/// A kind of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Level,
    Chapter,
    Concept,
    Saved,
    Tape,
    HandIn,
}

/// A sound file.
#[derive(Debug)]
pub(crate) struct Model {
    kind: Kind,
    bytes: Vec<u8>,
}

/// A sound file of each kind and more.
pub(crate) fn models(home: &Path) -> Result<Vec<Vec<Model>>, Box<dyn Error>> {
    let folders = [
        (Kind::Level, "levels", "toml"),
        (Kind::Chapter, "assets/lessons", "md"),
        (Kind::Concept, "assets/concepts", "toml"),
        (Kind::Saved, "tests/saves", "toml"),
        (Kind::Tape, "tests/tapes", "tape"),
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
    Ok(models)
}

/// Answers to a round of ten, noted as those of this one.
fn attempts(code: &str) -> Vec<Attempt> {
    let noted = Code::parse(code).unwrap_or_else(|| Code::hits(7));
    let round = Round::hits(7);
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

/// Damages the file of this number and has it read; told, it is printed.
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

/// Reads a file, and does with it what is done with a sound one.
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
    }
}

/// Damages a database, has it opened for play and asks for what is in it.
fn database(chance: &mut Pcg64Mcg, folder: &Path) -> Result<(), Fault> {
    let folder = folder.join("database");
    let path = folder.join("progress.db");
    let said = |error: std::io::Error| error.to_string();
    let _ = fs::remove_dir_all(&folder);
    let star = StoreRequest::Star(
        "Ada".into(),
        carrom::levels::Starred {
            pack: "first".into(),
            level: "one".into(),
            stars: 1,
        },
    );
    let ask = |store: &mut Store, wish| store.answer(&StoreCall { ticket: 0, wish });
    let mut store = Store::in_folder(&folder).timeless();
    ask(&mut store, star.clone());
    for attempt in attempts("7") {
        ask(&mut store, StoreRequest::Record(Box::new(attempt)));
    }
    drop(store);
    let mut bytes = fs::read(&path).map_err(said)?;
    for _ in 0..chance.random_range(1..6) {
        change(&mut bytes, chance);
    }
    fs::write(&path, &bytes).map_err(said)?;
    watched(|| {
        let mut store = Store::in_folder(&folder).timeless();
        for wish in [
            StoreRequest::Recall(None),
            StoreRequest::Stars("Ada".into()),
            StoreRequest::Marks("Ada".into()),
            star,
        ] {
            if let StoreReply::Recalled(Ok(history)) = ask(&mut store, wish).done {
                let attempts = &history.attempts;
                assert!(attempts.iter().all(|it| it.fault().is_none()));
                csv(attempts)?;
                json(attempts, &history.calendar)?;
                HandIn::new("Ada", "", attempts.clone()).text()?;
            }
        }
        Ok(())
    })
}

/// Damages a file at one place.
fn change(bytes: &mut Vec<u8>, chance: &mut Pcg64Mcg) {
    if bytes.is_empty() {
        return bytes.push(chance.random());
    }
    let at = chance.random_range(0..bytes.len());
    let end = (at + chance.random_range(1..64)).min(bytes.len());
    match chance.random_range(0..8) {
        0 => bytes[at] ^= 1 << chance.random_range(0..8),
        1 => bytes[at] = chance.random(),
        2 => drop(bytes.drain(at..end)),
        3 => {
            let again = bytes[at..end].to_vec();
            bytes.splice(at..at, again);
        }
        4 => bytes.truncate(at),
        5 => {
            let noise: Vec<u8> = (at..end).map(|_| chance.random()).collect();
            bytes.splice(at..end, noise);
        }
        _ => {
            // From here the next number, which is most often what matters.
            let is_part = |b: &u8| b.is_ascii_digit() || *b == b'.' || *b == b'-';
            let Some(start) = bytes[at..].iter().position(u8::is_ascii_digit) else {
                return;
            };
            let start = at + start;
            let length = bytes[start..].iter().take_while(|b| is_part(b)).count();
            let number = NUMBERS.choose(chance).copied().unwrap_or_default();
            bytes.splice(start..start + length, number.bytes());
        }
    }
}
