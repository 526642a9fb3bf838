//! Each goal is checked against the closed forms for one known hit.
//!
//! The striker starts along +x at 2 m/s; the coin, of equal mass, lies half of r1 + r2 to the right
//! of its path, so the impact angle is 30 degrees.

use carrom::levels::{Finding, Level, Patience, judge};

const HIT: &str = r#"
format = 1
[level]
id = "hit"
title = "A hit"
hints = ["Aim."]
explanation = "Half of r1 + r2 gives 30 degrees."
[[disc]]
kind = "striker"
at_mm = [-150, 0]
[[disc]]
kind = "white"
at_mm = [0, -18.275]
mass_g = 15
[[disc]]
kind = "queen"
at_mm = [0, 300]
[shot]
disc = 0
direction_deg = 0
speed = 2
[adjust]
direction_deg = [-30, 200]
[solution]
"#;

fn judged(goal: &str, direction_deg: f64) -> Finding {
    let text = format!("{HIT}direction_deg = {direction_deg}\n[[goal]]\n{goal}\n");
    let level = Level::read("hit.toml", text.as_bytes()).unwrap_or_else(|fault| panic!("{fault}"));
    let shot = level.aimed(&level.solution).play(Patience::AKey).unwrap();
    let [finding] = judge(&level, &shot).findings.try_into().unwrap();
    finding
}

fn met(goal: &str) {
    let finding = judged(goal, 0.0);
    assert!(finding.met, "{goal}: {}", finding.text);
}

fn missed(goal: &str, told: &str) {
    let finding = judged(goal, 0.0);
    assert!(!finding.met, "{goal}: {}", finding.text);
    assert_eq!(finding.text, told);
}

#[test]
fn the_coin_leaves_at_the_impact_angle_and_the_striker_at_90_degrees_to_it() {
    met("kind = \"turn\"\ndisc = 1\nbetween_deg = [29.999, 30.001]");
    met("kind = \"turn\"\ndisc = 0\nbetween_deg = [59.999, 60.001]");
    met("kind = \"separation\"\nbetween_deg = [89.999, 90.001]");
    missed(
        "kind = \"turn\"\ndisc = 1\nbetween_deg = [40, 50]",
        "the white coin left at 30.0°, required 40 to 50°",
    );
    missed(
        "kind = \"turn\"\ndisc = 2\nbetween_deg = [40, 50]",
        "the queen was not in the first hit",
    );
}

#[test]
fn the_coin_gets_three_quarters_of_the_energy() {
    met("kind = \"energy\"\ndisc = 1\nbetween_percent = [74.999, 75.001]");
    met("kind = \"energy\"\ndisc = 0\nbetween_percent = [24.999, 25.001]");
    missed(
        "kind = \"energy\"\ndisc = 0\nbetween_percent = [50, 60]",
        "the striker had 25 % of the energy, required 50 to 60 %",
    );
}

#[test]
fn speeds_are_measured_at_the_hit() {
    // The striker starts at 2 m/s and slides s = 150 mm - 36.55 mm cos 30 with a deceleration of
    // 0.12 g.
    let way = 0.150 - 0.03655 * 30_f64.to_radians().cos();
    let came = (4.0 - 2.0 * 0.12 * 9.80665 * way).sqrt();
    let (from, to) = (0.5 * came - 1e-6, 0.5 * came + 1e-6);
    met(&format!(
        "kind = \"speed\"\ndisc = 0\nbetween = [{from}, {to}]"
    ));
}

#[test]
fn circle_goals_are_met_by_paths_and_by_final_positions() {
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let a = 0.12 * 9.80665;
    let reach = 0.03655;
    let came_squared = 4.0 - 2.0 * a * (0.150 - reach * cos);
    // The striker leaves at 60 degrees with half its speed and hits nothing else.
    let slid = came_squared * sin * sin / (2.0 * a);
    let x = 1000.0 * (-reach * cos + slid * sin);
    let y = 1000.0 * (slid * cos);
    let circle = |x: f64, y: f64| format!("centre_mm = [{x}, {y}]\nradius_mm = 0.1");
    met(&format!("kind = \"rest\"\ndisc = 0\n{}", circle(x, y)));
    let halfway = circle(x - 500.0 * slid * sin, y - 500.0 * slid * cos);
    met(&format!("kind = \"pass\"\ndisc = 0\n{halfway}"));
    let finding = judged(&format!("kind = \"rest\"\ndisc = 0\n{halfway}"), 0.0);
    assert!(!finding.met);
    missed(
        &format!(
            "kind = \"rest\"\ndisc = 0\n{}",
            circle(x - 3.1 * cos, y + 3.1 * sin)
        ),
        "the striker came to rest 3.00 mm to the right of its circle",
    );
    for (ahead, where_to) in [(5.1, "short of"), (-5.1, "beyond")] {
        let circle = circle(x + ahead * sin, y + ahead * cos);
        missed(
            &format!("kind = \"rest\"\ndisc = 0\n{circle}"),
            &format!("the striker came to rest 5.00 mm {where_to} its circle"),
        );
    }
    missed(
        &format!("kind = \"pass\"\ndisc = 2\n{}", circle(0.0, 290.0)),
        "the queen passed 9.90 mm outside its circle",
    );
}

#[test]
fn pocket_and_contact_goals_report_what_happened() {
    met("kind = \"keep\"\ndisc = 1");
    met("kind = \"untouched\"\ndisc = 2");
    met("kind = \"untouched\"\ndisc = 1\nby = 2");
    missed(
        "kind = \"untouched\"\ndisc = 1",
        "the striker hit the white coin",
    );
    missed(
        "kind = \"bank\"\ndisc = 0\ntarget = 1",
        "the striker hit the white coin without a cushion",
    );
    missed(
        "kind = \"bank\"\ndisc = 0\ntarget = 2",
        "the striker hit another disc first",
    );
    // The queen never moves, and it is 351.01 mm from the pocket's centre at (347.75, 347.75).
    missed(
        "kind = \"pocket\"\ndiscs = [2]",
        "the queen came within 329 mm of a pocket",
    );
}

#[test]
fn a_hit_goal_requires_a_hit_by_the_given_disc() {
    met("kind = \"hit\"\ndisc = 1\nby = 0");
    met("kind = \"hit\"\ndisc = 0\nby = 1");
    missed(
        "kind = \"hit\"\ndisc = 2\nby = 1",
        "the white coin did not hit the queen",
    );
}

/// The striker is shot backwards, perpendicular to the left cushion, and returns along its path.
#[test]
fn cushions_are_counted() {
    let bank = "kind = \"bank\"\ndisc = 0\ntarget = 1";
    let once = judged(bank, 180.0);
    assert!(once.met);
    assert_eq!(once.text, "the striker hit the white coin off 1 cushion");
    let twice = judged(&format!("{bank}\nleast = 2"), 180.0);
    assert!(!twice.met);
    assert_eq!(twice.text, once.text);
    let hit = "kind = \"hit\"\ndisc = 1\nby = 0\nleast = 1";
    assert!(judged(hit, 180.0).met);
    missed(hit, "the striker hit the white coin off no cushion");
    let goal = "kind = \"cushions\"\ndisc = 0\nleast = 1";
    assert!(judged(goal, 180.0).met);
    missed(
        "kind = \"cushions\"\ndisc = 2\nleast = 1",
        "the queen hit no cushion",
    );
}

#[test]
fn without_a_hit_no_measured_goal_is_met() {
    for goal in [
        "kind = \"turn\"\ndisc = 0\nbetween_deg = [0, 180]",
        "kind = \"separation\"\nbetween_deg = [0, 180]",
        "kind = \"energy\"\ndisc = 0\nbetween_percent = [0, 100]",
        "kind = \"speed\"\ndisc = 0\nbetween = [0, 9]",
        "kind = \"bank\"\ndisc = 0\ntarget = 1",
    ] {
        let finding = judged(goal, 135.0);
        assert!(!finding.met, "{goal}: {}", finding.text);
    }
}

/// Discs shot straight at a pocket fall in the order in which they arrive.
#[test]
fn pocketed_discs_must_fall_in_the_required_order() {
    let text = |goal: &str| {
        format!(
            "format = 1\n\
             [level]\nid = \"row\"\ntitle = \"A row\"\nhints = [\"Aim.\"]\nexplanation = \"In a row.\"\n\
             [[disc]]\nkind = \"striker\"\nat_mm = [100, 100]\n\
             [[disc]]\nkind = \"white\"\nat_mm = [200, 200]\n\
             [shot]\ndisc = 0\ndirection_deg = 45\nspeed = 4\n\
             [adjust]\nspeed = [1, 5]\n[solution]\n[[goal]]\nkind = \"pocket\"\n{goal}\n"
        )
    };
    let judged = |goal: &str| {
        let level = Level::read("row.toml", text(goal).as_bytes()).unwrap();
        let shot = level.aimed(&level.solution).play(Patience::AKey).unwrap();
        judge(&level, &shot).findings.remove(0)
    };
    let right = judged("discs = [1, 0]");
    assert!(right.met);
    assert_eq!(right.text, "pocketed: the white coin, then the striker");
    let wrong = judged("discs = [0, 1]");
    assert!(!wrong.met);
    assert_eq!(
        wrong.text,
        "pocketed: the white coin, then the striker, in the wrong order"
    );
}
