//! What a class hands in, put together: 32 files, some of them odd.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use carrom::gradebook::HandIn;
use carrom::messages::{StoreCall, StoreReply, StoreRequest};
use carrom::progress::Attempt;
use carrom::store::Store;
use scraper::{Html, Selector};

use crate::folder::Folder;
use crate::handed_in::hand_in;

fn carrom(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carrom"));
    command.args(arguments).output().unwrap()
}

fn stderr(done: &Output) -> String {
    String::from_utf8_lossy(&done.stderr).into_owned()
}

/// Thirty-two files: 28 pupils, of whom two are called Ada and two have handed in twice, and two
/// files that are damaged.
fn class(folder: &Path) {
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).unwrap();
    for index in 1..=28 {
        let name = match index {
            1 | 2 => "Ada".to_owned(),
            3 => "=Söhne()".to_owned(),
            _ => format!("Pupil {index:02}"),
        };
        let right = usize::try_from(index).unwrap() % 11;
        let text = hand_in(index, &name, 10, right).text().unwrap();
        write(&format!("{index:02}.json"), &text);
    }
    // Once more with nothing new, and a first hand-in of half of it.
    write(
        "29-again.json",
        &hand_in(4, "Pupil 04", 10, 4).text().unwrap(),
    );
    write(
        "30-half.json",
        &hand_in(5, "pupil 05", 5, 5).text().unwrap(),
    );
    let whole = hand_in(6, "Pupil 31", 10, 6).text().unwrap();
    write("31-cut.json", &whole[..whole.len() / 2]);
    write(
        "32-newer.json",
        &whole.replace("\"format\": 1", "\"format\": 9"),
    );
}

fn records(path: &Path) -> (Vec<String>, Vec<csv::StringRecord>) {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let heads = reader.headers().unwrap().iter().map(Into::into).collect();
    (heads, reader.records().map(Result::unwrap).collect())
}

#[test]
fn a_class_of_32_is_gathered_into_tables() {
    let folder = Folder::new("gather");
    let handed_in = folder.path().join("handed-in");
    fs::create_dir(&handed_in).unwrap();
    class(&handed_in);
    let out = folder.path().join("class.csv");
    let done = carrom(&[
        "gather",
        handed_in.to_str().unwrap(),
        "--out",
        out.to_str().unwrap(),
    ]);
    let told = String::from_utf8(done.stderr).unwrap();
    assert!(done.status.success(), "{told}");
    // Each odd file is named, with what is odd about it.
    let lines: Vec<&str> = told.lines().collect();
    assert_eq!(lines.len(), 5, "{told}");
    for (file, words) in [
        ("02.json", "another Ada"),
        ("29-again.json", "nothing in it is new"),
        ("30-half.json", "nothing in it is new"),
        ("31-cut.json", "damaged"),
        ("32-newer.json", "newer"),
    ] {
        let line = lines.iter().find(|line| line.contains(file));
        assert!(
            line.is_some_and(|line| line.contains(words)),
            "{file}: {told}"
        );
    }
    let (heads, pupils) = records(&out);
    assert_eq!(pupils.len(), 28);
    let column = |name: &str| heads.iter().position(|head| head == name).unwrap();
    let named = |name: &str| pupils.iter().find(|row| &row[0] == name).unwrap();
    assert_eq!(&named("Ada")[column("mixed-7 right")], "1");
    assert_eq!(&named("Ada (2)")[column("mixed-7 right")], "2");
    assert!(pupils.iter().any(|row| &row[0] == "'=Söhne()"));
    // Twice the same answers are ten answers.
    assert_eq!(&named("Pupil 04")[column("answered")], "10");
    assert_eq!(&named("Pupil 05")[column("mixed-7 right")], "5");
    assert_eq!(&named("Pupil 10")[column("share_right")], "1.000");
    let (heads, items) = records(&folder.path().join("class-items.csv"));
    assert_eq!(items.len(), 10);
    let column = |name: &str| heads.iter().position(|head| head == name).unwrap();
    for (number, item) in items.iter().enumerate() {
        // Who has `right` answers has the first so many; question 1 is right for all but those
        // with a multiple of eleven.
        let right = (1..=28).filter(|index| index % 11 > number).count();
        assert_eq!(&item[column("answered")], "28");
        let share = right as f64 / 28.0;
        assert_eq!(item[column("share_right")], format!("{share:.3}"));
        assert!(!item[column("question")].is_empty() && !item[column("discrimination")].is_empty());
    }
    let (_, beliefs) = records(&folder.path().join("class-beliefs.csv"));
    assert!(!beliefs.is_empty());
}

#[test]
fn the_gradebook_has_a_page_for_every_pupil() {
    let folder = Folder::new("gather-html");
    let handed_in = folder.path().join("handed-in");
    fs::create_dir(&handed_in).unwrap();
    class(&handed_in);
    let out = folder.path().join("class.html");
    let arguments = [
        "gather",
        handed_in.to_str().unwrap(),
        "--out",
        out.to_str().unwrap(),
    ];
    assert!(carrom(&arguments).status.success());
    let page = Html::parse_document(&fs::read_to_string(&out).unwrap());
    let all = |what: &str| page.select(&Selector::parse(what).unwrap()).count();
    assert_eq!(all(".sheet"), 3 + 28);
    assert_eq!(all("script, img, link"), 0);
    assert_eq!(all(".notes li"), 5);
    // It is not written over without being told so.
    let again = carrom(&arguments);
    assert!(!again.status.success() && String::from_utf8_lossy(&again.stderr).contains("--force"));
}

/// Whoever is on the list of the class and has handed in nothing is named, and nobody else.
#[test]
fn who_of_the_class_list_is_missing_is_told() {
    let folder = Folder::new("gather-list");
    let handed_in = folder.path().join("handed-in");
    fs::create_dir(&handed_in).unwrap();
    for (file, name) in [("1.json", "Ada"), ("2.json", "Zoë Söhne")] {
        let text = hand_in(1, name, 2, 1).text().unwrap();
        fs::write(handed_in.join(file), text).unwrap();
    }
    // As a spreadsheet saves it: a mark at its beginning, line ends of Windows, rows without a name.
    let list = folder.file("list.txt", "\u{feff}ADA\r\nBo\r\n\r\n zoë söhne \r\nCy\r\n");
    let out = folder.path().join("class.html");
    let gather = |list: &str| {
        let [from, out] = [&handed_in, &out].map(|path| path.to_str().unwrap());
        let arguments = ["gather", from, "--out", out, "--force", "--class-list"];
        let done = carrom(&[&arguments[..], &[list]].concat());
        let told = String::from_utf8(done.stderr).unwrap();
        (done.status.code(), told)
    };
    let (status, told) = gather(&list);
    assert_eq!(status, Some(0), "{told}");
    assert!(
        told.contains("2 of the class list handed in nothing: Bo, Cy"),
        "{told}"
    );
    assert!(fs::read_to_string(&out).unwrap().contains("Bo, Cy"));
    // A list that is not there is said, and nothing is written in its place.
    let (status, told) = gather("no-such-list.txt");
    assert_eq!(status, Some(2), "{told}");
    assert!(told.contains("no-such-list.txt"), "{told}");
}

#[test]
fn what_a_player_hands_in_is_read_back() {
    let folder = Folder::new("hand-in");
    let data = folder.path().join("data");
    let mut store = Store::in_folder(&data);
    for attempt in hand_in(1, "Ada", 3, 2).attempts {
        let wish = StoreRequest::Record(Box::new(attempt));
        let noted = store.answer(&StoreCall { ticket: 0, wish }).done;
        assert!(matches!(noted, StoreReply::Noted(Ok(()))), "{noted:?}");
    }
    let out = folder.path().join("ada.json");
    let out = out.to_str().unwrap();
    let data = data.to_str().unwrap();
    let arguments = [
        "hand-in",
        "--player",
        "Ada",
        "--class",
        "10b",
        "--data-dir",
        data,
        "--out",
        out,
    ];
    let done = carrom(&arguments);
    assert!(
        done.status.success(),
        "{}",
        String::from_utf8_lossy(&done.stderr)
    );
    let read = HandIn::read(&fs::read(out).unwrap()).unwrap();
    assert_eq!((read.name.as_str(), read.class.as_str()), ("Ada", "10b"));
    let rights: Vec<bool> = read.attempts.iter().map(|it| it.right).collect();
    assert_eq!(rights, [true, true, false]);
    // Written and read again it is the same.
    assert_eq!(HandIn::read(read.text().unwrap().as_bytes()), Ok(read));
    // Nothing to hand in is said.
    let nobody = carrom(&["hand-in", "--player", "Nobody", "--data-dir", data]);
    assert_eq!(nobody.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&nobody.stderr).contains("no answer"));
}

/// A gradebook parsed all answers of a pupil again for every cell: with as many rounds as
/// this it took minutes.
#[test]
fn a_hand_in_of_many_rounds_is_gathered_in_seconds() {
    const ROUNDS: u64 = 4_000;
    let folder = Folder::new("gather-many-rounds");
    let handed_in = folder.path().join("handed-in");
    fs::create_dir(&handed_in).unwrap();
    let mut ada = hand_in(1, "Ada", 1, 1);
    let answer = ada.attempts.remove(0);
    ada.attempts.extend((1..=ROUNDS).map(|seed| {
        Attempt {
            seed,
            question: answer
                .question
                .replace("mixed-7", &format!("speeds1-{seed}")),
            ..answer.clone()
        }
    }));
    fs::write(handed_in.join("ada.json"), ada.text().unwrap()).unwrap();
    let out = folder.path().join("class.html");
    let start = Instant::now();
    let done = carrom(&[
        "gather",
        handed_in.to_str().unwrap(),
        "--out",
        out.to_str().unwrap(),
    ]);
    let took = start.elapsed();
    assert!(done.status.success(), "{}", stderr(&done));
    assert!(took < Duration::from_secs(20), "{took:?}");
    let text = fs::read_to_string(out).unwrap();
    assert_eq!(text.matches("10.0 (1 of 1)").count(), 4_000);
}

#[test]
fn no_bytes_break_the_reader() {
    let text = hand_in(1, "Ada", 2, 1).text().unwrap();
    for end in 0..text.len() - 1 {
        if let Some(cut) = text.get(..end) {
            assert!(HandIn::read(cut.as_bytes()).is_err(), "{cut}");
        }
    }
    for bad in [
        text.replace("\"credit\": 1.0", "\"credit\": 1e9"),
        text.replace("\"name\": \"Ada\"", "\"name\": \"\\u202e\""),
        text.replace("\"confidence\": \"sure\"", "\"confidence\": \"maybe\""),
        "[]".into(),
        "{\"carrom\": \"hand-in\", \"format\": \"1\"}".into(),
    ] {
        assert!(HandIn::read(bad.as_bytes()).is_err(), "{bad}");
    }
}

/// The CSV of a folder with this one hand-in, if it was gathered, and what was said.
fn gathered(bytes: &[u8]) -> (Option<String>, String) {
    let folder = Folder::new("gather-one");
    fs::write(folder.path().join("one.json"), bytes).unwrap();
    let out = folder.path().join("class.csv");
    let place = folder.path().to_str().unwrap();
    let done = carrom(&["gather", place, "--out", out.to_str().unwrap()]);
    (fs::read_to_string(out).ok(), stderr(&done))
}

/// A hand-in of one answer with something in it put in another's place.
fn changed(before: &str, after: &str) -> Vec<u8> {
    let text = hand_in(1, "Ada", 1, 1).text().unwrap();
    assert!(text.contains(before), "{before}");
    text.replace(before, after).into_bytes()
}

#[test]
fn a_formula_in_a_hand_in_reaches_no_head_of_a_table() {
    for formula in ["=HYPERLINK(0)", "=cmd|'/c calc'!A1", "@SUM(A1)", "mixed"] {
        let round = changed(
            "\"round\": \"mixed-7\"",
            &format!("\"round\": \"{formula}\""),
        );
        let (table, said) = gathered(&round);
        assert!(
            table.is_none() && said.contains("answer 1 cannot be"),
            "{said}"
        );
    }
    let text = hand_in(1, "Ada", 1, 1).text().unwrap();
    let topic = text.split("\"topic\": \"").nth(1).unwrap();
    let topic = topic.split('"').next().unwrap();
    for hostile in [
        "=HYPERLINK(0)",
        "+1",
        "\\u001b[31m=1",
        "\\u0000=1",
        "\\u009b=1",
        "\\u202e=1",
    ] {
        let named = format!("\"topic\": \"{hostile}\"");
        let (table, said) = gathered(&changed(&format!("\"topic\": \"{topic}\""), &named));
        let table = table.expect(&said);
        let heads = table.lines().next().unwrap();
        assert!(
            !heads.contains(['\u{1b}', '\0', '\u{9b}', '\u{202e}']),
            "{heads:?}"
        );
        let bare = |head: &str| head.trim_matches('"').starts_with(['=', '+']);
        assert!(!heads.split(',').any(bare), "{heads:?}");
    }
}

#[test]
fn an_answer_of_an_unknown_family_is_refused() {
    let text = hand_in(1, "Ada", 1, 1).text().unwrap();
    let family = text.split("\"family\": \"").nth(1).unwrap();
    let family = family.split('"').next().unwrap();
    let known = format!("\"family\": \"{family}\"");
    let (table, said) = gathered(&changed(&known, "\"family\": \"=1+1\""));
    assert!(
        table.is_none() && said.contains("answer 1 cannot be"),
        "{said}"
    );
}

#[test]
fn a_hand_in_with_a_byte_order_mark_is_read() {
    let text = hand_in(1, "Ada", 1, 1).text().unwrap();
    let (table, said) = gathered(format!("\u{feff}{text}").as_bytes());
    assert!(table.expect(&said).contains("Ada"));
}

#[cfg(unix)]
#[test]
fn a_pipe_among_the_hand_ins_is_passed_over() {
    let folder = Folder::new("gather-pipe");
    let pipe = folder.path().join("pipe.json");
    let made = Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    let text = hand_in(1, "Ada", 1, 1).text().unwrap();
    fs::write(folder.path().join("ada.json"), text).unwrap();
    let out = folder.path().join("class.csv");
    let place = folder.path().to_str().unwrap();
    let done = carrom(&["gather", place, "--out", out.to_str().unwrap()]);
    assert!(done.status.success() && stderr(&done).contains("pipe.json"));
    assert!(fs::read_to_string(out).unwrap().contains("Ada"));
}
