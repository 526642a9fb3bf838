//! The centre-of-mass frame.

use carrom::quiz::Family;
use glam::DVec2;

use super::hit::Hit;
use super::owed::{all, assert_close, assert_family, figure, number, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::CentreOfMass);
}

fn between_deg(a: DVec2, b: DVec2) -> f64 {
    a.perp_dot(b).atan2(a.dot(b)).abs().to_degrees()
}

#[test]
fn the_true_answers_follow_from_velocities_relative_to_the_centre_of_mass() {
    for question in all(Family::CentreOfMass) {
        let hit = Hit::of(&question);
        let centre = hit.m1 * hit.u / (hit.m1 + hit.m2);
        let turn = between_deg(hit.u - centre, hit.v1 - centre);
        let expected = match word(&question, "asked") {
            "turn" => turn,
            "centre-speed" => {
                let target = figure(&question, "target_speed") * hit.u.normalize();
                ((hit.m1 * hit.u + hit.m2 * target) / (hit.m1 + hit.m2)).length()
            }
            "theta1" => {
                assert_close(turn, figure(&question, "turn_deg"), &question);
                between_deg(hit.u, hit.v1)
            }
            "theta2" => {
                assert_close(turn, figure(&question, "turn_deg"), &question);
                between_deg(hit.u, hit.v2)
            }
            other => panic!("{other}"),
        };
        assert_close(number(&question), expected, &question);
    }
}
