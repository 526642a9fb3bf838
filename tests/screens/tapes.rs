//! The tapes under `tests/tapes`, each played in both charsets at two sizes. Their
//! screenshots are snapshots: accepted after they were looked at.

use std::fs;
use std::path::{Path, PathBuf};

use carrom::cli;
use carrom::shells::tape::{Tape, play};

fn tapes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/tapes");
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "tape"))
        .collect();
    paths.sort();
    paths
}

/// The tape with charset and size set after its first instruction, `Run`.
fn set(text: &str, charset: &str, size: &str) -> String {
    let mut lines: Vec<_> = text.lines().map(str::to_owned).collect();
    let run = lines.iter().position(|line| line.starts_with("Run"));
    let setting = format!("Set Size {size}\nSet Charset {charset}");
    lines.insert(run.map_or(0, |i| i + 1), setting);
    lines.join("\n")
}

#[test]
fn every_tape_plays_and_looks_as_it_did() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots/tapes");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in tapes() {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = fs::read_to_string(&path).unwrap();
        for charset in ["ascii", "unicode"] {
            for size in ["80x24", "120x40"] {
                let tape = Tape::parse(&set(&text, charset, size))
                    .unwrap_or_else(|error| panic!("{name}:{error}"));
                let screenshots = play(&tape, cli::open)
                    .unwrap_or_else(|error| panic!("{name} in {charset} at {size}:{error}"));
                for screenshot in screenshots {
                    let screen = screenshot.text();
                    assert!(!screen.contains("NaN") && !screen.contains("inf "));
                    assert!(charset == "unicode" || screen.is_ascii(), "{screen}");
                    let snapshot = format!("{name}-{}-{charset}-{size}", screenshot.name);
                    settings.bind(|| insta::assert_snapshot!(snapshot, screen));
                }
            }
        }
    }
}
