//! Databases damaged in ten ways: at least 99 % of the rows that SQLite can still find by their
//! keys are in the new file, and the damaged file is kept.
//! `cargo test --test program salvage -- --nocapture` prints the numbers; `--include-ignored` adds
//! a run with a thousand databases.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use carrom::lessons::Bookmark;
use carrom::levels::Starred;
use carrom::messages::{PlayerAction, StoreCall, StoreReply, StoreRequest};
use carrom::progress::Attempt;
use carrom::quiz::{Answer, Code, Confidence, Round};
use carrom::store::Store;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rusqlite::types::Value;
use rusqlite::{Connection, OpenFlags, params_from_iter};

use crate::folder::Folder;
use crate::thorough::cases;

/// The size of a database page in bytes.
const PAGE: usize = 4096;
/// The number of answers in a database.
const ANSWERS: i64 = 3000;
/// The tables, and the columns of their keys.
const TABLES: [(&str, &[&str]); 4] = [
    ("attempt", &["id"]),
    ("star", &["player", "pack", "level"]),
    ("bookmark", &["player", "chapter"]),
    ("page_seen", &["player", "chapter", "page"]),
];

/// A table, the columns of its key, and the keys of its rows.
type Keys = (&'static str, &'static [&'static str], Vec<Vec<Value>>);
/// Rows by their table and key.
type Rows = BTreeMap<String, Vec<Value>>;

fn ask(store: &mut Store, request: StoreRequest) -> StoreReply {
    store.answer(&StoreCall { ticket: 0, request }).done
}

/// Opens a database so that as much as possible can be read, even if it is truncated.
fn reader(path: &Path) -> Connection {
    let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_URI;
    let address = format!("file:{}?immutable=1", path.display());
    let database = Connection::open_with_flags(address, flags).unwrap();
    database
        .pragma_update(None, "writable_schema", true)
        .unwrap();
    database
}

/// The keys of all rows of an undamaged database, by table.
fn keys(path: &Path) -> Vec<Keys> {
    let database = reader(path);
    let of_table = |(table, key): (&'static str, &'static [&'static str])| {
        let sql = format!("SELECT {} FROM {table}", key.join(", "));
        let mut query = database.prepare(&sql).unwrap();
        let rows = query.query_map([], |row| (0..key.len()).map(|i| row.get(i)).collect());
        (table, key, rows.unwrap().map(Result::unwrap).collect())
    };
    TABLES.into_iter().map(of_table).collect()
}

/// The rows that SQLite finds if each is requested separately by its key.
fn found(path: &Path, keys: &[Keys]) -> Rows {
    let database = reader(path);
    let mut found = Rows::new();
    for (table, key, rows) in keys {
        let is_it = key.iter().map(|column| format!("{column} = ?"));
        let is_it = is_it.collect::<Vec<_>>().join(" AND ");
        let Ok(mut query) = database.prepare(&format!("SELECT * FROM {table} WHERE {is_it}"))
        else {
            continue;
        };
        let columns = query.column_count();
        for key in rows {
            let row = query.query_row(params_from_iter(key), |row| {
                (0..columns).map(|i| row.get(i)).collect()
            });
            if let Ok(row) = row {
                found.insert(format!("{table} {key:?}"), row);
            }
        }
    }
    found
}

/// A database as it is after some years of school: thousands of answers, some of them longer than a
/// page, some chapters and some levels.
fn sound(folder: &Path) -> Vec<u8> {
    let mut store = Store::in_folder(folder).timeless();
    let round = Round::of(Code::hits(7));
    let long = "球".repeat(3000);
    let questions = round.questions().iter().cycle();
    let players = ["Ada", "Bo", "Cy", "Ada", "Bo", "Cy", &long]
        .into_iter()
        .cycle();
    for ((number, question), player) in (1..=60).zip(questions).zip(players) {
        let answer = Answer::new(question.form.truth(), Confidence::Sure);
        let attempt = Attempt::of_quiz(player, round.code(), number, question, &answer);
        ask(
            &mut store,
            StoreRequest::Note(PlayerAction::Record(Box::new(attempt))),
        );
    }
    let starred = Starred {
        pack: "first".into(),
        level: "level-0".into(),
        stars: 2,
    };
    ask(
        &mut store,
        StoreRequest::Note(PlayerAction::Star("Ada".into(), starred)),
    );
    let mark = StoreRequest::Note(PlayerAction::Mark {
        player: "Bo".into(),
        chapter: "chapter-0".into(),
        later: Box::new(Bookmark {
            place: Some("Page 0".into()),
            pages: [("Page 0".into(), None)].into(),
            ..Bookmark::default()
        }),
    });
    ask(&mut store, mark);
    drop(store);
    // Add more rows in one transaction, which is faster; a few long answers are enough.
    let path = folder.join("progress.db");
    let more = Connection::open(&path).unwrap();
    more.execute_batch(&format!(
        "BEGIN;
         WITH RECURSIVE place (n) AS (SELECT 61 UNION ALL SELECT n + 1 FROM place WHERE n < {ANSWERS})
         INSERT INTO attempt
            SELECT n, n, substr(player, 1, 20), family, topic, seed, n, question, answer, truth,
                error_deg, credit, is_right, confidence, misconception
            FROM place JOIN attempt ON id = n % 60 + 1;
         WITH RECURSIVE place (n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM place WHERE n < 600)
         INSERT INTO star SELECT 'Player ' || n % 7, 'pack-' || n % 5, 'level-' || n, 1 + n % 3
            FROM place;
         WITH RECURSIVE place (n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM place WHERE n < 300)
         INSERT INTO bookmark SELECT 'Player ' || n % 7, 'chapter-' || n, 'Page ' || n, n / 2.0
            FROM place;
         WITH RECURSIVE place (n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM place WHERE n < 900)
         INSERT INTO page_seen
            SELECT 'Player ' || n % 7, 'chapter-' || n % 40, 'A page of a chapter ' || n,
                'choice' || n, '{{\"choice\":1}}', n % 2
            FROM place;
         COMMIT;"
    ))
    .unwrap();
    drop(more);
    fs::read(path).unwrap()
}

/// The results for databases that were damaged in the same way.
#[derive(Debug, Default)]
struct Figures {
    databases: usize,
    mended: usize,
    refused: usize,
    /// The number of rows that can be found by their keys in the damaged files.
    readable: usize,
    /// The number of these rows that are unchanged in the new files.
    saved: usize,
    /// The number of rows in the new files whose keys could not be read in the damaged files.
    beyond: usize,
    /// The smallest share of rows saved from one database, 0 to 1.
    worst: f64,
}

/// Damages `databases` databases, one after the other, and checks what is saved.
fn campaign(
    name: &str,
    databases: usize,
    seed: u64,
    damage: impl Fn(&mut Vec<u8>, &mut Pcg64Mcg),
) -> Figures {
    let folder = Folder::new("salvage");
    let path = folder.path().join("progress.db");
    let sound = sound(folder.path());
    let keys = keys(&path);
    let mut chance = Pcg64Mcg::seed_from_u64(seed);
    let mut figures = Figures {
        databases,
        worst: 1.0,
        ..Figures::default()
    };
    for number in 0..databases {
        for entry in fs::read_dir(folder.path()).unwrap() {
            fs::remove_file(entry.unwrap().path()).unwrap();
        }
        let mut damaged = sound.clone();
        damage(&mut damaged, &mut chance);
        fs::write(&path, &damaged).unwrap();
        let before = found(&path, &keys);
        let mut store = Store::in_folder(folder.path()).timeless();
        let request = StoreRequest::Recall(None);
        let answer = store.answer(&StoreCall { ticket: 0, request });
        match (&answer.done, &answer.notice) {
            (StoreReply::Recalled(Ok(_)), Some(notice))
                if !notice.contains("has been repaired") =>
            {
                // No page is damaged, but a flipped bit has made an answer impossible.
                assert!(notice.contains("left out"), "{notice}");
            }
            (StoreReply::Recalled(Ok(_)), Some(notice)) => {
                figures.mended += 1;
                let kept = fs::read(folder.path().join("progress-damaged-1.db"));
                assert!(kept.unwrap() == damaged, "the damaged file is kept");
                if !name.contains("bit") {
                    assert_counted(notice, &path);
                }
            }
            (StoreReply::Recalled(Ok(_)), None) => {}
            _ => {
                figures.refused += 1;
                let is_changed = fs::read(&path).unwrap() != damaged;
                assert!(!is_changed, "a refused file is not changed");
                println!(
                    "{name} {number} refused, {} readable: {:?}",
                    before.len(),
                    answer.done
                );
            }
        }
        let after = found(&path, &keys);
        let is_saved = |(key, row): &(&String, &Vec<Value>)| after.get(*key) == Some(*row);
        let saved = before.iter().filter(is_saved).count();
        let share = saved as f64 / before.len().max(1) as f64;
        if share < 0.99 && !before.is_empty() {
            let (readable, notice) = (before.len(), &answer.notice);
            println!("{name}, {number}: {saved} of {readable} saved: {notice:?}");
        }
        figures.readable += before.len();
        figures.saved += saved;
        figures.beyond += after
            .keys()
            .filter(|key| !before.contains_key(*key))
            .count();
        if !before.is_empty() {
            figures.worst = figures.worst.min(share);
        }
    }
    let Figures {
        mended,
        refused,
        readable,
        saved,
        beyond,
        worst,
        ..
    } = figures;
    println!(
        "| {name} | {databases} | {mended} | {refused} | {readable} | {saved} | {:.3} % | {:.1} % | {beyond} |",
        100.0 * saved as f64 / readable.max(1) as f64,
        100.0 * worst,
    );
    figures
}

/// The notice about a repaired database gives the number of lost answers, unless it warns that more
/// may be lost. After flipped bits, an id may be wrong, and then that number may be wrong, too.
fn assert_counted(notice: &str, mended: &Path) {
    let there: i64 = reader(mended)
        .query_row("SELECT count(*) FROM attempt", [], |row| row.get(0))
        .unwrap();
    let missing = ANSWERS - there;
    let counted = match missing {
        1 => "1 answer".into(),
        _ => format!("{missing} answers"),
    };
    let says = |text: &str| notice.contains(text);
    if there > 0 && missing > 0 && !says("or more") && !says("some of the answers") {
        let counts = says(&format!("Could not be read: {counted}"));
        assert!(counts, "{missing} are missing: {notice}");
    }
}

/// Overwrites pages with random bytes or zeros.
fn spoil(bytes: &mut [u8], pages: &[usize], chance: &mut Pcg64Mcg) {
    let is_noise = chance.random_bool(0.3);
    for page in pages {
        let page = &mut bytes[page * PAGE..(page + 1) * PAGE];
        match is_noise {
            true => chance.fill(page),
            false => page.fill(0),
        }
    }
}

/// Up to `most` random pages of this kind, or of any kind if `kind` is `None`.
fn pages(bytes: &[u8], kind: Option<u8>, most: usize, chance: &mut Pcg64Mcg) -> Vec<usize> {
    let pages = 0..bytes.len() / PAGE;
    let is_it = |page: &usize| kind.is_none_or(|kind| bytes[page * PAGE] == kind);
    let pages: Vec<_> = pages.filter(is_it).collect();
    pages.sample(chance, most).copied().collect()
}

/// Damages `each` databases in each way.
fn damage_of_all_kinds(each: usize) {
    println!(
        "| damage | databases | repaired | refused | rows readable by key | of these saved | share | \
         worst database | saved beyond |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|"
    );
    // Kinds of pages: 10 is a leaf of an index or of a table without ids, and 13 is a leaf of a
    // table.
    let mut all = Vec::new();
    for (seed, most) in [(1, 1), (2, 5), (3, 20), (4, 50)] {
        let name = format!("{most} of the pages of answers");
        all.push(campaign(&name, each, seed, |bytes, chance| {
            let pages = pages(bytes, Some(13), most, chance);
            spoil(bytes, &pages, chance);
        }));
    }
    all.push(campaign(
        "1 to 5 pages of other tables",
        each,
        5,
        |bytes, chance| {
            let most = chance.random_range(1..=5);
            let pages = pages(bytes, Some(10), most, chance);
            spoil(bytes, &pages, chance);
        },
    ));
    all.push(campaign(
        "1 to 50 pages of any kind",
        each,
        6,
        |bytes, chance| {
            let most = chance.random_range(1..=50);
            let pages = pages(bytes, None, most, chance);
            spoil(bytes, &pages, chance);
        },
    ));
    all.push(campaign("1 flipped bit", each, 7, |bytes, chance| {
        flip(bytes, 1, chance);
    }));
    all.push(campaign(
        "2 to 500 flipped bits",
        each,
        8,
        |bytes, chance| {
            let most = chance.random_range(2..=500);
            flip(bytes, most, chance);
        },
    ));
    all.push(campaign("truncated", each, 9, |bytes, chance| {
        bytes.truncate(chance.random_range(PAGE..bytes.len()));
    }));
    all.push(campaign(
        "truncated, damaged pages and flipped bits",
        each,
        10,
        |bytes, chance| {
            bytes.truncate(chance.random_range(bytes.len() / 2..bytes.len()) / PAGE * PAGE);
            let most = chance.random_range(1..=20);
            let pages = pages(bytes, None, most, chance);
            spoil(bytes, &pages, chance);
            flip(bytes, most, chance);
        },
    ));
    let sum = |what: fn(&Figures) -> usize| all.iter().map(what).sum::<usize>();
    println!(
        "{} databases, {} repaired, {} refused: {} of {} rows saved",
        sum(|it| it.databases),
        sum(|it| it.mended),
        sum(|it| it.refused),
        sum(|it| it.saved),
        sum(|it| it.readable),
    );
    assert!(sum(|it| it.mended) > all.len() * each / 2);
    for figures in all {
        assert!(figures.saved * 100 >= figures.readable * 99, "{figures:?}");
        assert!(figures.readable > 0 && figures.worst >= 0.99, "{figures:?}");
    }
}

fn flip(bytes: &mut [u8], bits: usize, chance: &mut Pcg64Mcg) {
    for _ in 0..bits {
        let byte = chance.random_range(0..bytes.len());
        bytes[byte] ^= 1 << chance.random_range(0..8);
    }
}

#[test]
fn rows_between_damaged_pages_are_saved() {
    damage_of_all_kinds(cases(1, 3));
}

#[test]
#[ignore = "damages a thousand databases"]
fn rows_between_damaged_pages_of_a_thousand_databases_are_saved() {
    damage_of_all_kinds(100);
}

#[test]
fn printing_a_damaged_database_announces_the_repair() {
    let folder = Folder::new("salvage-printed");
    let mut damaged = sound(folder.path());
    let page = (1..).find(|page| damaged[page * PAGE] == 13).unwrap();
    damaged[page * PAGE..(page + 1) * PAGE].fill(0);
    let path = folder.path().join("progress.db");
    fs::write(&path, &damaged).unwrap();
    let data = folder.path().to_str().unwrap();
    for how in ["--csv", "--json", "--report=/dev/null/a.html"] {
        let output = Command::new(env!("CARGO_BIN_EXE_carrom"))
            .args(["progress", how, "--data-dir", data])
            .output()
            .unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains("it is damaged"), "{message}");
        let hint = "carrom repairs it when you next open the game";
        assert!(message.contains(hint), "{message}");
        assert!(
            fs::read(&path).unwrap() == damaged,
            "the database is not changed"
        );
    }
    assert_eq!(
        fs::read_dir(folder.path()).unwrap().count(),
        2,
        "the database and the lock"
    );
}
