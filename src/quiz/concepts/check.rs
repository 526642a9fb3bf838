//! Checks whether anything gives a right choice away, and whether the style is uniform.

use std::collections::BTreeMap;

use super::Concept;
use crate::files::FileError;

/// How many questions there must be before a pattern can be seen in them.
const ENOUGH: usize = 8;
/// A right choice stands out if it is longer or shorter than all other choices of its question by
/// more than this many letters and by more than this factor.
const STANDING_OUT: (usize, f64) = (8, 1.5);
/// The characters that end a sentence, including those of Hindi and Bengali, Chinese, Arabic and
/// Urdu.
const STOPS: [char; 8] = ['.', '?', '!', '।', '。', '？', '！', '؟'];
/// Words that make a choice sound wrong.
const BROAD: [&str; 3] = ["always", "never", "nothing can"];

/// All faults of these questions: those of each question and, if there are at least eight
/// questions, those of all of them together.
pub fn check(concepts: &[Concept]) -> Vec<FileError> {
    let mut faults: Vec<FileError> = concepts.iter().flat_map(Concept::check).collect();
    let Some(first) = concepts.first().filter(|_| concepts.len() >= ENOUGH) else {
        return faults;
    };
    let together = [lengths(concepts), places(concepts), words(concepts)];
    let together = together.into_iter().flatten();
    // No single question is at fault, so no line can be named.
    faults.extend(together.map(|message| FileError::of_file(&first.file, message)));
    faults
}

impl Concept {
    /// The faults of this question.
    fn check(&self) -> Vec<FileError> {
        let mut faults = Vec::new();
        let mut found = |field: &str, message: String| faults.push(self.fault(field, message));
        if let Some(message) = self.stands_out() {
            found("right", message);
        }
        let says = self.wrongs.iter().map(|wrong| ("says", &wrong.says));
        for (field, text) in [("ask", &self.ask), ("why", &self.why)]
            .into_iter()
            .chain(says)
        {
            let end = text.trim_end_matches(['”', '"', '」', '»']);
            if !end.ends_with(STOPS) {
                found(field, format!("expected whole sentences, found \"{text}\""));
            }
        }
        for (text, _) in self.choices() {
            if text.ends_with(['.', '।', '。']) {
                found("choice", format!("expected no full stop after \"{text}\""));
            }
        }
        for wrong in &self.wrongs {
            if let Some([right, other]) = figures(&self.right, &wrong.choice)
                && (right - other).abs() <= 0.1 * right.max(other)
            {
                let message =
                    format!("expected clearly different figures, found {right} and {other}");
                found("choice", message);
            }
        }
        if self.hit.is_some_and(|hit| !hit.outcome().hit()) {
            found(
                "hit",
                "expected discs that collide; these miss each other".into(),
            );
        }
        faults
    }

    /// A message if the right choice is given away by its length alone.
    fn stands_out(&self) -> Option<String> {
        let (by, factor) = STANDING_OUT;
        let [right, least, most] = self.letters();
        let beyond =
            |short: usize, long: usize| long > short + by && long as f64 > factor * short as f64;
        let which = if beyond(most, right) {
            "longest"
        } else if beyond(right, least) {
            "shortest"
        } else {
            return None;
        };
        Some(format!(
            "expected a right choice about as long as the others, found the {which} by far: \
             {right} letters, the others {least}-{most}"
        ))
    }

    /// The numbers of letters of the right choice and of the shortest and the longest wrong one.
    fn letters(&self) -> [usize; 3] {
        let wrongs = self.wrongs.iter().map(|wrong| letters(&wrong.choice));
        let (least, most) = (wrongs.clone().min(), wrongs.max());
        [Some(letters(&self.right)), least, most].map(Option::unwrap_or_default)
    }
}

fn letters(text: &str) -> usize {
    text.chars().count()
}

/// How many questions are answered correctly by always choosing the longest or the shortest
/// choice, compared with blind guessing.
fn lengths(concepts: &[Concept]) -> Vec<String> {
    let count = concepts.len() as f64;
    let choices = concepts.iter().map(|it| it.choices().len() as f64);
    let fair = choices.map(|all| 1.0 / all).sum::<f64>();
    let won =
        |wins: fn([usize; 3]) -> bool| concepts.iter().filter(|it| wins(it.letters())).count();
    let mut faults = Vec::new();
    for (which, won) in [
        ("longest", won(|[right, _, most]| right > most)),
        ("shortest", won(|[right, least, _]| right < least)),
    ] {
        if won as f64 > fair {
            faults.push(format!(
                "the right choice is the {which} in {won} of {count} questions; guessing \
                 wins {fair:.0}"
            ));
        }
    }
    let mean = |concept: &Concept| {
        let sum: usize = concept.wrongs.iter().map(|it| letters(&it.choice)).sum();
        sum as f64 / concept.wrongs.len() as f64
    };
    let right: usize = concepts.iter().map(|concept| letters(&concept.right)).sum();
    let ratio = right as f64 / concepts.iter().map(mean).sum::<f64>();
    if (ratio - 1.0).abs() > 0.1 {
        faults.push(format!(
            "right choices have {ratio:.2} times as many letters as wrong ones"
        ));
    }
    faults
}

/// Whether the right choice is in the same place too often among questions whose choices have a
/// natural order; the choices of all others are shuffled.
fn places(concepts: &[Concept]) -> Vec<String> {
    let ordered: Vec<_> = concepts.iter().filter(|concept| concept.ordered).collect();
    let mut places: BTreeMap<usize, usize> = BTreeMap::new();
    for concept in &ordered {
        *places.entry(concept.before_right).or_default() += 1;
    }
    let often = places
        .into_iter()
        .filter(|(_, count)| ordered.len() >= ENOUGH && 2 * count > ordered.len());
    often
        .map(|(place, count)| {
            format!(
                "the right choice is number {} in {count} of {} questions whose choices \
                 have an order",
                place + 1,
                ordered.len()
            )
        })
        .collect()
}

/// Whether choices are given away by a first word that is found mostly in right ones, or by
/// "always" and "never" in wrong ones.
fn words(concepts: &[Concept]) -> Vec<String> {
    let mut begin: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for (text, wrong) in concepts.iter().flat_map(Concept::choices) {
        let first = text.split_whitespace().next().unwrap_or_default();
        let (right, of) = begin.entry(first).or_default();
        *right += usize::from(wrong.is_none());
        *of += 1;
    }
    let mut faults = Vec::new();
    for (word, (right, of)) in begin {
        if of >= 4 && 2 * right > of {
            faults.push(format!(
                "of {of} choices that begin with \"{word}\", {right} are right"
            ));
        }
    }
    let broad = |text: &str| BROAD.iter().any(|word| text.to_lowercase().contains(word));
    let wrongs = concepts.iter().flat_map(|concept| &concept.wrongs);
    let revealed = wrongs.filter(|wrong| broad(&wrong.choice)).count();
    if revealed > concepts.len() / 10 {
        faults.push(format!("{revealed} wrong choices say always or never"));
    }
    faults
}

/// The figures of two choices that are otherwise identical.
fn figures(a: &str, b: &str) -> Option<[f64; 2]> {
    let figure = |c: char| c.is_ascii_digit() || c == '.';
    let only = |text: &str| {
        let numbers = text
            .split(|c| !figure(c))
            .filter_map(|part| part.parse().ok());
        let numbers: Vec<f64> = numbers.collect();
        match numbers[..] {
            [number] => Some(number),
            _ => None,
        }
    };
    let (first, second) = (only(a)?, only(b)?);
    (a.replace(figure, "") == b.replace(figure, "")).then_some([first, second])
}
