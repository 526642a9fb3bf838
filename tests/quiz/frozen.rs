//! Every question that a seed brings, held by a hash of all that makes it: figures, truth,
//! choices, what misconceptions answer, and every word.
//!
//! Questions are a format: a code is to bring the same round in every version. A change of
//! one of these hashes has to be a change of wording on purpose. With `CARROM_QUESTIONS` set
//! to a folder the questions are written there, one JSON object a line and one file a
//! family, so that two versions can be compared.

use std::fmt::Write as _;
use std::path::PathBuf;

use carrom::quiz::{
    Code, Dice, Difficulty, Family, Form, Illustration, Question, Rays, Response, Round,
};
use serde_json::{Value, json};

/// Numbers are held to twelve figures: machines differ in the last bit of a sine.
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
            // In femtometres, for what is nearly nothing is written as nothing.
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
        Form::Choice { options, right } => json!({ "options": options, "right": right }),
        Form::Shot(aim) => json!({
            "shot": number(aim.offset),
            "ray": format!("{:?}", aim.ray),
            "wanted": number(aim.wanted),
            "collision": collision(&aim.collision),
        }),
    }
}

/// All of a question.
fn written(question: &Question) -> Value {
    let beliefs: Vec<Value> = question
        .beliefs
        .iter()
        .map(|it| {
            json!({
                "id": it.misconception.id(),
                "said": said(&it.said),
                "telltale": it.telltale.map(|ray| format!("{ray:?}")),
                "says": it.says,
            })
        })
        .collect();
    json!({
        "family": question.family.id(),
        "difficulty": question.difficulty.id(),
        "topic": question.topic.id(),
        "text": question.text,
        "picture": picture(&question.picture),
        "form": form(&question.form),
        "beliefs": beliefs,
        "replies": question.replies,
        "why": question.why,
        "figures": question.figures,
    })
}

/// The questions of a family, one a line: with the draws each took, and what the dice
/// bring next.
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
            "question": written(&question),
        });
        let _ = writeln!(text, "{line}");
    }
    text
}

/// FNV-1a of 64 bits.
fn hash(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// A text under a name, and its hash; written to a file where that is wanted.
fn kept(name: &str, text: &str) -> String {
    if let Some(folder) = std::env::var_os("CARROM_QUESTIONS") {
        let path = PathBuf::from(folder).join(format!("{name}.jsonl"));
        std::fs::write(path, text).unwrap();
    }
    format!("{name} {:016x}", hash(text))
}

/// The hash of every family with so many seeds at each difficulty.
fn families(seeds: u64) -> String {
    let (first, second): (Vec<_>, Vec<_>) = Family::ALL
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
fn a_seed_brings_the_same_question_for_ever() {
    insta::assert_snapshot!("families", families(500));
}

/// Four times as many: for whoever changes what draws a question.
#[test]
#[ignore = "takes as long as all other tests of the quiz; CI runs it"]
fn two_thousand_seeds_bring_the_same_questions_for_ever() {
    insta::assert_snapshot!("two-thousand", families(2_000));
}

/// The rounds of these codes, one a line.
fn rounds(codes: &[&str]) -> String {
    let mut text = String::new();
    for code in codes {
        let round = Round::of(Code::parse(code).unwrap());
        let questions: Vec<Value> = round.questions().iter().map(written).collect();
        let _ = writeln!(text, "{}", json!({ "code": code, "questions": questions }));
    }
    text
}

#[test]
fn a_code_brings_the_same_round_for_ever() {
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
fn a_code_of_what_was_read_brings_the_same_round_for_ever() {
    let text = rounds(&["read-a-7", "read-abc-7", "read-bdfghijkl-42", "read-l5-3"]);
    insta::assert_snapshot!("codes-read", kept("codes-read", &text));
}

#[test]
fn a_code_of_the_even_course_brings_the_same_round_for_ever() {
    let text = rounds(&["even-7", "even-1234", "even20-42"]);
    insta::assert_snapshot!("codes-even", kept("codes-even", &text));
}
