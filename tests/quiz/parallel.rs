//! The parallel forms before and after a unit.

use std::collections::BTreeSet;
use std::mem::discriminant;

use carrom::quiz::{Code, Form, Question, Round};

use crate::students::{Belief, Student};

/// The seeds of the forms that the guides recommend.
const SEEDS: std::ops::RangeInclusive<u64> = 1..=12;

/// The two forms with this seed: before and after.
fn forms(seed: u64) -> [Round; 2] {
    ["before", "after"].map(|name| Round::of(Code::parse(&format!("{name}-{seed}")).unwrap()))
}

fn held(question: &Question) -> BTreeSet<&'static str> {
    question
        .beliefs
        .iter()
        .map(|it| it.misconception.id())
        .collect()
}

#[test]
fn each_question_after_is_parallel_to_the_one_before() {
    for seed in SEEDS {
        let [before, after] = forms(seed);
        assert_eq!(after.code().to_string(), format!("after-{seed}"));
        assert_eq!(
            (before.questions().len(), after.questions().len()),
            (10, 10)
        );
        for (one, other) in before.questions().iter().zip(after.questions()) {
            let kind = |it: &Question| (it.family, it.difficulty, discriminant(&it.form));
            assert_eq!(kind(one), kind(other), "{seed}");
            assert_eq!(one.topic, other.topic, "{seed}");
            assert_eq!(
                one.figures.get("asked"),
                other.figures.get("asked"),
                "{seed}"
            );
            assert_eq!(held(one), held(other), "{seed}: {}", one.text);
            // If the answer is a number, it differs, too.
            if let Form::Number { .. } = one.form {
                assert!(
                    !one.form.is_right(&other.form.truth()),
                    "{seed}: {}",
                    one.text
                );
            }
        }
        let all = before.questions().iter().chain(after.questions());
        let different: BTreeSet<_> = all.map(|it| &it.text).collect();
        assert_eq!(different.len(), 20, "{seed}");
    }
}

/// The share of right answers that many students of one kind give.
fn share_right(round: &Round, belief: Belief, knows: bool) -> f64 {
    const STUDENTS: u64 = 60;
    let mut right = 0;
    for seed in 0..STUDENTS {
        let mut student = Student::new(belief, knows, 500 + seed);
        let asked = round.questions().iter();
        right += asked
            .filter(|it| it.form.is_right(&student.answer(it).said))
            .count();
    }
    right as f64 / (STUDENTS * round.questions().len() as u64) as f64
}

/// Both forms are equally difficult for a class with every kind of simulated student.
#[test]
fn both_forms_are_equally_difficult_for_simulated_students() {
    for seed in SEEDS {
        let forms = forms(seed);
        let mut off: Vec<f64> = Vec::new();
        for belief in Belief::ALL {
            for knows in [false, true] {
                let [before, after] = forms.each_ref().map(|it| share_right(it, belief, knows));
                off.push(after - before);
            }
        }
        let mean = off.iter().sum::<f64>() / off.len() as f64;
        let most = off.iter().map(|it| it.abs()).fold(0.0, f64::max);
        println!("before-{seed}, after-{seed}: mean difference {mean:+.3}, largest {most:.3}");
        assert!(mean.abs() < 0.02 && most < 0.08, "{seed}: {mean} {most}");
    }
}
