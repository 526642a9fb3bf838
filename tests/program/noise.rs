//! Devices that send random messages to a host, over real connections, during a whole round.

use std::fs;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use carrom::class::{ClassStep, Vote};
use carrom::quiz::{Code, Form, Question, Round};
use rand::seq::IndexedRandom;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64;
use serde_json::{Value, json};
use tungstenite::{Bytes, Message};

use crate::folder::Folder;
use crate::handed_in::hand_in;
use crate::pupil::Pupil;
use crate::teacher::{Teacher, kept};
use crate::thorough::cases;

/// The page that is served in these tests.
const STUB: &str = "<html lang=\"en\">a page</html>";
/// A round of ten questions of all forms.
const ROUND: &str = "mixed10-0";
/// The number of devices that send random messages.
const DEVICES: usize = 10;

fn questions() -> Vec<Question> {
    let round = Round::of(Code::parse(ROUND).unwrap());
    let questions = round.questions().to_vec();
    let has = |is: fn(&Form) -> bool| questions.iter().any(|it| is(&it.form));
    assert_eq!(questions.len(), 10);
    assert!(has(|form| matches!(form, Form::Rays { .. })));
    assert!(has(|form| matches!(form, Form::Number { .. })));
    assert!(has(|form| matches!(form, Form::Choice { .. })));
    assert!(has(|form| matches!(form, Form::Shot(_))));
    questions
}

/// A vote that a form accepts, and votes that it does not accept: out of range, not a number, of
/// another kind.
fn votes(form: &Form) -> (String, Vec<String>) {
    let own: (&str, &str, &[&str]) = match form {
        Form::Rays { .. } => ("rays", " 3", &["181", "-181", "1e9"]),
        Form::Number { .. } => ("number", "", &["1e300", "-1e300"]),
        Form::Choice { .. } => (
            "choice",
            "",
            &["0", "9", "99", "-1", "18446744073709551615"],
        ),
        Form::Shot(_) => ("shot", "", &["1e6", "-1e6"]),
    };
    let (kind, behind, ranges) = own;
    let good = match form {
        Form::Number { .. } => form.truth().to_text(),
        Form::Rays { .. } => "rays 12 still".to_owned(),
        _ => format!("{kind} 1"),
    };
    let no_numbers = ["NaN", "inf", "-inf", "1e999", "-1e999", "", "x"];
    let own = ranges.iter().chain(&no_numbers);
    let mut bad: Vec<String> = own.map(|x| format!("{kind} {x}{behind}")).collect();
    let others = ["rays 1 2", "number 1", "choice 1", "shot 1"];
    let others = others.iter().filter(|it| !it.starts_with(kind));
    bad.extend(others.map(|it| format!("sure {it}")));
    bad.extend(["rays 1 2 3", "sure", " "].map(String::from));
    (good, bad)
}

/// Continues to the step after this one.
fn go_on(teacher: &Teacher, step: ClassStep, question: usize) {
    let keys = match step {
        // Skip to the end of the shot.
        ClassStep::Shot => "<End><Enter>",
        _ => "<Enter>",
    };
    let shows = match step {
        ClassStep::Scores if question == 10 => "for a spreadsheet".to_owned(),
        ClassStep::Scores => format!("question {} of 10", question + 1),
        _ => format!("question {question} of 10"),
    };
    teacher.press(keys, &shows);
}

/// The steps of a question at which the devices' screens change.
const STEPS: [ClassStep; 6] = [
    ClassStep::Describe,
    ClassStep::FirstVote,
    ClassStep::Talk,
    ClassStep::SecondVote,
    ClassStep::Shot,
    ClassStep::Scores,
];

/// Sends invalid votes on questions of every form, at both votes and after the end: out of range,
/// of another kind, not a number.
#[test]
fn invalid_votes_are_refused_at_every_question() {
    let folder = Folder::new("noise-votes");
    let teacher = Teacher::with_round(&folder, STUB, ROUND);
    teacher.press("<Enter>", "question 1 of 10");
    let mut ada = Pupil::join(teacher.port, &teacher.code, "Ada", None).unwrap();
    let seat = ada.text("seat");
    let (mut refused, mut taken) = (0, 0);
    for (at, question) in questions().iter().enumerate() {
        let (good, bad) = votes(&question.form);
        for step in STEPS {
            if let Some(vote) = step.vote() {
                ada.hear_until(|state| state["q"] == at && state["step"] == name(step).as_str())
                    .unwrap();
                // A new connection has its full allowance of messages.
                ada = Pupil::join(teacher.port, &teacher.code, "Ada", Some(&seat)).unwrap();
                let field: &str = vote.into();
                for said in &bad {
                    ada.vote(said).unwrap();
                    assert_eq!(ada.state["misfit"], true, "{said} at {at}");
                    assert_eq!(ada.text(field), "", "{said} at {at}");
                }
                ada.vote(&good).unwrap();
                assert_eq!(ada.state.get("misfit"), None, "{good}");
                let kept = ada.text(field);
                assert_ne!(kept, "", "{good} at {at}");
                ada.vote(&bad[0]).unwrap();
                assert_eq!(ada.text(field), kept, "the valid vote stays");
                refused += bad.len() + 1;
                taken += 1;
            }
            go_on(&teacher, step, at + 1);
        }
    }
    ada.hear_until(|state| state["step"] == "end").unwrap();
    for said in ["choice 1", "rays 1 2", "number 1", "shot 1", "x"] {
        ada.vote(said).unwrap();
        refused += 1;
    }
    let round = kept(&folder);
    assert_eq!(round.dropped_votes(), 0);
    let given = (0..10).flat_map(|at| Vote::BOTH.map(|vote| round.voted(at, vote)));
    assert_eq!((given.sum(), taken), (20, 20));
    println!("{refused} invalid votes were refused");
}

/// The name of a step in a state.
fn name(step: ClassStep) -> String {
    let name: &str = step.into();
    name.to_owned()
}

/// A device that sends random messages until the round is over, and reconnects whenever it is
/// disconnected.
fn babble(port: u16, code: &str, device: usize, said: &AtomicUsize, over: &AtomicBool) -> usize {
    let mut chance = Pcg64::seed_from_u64(device as u64);
    let mut seat = None;
    let mut connections = 0;
    while !over.load(Ordering::SeqCst) {
        let name = format!("Device {device}");
        let joined = Pupil::join_from(device as u8 + 10, port, code, &name, seat.as_deref());
        let Ok(mut pupil) = joined else {
            thread::sleep(Duration::from_millis(5));
            continue;
        };
        assert_eq!(pupil.why(), None);
        seat = Some(pupil.text("seat"));
        connections += 1;
        let patience = Some(Duration::from_millis(2));
        pupil.socket.get_mut().set_read_timeout(patience).unwrap();
        while !over.load(Ordering::SeqCst) {
            let message = anything(&pupil.state, &mut chance);
            if pupil.socket.send(message).is_err() {
                break;
            }
            said.fetch_add(1, Ordering::SeqCst);
            // The device may receive a state or a refusal.
            if chance.random_bool(0.5)
                && let Err(error) = pupil.hear()
                && !is_late(&error)
            {
                break;
            }
            if pupil.why().is_some() {
                break;
            }
        }
    }
    connections
}

fn is_late(error: &std::io::Error) -> bool {
    use std::io::ErrorKind::{TimedOut, WouldBlock};
    matches!(error.kind(), TimedOut | WouldBlock)
}

/// A number or something else in its place, which JSON may or may not allow.
fn any_number(chance: &mut Pcg64) -> String {
    let numbers = [
        "-1",
        "0",
        "1",
        "9",
        "1.5",
        "1e999",
        "-1e999",
        "NaN",
        "18446744073709551615",
        "1e18",
        "null",
        "\"1\"",
        "[]",
        "{}",
    ];
    match chance.random_range(0..3) {
        0 => numbers.choose(chance).unwrap().to_string(),
        1 => chance.random_range(0..12).to_string(),
        _ => chance.random_range(0..1_000_000).to_string(),
    }
}

/// The text of a vote, valid or random.
fn any_vote(state: &Value, chance: &mut Pcg64) -> String {
    let form = &state["question"]["form"];
    let kinds = ["rays", "number", "choice", "shot"];
    let own = kinds
        .iter()
        .find(|kind| form.get(**kind).is_some())
        .unwrap_or(&"rays");
    let kind = if chance.random_bool(0.7) {
        own
    } else {
        kinds.choose(chance).unwrap()
    };
    let numbers = [
        "NaN",
        "inf",
        "1e999",
        "-1",
        "0",
        "still",
        "99",
        "1e300",
        "18446744073709551615",
    ];
    let mut number = || match chance.random_range(0..4) {
        0 => numbers.choose(chance).unwrap().to_string(),
        _ => chance.random_range(0..9).to_string(),
    };
    let said = match *kind {
        "rays" => format!("rays {} {}", number(), number()),
        kind => format!("{kind} {}", number()),
    };
    match chance.random_range(0..8) {
        0 => format!("sure {said}"),
        1 => any_text(chance),
        2 => String::new(),
        _ => said,
    }
}

fn any_text(chance: &mut Pcg64) -> String {
    let letters = chance.random_range(0..40);
    (0..letters).map(|_| chance.random::<char>()).collect()
}

/// A random message: mostly votes, but also everything else that a device may or must not send.
fn anything(state: &Value, chance: &mut Pcg64) -> Message {
    let quoted = |text: &str| Value::from(text).to_string();
    let vote = ["first", "second", "third", ""];
    let text = match chance.random_range(0..100) {
        // In the current format, with any content.
        0..45 => {
            let vote = match state["step"].as_str() {
                Some("second-vote") => "second",
                _ => "first",
            };
            let n = state["n"]
                .as_u64()
                .unwrap_or(0)
                .saturating_add(chance.random_range(0..3));
            let said = quoted(&any_vote(state, chance));
            format!(
                r#"{{"t":"vote","q":{},"vote":"{vote}","said":{said},"n":{n}}}"#,
                state["q"]
            )
        }
        45..70 => {
            let [q, n] = [0; 2].map(|_| any_number(chance));
            let (vote, said) = (
                vote.choose(chance).unwrap(),
                quoted(&any_vote(state, chance)),
            );
            format!(r#"{{"t":"vote","q":{q},"vote":"{vote}","said":{said},"n":{n}}}"#)
        }
        70..75 => {
            let n = any_number(chance);
            let file = match chance.random_range(0..4) {
                0 => hand_in(1, "x", 3, 1).value().unwrap().to_string(),
                1 => json!({"format": 1, "answers": [any_text(chance)]}).to_string(),
                2 => quoted(&"x".repeat(chance.random_range(0..20_000))),
                _ => any_number(chance),
            };
            format!(r#"{{"t":"hand-in","n":{n},"file":{file}}}"#)
        }
        75..80 => format!(
            r#"{{"t":"join","v":{},"code":{},"name":{}}}"#,
            any_number(chance),
            quoted(&any_text(chance)),
            quoted(&any_text(chance))
        ),
        80 => r#"{"t":"leave"}"#.to_owned(),
        81..86 => any_text(chance),
        86..89 => "[".repeat(chance.random_range(0..1000)),
        89..91 => "x".repeat(chance.random_range(1000..200_000)),
        // A truncated message.
        91..93 => {
            let whole = r#"{"t":"vote","q":0,"vote":"first","said":"rays 1 2","n":1}"#;
            whole[..chance.random_range(0..whole.len())].to_owned()
        }
        kind => {
            let mut bytes = vec![0; chance.random_range(0..100)];
            chance.fill_bytes(&mut bytes);
            let bytes = Bytes::from(bytes);
            return match kind {
                93..96 => Message::Binary(bytes),
                96..98 => Message::Ping(bytes),
                98 => Message::Pong(bytes),
                _ => Message::Close(None),
            };
        }
    };
    Message::text(text)
}

/// Ten devices send thousands of random messages of all kinds, or the number in `CARROM_MESSAGES`,
/// during a whole round of ten questions. The host keeps running, all votes of a pupil who votes
/// normally are saved, and every vote on the disk is valid for its question.
#[test]
fn random_messages_from_ten_devices_neither_end_a_round_nor_leave_an_invalid_vote() {
    let messages = std::env::var("CARROM_MESSAGES").ok();
    let messages: usize = messages
        .and_then(|it| it.parse().ok())
        .unwrap_or(cases(3_000, 10_000));
    let folder = Folder::new("noise");
    let teacher = Teacher::with_round(&folder, STUB, ROUND);
    let mut ada = Pupil::join(teacher.port, &teacher.code, "Ada", None).unwrap();
    teacher.press("<Enter>", "question 1 of 10");
    let (said, over) = (AtomicUsize::new(0), AtomicBool::new(false));
    let start = Instant::now();
    let mut votes_on_disk = 0;
    let connections = thread::scope(|scope| {
        let devices: Vec<_> = (0..DEVICES)
            .map(|device| {
                let (teacher, said, over) = (&teacher, &said, &over);
                let (port, code) = (teacher.port, teacher.code.clone());
                scope.spawn(move || babble(port, &code, device, said, over))
            })
            .collect();
        // A failure here must also stop the devices.
        let played = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            let mut steps = 0;
            for (at, question) in questions().iter().enumerate() {
                for step in STEPS {
                    steps += 1;
                    while said.load(Ordering::SeqCst) < messages * steps / 60 {
                        thread::sleep(Duration::from_millis(1));
                        assert!(
                            start.elapsed() < Duration::from_secs(900),
                            "the host does not reply"
                        );
                    }
                    ada.hear_until(|state| {
                        state["q"] == at && state["step"] == name(step).as_str()
                    })
                    .unwrap();
                    if step.vote().is_some() {
                        let (good, _) = votes(&question.form);
                        ada.vote(&good).unwrap();
                        assert_eq!(ada.state.get("misfit"), None);
                    }
                    // Invalid votes would be dropped and counted when the file is read.
                    let round = kept(&folder);
                    assert_eq!(round.dropped_votes(), 0, "an invalid vote is on the disk");
                    go_on(&teacher, step, at + 1);
                }
            }
            let round = kept(&folder);
            assert_eq!(round.dropped_votes(), 0);
            let ada = round
                .teams()
                .iter()
                .position(|name| *name == "Ada")
                .unwrap();
            for (at, question) in questions().iter().enumerate() {
                for vote in Vote::BOTH {
                    assert!(round.ballot(at, ada).vote(vote).is_some());
                    let people = 0..round.teams().len();
                    let given = people.filter_map(|person| round.ballot(at, person).vote(vote));
                    for said in given {
                        assert!(question.form.accepts(&said), "{said:?}");
                        votes_on_disk += 1;
                    }
                }
            }
            assert!(round.teams().len() <= DEVICES + 1, "{:?}", round.teams());
        }));
        over.store(true, Ordering::SeqCst);
        let connections: usize = devices.into_iter().map(|it| it.join().unwrap()).sum();
        played.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        connections
    });
    // The text of the file contains none of the invalid values either.
    let text = fs::read_to_string(folder.path().join("classes/class-1.toml")).unwrap();
    for word in ["NaN", "inf", "1e999", "choice 99", "1e300"] {
        assert!(!text.contains(word), "{word}");
    }
    println!(
        "{} messages from {DEVICES} devices over {connections} connections in {:.0} s; {votes_on_disk} \
         votes are on the disk, and all of them fit",
        said.load(Ordering::SeqCst),
        start.elapsed().as_secs_f64()
    );
}
