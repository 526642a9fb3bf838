//! `carrom simulate` plays scenes whose outcomes follow from closed formulas.

use std::io::Write;
use std::process::{Command, Stdio};

use serde_json::Value;

const G: f64 = 9.80665;

/// A file of format 1 as the first version wrote it. Every version must be able to read it, so it
/// must never be changed.
const PINNED: &str = r#"
format = 1
[board]                     # all optional; these are the defaults
side_mm = 740
pocket_diameter_mm = 44.5   # 0: no pockets
friction = 0.12
restitution = 1.0           # disc on disc
cushion_restitution = 0.8
[[disc]]                    # in order: disc 0, 1, ...
kind = "striker"            # striker | white | black | queen | marble
at_mm = [0, -260]           # origin: centre of the board
mass_g = 15                 # optional: the kind's default
radius_mm = 20.65
[shot]
disc = 0
direction_deg = 90          # from +x, anticlockwise
speed = 4.0                 # m/s
"#;

fn simulate(scene: &str, arguments: &[&str]) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(["simulate", "-"])
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(scene.as_bytes())
        .unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    String::from_utf8(output.stdout).unwrap()
}

fn json(scene: &str) -> Value {
    serde_json::from_str(&simulate(scene, &["--json"])).unwrap()
}

fn near(value: &Value, expected: f64) {
    let found = value.as_f64().unwrap();
    assert!(
        (found - expected).abs() < 1e-9,
        "{found}, expected {expected}"
    );
}

fn kinds(report: &Value) -> Vec<&str> {
    let events = report["events"].as_array().unwrap();
    events
        .iter()
        .map(|event| event["kind"].as_str().unwrap())
        .collect()
}

#[test]
fn one_disc_slides_to_a_stop() {
    let scene = PINNED.replace("speed = 4.0", "speed = 1.0");
    let report = json(&scene);
    let a = 0.12 * G;
    near(&report["duration_s"], 1.0 / a);
    assert_eq!(kinds(&report), ["rest"]);
    near(&report["events"][0]["t_s"], 1.0 / a);
    assert_eq!(report["events"][0]["discs"], serde_json::json!([0]));
    assert_eq!(report["final"][0]["disc"], 0);
    assert_eq!(report["final"][0]["state"], "rest");
    near(&report["final"][0]["at_mm"][0], 0.0);
    near(&report["final"][0]["at_mm"][1], -260.0 + 1000.0 / (2.0 * a));
    near(&report["energy_before_j"], 0.0075);
    near(&report["energy_after_j"], 0.0);
}

#[test]
fn a_file_of_the_first_format_opens_and_hits_both_cushions() {
    let report = json(PINNED);
    // After a shorter way to the first cushion, the disc crosses the board three times; each
    // hit on a cushion removes a fifth of its speed.
    assert_eq!(
        kinds(&report),
        ["cushion", "cushion", "cushion", "cushion", "rest"]
    );
    let a = 0.12 * G;
    let run = 0.74 - 0.0413;
    let mut left = 16.0 - 2.0 * a * (0.26 + 0.37 - 0.02065);
    for _ in 0..3 {
        left = 0.64 * left - 2.0 * a * run;
    }
    let slid = 0.64 * left / (2.0 * a);
    near(
        &report["final"][0]["at_mm"][1],
        1000.0 * (slid - 0.37 + 0.02065),
    );
    near(&report["energy_before_j"], 0.12);
}

/// The offset is half of r1 + r2: the coin leaves at 30 degrees with three quarters of the energy,
/// the striker at 60 degrees with one quarter.
#[test]
fn a_glancing_hit_ends_where_the_formulas_predict() {
    let scene = r#"
        format = 1
        [[disc]]
        kind = "striker"
        at_mm = [-150, 0]
        [[disc]]
        kind = "white"
        at_mm = [0, -18.275]
        mass_g = 15
        [shot]
        disc = 0
        direction_deg = 0
        speed = 1.2
    "#;
    let report = json(scene);
    assert_eq!(kinds(&report), ["impact", "rest", "rest"]);
    assert_eq!(report["events"][0]["discs"], serde_json::json!([0, 1]));
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let a = 0.12 * G;
    let way = 0.150 - 0.03655 * cos;
    let came = (1.44 - 2.0 * a * way).sqrt();
    near(&report["events"][0]["t_s"], 2.0 * way / (1.2 + came));
    let striker = (came * sin).powi(2) / (2.0 * a);
    near(
        &report["final"][0]["at_mm"][0],
        1000.0 * (-0.03655 * cos + striker * sin),
    );
    near(&report["final"][0]["at_mm"][1], 1000.0 * striker * cos);
    let coin = (came * cos).powi(2) / (2.0 * a);
    near(&report["final"][1]["at_mm"][0], 1000.0 * coin * cos);
    near(
        &report["final"][1]["at_mm"][1],
        -18.275 - 1000.0 * coin * sin,
    );
}

#[test]
fn a_pocketed_disc_is_reported() {
    let scene = PINNED
        .replace("at_mm = [0, -260]", "at_mm = [0, 0]")
        .replace("direction_deg = 90", "direction_deg = 45");
    let report = json(&scene);
    assert_eq!(kinds(&report), ["pocket"]);
    assert_eq!(report["final"][0]["state"], "pocketed");
    // The disc is pocketed when its centre is within 22.25 mm of the pocket's centre, on the
    // diagonal.
    let fell = 370.0 - 22.25 - 22.25 * 0.5_f64.sqrt();
    near(&report["final"][0]["at_mm"][0], fell);
    near(&report["final"][0]["at_mm"][1], fell);
}

#[test]
fn the_printed_table_has_the_event_and_the_energies() {
    let text = simulate(&PINNED.replace("speed = 4.0", "speed = 1.0"), &[]);
    let lines: Vec<_> = text
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>())
        .collect();
    assert_eq!(
        lines[1],
        ["0.8498", "rest", "0.00", "164.88", "the", "striker"]
    );
    assert!(text.contains("at the end, after 0.8498 s"));
    assert!(text.contains("energy 7.5000 mJ before, 0.0000 mJ after"));
}
