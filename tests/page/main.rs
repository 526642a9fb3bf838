//! The page in real browsers: `target/carrom.html`, opened from its file. `CARROM_TEST_PAGE`
//! names it; without one, or where there is no browser, each test says so.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod browser;
mod chromium;
mod class;
mod figures;
mod firefox;
mod kept;
mod safe;
mod tapes;
mod touch;

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
