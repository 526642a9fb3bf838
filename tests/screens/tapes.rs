//! The tapes under `tests/tapes`, each played in both charsets at two sizes. Their expectations and
//! refusals hold in all four variants. A selection of tapes shows every kind of picture. One
//! variant of each of these is kept as a snapshot, which was inspected before it was accepted; some
//! screenshots are also kept with their colours.

use std::collections::BTreeSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::thread;

use carrom::cli;
use carrom::shells::tape::{Screenshot, Tape, play};
use carrom::widgets::Depth::{self, Ansi16, Indexed256, True};
use carrom::widgets::Palette::{self, Dark, Light, Mono};
use carrom::widgets::Theme;

use super::colours;

/// Charset and size of each variant.
const VARIANTS: [(&str, &str); 4] = [
    ("ascii", "80x24"),
    ("ascii", "120x40"),
    ("unicode", "80x24"),
    ("unicode", "120x40"),
];

/// The tapes that are kept as snapshots, with charset and size.
const KEPT: [(&str, &str, &str); 37] = [
    ("home", "unicode", "120x40"),
    ("home-player", "ascii", "80x24"),
    ("quiz-choose", "unicode", "120x40"),
    ("quiz-right", "ascii", "120x40"),
    ("quiz-exam", "ascii", "80x24"),
    ("quiz-review", "ascii", "80x24"),
    ("family-both-moving", "ascii", "80x24"),
    ("family-centre-of-mass", "unicode", "120x40"),
    ("family-concept", "ascii", "80x24"),
    ("family-from-offset", "unicode", "80x24"),
    ("family-make-it-so", "ascii", "120x40"),
    ("family-rutherford", "unicode", "80x24"),
    ("family-slip-or-stick", "ascii", "80x24"),
    ("learn-04", "unicode", "80x24"),
    ("learn-09", "ascii", "120x40"),
    ("learn-contents", "unicode", "120x40"),
    ("worked-shot", "unicode", "120x40"),
    ("lab-live", "ascii", "80x24"),
    ("notebook", "unicode", "80x24"),
    ("stick", "unicode", "80x24"),
    ("mystery-coin", "ascii", "120x40"),
    ("miss", "ascii", "80x24"),
    ("marbles", "unicode", "120x40"),
    ("foil-beam", "unicode", "80x24"),
    ("foil-particle", "ascii", "80x24"),
    ("foil-1913", "unicode", "120x40"),
    ("levels", "unicode", "80x24"),
    ("levels-two-ideas", "ascii", "80x24"),
    ("board", "unicode", "120x40"),
    ("table-computer", "ascii", "80x24"),
    ("table-tray", "unicode", "120x40"),
    ("table-words", "ascii", "80x24"),
    ("saved-games", "ascii", "80x24"),
    ("class-round", "unicode", "80x24"),
    ("progress", "unicode", "120x40"),
    ("settings", "ascii", "80x24"),
    ("find-out-guess", "ascii", "80x24"),
];

/// The screenshots that are kept with their colours, at 80x24.
const COLOURED: [(&str, &str, &str, Palette, Depth); 11] = [
    ("home", "home", "unicode", Dark, True),
    ("worked-shot", "split", "unicode", Dark, True),
    ("worked-shot", "split", "ascii", Light, Ansi16),
    ("worked-shot", "departure", "unicode", Mono, True),
    ("worked-shot", "centre-of-mass", "unicode", Dark, Indexed256),
    ("board", "aim", "unicode", Dark, True),
    ("board", "queen", "ascii", Light, Ansi16),
    ("learn-04", "page4-moved", "unicode", Dark, True),
    ("foil-beam", "foil", "unicode", Dark, True),
    ("quiz-right", "right", "ascii", Dark, Ansi16),
    ("class-round", "second-vote", "unicode", Light, True),
];

fn folder(of: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(of)
}

/// The names of the files in `folder` that end in `ending`, without this ending, in order.
fn names(folder: &Path, ending: &str) -> BTreeSet<String> {
    let files = fs::read_dir(folder).unwrap();
    let files = files.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let stem = |name: String| name.strip_suffix(ending).map(str::to_owned);
    files.filter_map(stem).collect()
}

/// Plays the tape `name` with charset and size set after its first instruction, `Run`.
fn played(name: &str, charset: &str, size: &str, theme: Theme) -> Vec<Screenshot> {
    let text = fs::read_to_string(folder("tapes").join(format!("{name}.tape"))).unwrap();
    let mut lines: Vec<_> = text.lines().map(str::to_owned).collect();
    let run = lines.iter().position(|line| line.starts_with("Run"));
    let setting = format!("Set Size {size}\nSet Charset {charset}");
    lines.insert(run.map_or(0, |i| i + 1), setting);
    let tape = Tape::parse(&lines.join("\n")).unwrap_or_else(|error| panic!("{name}:{error}"));
    let open = |arguments: &str| {
        let mut app = cli::open(arguments)?;
        let settings = app.settings_mut();
        (settings.palette, settings.depth) = (theme.palette, theme.depth);
        Ok(app)
    };
    play(&tape, open).unwrap_or_else(|error| panic!("{name} in {charset} at {size}:{error}"))
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

/// Fails unless the snapshots in `tests/snapshots/<of>` are exactly the `wanted` ones.
fn assert_kept(of: &str, wanted: &BTreeSet<String>) {
    let kept = names(&folder("snapshots").join(of), ".snap");
    let wrong: Vec<_> = kept.symmetric_difference(wanted).collect();
    assert!(wrong.is_empty(), "left over or missing: {wrong:?}");
}

/// Runs `check` on every item, on all cores, and reports all failures at the end.
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
fn every_tape_plays_and_its_screenshots_are_unchanged() {
    let tapes = names(&folder("tapes"), ".tape");
    let of_each = |name: String| VARIANTS.map(|(charset, size)| (name.clone(), charset, size));
    let plays = tapes.into_iter().flat_map(of_each).collect();
    check_each(plays, |(name, charset, size)| {
        let screenshots = played(name, charset, size, Theme::new(Dark, Depth::None));
        for screenshot in &screenshots {
            let screen = screenshot.text();
            assert!(!screen.contains("NaN") && !screen.contains("inf "));
            assert!(*charset == "unicode" || screen.is_ascii(), "{screen}");
        }
        if KEPT.contains(&(name.as_str(), *charset, *size)) {
            let snapshot = format!("{name}-{charset}-{size}");
            compare("tapes", &snapshot, &album(&screenshots));
        }
    });
    let file = |(name, charset, size): (&str, &str, &str)| format!("{name}-{charset}-{size}");
    assert_kept("tapes", &KEPT.map(file).into());
}

#[test]
fn the_colours_of_some_pictures_are_unchanged() {
    let file = |(tape, shot, charset, palette, depth): (&str, &str, &str, Palette, Depth)| {
        format!("{tape}-{shot}-{charset}-{palette:?}-{depth:?}").to_lowercase()
    };
    check_each(COLOURED.to_vec(), |&picture| {
        let (tape, shot, charset, palette, depth) = picture;
        let theme = Theme::new(palette, depth);
        let screenshots = played(tape, charset, "80x24", theme);
        let screenshot = screenshots.iter().find(|other| other.name == shot);
        let text = colours::written(screenshot.unwrap(), theme);
        compare("colours", &file(picture), &text);
    });
    assert_kept("colours", &COLOURED.map(file).into());
}
