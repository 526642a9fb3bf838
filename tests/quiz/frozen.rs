//! Two kinds of snapshots of the questions that seeds and codes give.
//!
//! The draws are a format: a code must give the same round in every version. One hash per family
//! covers everything except the texts: figures, the right answer, the order of the choices and the
//! answers of misconceptions. None of these hashes may ever change. Misconceptions are counted as
//! existing codes count them, because splitting a misconception does not change the draws. If
//! `CARROM_QUESTIONS` is set to a folder, the hashed data are written there, one JSON object per
//! line and one file per family, so that two versions can be compared.
//!
//! The texts may change; each change shows up in one snapshot with a section per family.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::PathBuf;

use carrom::quiz::{
    Code, Dice, Difficulty, Family, Form, Illustration, Question, Rays, Response, Round,
};
use serde_json::{Value, json};

/// Numbers are rounded to twelve significant figures, because machines differ in the last bit of a
/// sine.
fn number(x: f64) -> Value {
    if x.abs() < 1e-12 {
        return json!("0");
    }
    json!(format!("{x:.11e}"))
}

fn rays(rays: &Rays) -> Value {
    json!([rays.striker.map(number), rays.target.map(number)])
}

fn said(said: &Response) -> Value {
    match said {
        Response::Rays(it) => rays(it),
        Response::Number(x) | Response::Shot(x) => number(*x),
        Response::Choice(i) => json!(i),
    }
}

fn collision(it: &carrom::physics::Collision) -> Value {
    let numbers = [
        it.striker.mass,
        it.striker.radius,
        it.target.mass,
        it.target.radius,
        it.u1.x,
        it.u1.y,
        it.u2.x,
        it.u2.y,
        it.offset,
        it.restitution,
    ];
    json!({ "numbers": numbers.map(number), "bond": format!("{:?}", it.bond) })
}

fn picture(picture: &Illustration) -> Value {
    match picture {
        Illustration::Nothing => json!("nothing"),
        Illustration::Before {
            collision: it,
            shown,
        } => json!({
            "before": collision(it),
            "shown": [shown.offset, shown.angle, shown.figures],
        }),
        Illustration::After { collision: it } => json!({ "after": collision(it) }),
        Illustration::Tracks { rutherford, angles } => json!({
            // In femtometres, because a number near 0 is written as 0.
            "approach": number(1e15 * rutherford.head_on_approach),
            "angles": angles.map(number),
        }),
    }
}

fn form(form: &Form) -> Value {
    match form {
        Form::Rays {
            truth,
            side,
            target,
        } => json!({ "rays": rays(truth), "side": side, "target": target }),
        Form::Number { quantity, truth } => {
            json!({ "number": number(*truth), "quantity": quantity.id() })
        }
        Form::Choice { options, right } => json!({ "options": options.len(), "right": right }),
        Form::Shot(aim) => json!({
            "shot": number(aim.offset),
            "ray": format!("{:?}", aim.ray),
            "wanted": number(aim.wanted),
            "collision": collision(&aim.collision),
        }),
    }
}

/// All of a question except its texts.
fn drawn(question: &Question) -> Value {
    let mut replies: BTreeSet<usize> = question.replies.keys().copied().collect();
    let mut beliefs: Vec<Value> = Vec::new();
    for it in &question.beliefs {
        match (it.in_codes(), it.said) {
            (Some(misconception), _) => beliefs.push(json!({
                "id": misconception.id(),
                "said": said(&it.said),
                "telltale": it.telltale.map(|ray| format!("{ray:?}")),
            })),
            (None, Response::Choice(choice)) => {
                replies.insert(choice);
            }
            (None, _) => panic!("{}: unknown to codes", it.misconception.id()),
        }
    }
    json!({
        "family": question.family.id(),
        "difficulty": question.difficulty.id(),
        "topic": question.topic.id(),
        "picture": picture(&question.picture),
        "form": form(&question.form),
        "beliefs": beliefs,
        "replies": replies,
        "figures": question.figures,
    })
}

/// The questions of a family, one per line, each with the number of draws it took and the number
/// that the dice give next.
fn lines(family: Family, seeds: u64) -> String {
    let mut text = String::new();
    for (difficulty, seed) in Difficulty::ALL
        .into_iter()
        .flat_map(|difficulty| (0..seeds).map(move |seed| (difficulty, seed)))
    {
        let mut dice = Dice::new(seed);
        let (question, draws) = family.ask(difficulty, &mut dice).unwrap();
        let line = json!({
            "seed": seed,
            "draws": draws,
            "next": dice.below(1_000_000),
            "question": drawn(&question),
        });
        let _ = writeln!(text, "{line}");
    }
    text
}

/// The 64-bit FNV-1a hash.
fn hash(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// The hash of a text, after the text's name. The text is written to a file if `CARROM_QUESTIONS`
/// is set.
fn kept(name: &str, text: &str) -> String {
    if let Some(folder) = std::env::var_os("CARROM_QUESTIONS") {
        let path = PathBuf::from(folder).join(format!("{name}.jsonl"));
        std::fs::write(path, text).unwrap();
    }
    format!("{name} {:016x}", hash(text))
}

/// The number of families with published codes. A family that is added later is frozen once it is
/// published, in a separate snapshot.
const FROZEN: usize = 17;

/// The hash of every family, with `seeds` seeds at each difficulty.
fn families(seeds: u64) -> String {
    let (first, second): (Vec<_>, Vec<_>) = Family::ALL[..FROZEN]
        .iter()
        .copied()
        .enumerate()
        .partition(|(i, _)| i % 2 == 0);
    let hashes = |families: Vec<(usize, Family)>| -> Vec<(usize, String)> {
        let families = families.into_iter();
        families
            .map(|(i, family)| (i, kept(family.id(), &lines(family, seeds))))
            .collect()
    };
    let mut all = std::thread::scope(|scope| {
        let other = scope.spawn(|| hashes(second));
        let mut all = hashes(first);
        all.extend(other.join().unwrap());
        all
    });
    all.sort();
    let lines: Vec<String> = all.into_iter().map(|(_, line)| line).collect();
    lines.join("\n")
}

#[test]
fn a_seed_always_gives_the_same_question() {
    insta::assert_snapshot!("families", families(500));
}

/// The same test with four times as many seeds, to be run after changes to how questions
/// are drawn at random.
#[test]
#[ignore = "takes as long as all other tests of the quiz; CI runs it"]
fn two_thousand_seeds_always_give_the_same_questions() {
    insta::assert_snapshot!("two-thousand", families(2_000));
}

/// The rounds of these codes, one per line.
fn rounds(codes: &[&str]) -> String {
    let mut text = String::new();
    for code in codes {
        let round = Round::of(Code::parse(code).unwrap());
        let questions: Vec<Value> = round.questions().iter().map(drawn).collect();
        let _ = writeln!(text, "{}", json!({ "code": code, "questions": questions }));
    }
    text
}

#[test]
fn a_code_always_gives_the_same_round() {
    let codes = [
        "0",
        "1",
        "7",
        "42",
        "999999",
        "quick-7",
        "mixed-7",
        "mixed-1234",
        "mixed12-42",
        "exam-3",
        "speeds3-5",
        "frames-mixed-7",
    ];
    let text = rounds(&codes);
    insta::assert_snapshot!("codes", kept("codes", &text));
}

#[test]
fn a_code_of_read_chapters_always_gives_the_same_round() {
    let text = rounds(&["read-a-7", "read-abc-7", "read-bdfghijkl-42", "read-l5-3"]);
    insta::assert_snapshot!("codes-read", kept("codes-read", &text));
}

#[test]
fn a_code_of_the_even_course_always_gives_the_same_round() {
    let text = rounds(&["even-7", "even-1234", "even20-42"]);
    insta::assert_snapshot!("codes-even", kept("codes-even", &text));
}

/// The texts of a question, each with its role.
fn words(question: &Question) -> Vec<(String, &str)> {
    let mut words = vec![
        ("asks".to_owned(), question.text.as_str()),
        ("why".to_owned(), &question.why),
    ];
    if let Form::Choice { options, .. } = &question.form {
        words.extend(options.iter().map(|it| ("choice".to_owned(), it.as_str())));
    }
    let replies = question.replies.values();
    words.extend(replies.map(|it| ("reply".to_owned(), it.as_str())));
    let beliefs = question.beliefs.iter();
    words.extend(beliefs.map(|it| (it.misconception.id().to_owned(), it.says.as_str())));
    words
}

/// A text with every number replaced by its format: "18.0°" and "7.5°" both become "#.0°", so that
/// texts that differ only in figures are equal.
fn without_figures(text: &str) -> String {
    let mut result = String::new();
    let mut decimals = false;
    for c in text.chars() {
        match c {
            '0'..='9' if decimals => result.push('0'),
            '0'..='9' if result.ends_with('#') => {}
            '0'..='9' => result.push('#'),
            c => {
                decimals = c == '.' && result.ends_with('#');
                result.push(c);
            }
        }
    }
    result
}

/// The texts of questions in words are in `assets/concepts` and are left out.
#[test]
fn the_words_of_each_family_are_unchanged() {
    let mut text = String::new();
    let written = [Family::Concept, Family::Ideas];
    let families = Family::ALL.iter().filter(|it| !written.contains(it));
    for family in families {
        let mut all = BTreeSet::new();
        for difficulty in Difficulty::ALL {
            for seed in 0..20 {
                let (question, _) = family.ask(difficulty, &mut Dice::new(seed)).unwrap();
                let words = words(&question).into_iter();
                all.extend(words.map(|(of, text)| format!("{of}: {}", without_figures(text))));
            }
        }
        let lines: Vec<String> = all.into_iter().collect();
        let _ = writeln!(text, "== {} ==\n{}\n", family.id(), lines.join("\n"));
    }
    insta::assert_snapshot!("words", text);
}
