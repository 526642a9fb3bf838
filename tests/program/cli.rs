//! The command line: its output and its exit status.

use std::fs;
use std::process::{Command, Output, Stdio};

use crate::folder::Folder;

/// Runs carrom without a terminal and with empty input.
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

/// The path for a file with this name in a folder.
fn within(folder: &Folder, name: &str) -> String {
    folder.path().join(name).to_str().unwrap().into()
}

/// The names of all entries of a folder.
fn names(folder: &Folder) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn the_glossary_is_printed_completely_or_by_term() {
    let all = out(&carrom(&["glossary", "--charset", "unicode"]));
    assert!(all.contains("impact angle, α, in °\n"), "{all}");
    // A whole term or symbol selects only its own entry; other words select all terms that contain
    // them.
    let json = out(&carrom(&["glossary", "θ₁", "--json"]));
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let entries = json["entries"].as_array().unwrap();
    assert_eq!(entries.len(), 1);
    assert_eq!(entries[0]["term"], "deflection angle");
    let frames = out(&carrom(&["glossary", "frame"]));
    assert_eq!(frames.matches("\n    chapter ").count(), 3, "{frames}");
    let refused = carrom(&["glossary", "phlogiston"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(err(&refused).contains("expected a term of the glossary"));
}

#[test]
fn progress_prints_the_games_of_a_player() {
    // A friendly board between two computers, won by South. The player sits in the winner's or in
    // the loser's seat, with a club hand. South pocketed three coins in one turn, North one.
    let text = include_str!("../saves/board-over-1.toml");
    for (seat, score, longest) in [("south", [2, 0], 3), ("north", [0, 2], 1)] {
        let folder = Folder::new("cli-games");
        let games = folder.path().join("games");
        fs::create_dir(&games).unwrap();
        let mut game = text.to_owned();
        for (from, to) in [
            ("format = 1", "format = 3\nhand = \"club\""),
            ("\"player\"", "\"Mia\""),
            (
                &format!("{seat} = \"computer\""),
                &format!("{seat} = \"person\""),
            ),
        ] {
            assert!(game.contains(from), "{from}");
            game = game.replacen(from, to, 1);
        }
        for name in ["game-1.toml", "game-2.toml"] {
            fs::write(games.join(name), &game).unwrap();
        }
        let data = folder.path().to_str().unwrap();
        let games = |player: &str| {
            let printed = carrom(&["--data-dir", data, "--player", player, "progress", "--json"]);
            let json: serde_json::Value = serde_json::from_str(&out(&printed)).unwrap();
            json["summary"]["games"].clone()
        };
        let expected = serde_json::json!({
            "results": [{
                "rules": "friendly",
                "strength": "club",
                "hand": "club",
                "boards_won_and_lost": score,
                "games_won_and_lost": score,
            }],
            "longest_turn": longest,
            "boards": [],
        });
        assert_eq!(games("Mia"), expected);
        let nothing = serde_json::json!({"results": [], "longest_turn": 0, "boards": []});
        assert_eq!(games("Bo"), nothing);
    }
}

#[test]
fn running_without_a_terminal_prints_a_message() {
    for arguments in [
        &[][..],
        &["learn"],
        &["quiz", "--seed", "7"],
        &["class"],
        &["table"],
        &["progress"],
    ] {
        let output = carrom(arguments);
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(out(&output), "");
        let message = err(&output);
        assert!(
            message.starts_with("carrom: a terminal is needed, but standard input is not one"),
            "{message}"
        );
        assert!(
            message.contains("; without a terminal, use --plain"),
            "{message}"
        );
        assert_eq!(message.lines().count(), 1);
    }
}

#[test]
fn commands_without_a_screen_refuse_plain_mode() {
    for arguments in [["keys", "--plain"], ["man", "--plain"]] {
        let output = carrom(&arguments);
        assert_eq!(output.status.code(), Some(2));
        assert!(err(&output).contains("--plain works only with a screen"));
    }
}

#[test]
fn help_and_version_exit_with_status_0() {
    let output = carrom(&["--help"]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(err(&output), "");
    for word in [
        "lab",
        "quiz",
        "levels",
        "tape",
        "--charset",
        "--data-dir",
        "Examples",
    ] {
        assert!(out(&output).contains(word), "{word}");
    }
    let output = carrom(&["--version"]);
    assert_eq!(
        out(&output),
        format!("carrom {}\n", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn unusable_arguments_are_refused() {
    for (arguments, message) in [
        (&["lob"][..], "unrecognized subcommand 'lob'"),
        (&["--colour", "16"], "unexpected argument '--colour'"),
        (
            &["--color", "17"],
            "invalid value '17' for '--color <DEPTH>'",
        ),
        (
            &["quiz", "--seed", "-1"],
            "invalid value '-1' for '--seed <N>'",
        ),
        (
            &["quiz", "--seed", "NaN"],
            "invalid value 'NaN' for '--seed <N>'",
        ),
        (
            &["quiz", "--code", "mixed"],
            "invalid value 'mixed' for '--code <CODE>': expected the code of a round",
        ),
        (
            &["quiz", "--code", "review-7"],
            "invalid value 'review-7' for '--code <CODE>'",
        ),
        (
            &["--player", "a\u{1b}[2J"],
            "expected a name of 1 to 40 visible characters",
        ),
        (
            &["--player", " "],
            "expected a name of 1 to 40 visible characters",
        ),
        (&["tape"], "<FILE>"),
        (&["completions", "csh"], "invalid value 'csh'"),
    ] {
        let output = carrom(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert_eq!(out(&output), "");
        assert!(
            err(&output).contains(message),
            "{arguments:?}: {}",
            err(&output)
        );
    }
}

#[test]
fn completions_and_the_manual_page_are_printed() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let output = carrom(&["completions", shell]);
        assert_eq!(output.status.code(), Some(0));
        assert!(out(&output).contains("carrom"));
    }
    let output = carrom(&["man"]);
    assert!(out(&output).contains(".TH carrom 1"));
}

#[test]
fn a_tape_writes_its_screenshots() {
    let folder = Folder::new("tape");
    let tape = folder.file(
        "home.tape",
        b"Screenshot home\nType \"?\"\nScreenshot help\n",
    );
    let target = within(&folder, "new/shots");
    let output = carrom(&["tape", &tape, "--out", &target, "--svg"]);
    assert_eq!(err(&output), "");
    assert_eq!(output.status.code(), Some(0));
    let written: Vec<_> = out(&output).lines().map(str::to_owned).collect();
    assert_eq!(written.len(), 4);
    let first: Vec<_> = written.iter().map(|path| fs::read(path).unwrap()).collect();
    assert!(String::from_utf8_lossy(&first[0]).contains("carrom : home"));
    assert!(first[1].starts_with(b"<svg "));
    carrom(&["tape", &tape, "--out", &target, "--svg"]);
    let again: Vec<_> = written.iter().map(|path| fs::read(path).unwrap()).collect();
    assert_eq!(first, again);
}

#[test]
fn options_of_the_command_apply_unless_the_tape_sets_them() {
    let folder = Folder::new("outer");
    let tape = folder.file("a.tape", b"Run \"--charset ascii\"\nType \"?\"\n");
    let output = carrom(&["tape", &tape, "--charset", "unicode", "--seed", "3"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
}

#[test]
fn a_tape_that_fails_writes_nothing() {
    let folder = Folder::new("fails");
    let tape = folder.file("bad.tape", b"Screenshot home\nExpect \"90.0\"\n");
    let output = carrom(&["tape", &tape, "--out", &within(&folder, "shots")]);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(out(&output), "");
    let message = err(&output);
    let start = format!("carrom: {tape}:2: Expect: the screen does not show \"90.0\"\n");
    assert!(message.starts_with(&start), "{message}");
    assert!(message.contains("carrom : home"), "{message}");
    assert_eq!(names(&folder), ["bad.tape"]);
}

#[test]
fn an_invalid_tape_is_reported_with_its_line() {
    let folder = Folder::new("unusable");
    let noise: Vec<u8> = (0..10 << 20)
        .map(|i: u32| (i.wrapping_mul(i) >> 7) as u8)
        .collect();
    for (content, message) in [
        (&b"Escape\nDance\n"[..], ":2: unknown instruction Dance"),
        (b"Run \"lob\"\n", ":1: Run: unrecognized subcommand 'lob'"),
        (
            b"Escape\nType \"\xff\"\n",
            ":2: expected UTF-8 text, found other bytes",
        ),
        (&noise, ":1: expected a file of at most 1 MiB, found more"),
    ] {
        let tape = folder.file("bad.tape", content);
        let output = carrom(&["tape", &tape, "--out", &within(&folder, "shots")]);
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(out(&output), "");
        let expected = format!("carrom: {tape}{message}");
        assert!(err(&output).starts_with(&expected), "{}", err(&output));
        assert_eq!(err(&output).lines().count(), 1);
        assert_eq!(names(&folder), ["bad.tape"]);
    }
    let missing = within(&folder, "missing.tape");
    let output = carrom(&["tape", &missing]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        err(&output).starts_with(&format!("carrom: {missing}: ")),
        "{}",
        err(&output)
    );
}

#[test]
fn a_folder_that_cannot_be_written_to_is_reported() {
    let folder = Folder::new("readonly");
    let tape = folder.file("a.tape", b"Screenshot home\n");
    let output = carrom(&["tape", &tape, "--out", &format!("{tape}/shots")]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        err(&output).starts_with(&format!("carrom: cannot write {tape}: expected a folder")),
        "{}",
        err(&output)
    );
}

/// A pinned exported game, which never changes.
const GAME: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/saves/format-1.toml");

#[test]
fn an_exported_game_is_replayed_bit_for_bit() {
    let text = carrom(&["replay", GAME]);
    assert!(text.status.success(), "{}", err(&text));
    assert!(out(&text).contains("   1  South strikes at "));
    let json = carrom(&["replay", GAME, "--json"]);
    let report: serde_json::Value = serde_json::from_str(&out(&json)).unwrap();
    let strokes = report["moves"].as_array().unwrap().iter();
    let strokes = strokes.filter(|made| made["kind"] == "strike");
    assert_eq!(strokes.count(), 30);
    let end = report["final"]["fingerprint"].as_str().unwrap();
    let game = fs::read_to_string(GAME).unwrap();
    assert!(game.contains(end));
    assert!(out(&text).contains(end));
    assert!(report.get("names").is_none());
    // If a person has a name, the output uses it instead of the seat.
    let names = "names = { south = \"Ada\", north = \"\" }\ncall = ";
    let named = game.replacen("call = ", names, 1);
    let folder = Folder::new("replay-names");
    let file = folder.file("game.toml", named.as_bytes());
    let text = out(&carrom(&["replay", &file]));
    assert!(text.contains("   1  Ada strikes at ") && text.contains("North strikes at "));
    let json = out(&carrom(&["replay", &file, "--json"]));
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(report["names"]["south"], "Ada");
}

#[test]
fn a_game_that_cannot_be_replayed_ends_with_status_2_and_the_line() {
    let folder = Folder::new("replay");
    let game = fs::read_to_string(GAME).unwrap();
    let other = game.replacen("[0.8135039368984194,", "[1.8135039368984194,", 1);
    for (content, expected) in [
        (other.as_str(), ":41: end: expected the moves to lead to "),
        ("format = 4", ":1: format: 4 is newer than 3, "),
        ("hello", ":1: "),
    ] {
        let file = folder.file("game.toml", content.as_bytes());
        let output = carrom(&["replay", &file]);
        assert_eq!(output.status.code(), Some(2));
        assert!(out(&output).is_empty());
        let message = err(&output);
        assert!(
            message.starts_with(&format!("carrom: {file}{expected}")),
            "{message}"
        );
    }
    let missing = carrom(&["replay", "/no/such/game.toml"]);
    assert_eq!(missing.status.code(), Some(2));
}

#[test]
fn a_tape_saves_its_games_only_with_a_data_folder() {
    let folder = Folder::new("tape-saves");
    let tape = folder.file(
        "game.tape",
        b"Run \"table --seed 3\"\nEnter\nSleep 2s\nSpace\nEnter\nType \"se\"\n",
    );
    let data = folder.path().join("data");
    let data = data.to_str().unwrap();
    assert!(
        carrom(&["tape", &tape, "--data-dir", data])
            .status
            .success()
    );
    let saved = fs::read_to_string(folder.path().join("data/games/game-1.toml")).unwrap();
    let exported =
        fs::read_to_string(folder.path().join("data/exports/carrom-game-1.toml")).unwrap();
    assert_eq!(saved, exported);
    // The same tape with another folder gives the same bytes.
    let again = folder.path().join("again");
    let again = again.to_str().unwrap();
    assert!(
        carrom(&["tape", &tape, "--data-dir", again])
            .status
            .success()
    );
    let twin = fs::read_to_string(folder.path().join("again/games/game-1.toml")).unwrap();
    assert_eq!(saved, twin);
}

/// A folder with a file of two valid questions, and a file with an unknown misconception.
const OWN_CONCEPTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/own-concepts");

#[test]
fn a_teachers_own_questions_are_checked() {
    let output = carrom(&["concept", "check", OWN_CONCEPTS]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(
        out(&output),
        "our-marbles-twice-as-heavy: good: our marbles, middle\n\
         our-marbles-head-on: good: our marbles, easy\n"
    );
    let message = err(&output);
    assert!(
        message.contains("wrong-belief.toml:12: item.wrong.misconception: expected the id of a misconception (carrom misconceptions prints all), found flat-earth"),
        "{message}"
    );
    let good = format!("{OWN_CONCEPTS}/our-marbles.toml");
    let output = carrom(&["concept", "check", &good]);
    assert_eq!((output.status.code(), err(&output).as_str()), (Some(0), ""));
    // The built-in questions are valid too.
    let output = carrom(&["concept", "check"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!(out(&output).lines().count(), 162);
}

#[test]
fn a_right_choice_that_gives_itself_away_is_reported_with_its_line() {
    let folder = Folder::new("cli-concepts");
    let path = within(&folder, "mine.toml");
    let good = fs::read_to_string(format!("{OWN_CONCEPTS}/our-marbles.toml")).unwrap();
    let long = "It stops, for it gives all of its momentum away, as equal masses do";
    fs::write(&path, good.replace("It stops", long)).unwrap();
    let output = carrom(&["concept", "check", &path]);
    assert_eq!(output.status.code(), Some(2));
    assert!(out(&output).contains("our-marbles-head-on: NOT GOOD: mine, easy"));
    let message = err(&output);
    let wanted = format!("{path}:21: our-marbles-head-on.right: expected a right choice about");
    assert!(message.contains(&wanted), "{message}");
    // The id of a built-in question cannot be used.
    fs::write(
        &path,
        good.replace("our-marbles-head-on", "sideways-balances"),
    )
    .unwrap();
    let message = err(&carrom(&["concept", "check", &path]));
    assert!(
        message.contains("mine.toml:21: ") && message.contains("expected a unique id"),
        "{message}"
    );
}

#[test]
fn the_code_of_a_teachers_own_questions_requires_their_folder() {
    let folder = Folder::new("cli-own");
    let to = within(&folder, "sheets");
    let output = carrom(&["worksheet", "--code", "own-7", "--out", &to]);
    assert_eq!(output.status.code(), Some(2));
    let message = err(&output);
    assert!(
        message.contains(
            "expected questions of your own for the code own-7; --concepts gives their folder"
        ),
        "{message}"
    );
    let output = carrom(&[
        "worksheet",
        "--code",
        "own-7",
        "--out",
        &to,
        "--concepts",
        OWN_CONCEPTS,
    ]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let sheet = fs::read_to_string(format!("{to}/worksheet.md")).unwrap();
    let sheet = sheet.replace('\u{a0}', " ");
    assert!(
        sheet.contains("own-7") && sheet.contains("A marble of 40 g"),
        "{sheet}"
    );
    let easy = sheet.find("Two equal marbles").unwrap();
    assert!(easy < sheet.find("A marble of 40 g").unwrap());
}

#[test]
fn a_board_is_printed_with_its_par_and_the_strokes_that_clear_it() {
    let by_code = carrom(&["board", "20261126", "--json"]);
    assert_eq!(by_code.status.code(), Some(0));
    let by_date = carrom(&["board", "--date", "2026-11-26", "--json"]);
    assert_eq!(out(&by_code), out(&by_date));
    let board: serde_json::Value = serde_json::from_str(&out(&by_code)).unwrap();
    assert_eq!(board["code"], "2026-11-26");
    assert_eq!(board["coins_mm"].as_array().unwrap().len(), 6);
    let solution = board["solution"].as_array().unwrap();
    assert_eq!(board["par"], solution.len());
    assert_eq!(solution.last().unwrap()["coins_left"], 0);
    for wrong in [
        &["board", "0"][..],
        &["board", "2026-02-30"],
        &["board", "--date", "7"],
    ] {
        let output = carrom(wrong);
        assert_eq!(output.status.code(), Some(2), "{wrong:?}");
        assert!(err(&output).contains("expected"), "{}", err(&output));
    }
}
