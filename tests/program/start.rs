//! What a teacher begins with: the examples, a new file, and the guides.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use scraper::{Html, Selector};

use crate::folder::Folder;

/// Runs carrom in a folder, without a terminal.
fn carrom(folder: &Folder, arguments: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(arguments.split(' '))
        .current_dir(folder.path())
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

/// The output of a successful command.
pub(crate) fn done(folder: &Folder, arguments: &str) -> String {
    let output = carrom(folder, arguments);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments}: {message}");
    String::from_utf8(output.stdout).unwrap()
}

/// The output of a successful command that reads these lines.
pub(crate) fn done_with(folder: &Folder, arguments: &str, lines: &str) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(arguments.split(' '))
        .current_dir(folder.path())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    input.write_all(lines.as_bytes()).unwrap();
    drop(input);
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{arguments}");
    String::from_utf8(output.stdout).unwrap()
}

/// The message of a command that fails with this status.
pub(crate) fn refused(folder: &Folder, arguments: &str, status: i32) -> String {
    let output = carrom(folder, arguments);
    assert_eq!(output.status.code(), Some(status), "{arguments}");
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn every_example_passes_the_check_that_its_readme_names() {
    let folder = Folder::new("examples");
    done(&folder, "examples --out .");
    let readme = fs::read_to_string(folder.path().join("README.md")).unwrap();
    let commands: Vec<_> = readme
        .split('`')
        .filter(|code| code.starts_with("carrom ") && !code.contains("NAME"))
        .filter(|code| code.contains(" check ") || code.contains("simulate"))
        .collect();
    assert_eq!(commands.len(), 6, "{commands:?}");
    for command in commands {
        done(&folder, command.strip_prefix("carrom ").unwrap());
    }
    for file in readme
        .split('`')
        .filter(|code| code.ends_with(".toml") || code.ends_with(".md"))
    {
        let path = file.rsplit(' ').next().unwrap();
        assert!(folder.path().join(path).is_file(), "{path}");
    }
    let again = refused(&folder, "examples --out .", 1);
    assert!(
        again.contains("already exists (--force replaces it)"),
        "{again}"
    );
    done(&folder, "examples --out . --force");
}

#[test]
fn a_new_file_passes_its_check_even_with_the_longest_name() {
    let folder = Folder::new("new");
    let longest = "a-name-of-thirty-two-letters-all";
    assert_eq!(longest.len(), 32);
    for name in ["x", "our-own-2", longest] {
        for (kind, check) in [
            ("level", "level check"),
            ("chapter", "lesson check"),
            ("questions", "concept check"),
            ("set", "set check"),
        ] {
            let out = done(&folder, &format!("new {kind} {name} --out {kind}"));
            let path = out.lines().next().unwrap();
            assert_eq!(
                out.lines().nth(1),
                Some(&*format!("check it: carrom {check} {path}"))
            );
            let checked = done(&folder, &format!("{check} {path}"));
            assert!(checked.contains(name), "{checked}");
            let text = fs::read_to_string(folder.path().join(path)).unwrap();
            assert!(
                !text.contains("glance") && !text.contains("our-coins"),
                "{text}"
            );
            let again = refused(&folder, &format!("new {kind} {name} --out {kind}"), 1);
            assert!(again.contains("already exists"), "{again}");
        }
    }
    for name in ["Über", "a_b", "../x", &"x".repeat(33)] {
        let message = refused(&folder, &format!("new level {name}"), 2);
        assert!(
            message.contains("expected at most 32 lower-case letters, digits and hyphens"),
            "{message}"
        );
    }
}

#[test]
fn the_guides_link_to_one_another() {
    let folder = Folder::new("guides");
    let list = done(&folder, "guide");
    let pages = done(&folder, "guide --out guides");
    assert_eq!(pages.lines().count(), 17);
    for line in list
        .lines()
        .filter_map(|line| line.strip_prefix("  carrom guide "))
    {
        let (name, about) = line.split_once(' ').unwrap();
        assert!(
            done(&folder, &format!("guide {name}")).starts_with("# "),
            "{about}"
        );
        assert!(pages.contains(&format!("{name}.html")), "{pages}");
    }
    let links = Selector::parse("a").unwrap();
    for page in pages.lines().map(|page| folder.path().join(page)) {
        let html = Html::parse_document(&fs::read_to_string(&page).unwrap());
        for link in html.select(&links) {
            let target = page.with_file_name(link.attr("href").unwrap());
            assert!(Path::new(&target).is_file(), "{}", target.display());
        }
    }
    let message = refused(&folder, "guide physics", 2);
    assert!(
        message.contains("expected one of start, class"),
        "{message}"
    );
}
