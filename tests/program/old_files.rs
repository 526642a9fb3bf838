//! Files from earlier versions of carrom are read completely and with the same meaning. The files
//! in `tests/saves` were written by those versions.

use std::fs;
use std::process::Command;

use carrom::class::{ClassRound, Vote, WayOfVoting};
use carrom::game::{Fingerprint, SavedGame};
use carrom::gradebook::HandIn;
use carrom::levels::Shelf;
use carrom::messages::{StoreCall, StoreReply, StoreRequest};
use carrom::progress::{Attempt, LEVEL, TABLE, Tally, beliefs, topics};
use carrom::quiz::{Confidence, Response};
use carrom::store::Store;
use rusqlite::Connection;

use crate::folder::Folder;

const ADA: &str = "Ada";
const BO: &str = "Bo \"L\" \u{e9}";

/// A folder with the database that this SQL creates.
fn folder_with(name: &str, sql: &str) -> Folder {
    let folder = Folder::new(name);
    let database = Connection::open(folder.path().join("progress.db")).unwrap();
    database.execute_batch(sql).unwrap();
    folder
}

fn done(store: &mut Store, request: StoreRequest) -> StoreReply {
    let answer = store.answer(&StoreCall { ticket: 0, request });
    assert_eq!(answer.notice, None);
    answer.done
}

fn attempts(store: &mut Store, player: Option<&str>) -> Vec<Attempt> {
    match done(store, StoreRequest::Recall(player.map(str::to_owned))) {
        StoreReply::Recalled(Ok(history)) => history.attempts,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_database_of_format_2_keeps_its_meaning() {
    let sql = include_str!("../saves/progress-2.sql");
    let folder = folder_with("format-2", sql);
    let mut store = Store::in_folder(folder.path());
    // Everything except topics and misconceptions is unchanged to the last bit.
    let old = Connection::open_in_memory().unwrap();
    old.execute_batch(sql).unwrap();
    let mut rows = old
        .prepare(
            "SELECT question, answer, truth, credit, time_s, is_right FROM attempt ORDER BY id",
        )
        .unwrap();
    let rows = rows.query_map([], |row| {
        let texts: (String, String, String) = (row.get(0)?, row.get(1)?, row.get(2)?);
        let rest: (f64, Option<i64>, bool) = (row.get(3)?, row.get(4)?, row.get(5)?);
        Ok((texts, rest))
    });
    let all = attempts(&mut store, None);
    let kept = all.iter().map(|it| {
        let text = |figures| serde_json::to_string(figures).unwrap();
        let texts = (text(&it.question), text(&it.answer), text(&it.truth));
        (texts, (it.credit, it.time_s, it.right))
    });
    assert!(rows.unwrap().map(Result::unwrap).eq(kept));
    // A hand-in contains all these answers.
    let hand_in = HandIn::new(ADA, "", all.clone());
    assert_eq!(hand_in.attempts.len(), all.len());
    let read = HandIn::read(hand_in.text().unwrap().as_bytes()).unwrap();
    assert_eq!(read.attempts.len(), all.len());

    let mut under_merged_names = 0;
    for (player, count, right, expected) in [(ADA, 170, 18, [24, 45]), (BO, 58, 5, [8, 26])] {
        let attempts = attempts(&mut store, Some(player));
        let all = Tally::of(&attempts);
        assert_eq!((all.attempts, all.right), (count, right));
        let topics = topics(&attempts);
        // These topics were once "the corner with loss", "coin's speed" and "marble's speed".
        let found = ["separation, with loss", "target's speed"].map(|name| {
            let mut of_name = topics.iter().filter(|topic| topic.name == name);
            let attempts = of_name.next().map_or(0, |topic| topic.all.attempts);
            assert!(of_name.next().is_none(), "{name} is one topic");
            attempts
        });
        assert_eq!(found, expected);
        under_merged_names += expected.iter().sum::<usize>();
    }
    assert!(under_merged_names > 100);

    // Two misconceptions have also been merged into one.
    let found = beliefs(&attempts(&mut store, Some(ADA)));
    let merged = found
        .iter()
        .find(|it| it.misconception.id() == "offset-as-angle");
    let since = merged.unwrap().since;
    assert_eq!((since.times, since.asked), (5, 5));

    let StoreReply::Stars(Ok(all_stars)) = done(&mut store, StoreRequest::Stars(ADA.into())) else {
        panic!("no stars");
    };
    let stars: Vec<_> = all_stars
        .iter()
        .map(|it| (it.pack.as_str(), it.level.as_str(), it.stars))
        .collect();
    assert_eq!(stars, [("first-hits", "square-corner", 3)]);
    // Stars belong to the level's id, wherever the level is in its pack.
    let mut shelf = Shelf::default();
    let won = |shelf: &Shelf| {
        (0..shelf.count())
            .filter(|at| shelf.stars(*at) == 3)
            .collect::<Vec<_>>()
    };
    assert_eq!(won(&shelf), [0_usize; 0]);
    for starred in &all_stars {
        assert!(shelf.recall(starred));
    }
    assert_eq!(won(&shelf), [shelf.find("square-corner").unwrap()]);
    let StoreReply::Marks(Ok(marks)) = done(&mut store, StoreRequest::Marks(ADA.into())) else {
        panic!("no bookmarks");
    };
    let mark = &marks["the-line-of-impact"];
    assert_eq!(mark.place.as_deref(), Some("Where can they push?"));
    assert_eq!(mark.pages.len(), 5);
    assert!(mark.pages["What can"].as_ref().is_some_and(|it| !it.right));
}

#[test]
fn a_call_and_a_prediction_in_a_database_of_format_3_keep_their_meaning() {
    let folder = folder_with("format-3", include_str!("../saves/progress-3.sql"));
    let mut store = Store::in_folder(folder.path());
    let attempts = attempts(&mut store, Some(ADA));
    let [call, prediction] = attempts.as_slice() else {
        panic!("{attempts:?}");
    };
    assert_eq!([&call.family, &prediction.family], [TABLE, LEVEL]);
    assert_eq!([call.round(), prediction.round()], ["table", "levels"]);
    let names: Vec<_> = topics(&attempts).iter().map(|it| it.all.attempts).collect();
    assert_eq!(names, [1, 1]);
    assert!(attempts.iter().all(|it| it.fault().is_none() && !it.right));
    let json = carrom::progress::json(&attempts, &[], None, serde_json::Value::Null).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let calls = serde_json::json!({"made": 1, "within_2_deg": 0});
    assert_eq!(json["summary"]["calls"], calls);
    // A hand-in contains both answers.
    let hand_in = HandIn::new(ADA, "", attempts.clone());
    let read = HandIn::read(hand_in.text().unwrap().as_bytes()).unwrap();
    assert_eq!(read.attempts, hand_in.attempts);
}

#[test]
fn a_class_round_of_the_first_format_still_opens() {
    let bytes = include_bytes!("../saves/class-1.toml");
    let round = ClassRound::read("class-1.toml", bytes, &Default::default()).unwrap();
    assert_eq!(round.teams(), ["Ants", "Bees", "=Cats()"]);
    assert_eq!(round.way(), WayOfVoting::Teams);
    let said = |question, team| {
        round
            .ballot(question, team)
            .vote(Vote::First)
            .map(Response::to_text)
    };
    assert_eq!(said(1, 0).unwrap(), "rays 25 65");
    assert_eq!((said(1, 2), round.place().question), (None, 1));
    // Writing the round in the current format keeps its meaning.
    let text = round.text().unwrap();
    let again = ClassRound::read("again", text.as_bytes(), &Default::default()).unwrap();
    assert_eq!(again.text().unwrap(), text);
}

#[test]
fn class_rounds_of_the_second_format_still_open() {
    let bytes = include_bytes!("../saves/class-2-devices.toml");
    let round = ClassRound::read("class-2", bytes, &Default::default()).unwrap();
    // "Bo" had been removed before the file was saved, and "Ada 2" was the same pupil as Ada.
    assert_eq!(round.teams(), ["Ada L.", "Cy"]);
    assert_eq!(round.class(), "");
    assert_eq!(round.join_code().unwrap().to_string(), "BCDFGH");
    let degrees = |person| {
        let rays = round
            .ballot(0, person)
            .vote(Vote::First)
            .unwrap()
            .rays()
            .unwrap();
        [rays.striker, rays.target].map(|angle| angle.unwrap().to_degrees().round())
    };
    assert_eq!([degrees(0), degrees(1)], [[60.0, 30.0], [45.0, 45.0]]);
    assert_eq!(round.ballot(1, 1).vote(Vote::First), None);
    assert_eq!(
        round.ballot(0, 1).given(Vote::First).unwrap().sure,
        Some(Confidence::Sure)
    );
    let bytes = include_bytes!("../saves/class-2-tally.toml");
    let round = ClassRound::read("class-2", bytes, &Default::default()).unwrap();
    assert_eq!(round.tally(0, Vote::First), Some(&[4, 17, 9, 2][..]));
    assert_eq!(round.tally(0, Vote::Second), Some(&[1, 28, 2, 1][..]));
}

#[test]
fn a_class_round_of_the_third_format_still_opens() {
    let bytes = include_bytes!("../saves/class-3.toml");
    let round = ClassRound::read("class-3", bytes, &Default::default()).unwrap();
    assert_eq!(round.class(), "10b");
    assert_eq!(round.tally(0, Vote::Second), Some(&[1, 28, 2, 1][..]));
}

#[test]
fn a_class_round_of_the_fourth_format_still_opens() {
    let bytes = include_bytes!("../saves/class-4.toml");
    let round = ClassRound::read("class-4", bytes, &Default::default()).unwrap();
    assert_eq!(round.removed().collect::<Vec<_>>(), ["Bo"]);
    assert_eq!(round.address(), None);
}

#[test]
fn a_class_round_of_the_fifth_format_still_opens() {
    let bytes = include_bytes!("../saves/class-5.toml");
    let round = ClassRound::read("class-5", bytes, &Default::default()).unwrap();
    assert_eq!(round.address().unwrap().to_string(), "192.168.43.117:8091");
    // Writing the round in the current format keeps its meaning.
    let text = round.text().unwrap();
    let again = ClassRound::read("again", text.as_bytes(), &Default::default()).unwrap();
    assert_eq!(again.text().unwrap(), text);
}

#[test]
fn a_class_round_of_the_sixth_format_still_opens() {
    let text = include_str!("../saves/class-6.toml");
    let round = ClassRound::read("class-6", text.as_bytes(), &Default::default()).unwrap();
    assert_eq!(round.teams(), ["Ada"]);
    assert_eq!(round.removed().collect::<Vec<_>>(), ["Bo"]);
    assert_eq!(round.voted(0, Vote::First), 1);
    assert_eq!(round.text().unwrap(), text);
}

#[test]
fn an_exported_game_of_the_first_format_still_opens() {
    let bytes = include_bytes!("../saves/export-1.toml");
    let (saved, game) = SavedGame::read("export-1.toml", bytes).unwrap();
    assert_eq!(saved.record.strokes(), 3);
    assert_eq!(saved.record.setup.restitution, 1.0);
    assert_eq!(Fingerprint::of(&game), saved.end);
}

/// A report counts days in the time zone in which it is written: one evening in one zone can fall
/// on two days in another.
#[cfg(unix)]
#[test]
fn a_report_counts_the_days_in_the_players_time_zone() {
    let folder = folder_with("zones", include_str!("../saves/progress-2.sql"));
    let old = Connection::open(folder.path().join("progress.db")).unwrap();
    // 2026-01-05 at 21:30 UTC, and three hours later.
    old.execute_batch(
        "DELETE FROM attempt WHERE id > 2;
         UPDATE attempt SET time_s = 1767648600 + 10800 * (id - 1)",
    )
    .unwrap();
    drop(old);
    for (zone, span) in [
        (
            "UTC0",
            "2 answers on 2 days, from 5 January 2026 to 6 January 2026",
        ),
        ("AAA5", "2 answers on 5 January 2026"),
        ("BBB-5", "2 answers on 6 January 2026"),
    ] {
        let report = folder.path().join(format!("{zone}.md"));
        let status = Command::new(env!("CARGO_BIN_EXE_carrom"))
            .env("TZ", zone)
            .arg("--data-dir")
            .arg(folder.path())
            .args(["--player", ADA, "progress", "--report"])
            .arg(&report)
            .status();
        assert!(status.unwrap().success());
        let text = fs::read_to_string(report).unwrap();
        assert!(text.contains(span), "{zone}: {text}");
    }
}
