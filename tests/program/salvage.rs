//! Databases damaged in hundreds of ways: what SQLite can still read of one is in the new
//! file, and the damaged one is kept. `cargo test --test program salvage -- --nocapture`
//! prints the figures.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use carrom::lessons::Bookmark;
use carrom::levels::Starred;
use carrom::messages::{StoreCall, StoreReply, StoreRequest};
use carrom::progress::Attempt;
use carrom::quiz::{Answer, Confidence, Round};
use carrom::store::Store;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rusqlite::{Connection, OpenFlags};

use crate::folder::Folder;

/// How many databases of each kind are damaged.
const CASES: usize = 200;

/// All rows of all tables that a scan reads, up to the first that it cannot.
fn rows(path: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let Ok(database) = Connection::open_with_flags(path, OpenFlags::SQLITE_OPEN_READ_ONLY) else {
        return found;
    };
    for table in ["attempt", "star", "bookmark", "page_seen"] {
        let Ok(mut all) = database.prepare(&format!("SELECT * FROM {table} NOT INDEXED")) else {
            continue;
        };
        let columns = all.column_count();
        let mut all = all.query([]).unwrap();
        while let Ok(Some(row)) = all.next() {
            let row = (0..columns).map(|i| format!("{:?}", row.get_ref(i).unwrap()));
            found.insert(format!("{table} {:?}", row.collect::<Vec<_>>()));
        }
    }
    found
}

fn ask(store: &mut Store, wish: StoreRequest) -> StoreReply {
    store.answer(&StoreCall { ticket: 0, wish }).done
}

/// A database as a year of school may leave it: 730 answers, some chapters, some levels.
fn sound(folder: &Path) -> Vec<u8> {
    let mut store = Store::in_folder(folder).timeless();
    let round = Round::hits(7);
    let questions = round.questions().iter().cycle();
    let players = ["Ada", "Bo", "Cy"].into_iter().cycle();
    for ((number, question), player) in (1..=730).zip(questions).zip(players) {
        let answer = Answer::new(question.form.truth(), Confidence::Sure);
        let attempt = Attempt::of_quiz(player, round.code(), number, question, &answer);
        ask(&mut store, StoreRequest::Record(Box::new(attempt)));
    }
    for number in 0..60 {
        let starred = Starred {
            pack: "first".into(),
            level: format!("level-{number}"),
            stars: 1 + number % 3,
        };
        ask(&mut store, StoreRequest::Star("Ada".into(), starred));
        let mark = StoreRequest::Mark {
            player: "Bo".into(),
            chapter: format!("chapter-{}", number % 6),
            later: Box::new(Bookmark {
                place: Some(format!("Page {number}")),
                pages: [(format!("Page {number}"), None)].into(),
                ..Bookmark::default()
            }),
        };
        ask(&mut store, mark);
    }
    drop(store);
    fs::read(folder.join("progress.db")).unwrap()
}

/// What became of damaged databases.
#[derive(Debug, Default)]
struct Figures {
    mended: usize,
    refused: usize,
    /// Rows that a scan of the damaged file reads.
    readable: usize,
    /// Those of them that are there afterwards.
    saved: usize,
    /// All rows that are there afterwards.
    there: usize,
}

fn campaign(name: &str, seed: u64, damage: impl Fn(&mut [u8], &mut Pcg64Mcg)) -> Figures {
    let folder = Folder::new(&format!("salvage-{name}"));
    let path = folder.path().join("progress.db");
    let sound = sound(folder.path());
    let mut chance = Pcg64Mcg::seed_from_u64(seed);
    let mut figures = Figures::default();
    for _ in 0..CASES {
        for entry in fs::read_dir(folder.path()).unwrap() {
            fs::remove_file(entry.unwrap().path()).unwrap();
        }
        let mut damaged = sound.clone();
        damage(&mut damaged, &mut chance);
        fs::write(&path, &damaged).unwrap();
        let before = rows(&path);
        let mut store = Store::in_folder(folder.path()).timeless();
        let wish = StoreRequest::Recall(None);
        let answer = store.answer(&StoreCall { ticket: 0, wish });
        match (&answer.done, &answer.notice) {
            (StoreReply::Recalled(Ok(_)), Some(notice)) => {
                figures.mended += 1;
                assert!(notice.contains("mended"), "{notice}");
                let kept = fs::read(folder.path().join("progress-damaged-1.db"));
                assert!(kept.unwrap() == damaged, "the damaged file is kept");
            }
            (StoreReply::Recalled(Ok(_)), None) => {}
            _ => {
                figures.refused += 1;
                assert!(
                    fs::read(&path).unwrap() == damaged,
                    "what is refused is not changed"
                );
            }
        }
        let after = rows(&path);
        figures.readable += before.len();
        figures.saved += before.intersection(&after).count();
        figures.there += after.len();
    }
    println!("{CASES} databases with {name}: {figures:?}");
    figures
}

#[test]
fn what_can_be_read_of_a_damaged_database_is_saved() {
    let zeroed = campaign("a zeroed page", 1, |bytes, chance| {
        let page = chance.random_range(0..bytes.len() / 4096) * 4096;
        bytes[page..page + 4096].fill(0);
    });
    let flipped = campaign("a flipped bit", 2, |bytes, chance| {
        let byte = chance.random_range(0..bytes.len());
        bytes[byte] ^= 1 << chance.random_range(0..8);
    });
    assert!(zeroed.mended > CASES / 2 && flipped.mended > 0);
    for Figures {
        readable, saved, ..
    } in [zeroed, flipped]
    {
        assert!(saved * 100 >= readable * 99, "{saved} of {readable}");
    }
}
