//! Finding masses from what can be seen after the collision: the mass follows from the figures in
//! the text, as a player reads them.

use carrom::quiz::{Family, Illustration, Measure, Question};

use super::owed::{all, assert_family, figure, number, right_choice, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::Weigh);
}

/// The number before the occurrence of `unit` with the index `n`.
fn read(question: &Question, unit: &str, n: usize) -> f64 {
    let before = question.text.split(unit).nth(n).unwrap();
    let number = before.rsplit(' ').next().unwrap();
    number
        .parse()
        .unwrap_or_else(|_| panic!("{number:?}: {question:#?}"))
}

#[test]
fn the_numbers_in_the_text_give_the_mass() {
    for question in all(Family::Weigh) {
        assert!(matches!(question.picture, Illustration::After { .. }));
        let theta1 = read(&question, "°", 0).to_radians();
        let theta2 = read(&question, "°", 1).to_radians();
        let coin_g = figure(&question, "m2_g");
        let e = figure(&question, "restitution");
        let k = theta1.sin() / (theta2.cos() * (theta1 + theta2).sin());
        let striker_g = || read(&question, " g ", 0);
        let found = match word(&question, "asked") {
            "which" => {
                let weight = match (theta1 + theta2).to_degrees() - 90.0 {
                    over if over > 0.15 => "heavier than the striker",
                    over if over < -0.15 => "lighter than the striker",
                    _ => "as heavy as the striker",
                };
                assert_eq!(right_choice(&question), weight, "{question:#?}");
                continue;
            }
            "momentum" => {
                let (v1, v2) = (read(&question, " m/s", 1), read(&question, " m/s", 2));
                striker_g() * v1 * theta1.sin() / (v2 * theta2.sin())
            }
            // k = (1 + e) m2 / (m1 + m2)
            "angles" => striker_g() * k / (1.0 + e - k),
            other => panic!("{other}"),
        };
        assert!((number(&question) - coin_g).abs() < 1e-9);
        let off = Measure::Mass.distance(found, coin_g);
        assert!(off < 0.5, "{found}: {question:#?}");
    }
}
