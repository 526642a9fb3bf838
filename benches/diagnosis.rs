//! Measures how often carrom names the right misconception: `cargo bench --bench diagnosis`.
//!
//! Simulated students answer rounds of *Find out*, of the mixed course, and of the older version of
//! each; the output is the share of students whose own misconception is named first. `-- 50`
//! simulates 50 students of each kind instead of 200.

use std::thread;

use carrom::quiz::{Answer, Clue, Code, Course, CourseKind, Misconception, Round, named};

mod students;

use students::{Belief, Belief::Knows, Student};

/// Answers a whole round, and returns the evidence that the answers give.
fn play(student: &mut Student, code: Code) -> Vec<Clue> {
    let mut round = Round::of(code);
    let mut answers: Vec<Answer> = Vec::new();
    while let Some(question) = round.questions().get(answers.len()) {
        answers.push(student.answer(question));
        round.go_on(&answers);
    }
    let answered = round.questions().iter().zip(&answers);
    answered
        .map(|(question, answer)| Clue::new(question, answer))
        .collect()
}

/// The results of many students of one kind in one course.
#[derive(Default)]
struct Outcome {
    students: usize,
    /// The number of students whose misconception is named first; for students without one, the
    /// number for whom any misconception is named.
    named: usize,
    /// The misconceptions that were wrongly named first.
    others: Vec<Misconception>,
    /// How many questions the students were asked: one number per student, in ascending order.
    asked: Vec<usize>,
}

fn outcome(belief: Belief, knows: bool, course: &Course, students: u64) -> Outcome {
    let mut outcome = Outcome::default();
    for seed in 0..students {
        let mut student = Student::new(belief, knows, 1_000 + seed);
        let code = Code {
            course: course.clone(),
            seed,
        };
        let clues = play(&mut student, code);
        let first = named(&clues).first().map(|it| it.misconception);
        outcome.students += 1;
        outcome.asked.push(clues.len());
        if first.is_some() && (first == belief.right() || belief.right().is_none()) {
            outcome.named += 1;
        }
        outcome
            .others
            .extend(first.filter(|it| Some(*it) != belief.right()));
    }
    outcome.asked.sort_unstable();
    outcome
}

/// The four most frequent misconceptions in a list, each with its count.
fn counted(misconceptions: &[Misconception]) -> String {
    let count = |it: &Misconception| misconceptions.iter().filter(|other| *other == it).count();
    let mut all: Vec<_> = Misconception::ALL
        .iter()
        .map(|it| (count(it), it.id()))
        .collect();
    all.retain(|(count, _)| *count > 0);
    all.sort_by(|a, b| b.cmp(a));
    let each = all
        .iter()
        .take(4)
        .map(|(count, id)| format!("{id} {count}"));
    each.collect::<Vec<_>>().join(", ")
}

fn main() {
    let students = std::env::args().filter_map(|arg| arg.parse().ok()).next();
    let students = students.unwrap_or(200);
    let courses = [
        ("find out, at most 12", Course::new(CourseKind::FindOut)),
        (
            "older find out, at most 12",
            Course::new(CourseKind::FindOutFromAny),
        ),
        ("mixed, 20", Course::of(CourseKind::Even, 20)),
        ("mixed, 10", Course::of(CourseKind::Even, 10)),
        ("older mixed, 20", Course::of(CourseKind::Mixed, 20)),
        ("older mixed, 10", Course::of(CourseKind::Mixed, 10)),
    ];
    println!("{students} students of each kind; the share whose own misconception is named first");
    println!("(for students who know or guess: the share for whom any misconception is named)\n");
    let only = std::env::args().find_map(|arg| arg.strip_prefix("only=").map(str::to_owned));
    for (name, course) in &courses {
        if only
            .as_ref()
            .is_some_and(|only| !name.starts_with(only.as_str()))
        {
            continue;
        }
        println!("{name}");
        let kinds: Vec<(Belief, bool)> = Belief::ALL
            .into_iter()
            .flat_map(|belief| match belief.right() {
                Some(_) => vec![(belief, false), (belief, true)],
                None => vec![(belief, belief == Knows)],
            })
            .collect();
        let of = |kinds: &[(Belief, bool)]| -> Vec<Outcome> {
            let each = kinds.iter();
            each.map(|(belief, knows)| outcome(*belief, *knows, course, students))
                .collect()
        };
        let (first, second) = kinds.split_at(kinds.len() / 2);
        let outcomes: Vec<Outcome> = thread::scope(|scope| {
            let second = scope.spawn(|| of(second));
            let mut all = of(first);
            all.extend(second.join().unwrap_or_default());
            all
        });
        for ((belief, knows), outcome) in kinds.iter().zip(outcomes) {
            let elsewhere = match (belief.right(), knows) {
                (None, _) => "",
                (_, true) => "else knows",
                (_, false) => "else guesses",
            };
            println!(
                "  {:27}{elsewhere:14}{:5.1} %  median {:2} questions  {}",
                belief.name(),
                100.0 * outcome.named as f64 / outcome.students as f64,
                outcome
                    .asked
                    .get(outcome.asked.len() / 2)
                    .copied()
                    .unwrap_or(0),
                counted(&outcome.others),
            );
        }
        println!();
    }
}
