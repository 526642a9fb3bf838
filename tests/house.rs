//! Holds every room of the house to its floor: higher rooms may use lower ones, never
//! the reverse, and rooms of one floor do not know each other.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

/// The floors from the top, as the map in `lib.rs` draws them.
const FLOORS: [&[&str]; 12] = [
    &["cli"],
    &["shells"],
    &["store"],
    &["app"],
    &["screens", "paper"],
    &["widgets"],
    &["messages"],
    &["class"],
    &["lessons", "progress"],
    &["quiz", "levels", "game", "beams"],
    &["physics", "files"],
    &["numbers"],
];

/// The floor of a room, counted from the top.
fn floor(room: &str) -> Option<usize> {
    FLOORS.iter().position(|rooms| rooms.contains(&room))
}

/// Whether code in room `from` may use room `to`.
fn allowed(from: &str, to: &str) -> bool {
    from == to || floor(from) < floor(to)
}

/// What follows a path to the root of the crate, wherever it is written in `code`,
/// which stands `depth` modules below that root: `crate::`, or enough `super::`.
fn after_root(code: &str, depth: usize) -> Vec<&str> {
    let mut found: Vec<_> = code.split("crate::").skip(1).collect();
    let up = "super::".repeat(depth);
    found.extend(code.split(up.as_str()).skip(1));
    found
}

/// The first names of what a path, or a list in braces, begins with.
fn first_names(path: &str) -> Vec<String> {
    let name = |text: &str| -> String {
        let text = text.trim_start();
        text.chars()
            .take_while(|c| c.is_alphanumeric() || *c == '_')
            .collect()
    };
    let Some(list) = path.trim_start().strip_prefix('{') else {
        return vec![name(path)];
    };
    let mut names = vec![name(list)];
    let mut depth = 1;
    for (i, c) in list.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 1 => names.push(name(&list[i + 1..])),
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    names
}

/// `source` without its comments, whose links may point anywhere.
fn code(source: &str) -> String {
    let lines = source.lines().map(|line| {
        let comment = line.find("//").unwrap_or(line.len());
        &line[..comment]
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// The uses in `source` that its floor does not allow; `path` is its place in `src`.
fn trespasses(path: &str, source: &str) -> Vec<String> {
    let place = path.trim_end_matches(".rs").trim_end_matches("/mod");
    let from = place.split('/').next().unwrap_or_default();
    let depth = place.split('/').count();
    let code = code(source);
    let mut found: Vec<_> = after_root(&code, depth)
        .into_iter()
        .flat_map(first_names)
        .filter(|to| floor(to).is_some() && !allowed(from, to))
        .map(|to| format!("src/{path}: {from} uses {to}"))
        .collect();
    found.sort();
    found.dedup();
    found
}

/// Calls `look` on every source file below `folder`.
fn each_source(folder: &Path, look: &mut impl FnMut(&Path)) {
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            each_source(&path, look);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            look(&path);
        }
    }
}

#[test]
fn every_room_uses_only_lower_ones() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    let mut seen = 0;
    each_source(&src, &mut |path| {
        let place = path.strip_prefix(&src).unwrap().to_str().unwrap();
        if place != "lib.rs" && place != "main.rs" {
            seen += 1;
            let place = place.replace('\\', "/");
            found.extend(trespasses(&place, &fs::read_to_string(path).unwrap()));
        }
    });
    assert!(seen > 20, "only {seen} files were found");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_room_has_its_floor() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let library = fs::read_to_string(src.join("lib.rs")).unwrap();
    for line in library.lines() {
        if let Some(room) = line.strip_prefix("pub mod ") {
            let room = room.trim_end_matches(';');
            assert!(floor(room).is_some(), "{room} is not on the map");
        }
    }
}

#[test]
fn a_trespass_is_found_however_it_is_written() {
    for (path, source, expected) in [
        (
            "physics/disc.rs",
            "use crate::widgets::Role;",
            "physics uses widgets",
        ),
        (
            "physics/mod.rs",
            "fn f() { crate::app::f() }",
            "physics uses app",
        ),
        (
            "quiz/mod.rs",
            "use crate::{physics::Disc, levels};",
            "quiz uses levels",
        ),
        (
            "quiz/a.rs",
            "use crate::{\n  physics::{Disc, A},\n  screens,\n};",
            "quiz uses screens",
        ),
        (
            "levels/scene.rs",
            "use super::super::quiz::Question;",
            "levels uses quiz",
        ),
        (
            "widgets/mod.rs",
            "use super::screens::Screen;",
            "widgets uses screens",
        ),
        (
            "screens/home/view.rs",
            "use super::super::super::app::App;",
            "screens uses app",
        ),
        ("app/mod.rs", "pub(crate) use crate::cli;", "app uses cli"),
    ] {
        let found = trespasses(path, source);
        assert_eq!(found, [format!("src/{path}: {expected}")]);
    }
}

#[test]
fn what_is_allowed_is_let_be() {
    for (path, source) in [
        ("cli/tape.rs", "use crate::shells::tape;"),
        (
            "quiz/mod.rs",
            "use crate::physics::Disc; use super::quiz::x;",
        ),
        (
            "physics/disc.rs",
            "/// See [`crate::widgets`].\n// crate::app\nuse crate::physics::x;",
        ),
        (
            "screens/home/view.rs",
            "use super::super::Place; use crate::screens::Context;",
        ),
        (
            "shells/tape/mod.rs",
            "use crate::{app::App, messages::{Key, Input}};",
        ),
    ] {
        assert_eq!(trespasses(path, source), Vec::<String>::new(), "{path}");
    }
}
