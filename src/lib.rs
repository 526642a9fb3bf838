//! carrom: a terminal game that teaches glancing collisions.
//!
//! Aim a striker at a coin, set how far off-centre it hits, say first where both
//! will go, then watch the exact collision explain itself.
//!
//! # The house
//!
//! Higher rooms may use lower ones, never the reverse, and rooms of one floor do not
//! know each other: `tests/layers.rs` reads this map and holds every room to it.
//!
//! ```text
//!   main.rs        parse the command line, run, print the error
//!   cli/           one file a subcommand
//!   ─────────────────────────────────────────────────────────────
//!   shells/        what drives the app: terminal (crossterm), tape (headless script), plain
//!                  lines for screen readers (plain); a class on its own devices: the server
//!                  (host), the connection to it (client), and all in one process (classroom).
//!                  (The browser's shell is web/ beside src, a package of its own.)
//!   ─────────────────────────────────────────────────────────────
//!   store/         what is kept on disk: saved games, every answer (SQLite); the only
//!                  room that writes there
//!   ─────────────────────────────────────────────────────────────
//!   app/           App: the stack of screens, what every screen shares
//!   ─────────────────────────────────────────────────────────────
//!   screens/       one folder a screen: its state and update, its view beside it
//!                  home · learn · lab · foil · quiz · class · join · table · levels ·
//!                  progress · settings
//!   paper/         documents for paper: HTML that prints well, Markdown, vector pictures
//!   ─────────────────────────────────────────────────────────────
//!   widgets/       the drawn things: pictures as lists of marks (picture) with two
//!                  renderers (ink, svg), the hit, plots, prompts; theme
//!   ─────────────────────────────────────────────────────────────
//!   messages/      what goes into the app and what comes out: keys, effects
//!   ─────────────────────────────────────────────────────────────
//!   class/         a round for a class: who votes and how, two votes, scores, what each
//!                  question showed; what devices and the host say to each other
//!   ─────────────────────────────────────────────────────────────
//!   gradebook/     what a class has handed in: each pupil, each round, each question
//!   ─────────────────────────────────────────────────────────────
//!   lessons/       chapters: text, figures, checkpoints  (data: assets/lessons)
//!   progress/      what a player has done, and what follows from it: topics, confidence,
//!                  misconceptions that fade, what is due
//!   ─────────────────────────────────────────────────────────────
//!   quiz/          questions, grading, misconceptions; concept questions in words
//!                  (data: assets/concepts)
//!   game/          carrom itself: pieces, the pack, placing, the laws, the score, the
//!                  computer opponent
//!   levels/        scene and level files: format, loading, checking  (data: levels/)
//!   beams/         particles thrown by the million and counted; Geiger and Marsden's
//!                  own counts  (data: assets/)
//!   ─────────────────────────────────────────────────────────────
//!   physics/       discs, one impact, closed forms, frames, scattering, the event-
//!                  driven engine and the exact record of a shot. Knows no game, no
//!                  terminal, no clock, no random numbers.
//!   files/         how any file from outside is read, how its faults are told, and how
//!                  whole files, tables and JSON are written
//!   ─────────────────────────────────────────────────────────────
//!   numbers        how quantities are printed: figures, units, signs
//! ```

pub mod app;
pub mod beams;
pub mod class;
#[cfg(not(target_family = "wasm"))]
pub mod cli;
pub mod files;
pub mod game;
pub mod gradebook;
pub mod lessons;
pub mod levels;
pub mod messages;
pub(crate) mod numbers;
pub mod paper;
pub mod physics;
pub mod progress;
pub mod quiz;
pub mod screens;
pub mod shells;
pub mod store;
pub mod widgets;
