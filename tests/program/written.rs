//! Files that carrom writes: none is replaced without --force, and none is left incomplete.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::folder::Folder;

fn carrom(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carrom"));
    command.args(arguments).args(["--data-dir", "data"]);
    run(command, folder)
}

fn run(mut command: Command, folder: &Path) -> Output {
    let command = command.current_dir(folder).stdin(Stdio::null());
    command.output().unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// All files in a folder and its subfolders, with their contents.
fn all(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(all(&path));
        } else {
            files.push((path.to_str().unwrap().into(), fs::read(&path).unwrap()));
        }
    }
    files.sort();
    files
}

#[test]
fn reports_and_figures_are_replaced_only_with_force() {
    let folder = Folder::new("written");
    for (arguments, file) in [
        (&["progress", "--report", "a.html"][..], "a.html"),
        (&["progress", "--report", "a.md"], "a.md"),
        (&["figure", "curves", "--svg", "a.svg"], "a.svg"),
    ] {
        let path = folder.path().join(file);
        fs::write(&path, "mine").unwrap();
        let output = carrom(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(1), "{file}");
        let expected = format!("carrom: {file} already exists (--force replaces it)\n");
        assert_eq!(err(&output), expected);
        assert_eq!(fs::read(&path).unwrap(), b"mine", "{file}");
        let output = carrom(folder.path(), &[arguments, &["--force"]].concat());
        assert!(output.status.success(), "{}", err(&output));
        assert_ne!(fs::read(&path).unwrap(), b"mine", "{file}");
    }
    let nowhere = ["figure", "lab", "--svg", "no/such/a.svg"];
    let output = carrom(folder.path(), &nowhere);
    assert!(err(&output).contains("cannot write no/such/a.svg"));
    assert!(!folder.path().join("no").exists());
}

/// Existing files in the folder of the pictures are protected too.
#[test]
fn pictures_beside_a_report_are_replaced_only_with_force() {
    let folder = Folder::new("written-pictures");
    let round = ["quiz", "--plain", "--code", "quick-3", "--data-dir", "data"];
    let mut child = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(round)
        .current_dir(folder.path())
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let mut said = child.stdin.take().unwrap();
    for _ in 0..40 {
        // The program may have ended already.
        let _ = std::io::Write::write_all(&mut said, b"1\n");
    }
    drop(said);
    child.wait().unwrap();
    let report = ["progress", "--report", "me.md"];
    assert!(carrom(folder.path(), &report).status.success());
    let pictures = folder.path().join("me-pictures");
    let name = fs::read_dir(&pictures).unwrap().next().unwrap().unwrap();
    fs::write(name.path(), "mine").unwrap();
    fs::remove_file(folder.path().join("me.md")).unwrap();
    let output = carrom(folder.path(), &report);
    assert_eq!(output.status.code(), Some(1));
    assert!(err(&output).contains("me-pictures"), "{}", err(&output));
    assert_eq!(fs::read(name.path()).unwrap(), b"mine");
    assert!(!folder.path().join("me.md").exists());
}

#[test]
fn a_worksheet_leaves_no_file_of_the_previous_one() {
    let folder = Folder::new("written-worksheet");
    let sheet = |arguments: &[&str]| {
        let all = [&["worksheet", "--seed", "7", "--out", "w"], arguments].concat();
        let output = carrom(folder.path(), &all);
        assert!(output.status.success(), "{}", err(&output));
        let names = all_names(&folder.path().join("w"));
        names
            .into_iter()
            .filter(|name| name != "mine.svg")
            .collect()
    };
    let _: Vec<String> = sheet(&["--count", "12"]);
    fs::write(folder.path().join("w/pictures/mine.svg"), "mine").unwrap();
    for arguments in [&["--count", "3"][..], &["--count", "2", "--with-key"]] {
        let over: Vec<String> = sheet(&[arguments, &["--force"]].concat());
        let mine = fs::read(folder.path().join("w/pictures/mine.svg"));
        assert_eq!(mine.unwrap(), b"mine");
        let alone = Folder::new("written-worksheet-alone");
        let new = ["worksheet", "--seed", "7", "--out", "w"];
        carrom(alone.path(), &[&new[..], arguments].concat());
        assert_eq!(over, all_names(&alone.path().join("w")));
    }
}

fn all_names(folder: &Path) -> Vec<String> {
    let files = all(folder).into_iter();
    let names = files.map(|(path, _)| path.rsplit('/').next().unwrap().to_owned());
    names.collect()
}

/// The test cannot fill a disk, so it limits the size of files instead.
#[cfg(unix)]
#[test]
fn a_failed_write_leaves_everything_unchanged() {
    let folder = Folder::new("written-full");
    let path = folder.path();
    fs::write(path.join("a.html"), "old").unwrap();
    fs::write(path.join("a.svg"), "old").unwrap();
    let sheet = ["worksheet", "--seed", "7", "--count", "2", "--out", "w"];
    assert!(carrom(path, &sheet).status.success());
    let before = all(path);
    let again = ["worksheet", "--seed", "8", "--count", "9", "--force"];
    for arguments in [
        &["progress", "--report", "a.html", "--force"][..],
        &["figure", "lab", "--svg", "a.svg", "--force"],
        &[&again[..], &["--out", "w"]].concat(),
        &[&again[..], &["--out", "new/sheets"]].concat(),
    ] {
        let mut command = Command::new("sh");
        let limited = "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\"";
        command.args(["-c", limited, env!("CARGO_BIN_EXE_carrom")]);
        command.args(arguments).args(["--data-dir", "data"]);
        let output = run(command, path);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(err(&output).contains("cannot write"), "{}", err(&output));
        assert!(all(path) == before, "{arguments:?} left something");
    }
    assert!(!path.join("new").exists());
}

/// A device is written to directly and never replaced.
#[cfg(unix)]
#[test]
fn output_to_a_device_is_written_directly() {
    let folder = Folder::new("written-device");
    let figure = ["figure", "lab", "--svg", "/dev/null"];
    let output = carrom(folder.path(), &figure);
    assert!(output.status.success(), "{}", err(&output));
    let output = carrom(folder.path(), &["figure", "lab", "--svg", "/dev/stdout"]);
    assert!(output.stdout.starts_with(b"<svg"), "{}", err(&output));
}

/// A link is followed, and stays a link.
#[cfg(unix)]
#[test]
fn the_target_of_a_link_is_replaced() {
    let folder = Folder::new("written-link");
    let (real, link) = (folder.path().join("real.svg"), folder.path().join("a.svg"));
    fs::write(&real, "old").unwrap();
    std::os::unix::fs::symlink("real.svg", &link).unwrap();
    let figure = ["figure", "lab", "--svg", "a.svg", "--force"];
    assert!(carrom(folder.path(), &figure).status.success());
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(fs::read(&real).unwrap().starts_with(b"<svg"));
}
