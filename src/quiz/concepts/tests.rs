//! Checks that the built-in questions follow the rules for good questions.

use std::collections::{BTreeMap, BTreeSet};

use super::*;
use crate::physics::named::Constant;
use crate::physics::units::deg_from_rad;
use crate::physics::{RestingTarget, resting_target::LargestDeflection};
use crate::quiz::misconceptions::Origin;
use crate::quiz::question::Misconception;

#[test]
fn the_embedded_files_have_no_errors() {
    if let Err(fault) = embedded() {
        panic!("{fault}");
    }
}

#[test]
fn there_are_at_least_sixty_questions_with_different_ids() {
    let ids: BTreeSet<_> = all().iter().map(|concept| &concept.id).collect();
    assert_eq!(ids.len(), all().len());
    assert!(ids.len() >= 60, "{}", ids.len());
    assert!(ids.iter().all(|id| with_id(id).is_some()));
}

/// The codes of rounds depend on this order; new questions are added at the end.
#[test]
fn the_order_does_not_change() {
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

/// The table in the guide describes the misconceptions as the program does and in the same order,
/// and every study is listed below the table.
#[test]
fn the_guide_lists_every_misconception_with_its_source() {
    let guide = include_str!("../../../docs/concepts.md");
    let (_, table) = guide
        .split_once("| name | in words | source |\n|---|---|---|\n")
        .unwrap();
    let (table, below) = table.split_once("\n\n").unwrap();
    let source = |it: &Misconception| match it.origin() {
        Origin::Study(study) => study,
        Origin::Slip => "slip",
        Origin::Ours => "ours",
    };
    let rows = Misconception::ALL.iter();
    let rows = rows.map(|it| format!("| `{}` | {} | {} |", it.id(), it.name(), source(it)));
    let rows: Vec<String> = rows.collect();
    assert_eq!(table, rows.join("\n"));

    let listed: Vec<&str> = below.split("\n- ").collect();
    for misconception in Misconception::ALL {
        if let Origin::Study(study) = misconception.origin() {
            let (cited, found) = study.split_once(": ").unwrap();
            let (authors, year) = cited.rsplit_once(' ').unwrap_or((cited, ""));
            let first = authors
                .split(" &")
                .next()
                .unwrap()
                .trim_end_matches(" et al.");
            // An online review has no year of publication.
            let year = match year {
                "" => String::new(),
                year => format!("({year})"),
            };
            let is_it = |entry: &&str| entry.contains(first) && entry.contains(&year);
            assert!(listed.iter().any(is_it), "{study}");
            assert!(!found.is_empty(), "{study}");
        }
    }
}

#[test]
fn every_misconception_occurs_in_at_least_two_questions() {
    let mut met: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for concept in all() {
        for belief in concept
            .wrongs
            .iter()
            .filter_map(|wrong| wrong.misconception)
        {
            met.entry(belief.id()).or_default().insert(&concept.id);
        }
    }
    for belief in Misconception::ALL {
        let count = met.get(belief.id()).map_or(0, BTreeSet::len);
        assert!(count >= 2, "{} occurs in {count} questions", belief.id());
    }
}

#[test]
fn nothing_gives_a_right_choice_away_and_the_style_is_uniform() {
    let faults: Vec<String> = check(all()).iter().map(ToString::to_string).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    for text in all()
        .iter()
        .flat_map(|concept| [&concept.ask, &concept.why])
    {
        assert!(!text.contains("--") && !text.contains("  "), "{text}");
    }
}

/// The faults found in the first `count` built-in questions after `change` has been applied to each
/// of them.
fn spoilt(count: usize, change: impl Fn(&mut Concept)) -> Vec<String> {
    let mut concepts: Vec<Concept> = all()[..count].to_vec();
    concepts.iter_mut().for_each(change);
    check(&concepts).iter().map(ToString::to_string).collect()
}

#[test]
fn right_choices_that_are_given_away_are_reported() {
    let faults = |count, change: fn(&mut Concept)| spoilt(count, change).join("\n");
    assert_eq!(faults(1, |_| {}), "");
    let long = faults(1, |it| it.right = "x".repeat(90));
    assert!(
        long.contains("found the longest by far: 90 letters"),
        "{long}"
    );
    assert!(long.contains(&format!("{}.right", all()[0].id)), "{long}");
    let short = faults(1, |it| {
        it.right = "no".into();
        it.wrongs
            .iter_mut()
            .for_each(|wrong| wrong.choice += " and so on");
    });
    assert!(short.contains("shortest by far"), "{short}");
    let stop = faults(1, |it| it.right += ".");
    assert!(stop.contains("expected no full stop"), "{stop}");
    let urdu_stop = faults(1, |it| it.right += "۔");
    assert!(urdu_stop.contains("expected no full stop"), "{urdu_stop}");
    let open = faults(1, |it| it.why = "Because".into());
    assert!(open.contains("expected whole sentences"), "{open}");
    assert_eq!(faults(1, |it| it.why = "یہ درست ہے۔".into()), "");
    let near = faults(1, |it| {
        it.right = "90°".into();
        it.wrongs[0].choice = "88°".into();
    });
    assert!(
        near.contains("clearly different figures, found 90 and 88"),
        "{near}"
    );
    // A pattern is reported only if there are enough questions to show it.
    let longer = |it: &mut Concept| {
        let most = it
            .wrongs
            .iter()
            .map(|wrong| wrong.choice.chars().count())
            .max();
        it.right = "x".repeat(most.unwrap() + 1);
    };
    assert!(spoilt(7, longer).is_empty());
    assert!(
        spoilt(8, longer)
            .join("\n")
            .contains("is the longest in 8 of 8")
    );
    let placed = faults(10, |it| (it.ordered, it.before_right) = (true, 1));
    assert!(placed.contains("is number 2 in 10 of 10"), "{placed}");
    let begun = faults(8, |it| it.right = format!("Exactly {}", it.right));
    assert!(
        begun.contains("that begin with \"Exactly\", 8 are right"),
        "{begun}"
    );
    let broad = faults(8, |it| it.wrongs[0].choice += ", always");
    assert!(
        broad.contains("8 wrong choices say always or never"),
        "{broad}"
    );
}

/// Checks the figures that are typed in texts because no placeholder can provide them.
#[test]
fn figures_typed_in_texts_are_correct() {
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
    // no-electron-can: an electron has 1/7294 of the mass of an α-particle.
    assert!(deg_from_rad((1.0_f64 / 7294.0).asin()) < 0.01);
    // one-in-8000: the gold foil of 1913 turns back less than 1 in 100,000.
    let mut beyond = Constant::named("rutherford_beyond").unwrap();
    beyond.set("angle_deg", "90").unwrap();
    assert!(beyond.value().unwrap() < 1e-5);
    // sixty-to-ninety: the ratio if the angles are not halved.
    assert!(((1.0 / 60.0_f64.to_radians().sin()).powi(4) - 1.78).abs() < 0.005);
    // came-square: 90° before and 90° after.
    let came = with_id("came-square").unwrap().hit.unwrap();
    let after = came.outcome();
    assert!(came.u1.dot(came.u2).abs() < 1e-12 && after.v1.dot(after.v2).abs() < 1e-12);
}

#[test]
fn the_hits_shown_agree_with_the_questions() {
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

/// The errors in a file with a single question in which `old` has been replaced by `new`.
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
fn errors_name_the_line_and_the_field() {
    for (old, new, message) in [
        (
            "format = 1",
            "format = 2",
            "my.toml:1: format: 2 is newer than 1, the latest this version reads; a newer version may open it",
        ),
        (
            "\"easy\"",
            "\"soft\"",
            "my.toml:4: item.difficulty: expected one of easy, middle, hard, found the text \"soft\"",
        ),
        (
            "why =",
            "because =",
            "my.toml:7: item.because: unknown field; expected one of id, difficulty, ask, right, right_place, why, wrong, hit",
        ),
        (
            "ask = \"Which?\"\n",
            "",
            "my.toml:2: item.ask: expected text, found nothing",
        ),
        (
            "{theta1_deg}",
            "{theta3}",
            "my.toml:6: item.right: expected the name of a number",
        ),
        (
            "{theta1_deg}",
            "{theta1_deg",
            "my.toml:6: item.right: expected } after {",
        ),
        (
            "alpha_deg = 30",
            "alpha_deg = 99",
            "my.toml:8: item.hit.alpha_deg: expected an impact angle in degrees from -90 to 90, found 99",
        ),
        (
            "alpha_deg = 30",
            "alpha = 30",
            "my.toml:8: item.hit.alpha: unknown field; expected one of m1_g, ",
        ),
        (
            "alpha_deg = 30",
            "alpha_deg = 30, offset_mm = 3",
            "found both",
        ),
        (
            "alpha_deg = 30",
            "alpha_deg = \"x\"",
            "my.toml:8: item.hit.alpha_deg: expected an impact angle in degrees from -90 to 90, found x",
        ),
        (
            "\"30°\"",
            "\"60°\"",
            "expected different choices, found 60° twice",
        ),
        (
            "\"45°\"",
            "\"30°\"",
            "expected different choices, found 30° twice",
        ),
        (
            "\"Because.\"",
            "\"\"",
            "my.toml:7: item.why: expected text of 1 to 320 printable characters, found 0",
        ),
        (
            "copied-angle",
            "copied",
            "my.toml:11: item.wrong.misconception: expected the id of a misconception (carrom misconceptions prints all), found copied",
        ),
        (
            "\"one\"",
            "\"One\"",
            "my.toml:3: item.id: expected 1 to 40 lower-case",
        ),
        (
            "right =",
            "right_place = 4\nright =",
            "item.right_place: expected a place from 1 to 3, found 4",
        ),
        (
            "[[item.wrong]]\nchoice = \"45°\"\nsays = \"No.\"\n",
            "",
            "item.wrong: expected 2 to 3 tables [[wrong]], found a list of 1",
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
fn the_right_choice_of_an_ordered_question_is_in_its_place() {
    let ordered = with_id("ninety-survives-speed").unwrap();
    let texts: Vec<_> = ordered.choices().iter().map(|c| c.0).collect();
    assert_eq!(texts, ["Below 90°", "90°", "Above 90°"]);
}

/// The manual contains a complete example, which has to be a valid question.
#[test]
fn the_example_in_the_manual_is_a_valid_question() {
    let manual = include_str!("../../../docs/concepts.md");
    let (_, after) = manual.split_once("```toml\n").unwrap();
    let (example, _) = after.split_once("```").unwrap();
    let mut concepts = Vec::new();
    read::file("example", "example.toml", example.as_bytes(), &mut concepts).unwrap();
    assert_eq!(concepts.len(), 1);
}
