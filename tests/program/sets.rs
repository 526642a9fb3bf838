//! Sets of questions, and lists to choose from.

use std::fs;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use carrom::class::ClassRound;
use carrom::cli;
use carrom::files::FileLibrary;
use carrom::paper::worksheet::Worksheet;
use carrom::quiz::concepts::Library;
use carrom::quiz::{Code, Question, Round};
use carrom::shells::Headless;
use carrom::store::Store;
use scraper::{Html, Selector};

use crate::folder::Folder;
use crate::keys;

const OWN: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/tests/own-concepts/our-marbles.toml"
);

const SET: &str = r#"format = 1
title = "Our / first & best"

[[question]]
code = "speeds-7"
number = 3
reason = "A number"

[[question]]
id = "our-marbles-head-on"

[[question]]
code = "from-angle-1"
number = 1

[[question]]
id = "ninety-survives-speed"

[[question]]
code = "make-it-so-2"
number = 1
"#;

fn carrom(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A folder with a set and with the teacher's own questions.
struct Teacher {
    folder: Folder,
    set: String,
    concepts: String,
}

impl Teacher {
    fn new(name: &str) -> Self {
        let folder = Folder::new(name);
        let concepts = folder.path().join("mine");
        fs::create_dir(&concepts).unwrap();
        fs::copy(OWN, concepts.join("our-marbles.toml")).unwrap();
        let set = folder.file("our-set.toml", SET.as_bytes());
        let concepts = concepts.to_str().unwrap().to_owned();
        Self {
            folder,
            set,
            concepts,
        }
    }

    fn own(&self) -> Library {
        Library::default().with(&[(&self.concepts).into()])
    }

    /// The round of the set, read directly.
    fn round(&self) -> Round {
        let mut own = self.own();
        own.add_set(self.set.as_ref()).unwrap();
        Round::of(Code::of_set(&own.sets[0]))
    }

    fn game(&self, screen: &str) -> Headless {
        let arguments = format!(
            "{screen} --set '{}' --concepts '{}'",
            self.set, self.concepts
        );
        let app = cli::open(&arguments).unwrap();
        let store = Store::in_folder(self.folder.path()).with_own(&app.context().own);
        Headless::keeping(app, 80, 24, store)
    }

    /// The name and the content of the only saved class round.
    fn class_file(&self) -> (String, Vec<u8>) {
        let mut files = fs::read_dir(self.folder.path().join("classes")).unwrap();
        let path = files.next().unwrap().unwrap().path();
        (path.display().to_string(), fs::read(path).unwrap())
    }
}

/// Begins a class round and enters a team's vote.
fn vote(game: &mut Headless, round: &Round) {
    let form = &round.questions()[0].form;
    let said = keys::said(form, &form.truth());
    game.press(&format!("<Enter><Enter><Enter>1{said}"));
}

/// Answers the question on the screen and goes on to the next one.
fn answer(game: &mut Headless, question: &Question) {
    let said = keys::said(&question.form, &question.form.truth());
    let top = |game: &mut Headless| {
        let screen = game.screen();
        let line = screen.lines().next().unwrap_or_default();
        let status = line.trim_start_matches(" carrom : quiz").trim_start();
        status.split("  ").next().map(str::to_owned)
    };
    let here = top(game);
    game.press(&format!("{said}2"));
    for _ in 0..4 {
        if game
            .app()
            .keys()
            .rows()
            .iter()
            .any(|row| row.id == "hit.end")
        {
            game.press("<End>");
        }
        assert!(game.settle(Duration::from_secs(120)));
        if top(game) != here {
            return;
        }
        game.press("<Enter>");
    }
    panic!("{}", game.screen());
}

fn texts(questions: &[Question]) -> Vec<&str> {
    questions.iter().map(|it| it.text.as_str()).collect()
}

#[test]
fn the_quiz_a_class_a_worksheet_and_moodle_ask_the_same_questions() {
    let teacher = Teacher::new("sets");
    let round = teacher.round();
    let asked = texts(round.questions());
    let built_in = |code: &str, number: usize| {
        let round = Round::of(Code::parse(code).unwrap());
        round.questions()[number - 1].text.clone()
    };
    assert_eq!(asked[0], built_in("speeds-7", 3));
    assert!(asked[1].starts_with("Two equal marbles meet"));
    assert_eq!(asked[2], built_in("from-angle-1", 1));
    assert!(asked[3].starts_with("Two equal, smooth coins collide"));
    assert_eq!(asked.len(), 5);

    let mut game = teacher.game("quiz");
    for question in round.questions() {
        answer(&mut game, question);
    }
    let attempts = game.attempts();
    assert_eq!(attempts.len(), 5);
    for (attempt, question) in attempts.iter().zip(round.questions()) {
        assert!(attempt.right, "{}", question.text);
        for (name, value) in &question.figures {
            assert_eq!(attempt.question.get(name), Some(value));
        }
        assert_eq!(attempt.question["round"], round.code().to_string());
    }

    let mut game = teacher.game("class --teams A,B");
    vote(&mut game, &teacher.round());
    let (name, bytes) = teacher.class_file();
    let mut own = teacher.own();
    own.add_set(teacher.set.as_ref()).unwrap();
    let saved = ClassRound::read(&name, &bytes, &own.into()).unwrap();
    assert_eq!(saved.questions(), round.questions());

    let sheets = teacher.folder.path().join("sheets");
    let moodle = teacher.folder.path().join("set.xml");
    let output = carrom(&[
        "worksheet",
        "--set",
        &teacher.set,
        "--concepts",
        &teacher.concepts,
        "--out",
        sheets.to_str().unwrap(),
        "--moodle",
        moodle.to_str().unwrap(),
    ]);
    assert!(output.status.success(), "{}", err(&output));
    let sheet = fs::read_to_string(sheets.join("worksheet.html")).unwrap();
    let page = Html::parse_document(&sheet);
    let read = |selector| {
        let selector = Selector::parse(selector).unwrap();
        let found = page.select(&selector);
        let texts = found.map(|it| it.text().collect::<String>().replace('\u{a0}', " "));
        texts.collect::<Vec<_>>()
    };
    assert_eq!(read(".question .said > p:first-child"), asked);
    assert_eq!(read("h1"), ["Our / first & best"]);
    let command = &read(".code code")[0];
    let words = shlex::split(command).unwrap();
    assert_eq!(words[..3], ["carrom", "quiz", "--set"]);
    assert_eq!(
        words[3..],
        [&*teacher.set, "--concepts", &*teacher.concepts]
    );
    let xml = fs::read_to_string(moodle).unwrap();
    assert!(xml.contains("$course$/top/Our // first &amp; best<"));
    let places = asked.iter().map(|text| {
        let mut words = text.split(' ').take(6).collect::<Vec<_>>().join(" ");
        words = words.replace('\'', "&#39;");
        xml.replace('\u{a0}', " ").find(&words)
    });
    let places: Option<Vec<_>> = places.collect();
    assert!(places.is_some_and(|it| it.is_sorted()));
}

#[test]
fn a_class_round_is_resumed_only_with_the_same_questions() {
    let teacher = Teacher::new("sets-class");
    let mut game = teacher.game("class --teams A,B");
    let code = teacher.round().code().to_string();
    assert!(game.screen().contains(&code), "{}", game.screen());
    vote(&mut game, &teacher.round());
    // Another title changes nothing.
    fs::write(&teacher.set, SET.replace("Our / first", "Another")).unwrap();
    let mut game = teacher.game("class");
    game.press("<End><Enter>");
    assert!(game.screen().contains("2 teams"), "{}", game.screen());
    game.press("<Enter>");
    assert!(game.screen().contains(&format!("code {code}")));
    // Once a question in the set has been changed, the round is refused.
    fs::write(&teacher.set, SET.replace("number = 3", "number = 4")).unwrap();
    let mut game = teacher.game("class");
    game.press("<End><Enter>");
    let screen = game.screen();
    assert!(screen.contains("cannot be read"), "{screen}");
    let (name, bytes) = teacher.class_file();
    let refused = ClassRound::read(&name, &bytes, &teacher.own().into()).unwrap_err();
    let message = refused.to_string();
    assert!(
        message.contains(&format!(
            "expected the set with the code {code}; --set gives its file"
        )),
        "{message}"
    );
}

#[test]
fn the_answers_of_a_set_can_be_handed_in_and_read_again() {
    let teacher = Teacher::new("sets-answers");
    let round = teacher.round();
    let mut game = teacher.game("quiz");
    for question in round.questions().iter().take(2) {
        answer(&mut game, question);
    }
    let data = teacher.folder.path().to_str().unwrap();
    let all = carrom(&["progress", "--json", "--data-dir", data]);
    assert!(
        out(&all).contains(&round.code().to_string()),
        "{}",
        err(&all)
    );
    let handed = teacher.folder.path().join("handed");
    fs::create_dir(&handed).unwrap();
    let file = handed.join("ada.json");
    let output = carrom(&[
        "hand-in",
        "--class",
        "10b",
        "--data-dir",
        data,
        "--out",
        file.to_str().unwrap(),
    ]);
    assert!(output.status.success(), "{}", err(&output));
    let table = teacher.folder.path().join("class.csv");
    let [handed, csv] = [&handed, &table].map(|it| it.to_str().unwrap());
    let output = carrom(&["gather", handed, "--out", csv]);
    assert!(output.status.success(), "{}", err(&output));
    assert_eq!(err(&output), "");
    let table = fs::read_to_string(table).unwrap();
    assert!(
        table.contains(&format!("{} answered", round.code())),
        "{table}"
    );
}

#[test]
fn another_version_keeps_the_kind_of_each_question() {
    let teacher = Teacher::new("sets-versions");
    let round = teacher.round();
    let other = round.version(2);
    assert_ne!(texts(round.questions())[0], texts(other.questions())[0]);
    // A question in words that was chosen by its id does not change.
    for at in [1, 3] {
        assert_eq!(round.questions()[at].text, other.questions()[at].text);
    }
    let xml = Worksheet::moodle_xml(&[Worksheet::new(&other, None)]);
    assert!(xml.contains("Our // first"));
}

#[test]
fn a_set_is_checked_question_by_question() {
    let teacher = Teacher::new("sets-check");
    let check = |more: &[&str]| carrom(&[&["set", "check", &teacher.set], more].concat());
    let good = check(&["--concepts", &teacher.concepts]);
    assert_eq!((good.status.code(), err(&good).as_str()), (Some(0), ""));
    let report = out(&good);
    for words in [
        "our-set.toml: good: Our / first & best",
        "    from speeds-7, question 3\n    reason: A number\n",
        "2. ideas in words: our marbles, easy, id our-marbles-head-on",
        "    Two equal marbles meet",
    ] {
        assert!(report.contains(words), "{words}: {report}");
    }
    let without = check(&[]);
    assert_eq!(without.status.code(), Some(2));
    let message = err(&without);
    assert!(
        message.contains(
            "our-set.toml:10: question.id: expected the id of a question in words, built in or in \
             a folder given with --concepts, found \"our-marbles-head-on\""
        ),
        "{message}"
    );
}

#[test]
fn each_error_in_a_set_is_reported_with_its_line() {
    let folder = Folder::new("sets-errors");
    let good = "code = \"speeds-7\"\nnumber = 3";
    for (questions, message) in [
        (
            "code = \"speeds-7\"",
            ":5: question.number: expected the number of a question of speeds-7, 1 to 6, found nothing",
        ),
        (
            "code = \"speeds-7\"\nnumber = 7",
            ":7: question.number: expected the number of a question of speeds-7, 1 to 6, found 7",
        ),
        (
            "code = \"speds-7\"\nnumber = 0",
            ":6: question.code: expected the code of a round",
        ),
        (
            "code = \"speds-7\"\nnumber = 0",
            ":7: question.number: expected a number from 1 to 60, found 0",
        ),
        (
            "code = \"own-7\"\nnumber = 1",
            ":6: question.code: expected the code of a built-in round (a question of your own has an id), found \"own-7\"",
        ),
        (
            "code = \"set-7\"\nnumber = 1",
            "expected the code of a built-in round",
        ),
        ("code = \"find-out-7\"\nnumber = 1", "the same for everyone"),
        ("code = \"review-7\"\nnumber = 1", "a review has no code"),
        (
            "id = \"no-such\"",
            ":6: question.id: expected the id of a question in words",
        ),
        (
            "id = \"ninety-head-on\"\nnumber = 1",
            ":5: question: expected a code and a number, or an id; found both",
        ),
        (
            "id = \"A B\"",
            ":6: question.id: expected 1 to 40 lower-case letters, digits and hyphens",
        ),
        (
            "numer = 3\ncode = \"speeds-7\"",
            ":6: question.numer: unknown field; expected one of code, number, id, reason; did you mean number?",
        ),
        (
            "code = \"speeds-7\"\nnumber = 3\nreason = \"\"",
            ":8: question.reason: expected text of 1 to 400 printable characters",
        ),
        (
            "code = \"speeds-7\"\nnumber = 3\n[[question]]\ncode = \"SPEEDS-7\"\nnumber = 3",
            ":8: question: expected different questions; this is question 1 again",
        ),
    ] {
        let text = format!("format = 1\ntitle = \"x\"\n\n# here\n[[question]]\n{questions}\n");
        let path = folder.file("bad.toml", text.as_bytes());
        let output = carrom(&["set", "check", &path]);
        assert_eq!(output.status.code(), Some(2), "{questions}");
        let said = err(&output);
        assert!(said.contains(message), "{message}: {said}");
        assert!(said.contains(&format!("{path}:")), "{said}");
        // The game and a worksheet refuse the set with the same message.
        let out = folder.path().join("out");
        for arguments in [
            vec!["worksheet", "--set", &path, "--out", out.to_str().unwrap()],
            vec!["quiz", "--plain", "--set", &path],
        ] {
            let output = carrom(&arguments);
            assert_eq!(output.status.code(), Some(2), "{arguments:?}");
            assert!(err(&output).contains(message), "{}", err(&output));
        }
    }
    let many = format!("[[question]]\n{good}\n").repeat(61);
    for (text, message) in [
        (
            String::new(),
            "expected a set of questions with `format = 1`, found nothing",
        ),
        ("format = 2\ntitle = \"x\"".into(), "2 is newer than 1"),
        (
            "format = 1\ntitle = \"x\"".into(),
            "expected 1 to 60 tables [[question]], found nothing",
        ),
        (
            format!("format = 1\n[[question]]\n{good}"),
            "title: expected text of 1 to 80",
        ),
        (
            format!("format = 1\ntitle = \"x\"\n{many}"),
            "expected 1 to 60 tables [[question]]",
        ),
        ("\u{1b}[2J".into(), ":1: "),
    ] {
        let path = folder.file("bad.toml", text.as_bytes());
        let output = carrom(&["set", "check", &path]);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(
            err(&output).contains(message),
            "{message}: {}",
            err(&output)
        );
    }
    let output = carrom(&["set", "check", "no-such-set.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("no-such-set.toml: cannot be read: "));
}

#[test]
fn the_questions_of_a_code_are_listed_without_their_answers() {
    let round = Round::of(Code::parse("concept3-7").unwrap());
    let list = out(&carrom(&["quiz", "--list", "concept3-7"]));
    let json = carrom(&["quiz", "--list", "concept3-7", "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["code"], "concept3-7");
    for (i, question) in round.questions().iter().enumerate() {
        let id = question.figures["id"].as_str().unwrap();
        let (topic, difficulty) = (&question.topic, question.difficulty.id());
        let head = format!(
            "{}. ideas in words: {topic}, {difficulty}, id {id}\n",
            i + 1
        );
        assert!(list.contains(&head), "{head}: {list}");
        assert!(list.contains(&question.text) && !list.contains(&question.why));
        let listed = &json["questions"][i];
        assert_eq!(listed["number"], i + 1);
        assert_eq!(listed["family"], "concept");
        assert_eq!(listed["id"], id);
        assert_eq!(listed["text"], *question.text);
        assert!(listed["choices"].as_array().unwrap().len() >= 3);
    }
    for (arguments, message) in [
        (
            vec!["quiz", "--list", "find-out-7"],
            "the same for everyone",
        ),
        (
            vec!["quiz", "--list", "own-7"],
            "--concepts gives their folder",
        ),
        (vec!["quiz", "--list", "set-7"], "--set gives its file"),
        (vec!["quiz", "--json"], "--list <CODE>"),
        (
            vec!["quiz", "--set", "x.toml", "--code", "7"],
            "cannot be used with",
        ),
        (
            vec!["quiz", "--set", "x.toml", "--seed", "7", "--plain"],
            "either --seed",
        ),
    ] {
        let output = carrom(&arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(err(&output).contains(message), "{}", err(&output));
    }
}
