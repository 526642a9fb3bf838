//! Plain mode: the program used line by line, as with a screen reader or from a script.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use carrom::quiz::{Answer, Code, Confidence, Form, Misconception, Question, Response, Round};

use crate::folder::Folder;
use crate::thorough::cases;

/// The program's output for these input lines.
fn talk(arguments: &str, folder: &Path, heard: &[u8]) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(arguments.split(' '))
        .arg("--data-dir")
        .arg(folder)
        .env("TERM", "dumb")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let heard = heard.to_owned();
    // A program that quits early does not read the rest.
    let writer = std::thread::spawn(move || drop(input.write_all(&heard)));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    let complaints = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{complaints}");
    assert_eq!(complaints, "");
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(
        said.chars().all(|c| c == '\n' || !c.is_control()),
        "{said:?}"
    );
    assert!(
        said.lines()
            .all(|line| line.trim() == line && !line.is_empty()),
        "{said}"
    );
    said
}

/// The lines with this answer, as a player would type them.
fn typed(question: &Question, said: &Response) -> String {
    match (&question.form, said) {
        (Form::Rays { side, .. }, Response::Rays(rays)) => [rays.striker, rays.target]
            .map(|angle| match angle {
                Some(angle) => format!("{:.1}\n", side * angle.to_degrees()),
                None => "still\n".into(),
            })
            .concat(),
        (Form::Number { .. }, Response::Number(x)) => format!("{x}\n"),
        (_, Response::Choice(i)) => format!("{}\n", carrom::quiz::letter(*i)),
        (_, Response::Shot(offset)) => format!("{}\n", 1000.0 * offset),
        other => panic!("no answer of this form: {other:?}"),
    }
}

fn answers(round: &Round, said: impl Fn(&Question) -> Response) -> String {
    let each = round.questions().iter();
    each.map(|question| format!("{}3\n", typed(question, &said(question))))
        .collect()
}

/// All answers stored in this folder.
fn attempts(folder: &Folder) -> Vec<serde_json::Value> {
    let kept = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(["progress", "--json", "--data-dir"])
        .arg(folder.path())
        .output()
        .unwrap();
    let kept: serde_json::Value = serde_json::from_slice(&kept.stdout).unwrap();
    kept["attempts"].as_array().unwrap().clone()
}

fn round(code: &str) -> Round {
    Round::of(Code::parse(code).unwrap())
}

#[test]
fn right_answers_in_plain_lines_are_graded_as_right() {
    let folder = Folder::new("plain");
    for code in ["7", "mixed-7", "mixed-8"] {
        let round = round(code);
        let lines = answers(&round, |question| question.form.truth());
        let said = talk(
            &format!("quiz --plain --code {code}"),
            folder.path(),
            lines.as_bytes(),
        );
        assert_eq!(
            said.matches("\nright\n").count(),
            round.questions().len(),
            "{said}"
        );
        assert!(said.contains("10 of 10 right"), "{said}");
        assert!(said.contains(" for a friend: "), "{said}");
    }
}

#[test]
fn each_misconception_is_named() {
    let folder = Folder::new("plain");
    let round = round("mixed-7");
    let lines = answers(&round, |question| question.beliefs[0].said);
    let said = talk(
        "quiz --plain --code mixed-7",
        folder.path(),
        lines.as_bytes(),
    );
    for question in round.questions() {
        let name = carrom::shells::plain::spoken(question.beliefs[0].misconception.name());
        assert!(said.contains(&format!("\n{name}\n")), "{name}\n{said}");
    }
    assert!(said.contains("0 of 10 right"), "{said}");
}

#[test]
fn every_answer_is_saved_before_its_explanation_is_shown() {
    let folder = Folder::new("plain");
    let round = round("7");
    let first = &round.questions()[0];
    for end in ["quit\n", "", "nonsense\n", "\u{0}\u{1b}[2J\n"] {
        let lines = format!("{}2\n{end}", typed(first, &first.form.truth()));
        talk("quiz --plain --seed 7", folder.path(), lines.as_bytes());
    }
    let attempts = attempts(&folder);
    assert_eq!(attempts.len(), 4);
    for attempt in attempts {
        assert_eq!(attempt["right"], true);
        assert_eq!(attempt["confidence"], "think-so");
    }
}

#[test]
fn plain_mode_asks_again_politely_after_an_unclear_line() {
    let folder = Folder::new("plain");
    let said = talk(
        "quiz --plain --seed 7",
        folder.path(),
        b"sixty\n999\n\nhelp\nrepeat\nskip\n",
    );
    let again = "Please type an angle from minus 180 to 180, or still.\n";
    assert_eq!(said.matches(again).count(), 3, "{said}");
    assert!(said.contains("At any time: repeat"), "{said}");
    assert_eq!(
        said.matches("11.3 millimetres to the left").count(),
        2,
        "{said}"
    );
}

#[test]
fn random_input_neither_crashes_plain_mode_nor_floods_its_output() {
    let folder = Folder::new("plain");
    let length = cases(1_000_000, 10_000_000);
    let one_line: Vec<u8> = (0..length as u64).map(|i| (i * i % 251) as u8).collect();
    // About 200 lines that together contain every byte.
    let scattered = |i: u64| i.wrapping_mul(0x9e37_79b9_7f4a_7c15).to_be_bytes()[1];
    let lines: Vec<u8> = (0..50_000).map(scattered).collect();
    assert!(lines.iter().filter(|byte| **byte == b'\n').count() > 150);
    for arguments in [
        "quiz --plain",
        "quiz --plain --seed 1",
        "learn --plain",
        "table --plain",
        "solve --plain",
    ] {
        talk(arguments, folder.path(), &one_line);
        talk(arguments, folder.path(), &lines);
        talk(arguments, folder.path(), &vec![b'x'; length]);
    }
}

#[test]
fn an_exam_gives_no_feedback_before_its_end() {
    let folder = Folder::new("plain");
    let round = round("exam-3");
    let lines = answers(&round, |question| question.form.truth());
    let said = talk(
        "quiz --plain --code exam-3",
        folder.path(),
        lines.as_bytes(),
    );
    let (during, after) = said.split_once("Your round.").unwrap();
    assert!(
        !during.contains("\nright\n") && !during.contains("truth"),
        "{during}"
    );
    assert!(after.contains("15 of 15 right"), "{after}");
}

#[test]
fn a_round_is_chosen_by_its_number_or_its_code() {
    let folder = Folder::new("plain");
    let said = talk("quiz --plain", folder.path(), b"99\nmixes\n5\nquit\n");
    assert_eq!(
        said.matches("Please type a label from 1").count(),
        2,
        "{said}"
    );
    assert!(said.contains("Question 1 of 10, "), "{said}");
    assert!(said.contains("Where will they go?\n"), "{said}");
    let said = talk("quiz --plain", folder.path(), b"code\nspeeds4-7\nquit\n");
    assert!(said.contains("Question 1 of 4, "), "{said}");
    assert!(said.contains("Speeds after collisions."), "{said}");
}

/// A player who copies the given angle sees the name of this misconception, and then starts the
/// check for it.
#[test]
fn a_misconception_is_found_in_plain_lines() {
    let folder = Folder::new("plain");
    let copied = |question: &Question| {
        let mut held = question.beliefs.iter();
        let held = held.find(|it| it.misconception == Misconception::CopiedAngle);
        held.map_or(question.form.truth(), |it| it.said)
    };
    let mut found = round("find-out-7");
    let (mut answers, mut lines) = (Vec::new(), String::new());
    while let Some(question) = found.questions().get(answers.len()) {
        let said = copied(question);
        if answers.is_empty() {
            // The question must be answered, because the next question depends on the answer.
            lines += "skip\n";
        }
        lines += &format!("{}2\n", typed(question, &said));
        answers.push(Answer::new(said, Confidence::ThinkSo));
        found.go_on(&answers);
    }
    lines += "maybe\ncheck with two\nquit\n";
    let said = talk(
        "quiz --plain --code find-out-7",
        folder.path(),
        lines.as_bytes(),
    );
    insta::assert_snapshot!("plain_find_out_7", said);
}

#[test]
fn the_text_of_a_whole_round_is_unchanged() {
    let folder = Folder::new("plain");
    let round = round("quick-7");
    let lines: String = (0..)
        .zip(round.questions())
        .map(|(i, question)| {
            let said = match i % 2 {
                0 => question.form.truth(),
                _ => question.beliefs[0].said,
            };
            format!("{}{}\n", typed(question, &said), 1 + i % 3)
        })
        .collect();
    let said = talk(
        "quiz --plain --code quick-7",
        folder.path(),
        lines.as_bytes(),
    );
    insta::assert_snapshot!("plain_quick_7", said);
}

#[test]
fn the_position_in_a_chapter_is_saved() {
    let folder = Folder::new("plain");
    let said = talk(
        "learn 2 --plain",
        folder.path(),
        b"skip\nnext\nskip\nquit\n",
    );
    assert!(said.contains("Page 4 of 5"), "{said}");
    let said = talk("learn 2 --plain", folder.path(), b"quit\n");
    assert!(
        said.contains("Page 4 of 5") && !said.contains("Page 1 of"),
        "{said}"
    );
}

#[test]
fn the_answer_to_a_checkpoint_is_saved() {
    let folder = Folder::new("plain");
    let said = talk("learn 1 --plain", folder.path(), b"2\nquit\n");
    assert!(
        said.contains("truth: 2.00 metres per second\nRight."),
        "{said}"
    );
    let folder = Folder::new("plain-again");
    let said = talk("learn 1 --plain", folder.path(), b"1\n1\nquit\n");
    assert!(
        said.contains("you said: 1.00 metres per second\ntruth: 2.00 metres per second"),
        "{said}"
    );
    let said = talk("learn --plain", folder.path(), b"quit\n");
    assert!(said.contains("pages seen: 1 of 8"), "{said}");
}

#[test]
fn a_solution_is_printed_from_arguments_or_after_questions() {
    let folder = Folder::new("plain");
    let given = talk(
        "solve --plain --m1-g 20 --m2-g 40 --speed 3 --alpha-deg 45",
        folder.path(),
        b"",
    );
    assert!(given.contains("2.236 metres per second"), "{given}");
    assert!(given.contains("63.43 degrees"), "{given}");
    let asked = talk("solve --plain", folder.path(), b"20\n40\n3\n45\n\n");
    assert!(
        asked.contains("Mass of the striker in grams? Proposed: 15."),
        "{asked}"
    );
    // The quantities that are not among the arguments are reported as assumed.
    let (before, rest) = given.split_once(" Assumed: ").unwrap();
    let (assumed, after) = rest.split_once('\n').unwrap();
    assert_eq!(
        assumed,
        "target at rest; elastic, restitution 1; smooth rims."
    );
    assert!(asked.ends_with(&format!("{before}\n{after}")), "{asked}");
}

#[test]
fn an_invalid_number_is_asked_for_again_and_not_stored() {
    let folder = Folder::new("plain");
    let strange = "1/2\n1e999\n1e-400\n1 000\n1,000\n2*3\n0x1\n1_0\n++1\n5 cm\n";
    let heard = format!("{strange}quit\n");
    let said = talk("learn 1 --plain", folder.path(), heard.as_bytes());
    let again = "\nPlease type a number";
    assert_eq!(said.matches(again).count(), 10, "{said}");
    assert!(!said.contains("Not yet."), "{said}");
    assert_eq!(attempts(&folder).len(), 0);
    let said = talk("solve --plain", folder.path(), b"1e999\n1e1\n");
    assert!(
        said.contains(again) && said.contains("Mass of the target"),
        "{said}"
    );
    let said = talk("learn 1 --plain", folder.path(), b"2,0 m/s\nquit\n");
    assert!(said.contains("\nRight.\n"), "{said}");
}

#[test]
fn file_names_are_read_unchanged() {
    let folder = Folder::new("plain");
    let lessons = folder.path().join("a_2*x-1=b");
    std::fs::create_dir_all(&lessons).unwrap();
    let file = lessons.join("01-bad.md");
    std::fs::write(&file, "---\n").unwrap();
    let arguments = format!("learn --plain --lessons {}", lessons.display());
    let said = talk(&arguments, folder.path(), b"quit\n");
    assert!(said.contains("left out:"), "{said}");
    assert!(said.contains(&file.display().to_string()), "{said}");
}

#[test]
fn a_chapter_does_not_reveal_later_answers() {
    let folder = Folder::new("plain");
    let said = talk(
        "learn 2 --plain",
        folder.path(),
        b"b\nnext\nnext\n2\nnext\nquit\n",
    );
    assert!(said.contains("Page 4 of 5.\n"), "{said}");
    assert!(said.contains("What can change.\n"), "{said}");
    assert!(
        !said.contains("leaves at") && !said.contains(" 60"),
        "{said}"
    );
    assert_eq!(said.matches("Figure: a disc").count(), 1, "{said}");
    assert!(said.contains("Where can they push?\n"), "{said}");
}

#[test]
fn the_players_own_shot_is_set_up_predicted_and_played() {
    let folder = Folder::new("plain");
    let heard =
        b"set angle 30\nset coin 15\nset wind 3\nshoot\n60\n30\nset up\nset offset 0\nquit\n";
    let said = talk("lab --plain", folder.path(), heard);
    assert!(
        said.contains("Please name one of these: offset b, impact angle"),
        "{said}"
    );
    assert!(
        said.contains("striker, degrees: you said 60.0, truth 60.0"),
        "{said}"
    );
    assert!(said.contains("offset b: 0.0 millimetres"), "{said}");
}

/// A result whose terms cancel is shown as 0, without the rounding error in its last digit.
#[test]
fn the_right_answer_is_shown_without_rounding_errors() {
    let folder = Folder::new("plain");
    let heard = b"skip\nskip\n1\n1\nquit\n";
    let said = talk("learn 5 --plain", folder.path(), heard);
    assert!(
        said.contains("truth: 0 metres per second\n") || said.contains("truth: 0.00 metres"),
        "{said}"
    );
}

/// No instruction requires a mouse or sight.
#[test]
fn all_chapters_can_be_read_in_words_alone() {
    let folder = Folder::new("plain");
    for chapter in 1..=12 {
        let heard = "skip\n\n".repeat(30) + "quit\n";
        let said = talk(
            &format!("learn {chapter} --plain"),
            folder.path(),
            heard.as_bytes(),
        );
        let is_last = |line: &str| {
            let page = line
                .strip_prefix("Page ")
                .and_then(|it| it.strip_suffix('.'));
            page.and_then(|it| it.split_once(" of "))
                .is_some_and(|(at, all)| at == all)
        };
        assert!(said.lines().any(is_last), "{said}");
        for strange in ["NaN", "inf ", "{", "}", "$", "  "] {
            assert!(!said.contains(strange), "{strange:?}: {said}");
        }
        for line in said.lines() {
            let by_hand = [
                "Drag ",
                "Press ",
                "Click ",
                "press ",
                "look at the",
                "Look ",
            ];
            assert!(!by_hand.iter().any(|it| line.contains(it)), "{line}");
            assert!(!line.starts_with("equals"), "{line}");
        }
    }
}
