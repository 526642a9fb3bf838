//! Speeds after the collision.

use carrom::quiz::Family;

use super::hit::Hit;
use super::owed::{all, assert_close, assert_family, number, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::Speeds);
}

#[test]
fn the_true_speed_follows_from_an_impulse_along_the_line_of_centres() {
    for question in all(Family::Speeds) {
        let hit = Hit::of(&question);
        let speed = match word(&question, "asked") {
            "striker" => hit.v1.length(),
            "target" => hit.v2.length(),
            other => panic!("{other}"),
        };
        assert_close(number(&question), speed, &question);
    }
}
