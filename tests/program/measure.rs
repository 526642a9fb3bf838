//! `carrom measure` with the shipped examples and with faulty tracks.

use std::fs;

use scraper::{Html, Selector};
use serde_json::Value;

use crate::folder::Folder;
use crate::start::{done, refused};

const PUCKS: &str = "measured/pucks.txt --m1-g 30 --m2-g 30 --r1-mm 25 --r2-mm 25";
const COINS: &str =
    "measured/coins.csv --m1-g 8.5 --m2-g 7.5 --r1-mm 12.875 --r2-mm 11.625 --charset unicode";

fn examples() -> Folder {
    let folder = Folder::new("measure");
    done(&folder, "examples --out .");
    folder
}

/// The shipped examples were simulated, so their true values are known.
#[test]
fn the_examples_give_the_values_that_were_simulated() {
    let folder = examples();
    let json = done(&folder, &format!("measure {PUCKS} --json"));
    let report: Value = serde_json::from_str(&json).unwrap();
    let near = |name: &str, truth: f64| {
        let quantity = &report["quantities"][name];
        let [low, high] = [0, 1].map(|end| quantity["interval_95"][end].as_f64().unwrap());
        assert!(low <= truth && truth <= high, "{name}: {quantity}");
    };
    near("restitution", 0.99);
    near("u1_m_s", 0.8_f64.hypot(0.1));
    near("alpha_deg", 0.5_f64.to_degrees());
    near("offset_mm", 50.0 * 0.5_f64.sin());
    near("impulse_ratio", 0.0);
    assert_eq!(report["line_of_impact_from"], "centres");
    let rest = report["quantities"]["u2_direction_deg"]["unknown"]
        .as_str()
        .unwrap();
    assert!(
        rest.contains("mass B is at rest before the contact"),
        "{rest}"
    );
    let coins = done(&folder, &format!("measure {COINS}"));
    for part in [
        "constant deceleration: straight lines fit worse",
        "e  0.841 ± 0.009",
        "18 points",
    ] {
        assert!(coins.contains(part), "{part}\n{coins}");
    }
}

#[test]
fn sentences_are_as_strong_as_the_data() {
    let folder = examples();
    let options = "--charset unicode --m1-g 30 --m2-g 30";
    let clean = done(&folder, &format!("measure {PUCKS} --charset unicode"));
    assert!(
        clean.contains("Momentum agrees within 0.4 %: 0.5 σ."),
        "{clean}"
    );
    let hopeless = done(
        &folder,
        &format!("measure measured/careless.csv --scale 1 {options}"),
    );
    assert!(
        hopeless.contains("This test is weak: a change of"),
        "{hopeless}"
    );
    assert!(hopeless.contains("unknown without the radii"), "{hopeless}");
    let ascii = done(&folder, "measure measured/pucks.txt --charset ascii");
    assert!(
        ascii.is_ascii() && ascii.contains("The masses are assumed to be equal"),
        "{ascii}"
    );
}

#[test]
fn wrong_radii_are_noticed_and_the_given_restitution_is_used_for_the_prediction() {
    let folder = examples();
    let wrong = COINS.replace("--r1-mm 12.875", "--r1-mm 14");
    let text = done(&folder, &format!("measure {wrong}"));
    assert!(text.contains("The tracks contradict the radii"), "{text}");
    assert!(
        text.contains("from the change of the relative velocity"),
        "{text}"
    );
    let text = done(&folder, &format!("measure {COINS} --restitution 0.85"));
    assert!(
        text.contains("prediction for smooth rims and e = 0.85"),
        "{text}"
    );
}

#[test]
fn the_report_is_one_page_with_a_picture() {
    let folder = examples();
    let named = done(&folder, &format!("measure {PUCKS} --report r.html"));
    assert_eq!(named, "r.html\n");
    let html = Html::parse_document(&fs::read_to_string(folder.path().join("r.html")).unwrap());
    for (part, count) in [("svg", 1), ("section", 1), ("h1", 1), ("table", 5)] {
        let found = html.select(&Selector::parse(part).unwrap()).count();
        assert_eq!(found, count, "{part}");
    }
    let again = refused(&folder, &format!("measure {PUCKS} --report r.html"), 1);
    assert!(again.contains("--force"), "{again}");
    done(&folder, &format!("measure {PUCKS} --report r.html --force"));
}

#[test]
fn faulty_tracks_are_refused_with_a_clear_message() {
    let folder = examples();
    let pucks = fs::read_to_string(folder.path().join("measured/pucks.txt")).unwrap();
    let rows: Vec<&str> = pucks.lines().collect();
    let swapped: Vec<String> = { rows.iter().enumerate() }
        .map(
            |(line, row)| match row.split('\t').collect::<Vec<_>>().as_slice() {
                [t, x1, y1, x2, y2, ..] if line > 30 => format!("{t}\t{x2}\t{y2}\t{x1}\t{y1}"),
                _ => (*row).to_owned(),
            },
        )
        .collect();
    let apart = |line: &str| {
        let numbers: Vec<f64> = line.split('\t').filter_map(|it| it.parse().ok()).collect();
        match numbers.as_slice() {
            [t, ..] => format!("{t}\t{}\t0\t{}\t1", 0.8 * t, 0.1 * t),
            _ => line.to_owned(),
        }
    };
    for (name, text, expected) in [
        (
            "swapped",
            swapped.join("\n"),
            "swapped:32: expected mass A to continue its path",
        ),
        (
            "short",
            rows[..26].join("\n"),
            "expected at least 3 points of mass A after",
        ),
        ("few", rows[..8].join("\n"), "found 4 points"),
        (
            "missed",
            rows.iter()
                .map(|row| apart(row))
                .collect::<Vec<_>>()
                .join("\n"),
            "expected a collision, found tracks that do not determine a contact",
        ),
        (
            "text",
            pucks.replacen("1.9", "1,9,", 1),
            "expected a number",
        ),
    ] {
        folder.file(name, text);
        let message = refused(&folder, &format!("measure {name}"), 2);
        assert!(message.contains(expected), "{name}: {message}");
        assert_eq!(message.lines().count(), 1, "{message}");
    }
    for (arguments, expected) in [
        ("measure nothing.txt", "nothing.txt: cannot be read"),
        ("measure -", "standard input:1: expected rows of a time"),
        ("measure measured/careless.csv", "expected --scale"),
        ("measure measured/pucks.txt --m1-g 30", "--m2-g"),
        (
            "measure measured/pucks.txt --scale 0",
            "expected one or two numbers",
        ),
        (
            "measure measured/pucks.txt --restitution 2",
            "expected a number from 0 to 1",
        ),
    ] {
        let message = refused(&folder, arguments, 2);
        assert!(message.contains(expected), "{arguments}: {message}");
    }
}
