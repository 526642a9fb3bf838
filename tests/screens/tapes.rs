//! The tapes under `tests/tapes`, each played in both charsets at two sizes. What they
//! expect and refuse holds in all four; their screenshots are kept as one snapshot a
//! tape and variant, accepted after they were looked at: two variants of every tape,
//! and all four of those that together show every kind of picture.

use std::collections::BTreeSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::thread;

use carrom::cli;
use carrom::shells::tape::{Screenshot, Tape, play};

/// Charset and size of each variant, and whether every tape has a snapshot of it.
const VARIANTS: [(&str, &str, bool); 4] = [
    ("ascii", "80x24", true),
    ("ascii", "120x40", false),
    ("unicode", "80x24", false),
    ("unicode", "120x40", true),
];

/// The tapes that have a snapshot of every variant.
const IN_ALL_VARIANTS: [&str; 17] = [
    "board",
    "class-round",
    "family-from-offset",
    "family-make-it-so",
    "family-rutherford",
    "foil-1913",
    "foil-beam",
    "foil-particle",
    "home",
    "learn-04",
    "learn-09",
    "levels",
    "mystery-coin",
    "progress",
    "quiz-right",
    "stick",
    "worked-shot",
];

fn folder(of: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(of)
}

/// Names of the files in `folder` that end in `ending`, without it, in order.
fn names(folder: &Path, ending: &str) -> BTreeSet<String> {
    let files = fs::read_dir(folder).unwrap();
    let files = files.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let stem = |name: String| name.strip_suffix(ending).map(str::to_owned);
    files.filter_map(stem).collect()
}

/// Plays the tape `name` with charset and size set after its first instruction, `Run`.
fn played(name: &str, charset: &str, size: &str) -> Vec<Screenshot> {
    let text = fs::read_to_string(folder("tapes").join(format!("{name}.tape"))).unwrap();
    let mut lines: Vec<_> = text.lines().map(str::to_owned).collect();
    let run = lines.iter().position(|line| line.starts_with("Run"));
    let setting = format!("Set Size {size}\nSet Charset {charset}");
    lines.insert(run.map_or(0, |i| i + 1), setting);
    let tape = Tape::parse(&lines.join("\n")).unwrap_or_else(|error| panic!("{name}:{error}"));
    play(&tape, cli::open).unwrap_or_else(|error| panic!("{name} in {charset} at {size}:{error}"))
}

/// All screenshots of a tape in one text.
fn album(screenshots: &[Screenshot]) -> String {
    let pages = screenshots
        .iter()
        .map(|shot| format!("== {} ==\n{}\n", shot.name, shot.text().trim_end()));
    pages.collect::<Vec<_>>().join("\n")
}

/// Compares `text` with the snapshot `name` in `tests/snapshots/<folder>`.
fn compare(folder: &str, name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(format!("../snapshots/{folder}"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// Runs `check` on every item, on all cores; fails at the end with all that failed.
fn check_each<T: Send + std::fmt::Debug>(items: Vec<T>, check: impl Fn(&T) + Sync) {
    let left = Mutex::new(items);
    let failed = Mutex::new(Vec::new());
    let cores = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| {
                loop {
                    let next = left.lock().unwrap().pop();
                    let Some(item) = next else { break };
                    if catch_unwind(AssertUnwindSafe(|| check(&item))).is_err() {
                        failed.lock().unwrap().push(format!("{item:?}"));
                    }
                }
            });
        }
    });
    let failed = failed.into_inner().unwrap();
    assert!(failed.is_empty(), "these failed:\n{}", failed.join("\n"));
}

#[test]
fn every_tape_plays_and_looks_as_it_did() {
    let mut plays = Vec::new();
    let mut expected = BTreeSet::new();
    for name in names(&folder("tapes"), ".tape") {
        for (charset, size, always) in VARIANTS {
            let kept = always || IN_ALL_VARIANTS.contains(&name.as_str());
            if kept {
                expected.insert(format!("{name}-{charset}-{size}"));
            }
            plays.push((name.clone(), charset, size, kept));
        }
    }
    check_each(plays, |(name, charset, size, kept)| {
        let screenshots = played(name, charset, size);
        for screenshot in &screenshots {
            let screen = screenshot.text();
            assert!(!screen.contains("NaN") && !screen.contains("inf "));
            assert!(*charset == "unicode" || screen.is_ascii(), "{screen}");
        }
        if *kept {
            let snapshot = format!("{name}-{charset}-{size}");
            compare("tapes", &snapshot, &album(&screenshots));
        }
    });
    let kept = names(&folder("snapshots/tapes"), ".snap");
    let wrong: Vec<_> = kept.symmetric_difference(&expected).collect();
    assert!(wrong.is_empty(), "left over or missing: {wrong:?}");
}
