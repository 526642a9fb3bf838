//! The page in real browsers: `target/carrom.html`, opened as a file. `CARROM_TEST_PAGE` is the
//! path of the page. Each test that needs the page is ignored unless `-- --include-ignored` is
//! given; with this option, it fails if there is no page or no browser.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::env;
use std::process::Command;

mod browser;
mod chromium;
mod class;
mod figures;
mod firefox;
mod history;
mod kept;
mod safe;
mod scorm;
mod site;
mod soft_keyboard;
mod tapes;
mod touch;
mod visit;

#[allow(dead_code, reason = "other programs use the rest")]
#[path = "../common/folder.rs"]
mod folder;
#[path = "../common/handed_in.rs"]
mod handed_in;
#[path = "../common/keys.rs"]
mod keys;
#[allow(dead_code, reason = "other programs use the rest")]
#[path = "../common/teacher.rs"]
mod teacher;

/// Without a page nothing is tested, so no test may be reported as passed.
#[test]
fn no_test_of_the_page_passes_without_a_page() {
    let list = |which: &[&str]| {
        let mut this = Command::new(env::current_exe().unwrap());
        let output = this.args(which).output().unwrap();
        let output = String::from_utf8(output.stdout).unwrap();
        output.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let ignored = list(&["--list", "--format", "terse", "--ignored"]);
    assert!(!ignored.is_empty());
    let mut run = list(&["--list", "--format", "terse"]);
    run.retain(|test| !ignored.contains(test));
    assert_eq!(run, ["no_test_of_the_page_passes_without_a_page: test"]);
    let mut this = Command::new(env::current_exe().unwrap());
    this.args(["a_file_of_another_kind_is_reported", "--include-ignored"]);
    let output = this.env_remove("CARROM_TEST_PAGE").output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(said.contains("0 passed; 1 failed"), "{said}");
    assert!(said.contains(".ci/page builds it"), "{said}");
}
