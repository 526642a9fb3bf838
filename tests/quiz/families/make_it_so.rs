//! "Make it so".

use carrom::quiz::{Answer, Confidence, Family, Form, Grade, Ray, Response};
use glam::DVec2;

use super::hit::Hit;
use super::owed::{all, assert_close, assert_family, figure, word};

#[test]
fn passes_the_checks_for_all_families() {
    assert_family(Family::MakeItSo);
}

#[test]
fn the_true_offset_sends_the_disc_in_the_given_direction() {
    for question in all(Family::MakeItSo) {
        let Form::Shot(aim) = question.form else {
            panic!("{question:#?}");
        };
        let figure = |name| figure(&question, name);
        let sine = 1000.0 * aim.offset / (figure("r1_mm") + figure("r2_mm"));
        let u = figure("speed") * DVec2::from_angle(figure("direction_deg").to_radians());
        let rays = Hit::new(figure("m1_g"), figure("m2_g"), 1.0, u, sine).rays();
        let (ray, name) = match word(&question, "asked") {
            "striker" => (Ray::Striker, "striker"),
            "target" => (Ray::Target, "coin"),
            other => panic!("{other}"),
        };
        assert_eq!(aim.ray, ray);
        // A scattering angle is positive to the left, a recoil angle to the right.
        let side = if word(&question, "side") == "left" {
            -1.0
        } else {
            1.0
        };
        let way = rays.get(ray).unwrap().to_degrees();
        assert_close(way, side * figure("wanted_deg"), &question);
        assert_close(aim.wanted.to_degrees(), way, &question);
        let to_left = (way > 0.0) == (ray == Ray::Striker);
        let told = format!(
            "Make the {name} leave at {:.1}° to the {} of ",
            figure("wanted_deg"),
            if to_left { "left" } else { "right" }
        );
        assert!(
            question.text.starts_with(&told),
            "{told}: {}",
            question.text
        );
    }
}

/// Any offset that sends the disc in the given direction is right, and so is an offset that is
/// slightly off.
#[test]
fn a_shot_is_graded_by_where_the_disc_goes() {
    for question in all(Family::MakeItSo).step_by(10) {
        let Form::Shot(aim) = question.form else {
            panic!("{question:#?}");
        };
        let graded = |offset| {
            let answer = Answer::new(Response::Shot(offset), Confidence::Sure);
            Grade::new(&question, &answer)
        };
        assert!(graded(aim.offset + 1e-4 * aim.collision.contact_distance()).right);
        let miss = graded(1.01 * aim.collision.contact_distance());
        assert!(!miss.right && miss.credit < 1e-12);
        let mirrored = graded(-aim.offset);
        assert!(!mirrored.right && mirrored.angle_error.is_some());
    }
}
