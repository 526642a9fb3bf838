//! Holds the questions in the program to what makes a good question.

use std::collections::{BTreeMap, BTreeSet};

use super::*;
use crate::physics::named::Constant;
use crate::physics::units::deg_from_rad;
use crate::physics::{RestingTarget, resting_target::LargestDeflection};
use crate::quiz::misconceptions;

/// Letters of a text.
fn letters(text: &str) -> usize {
    text.chars().count()
}

#[test]
fn nothing_is_wrong_with_the_files() {
    if let Err(fault) = embedded() {
        panic!("{fault}");
    }
}

#[test]
fn there_are_sixty_and_more_with_ids_of_their_own() {
    let ids: BTreeSet<_> = all().iter().map(|concept| &concept.id).collect();
    assert_eq!(ids.len(), all().len());
    assert!(ids.len() >= 60, "{}", ids.len());
    assert!(ids.iter().all(|id| with_id(id).is_some()));
}

/// A code of a round counts on this order; what is new goes to the end.
#[test]
fn the_order_laid_down_stays() {
    for (place, id) in [
        (0, "sideways-balances"),
        (13, "a-test-for-the-formula"),
        (26, "coin-on-the-left"),
        (42, "light-head-on"),
        (56, "square-in-spite-of-loss"),
        (70, "square-on-the-board"),
        (88, "one-in-8000"),
        (94, "off-the-line"),
        (96, "turn-seen-from-the-centre"),
    ] {
        assert_eq!(all()[place].id, id, "{place}");
    }
}

#[test]
fn every_misconception_is_met_twice() {
    let mut met: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for concept in all() {
        for belief in concept
            .wrongs
            .iter()
            .filter_map(|wrong| wrong.misconception)
        {
            met.entry(belief.id).or_default().insert(&concept.id);
        }
    }
    for belief in misconceptions::all() {
        let count = met.get(belief.id).map_or(0, BTreeSet::len);
        assert!(count >= 2, "{} is met {count} times", belief.id);
    }
}

/// The share of questions whose right choice would win by a rule of thumb.
fn won_by(rule: impl Fn(usize, &[usize]) -> bool) -> f64 {
    let won = all().iter().filter(|concept| {
        let others: Vec<_> = concept
            .wrongs
            .iter()
            .map(|wrong| letters(&wrong.choice))
            .collect();
        rule(letters(&concept.right), &others)
    });
    won.count() as f64 / all().len() as f64
}

/// The share that blind guessing would win.
fn fair_share() -> f64 {
    let sum: f64 = all()
        .iter()
        .map(|concept| 1.0 / concept.choices().len() as f64)
        .sum();
    sum / all().len() as f64
}

#[test]
fn no_length_gives_the_right_choice_away() {
    let fair = fair_share();
    let longest = won_by(|right, others| others.iter().all(|other| right > *other));
    let shortest = won_by(|right, others| others.iter().all(|other| right < *other));
    assert!(longest <= fair, "the longest: {longest}, fair: {fair}");
    assert!(shortest <= fair, "the shortest: {shortest}, fair: {fair}");
    let (mut right, mut others) = (0.0, 0.0);
    for concept in all() {
        right += letters(&concept.right) as f64;
        let sum: usize = concept.wrongs.iter().map(|w| letters(&w.choice)).sum();
        others += sum as f64 / concept.wrongs.len() as f64;
    }
    assert!((right / others - 1.0).abs() <= 0.1, "{right} to {others}");
}

#[test]
fn no_place_gives_the_right_choice_away() {
    let mut places: BTreeMap<usize, usize> = BTreeMap::new();
    let ordered: Vec<_> = all().iter().filter(|concept| concept.ordered).collect();
    for concept in &ordered {
        let place = concept
            .choices()
            .iter()
            .position(|choice| choice.is_right());
        *places.entry(place.unwrap()).or_default() += 1;
    }
    for (place, count) in places {
        assert!(2 * count <= ordered.len(), "place {place}: {count} times");
    }
}

/// A first word that mostly right choices have, or "always" and "never" that only wrong
/// ones have, would tell them from afar.
#[test]
fn no_word_gives_the_right_choice_away() {
    let mut begin: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for choice in all().iter().flat_map(Concept::choices) {
        let first = choice.text().split_whitespace().next().unwrap_or_default();
        let (right, of) = begin.entry(first).or_default();
        *right += usize::from(choice.is_right());
        *of += 1;
    }
    for (word, (right, of)) in begin {
        assert!(
            of < 4 || 2 * right <= of,
            "{word}: {right} of {of} are right"
        );
    }
    let broad = ["always", "never", "nothing can"];
    let tells = |text: &str| broad.iter().any(|word| text.to_lowercase().contains(word));
    let wrongs = all().iter().flat_map(|c| &c.wrongs);
    let told = wrongs.filter(|w| tells(&w.choice)).count();
    assert!(
        told <= all().len() / 10,
        "{told} wrong choices say always or never"
    );
}

#[test]
fn texts_are_whole_and_set_as_the_others_are() {
    for concept in all() {
        let mut sentences = vec![&concept.ask, &concept.why];
        let mut choices = vec![&concept.right];
        for wrong in &concept.wrongs {
            sentences.push(&wrong.says);
            choices.push(&wrong.choice);
        }
        for text in sentences {
            let end = text.trim_end_matches(['”', '"']);
            assert!(end.ends_with(['.', '?']), "{}: {text}", concept.id);
        }
        for choice in choices {
            assert!(!choice.ends_with('.'), "{}: {choice}", concept.id);
        }
        for text in [&concept.ask, &concept.why] {
            assert!(!text.contains("--") && !text.contains("  "), "{text}");
        }
    }
}

/// The only number in a text, if it has just one.
fn only_number(text: &str) -> Option<f64> {
    let apart = text.split(|c: char| !(c.is_ascii_digit() || c == '.'));
    let numbers: Vec<f64> = apart.filter_map(|part| part.parse().ok()).collect();
    match numbers[..] {
        [number] => Some(number),
        _ => None,
    }
}

/// A figure that is merely rounded otherwise would be no other choice.
#[test]
fn figures_among_the_choices_are_well_apart() {
    for concept in all() {
        let Some(right) = only_number(&concept.right) else {
            continue;
        };
        let words = |text: &str| text.replace(|c: char| c.is_ascii_digit() || c == '.', "");
        for wrong in &concept.wrongs {
            let same_words = words(&wrong.choice) == words(&concept.right);
            if let Some(other) = only_number(&wrong.choice).filter(|_| same_words) {
                let apart = (right - other).abs() / right.max(other);
                assert!(apart > 0.1, "{}: {right} and {other}", concept.id);
            }
        }
    }
}

/// Figures in words that no placeholder can give.
#[test]
fn figures_in_words_are_so() {
    // where-turned-most: "at about α = 34°".
    let tournament = RestingTarget {
        m1: 0.015,
        m2: 0.0055,
        restitution: 1.0,
    };
    match tournament.largest_deflection() {
        LargestDeflection::Turned { alpha, .. } => {
            assert!((deg_from_rad(alpha) - 34.0).abs() < 0.5);
        }
        other => panic!("{other:?}"),
    }
    // no-electron-can: an electron has 1/7294 of the mass of an α particle.
    assert!(deg_from_rad((1.0_f64 / 7294.0).asin()) < 0.01);
    // one-in-8000: less than 1 in 100 000 of the gold foil of 1913.
    let mut beyond = Constant::named("rutherford_beyond").unwrap();
    beyond.set("angle_deg", "90").unwrap();
    assert!(beyond.value().unwrap() < 1e-5);
    // sixty-to-ninety: what the half angle forgotten gives.
    assert!(((1.0 / 60.0_f64.to_radians().sin()).powi(4) - 1.78).abs() < 0.005);
    // came-square: square before, square after.
    let came = with_id("came-square").unwrap().hit.unwrap();
    let after = came.outcome();
    assert!(came.u1.dot(came.u2).abs() < 1e-12 && after.v1.dot(after.v2).abs() < 1e-12);
}

#[test]
fn hits_are_shown_as_they_are_asked() {
    for concept in all() {
        if let Some(hit) = &concept.hit {
            assert!(hit.outcome().hit(), "{} misses", concept.id);
            let smooth = concept.ask.contains("without loss") || concept.ask.contains("no energy");
            let lossless = hit.restitution >= 1.0;
            assert!(
                !smooth || lossless,
                "{}: e = {}",
                concept.id,
                hit.restitution
            );
            let rests = concept.ask.contains("at rest");
            assert!(!rests || hit.u2.length() <= 0.0, "{}", concept.id);
        }
    }
}

/// A file with one question, with `old` in it replaced by `new`.
fn fault_of(old: &str, new: &str) -> String {
    let good = r#"format = 1
[[item]]
id = "one"
difficulty = "easy"
ask = "Which?"
right = "{theta1_deg}°"
why = "Because."
hit = { alpha_deg = 30 }
[[item.wrong]]
choice = "30°"
misconception = "copied-angle"
says = "No."
[[item.wrong]]
choice = "45°"
says = "No."
"#;
    assert!(good.contains(old), "{old}");
    let mut concepts = Vec::new();
    let bytes = good.replacen(old, new, 1);
    match read::file("my", "my.toml", bytes.as_bytes(), &mut concepts) {
        Ok(()) => format!("{concepts:?}"),
        Err(fault) => fault.to_string(),
    }
}

#[test]
fn faults_name_line_and_field() {
    for (old, new, message) in [
        (
            "format = 1",
            "format = 2",
            "my.toml:1: format: 2 is newer than the 1 this carrom reads; a newer carrom may open the file",
        ),
        (
            "\"easy\"",
            "\"soft\"",
            "my.toml:4: difficulty: unknown variant `soft`",
        ),
        (
            "why =",
            "because =",
            "my.toml:7: because: unknown field `because`",
        ),
        ("ask = \"Which?\"\n", "", "missing field `ask`"),
        (
            "{theta1_deg}",
            "{theta3}",
            "my.toml:6: right: expected the name of a number",
        ),
        (
            "{theta1_deg}",
            "{theta1_deg",
            "my.toml:6: right: expected } after {",
        ),
        (
            "alpha_deg = 30",
            "alpha_deg = 99",
            "my.toml:8: hit: alpha_deg: expected",
        ),
        (
            "alpha_deg = 30",
            "alpha = 30",
            "my.toml:8: hit: expected a field of a shot",
        ),
        (
            "alpha_deg = 30",
            "alpha_deg = 30, offset_mm = 3",
            "found both",
        ),
        (
            "alpha_deg = 30",
            "alpha_deg = \"x\"",
            "expected a number, true or false",
        ),
        (
            "\"30°\"",
            "\"60°\"",
            "expected a choice of its own, found 60° twice",
        ),
        (
            "\"45°\"",
            "\"30°\"",
            "expected a choice of its own, found 30° twice",
        ),
        (
            "\"Because.\"",
            "\"\"",
            "my.toml:7: why: expected printable text of 1 to 320",
        ),
        (
            "copied-angle",
            "copied",
            "my.toml:11: misconception: expected the id of a misconception, found copied",
        ),
        (
            "\"one\"",
            "\"One\"",
            "my.toml:3: id: expected 1 to 40 lower-case",
        ),
        (
            "right =",
            "right_place = 4\nright =",
            "right_place: expected a place from 1 to 3",
        ),
        (
            "[[item.wrong]]\nchoice = \"45°\"\nsays = \"No.\"\n",
            "",
            "wrong: expected 2 or 3 tables [[item.wrong]], found 1",
        ),
    ] {
        let found = fault_of(old, new);
        assert!(found.contains(message), "{new}: {found}");
    }
    assert!(fault_of("one", "one").starts_with("[Concept"));
}

#[test]
fn the_order_names_each_question_once() {
    let concepts = all()[..2].to_vec();
    let (first, second) = (concepts[0].id.clone(), concepts[1].id.clone());
    let turned = in_order(concepts.clone(), &format!("{second}\n{first}\n")).unwrap();
    assert_eq!(turned, [concepts[1].clone(), concepts[0].clone()]);
    for (order, message) in [
        (format!("{first}\n"), "is missing at the end"),
        (
            format!("{first}\n{first}\n"),
            "order.txt:2: expected the id",
        ),
        ("none\n".to_owned(), "order.txt:1: expected the id"),
    ] {
        let fault = in_order(concepts.clone(), &order).unwrap_err().to_string();
        assert!(fault.contains(message), "{fault}");
    }
}

#[test]
fn an_ordered_question_has_its_right_choice_in_place() {
    let ordered = with_id("ninety-survives-speed").unwrap();
    let texts: Vec<_> = ordered.choices().iter().map(|c| c.text()).collect();
    assert_eq!(texts, ["Below 90°", "90°", "Above 90°"]);
}

/// The manual has a whole example, and it is one.
#[test]
fn the_example_of_the_manual_is_a_question() {
    let manual = include_str!("../../../docs/concepts.md");
    let (_, after) = manual.split_once("```toml\n").unwrap();
    let (example, _) = after.split_once("```").unwrap();
    let mut concepts = Vec::new();
    read::file("example", "example.toml", example.as_bytes(), &mut concepts).unwrap();
    assert_eq!(concepts.len(), 1);
}
