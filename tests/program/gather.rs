//! Combines the hand-ins of a class: 32 files, some of them with problems.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use carrom::gradebook::{Gradebook, HandIn, items};
use carrom::messages::{PlayerAction, StoreCall, StoreReply, StoreRequest};
use carrom::progress::{Attempt, LEVEL, TABLE};
use carrom::quiz::{Answer, Code, Confidence, Family, Round};
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

/// Writes thirty-two files. Thirty are from 28 pupils, of whom two are called Ada and two have
/// handed in twice; one is damaged, and one is too new.
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
    // One hand-in is repeated without new answers, and another was sent earlier with half of its
    // answers.
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
fn thirty_two_hand_ins_are_combined_into_tables() {
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
    // Each file with a problem is named, along with the problem.
    let lines: Vec<&str> = told.lines().collect();
    assert_eq!(lines.len(), 5, "{told}");
    for (file, words) in [
        ("02.json", "another Ada"),
        ("29-again.json", "no new answers"),
        ("30-half.json", "no new answers"),
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
    // The same ten answers handed in twice are counted once.
    assert_eq!(&named("Pupil 04")[column("answered")], "10");
    assert_eq!(&named("Pupil 05")[column("mixed-7 right")], "5");
    assert_eq!(&named("Pupil 10")[column("share_right")], "1.000");
    let (heads, items) = records(&folder.path().join("class-items.csv"));
    assert_eq!(items.len(), 10);
    let column = |name: &str| heads.iter().position(|head| head == name).unwrap();
    for (number, item) in items.iter().enumerate() {
        // A pupil with `right` right answers has the first `right` questions right; question 1 is
        // right for all pupils except those whose index is a multiple of eleven.
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
    // An existing file is not replaced without --force.
    let again = carrom(&arguments);
    assert!(!again.status.success() && String::from_utf8_lossy(&again.stderr).contains("--force"));
}

/// Of the pupils on the class list, only those who have handed in nothing are listed.
#[test]
fn pupils_on_the_class_list_without_a_hand_in_are_listed() {
    let folder = Folder::new("gather-list");
    let handed_in = folder.path().join("handed-in");
    fs::create_dir(&handed_in).unwrap();
    for (file, name) in [("1.json", "Ada"), ("2.json", "Zoë Söhne")] {
        let text = hand_in(1, name, 2, 1).text().unwrap();
        fs::write(handed_in.join(file), text).unwrap();
    }
    // As saved by a spreadsheet: a byte order mark, Windows line endings, and a row without a name.
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
        told.contains("2 pupils on the class list handed in nothing: Bo, Cy"),
        "{told}"
    );
    assert!(fs::read_to_string(&out).unwrap().contains("Bo, Cy"));
    // A missing list is reported.
    let (status, told) = gather("no-such-list.txt");
    assert_eq!(status, Some(2), "{told}");
    assert!(told.contains("no-such-list.txt"), "{told}");
}

#[test]
fn a_hand_in_is_read_back() {
    let folder = Folder::new("hand-in");
    let data = folder.path().join("data");
    let mut store = Store::in_folder(&data);
    for attempt in hand_in(1, "Ada", 3, 2).attempts {
        let request = StoreRequest::Note(PlayerAction::Record(Box::new(attempt)));
        let noted = store.answer(&StoreCall { ticket: 0, request }).done;
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
    // Writing the hand-in and reading it again changes nothing.
    assert_eq!(HandIn::read(read.text().unwrap().as_bytes()), Ok(read));
    // A player without answers gets a message.
    let nobody = carrom(&["hand-in", "--player", "Nobody", "--data-dir", data]);
    assert_eq!(nobody.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&nobody.stderr).contains("no answer"));
}

/// Earlier versions of carrom refuse calls and predictions, so a file that contains any has a newer
/// format.
#[test]
fn calls_and_predictions_are_handed_in_but_make_no_items() {
    let mut ada = hand_in(1, "Ada", 2, 2);
    let format = |it: &HandIn| it.value().unwrap()["format"].clone();
    assert_eq!(format(&ada), 1);
    for (answer, family) in ada.attempts.iter_mut().zip([TABLE, LEVEL]) {
        answer.family = family.into();
        answer.topic = "heavier-striker-by-offset".into();
        answer.question.remove("round");
        answer.number = 700;
    }
    assert_eq!(format(&ada), 2);
    let read = HandIn::read(ada.text().unwrap().as_bytes()).unwrap();
    assert_eq!(read, ada);
    let mut book = Gradebook::default();
    book.add("ada.json", Ok(read));
    let results = book.results();
    let rounds: Vec<&String> = results.pupils[0].rounds.keys().collect();
    assert_eq!(rounds, ["table", "levels"]);
    assert!(items(&results).is_empty());
    // A topic that no call or prediction can have is refused.
    for topic in ["rutherford", "=1+1"] {
        ada.attempts[0].topic = topic.into();
        let read = HandIn::read(ada.text().unwrap().as_bytes());
        assert!(read.unwrap_err().contains("its topic is"));
    }
}

/// A gradebook once parsed all of a pupil's answers again for every cell, which took minutes with
/// 4,000 rounds.
#[test]
fn a_hand_in_with_many_rounds_is_gathered_in_seconds() {
    const ROUNDS: u64 = 4_000;
    let folder = Folder::new("gather-many-rounds");
    let handed_in = folder.path().join("handed-in");
    fs::create_dir(&handed_in).unwrap();
    let mut ada = hand_in(1, "Ada", 1, 1);
    let answer = ada.attempts.remove(0);
    ada.attempts.extend((1..=ROUNDS).map(|seed| {
        let mut answer = answer.clone();
        let round = format!("speeds1-{seed}").into();
        answer.question.insert("round".into(), round);
        Attempt { seed, ..answer }
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
fn any_bytes_are_either_read_as_a_hand_in_or_refused() {
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

/// Gathers a folder with this one hand-in; returns the CSV, if it was written, and the messages.
fn gathered(bytes: &[u8]) -> (Option<String>, String) {
    let folder = Folder::new("gather-one");
    fs::write(folder.path().join("one.json"), bytes).unwrap();
    let out = folder.path().join("class.csv");
    let place = folder.path().to_str().unwrap();
    let done = carrom(&["gather", place, "--out", out.to_str().unwrap()]);
    (fs::read_to_string(out).ok(), stderr(&done))
}

/// A hand-in of one answer, with one string replaced with another.
fn changed(before: &str, after: &str) -> Vec<u8> {
    let text = hand_in(1, "Ada", 1, 1).text().unwrap();
    assert!(text.contains(before), "{before}");
    text.replace(before, after).into_bytes()
}

/// Whether a cell has an effect in a spreadsheet or a terminal.
fn is_hostile(cell: &str) -> bool {
    let orders = |c: char| c.is_control() || ('\u{202a}'..='\u{202e}').contains(&c);
    cell.trim_start().starts_with(['=', '+', '@', '-']) && cell.parse::<f64>().is_err()
        || cell.contains(orders)
}

/// Formulas and control characters, as written in JSON.
const HOSTILE: [&str; 8] = [
    "=HYPERLINK(\\\"http://x.invalid\\\")",
    "=cmd|'/c calc'!A1",
    "@SUM(A1)",
    "+1+1",
    "\\u001b[31m=1",
    "\\u0000=1",
    "\\u009b=1",
    "\\u202e=1",
];

#[test]
fn a_hand_in_with_a_formula_as_a_round_or_a_topic_is_refused() {
    let sound = hand_in(1, "Ada", 1, 1).text().unwrap();
    let topic = sound.split("\"topic\": \"").nth(1).unwrap();
    let topic = topic.split('"').next().unwrap();
    for hostile in HOSTILE {
        for (field, value) in [("round", "mixed-7"), ("topic", topic)] {
            let before = format!("\"{field}\": \"{value}\"");
            let after = format!("\"{field}\": \"{hostile}\"");
            let (table, said) = gathered(&changed(&before, &after));
            let names_it = said.contains(&format!("answer 1 is impossible: its {field} is"));
            assert!(table.is_none() && names_it, "{hostile}: {said}");
            assert!(
                !said.lines().any(|line| line.contains('\u{1b}')),
                "{said:?}"
            );
        }
    }
}

/// Topics of a teacher's own questions and chapters may be any text, and so may names and classes,
/// so they must be harmless in every table.
#[test]
fn no_text_in_a_hand_in_becomes_a_formula_in_any_table() {
    for hostile in HOSTILE {
        let text = hand_in(1, "Ada", 1, 1).text().unwrap();
        let value: serde_json::Value = serde_json::from_str(&text).unwrap();
        let family = format!("\"family\": {}", value["answers"][0]["family"]);
        let topic = format!("\"topic\": {}", value["answers"][0]["topic"]);
        for family_of_free_topics in ["concept", "lesson"] {
            let mut text = text.replace("mixed-7", "own-7");
            text = text.replace(&family, &format!("\"family\": \"{family_of_free_topics}\""));
            text = text.replace(&topic, &format!("\"topic\": \"{hostile}\""));
            text = text.replace("\"Ada\"", &format!("\"{hostile}\""));
            text = text.replace("\"10b\"", &format!("\"{hostile}\""));
            let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
            if family_of_free_topics == "lesson" {
                for said in ["answer", "truth"] {
                    value["answers"][0][said] = serde_json::json!({"choice": 1});
                }
            }
            let folder = Folder::new("gather-hostile");
            fs::write(folder.path().join("one.json"), value.to_string()).unwrap();
            let out = folder.path().join("class.csv");
            let place = folder.path().to_str().unwrap();
            let done = carrom(&["gather", place, "--out", out.to_str().unwrap()]);
            assert!(done.status.success(), "{} {text}", stderr(&done));
            for name in ["class.csv", "class-items.csv", "class-beliefs.csv"] {
                let (heads, rows) = records(&folder.path().join(name));
                let cells = rows.iter().flat_map(|row| row.iter());
                let all: Vec<&str> = heads.iter().map(String::as_str).chain(cells).collect();
                assert!(all.len() > 4, "{name}");
                for cell in all {
                    assert!(!is_hostile(cell), "{name}: {cell:?}");
                }
            }
            let (heads, _) = records(&out);
            let round = match family_of_free_topics {
                "lesson" => "chapter: ",
                _ => "own-7 ",
            };
            assert!(
                heads.iter().any(|head| head.starts_with(round)),
                "{heads:?}"
            );
        }
    }
}

#[test]
fn one_round_is_one_column_however_its_code_is_spelt() {
    for spelt in [" MIXED-7 ", "mixed10-7", "mixed-007"] {
        let (table, said) = gathered(&changed(
            "\"round\": \"mixed-7\"",
            &format!("\"round\": \"{spelt}\""),
        ));
        let table = table.expect(&said);
        assert!(
            table.lines().next().unwrap().contains(",mixed-7 answered,"),
            "{table}"
        );
    }
}

#[test]
fn an_answer_out_of_range_or_of_the_wrong_kind_is_refused() {
    let text = hand_in(1, "Ada", 1, 1).text().unwrap();
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    let sound = &value["answers"][0];
    let written = |value: &serde_json::Value| value.to_string().into_bytes();
    assert!(HandIn::read(&written(&value)).is_ok());
    let with = |field: &str, changed: serde_json::Value| {
        let mut value = value.clone();
        value["answers"][0][field] = changed;
        HandIn::read(&written(&value))
    };
    let json = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    for (field, changed) in [
        ("answer", r#"{"choice": 99}"#),
        ("answer", r#"{"theta1_deg": 1e300, "theta2_deg": 0}"#),
        ("answer", r#"{"angle_deg": 500}"#),
        ("answer", r#"{"unheard_of": 1}"#),
        ("answer", r#"{"choice": "=1+1", "angle_deg": 1}"#),
        ("error_deg", "-1"),
        ("error_deg", "1e300"),
        ("credit", "2"),
        ("number", "0"),
        ("number", "11"),
        ("confidence", "\"maybe\""),
    ] {
        let read = with(field, json(changed));
        let said = read.expect_err(changed);
        assert!(said.contains("answer 1 is impossible"), "{changed}: {said}");
    }
    // Numbers that JSON does not allow, or that are too large.
    let number = sound["credit"].to_string();
    for no_number in ["1e999", "NaN", "Infinity"] {
        let bytes = changed(
            &format!("\"credit\": {number}"),
            &format!("\"credit\": {no_number}"),
        );
        let (table, said) = gathered(&bytes);
        assert!(table.is_none() && said.contains("damaged"), "{said}");
    }
}

#[test]
fn answers_of_every_family_are_handed_in_and_read() {
    let rounds = Family::ALL
        .iter()
        .map(|family| format!("{}60-3", family.id()));
    let rounds = rounds.filter(|code| Code::parse(code).is_some());
    let others = [
        "7",
        "even60-3",
        "exam60-3",
        "copied-angle60-3",
        "find-out-3",
    ];
    let mut count = 0;
    for text in rounds.chain(others.map(Into::into)) {
        let code = Code::parse(&text).unwrap();
        let round = Round::of(code.clone());
        let mut attempts = Vec::new();
        for (number, question) in { 1.. }.zip(round.questions()) {
            let beliefs = question.beliefs.iter().map(|it| it.said);
            for said in beliefs.chain([question.form.truth()]) {
                let answer = Answer::new(said, Confidence::Guess);
                attempts.push(Attempt::of_quiz("Ada", &code, number, question, &answer));
            }
        }
        assert!(!attempts.is_empty(), "{text}");
        let hand_in = HandIn::new("Ada", "", attempts.clone());
        assert_eq!(hand_in.attempts, attempts, "{text}");
        let read = HandIn::read(hand_in.text().unwrap().as_bytes()).unwrap();
        assert_eq!(read.attempts, attempts, "{text}");
        count += attempts.len();
    }
    assert!(count > 2000, "{count}");
}

#[test]
fn an_answer_of_an_unknown_family_is_refused() {
    let text = hand_in(1, "Ada", 1, 1).text().unwrap();
    let family = text.split("\"family\": \"").nth(1).unwrap();
    let family = family.split('"').next().unwrap();
    let known = format!("\"family\": \"{family}\"");
    let (table, said) = gathered(&changed(&known, "\"family\": \"=1+1\""));
    assert!(
        table.is_none() && said.contains("answer 1 is impossible: its family is \"=1+1\""),
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
fn a_pipe_among_the_hand_ins_is_skipped() {
    let folder = Folder::new("gather-pipe");
    let pipe = folder.path().join("pipe.json");
    let made = Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    let text = hand_in(1, "Ada", 1, 1).text().unwrap();
    fs::write(folder.path().join("ada.json"), text).unwrap();
    let out = folder.path().join("class.csv");
    let place = folder.path().to_str().unwrap();
    let done = carrom(&["gather", place, "--out", out.to_str().unwrap()]);
    let said = stderr(&done);
    let notice = "pipe.json: left out; expected a file, found something else";
    assert!(done.status.success() && said.contains(notice), "{said}");
    assert!(fs::read_to_string(out).unwrap().contains("Ada"));
}

/// A pupil's answers to a form: the first `right` answers are right, and the others are those to
/// which the first misconception leads.
fn form(name: &str, code: &str, time_s: i64, answered: usize, right: usize) -> Vec<Attempt> {
    let round = Round::of(Code::parse(code).unwrap());
    let asked = (1..).zip(round.questions()).take(answered);
    let answer = |(number, question): (u32, &carrom::quiz::Question)| {
        let said = match number as usize <= right {
            true => question.form.truth(),
            false => question.beliefs[0].said,
        };
        let answer = Answer::new(said, Confidence::ThinkSo);
        Attempt {
            time_s: Some(time_s + i64::from(number)),
            ..Attempt::of_quiz(name, round.code(), number, question, &answer)
        }
    };
    asked.map(answer).collect()
}

/// The page about learning, and the table, of a class with `matched` matched pupils and two others.
fn learnt(matched: usize) -> (String, Vec<String>) {
    let folder = Folder::new("gather-learning");
    for index in 0..matched + 2 {
        let name = format!("Pupil {index:02}");
        let (before, after) = (2 + index % 3, 6 + index % 4);
        let answered = if index < matched { 10 } else { 9 };
        let time_s = 1_770_000_000 + 100_000 * index as i64;
        let mut answers = form(&name, "before-1", time_s, 10, before);
        answers.extend(form(&name, "after-1", time_s + 50_000, answered, after));
        let text = HandIn::new(&name, "10b", answers).text().unwrap();
        fs::write(folder.path().join(format!("{index}.json")), text).unwrap();
    }
    let from = folder.path().to_str().unwrap().to_owned();
    let out = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let done = carrom(&["gather", &from, "--out", &out("class.html")]);
    assert!(done.status.success(), "{}", stderr(&done));
    let page = Html::parse_document(&fs::read_to_string(out("class.html")).unwrap());
    let sheets = Selector::parse(".gradebook").unwrap();
    let text = { page.select(&sheets) }.map(|it| it.text().collect::<String>());
    let learnt = text
        .into_iter()
        .find(|it| it.contains("Did the class learn it?"));
    let done = carrom(&["gather", &from, "--out", &out("class.csv")]);
    assert!(done.status.success(), "{}", stderr(&done));
    let table = fs::read_to_string(out("class-learning.csv")).unwrap();
    (learnt.unwrap(), table.lines().map(str::to_owned).collect())
}

#[test]
fn the_gradebook_reports_the_gain_between_both_forms() {
    let (page, table) = learnt(12);
    assert!(
        page.contains("12 pupils answered all of them; 2 pupils answered only some"),
        "{page}"
    );
    // In turn, the pupils have 2, 3 or 4 right answers before the unit, and 6, 7, 8 or 9 after it:
    // 30 % and 75 % on average.
    assert!(
        page.contains("Normalized gain 0.64, 95 % confidence interval 0.5")
            && page.contains("from 12 pupils: 30 % right before, 75 % right after."),
        "{page}"
    );
    assert!(
        page.contains("By misconception") && page.contains("2 of 10"),
        "{page}"
    );
    assert_eq!(table.len(), 13);
    assert_eq!(table[1], "Pupil 00,10b,before-1,after-1,10,2,6");
}

#[test]
fn nothing_is_claimed_about_fewer_than_ten_pupils() {
    let (page, table) = learnt(7);
    assert!(
        page.contains("Too few pupils to state a gain: 7, but at least 10 are needed."),
        "{page}"
    );
    assert!(!page.contains("Normalized gain 0") && !page.contains("By misconception"));
    assert_eq!(table.len(), 8);
}
