//! Two equal discs that both move.

use carrom::quiz::Family;
use glam::DVec2;

use super::owed::{all, assert_close, assert_family, figure, number, right_choice, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::BothMoving);
}

fn between_deg(a: DVec2, b: DVec2) -> f64 {
    a.perp_dot(b).atan2(a.dot(b)).abs().to_degrees()
}

#[test]
fn the_true_answers_follow_from_an_exchange_along_the_line_of_impact() {
    for question in all(Family::BothMoving) {
        let figure = |name| figure(&question, name);
        let along = |deg: f64| DVec2::from_angle((figure("direction_deg") + deg).to_radians());
        let u1 = figure("speed") * along(0.0);
        let u2 = figure("target_speed") * along(figure("target_deg"));
        let line = along(figure("line_deg"));
        let exchanged = (u1 - u2).dot(line) * line;
        let (v1, v2) = (u1 - exchanged, u2 + exchanged);
        assert!((u1 - u2).dot(line) > 0.0, "they never meet: {question:#?}");
        let on_board = between_deg(v1, v2);
        // The picture shows the calculated collision.
        let drawn = question.picture.collision().unwrap().outcome();
        assert!((drawn.v1 - v1).length() < 1e-9 && (drawn.v2 - v2).length() < 1e-9);
        // The angle is 90° in the coin's initial frame and 180° in the centre-of-mass frame.
        assert_close(between_deg(v1 - u2, v2 - u2), 90.0, &question);
        let centre = (u1 + u2) / 2.0;
        assert_close(between_deg(v1 - centre, v2 - centre), 180.0, &question);
        match word(&question, "asked") {
            "who" => {
                assert!(right_choice(&question).contains("as the coin did at first"));
                assert!((on_board - 90.0).abs() > 0.5, "{question:#?}");
            }
            "from-the-coin" => assert!(right_choice(&question).contains("90°")),
            "from-the-centre" => assert!(right_choice(&question).contains("180°")),
            "on-the-board" => {
                let expected = match on_board - 90.0 {
                    off if off.abs() < 1e-9 => "Exactly 90°",
                    off if off > 4.0 => "More than 90°",
                    off if off < -4.0 => "Less than 90°",
                    off => panic!("{off}: {question:#?}"),
                };
                assert_eq!(right_choice(&question), expected);
            }
            "separation" => assert_close(number(&question), on_board, &question),
            "striker-speed" => assert_close(number(&question), v1.length(), &question),
            "target-speed" => assert_close(number(&question), v2.length(), &question),
            other => panic!("{other}"),
        }
    }
}
