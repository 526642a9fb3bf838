//! What a class has learnt between the two parallel forms of a test.

use std::collections::BTreeSet;

use super::gain::{NoGain, NormalizedGain};
use super::{ClassResults, Pupil, PupilResults};
use crate::progress::{Attempt, HeldBelief};
use crate::quiz::{Clue, Code, Course, CourseKind, Evidence, Misconception};

/// The results of a class in the forms before and after a unit.
#[derive(Debug, Clone)]
pub struct Learning<'a> {
    /// The codes of both forms.
    pub codes: [String; 2],
    /// The number of questions in each form.
    pub count: usize,
    /// The pupils who answered every question of both forms.
    pub matched: Vec<Matched<'a>>,
    /// The number of pupils who answered only some of these questions.
    pub others: usize,
    /// The misconceptions that the matched pupils could have shown in both forms, and showed in at
    /// least one, with the evidence from each form.
    pub beliefs: Vec<HeldBelief>,
    /// The gain of the class, or why there is none.
    pub gain: Result<NormalizedGain, NoGain>,
}

/// A pupil who answered every question of both forms.
#[derive(Debug, Clone, Copy)]
pub struct Matched<'a> {
    /// The pupil.
    pub pupil: &'a Pupil,
    /// The number of right answers before and after.
    pub right: [usize; 2],
}

/// The results of each pair of forms that any pupil has begun, sorted by seed and number of
/// questions.
pub fn learning<'a>(results: &ClassResults<'a>) -> Vec<Learning<'a>> {
    let begun = results.rounds().into_iter().filter_map(Code::parse);
    let pairs = begun.filter_map(|code| {
        let is_form = matches!(code.course.kind, CourseKind::Before | CourseKind::After);
        is_form.then_some((code.seed, code.course.count))
    });
    let pairs: BTreeSet<(u64, usize)> = pairs.collect();
    { pairs.into_iter() }
        .map(|(seed, count)| of_pair(results, seed, count))
        .collect()
}

fn of_pair<'a>(results: &ClassResults<'a>, seed: u64, count: usize) -> Learning<'a> {
    let codes = [CourseKind::Before, CourseKind::After].map(|kind| {
        let course = Course::of(kind, count);
        Code { course, seed }.to_string()
    });
    let mut matched = Vec::new();
    let mut clues: [Vec<Clue>; 2] = Default::default();
    let mut others = 0;
    for pupil in &results.pupils {
        let forms = codes.each_ref().map(|code| answers(pupil, code));
        if forms.iter().all(|it| it.len() == count) {
            matched.push(Matched {
                pupil: pupil.pupil,
                right: forms
                    .each_ref()
                    .map(|it| it.iter().filter(|it| it.right).count()),
            });
            for (clues, form) in clues.iter_mut().zip(&forms) {
                clues.extend(form.iter().map(|it| it.clue()));
            }
        } else if forms.iter().any(|it| !it.is_empty()) {
            others += 1;
        }
    }
    let scores: Vec<[f64; 2]> = { matched.iter() }
        .map(|it: &Matched<'_>| it.right.map(|right| right as f64 / count as f64))
        .collect();
    Learning {
        count,
        others,
        beliefs: changes(&clues),
        gain: NormalizedGain::of(&scores),
        matched,
        codes,
    }
}

/// A pupil's first answers to the questions of a form, each question once.
fn answers<'a>(pupil: &PupilResults<'a>, code: &str) -> Vec<&'a Attempt> {
    let mut numbers = BTreeSet::new();
    let of_form = pupil.answers.iter().filter(|(_, round)| round == code);
    { of_form.map(|(it, _)| *it) }
        .filter(|it| numbers.insert(it.number))
        .collect()
}

/// The misconceptions that answers to both forms could show and that at least one answer fits,
/// sorted by how often they occurred before the unit, the most frequent first.
fn changes([before, after]: &[Vec<Clue>; 2]) -> Vec<HeldBelief> {
    let change = |misconception: &Misconception| HeldBelief {
        misconception: *misconception,
        before: Evidence::of(*misconception, before),
        since: Evidence::of(*misconception, after),
    };
    let times = |it: &HeldBelief| [it.before.times, it.since.times];
    let mut all: Vec<_> = Misconception::ALL.iter().map(change).collect();
    all.retain(|it| it.before.asked > 0 && it.since.asked > 0 && times(it) != [0, 0]);
    all.sort_by_key(|it| std::cmp::Reverse(times(it)));
    all
}
