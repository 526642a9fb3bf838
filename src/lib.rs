//! carrom: a terminal game that teaches glancing collisions.
//!
//! Aim a striker at a coin, set how far off-centre it hits, predict where both will go,
//! then watch the exact collision and its explanation.
//!
//! # Modules
//!
//! Higher modules may use lower ones, never the reverse, and modules of one layer do not
//! use each other: `tests/layers.rs` reads this map and checks every module against it.
//!
//! ```text
//!   main.rs        parse the command line, run, print the error
//!   cli/           one file per subcommand
//!   ─────────────────────────────────────────────────────────────
//!   shells/        the drivers of the app: terminal (crossterm), tape (headless script), plain
//!                  lines for screen readers (plain); a class on its own devices: the server
//!                  (host), the connection to it (client), and all in one process (classroom).
//!                  (The browser's shell is web/ beside src, a package of its own.)
//!   ─────────────────────────────────────────────────────────────
//!   store/         the data on disk: saved games, every answer (SQLite); the only module
//!                  that writes there
//!   ─────────────────────────────────────────────────────────────
//!   app/           App: the stack of screens, and what all screens share
//!   ─────────────────────────────────────────────────────────────
//!   screens/       one folder per screen: its state and actions, its view beside it
//!                  home · learn · glossary · lab · foil · quiz · class · join · table ·
//!                  rules · measured · levels · progress · teacher · settings
//!   ─────────────────────────────────────────────────────────────
//!   paper/         documents for paper: HTML that prints well, Markdown, vector pictures
//!   ─────────────────────────────────────────────────────────────
//!   widgets/       drawing: pictures as lists of marks (picture) with two
//!                  renderers (ink, svg), the hit, plots, prompts; theme
//!   ─────────────────────────────────────────────────────────────
//!   messages/      the inputs and outputs of the app: keys, effects
//!   ─────────────────────────────────────────────────────────────
//!   class/         a round for a class: participants, two votes, scores, what each question
//!                  showed; the messages between devices and the host
//!   ─────────────────────────────────────────────────────────────
//!   gradebook/     the hand-ins of a class: each pupil, each round, each question
//!   path/          a player's next step, the reason for it, and what is done
//!   ─────────────────────────────────────────────────────────────
//!   lessons/       chapters: text, figures, checkpoints  (data: assets/lessons)
//!   progress/      a player's answers, hits and observations, and what follows: topics, confidence,
//!                  misconceptions that fade, reviews that are due, the summary of a round
//!   ─────────────────────────────────────────────────────────────
//!   quiz/          questions, grading, misconceptions; concept questions in words
//!                  (data: assets/concepts, misconceptions.toml, topics.csv)
//!   game/          carrom itself: pieces, the pack, placing, the laws, the score, the
//!                  computer opponent
//!   levels/        scene and level files: format, loading, checking  (data: levels/)
//!   measure/       a filmed collision: reading its tracks, fitting them, the results
//!                  and their uncertainties
//!   beams/         particles simulated by the million and counted; Geiger and Marsden's
//!                  own counts  (data: assets/)
//!   ─────────────────────────────────────────────────────────────
//!   physics/       discs, one impact, closed forms, frames, scattering, the event-
//!                  driven engine and the exact record of a shot. Contains no game, no
//!                  terminal, no clock, no random numbers.
//!   files/         reading files from outside and reporting their errors; writing whole
//!                  files, tables and JSON
//!   ─────────────────────────────────────────────────────────────
//!   numbers        how quantities are printed: figures, units, signs
//! ```

#![cfg_attr(
    target_family = "wasm",
    allow(
        dead_code,
        unused_imports,
        reason = "the command line and the terminal use the rest"
    )
)]

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
pub mod measure;
pub mod messages;
pub(crate) mod numbers;
pub mod paper;
pub mod path;
pub mod physics;
pub mod progress;
pub mod quiz;
pub mod screens;
pub mod shells;
pub mod store;
pub mod widgets;
