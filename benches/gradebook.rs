//! Measures how long it takes to make a gradebook, and shows whether this time grows no faster than
//! the class: `cargo bench --bench gradebook`.
//!
//! Classes of 10, 20, 40 and 60 pupils answer 30 rounds of ten questions each. For each size,
//! the work of `carrom gather` is timed, from the bytes of the files to the finished document; the
//! last column compares the time per pupil with that of the smallest class. Another file contains
//! 5,000 rounds.

use std::hint::black_box;
use std::time::{Duration, Instant};

use carrom::gradebook::{Gradebook, HandIn, beliefs_csv, items_csv, pupils_csv};
use carrom::paper::gradebook::html;
use carrom::progress::Attempt;
use carrom::quiz::{Answer, Code, Confidence, Round};

const ROUNDS: u64 = 30;
const CLASSES: [usize; 4] = [10, 20, 40, 60];
/// The number of rounds in the one large file.
const MANY_ROUNDS: u64 = 5_000;
/// The number of runs of each measurement; the best is printed.
const RUNS: usize = 3;

/// The answers of one pupil to these rounds. Neighbouring pupils give wrong answers to different
/// questions.
fn answers(rounds: &[Round], pupil: usize) -> Vec<Attempt> {
    let mut all = Vec::new();
    for round in rounds {
        for (number, question) in (1..).zip(round.questions()) {
            let said = match question.beliefs.first() {
                Some(belief) if (pupil + all.len()).is_multiple_of(3) => belief.said,
                _ => question.form.truth(),
            };
            let answer = Answer::new(said, Confidence::Sure);
            let time_s = 1_770_000_000 + 100_000 * pupil as i64 + 60 * all.len() as i64;
            all.push(Attempt {
                time_s: Some(time_s),
                ..Attempt::of_quiz("", round.code(), number, question, &answer)
            });
        }
    }
    all
}

/// The bytes of a pupil's file.
fn file(pupil: usize, answers: Vec<Attempt>) -> Vec<u8> {
    let hand_in = HandIn::new(&format!("Pupil {pupil}"), "10b", answers);
    hand_in.text().expect("a hand-in is text").into_bytes()
}

fn gathered(files: &[Vec<u8>]) -> Gradebook {
    let mut book = Gradebook::default();
    for file in files {
        book.add("a file", HandIn::read(file));
    }
    book
}

fn tables(book: &Gradebook) -> [Result<String, String>; 3] {
    let results = book.results();
    [
        pupils_csv(&results),
        items_csv(&results),
        beliefs_csv(&results),
    ]
}

fn best<T>(work: impl Fn() -> T) -> Duration {
    let mut shortest = Duration::MAX;
    for _ in 0..RUNS {
        let start = Instant::now();
        black_box(work());
        shortest = shortest.min(start.elapsed());
        // A measurement that takes this long is not repeated.
        if shortest > Duration::from_secs(5) {
            break;
        }
    }
    shortest
}

fn main() {
    let codes = (1..=ROUNDS).filter_map(|seed| Code::parse(&format!("mixed-{seed}")));
    let rounds: Vec<Round> = codes.map(Round::of).collect();
    println!("pupils × {ROUNDS} rounds   HTML        CSV         HTML per pupil / first row");
    let mut first = None;
    for pupils in CLASSES {
        let files: Vec<_> = (0..pupils)
            .map(|it| file(it, answers(&rounds, it)))
            .collect();
        let page = best(|| html(&gathered(&files).results())).as_secs_f64();
        let csv = best(|| tables(&gathered(&files))).as_secs_f64();
        let each = page / pupils as f64;
        let first = *first.get_or_insert(each);
        println!(
            "{pupils:>6}               {page:>7.3} s   {csv:>7.3} s   {:.2}",
            each / first
        );
    }
    let one = answers(&rounds[..1], 0);
    let many = (1..=MANY_ROUNDS).filter_map(|seed| {
        let answer = one.first()?;
        let mut question = answer.question.clone();
        question.insert("round".into(), format!("mixed-{seed}").into());
        Some(Attempt {
            seed,
            question,
            ..answer.clone()
        })
    });
    let large = [file(0, many.collect())];
    let page = best(|| html(&gathered(&large).results())).as_secs_f64();
    let csv = best(|| tables(&gathered(&large))).as_secs_f64();
    let megabytes = large[0].len() as f64 / 1e6;
    println!(
        "one file of {MANY_ROUNDS} rounds, {megabytes:.1} MB: HTML {page:.3} s, CSV {csv:.3} s"
    );
}
