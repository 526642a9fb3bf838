//! The command `carrom solve`: its answers, its messages and its batches.

use std::io::Write;
use std::process::{Command, Output, Stdio};

use serde_json::{Value, json};

fn solve(args: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(["--charset", "ascii", "solve"])
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_vec();
    let writer = std::thread::spawn(move || {
        // A command that refuses its arguments does not read its input.
        let _ = stdin.write_all(&input);
    });
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    output
}

fn printed(args: &[&str]) -> String {
    let output = solve(args, b"");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// The exit code and the answers of a batch.
fn batch(input: &[u8]) -> (Option<i32>, Vec<Value>) {
    let output = solve(&["--batch"], input);
    assert!(output.stderr.is_empty(), "{output:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    let answers = text.lines().map(|line| serde_json::from_str(line).unwrap());
    (output.status.code(), answers.collect())
}

fn answer(line: &str) -> Value {
    let (code, mut answers) = batch(line.as_bytes());
    assert_eq!((code, answers.len()), (Some(0), 1), "{answers:?}");
    answers.remove(0)
}

fn refusal(line: &str) -> String {
    let (code, answers) = batch(line.as_bytes());
    assert_eq!((code, answers.len()), (Some(1), 1), "{line}: {answers:?}");
    assert_eq!(answers[0]["line"], 1);
    answers[0]["error"].as_str().unwrap().to_owned()
}

fn close(value: &Value, expected: f64) {
    let value = value.as_f64().unwrap();
    assert!(
        (value - expected).abs() <= 1e-12,
        "{value} is not {expected}"
    );
}

const MARBLES: &str = r#"{"m1_g":20,"m2_g":40,"u1":[3,0],"alpha_deg":45}"#;

#[test]
fn the_published_example_is_solved() {
    let marbles = answer(MARBLES);
    assert_eq!(marbles["hit"], true);
    for (field, expected) in [("v1", [1.0, 2.0]), ("v2", [1.0, -1.0])] {
        close(&marbles[field][0], expected[0]);
        close(&marbles[field][1], expected[1]);
    }
    close(&marbles["speed1"], 5.0_f64.sqrt());
    close(&marbles["speed2"], 2.0_f64.sqrt());
    close(&marbles["theta1_deg"], 2.0_f64.atan().to_degrees());
    close(&marbles["theta2_deg"], 45.0);
    close(
        &marbles["separation_deg"],
        45.0 + 2.0_f64.atan().to_degrees(),
    );
    close(&marbles["energy_before_j"], 0.09);
    close(&marbles["energy_after_j"], 0.09);
}

#[test]
fn the_fields_have_a_fixed_order() {
    let output = solve(&["--batch"], MARBLES.as_bytes());
    let text = String::from_utf8(output.stdout).unwrap();
    let fields = [
        "hit",
        "v1",
        "v2",
        "speed1",
        "speed2",
        "theta1_deg",
        "theta2_deg",
        "separation_deg",
        "energy_before_j",
        "energy_after_j",
        "assumed",
    ];
    let places: Vec<usize> = fields
        .iter()
        .map(|field| text.find(&format!("\"{field}\":")).unwrap())
        .collect();
    assert!(places.is_sorted(), "{text}");
    assert_eq!(text.matches(':').count(), fields.len(), "{text}");
}

#[test]
fn a_head_on_hit_has_no_angle_and_no_nan() {
    let stopped = answer(r#"{"m1_g":15,"m2_g":15,"u1":[2.4,3.2],"alpha_deg":0}"#);
    assert_eq!(stopped["v1"], json!([0.0, 0.0]));
    assert_eq!(stopped["theta1_deg"], Value::Null);
    assert_eq!(stopped["separation_deg"], Value::Null);
    close(&stopped["theta2_deg"], 0.0);
}

#[test]
fn a_miss_leaves_the_velocities_unchanged() {
    let line = r#"{"m1_g":15,"m2_g":15,"u1":[0.1,0.7],"u2":[0.3,-0.2],"offset_mm":40,"r1_mm":20.65,"r2_mm":15.9}"#;
    let missed = answer(line);
    assert_eq!(missed["hit"], false);
    assert_eq!(missed["v1"], json!([0.1, 0.7]));
    assert_eq!(missed["v2"], json!([0.3, -0.2]));
    close(&missed["theta1_deg"], 0.0);
    assert_eq!(missed["energy_before_j"], missed["energy_after_j"]);
}

#[test]
fn a_graze_is_a_hit_that_changes_nothing() {
    let line = r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"offset_mm":36.55,"r1_mm":20.65,"r2_mm":15.9}"#;
    let grazed = answer(line);
    assert_eq!(grazed["hit"], true);
    assert_eq!(grazed["v1"], json!([4.0, 0.0]));
    assert_eq!(grazed["theta2_deg"], Value::Null);
}

#[test]
fn an_offset_and_its_impact_angle_give_the_same_answer() {
    let by_offset =
        answer(r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"offset_mm":15,"r1_mm":14.1,"r2_mm":15.9}"#);
    let by_angle = answer(r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"alpha_deg":30}"#);
    for field in ["speed1", "speed2", "theta1_deg", "separation_deg"] {
        close(&by_offset[field], by_angle[field].as_f64().unwrap());
    }
}

#[test]
fn discs_that_stick_share_a_velocity_and_rotate() {
    let stuck = answer(
        r#"{"m1_g":10,"m2_g":10,"u1":[3,0],"offset_mm":10,"r1_mm":10,"r2_mm":10,"stick":true}"#,
    );
    assert_eq!(stuck["v1"], json!([1.5, 0.0]));
    assert_eq!(stuck["v1"], stuck["v2"]);
    close(&stuck["spin_rad_s"], 50.0);
    // The centres move around the centre of mass at ω r = 0.5 m/s, perpendicular to the line
    // between them. That line is at 30° to the motion, so the components are 0.25 m/s along the
    // motion and 0.25 √3 m/s perpendicular to it.
    close(&stuck["centre_v1"][0], 1.75);
    close(&stuck["centre_v2"][0], 1.25);
    close(&stuck["centre_v1"][1], 0.25 * 3.0_f64.sqrt());
    close(&stuck["centre_v2"][1], -0.25 * 3.0_f64.sqrt());
    close(&stuck["energy_rotation_j"], 0.00375);
    close(&stuck["energy_after_j"], 0.0225 + 0.00375);
    assert_eq!(answer(MARBLES).get("spin_rad_s"), None);
}

/// `spin_rad_s` is positive clockwise; `spin_ccw_rad_s` is positive anticlockwise, in agreement
/// with the axes.
#[test]
fn the_anticlockwise_spin_gives_the_velocities_of_the_centres() {
    for offset in [10.0, -10.0, 0.0] {
        let problem = json!({"m1_g":10,"m2_g":30,"u1":[3,0],"offset_mm":offset,"r1_mm":10,"r2_mm":12,"stick":true});
        let stuck = answer(&problem.to_string());
        let spin = stuck["spin_ccw_rad_s"].as_f64().unwrap();
        close(&stuck["spin_rad_s"], -spin);
        assert!(spin * offset <= 0.0 && (spin != 0.0 || offset == 0.0));
        // The relative velocity of the centres is ω × (the vector between them). This vector is
        // along the line of impact and r1 + r2 = 22 mm long; its component to the right of the
        // motion is the offset.
        let [along, across] = [(22.0_f64.powi(2) - offset * offset).sqrt(), -offset];
        let part = |name: &str, i: usize| stuck[name][i].as_f64().unwrap();
        for (i, expected) in [-spin * across * 1e-3, spin * along * 1e-3]
            .into_iter()
            .enumerate()
        {
            let relative = part("centre_v2", i) - part("centre_v1", i);
            assert!(
                (relative - expected).abs() < 1e-12,
                "{relative} is not {expected}"
            );
        }
    }
}

#[test]
fn an_answer_lists_what_it_assumes_and_ignores() {
    let given = r#""m1_g":15,"m2_g":15,"u1":[4,0]"#;
    for (rest, expected) in [
        (
            r#""alpha_deg":30"#,
            &["target at rest", "elastic, restitution 1", "smooth rims"][..],
        ),
        (
            r#""alpha_deg":30,"u2":[0,1],"restitution":0.8,"r1_mm":9"#,
            &[
                "radii ignored, as alpha_deg gives the line of impact",
                "smooth rims",
            ],
        ),
        (
            r#""offset_mm":3,"r1_mm":9,"r2_mm":9,"u2":[0,0],"restitution":1"#,
            &["smooth rims"],
        ),
        (
            r#""alpha_deg":30,"u2":[0,0],"stick":true"#,
            &["radii 15.9 mm", "uniform solid discs"],
        ),
        (
            r#""alpha_deg":30,"u2":[0,0],"stick":true,"r2_mm":9,"restitution":0.5"#,
            &[
                "restitution ignored, as discs that stick do not rebound",
                "r1 = 15.9 mm",
                "uniform solid discs",
            ],
        ),
        (
            r#""offset_mm":3,"r1_mm":9,"r2_mm":9,"stick":true"#,
            &["target at rest", "uniform solid discs"],
        ),
    ] {
        let answer = answer(&format!("{{{given},{rest}}}"));
        assert_eq!(answer["assumed"], json!(expected), "{rest}");
    }
    // The assumed radii are the ones that are used.
    let radii = r#""r1_mm":15.9,"r2_mm":15.9"#;
    let stick = r#""alpha_deg":30,"u2":[0,0],"stick":true"#;
    assert_eq!(
        answer(&format!("{{{given},{stick}}}"))["spin_rad_s"],
        answer(&format!("{{{given},{stick},{radii}}}"))["spin_rad_s"]
    );
}

#[test]
fn the_command_line_lists_the_values_that_it_assumes() {
    let args = ["--alpha-deg", "30", "--stick", "--restitution", "0.5"];
    let text = words(&printed(&args));
    let said = "Assumed: m1 = 15 g; m2 = 15 g; u1 = 4 m/s; target at rest; restitution ignored, \
                as discs that stick do not rebound; radii 15.9 mm; uniform solid discs.";
    assert!(text.contains(said), "{text}");
    let plain = words(&printed(&[&args[..], &["--plain"]].concat()));
    assert!(plain.contains("Assumed: m1 equals 15 grams"), "{plain}");
    let json = printed(&[&args[..], &["--json", "--m1-g", "15", "--u2", "0,0"]].concat());
    assert!(json.ends_with("}\n"), "{json}");
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["assumed"][0], "m2 = 15 g");
    assert_eq!(json["assumed"][1], "u1 = 4 m/s");
}

/// 15 g discs of radius 15 mm at 4 m/s and 30°: Jₙ = 51.96 g m/s, Jₜ = 0.05 Jₙ = 2.598 g m/s, both
/// discs spin clockwise at 2 × 2.598 / (15 × 0.015) = 23.09 rad/s, and tan δ = 0.05.
#[test]
fn rims_with_friction_throw_the_target_and_spin_both_discs() {
    let given = r#""m1_g":15,"m2_g":15,"u1":[4,0],"alpha_deg":30,"r1_mm":15,"r2_mm":15"#;
    let thrown = answer(&format!(r#"{{{given},"rim_friction":0.05}}"#));
    let impulse = 0.05 * 60.0 * 0.75_f64.sqrt();
    let spin = -2.0 * impulse / (15.0 * 0.015);
    close(&thrown["spin1_ccw_rad_s"], spin);
    close(&thrown["spin2_ccw_rad_s"], spin);
    close(&thrown["friction_impulse_n_s"], impulse / 1000.0);
    close(&thrown["normal_impulse_n_s"], 0.060 * 0.75_f64.sqrt());
    let throw = 0.05_f64.atan().to_degrees();
    close(&thrown["throw_deg"], throw);
    close(&thrown["theta2_deg"], 30.0 - throw);
    close(&thrown["separation_deg"], 90.0 - throw);
    assert_eq!(
        thrown["assumed"],
        json!([
            "target at rest",
            "elastic, restitution 1",
            "uniform solid discs"
        ])
    );
    // This spin cancels the slip of 2 m/s along t, so no friction acts.
    let rolls = answer(&format!(
        r#"{{{given},"rim_friction":0.05,"spin1":{}}}"#,
        -2.0 / 0.015
    ));
    close(&rolls["throw_deg"], 0.0);
    close(&rolls["spin2_ccw_rad_s"], 0.0);
    close(&rolls["separation_deg"], 90.0);
    // With smooth rims, the spins do not change, and the velocities are those of discs without
    // spin.
    let smooth = answer(&format!("{{{given}}}"));
    let spinning = answer(&format!(r#"{{{given},"rim_friction":0,"spin2":7}}"#));
    assert_eq!(
        (&smooth["v1"], &smooth["v2"]),
        (&spinning["v1"], &spinning["v2"])
    );
    close(&spinning["spin2_ccw_rad_s"], 7.0);
    let zero = answer(&format!(
        r#"{{{given},"rim_friction":0,"spin1":0,"spin2":0}}"#
    ));
    assert_eq!(zero.get("spin1_ccw_rad_s"), None);
    let said = refusal(&format!(r#"{{{given},"stick":true,"spin1":1}}"#));
    assert_eq!(said, "spin1: expected either this or stick, found both");
    let said = refusal(&format!(r#"{{{given},"rim_friction":-1}}"#));
    assert_eq!(
        said,
        "rim_friction: expected a number from 0 to 1e9, found -1"
    );
}

#[test]
fn the_worked_solution_explains_the_throw() {
    let args = [
        "--alpha-deg",
        "30",
        "--rim-friction",
        "0.05",
        "--r1-mm",
        "15",
    ];
    let text = printed(&[&args[..], &["--r2-mm", "15"]].concat());
    for part in [
        "rims friction mu_r = 0.05",
        "slip us = u1_t - u2_t + omega1r1 + omega2r2",
        "= 2 - 0 + 0 x 0.015 + 0 x 0.015 = 2 m/s",
        "limit mu_r J_n = 0.05 x 51.96 = 2.598 g m/s",
        "to stop the slip mu |us| / 3 = 7.5 x 2 / 3 = 5 g m/s",
        "J_t = 2.598 g m/s: the limit is reached first",
        "v1_t = u1_t - J_t / m1 = 2 - 2.598 / 15 = 1.827 m/s",
        "= 0 - 2 x 2.598 / (15 x 0.015) = -23.09 rad/s",
        "tan delta = J_t / J_n, delta = 2.862 deg",
        "The angle between their paths is 87.14 deg; with smooth rims it would be 90 deg.",
        "the striker spins clockwise at 23.09 rad/s",
    ] {
        assert!(words(&text).contains(part), "{part}\n{text}");
    }
    let plain = words(&printed(
        &[&args[..], &["--r2-mm", "15", "--plain"]].concat(),
    ));
    assert!(plain.contains("mu r equals 0.05"), "{plain}");
    let json = printed(&[&args[..], &["--spin1", "10", "--spin2=-3", "--json"]].concat());
    let json: Value = serde_json::from_str(&json).unwrap();
    assert!(json["spin1_ccw_rad_s"].as_f64().unwrap() < 10.0);
    assert!(
        json["assumed"]
            .as_array()
            .unwrap()
            .contains(&json!("r2 = 15.9 mm"))
    );
}

/// The help gives the sign conventions, and the guide names every field of an answer.
#[test]
fn the_signs_are_documented() {
    let help = words(&printed(&["--help"]));
    for said in [
        "theta1_deg is the angle from u1 to v1, positive anticlockwise",
        "theta2_deg is the angle from u1 to v2, positive clockwise",
        "spin_rad_s is the angular velocity, positive clockwise",
        "spin_ccw_rad_s is the same, positive anticlockwise",
        "spins after the collision, positive anticlockwise, as are spin1 and spin2",
        "Spin of the striker in rad/s, positive anticlockwise",
        "[default: 15]",
    ] {
        assert!(help.contains(said), "{said}\n{help}");
    }
    let guide = include_str!("../../docs/solve.md");
    let stick = r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"alpha_deg":30,"stick":true}"#;
    for field in answer(stick).as_object().unwrap().keys() {
        assert!(guide.contains(&format!("`{field}`")), "{field}");
    }
    let rims = r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"alpha_deg":30,"rim_friction":1}"#;
    for field in answer(rims).as_object().unwrap().keys() {
        assert!(guide.contains(&format!("`{field}`")), "{field}");
    }
}

#[test]
fn numbers_are_read_back_bit_for_bit() {
    // A miss does not change the velocities, which are written as text and read back.
    let speeds: [f64; 6] = [
        0.1,
        1.0 / 3.0,
        5e-324,
        123_456.789_012_345_68,
        2.2e-16,
        -7.450_580_596_923_828e-9,
    ];
    for speed in speeds {
        let line = json!({"m1_g":15,"m2_g":15,"u1":[4.0,speed],"u2":[speed,1.0],"offset_mm":99,"r1_mm":1,"r2_mm":1});
        let missed = answer(&line.to_string());
        let back = missed["v1"][1].as_f64().unwrap();
        assert_eq!(back.to_bits(), speed.to_bits());
    }
}

#[test]
fn a_batch_keeps_its_order_and_continues_after_an_invalid_line() {
    let mut input = String::new();
    for line in 1..=2000 {
        if line % 7 == 0 {
            input.push_str("not json\n");
        } else {
            let u1 = f64::from(line);
            input.push_str(&format!(
                "{{\"m1_g\":1,\"m2_g\":1,\"u1\":[{u1},0],\"alpha_deg\":90}}\r\n"
            ));
        }
    }
    let (code, answers) = batch(input.as_bytes());
    assert_eq!((code, answers.len()), (Some(1), 2000));
    for (line, answer) in (1..).zip(&answers) {
        if line % 7 == 0 {
            assert_eq!(answer["line"], line);
            assert!(answer["error"].is_string());
        } else {
            close(&answer["speed1"], f64::from(line));
        }
    }
}

#[test]
fn blank_lines_are_skipped_but_counted() {
    let (code, answers) = batch(format!("\n  \r\n{MARBLES}\n\nbad\n").as_bytes());
    assert_eq!((code, answers.len()), (Some(1), 2));
    assert_eq!(answers[1]["line"], 5);
    assert_eq!(batch(b""), (Some(0), vec![]));
}

/// A refusal names the field that is at fault, if there is one.
#[test]
fn refusals_name_the_field() {
    for (line, said) in [
        (
            r#"{"m1_g":-5,"m2_g":15,"u1":[4,0],"alpha_deg":30}"#,
            "m1_g: expected grams from 1e-12 to 1e12, found -5",
        ),
        (
            r#"{"m1_g":15,"m2_g":0,"u1":[4,0],"alpha_deg":30}"#,
            "m2_g: expected grams from 1e-12 to 1e12, found 0",
        ),
        (
            r#"{"m1_g":1e300,"m2_g":15,"u1":[4,0],"alpha_deg":30}"#,
            "m1_g: expected grams from 1e-12 to 1e12, found 1e300",
        ),
        (r#"{"m2_g":15,"u1":[4,0],"alpha_deg":30}"#, "m1_g: missing"),
        (
            r#"{"m1_g":15,"m2_g":null,"u1":[4,0],"alpha_deg":30}"#,
            "m2_g: invalid type: null, expected a number",
        ),
        (r#"{"m1_g":15,"m2_g":15,"alpha_deg":30}"#, "u1: missing"),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4],"alpha_deg":30}"#,
            "u1: invalid length 1",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4,0,0],"alpha_deg":30}"#,
            "u1: ",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":4,"alpha_deg":30}"#,
            "u1: invalid type: integer `4`, expected an array of length 2",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[1e200,0],"alpha_deg":30}"#,
            "u1: expected components in m/s from -1e9 to 1e9, found 1e200",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"u2":[0,-1e10],"alpha_deg":30}"#,
            "u2: expected components in m/s from -1e9 to 1e9, found -1e10",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4,0]}"#,
            "alpha_deg: missing: expected this, or offset_mm with r1_mm and r2_mm",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"alpha_deg":91}"#,
            "alpha_deg: expected degrees from -90 to 90, found 91",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"alpha_deg":30,"offset_mm":1,"r1_mm":1,"r2_mm":1}"#,
            "alpha_deg: expected either this or offset_mm, found both",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"offset_mm":1,"r1_mm":1}"#,
            "r2_mm: missing",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"offset_mm":1,"r1_mm":0,"r2_mm":1}"#,
            "r1_mm: expected millimetres",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"alpha_deg":30,"restitution":1.1}"#,
            "restitution: expected a number from 0 to 1, found 1.1",
        ),
        (
            r#"{"m1_g":15,"m2_g":15,"u1":[4,0],"alpha_deg":30,"stick":1}"#,
            "stick: invalid type: integer `1`, expected a boolean",
        ),
        (
            r#"{"m1_g":"15","m2_g":15,"u1":[4,0],"alpha_deg":30}"#,
            "m1_g: invalid type: string \"15\", expected a number",
        ),
        (
            r#"{"m1_g":15,"m1_g":15,"m2_g":15,"u1":[4,0],"alpha_deg":30}"#,
            "duplicate field `m1_g`",
        ),
        (
            r#"{"m1_g":15,"mass2":15,"u1":[4,0],"alpha_deg":30}"#,
            "unknown field `mass2`, expected one of `m1_g`, `m2_g`",
        ),
        (
            r#"{"m1_g":NaN,"m2_g":15,"u1":[4,0],"alpha_deg":30}"#,
            "m1_g: expected value at column",
        ),
        (
            r#"{"m1_g":1e999,"m2_g":15,"u1":[4,0],"alpha_deg":30}"#,
            "m1_g: number out of range at column",
        ),
        (r#"{"m1_g":15"#, "EOF while parsing"),
        (
            "[1,2]",
            "expected an object with m1_g, m2_g, u1 and alpha_deg",
        ),
        ("17", "expected an object with m1_g"),
        ("{} {}", "trailing characters"),
    ] {
        let error = refusal(line);
        assert!(error.contains(said), "{line}\n  {error}\n  {said}");
        assert!(!error.contains("line 1"), "{error}");
    }
}

#[test]
fn random_lines_are_refused_briefly_and_the_run_continues() {
    // A simple generator, so that the random bytes are the same every time.
    let mut state = 7_u32;
    let mut noise: Vec<u8> = std::iter::repeat_with(|| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    })
    .filter(|byte| *byte != b'\n')
    .take(10_000_000)
    .collect();
    noise.extend_from_slice(b"\n\xff\xfe{\"m1_g\":1}\n");
    noise.extend_from_slice(format!("{{\"{}\":1}}\n", "é".repeat(9000)).as_bytes());
    noise.extend_from_slice("[".repeat(60_000).as_bytes());
    noise.push(b'\n');
    noise.extend_from_slice(MARBLES.as_bytes());
    let (code, answers) = batch(&noise);
    assert_eq!((code, answers.len()), (Some(1), 5));
    assert_eq!(
        answers[0]["error"],
        "expected a line of at most 65536 bytes"
    );
    for refused in &answers[..4] {
        assert!(refused["error"].as_str().unwrap().chars().count() <= 203);
    }
    assert_eq!(answers[4]["hit"], true);
}

/// A program at the other end of a pipe gets each answer before it closes the pipe.
#[test]
fn an_answer_does_not_wait_for_the_end_of_input() {
    use std::io::{BufRead, BufReader};
    let mut child = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(["solve", "--batch"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let mut stdout = BufReader::new(child.stdout.take().unwrap());
    for _ in 0..3 {
        writeln!(stdin, "{MARBLES}").unwrap();
        let mut line = String::new();
        stdout.read_line(&mut line).unwrap();
        assert!(line.starts_with("{\"hit\":true"), "{line}");
    }
    drop(stdin);
    assert!(child.wait().unwrap().success());
}

#[test]
fn json_prints_one_object() {
    let text = printed(&[
        "--m1-g",
        "20",
        "--m2-g",
        "40",
        "--speed",
        "3",
        "--alpha-deg",
        "45",
        "--json",
    ]);
    assert_eq!(
        serde_json::from_str::<Value>(&text).unwrap(),
        answer(MARBLES)
    );
}

#[test]
fn the_worked_solution_substitutes_the_numbers() {
    let text = printed(&[
        "--m1-g",
        "20",
        "--m2-g",
        "40",
        "--speed",
        "3",
        "--alpha-deg",
        "45",
    ]);
    assert!(text.is_ascii());
    for part in [
        "m1 = 20 g   u1 = (3, 0) m/s",
        "n = (cos alpha, -sin alpha) = (0.7071, -0.7071)",
        "= [(20 - 1 x 40) x 2.121 + 2 x 40 x 0] / 60 = -0.7071 m/s",
        "v1 = v1_n n + v1_t t = (1, 2) m/s",
        "theta1 = 63.43 deg",
        "angle between the paths, from v1 to v2: 108.4 deg",
        "momentum after   m1v1 + m2v2 = (60, 0) g m/s",
        "more than a right angle",
    ] {
        assert!(words(&text).contains(&words(part)), "{part}\n{text}");
    }
}

/// Wrapped text joined into one line.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_worked_solution_mentions_special_cases() {
    let offset = |mm: &'static str| ["--r1-mm", "20.65", "--r2-mm", "15.9", "--offset-mm", mm];
    for (args, part) in [
        (
            &["--alpha-deg", "30"][..],
            "a right angle, as always for equal masses",
        ),
        (&["--alpha-deg", "0"], "The striker stops"),
        (&["--alpha-deg", "90"], "A graze"),
        (&offset("40"), "A miss"),
        (&offset("-18.275"), "alpha = -30 deg"),
        (&["--alpha-deg", "30", "--u2", "4,0"], "they never collide"),
        (
            &["--alpha-deg", "30", "--u2", "-4,0"],
            "In the frame in which the target was at rest it is 90 deg",
        ),
        (
            &["--alpha-deg", "30", "--speed", "0", "--u2", "-1,0"],
            "without an original direction there is no scattering angle",
        ),
        (
            &["--alpha-deg", "30", "--restitution", "0.8", "--m1-g", "12"],
            "mass is 0.8 times that of the target",
        ),
        (
            &["--alpha-deg", "30", "--m2-g", "5.5"],
            "The angle between their paths is 51.25 deg: less than a right angle",
        ),
        (&["--alpha-deg", "0", "--m1-g", "5.5"], "straight back"),
        (
            &["--alpha-deg", "30", "--stick"],
            "their centre of mass moves on at 2 m/s, and they rotate about it",
        ),
        (
            &["--alpha-deg", "0", "--stick"],
            "a head-on collision causes no rotation",
        ),
    ] {
        let text = printed(args);
        // Every symbol must have an ASCII spelling; without one it would become a question mark.
        let text = text.replace("at which impact angle?", "");
        let unwrapped = words(&text);
        assert!(unwrapped.contains(part), "{args:?}: {part}\n{text}");
        for never in ["NaN", "inf", "?", "-0 "] {
            assert!(!text.contains(never), "{args:?}: {never}\n{text}");
        }
        assert!(text.lines().all(|line| line.len() <= 80), "{text}");
    }
}

#[test]
fn invalid_arguments_are_refused_by_name() {
    for (args, said) in [
        (
            &["--alpha-deg", "95"][..],
            "--alpha-deg: expected degrees from -90 to 90, found 95",
        ),
        (
            &["--alpha-deg", "NaN"],
            "--alpha-deg: expected degrees from -90 to 90, found NaN",
        ),
        (&["--alpha-deg", "x"], "--alpha-deg"),
        (
            &["--alpha-deg", "30", "--m1-g", "-15"],
            "--m1-g: expected grams",
        ),
        (
            &["--alpha-deg", "30", "--m2-g", "inf"],
            "--m2-g: expected grams",
        ),
        (
            &["--alpha-deg", "30", "--speed", "1e200"],
            "--speed: expected a speed in m/s from -1e9 to 1e9",
        ),
        (
            &["--alpha-deg", "30", "--restitution", "-0.1"],
            "--restitution: expected a number from 0 to 1",
        ),
        (
            &["--alpha-deg", "30", "--u2", "1"],
            "expected two numbers in m/s separated by a comma",
        ),
        (
            &[
                "--alpha-deg",
                "30",
                "--offset-mm",
                "1",
                "--r1-mm",
                "1",
                "--r2-mm",
                "1",
            ],
            "cannot be used with",
        ),
        (&["--offset-mm", "1"], "--r1-mm"),
        (&[], "--alpha-deg: missing: expected this, or --offset-mm"),
        (&["--batch", "--m1-g", "3"], "cannot be used with"),
        (
            &["--alpha-deg", "30", "--stick", "--rim-friction", "0.1"],
            "cannot be used with",
        ),
        (&["--alpha-deg", "30", "--frobnicate"], "--frobnicate"),
    ] {
        let output = solve(args, b"");
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {error}");
        assert!(error.contains(said), "{args:?}: {error}");
        assert!(output.stdout.is_empty());
    }
}
