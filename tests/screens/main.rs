//! The app driven by keys, by the mouse and by tapes, without a terminal.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod article;
mod boards;
mod class;
mod class_devices;
mod clicks;
mod colours;
mod every_screen;
mod figures_in_chapters;
mod foil;
mod keeping;
mod key_tables;
mod lab;
mod learn;
mod levels;
mod measured;
mod notebook;
mod path;
mod quiz;
mod quiz_kinds;
mod reading;
mod rows_of_texts;
mod sheets;
mod table;
mod tape;
mod tapes;
mod teacher;

#[path = "../common/folder.rs"]
mod folder;
#[path = "../common/keys.rs"]
mod keys;
#[path = "../common/thorough.rs"]
mod thorough;
#[path = "../common/tour.rs"]
mod tour;
