//! Shares of energy.

use carrom::quiz::Family;

use super::hit::Hit;
use super::owed::{all, assert_close, assert_family, number, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::EnergyShare);
}

#[test]
fn the_true_share_follows_from_the_speeds_after_an_impulse() {
    for question in all(Family::EnergyShare) {
        let (kept, passed) = Hit::of(&question).energy_shares();
        let share = match word(&question, "asked") {
            "kept" => kept,
            "passed" => passed,
            "lost" => 1.0 - kept - passed,
            other => panic!("{other}"),
        };
        assert_close(number(&question), 100.0 * share, &question);
    }
}
