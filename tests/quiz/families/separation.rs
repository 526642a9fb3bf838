//! The angle between the paths.

use carrom::quiz::{Family, Form};

use super::hit::Hit;
use super::owed::{all, assert_close, assert_family, number, right_choice};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::Separation);
}

#[test]
fn the_true_angle_follows_from_an_impulse_along_the_line_of_centres() {
    for question in all(Family::Separation) {
        let corner_deg = Hit::of(&question).separation_deg();
        if let Form::Number { .. } = question.form {
            assert_close(number(&question), corner_deg, &question);
            continue;
        }
        let corner = match corner_deg - 90.0 {
            over if over > 1e-9 => "more than 90°",
            over if over < -1e-9 => "less than 90°",
            _ => "exactly 90°",
        };
        assert_eq!(right_choice(&question), corner, "{question:#?}");
    }
}

#[test]
fn every_choice_is_right_often_enough() {
    for corner in ["more than 90°", "exactly 90°", "less than 90°"] {
        let choices =
            all(Family::Separation).filter(|question| matches!(question.form, Form::Choice { .. }));
        let right = choices.filter(|question| right_choice(question) == corner);
        assert!(right.count() > 400, "{corner}");
    }
}
