//! Everything that is stored about a class can be deleted.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use carrom::class::{ClassChange, ClassRound, Vote};
use carrom::quiz::Code;

use crate::folder::Folder;
use crate::handed_in::hand_in;
use crate::pupil::Pupil;
use crate::teacher::Teacher;

const STUB: &str = "<html lang=\"en\">a page</html>";
/// Names that occur in no other text.
const NAMES: [&str; 3] = ["Zwetschga", "Quendolin", "Xaverius"];

fn carrom(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carrom"));
    command.arg("--data-dir").arg(folder).args(arguments);
    command.stdin(Stdio::null()).output().unwrap()
}

fn stdout(done: &Output) -> String {
    String::from_utf8_lossy(&done.stdout).into_owned()
}

/// The files in a folder and its subfolders, with their contents.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut all = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(within) = folders.pop() {
        for entry in fs::read_dir(within).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap();
                let name = name.display().to_string().replace('\\', "/");
                let bytes = fs::read(path).unwrap();
                all.push((name, bytes));
            }
        }
    }
    all.sort();
    all
}

/// The files whose name or content contains one of the names, in upper or lower case.
fn with_names(folder: &Path) -> Vec<String> {
    let all = files(folder).into_iter();
    let found = all.filter(|(file, bytes)| {
        let text = String::from_utf8_lossy(bytes).to_lowercase() + &file.to_lowercase();
        NAMES.iter().any(|name| text.contains(&name.to_lowercase()))
    });
    found.map(|(file, _)| file).collect()
}

/// A lesson of 10b: one pupil hands in answers, three pupils vote, the tables are written, and a
/// gradebook is gathered into the data folder.
fn lesson(folder: &Folder) {
    let teacher = Teacher::gathering(folder, STUB);
    let join = |name: &str| Pupil::join(teacher.port, &teacher.code, name, None).unwrap();
    let mut pupils = NAMES.map(join);
    let file = hand_in(1, NAMES[0], 10, 4).value().unwrap();
    let kept = pupils[0].hand_in(&file).unwrap();
    assert_eq!(kept, serde_json::json!({ "Ok": 10 }));
    teacher.press("<Enter><Enter>", "have voted");
    for pupil in &mut pupils {
        pupil
            .hear_until(|state| state["step"] == "first-vote")
            .unwrap();
        pupil.vote("sure rays 30 60").unwrap();
    }
    teacher.press("e", "class-report");
    drop(teacher);
    let path = folder.path();
    let handed_in = path.join("handed-in");
    for out in ["10b.html", "10b.csv"] {
        let out = path.join(out);
        let gather = [
            "gather",
            handed_in.to_str().unwrap(),
            "--out",
            out.to_str().unwrap(),
        ];
        assert!(carrom(path, &gather).status.success());
    }
    let round = fs::read(path.join("classes/class-1.toml")).unwrap();
    fs::write(path.join("classes/class-1.toml~"), &round).unwrap();
    fs::write(path.join("classes/.new-x1"), &round[..round.len() / 2]).unwrap();
    fs::write(path.join("exports/.new-x2"), "team\nQuendolin").unwrap();
    fs::create_dir(path.join("old")).unwrap();
    fs::write(path.join("old/copy.toml"), &round).unwrap();
}

/// A round of another class, with one pupil.
fn other_class(folder: &Folder) -> Vec<u8> {
    let code = Code::parse("mixed-7").unwrap();
    let mut round = ClassRound::with_devices(code).of_class("10c");
    let name = "Bo".to_owned();
    round
        .change(&ClassChange::Join { seat: None, name })
        .unwrap();
    let truth = round.questions()[0].form.truth();
    round.vote(0, 0, Vote::First, Some(truth));
    let text = round.text().unwrap();
    folder.file("classes/class-9.toml", &text);
    text.into_bytes()
}

#[test]
fn after_forgetting_a_class_no_byte_of_its_pupils_names_is_left() {
    let folder = Folder::new("forget");
    let path = folder.path();
    lesson(&folder);
    let other = other_class(&folder);
    folder.file("handed-in/hand-in-bo-1.json", {
        let mut file = hand_in(2, "Bo", 10, 4);
        file.class = "10c".into();
        file.text().unwrap()
    });
    let before = files(path);
    assert!(with_names(path).len() >= 9, "{:?}", with_names(path));

    // Without a terminal, nothing is deleted unless --yes is given.
    let refused = carrom(path, &["class", "--forget", "10b"]);
    assert_eq!(refused.status.code(), Some(2));
    let words = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        words.contains("--yes deletes") && words.contains("class-1.toml"),
        "{words}"
    );
    assert_eq!(files(path), before);

    let done = carrom(path, &["class", "--forget", "10B ", "--yes"]);
    assert!(done.status.success(), "{done:?}");
    let said = stdout(&done);
    for file in [
        "classes/class-1.toml",
        "classes/class-1.toml~",
        "classes/.new-x1",
        "exports/.new-x2",
        "exports/class-answers-1.csv",
        "exports/class-items-1.csv",
        "exports/class-report-1.html",
        "handed-in/hand-in-zwetschga-1.json",
        "10b.html",
        "10b.csv",
        "old/copy.toml",
    ] {
        assert!(
            said.lines().any(|it| it == format!("deleted {file}")),
            "{file}: {said}"
        );
    }
    assert_eq!(with_names(path), Vec::<String>::new());
    assert_eq!(fs::read(path.join("classes/class-9.toml")).unwrap(), other);
    assert!(path.join("handed-in/hand-in-bo-1.json").exists());

    let again = carrom(path, &["class", "--forget", "10b", "--yes"]);
    assert!(again.status.success());
    assert_eq!(stdout(&again), "nothing is kept about 10b\n");
}

#[test]
fn forgetting_requires_a_name_and_creates_nothing() {
    let folder = Folder::new("forget-nothing");
    let path = folder.path().join("data");
    let none = carrom(&path, &["class", "--forget", " ", "--yes"]);
    assert_eq!(none.status.code(), Some(2));
    let nothing = carrom(&path, &["class", "--forget", "10b"]);
    assert!(nothing.status.success());
    assert_eq!(stdout(&nothing), "nothing is kept about 10b\n");
    assert!(!path.exists());
}

#[test]
fn a_report_of_a_round_names_nobody_unless_asked() {
    let folder = Folder::new("class-report");
    let path = folder.path();
    lesson(&folder);
    let out = path.join("report.html");
    let out = out.to_str().unwrap();
    let report = ["class", "--report", "class-1", "--out", out];
    assert!(carrom(path, &report).status.success());
    let page = fs::read_to_string(out).unwrap();
    assert!(page.contains("A round with 10b") && page.contains("3 pupils on their own devices"));
    assert!(NAMES.iter().all(|name| !page.contains(name)), "{page}");
    // An existing file is replaced only with --force.
    let named = ["class", "--report", "10B", "--out", out, "--names"];
    assert_eq!(carrom(path, &named).status.code(), Some(1));
    let forced = [&named[..], &["--force"]].concat();
    assert!(carrom(path, &forced).status.success());
    let page = fs::read_to_string(out).unwrap();
    assert!(NAMES.iter().all(|name| page.contains(name)));
    let unknown = carrom(path, &["class", "--report", "10x", "--out", out]);
    assert_eq!(unknown.status.code(), Some(2));
    let words = String::from_utf8_lossy(&unknown.stderr).into_owned();
    assert!(words.contains("class-1 (10b)"), "{words}");
}
