//! Discs that slip, compared with discs that stick.

use carrom::quiz::Family;
use glam::DVec2;

use super::owed::{all, assert_close, assert_family, figure, number, right_choice, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::SlipOrStick);
}

#[test]
fn the_true_answers_follow_from_momentum_shared_along_the_line_of_impact_or_completely() {
    for question in all(Family::SlipOrStick) {
        let [m1, m2, u] = ["m1_g", "m2_g", "speed"].map(|name| figure(&question, name));
        let alpha = figure(&question, "alpha_deg").to_radians().abs();
        // In components along n and t: with e = 0 both discs have the same final component along n.
        let level = m1 * u * alpha.cos() / (m1 + m2);
        let (striker, target) = (DVec2::new(level, u * alpha.sin()), DVec2::new(level, 0.0));
        let energy = |m: f64, v: DVec2| 0.5 * m * v.length_squared();
        let (asked, rims) = (word(&question, "asked"), word(&question, "rims"));
        let expected = match asked {
            "separation" => striker.angle_to(target).abs().to_degrees(),
            "striker-speed" => striker.length(),
            "pair-speed" => m1 * u / (m1 + m2),
            "energy-lost" => {
                let before = 0.5 * m1 * u * u;
                100.0 * (1.0 - (energy(m1, striker) + energy(m2, target)) / before)
            }
            "picture" => {
                assert_close(m1, m2, &question);
                let expected = match rims {
                    "lossless" => "They move apart at exactly 90°",
                    "slip" => "They move apart at less than 90°",
                    "stick" => "They stay together and move on",
                    other => panic!("{other}"),
                };
                assert_eq!(right_choice(&question), expected);
                continue;
            }
            other => panic!("{other}"),
        };
        assert_eq!(
            rims,
            if asked == "pair-speed" {
                "stick"
            } else {
                "slip"
            }
        );
        assert_close(number(&question), expected, &question);
    }
}
