use std::collections::BTreeMap;
use std::env;
use std::process;

use serde_json::json;

use super::*;
use crate::lessons::{Bookmark, Forget, GivenAnswer};
use crate::levels::Starred;
use crate::progress::Attempt;
use crate::quiz::Response;
use crate::quiz::{Confidence, Topic};
use crate::quiz::{Figures, figures};

/// An empty folder, removed when it is dropped.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let folder = env::temp_dir().join(format!("carrom-db-{name}-{}", process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn database(&self) -> Database {
        Database::in_folder(self.0.clone())
    }

    fn path(&self) -> PathBuf {
        path(&self.0)
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let mut names: Vec<_> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| !name.starts_with('.'))
            .collect();
        names.sort();
        names
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn attempt(player: &str, number: u32) -> Attempt {
    Attempt {
        time_s: Some(1_800_000_000),
        player: player.into(),
        family: "where-to".into(),
        topic: "equal-masses".into(),
        seed: u64::MAX - 1,
        number,
        question: figures(json!({"alpha_deg": 30})),
        answer: Figures::new(),
        truth: Figures::new(),
        error_deg: Some(0.1 + 0.2),
        credit: 0.7,
        right: true,
        confidence: Some(Confidence::ThinkSo),
        misconception: Some("swapped".into()),
    }
}

fn starred(level: &str, stars: u8) -> Starred {
    Starred {
        pack: "first".into(),
        level: level.into(),
        stars,
    }
}

#[test]
fn stored_answers_are_read_back_bit_for_bit() {
    let scratch = Scratch::new("kept");
    for mut database in [Database::in_memory(), scratch.database()] {
        let names = [
            "Ada",
            "O'Brien\"; DROP TABLE attempt; --",
            "a\nb\0c\u{1b}",
            &"球".repeat(10_000),
        ];
        for name in names {
            for number in 1..=3 {
                database.record(&attempt(name, number)).unwrap();
            }
        }
        let bare = Attempt {
            time_s: None,
            error_deg: None,
            confidence: None,
            misconception: None,
            ..attempt("bare", 1)
        };
        database.record(&bare).unwrap();
        for name in names {
            let expected = [1, 2, 3].map(|number| attempt(name, number));
            assert_eq!(database.attempts(Some(name)).unwrap(), expected);
        }
        assert_eq!(database.attempts(Some("bare")).unwrap(), [bare]);
        assert_eq!(database.attempts(Some("nobody")).unwrap(), []);
        assert_eq!(database.attempts(None).unwrap().len(), 13);
        assert_eq!(database.notice.take(), None);
    }
}

#[test]
fn each_player_keeps_the_most_stars_of_each_level() {
    let mut database = Database::in_memory();
    for (player, level, stars) in [
        ("Ada", "a", 2),
        ("Ada", "a", 3),
        ("Ada", "a", 1),
        ("Ada", "b", 1),
        ("Bo", "a", 1),
    ] {
        database.star(player, &starred(level, stars)).unwrap();
    }
    let ada = database.stars("Ada").unwrap();
    assert_eq!(ada, [starred("a", 3), starred("b", 1)]);
    assert_eq!(database.stars("Bo").unwrap(), [starred("a", 1)]);
    assert_eq!(database.stars("Cy").unwrap(), []);
}

/// A bookmark for a page that was seen and is still open.
fn seen(page: &str) -> Bookmark {
    Bookmark {
        place: Some(page.into()),
        pages: BTreeMap::from([(page.into(), None)]),
        ..Bookmark::default()
    }
}

fn answered(page: &str, answer: Response, right: bool) -> Bookmark {
    let given = GivenAnswer {
        asked: "choice\nWhich?".into(),
        answer,
        right,
        first: None,
    };
    Bookmark {
        pages: BTreeMap::from([(page.into(), Some(given))]),
        ..Bookmark::default()
    }
}

#[test]
fn bookmarks_are_merged_in_the_database_as_in_memory() {
    let scratch = Scratch::new("marks");
    for mut database in [Database::in_memory(), scratch.database()] {
        let dial = Bookmark {
            alpha_deg: Some(0.1 + 0.2),
            ..Bookmark::default()
        };
        let mut expected = Bookmark::default();
        for later in [
            seen("One"),
            seen("Two"),
            answered("Two", Response::Choice(2), true),
            dial,
            seen("O'Brien\"; DROP TABLE page_seen; --"),
            answered("Two", Response::Number(0.1), false),
            seen("Two"),
        ] {
            database.mark("Ada", "shots", &later).unwrap();
            expected.merge(later);
            let kept = database.marks("Ada").unwrap();
            assert_eq!(kept, BTreeMap::from([("shots".into(), expected.clone())]));
        }
        assert_eq!(expected.place.as_deref(), Some("Two"));
        assert_eq!(expected.alpha_deg, Some(0.1 + 0.2));
        assert_eq!(expected.pages.len(), 3);
    }
}

#[test]
fn only_the_given_part_of_the_bookmarks_is_deleted() {
    let mut database = Database::in_memory();
    for (player, chapter) in [("Ada", "shots"), ("Ada", "atoms"), ("Bo", "shots")] {
        let answer = answered("One", Response::Choice(0), true);
        database.mark(player, chapter, &seen("One")).unwrap();
        database.mark(player, chapter, &answer).unwrap();
    }
    database.record(&attempt("Ada", 1)).unwrap();
    let answer = Forget::Answer {
        chapter: "shots".into(),
        page: "One".into(),
    };
    database.forget("Ada", &answer).unwrap();
    let ada = database.marks("Ada").unwrap();
    assert_eq!(
        ada["shots"],
        seen("One"),
        "the page is still marked as seen"
    );
    assert!(ada["atoms"].pages["One"].is_some());
    database
        .forget("Ada", &Forget::Chapter("shots".into()))
        .unwrap();
    let ada = database.marks("Ada").unwrap();
    assert_eq!(ada.keys().collect::<Vec<_>>(), ["atoms"]);
    database.forget("Ada", &Forget::All).unwrap();
    assert_eq!(database.marks("Ada").unwrap(), BTreeMap::new());
    assert_eq!(database.marks("Bo").unwrap().len(), 1);
    assert_eq!(database.attempts(Some("Ada")).unwrap().len(), 1);
}

#[test]
fn an_invalid_answer_in_a_bookmark_is_ignored() {
    let scratch = Scratch::new("senseless");
    let mut database = scratch.database();
    let answer = answered("One", Response::Choice(0), true);
    database.mark("Ada", "shots", &answer).unwrap();
    let strange = Connection::open(scratch.path()).unwrap();
    for text in [
        "",
        "{}",
        "{\"choice\":-1}",
        "{\"theta1_deg\":1e9,\"theta2_deg\":1}",
    ] {
        strange
            .execute("UPDATE page_seen SET answer = ?1", [text])
            .unwrap();
        let kept = database.marks("Ada").unwrap();
        assert_eq!(kept["shots"].pages["One"], None, "{text}");
    }
}

#[test]
fn a_row_with_damaged_text_does_not_hide_the_others() {
    let mut database = Database::in_memory();
    for name in ["a", "b"] {
        database.star("Ada", &starred(name, 1)).unwrap();
        database.mark("Ada", name, &seen("One")).unwrap();
    }
    database.star("Bo", &starred("a", 1)).unwrap();
    let damage = "
        UPDATE star SET level = CAST(x'ff' AS TEXT) WHERE player = 'Ada' AND level = 'a';
        UPDATE star SET player = CAST(x'ff' AS TEXT) WHERE player = 'Bo';
        UPDATE bookmark SET chapter = CAST(x'ff' AS TEXT) WHERE chapter = 'a';
        UPDATE page_seen SET chapter = CAST(x'ff' AS TEXT) WHERE chapter = 'a';";
    let damaged = database.change(&|transaction| transaction.execute_batch(damage));
    damaged.unwrap();
    assert_eq!(database.stars("Ada").unwrap(), [starred("b", 1)]);
    let marks = database.marks("Ada").unwrap();
    assert_eq!(marks, BTreeMap::from([("b".into(), seen("One"))]));
    assert_eq!(database.players().unwrap(), [("Ada".into(), None)]);
}

#[test]
fn reading_creates_no_file() {
    let scratch = Scratch::new("looking");
    let mut database = scratch.database();
    assert_eq!(database.attempts(None).unwrap(), []);
    assert_eq!(database.stars("Ada").unwrap(), []);
    assert_eq!(database.marks("Ada").unwrap(), BTreeMap::new());
    database.forget("Ada", &Forget::All).unwrap();
    assert_eq!(scratch.names(), Vec::<String>::new());
}

/// A database with 200 answers.
fn filled(name: &str) -> (Scratch, Vec<u8>) {
    let scratch = Scratch::new(name);
    let mut database = scratch.database();
    for number in 0..200 {
        database.record(&attempt("Ada", number)).unwrap();
    }
    let bytes = fs::read(scratch.path()).unwrap();
    (scratch, bytes)
}

/// The notice about the repair, and the number of answers afterwards.
fn mended(scratch: &Scratch, damaged: &[u8]) -> (String, usize) {
    fs::write(scratch.path(), damaged).unwrap();
    let files = || {
        scratch
            .names()
            .iter()
            .filter(|it| it.ends_with(".db"))
            .count()
    };
    let kept = files();
    let mut database = scratch.database();
    let answers = database.attempts(None).unwrap().len();
    let notice = database.notice.take().unwrap();
    assert_eq!(database.notice.take(), None, "the notice is shown once");
    assert_eq!(files(), kept + 1, "there is one more file, the damaged one");
    database.record(&attempt("Bo", 7)).unwrap();
    assert_eq!(scratch.database().attempts(Some("Bo")).unwrap().len(), 1);
    (notice, answers)
}

/// The start of a page of this kind that has cells, not counting page 1. (Database File Format,
/// section 1.6: 10 is a leaf of an index, 13 a leaf of a table.)
fn page(database: &[u8], kind: u8) -> usize {
    let mut starts = (4096..database.len()).step_by(4096);
    let has_cells = |start: usize| database[start + 3..start + 5] != [0, 0];
    starts
        .find(|start| database[*start] == kind && has_cells(*start))
        .unwrap()
}

#[test]
fn a_damaged_database_is_repaired_and_the_damaged_file_is_kept() {
    let (scratch, sound) = filled("damaged");
    let with = |start: usize, bytes: &[u8]| {
        let mut damaged = sound.clone();
        damaged[start..start + bytes.len()].copy_from_slice(bytes);
        damaged
    };
    let cases = [
        // Only an index is damaged.
        (with(page(&sound, 10), &[0; 4096]), "Everything in it", 200),
        (
            with(page(&sound, 13), &[0; 4096]),
            "Could not be read: ",
            150,
        ),
        // The file is truncated after the first page of answers.
        (
            sound[..page(&sound, 13) + 4096].to_vec(),
            "Could not be read: ",
            30,
        ),
        // A letter in the name of the format is wrong.
        (with(3, b"j"), "Everything in it", 200),
    ];
    for (i, (damaged, reported, least)) in cases.into_iter().enumerate() {
        let (notice, answers) = mended(&scratch, &damaged);
        assert!(notice.contains(reported), "{i}: {notice}");
        assert!(answers >= least, "{i}: {answers}");
        let name = format!("progress-damaged-{}.db", i + 1);
        assert!(notice.contains(&name), "{notice}");
        assert_eq!(fs::read(scratch.0.join(name)).unwrap(), damaged);
    }
}

/// If an inner page is zeroed, the pages below it are recognized by their contents.
#[test]
fn answers_on_pages_without_a_parent_are_saved() {
    let (scratch, mut damaged) = filled("cut-off");
    let start = page(&damaged, 5);
    damaged[start..start + 4096].fill(0);
    let (notice, answers) = mended(&scratch, &damaged);
    assert!(notice.contains("Everything in it could be saved: 200 answers"));
    assert_eq!(answers, 200);
}

/// The database has rows that continue on other pages, and rows that are only in the log.
#[test]
fn long_rows_and_rows_in_the_log_of_a_damaged_database_are_saved() {
    let (scratch, _) = filled("long");
    let mut database = scratch.database();
    let long = Attempt {
        question: figures(json!({"text": "球\0".repeat(30_000)})),
        ..attempt(&"Ada".repeat(4000), 1000)
    };
    database.record(&long).unwrap();
    let mut damaged = fs::read(scratch.path()).unwrap();
    let start = page(&damaged, 13);
    damaged[start..start + 4096].fill(0);
    fs::write(scratch.path(), &damaged).unwrap();
    let held = Connection::open(scratch.path()).unwrap();
    let count = "SELECT count(*) FROM star";
    held.query_row(count, [], |row| row.get::<_, i64>(0))
        .unwrap();
    for number in 1001..=1040 {
        tables::insert_attempt(&held, &attempt("Bo", number)).unwrap();
    }
    let log = scratch.0.join("progress.db-wal");
    let written = (fs::read(scratch.path()).unwrap(), fs::read(&log).unwrap());
    assert!(written.0 == damaged && !written.1.is_empty());
    drop(held);
    fs::write(scratch.path(), written.0).unwrap();
    fs::write(&log, written.1).unwrap();
    let mut database = scratch.database();
    assert_eq!(database.attempts(Some(&long.player)).unwrap(), [long]);
    assert!(
        database
            .notice
            .take()
            .unwrap()
            .contains("has been repaired")
    );
    let of_the_log: Vec<_> = (1001..=1040).map(|number| attempt("Bo", number)).collect();
    assert_eq!(database.attempts(Some("Bo")).unwrap(), of_the_log);
}

/// Unused pages still contain deleted rows.
#[test]
fn deleted_rows_are_not_restored_from_a_damaged_database() {
    let scratch = Scratch::new("forgotten");
    let mut database = scratch.database();
    for (chapter, number) in (0..300).flat_map(|n| [("kept", n), ("forgotten", n)]) {
        let seen = seen(&format!("{number} {}", "x".repeat(50)));
        database.mark("Ada", chapter, &seen).unwrap();
    }
    let forget = Forget::Chapter("forgotten".into());
    database.forget("Ada", &forget).unwrap();
    let mut damaged = fs::read(scratch.path()).unwrap();
    let start = page(&damaged, 2);
    damaged[start..start + 4096].fill(0);
    fs::write(scratch.path(), &damaged).unwrap();
    let mut database = scratch.database();
    let marks = database.marks("Ada").unwrap();
    assert_eq!(marks.keys().collect::<Vec<_>>(), ["kept"]);
    assert!(
        marks["kept"].pages.len() > 290,
        "only the rows on the damaged page are lost"
    );
    assert!(
        database
            .notice
            .take()
            .unwrap()
            .contains("some of the pages read")
    );
}

#[cfg(unix)]
#[test]
fn a_damaged_database_behind_a_link_is_repaired_at_the_target() {
    let (scratch, sound) = filled("link");
    let elsewhere = Scratch::new("link-target");
    let target = elsewhere.0.join("answers.sqlite");
    let link = scratch.0.join("progress.db");
    fs::rename(&link, &target).unwrap();
    std::os::unix::fs::symlink(&target, &link).unwrap();
    let mut damaged = sound.clone();
    let start = page(&sound, 13);
    damaged[start..start + 4096].fill(0);
    fs::write(&target, &damaged).unwrap();
    let mut database = scratch.database();
    let answers = database.attempts(None).unwrap().len();
    assert!((150..200).contains(&answers), "{answers}");
    assert!(
        database
            .notice
            .take()
            .unwrap()
            .contains("has been repaired")
    );
    database.record(&attempt("Bo", 1)).unwrap();
    assert!(link.is_symlink());
    assert_eq!(scratch.names(), ["progress.db"]);
    let kept = elsewhere.0.join("progress-damaged-1.db");
    assert!(fs::read(kept).unwrap() == damaged);
    let mended = Connection::open(&target).unwrap();
    assert_eq!(
        tables::attempts(&mended, None).unwrap().0.len(),
        answers + 1
    );
}

/// A store that only reads also follows the link, and finds the log beside the target.
#[cfg(unix)]
#[test]
fn the_log_of_a_database_behind_a_link_is_read() {
    let (scratch, _) = filled("link-log");
    let elsewhere = Scratch::new("link-log-target");
    let target = elsewhere.0.join("progress.db");
    fs::rename(scratch.path(), &target).unwrap();
    std::os::unix::fs::symlink(&target, scratch.0.join("progress.db")).unwrap();
    let held = Connection::open(&target).unwrap();
    tables::insert_attempt(&held, &attempt("Bo", 1)).unwrap();
    let mut database = scratch.database();
    database.only_looks = true;
    assert_eq!(database.attempts(None).unwrap().len(), 201);
}

#[test]
fn unreadable_rows_are_restored_from_the_latest_copy() {
    let (scratch, sound) = filled("filled-in");
    let mut database = scratch.database();
    database.today = Some(jiff::civil::date(2026, 11, 21));
    assert_eq!(database.attempts(None).unwrap().len(), 200);
    let mut damaged = sound.clone();
    let start = page(&sound, 13);
    damaged[start..start + 4096].fill(0);
    let (notice, answers) = mended(&scratch, &damaged);
    let copy = "Restored from progress-backup-2026-11-21.db: ";
    assert!(notice.contains(copy), "{notice}");
    assert_eq!(answers, 200);
}

#[test]
fn the_copies_of_the_last_three_days_are_kept() {
    let (scratch, _) = filled("days");
    let mut database = scratch.database();
    for day in [3, 4, 4, 9, 10] {
        database.today = Some(jiff::civil::date(2026, 11, day));
        database.record(&attempt("Ada", 1000)).unwrap();
    }
    let copies = ["04", "09", "10"].map(|day| format!("progress-backup-2026-11-{day}.db"));
    assert_eq!(
        scratch.names(),
        [copies.as_slice(), &["progress.db".into()]].concat()
    );
    let copy = Connection::open(scratch.0.join(&copies[2])).unwrap();
    let (rows, _) = tables::attempts(&copy, None).unwrap();
    assert_eq!(
        rows.len(),
        204,
        "the copy has the rows from the start of the day"
    );
}

/// A store that only reads changes nothing and reports the damage.
#[test]
fn a_store_that_only_reads_repairs_nothing() {
    let (scratch, sound) = filled("only-looks");
    let mut damaged = sound.clone();
    let start = page(&sound, 10);
    damaged[start..start + 4096].fill(0);
    for bytes in [&damaged, &sound] {
        fs::write(scratch.path(), bytes).unwrap();
        let mut database = scratch.database();
        database.only_looks = true;
        match database.attempts(None) {
            Ok(found) => assert!(bytes == &sound && found.len() == 200),
            Err(reason) => assert!(bytes == &damaged && reason.contains("damaged"), "{reason}"),
        }
        assert!(&fs::read(scratch.path()).unwrap() == bytes);
        assert_eq!(scratch.names(), ["progress.db"]);
    }
}

#[test]
fn a_file_that_is_not_a_carrom_database_is_refused_and_left_unchanged() {
    let refused = |scratch: &Scratch| {
        let mut database = scratch.database();
        let message = database.record(&attempt("Ada", 1)).unwrap_err();
        assert!(message.contains("left unchanged"), "{message}");
        assert!(database.attempts(None).is_err());
        assert_eq!(scratch.names(), ["progress.db"]);
    };
    for sql in [
        "CREATE TABLE recipe (name TEXT)",
        "CREATE TABLE attempt (name TEXT); PRAGMA user_version = 1",
        "CREATE TABLE attempt (name TEXT); PRAGMA user_version = 3",
        "CREATE TABLE recipe (name TEXT); PRAGMA user_version = -3",
    ] {
        let scratch = Scratch::new("strange");
        Connection::open(scratch.path())
            .unwrap()
            .execute_batch(sql)
            .unwrap();
        refused(&scratch);
    }
    let (scratch, sound) = filled("no-database");
    let text = b"CREATE TABLE attempt (is no more than words here). ".repeat(400);
    for bytes in [text, vec![0; 9000], [&[0; 4096], &sound[4096..]].concat()] {
        fs::write(scratch.path(), &bytes).unwrap();
        refused(&scratch);
        assert_eq!(fs::read(scratch.path()).unwrap(), bytes);
    }
    fs::remove_file(scratch.path()).unwrap();
    fs::create_dir(scratch.path()).unwrap();
    refused(&scratch);
}

/// Manipulations of a database of the current version. Each changes the schema so that reading,
/// checking or writing could run foreign code.
pub(super) const FOREIGN_SCHEMAS: [&str; 7] = [
    // The view is finite, so that this test fails instead of running for ever if the view is read.
    "ALTER TABLE attempt RENAME TO hidden;
     CREATE VIEW attempt AS
        WITH RECURSIVE number (n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM number LIMIT 200000)
        SELECT n AS id, 1 AS time_s, 'Ada' AS player, 'where-to' AS family, 'x' AS topic, 1 AS seed,
            n AS number, '{}' AS question, '{}' AS answer, '{}' AS truth, NULL AS error_deg,
            1 AS credit, 1 AS is_right, NULL AS confidence, NULL AS misconception
        FROM number;",
    "CREATE TRIGGER more AFTER INSERT ON attempt BEGIN DELETE FROM attempt; END",
    "CREATE INDEX slow ON attempt (hex(topic || family))",
    "CREATE TABLE more (x CHECK (length(hex(zeroblob(x))) < 9))",
    "CREATE VIRTUAL TABLE more USING fts5 (x)",
    "CREATE VIEW star_2 AS SELECT * FROM star",
    "DROP TABLE page_seen; CREATE TABLE page_seen (player TEXT, chapter TEXT, page TEXT,
        asked TEXT, answer TEXT, is_right INTEGER AS (length(hex(player))))",
];

/// A database of the current version after this manipulation.
pub(super) fn with_foreign_schema(
    connection: rusqlite::Result<Connection>,
    sql: &str,
) -> Connection {
    let connection = connection.unwrap();
    schema::lay_out(&connection, schema::VERSION).unwrap();
    connection.execute_batch(sql).unwrap();
    connection
}

#[test]
fn a_schema_that_is_not_ours_is_refused_before_it_is_queried() {
    for sql in FOREIGN_SCHEMAS {
        let scratch = Scratch::new("foreign");
        drop(with_foreign_schema(Connection::open(scratch.path()), sql));
        let before = fs::read(scratch.path()).unwrap();
        let refused = [
            scratch.database().record(&attempt("Ada", 1)),
            scratch.database().attempts(None).map(drop),
            {
                let mut only_looks = scratch.database();
                only_looks.only_looks = true;
                only_looks.attempts(None).map(drop)
            },
        ];
        for message in refused.map(Result::unwrap_err) {
            assert!(
                message.contains("carrom did not create its"),
                "{sql}: {message}"
            );
            assert!(message.contains("left unchanged"), "{sql}: {message}");
        }
        assert!(fs::read(scratch.path()).unwrap() == before, "{sql}");
        assert_eq!(scratch.names(), ["progress.db"]);
    }
}

/// A flipped bit in the format number once made an undamaged file look like that of a newer version
/// of carrom.
#[test]
fn a_flipped_bit_of_the_format_number_is_repaired() {
    let (scratch, sound) = filled("version");
    for (place, bit) in (60..64).flat_map(|place| (0..8).map(move |bit| (place, bit))) {
        let mut damaged = sound.clone();
        damaged[place] ^= 1 << bit;
        for name in scratch.names() {
            fs::remove_file(scratch.0.join(name)).unwrap();
        }
        fs::write(scratch.path(), damaged).unwrap();
        let mut database = scratch.database();
        let answers = database.attempts(None).map(|it| it.len());
        assert_eq!(answers, Ok(200), "{place} {bit}");
        let notice = database.notice.take().unwrap_or_default();
        let is_whole = notice.contains("Everything in it could be saved");
        assert!(is_whole, "{place} {bit}: {notice}");
        let format = schema::version_in_header(&scratch.path());
        assert_eq!(format, Some(schema::VERSION));
    }
}

/// The flipped bit is in a letter of a column's name.
#[test]
fn a_flipped_byte_of_the_schema_is_damage() {
    let (scratch, mut damaged) = filled("schema");
    let words = b"question TEXT NOT NULL";
    let place = damaged.windows(words.len()).position(|it| it == words);
    damaged[place.unwrap()] ^= 1;
    fs::write(scratch.path(), damaged).unwrap();
    let mut database = scratch.database();
    assert!(database.attempts(None).is_ok());
    assert!(database.notice.take().unwrap().contains("damaged"));
}

/// The tables of statistics that ANALYZE adds to the schema are ignored.
#[test]
fn a_database_with_statistics_is_accepted() {
    let (scratch, _) = filled("analyzed");
    let other = Connection::open(scratch.path()).unwrap();
    other.execute_batch("ANALYZE; VACUUM").unwrap();
    drop(other);
    let mut database = scratch.database();
    assert_eq!(database.attempts(None).unwrap().len(), 200);
    database.record(&attempt("Ada", 1)).unwrap();
    assert_eq!(database.notice.take(), None);
}

#[test]
fn an_invalid_row_does_not_hide_the_others() {
    let (scratch, _) = filled("nonsense");
    let strange = Connection::open(scratch.path()).unwrap();
    strange
        .execute_batch(
            "UPDATE attempt SET number = -1 WHERE id = 3;
             UPDATE attempt SET topic = CAST(x'61ff' AS TEXT) WHERE id = 4;",
        )
        .unwrap();
    let found = scratch.database().attempts(None).unwrap();
    assert_eq!(found.len(), 199);
    assert_eq!(found[2].topic, "a\u{fffd}");
}

/// Impossible answers are left out, and the player is notified once. The rows are kept.
#[test]
fn answers_out_of_range_are_left_out_and_counted_in_a_notice() {
    let (scratch, _) = filled("misfits");
    let strange = Connection::open(scratch.path()).unwrap();
    for (id, change) in [
        (1, "credit = 9e999"),
        (2, "error_deg = 9e999"),
        (3, "credit = 1.5"),
        (4, "answer = '{\"choice\":99}'"),
        (5, "answer = '{\"theta1_deg\":1e999,\"theta2_deg\":0}'"),
        (6, "answer = 'NaN'"),
        (7, "error_deg = -1"),
    ] {
        let sql = format!("UPDATE attempt SET {change} WHERE id = {id}");
        assert_eq!(strange.execute(&sql, []).unwrap(), 1);
    }
    for only_looks in [false, true] {
        let mut database = scratch.database();
        database.only_looks = only_looks;
        assert_eq!(database.attempts(None).unwrap().len(), 193);
        let notice = database.notice.take().unwrap();
        assert!(notice.contains("7 answers"), "{notice}");
        database.attempts(None).unwrap();
        assert_eq!(database.notice.take(), None);
    }
    let rows = strange.query_row("SELECT count(*) FROM attempt", [], |row| row.get(0));
    assert_eq!(rows, Ok(200));
}

#[test]
fn a_newer_database_is_refused_and_left_unchanged() {
    let (scratch, _) = filled("newer");
    // The second time, the last changes are still in the log, as a killed process leaves them.
    for in_log in [false, true] {
        let newer = Connection::open(scratch.path()).unwrap();
        if in_log {
            let no_checkpoint = rusqlite::config::DbConfig::SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE;
            newer.set_db_config(no_checkpoint, true).unwrap();
        }
        newer
            .execute_batch("PRAGMA user_version = 99; CREATE TABLE IF NOT EXISTS later (x)")
            .unwrap();
        drop(newer);
        let log = scratch.0.join("progress.db-wal");
        // An empty log is the same as none.
        let log = || fs::read(&log).unwrap_or_default();
        let files = || (fs::read(scratch.path()).unwrap(), log());
        let before = files();
        let names = scratch.names();
        let mut database = scratch.database();
        let refusals = [
            database.record(&attempt("Ada", 1)),
            database.star("Ada", &starred("a", 1)),
            database.mark("Ada", "shots", &seen("One")),
            database.forget("Ada", &Forget::All),
            database.marks("Ada").map(drop),
            database.attempts(None).map(drop),
            database.stars("Ada").map(drop),
        ];
        for refusal in refusals {
            let message = refusal.unwrap_err();
            assert!(
                message.contains("newer version of carrom wrote it (format 99"),
                "{message}"
            );
        }
        assert_eq!(database.notice.take(), None);
        assert!(files() == before, "the files were changed");
        assert_eq!(scratch.names(), names);
    }
}

/// A database of the first released version; it must always open.
const PINNED_1: &str = "
    CREATE TABLE attempt (
        id INTEGER PRIMARY KEY, time_s INTEGER, player TEXT NOT NULL, family TEXT NOT NULL,
        topic TEXT NOT NULL, seed INTEGER NOT NULL, number INTEGER NOT NULL,
        question TEXT NOT NULL, answer TEXT NOT NULL, truth TEXT NOT NULL, error_deg REAL,
        credit REAL NOT NULL, is_right INTEGER NOT NULL, confidence TEXT, misconception TEXT
    ) STRICT;
    CREATE INDEX attempt_of_player ON attempt (player);
    CREATE TABLE star (
        player TEXT NOT NULL, pack TEXT NOT NULL, level TEXT NOT NULL, stars INTEGER NOT NULL,
        PRIMARY KEY (player, pack, level)
    ) STRICT, WITHOUT ROWID;
    INSERT INTO attempt VALUES (1, 1800000000, 'Ada', 'where-to', 'equal masses', -2, 5,
        '{\"alpha_deg\":30}', '{}', '{}', 0.30000000000000004, 0.7, 1, 'think-so', 'swapped');
    INSERT INTO star VALUES ('Ada', 'first', 'a', 3);
    PRAGMA user_version = 1;";

/// The additions of the second format; a database with them must always open.
const PINNED_2: &str = "
    CREATE TABLE bookmark (
        player TEXT NOT NULL, chapter TEXT NOT NULL, page TEXT, alpha_deg REAL,
        PRIMARY KEY (player, chapter)
    ) STRICT, WITHOUT ROWID;
    CREATE TABLE page_seen (
        player TEXT NOT NULL, chapter TEXT NOT NULL, page TEXT NOT NULL, asked TEXT,
        answer TEXT, is_right INTEGER, PRIMARY KEY (player, chapter, page)
    ) STRICT, WITHOUT ROWID;
    INSERT INTO bookmark VALUES ('Ada', 'shots', 'Two', 12.5);
    INSERT INTO page_seen VALUES ('Ada', 'shots', 'One', NULL, NULL, NULL),
        ('Ada', 'shots', 'Two', 'choice\nWhich?', '{\"choice\":2}', 1);
    PRAGMA user_version = 2;";

/// The bookmarks in [`PINNED_2`].
fn pinned_marks() -> BTreeMap<String, Bookmark> {
    let mut mark = seen("One");
    mark.merge(seen("Two"));
    mark.merge(answered("Two", Response::Choice(1), true));
    mark.alpha_deg = Some(12.5);
    BTreeMap::from([("shots".into(), mark)])
}

#[test]
fn a_database_of_each_older_format_opens() {
    let second = format!("{PINNED_1}{PINNED_2}");
    // The third format has the same tables.
    let third =
        format!("{second} UPDATE attempt SET topic = 'equal-masses'; PRAGMA user_version = 3;");
    for (sql, marks) in [
        (PINNED_1, BTreeMap::new()),
        (&second, pinned_marks()),
        (&third, pinned_marks()),
    ] {
        let scratch = Scratch::new("pinned");
        let old = Connection::open(scratch.path()).unwrap();
        old.execute_batch(sql).unwrap();
        drop(old);
        // A database that cannot be written to is read with the same result.
        let unwritten = unchanged::open(&scratch.path(), true).unwrap();
        let found = tables::attempts(&unwritten, None).unwrap();
        assert_eq!(found, (vec![attempt("Ada", 5)], 0));
        drop(unwritten);
        let mut database = scratch.database();
        assert_eq!(database.attempts(None).unwrap(), [attempt("Ada", 5)]);
        assert_eq!(database.stars("Ada").unwrap(), [starred("a", 3)]);
        assert_eq!(database.marks("Ada").unwrap(), marks);
        database.record(&attempt("Ada", 6)).unwrap();
        database.mark("Ada", "atoms", &seen("One")).unwrap();
        assert_eq!(database.attempts(Some("Ada")).unwrap().len(), 2);
        assert_eq!(database.marks("Ada").unwrap().len(), marks.len() + 1);
        assert_eq!(database.notebook("Ada").unwrap(), []);
        assert_eq!(database.observations(None).unwrap(), []);
        assert_eq!(database.notice.take(), None);
    }
}

/// Every name under which a topic was stored leads to the id of an existing topic.
#[test]
fn every_topic_stored_by_name_has_an_id() {
    let lines = include_str!("schema-3.sql").lines();
    let lines = lines.filter(|line| line.starts_with("    ('"));
    let ids = lines.filter_map(|line| line.strip_suffix(')').or(line.strip_suffix("),")));
    let ids: Vec<_> = ids.filter_map(|line| line.rsplit('\'').nth(1)).collect();
    assert_eq!(ids.len(), 44);
    for id in ids {
        assert!(!Topic::with_id(id).families().is_empty(), "{id}");
    }
}

#[test]
fn a_folder_that_cannot_be_created_causes_only_a_message() {
    let scratch = Scratch::new("file");
    let file = scratch.0.join("file");
    fs::write(&file, "x").unwrap();
    let mut database = Database::in_folder(file.join("below"));
    let message = database.record(&attempt("Ada", 1)).unwrap_err();
    assert!(message.contains("progress.db: "), "{message}");
}

/// Permissions do not restrict an administrator, so this test opens the database for reading
/// directly.
#[test]
fn a_read_only_database_can_be_read() {
    for in_log in [false, true] {
        let scratch = Scratch::new("unchanged");
        let mut database = scratch.database();
        database.record(&attempt("Ada", 1)).unwrap();
        let held = in_log.then(|| {
            // An open connection keeps the last changes in the log.
            let held = Connection::open(scratch.path()).unwrap();
            held.query_row("SELECT count(*) FROM attempt", [], |row| {
                row.get::<_, i64>(0)
            })
            .unwrap();
            held
        });
        database.record(&attempt("Ada", 2)).unwrap();
        let before = (scratch.names(), fs::read(scratch.path()).unwrap());
        let mut connection = unchanged::open(&scratch.path(), true).unwrap();
        let found = transact(&mut connection, TransactionBehavior::Deferred, &|it| {
            tables::attempts(it, None)
        });
        assert_eq!(found.unwrap().0.len(), 2);
        assert!(tables::insert_attempt(&connection, &attempt("Ada", 3)).is_err());
        drop(connection);
        assert!((scratch.names(), fs::read(scratch.path()).unwrap()) == before);
        drop(held);
    }
}

#[test]
fn a_tiny_credit_in_an_older_row_is_read_as_zero() {
    let scratch = Scratch::new("credit");
    let mut database = scratch.database();
    for credit in [3.7e-33, 0.25] {
        let attempt = Attempt {
            credit,
            ..attempt("Ada", 1)
        };
        database.record(&attempt).unwrap();
    }
    let found = database.attempts(None).unwrap();
    let credits: Vec<_> = found.iter().map(|it| it.credit).collect();
    assert_eq!(credits, [0.0, 0.25]);
}

#[test]
fn after_a_long_wait_for_the_database_the_next_wait_is_shorter() {
    let scratch = Scratch::new("busy");
    let mut database = scratch.database();
    database.record(&attempt("Ada", 1)).unwrap();
    let other = Connection::open(scratch.path()).unwrap();
    other.execute_batch("BEGIN IMMEDIATE").unwrap();
    database.was_busy = true;
    let refused = database.record(&attempt("Ada", 2)).unwrap_err();
    assert!(refused.contains("locked"), "{refused}");
    assert!(database.was_busy);
    other.execute_batch("COMMIT").unwrap();
    database.record(&attempt("Ada", 3)).unwrap();
    assert!(!database.was_busy);
}
