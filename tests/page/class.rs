//! The page on a pupil's device: a host serves it, the pupil joins, votes and hands in answers, and
//! the page returns to its state after a reload.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

use carrom::class::Vote;
use carrom::gradebook::HandIn;
use carrom::quiz::{Code, Round};
use serde_json::{Value, json};

use crate::browser::{self, Browser, SCREEN, page, wait_until_ready};
use crate::chromium::Chromium;
use crate::folder::Folder;
use crate::handed_in::hand_in;
use crate::keys::said;
use crate::teacher::{Teacher, kept};
use crate::touch::Phone;

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_phone_joins_votes_and_comes_back() {
    let page = page();
    let page = fs::read_to_string(page.trim_start_matches("file://")).unwrap();
    let folder = Folder::new("page-class");
    let teacher = Teacher::gathering(&folder, &page);
    let address = format!("http://127.0.0.1:{}/", teacher.port);
    let mut phone = Phone::open(&address, &format!("code={}", teacher.code));
    phone.expect("Your class is playing a round");
    phone.type_in("Ada");
    phone.press("Join the class");
    phone.expect("You are in, Ada.");
    teacher.press("<Enter><Enter>", "0 of 1 have voted");
    phone.expect("Where will they go?");
    for (angle, next) in [("60", "Next, how sure?"), ("30", "How sure are you?")] {
        phone.type_in(angle);
        phone.go_on();
        phone.expect(next);
    }
    phone.go_on();
    phone.expect("Your vote is in.");
    teacher.wait_for("1 of 1 have voted");
    let said = kept(&folder)
        .ballot(0, 0)
        .vote(Vote::First)
        .unwrap()
        .rays()
        .unwrap();
    assert!((said.striker.unwrap().abs().to_degrees() - 60.0).abs() < 1e-9);
    // The page is reloaded, as happens when a phone has been put away.
    phone.0.run("location.reload()", &[]);
    thread::sleep(Duration::from_millis(500));
    wait_until_ready(&mut phone.0);
    phone.expect("Your vote is in.");
    assert_eq!(kept(&folder).teams(), ["Ada"]);
    assert_eq!(kept(&folder).voted(0, Vote::First), 1);
}

/// Presses keys, written as in a tape, and waits until the screen shows a text.
fn press(browser: &mut Chromium, keys: &str, shows: &str) {
    let mut rest = keys;
    while let Some(first) = rest.chars().next() {
        let named = rest.strip_prefix('<').and_then(|it| it.split_once('>'));
        let (key, after) = named.unwrap_or_else(|| rest.split_at(first.len_utf8()));
        browser::press(browser, &[key]);
        rest = after;
    }
    let start = Instant::now();
    loop {
        let screen = browser.run(SCREEN, &[]);
        let screen = screen.as_str().unwrap();
        if screen.contains(shows) {
            return;
        }
        let late = start.elapsed() > Duration::from_secs(20);
        assert!(!late, "{keys}: no {shows}:\n{screen}");
        thread::sleep(Duration::from_millis(50));
    }
}

/// The number of questions answered on each page.
const ALONE: usize = 3;

/// A page served by the host, after a pupil has answered the first questions of mixed-7 alone, all
/// correctly.
fn answered_alone(teacher: &Teacher, name: &str) -> Chromium {
    let mut browser = Chromium::start((1000, 700), false);
    let address = format!("http://127.0.0.1:{}/", teacher.port);
    browser.open(&format!("{address}#quiz=mixed-7&player={name}"));
    wait_until_ready(&mut browser);
    let round = Round::of(Code::parse("mixed-7").unwrap());
    for (number, question) in { 1.. }.zip(round.questions()).take(ALONE) {
        press(&mut browser, "", &format!("question {number} of 10"));
        let keys = said(&question.form, &question.form.truth());
        press(&mut browser, &keys, "How sure are you?");
        press(&mut browser, "3<End>", "points");
        // Enter pressed right after the digit would only confirm the digit (see `SETTLING` in the
        // quiz), so wait first.
        thread::sleep(Duration::from_secs(1));
        press(
            &mut browser,
            "<Enter>",
            &format!("question {} of 10", number + 1),
        );
    }
    // Waits until all answers are saved.
    let start = Instant::now();
    while browser.run("return window.carrom.told()", &[]).as_u64() < Some(ALONE as u64) {
        let late = start.elapsed() > Duration::from_secs(20);
        assert!(!late, "the answers are not saved");
        thread::sleep(Duration::from_millis(50));
    }
    browser
}

/// The hand-in files of a folder.
fn files(folder: &Path) -> Vec<HandIn> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let paths = entries.map(|entry| entry.unwrap().path());
    let paths = paths.filter(|path| path.extension().is_some_and(|it| it == "json"));
    let bytes = paths.map(|path| fs::read(path).unwrap());
    bytes.filter_map(|it| HandIn::read(&it).ok()).collect()
}

/// Thirty-two files of a class. Four come from pages: three send theirs to the host and one saves a
/// file; the others come from programs. One file is damaged, one has a newer format, two were
/// handed in twice, and two pupils are called Ada.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn handed_in_files_are_merged_into_one_gradebook() {
    let page = page();
    let page = fs::read_to_string(page.trim_start_matches("file://")).unwrap();
    let folder = Folder::new("page-hand-in");
    let teacher = Teacher::gathering(&folder, &page);
    let handed_in = folder.path().join("handed-in");
    for name in ["Ada", "Bo", "Ada"] {
        let mut browser = answered_alone(&teacher, name);
        let to_class = "location.hash = 'code=' + arguments[0]";
        browser.run(to_class, &[Value::from(teacher.code.clone())]);
        press(&mut browser, "", "Your class is playing a round");
        let keys = format!("{name}<Enter><Enter>");
        press(&mut browser, &keys, "Hand in the 3 answers");
        press(&mut browser, "h", "Send ");
        press(&mut browser, "y", "Handed in: 3 answers.");
        // Handing in again does not create a second file.
        press(&mut browser, "hy", "Handed in: 3 answers.");
    }
    let mut sent = files(&handed_in);
    sent.sort_by(|a, b| a.name.cmp(&b.name));
    let names: Vec<&str> = sent.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(names, ["Ada", "Ada 2", "Bo"]);
    for it in &sent {
        assert_eq!((it.class.as_str(), it.attempts.len()), ("10b", ALONE));
        assert!(it.attempts.iter().all(|it| it.right), "{}", it.name);
    }
    // Zoë has not joined a class.
    let mut browser = answered_alone(&teacher, "Zoë");
    let place = json!({ "behavior": "allow", "downloadPath": handed_in.to_str().unwrap() });
    browser.debug("Browser.setDownloadBehavior", &place);
    browser.run("location.hash = 'progress&player=Zoë'", &[]);
    press(&mut browser, "", "3 answers");
    press(&mut browser, "h", "The file to hand in");
    let start = Instant::now();
    while files(&handed_in).len() < 4 {
        let late = start.elapsed() > Duration::from_secs(20);
        assert!(!late, "no file was handed in");
        thread::sleep(Duration::from_millis(50));
    }
    let write = |name: &str, text: &str| fs::write(handed_in.join(name), text).unwrap();
    for index in 1..=24 {
        let right = usize::try_from(index).unwrap() % 11;
        let name = format!("Pupil {index:02}");
        let text = hand_in(index, &name, 10, right).text().unwrap();
        write(&format!("{index:02}.json"), &text);
    }
    let again = hand_in(4, "Pupil 04", 10, 4).text().unwrap();
    write("25-again.json", &again);
    let half = hand_in(5, "pupil 05", 5, 5).text().unwrap();
    write("26-half.json", &half);
    let whole = hand_in(6, "Pupil 31", 10, 6).text().unwrap();
    write("27-cut.json", &whole[..whole.len() / 2]);
    let newer = whole.replace("\"format\": 1", "\"format\": 9");
    write("28-newer.json", &newer);
    let [table, book] = ["class.csv", "class.html"].map(|out| {
        let out = folder.path().join(out);
        let mut gather = Command::new(env!("CARGO_BIN_EXE_carrom"));
        gather.arg("gather").arg(&handed_in).arg("--out").arg(&out);
        let done = gather.output().unwrap();
        let told = String::from_utf8(done.stderr).unwrap();
        assert!(done.status.success(), "{told}");
        assert_eq!(told.lines().count(), 4, "{told}");
        fs::read_to_string(out).unwrap()
    });
    let rows: Vec<&str> = table.lines().skip(1).collect();
    assert_eq!(rows.len(), 28, "{table}");
    for begins in ["Ada,10b,3,3,1.000,30.0,", "Ada 2,10b,3,3,", "Zoë,,3,3,"] {
        let is_there = rows.iter().any(|row| row.starts_with(begins));
        assert!(is_there, "{begins}: {table}");
    }
    // The four pupils with pages answered only the first three questions.
    let items = folder.path().join("class-items.csv");
    let mut items = csv::Reader::from_path(items).unwrap();
    let answered = items.records().map(|row| row.unwrap()[3].to_owned());
    let answered: Vec<String> = answered.take(4).collect();
    assert_eq!(answered, ["28", "28", "28", "24"]);
    assert!(book.contains("27-cut.json: left out") && book.contains("Ada 2"));
    if let Some(place) = std::env::var_os("CARROM_GATHERED") {
        fs::write(place, book).unwrap();
    }
}
