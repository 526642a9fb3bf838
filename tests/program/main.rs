//! Runs the program as a person or a script does, with arguments or in a real terminal, and checks
//! its output and the files it writes, even when it is killed at a random moment.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod at_once;
mod bad_files;
mod bad_lessons;
mod bad_levels;
mod bookmarks;
mod child;
mod cli;
#[cfg(target_os = "linux")]
mod crowd;
mod damaged_files;
#[cfg(unix)]
mod forget;
mod freeze;
#[cfg(target_os = "linux")]
mod full_disk;
mod gather;
mod hosted;
#[cfg(target_os = "linux")]
mod idle;
#[cfg(unix)]
mod kill;
mod measure;
mod memory;
mod moodle;
#[cfg(target_os = "linux")]
mod noise;
mod old_files;
mod page;
mod plain;
mod plain_all;
mod play;
mod rebound;
mod report;
mod safe;
mod salvage;
mod saves;
#[cfg(target_os = "linux")]
mod seen_devices;
mod sets;
mod simulate;
mod solve;
mod start;
#[cfg(unix)]
mod terminal;
#[cfg(target_os = "linux")]
mod unsaved;
mod worksheet;
mod written;

#[cfg(target_os = "linux")]
#[allow(dead_code, reason = "the tests of the page use the rest")]
#[path = "../page/browser.rs"]
mod browser;
#[cfg(target_os = "linux")]
#[allow(dead_code, reason = "the tests of the page use the rest")]
#[path = "../page/chromium.rs"]
mod chromium;
#[path = "../common/damage.rs"]
mod damage;
#[path = "../common/folder.rs"]
mod folder;
#[path = "../common/handed_in.rs"]
mod handed_in;
#[path = "../common/keys.rs"]
mod keys;
#[cfg(unix)]
#[path = "../common/pty.rs"]
mod pty;
#[path = "../common/pupil.rs"]
mod pupil;
#[path = "../common/teacher.rs"]
mod teacher;
#[path = "../common/thorough.rs"]
mod thorough;
