//! The greatest deflection of a striker, found by trying every offset.

use carrom::quiz::{Family, Question};
use glam::DVec2;

use super::hit::Hit;
use super::owed::{all, assert_family, figure, number, right_choice, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::LargestDeflection);
}

/// The deflection of the striker at this impact angle, in degrees; 0 if it stops.
fn turned_deg(question: &Question, alpha_deg: f64) -> f64 {
    let [m1, m2, e] = ["m1_g", "m2_g", "restitution"].map(|name| figure(question, name));
    let hit = Hit::new(m1, m2, e, DVec2::X, alpha_deg.to_radians().sin());
    hit.rays().striker.unwrap_or(0.0).abs().to_degrees()
}

/// The greatest deflection and the impact angle that gives it, in degrees, found by a search with
/// smaller and smaller steps.
fn most(question: &Question) -> (f64, f64) {
    let mut best = 0.0;
    let mut step = 1.0;
    for _ in 0..30 {
        let around = (-90..=90).map(|i| best + step * f64::from(i));
        best = around
            .filter(|alpha_deg| (0.0..=90.0).contains(alpha_deg))
            .max_by(|a, b| turned_deg(question, *a).total_cmp(&turned_deg(question, *b)))
            .unwrap();
        step /= 2.0;
    }
    (turned_deg(question, best), best)
}

#[test]
fn the_greatest_deflection_is_the_greatest_over_all_offsets() {
    // The search is slow, so every combination of masses, e and question is checked once.
    let mut seen = std::collections::BTreeSet::new();
    for question in all(Family::LargestDeflection) {
        let masses = ["m1_g", "m2_g", "restitution"].map(|name| figure(&question, name));
        if !seen.insert(format!("{masses:?} {}", word(&question, "asked"))) {
            continue;
        }
        let (turned_deg, alpha_deg) = most(&question);
        // The position of a maximum is found only to the square root of the rounding error.
        let near = |x: f64, y: f64, within: f64| {
            assert!((x - y).abs() <= within, "{x} is not {y}: {question:#?}");
        };
        match word(&question, "asked") {
            "limit" => {
                let limit = match turned_deg {
                    most if most > 179.0 => "up to 180°, straight back",
                    most if most > 89.0 => "up to nearly 90°, but no further",
                    _ => "up to an angle well below 90°",
                };
                assert_eq!(right_choice(&question), limit, "{question:#?}");
            }
            "theta1" => near(number(&question), turned_deg, 1e-9),
            "alpha" => near(number(&question), alpha_deg, 1e-5),
            "offset" => {
                let reach_mm = figure(&question, "r1_mm") + figure(&question, "r2_mm");
                near(
                    number(&question),
                    reach_mm * alpha_deg.to_radians().sin(),
                    1e-5,
                );
            }
            other => panic!("{other}"),
        }
    }
}
