//! Checks that nothing gives the right choices away, and that the style is uniform.

use std::collections::BTreeMap;

use super::Concept;
use super::read::WRONGS;
use crate::files::FileError;

/// Patterns across all questions are checked only if there are at least this many questions.
const ENOUGH: usize = 8;
/// A right choice stands out if it is longer than every wrong choice, or shorter than every wrong
/// choice, by more than this number of letters and by more than this factor.
const STANDING_OUT: (usize, f64) = (8, 1.5);
/// The characters that end a sentence, including those used in Hindi, Bengali, Chinese, Arabic and
/// Urdu.
const STOPS: [char; 9] = ['.', '?', '!', '।', '。', '？', '！', '؟', '۔'];
/// Words that make a choice sound wrong.
const BROAD: [&str; 3] = ["always", "never", "nothing can"];

/// All faults found in these questions: the faults of each question and, if there are at least
/// eight questions, the patterns across all of them.
pub fn check(concepts: &[Concept]) -> Vec<FileError> {
    let mut faults: Vec<FileError> = concepts.iter().flat_map(Concept::check).collect();
    let Some(first) = concepts.first().filter(|_| concepts.len() >= ENOUGH) else {
        return faults;
    };
    let together = [lengths(concepts), places(concepts), words(concepts)];
    let together = together.into_iter().flatten();
    // A pattern is not the fault of any single question, so the errors have no line number.
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
        let texts = [("ask", &self.ask), ("why", &self.why)].into_iter();
        let says = self.wrongs.iter().map(|wrong| ("says", &wrong.says));
        for (field, text) in texts.chain(says) {
            let end = text.trim_end_matches(['”', '"', '」', '»']);
            if !end.ends_with(STOPS) {
                found(field, format!("expected whole sentences, found \"{text}\""));
            }
        }
        for (text, _) in self.choices() {
            if text.ends_with(['.', '।', '。', '۔']) {
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
            let message = "expected discs that collide; these miss each other";
            found("hit", message.into());
        }
        faults
    }

    /// Returns a message if the right choice can be recognized by its length alone.
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

    /// The number of letters of the right choice, of the shortest wrong choice and of the longest
    /// wrong choice.
    fn letters(&self) -> [usize; 3] {
        let wrongs = self.wrongs.iter().map(|wrong| letters(&wrong.choice));
        let (least, most) = (wrongs.clone().min(), wrongs.max());
        [Some(letters(&self.right)), least, most].map(Option::unwrap_or_default)
    }
}

fn letters(text: &str) -> usize {
    text.chars().count()
}

/// Checks whether always taking the longest or the shortest choice beats blind guessing, and
/// whether the mean lengths of right and of wrong choices differ by more than a tenth.
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

/// Checks whether the right choice is too often in the same position. This concerns only questions
/// whose choices have a natural order; the choices of all other questions are shuffled.
fn places(concepts: &[Concept]) -> Vec<String> {
    let ordered: Vec<_> = concepts.iter().filter(|concept| concept.ordered).collect();
    let all = ordered.len();
    let fault = |number: usize| {
        let right = ordered.iter().map(|it| it.before_right + 1);
        let count = right.filter(|it| *it == number).count();
        let often = all >= ENOUGH && 2 * count > all;
        often.then(|| {
            format!(
                "the right choice is number {number} in {count} of {all} questions whose choices \
                 have an order"
            )
        })
    };
    (1..=WRONGS.end() + 1).filter_map(fault).collect()
}

/// Checks whether choices are given away by a first word that occurs mostly in right choices, or by
/// "always" and "never" in wrong choices.
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

/// The figures in two choices whose texts are otherwise identical.
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
