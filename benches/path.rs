//! Checks that the path leads every learner to its end: `cargo bench --bench path`.
//!
//! Simulated learners start with an empty record and take one suggested step after another, until
//! every chapter is done or known and no misconception is left, and then until only the table
//! remains; one kind of learner plays only levels, whatever is suggested. The learners' bookmarks,
//! stars and answers are kept in the program's own types. `-- 10` simulates 10 learners of each
//! kind instead of 100.

use std::thread;

use carrom::path::Step;

#[path = "students/learner.rs"]
mod learner;
mod students;

use learner::{Habit, Learner};
use students::Belief;

/// More steps than any learner should need.
const MOST_STEPS: usize = 1_000;
/// How many times in a row the same step must be suggested to count as a loop.
const IN_A_ROW: usize = 8;

/// The progress of one learner.
struct Journey {
    /// The number of steps and days to the end of the chapters; `None` if the end was not reached.
    arrived: Option<(usize, i64)>,
    /// The number of steps until only the table was left; `None` if this point was not reached.
    finished: Option<usize>,
    /// The number of questions answered.
    answered: usize,
    /// The number of chapters begun.
    chapters: usize,
    /// The next step at the end of the run.
    next: String,
    looped: bool,
}

fn follow(belief: Belief, habit: Habit, seed: u64) -> Journey {
    let mut learner = Learner::new(belief, habit, seed);
    let (mut arrived, mut finished) = (None, None);
    while learner.steps.len() < MOST_STEPS && finished.is_none() {
        learner.take_step();
        if arrived.is_none() && learner.has_arrived() {
            arrived = Some((learner.steps.len(), learner.days()));
        }
        let at_table = learner.steps.last() == Some(&Step::Table);
        if at_table && (arrived.is_some() || habit == Habit::OnlyPlays) {
            finished = Some(learner.steps.len());
        }
    }
    let same = |steps: &[Step]| steps.iter().all(|it| *it == steps[0]);
    let begins = |it: &&Step| matches!(it, Step::Read { page: None, .. });
    Journey {
        arrived,
        finished,
        answered: learner.answered(),
        chapters: learner.steps.iter().filter(begins).count(),
        next: learner.next().words,
        looped: learner.steps.windows(IN_A_ROW).any(same),
    }
}

fn middle_and_most<T: Copy + Ord>(all: impl Iterator<Item = T>) -> Option<(T, T)> {
    let mut all: Vec<T> = all.collect();
    all.sort_unstable();
    Some((*all.get(all.len() / 2)?, *all.last()?))
}

fn print(name: &str, journeys: &[Journey]) {
    let arrived = journeys.iter().filter_map(|it| it.arrived);
    let steps = middle_and_most(arrived.clone().map(|(steps, _)| steps));
    let days = middle_and_most(arrived.clone().map(|(_, days)| days));
    let finished = middle_and_most(journeys.iter().filter_map(|it| it.finished));
    let answered = middle_and_most(journeys.iter().map(|it| it.answered));
    let chapters = middle_and_most(journeys.iter().map(|it| it.chapters));
    let words = |it: Option<(usize, usize)>| {
        it.map_or("-".into(), |(middle, most)| format!("{middle} / {most}"))
    };
    let days = days.map_or("-".into(), |(middle, most)| format!("{middle} / {most}"));
    println!(
        "  {name:26}{:4}  {:>11}{days:>10}{:>12}{:>12}{:>11}  {}",
        arrived.count(),
        words(steps),
        words(finished),
        words(answered),
        words(chapters),
        match journeys
            .iter()
            .find(|it| it.arrived.is_none() || it.finished.is_none() || it.looped)
        {
            None => "no plateau, no loop".to_owned(),
            Some(it) if it.looped => format!("LOOP, at: {}", it.next),
            Some(it) => format!("plateau, at: {}", it.next),
        },
    );
}

fn main() {
    let learners = std::env::args().filter_map(|arg| arg.parse().ok()).next();
    let learners: u64 = learners.unwrap_or(100);
    let mut kinds: Vec<(String, Belief, Habit)> = Belief::ALL
        .iter()
        .map(|it| (it.name().to_owned(), *it, Habit::Follows))
        .collect();
    let pauses = ("45/45, a week away", Belief::HalfAndHalf, Habit::Pauses);
    let plays = ("plays only levels", Belief::IgnoresMass, Habit::OnlyPlays);
    kinds.extend([pauses, plays].map(|(name, belief, habit)| (name.to_owned(), belief, habit)));
    println!("{learners} learners of each kind; median / maximum of those who arrive:");
    println!(
        "  {:26}{:>4}  {:>11}{:>10}{:>12}{:>12}{:>11}",
        "", "arrive", "steps", "days", "to the table", "answers", "chapters"
    );
    let journeys: Vec<Vec<Journey>> = thread::scope(|scope| {
        let halves = kinds.chunks(kinds.len().div_ceil(2));
        let of = |kinds: &[(String, Belief, Habit)]| -> Vec<Vec<Journey>> {
            let each = kinds.iter();
            each.map(|(_, belief, habit)| {
                (0..learners)
                    .map(|seed| follow(*belief, *habit, 1_000 + seed))
                    .collect()
            })
            .collect()
        };
        let running: Vec<_> = halves.map(|half| scope.spawn(move || of(half))).collect();
        running
            .into_iter()
            .flat_map(|it| it.join().unwrap_or_default())
            .collect()
    });
    for ((name, ..), journeys) in kinds.iter().zip(&journeys) {
        print(name, journeys);
    }
}
