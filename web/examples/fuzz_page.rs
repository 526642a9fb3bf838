//! Sends carrom random commands, as a page would, and checks that nothing fails:
//! `cargo run --release -p carrom-web --example fuzz_page -- SECONDS [FIRST]`, where FIRST is the
//! number of the first session. A panic names its session.

use std::error::Error;
use std::time::{Duration, Instant};
use std::{env, panic, process};

use carrom_web::{Command, Shell};
use rand::seq::IndexedRandom;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde_json::{Value, json};

/// The largest number of commands in a session.
const LONGEST: u64 = 1000;
/// The largest number of commands between two frames.
const PAINTED: u64 = 100;
/// Keys that often open or close a screen: a frame is drawn after each.
const LEADING: [&str; 3] = ["Enter", "Esc", "Escape"];

const FRAGMENTS: [&str; 10] = [
    "",
    "lab",
    "foil",
    "table",
    "levels",
    "chapter=2",
    "quiz=mixed-7&player=Ana",
    "class=quick-7&teams=Ants,Bees",
    "quiz=%ff%00&player=%",
    "nowhere=at-all&&==",
];
const KEYS: [&str; 24] = [
    "Enter",
    "Enter",
    "Escape",
    "Space",
    "Tab",
    "Shift+Tab",
    "Up",
    "Down",
    "Left",
    "Right",
    "Home",
    "End",
    "PageUp",
    "PageDown",
    "Backspace",
    "F1",
    "F2",
    "3",
    "6",
    "0",
    ".",
    "-",
    "?",
    "n",
];
const KINDS: [&str; 6] = ["down", "drag", "up", "scroll-up", "scroll-down", "wink"];

/// A random text of up to `most` characters.
fn text(chance: &mut impl Rng, most: usize) -> String {
    let length = chance.random_range(0..=most);
    (0..length).map(|_| chance.random::<char>()).collect()
}

fn opening(chance: &mut impl Rng) -> Value {
    let fragment = match chance.random_range(0..10) {
        0 => text(chance, 30),
        _ => FRAGMENTS.choose(chance).copied().unwrap_or_default().into(),
    };
    json!({
        "do": "open",
        "fragment": fragment,
        "seed": chance.random::<u32>(),
        "columns": chance.random_range(1..200),
        "rows": chance.random_range(1..70),
        "light": chance.random::<bool>(),
        "still": chance.random::<bool>(),
        "simulated": chance.random_bool(0.8),
    })
}

/// News that a page may receive from a class.
fn news(chance: &mut impl Rng) -> Value {
    let heard = [
        r#"{"t":"no","why":"code"}"#.to_owned(),
        r#"{"t":"no","why":"kicked"}"#.to_owned(),
        r#"{"t":"state","v":1}"#.to_owned(),
        text(chance, 30),
    ];
    match chance.random_range(0..5) {
        0 => json!({ "is": "reached" }),
        1 => json!({ "is": "heard", "text": heard.choose(chance) }),
        2 => json!({ "is": "lost", "reason": text(chance, 30) }),
        3 => json!({ "is": "remembered", "seat": text(chance, 32), "name": text(chance, 12) }),
        _ => json!({ "is": "awake" }),
    }
}

/// A random command and the bytes that follow it. `meant` lists the keys of the last frame.
fn said(meant: &[String], chance: &mut impl Rng) -> (Value, Vec<u8>) {
    let bytes: Vec<u8> = (0..chance.random_range(0..40))
        .map(|_| chance.random())
        .collect();
    let said = match chance.random_range(0..100) {
        0..20 => json!({ "do": "key", "key": KEYS.choose(chance) }),
        20..38 => match meant.choose(chance).map(String::as_str) {
            // Ctrl+C ends a session.
            Some("Ctrl+C") if chance.random_bool(0.95) => json!({ "do": "key", "key": "Escape" }),
            key => json!({ "do": "key", "key": key.unwrap_or("Enter") }),
        },
        38..40 => json!({ "do": "joined", "news": news(chance) }),
        40..60 => json!({ "do": "key", "key": chance.random_range(' '..='~').to_string() }),
        60 => json!({ "do": "tell", "words": text(chance, 90) }),
        61 => json!({
            "do": "files",
            "files": [{ "path": "progress.db", "bytes": chance.random_range(0..40) }],
        }),
        62 => json!({ "do": "key", "key": text(chance, 3) }),
        63..80 => json!({
            "do": "mouse",
            "kind": KINDS.choose(chance),
            "x": chance.random_range(-10.0..250.0),
            "y": chance.random_range(-10.0..90.0),
        }),
        80 => json!({ "do": "paste", "text": text(chance, 200) }),
        81 => json!({ "do": "paste", "text": "1e300" }),
        82 => json!({
            "do": "resize",
            "columns": chance.random_range(0..250),
            "rows": chance.random_range(0..90),
            "pictures": chance.random_bool(0.7).then(|| json!({
                "any": [chance.random_range(0..300), chance.random_range(0..120)],
                "square": [chance.random_range(0..300), chance.random_range(0..120)],
            })),
        }),
        83..90 => json!({ "do": "pass", "ms": chance.random_range(-10.0..2000.0) }),
        90 => json!({
            "do": "now",
            "time_s": chance.random::<i64>(),
            "offset_s": chance.random::<i32>(),
        }),
        91 => json!({ "do": "set", "charset": "ascii", "color": "none" }),
        92 => json!({ "do": "set", "charset": "unicode", "color": "truecolor" }),
        93 => json!({ "do": "changed" }),
        94 => json!({ "do": "kept", "failed": chance.random::<bool>().then_some("full") }),
        95 => json!({ "do": "slow" }),
        96 => json!({ "do": "file", "name": text(chance, 12) }),
        97 => json!({ "do": "progress" }),
        98 => json!({ "do": "glyph", "letter": text(chance, 2) }),
        _ => json!({ "do": "talk", "lines": [text(chance, 8), "quiz", "60", "yes"] }),
    };
    (said, bytes)
}

/// Plays the session with this number; returns the number of commands.
///
/// # Errors
/// If a picture contains "NaN".
fn play(number: u64) -> Result<u64, Box<dyn Error>> {
    let mut chance = Pcg64Mcg::seed_from_u64(number);
    let Command::Open(opening) = serde_json::from_value(opening(&mut chance))? else {
        return Ok(0);
    };
    let (mut shell, mut reply) = Shell::open(&opening, &[]);
    let most = chance.random_range(10..=LONGEST);
    let mut meant = Vec::new();
    for step in 0..most {
        if reply.quit {
            return Ok(step);
        }
        let (said, bytes) = said(&meant, &mut chance);
        let command: Command = serde_json::from_value(said)?;
        let leads = matches!(&command, Command::Key { key } if LEADING.contains(&key.as_str()));
        reply = shell.call(command, &bytes);
        if leads || step % PAINTED == 0 {
            let painted = shell
                .call(Command::Paint { since: 0 }, &[])
                .painted
                .unwrap_or_default();
            if painted
                .pictures
                .iter()
                .any(|it| it.svg.as_ref().is_some_and(|svg| svg.contains("NaN")))
            {
                return Err(format!("session {number} draws NaN at {step}").into());
            }
            if let Some(keys) = painted.keys {
                meant = keys.into_iter().flat_map(|it| it.keys).collect();
            }
        }
    }
    Ok(most)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1).map(|word| word.parse::<u64>());
    let seconds = arguments.next().ok_or("expected SECONDS [FIRST]")??;
    let first = arguments.next().transpose()?.unwrap_or(0);
    let (start, mut inputs, mut next) = (Instant::now(), 0, first);
    while start.elapsed() < Duration::from_secs(seconds) {
        match panic::catch_unwind(|| play(next)) {
            Ok(said) => inputs += said?,
            Err(_) => {
                eprintln!("session {next} panicked");
                process::exit(1);
            }
        }
        next += 1;
    }
    println!(
        "{inputs} inputs in {} sessions, from {first} on; none failed",
        next - first
    );
    Ok(())
}
