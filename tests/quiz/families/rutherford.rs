//! Rutherford's counts.

use carrom::quiz::{Family, Illustration};

use super::owed::{all, assert_close, assert_family, figure, number, right_choice, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::Rutherford);
}

/// The count at an angle is proportional to the area of a ring of offsets divided by the solid
/// angle into which the ring is scattered: b db / (sin Θ dΘ), with b = cot(Θ/2). Written without
/// half angles, cot(Θ/2) = (1 + cos Θ) / sin Θ, and sin⁴(Θ/2) = (1 − cos Θ)² / 4.
fn count(angle_deg: f64) -> f64 {
    4.0 / (1.0 - angle_deg.to_radians().cos()).powi(2)
}

#[test]
fn the_formula_agrees_with_the_areas_of_rings() {
    let offset = |deg: f64| (1.0 + deg.to_radians().cos()) / deg.to_radians().sin();
    for tens in 2..17 {
        let (deg, step) = (10.0 * f64::from(tens), 1e-4);
        let ring = offset(deg - step).powi(2) - offset(deg + step).powi(2);
        let cosine = |deg: f64| deg.to_radians().cos();
        let found = ring / (cosine(deg - step) - cosine(deg + step));
        // d(b²) = 2b db, and 2b db / (sin Θ dΘ) = 1 / (2 sin⁴(Θ/2)). `count` returns 1 / sin⁴(Θ/2),
        // so the ratio is 1/2.
        assert!(
            (found / count(deg) / 0.5 - 1.0).abs() < 1e-6,
            "{deg}: {found}"
        );
    }
}

#[test]
fn the_true_answers_follow_from_the_law() {
    for question in all(Family::Rutherford) {
        let here = figure(&question, "angle_deg");
        match word(&question, "asked") {
            "choice" => {
                let times = count(here) / count(figure(&question, "to_deg"));
                let said = right_choice(&question);
                let said = said.trim_end_matches(" as many").trim_end_matches(" times");
                let said: f64 = match said.split_once('/') {
                    Some((one, n)) => one.parse::<f64>().unwrap() / n.parse::<f64>().unwrap(),
                    None => said.parse().unwrap(),
                };
                assert_close(said, times, &question);
            }
            "ratio" => {
                let energy = figure(&question, "energy_mev");
                let other = question.figures.get("to_energy_mev");
                let other = other.map_or(energy, |it| it.as_f64().unwrap());
                let times = count(here) / count(figure(&question, "to_deg"));
                assert_close(
                    number(&question),
                    times * (other / energy).powi(2),
                    &question,
                );
            }
            "angle" => {
                let fewer = count(here) / count(number(&question));
                assert_close(fewer, figure(&question, "fewer_times"), &question);
                assert_eq!(
                    question.picture,
                    Illustration::Nothing,
                    "a picture would give the answer away"
                );
            }
            other => panic!("{other}"),
        }
    }
}
