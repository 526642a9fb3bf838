//! The quiz without a screen: every family of questions, whole rounds, their codes, and class
//! rounds.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod asked;
mod attributed;
mod class_report;
mod class_round;
mod codes;
mod families;
mod find_out;
mod forms;
mod frozen;
mod parallel;
mod path;
mod readability;
mod rounds;
#[path = "../../benches/students/mod.rs"]
mod students;
#[path = "../common/thorough.rs"]
mod thorough;
mod working;

use carrom::quiz::{Dice, Difficulty, Family, Question};

/// The questions of every family and difficulty with seeds below `seeds`.
fn questions(seeds: u64) -> impl Iterator<Item = (Family, u64, Question)> {
    let families = Family::ALL.iter();
    let kinds = families.flat_map(|family| Difficulty::ALL.map(|it| (*family, it)));
    kinds.flat_map(move |(family, difficulty)| {
        let ask = move |seed| family.ask(difficulty, &mut Dice::new(seed)).unwrap();
        (0..seeds).map(move |seed| (family, seed, ask(seed).0))
    })
}
