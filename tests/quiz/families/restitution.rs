//! Questions about the coefficient of restitution.

use carrom::quiz::Family;

use super::hit::Hit;
use super::owed::{all, assert_close, assert_family, figure, number, right_choice, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::Restitution);
}

#[test]
fn the_true_answers_follow_from_an_impulse_along_the_line_of_centres() {
    for question in all(Family::Restitution) {
        let hit = Hit::of(&question);
        let e = figure(&question, "restitution");
        let square = || assert_close(hit.separation_deg(), 90.0, &question);
        match word(&question, "asked") {
            "striker" => {
                // Only one mass, less than the coin's, lets the striker leave at 90° to the coin.
                let coin_g = figure(&question, "m2_g");
                let at = |m1| Hit::new(m1, coin_g, e, hit.u, 0.5).separation_deg();
                assert_close(at(e * coin_g), 90.0, &question);
                assert!(e < 1.0 && at(coin_g) < 89.0 && at(2.0 * coin_g) < 89.0);
                assert_eq!(right_choice(&question), "for a certain lighter striker");
            }
            "e head-on" => {
                let parting = hit.v2.length() - hit.v1.length();
                assert_close(number(&question), parting / hit.u.length(), &question);
            }
            "striker mass" => {
                square();
                assert_close(number(&question), figure(&question, "m1_g"), &question);
            }
            "e square" => {
                square();
                assert_close(number(&question), e, &question);
            }
            "separation" => {
                assert_close(number(&question), hit.separation_deg(), &question);
            }
            "e angles" => {
                assert_close(number(&question), e, &question);
                // The printed angles are enough to find e.
                let rays = hit.rays();
                let tenths = |angle: Option<f64>| {
                    let deg = angle.unwrap().abs().to_degrees();
                    ((deg * 10.0).round() / 10.0).to_radians()
                };
                let (theta1, theta2) = (tenths(rays.striker), tenths(rays.target));
                let k = theta1.sin() / (theta2.cos() * (theta1 + theta2).sin());
                let found = k * (hit.m1 + hit.m2) / hit.m2 - 1.0;
                assert!((found - e).abs() < 0.02, "{found}: {question:#?}");
            }
            other => panic!("{other}"),
        }
    }
}
