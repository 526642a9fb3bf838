//! No input can control the terminal, and input that cannot be used is reported.

use std::fs;
use std::process::{Command, Output, Stdio};

use carrom::messages::{PlayerAction, StoreCall, StoreReply, StoreRequest};
use carrom::store::Store;

use crate::folder::Folder;
use crate::handed_in::hand_in;

fn carrom(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(arguments)
        .env_remove("LC_ALL")
        .env("LANG", "C")
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

fn said(output: &Output) -> String {
    let all = [&output.stdout[..], &output.stderr[..]].concat();
    String::from_utf8(all).unwrap()
}

const CHAPTER: &str = "+++\nformat = 1\ntitle = \"T\"\nabout = \"A\"\n+++\n# P\n\nText.\n";

#[test]
fn no_escape_sequence_reaches_the_terminal() {
    let folder = Folder::new("safe");
    let red = "\u{1b}[31mred\u{7}\u{202e}";
    let chapter = folder.file("01-a.md", CHAPTER.replace("\"T\"", "\"\\u001b[31mT\""));
    let pack = folder.path().join(red);
    fs::create_dir(&pack).unwrap();
    let level = concat!(env!("CARGO_MANIFEST_DIR"), "/levels");
    let any = fs::read_dir(level).unwrap().flatten();
    let packs = any.map(|it| it.path()).filter(|it| it.is_dir());
    let first = packs.flat_map(|it| fs::read_dir(it).unwrap().flatten());
    let first = first.map(|it| it.path()).next().unwrap();
    fs::copy(first, pack.join("a.toml")).unwrap();
    for arguments in [
        &["lesson", "check", &chapter][..],
        &["level", "check", pack.to_str().unwrap()],
        &["figure", red],
        &["figure", "lab", red],
        &["figure", "lab", &format!("alpha_deg={red}")],
        &[red],
        &["quiz", "--code", red],
        &["--player", "", "--palette", red],
        &["levels", red],
        &["simulate", red],
        &["tape", red],
        &[
            "progress",
            "--csv",
            "--data-dir",
            &format!("/dev/null/{red}"),
        ],
    ] {
        let output = carrom(arguments);
        let said = said(&output);
        let tricks = |c: char| c.is_control() && c != '\n' || c == '\u{202e}';
        assert!(!said.contains(tricks), "{arguments:?}: {said:?}");
        assert!(!said.is_empty(), "{arguments:?}");
    }
}

/// Anyone can change the contents of a database, so these must not control a terminal or a
/// spreadsheet either.
#[test]
fn printed_answers_cannot_control_a_terminal_or_a_spreadsheet() {
    let folder = Folder::new("safe-answers");
    let mut store = Store::in_folder(folder.path());
    let hostile = "=cmd|'/c calc'!A1\u{1b}[2J\u{0}\u{9b}31m\u{202e}\u{2066}";
    let mut attempt = hand_in(1, "Ada", 1, 1).attempts.remove(0);
    let figures = serde_json::json!({"round": hostile, hostile: hostile});
    attempt.player = hostile.into();
    attempt.topic = hostile.into();
    attempt.family = hostile.into();
    attempt.misconception = Some(hostile.into());
    attempt.question = figures.as_object().unwrap().clone();
    let choice = serde_json::json!({ "choice": hostile });
    let choice = choice.as_object().unwrap().clone();
    (attempt.answer, attempt.truth) = (choice.clone(), choice);
    let call = StoreCall {
        ticket: 0,
        request: StoreRequest::Note(PlayerAction::Record(Box::new(attempt))),
    };
    assert_eq!(store.answer(&call).done, StoreReply::Noted(Ok(())));
    let data = folder.path().to_str().unwrap();
    for format in ["--csv", "--json"] {
        let output = carrom(&["progress", format, "--everyone", "--data-dir", data]);
        assert!(output.status.success(), "{}", said(&output));
        let text = String::from_utf8(output.stdout).unwrap();
        let orders = |c: char| {
            c.is_control() && c != '\n'
                || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
        };
        assert!(!text.contains(orders), "{text:?}");
        if format == "--json" {
            let read: serde_json::Value = serde_json::from_str(&text).unwrap();
            assert_eq!(read["attempts"][0]["player"], hostile);
            continue;
        }
        let mut table = csv::Reader::from_reader(text.as_bytes());
        let row = table.records().next().unwrap().unwrap();
        let cells: Vec<&str> = row.iter().collect();
        assert!(cells.iter().filter(|cell| cell.contains("calc")).count() >= 5);
        for cell in cells {
            assert!(!cell.trim_start().starts_with(['=', '@', '+']), "{cell:?}");
        }
    }
}

/// A line of a file may be a megabyte of random text, so a message must not quote all of it.
#[test]
fn no_message_quotes_more_than_200_characters_of_a_line() {
    let folder = Folder::new("safe-quotes");
    let in_folder = |name: &str, file: &str, text: &str| {
        let place = folder.path().join(name);
        fs::create_dir_all(&place).unwrap();
        fs::write(place.join(file), text).unwrap();
        place.to_str().unwrap().to_owned()
    };
    let long = "Q".repeat(10_000);
    let filled = |template: &str| template.replace("{}", &long);
    let longest = |said: &str| {
        let runs = said.split(|c| c != 'Q').map(str::len);
        runs.max().unwrap_or_default()
    };
    let check = |arguments: &[&str]| {
        let output = carrom(arguments);
        let said = said(&output);
        let shown: Vec<String> = { arguments.iter() }
            .map(|it| it.chars().take(40).collect())
            .collect();
        assert!(!output.status.success() && !said.is_empty(), "{shown:?}");
        assert!(longest(&said) <= 200, "{shown:?}: {said:.400}");
    };
    let data = |name: &str, file: &str, text: &str| in_folder(name, file, &filled(text));
    for (number, text) in [
        "{}",
        "format = {}",
        "format = \"{}\"",
        "format = 1\n{} = 1",
        "format = 1\n[board]\nside_mm = \"{}\"",
        "format = 1\n[[{}]]\na = 1",
        "format = 1\n[[disc]]\nkind = \"{}\"\nat_mm = [0, 0]",
        "format = 1\n[level]\nid = \"{}\"",
        "format = 1\n[[item]]\nid = \"a\"\nask = \"{ {} }\"",
    ]
    .into_iter()
    .enumerate()
    {
        let place = data(&format!("toml-{number}"), "a.toml", text);
        let file = format!("{place}/a.toml");
        check(&["simulate", &file]);
        check(&["replay", &file]);
        check(&["level", "check", &file]);
        check(&["concept", "check", &place]);
    }
    for (number, text) in [
        "{}",
        "Set {}",
        "Set Size {}",
        "Set {} 1",
        "Type {}",
        "Screenshot {}",
        "Screenshot a b {} c",
        "Click {}",
        "Right {}",
        "Sleep {}",
        "At {}",
        "Lose \"{}\"",
        "Expect \"{}\"",
        "\"{}\"",
        "Run \"{}\"",
        "Run \"quiz --code {}\"",
        "Run \"quiz --{}\"",
    ]
    .into_iter()
    .enumerate()
    {
        let place = data(&format!("tape-{number}"), "a.tape", text);
        check(&["tape", &format!("{place}/a.tape"), "--out", &place]);
    }
    for (number, text) in [
        "{}",
        "+++\n{}\n+++\n",
        "+++\nformat = 1\ntitle = \"{}\"\nabout = \"a\"\n+++\n# P\n\nText.\n",
        "+++\nformat = 1\ntitle = \"T\"\nabout = \"A\"\n+++\n# {}\n\n:::{}\n",
        "+++\nformat = 1\ntitle = \"T\"\nabout = \"A\"\n+++\n# P\n\n{{}} ${}$\n",
        "+++\nformat = 1\ntitle = \"T\"\nabout = \"A\"\n+++\n# P\n\n:::figure lab {}=1\n:::\n",
    ]
    .into_iter()
    .enumerate()
    {
        check(&[
            "lesson",
            "check",
            &data(&format!("lesson-{number}"), "01-a.md", text),
        ]);
    }
    for (number, text) in [
        "{}",
        "{\"{}\": 1}",
        "{\"carrom\": \"hand-in\", \"format\": 1, \"name\": \"a\", \"answers\": \"{}\"}",
        "{\"carrom\": \"hand-in\", \"format\": 1, \"name\": \"a\", \"answers\": [{\"seed\": \"{}\"}]}",
    ]
    .into_iter()
    .enumerate()
    {
        let place = data(&format!("hand-in-{number}"), "a.json", text);
        check(&["gather", &place, "--out", &format!("{place}/a.csv")]);
    }
    for arguments in [
        &["quiz", "--code", &long][..],
        &["learn", "--plain", &long],
        &["figure", &long],
        &["figure", "lab", &format!("{long}=1")],
        &["guide", &long],
        &[&long],
    ] {
        check(arguments);
    }
}

#[test]
fn a_byte_order_mark_is_skipped() {
    let folder = Folder::new("safe-mark");
    let mark = "\u{feff}";
    let chapter = folder.file("01-a.md", format!("{mark}{CHAPTER}"));
    let tape = folder.file("a.tape", format!("{mark}Expect \"carrom\"\n"));
    let scene = "format = 1\n[[disc]]\nkind = \"striker\"\nat_mm = [0, 0]\n\
                 [shot]\ndisc = 0\ndirection_deg = 90\nspeed = 1\n";
    let scene = folder.file("a.toml", format!("{mark}{scene}"));
    for arguments in [
        ["lesson", "check", &chapter].as_slice(),
        &["tape", &tape],
        &["simulate", &scene],
    ] {
        let output = carrom(arguments);
        assert!(output.status.success(), "{}", said(&output));
    }
}

#[test]
fn only_names_with_visible_characters_are_accepted() {
    let folder = Folder::new("safe-name");
    let data = folder.path().to_str().unwrap();
    for (name, good) in [
        ("\u{200b}", false),
        ("\u{fffe}", false),
        ("\u{202e}\u{301}", false),
        (" ", false),
        ("Zo\u{eb}", true),
        ("a\u{202e}b", false),
    ] {
        let output = carrom(&["progress", "--csv", "--data-dir", data, "--player", name]);
        assert_eq!(output.status.success(), good, "{name:?}");
        if !good {
            let said = said(&output);
            assert!(said.contains("1 to 40 visible characters"), "{said}");
        }
    }
}

#[test]
fn the_printed_screen_is_what_the_terminal_shows() {
    for arguments in [
        &["level", "check"][..],
        &["level", "check", "--charset", "ascii"],
        &["lesson", "check"],
        &["concept", "check"],
    ] {
        let output = carrom(arguments);
        assert!(output.status.success());
        assert!(output.stdout.is_ascii(), "{}", said(&output));
    }
    let output = carrom(&["level", "check", "--charset", "unicode"]);
    assert!(said(&output).contains('°'));
}

#[test]
fn messages_name_the_expected_input() {
    for (arguments, expected) in [
        (&["quiz", "--code", "mixed61-7"][..], "1 to 60 questions"),
        (&["quiz", "--code", "review-7"], "a review has no code"),
        (
            &["quiz", "--code", "hits12-7"],
            "expected the code of ten hits without a number of questions",
        ),
        (
            &["quiz", "--code", "7", "--seed", "5"],
            "use either --seed or --code, not both",
        ),
        (
            &["class", "--code", "7", "--seed", "5"],
            "use either --seed or --code, not both",
        ),
        (
            &["quiz", "--seed", "-1"],
            "expected a whole number from 0 to 18446744073709551615",
        ),
        (
            &["figure", "lab", "="],
            "expected a field such as alpha_deg=45, found =",
        ),
        (
            &["figure", "lab", "marbles"],
            "expected fields such as alpha_deg=45",
        ),
        (
            &["figure", "lab", "offset_mm=5", "alpha_deg=3"],
            "expected alpha_deg or offset_mm, found both",
        ),
    ] {
        let output = carrom(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let said = said(&output);
        assert!(said.contains(expected), "{said}");
    }
}

/// Anything in a folder of chapters that is named like a chapter but is not a file is reported, not
/// ignored.
#[cfg(unix)]
#[test]
fn a_message_names_a_path_that_is_not_a_file() {
    let folder = Folder::new("safe-odd");
    folder.file("01-a.md", CHAPTER);
    let link = |to: &str, name: &str| {
        std::os::unix::fs::symlink(to, folder.path().join(name)).unwrap();
    };
    link("nowhere", "02-b.md");
    link("/dev/null", "03-c.md");
    fs::create_dir(folder.path().join("04-d.md")).unwrap();
    let output = carrom(&["lesson", "check", folder.path().to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    let said = said(&output);
    for part in [
        "a: good",
        "02-b.md: expected a file, found a broken link",
        "03-c.md: expected a file",
        "04-d.md: expected a file, found a folder",
    ] {
        assert!(said.contains(part), "{said}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported_as_such() {
    let full = fs::File::options().write(true).open("/dev/full").unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(["solve", "--alpha-deg", "30"])
        .stdout(full)
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
        .wait_with_output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(
        said.starts_with("carrom: cannot write to standard output"),
        "{said}"
    );
}
