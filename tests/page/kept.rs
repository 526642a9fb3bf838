//! Answers that the page has saved are never lost, even if its tab is closed or reloaded, and the
//! program can read them too.

use std::fs;
use std::time::Instant;

use carrom::messages::{StoreCall, StoreReply, StoreRequest};
use carrom::progress::Attempt;
use carrom::store::Store;
use rusqlite::Connection;
use serde_json::{Value, json};

use crate::browser::{Browser, SCREEN, TIME_FRAMES, page, press, wait_until_ready};
use crate::chromium::Chromium;
use crate::folder::Folder;

/// The bytes of the page's `progress.db` as numbers.
const PROGRESS: &str = "return [...window.carrom.call({ do: 'progress' }).bytes]";

/// The number of times that the page has saved changes so far.
const TOLD: &str = "return window.carrom.told()";

/// The answers in the bytes of a database, as the program reads them from a file.
fn answers(bytes: &[u8]) -> Vec<Attempt> {
    let folder = Folder::new("page-answers");
    fs::write(folder.path().join("progress.db"), bytes).unwrap();
    let mut store = Store::in_folder(folder.path());
    let request = StoreRequest::Recall(None);
    let StoreReply::Recalled(Ok(history)) = store.answer(&StoreCall { ticket: 0, request }).done
    else {
        panic!("the program cannot read the page's database");
    };
    history.attempts
}

fn progress(browser: &mut dyn Browser) -> Vec<u8> {
    let bytes = browser.run(PROGRESS, &[]);
    let bytes = bytes.as_array().unwrap().iter();
    bytes.map(|byte| byte.as_u64().unwrap() as u8).collect()
}

fn wait(ms: u64) {
    std::thread::sleep(std::time::Duration::from_millis(ms));
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn no_answer_reported_as_saved_is_lost_by_repeated_reloads() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    let mut told = 0;
    for round in 0..100 {
        chromium.open("about:blank");
        chromium.open(&format!("{page}#quiz=separation-{round}&player=Ana"));
        wait_until_ready(&mut chromium);
        press(&mut chromium, &["a", "Enter", "2"]);
        // The reload happens while the answer is being saved, or afterwards.
        wait(round % 10 * 4);
        told += chromium.run(TOLD, &[]).as_u64().unwrap();
    }
    chromium.open("about:blank");
    chromium.open(&page);
    wait_until_ready(&mut chromium);
    let kept = answers(&progress(&mut chromium)).len() as u64;
    println!("100 reloads: {told} answers reported as saved, {kept} found");
    assert!(
        told > 0 && kept >= told,
        "{told} were reported, {kept} are saved"
    );
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn two_tabs_never_overwrite_each_other() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    let open = |chromium: &mut Chromium, seed: u32| {
        chromium.open("about:blank");
        chromium.open(&format!("{page}#quiz=separation-{seed}"));
        wait_until_ready(chromium);
    };
    open(&mut chromium, 1);
    let first = chromium.window();
    let second = chromium.another_window();
    open(&mut chromium, 2);
    // The tabs answer in turn, and neither is reloaded in between.
    for window in [&first, &second, &first, &second] {
        chromium.go_to(window);
        press(&mut chromium, &["a", "Enter", "2"]);
        wait(300);
        // Enter leads through the explanation to the next question, where it does nothing.
        for _ in 0..20 {
            press(&mut chromium, &["Enter"]);
            wait(50);
        }
    }
    open(&mut chromium, 3);
    let kept = answers(&progress(&mut chromium));
    let of = |seed| kept.iter().filter(|attempt| attempt.seed == seed).count();
    assert_eq!((of(1), of(2)), (2, 2), "{kept:?}");
}

/// The tabs are closed while they save an answer.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn no_answer_reported_as_saved_is_lost_when_a_tab_is_closed() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    let first = chromium.window();
    let mut told = 0;
    for round in 0..20 {
        chromium.another_window();
        chromium.open(&format!("{page}#quiz=separation-{round}&player=Ana"));
        wait_until_ready(&mut chromium);
        press(&mut chromium, &["a", "Enter", "2"]);
        wait(round % 5 * 8);
        told += chromium.run(TOLD, &[]).as_u64().unwrap();
        chromium.close_window();
        chromium.go_to(&first);
    }
    chromium.open(&page);
    wait_until_ready(&mut chromium);
    let kept = answers(&progress(&mut chromium)).len() as u64;
    println!("20 closed tabs: {told} answers reported as saved, {kept} found");
    assert!(
        told > 0 && kept >= told,
        "{told} were reported, {kept} are saved"
    );
}

/// A part of the message that appears when nothing can be saved.
const UNSAVED: &str = "cannot be saved";

/// Waits until the screen contains this text.
fn wait_until_shown(chromium: &mut Chromium, text: &str) {
    for _ in 0..100 {
        if chromium.run(SCREEN, &[]).as_str().unwrap().contains(text) {
            return;
        }
        wait(100);
    }
    panic!("no \"{text}\" on the screen");
}

/// Plays two questions while nothing can be saved, and returns how many times the page reported
/// that.
fn times_told(chromium: &mut Chromium) -> usize {
    // Any key closes the message, even before it is drawn. So the screen is read after two frames,
    // in the same step in which the next key is pressed.
    let read_and_press = format!(
        "const read = () => {{ {SCREEN} }};
        return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {{
          const screen = read();
          document.body.dispatchEvent(new KeyboardEvent(
            'keydown', {{ key: arguments[0], bubbles: true, cancelable: true }}));
          done(screen);
        }})));"
    );
    let mut times = 0;
    let mut before = false;
    for key in ["a", "Enter", "2"]
        .into_iter()
        .chain(std::iter::repeat_n("Enter", 20))
        .chain(["a", "Enter", "2"])
        .chain(std::iter::repeat_n("Enter", 20))
    {
        if key == "2" {
            wait_until_shown(chromium, "How sure");
        }
        let screen = chromium.run(&read_and_press, &[json!(key)]);
        let now = screen.as_str().unwrap().contains(UNSAVED);
        times += usize::from(now && !before);
        before = now;
        wait(200);
    }
    if times == 0 {
        // On a busy machine the message can come after the last key, which then cannot close it.
        wait_until_shown(chromium, UNSAVED);
        times = 1;
    }
    times
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_browser_that_saves_nothing_is_reported_once() {
    // Saving is blocked, as in some schools.
    let blocked = json!({ "profile.default_content_setting_values.cookies": 2 });
    let (page, mut chromium) = (page(), Chromium::start_as((1000, 700), false, &blocked));
    chromium.open(&format!("{page}#quiz=separation-3"));
    wait_until_ready(&mut chromium);
    assert_eq!(times_told(&mut chromium), 1);
    // The page still has all answers in memory.
    assert_eq!(answers(&progress(&mut chromium)).len(), 2);
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn full_browser_storage_is_reported_once_and_answers_are_saved_when_there_is_room() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    chromium.open(&format!("{page}#quiz=separation-3"));
    wait_until_ready(&mut chromium);
    let quota = |bytes: u64| json!({ "origin": "file:///", "quotaSize": bytes });
    chromium.debug("Storage.overrideQuotaForOrigin", &quota(1));
    assert_eq!(times_told(&mut chromium), 1);
    assert_eq!(answers(&progress(&mut chromium)).len(), 2);
    // When there is room again, the answers are saved without further input.
    chromium.debug("Storage.overrideQuotaForOrigin", &quota(1_000_000_000));
    for _ in 0..200 {
        if chromium.run(TOLD, &[]) != json!(0) {
            break;
        }
        wait(100);
    }
    chromium.open("about:blank");
    chromium.open(&page);
    wait_until_ready(&mut chromium);
    assert_eq!(answers(&progress(&mut chromium)).len(), 2);
}

/// Simulates another tab that locks all saved data for a number of milliseconds.
const HOLD: &str = "
    const until = performance.now() + arguments[0];
    const opening = indexedDB.open('carrom', 1);
    opening.onsuccess = () => {
      const files = opening.result.transaction('files', 'readwrite').objectStore('files');
      const again = () => performance.now() < until && (files.get('').onsuccess = again);
      again();
    };";

/// Whether a frame was drawn more than 450 ms after the given time, later than any frame that a key
/// press causes.
const DRAWN_LATE: &str = "return window.frameTimes.some((time) => time - arguments[0] > 450)";

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_slow_browser_is_reported_while_nothing_else_is_drawn() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    chromium.open(&page);
    wait_until_ready(&mut chromium);
    press(&mut chromium, &["s"]);
    chromium.run(HOLD, &[json!(5000)]);
    wait(300);
    chromium.run(TIME_FRAMES, &[]);
    let pressed = chromium.run("return performance.now()", &[]);
    press(&mut chromium, &["Enter"]);
    let mut soon = |what: &str, seen: &dyn Fn(&mut Chromium) -> bool| {
        for _ in 0..150 {
            if seen(&mut chromium) {
                return;
            }
            wait(50);
        }
        panic!("did not happen within seven seconds: {what}");
    };
    let saving = |chromium: &mut Chromium| {
        let screen = chromium.run(SCREEN, &[]);
        screen.as_str().unwrap().contains("saving")
    };
    soon("a frame", &|chromium| {
        chromium.run(DRAWN_LATE, std::slice::from_ref(&pressed)) == json!(true)
    });
    soon("saving", &saving);
    soon("saved", &|chromium| !saving(chromium));
}

/// The page opens a copy of its own database, which the program can read too.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_database_of_the_program_is_opened_in_the_page() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    chromium.open(&format!("{page}#quiz=separation-5"));
    wait_until_ready(&mut chromium);
    press(&mut chromium, &["a", "Enter", "2"]);
    wait(300);
    let own = progress(&mut chromium);
    assert_eq!(answers(&own).len(), 1);
    // A database that was copied to another computer and back adds nothing twice.
    drop_file(&mut chromium, &own);
    wait_for(&mut chromium, "has been added to your progress here");
    assert_eq!(answers(&progress(&mut chromium)).len(), 1);
    // A damaged database is refused with a message.
    press(&mut chromium, &["Escape"]);
    drop_file(&mut chromium, &own[..own.len() / 2]);
    wait_for(&mut chromium, "cannot be opened");
}

/// Drops a `progress.db` with these bytes on the page.
fn drop_file(chromium: &mut Chromium, bytes: &[u8]) {
    drop_named(chromium, "progress.db", bytes);
}

/// Drops a file on the page.
fn drop_named(chromium: &mut Chromium, name: &str, bytes: &[u8]) {
    let script = "
        const dropped = new DataTransfer();
        dropped.items.add(new File([new Uint8Array(arguments[1])], arguments[0]));
        dispatchEvent(new DragEvent('drop', { dataTransfer: dropped }));";
    chromium.run(script, &[json!(name), json!(bytes)]);
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn an_opened_file_is_listed_at_once() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    chromium.open(&format!("{page}#quiz"));
    wait_until_ready(&mut chromium);
    let questions = include_bytes!("../../assets/examples/questions/our-coins.toml");
    drop_named(&mut chromium, "our-coins.toml", questions);
    wait_for(&mut chromium, "our-coins.toml is saved");
    press(&mut chromium, &["Enter"]);
    wait_for(&mut chromium, "your own questions");
    chromium.open(&format!("{page}#quiz=separation-5"));
    wait_until_ready(&mut chromium);
    press(&mut chromium, &["a", "Enter", "2"]);
    wait(300);
    let answered = progress(&mut chromium);
    let mut another = Chromium::start((1000, 700), false);
    another.open(&format!("{page}#progress"));
    wait_until_ready(&mut another);
    let before = another.run(SCREEN, &[]);
    drop_file(&mut another, &answered);
    wait_for(&mut another, "has been added to your progress here");
    press(&mut another, &["Enter"]);
    wait(300);
    assert_ne!(another.run(SCREEN, &[]), before);
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_tab_shows_data_saved_by_another_tab_when_it_gets_the_focus() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    chromium.open(&format!("{page}#progress"));
    wait_until_ready(&mut chromium);
    let none = chromium.run(SCREEN, &[]);
    let first = chromium.window();
    chromium.another_window();
    chromium.open(&format!("{page}#quiz=separation-5"));
    wait_until_ready(&mut chromium);
    press(&mut chromium, &["a", "Enter", "2"]);
    wait(300);
    chromium.go_to(&first);
    chromium.run("dispatchEvent(new Event('focus'))", &[]);
    wait(600);
    assert_ne!(chromium.run(SCREEN, &[]), none);
}

/// Waits until the page shows a text.
fn wait_for(chromium: &mut Chromium, words: &str) {
    let mut screen = Value::Null;
    for _ in 0..400 {
        screen = chromium.run(SCREEN, &[]);
        if screen.as_str().unwrap().contains(words) {
            return;
        }
        wait(50);
    }
    panic!("no {words}: {screen}");
}

/// The bytes of a database after these SQL statements have been executed in it.
fn crafted(bytes: &[u8], sql: &str) -> Vec<u8> {
    let folder = Folder::new("page-crafted");
    let path = folder.path().join("progress.db");
    fs::write(&path, bytes).unwrap();
    let database = Connection::open(&path).unwrap();
    database.execute_batch(sql).unwrap();
    drop(database);
    fs::read(&path).unwrap()
}

/// The databases are crafted to keep a page busy forever or to change saved data.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_crafted_database_is_refused_before_it_is_queried() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    chromium.open(&format!("{page}#quiz=separation-5"));
    wait_until_ready(&mut chromium);
    press(&mut chromium, &["a", "Enter", "2"]);
    wait_for_told(&mut chromium, 1);
    let own = progress(&mut chromium);
    for sql in [
        "ALTER TABLE attempt RENAME TO hidden;
         CREATE VIEW attempt AS
            WITH RECURSIVE number (n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM number)
            SELECT n AS id, 1 AS time_s, 'Ada' AS player, 'where-to' AS family, 'x' AS topic,
                1 AS seed, n AS number, '{}' AS question, '{}' AS answer, '{}' AS truth,
                NULL AS error_deg, 1 AS credit, 1 AS is_right, NULL AS confidence,
                NULL AS misconception
            FROM number",
        "CREATE TRIGGER more AFTER INSERT ON attempt BEGIN DELETE FROM attempt; END",
    ] {
        press(&mut chromium, &["Escape"]);
        let start = Instant::now();
        drop_file(&mut chromium, &crafted(&own, sql));
        wait_for(
            &mut chromium,
            "not a carrom database: carrom did not create its",
        );
        println!("refused after {} ms", start.elapsed().as_millis());
        assert_eq!(progress(&mut chromium), own);
    }
    // A database that is too large is not even read.
    press(&mut chromium, &["Escape"]);
    let script = "
        window.read = 0;
        const arrayBuffer = Blob.prototype.arrayBuffer;
        Blob.prototype.arrayBuffer = function () {
          window.read += 1;
          return arrayBuffer.call(this);
        };
        const dropped = new DataTransfer();
        dropped.items.add(new File([new Uint8Array(65 * 2 ** 20)], 'progress.db'));
        dispatchEvent(new DragEvent('drop', { dataTransfer: dropped }));";
    chromium.run(script, &[]);
    wait_for(
        &mut chromium,
        "its size is 65 MiB, and carrom opens files of up to 64 MiB",
    );
    assert_eq!(chromium.run("return window.read", &[]), json!(0));
    press(&mut chromium, &["Escape"]);
    drop_file(&mut chromium, &own);
    wait_for(&mut chromium, "has been added to your progress here");
    assert_eq!(answers(&progress(&mut chromium)).len(), 1);
}

/// Waits until the page has saved changes at least this many times.
fn wait_for_told(chromium: &mut Chromium, told: u64) {
    for _ in 0..400 {
        if chromium.run(TOLD, &[]).as_u64() >= Some(told) {
            return;
        }
        wait(50);
    }
    panic!("the page did not report the answers as saved");
}

/// While `window.faulty` is set, the program fails to report its changes. The script counts the
/// requests for these changes and the uncaught errors.
const FAULTY: &str = "window.faulty = true; window.asked = 0; window.uncaught = 0;
    addEventListener('unhandledrejection', () => (window.uncaught += 1));
    addEventListener('error', () => (window.uncaught += 1));
    const call = program.call;
    program.call = (command, bytes) => {
      const reply = call(command, bytes);
      if (command.do !== 'changed' || !window.faulty) return reply;
      window.asked += 1;
      return { ...reply, fault: 'the disk image is malformed', files: [], gone: [] };
    };";

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_fault_while_saving_is_reported_once_and_nothing_is_lost() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    chromium.open(&format!("{page}#quiz=separation-7&player=Ana"));
    wait_until_ready(&mut chromium);
    chromium.run(FAULTY, &[]);
    press(&mut chromium, &["a", "Enter", "2"]);
    wait(3000);
    let said = chromium.run("return document.body.innerText", &[]);
    let said = said.as_str().unwrap();
    assert!(said.contains("cannot be saved at the moment"), "{said}");
    assert!(said.contains("the disk image is malformed"), "{said}");
    let asked = chromium.run("return window.asked", &[]);
    let asked = asked.as_u64().unwrap();
    assert!((1..=4).contains(&asked), "{asked} tries");
    assert_eq!(chromium.run(TOLD, &[]), json!(0));
    chromium.run("window.faulty = false", &[]);
    for _ in 0..200 {
        if chromium.run(TOLD, &[]) != json!(0) {
            break;
        }
        wait(100);
    }
    assert_eq!(chromium.run("return window.uncaught", &[]), json!(0));
    chromium.open("about:blank");
    chromium.open(&format!("{page}#progress"));
    wait_until_ready(&mut chromium);
    assert_eq!(answers(&progress(&mut chromium)).len(), 1);
}

/// While `window.faulty` is set, the browser fails to save anything. The script counts the attempts
/// and the uncaught errors, and records in `bases` the databases that the page has opened.
const FAULTY_BROWSER: &str = "
    Object.assign(window, { faulty: false, unreadable: false, tries: 0, uncaught: 0, bases: [] });
    addEventListener('unhandledrejection', () => (window.uncaught += 1));
    addEventListener('error', () => (window.uncaught += 1));
    const { transaction } = IDBDatabase.prototype;
    IDBDatabase.prototype.transaction = function (names, mode, options) {
      window.bases.push(this);
      if (window.unreadable && mode === 'readonly') throw new DOMException('', 'UnknownError');
      if (mode === 'readwrite') window.tries += 1;
      return transaction.call(this, names, mode, options);
    };
    const { put } = IDBObjectStore.prototype;
    IDBObjectStore.prototype.put = function (content, path) {
      if (window.faulty) throw new DOMException('', 'DataError');
      return put.call(this, content, path);
    };";

/// The page at a route, in a browser that can be made to fail.
fn in_a_faulty_browser(place: &str) -> (Chromium, String) {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    let before = json!({ "source": FAULTY_BROWSER });
    chromium.debug("Page.addScriptToEvaluateOnNewDocument", &before);
    chromium.open(&format!("{page}#{place}"));
    wait_until_ready(&mut chromium);
    (chromium, page)
}

/// The number of answers after the page is loaded again.
fn kept_answers(chromium: &mut Chromium, page: &str) -> usize {
    assert_eq!(chromium.run("return window.uncaught", &[]), json!(0));
    chromium.open("about:blank");
    chromium.open(page);
    wait_until_ready(chromium);
    answers(&progress(chromium)).len()
}

/// Whether the browser would ask for confirmation before closing the page.
const ASKS: &str = "
    const leaving = new Event('beforeunload', { cancelable: true });
    return !dispatchEvent(leaving);";

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_temporary_browser_fault_is_reported_once_and_loses_nothing_as_saving_is_retried() {
    let (mut chromium, page) = in_a_faulty_browser("quiz=separation-3");
    assert_eq!(chromium.run(ASKS, &[]), json!(false));
    chromium.run("window.faulty = true", &[]);
    let start = Instant::now();
    assert_eq!(times_told(&mut chromium), 1);
    wait(10_000);
    let tries = chromium.run("return window.tries", &[]).as_u64().unwrap();
    let seconds = start.elapsed().as_secs();
    println!("{tries} attempts in {seconds} s with two answers and a setting");
    // Besides the attempts that follow the two answers, there are retries at growing intervals.
    assert!((3..=8).contains(&tries), "{tries} tries in {seconds} s");
    assert_eq!(chromium.run(ASKS, &[]), json!(true));
    chromium.run("window.faulty = false", &[]);
    wait_for_told(&mut chromium, 1);
    assert_eq!(chromium.run(ASKS, &[]), json!(false));
    let screen = chromium.run(SCREEN, &[]);
    assert!(!screen.as_str().unwrap().contains("not saved"), "{screen}");
    assert_eq!(kept_answers(&mut chromium, &page), 2);
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn unsaved_changes_are_not_lost_when_another_route_is_opened() {
    let (mut chromium, page) = in_a_faulty_browser("quiz=separation-3");
    chromium.run("window.faulty = true", &[]);
    press(&mut chromium, &["a", "Enter", "2"]);
    wait_for(&mut chromium, "cannot be saved at the moment");
    chromium.run("location.hash = 'lab'", &[]);
    wait_for(&mut chromium, "set up the hit");
    chromium.run("window.faulty = false", &[]);
    wait_for_told(&mut chromium, 1);
    assert_eq!(kept_answers(&mut chromium, &page), 1);
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn files_that_could_not_be_read_are_not_overwritten() {
    let (mut chromium, page) = in_a_faulty_browser("quiz=separation-3");
    press(&mut chromium, &["a", "Enter", "2"]);
    wait_for_told(&mut chromium, 1);
    chromium.run(
        "window.unreadable = true; location.hash = 'quiz=separation-4'",
        &[],
    );
    wait(500);
    chromium.run("window.unreadable = false", &[]);
    press(&mut chromium, &["a", "Enter", "2"]);
    wait_for_told(&mut chromium, 2);
    assert_eq!(kept_answers(&mut chromium, &page), 2);
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_database_that_the_browser_closes_is_opened_again() {
    let (mut chromium, page) = in_a_faulty_browser("quiz=separation-3");
    chromium.run("for (const base of window.bases) base.close()", &[]);
    press(&mut chromium, &["a", "Enter", "2"]);
    wait_for_told(&mut chromium, 1);
    assert_eq!(kept_answers(&mut chromium, &page), 1);
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn plain_mode_reports_once_that_nothing_can_be_saved_and_saves_it_later() {
    let (mut chromium, page) = in_a_faulty_browser("plain&quiz=separation-3");
    chromium.run("window.faulty = true", &[]);
    let say = "
        document.getElementById('line').value = arguments[0];
        document.getElementById('answer').requestSubmit();";
    for line in ["a", "3", "a", "3", ""] {
        chromium.run(say, &[Value::from(line)]);
        wait(300);
    }
    let times = |chromium: &mut Chromium, words: &str| {
        let log = chromium.run("return document.getElementById('log').textContent", &[]);
        log.as_str().unwrap().matches(words).count()
    };
    assert_eq!(times(&mut chromium, "cannot be saved at the moment"), 1);
    assert_eq!(times(&mut chromium, "Question 3 of"), 1);
    chromium.run("window.faulty = false", &[]);
    wait_for_told(&mut chromium, 1);
    assert_eq!(times(&mut chromium, "is saved now"), 1);
    assert_eq!(kept_answers(&mut chromium, &page), 2);
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_program_that_stops_while_a_file_or_a_link_is_opened_is_reported() {
    for (does, act) in [
        ("open", "location.hash = 'lab'"),
        (
            "file",
            "const dropped = new DataTransfer();
             dropped.items.add(new File(['x'], 'game.toml'));
             dispatchEvent(new DragEvent('drop', { dataTransfer: dropped }));",
        ),
    ] {
        let (mut chromium, _) = in_a_faulty_browser("quiz=separation-3");
        let stops = "
            const call = program.call;
            program.call = (command, bytes) => {
              if (command.do === arguments[0]) throw new WebAssembly.RuntimeError('unreachable');
              return call(command, bytes);
            };";
        chromium.run(stops, &[Value::from(does)]);
        chromium.run(act, &[]);
        wait_for(
            &mut chromium,
            "Something went wrong, and carrom has stopped",
        );
        assert_eq!(chromium.run("return window.uncaught", &[]), json!(0));
    }
}
