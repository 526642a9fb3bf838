//! The picture of a question before it is answered.

use ratatui::{buffer::Buffer, layout::Rect};

use super::AnswerInput;
use crate::physics::Collision;
use crate::quiz::{Form, Illustration, Question, Response};
use crate::widgets::hit::{Face, Markings, after_picture, aim_picture, setup_picture};
use crate::widgets::picture::Picture;
use crate::widgets::tracks::tracks_picture;
use crate::widgets::{Look, sheet};

/// The picture of a question, which shows only the given information and the answer so far; `None`
/// for a question without a picture.
pub(crate) fn question_picture(
    area: Rect,
    question: &Question,
    input: Option<&AnswerInput>,
) -> Option<Picture> {
    Some(match (&question.picture, &question.form) {
        (Illustration::Before { shown, .. }, Form::Shot(aim)) => {
            let offset = match input.and_then(AnswerInput::said) {
                Some(Response::Shot(offset)) => offset,
                _ => 0.0,
            };
            let given = Markings {
                offset: true,
                ..*shown
            };
            aim_picture(area, aim, offset, given)
        }
        (Illustration::Before { collision, shown }, _) => {
            let rays = input.and_then(AnswerInput::rays);
            setup_picture(area, Face::STRIKER_AND_COIN, collision, *shown, rays)
        }
        (Illustration::After { collision }, _) => after_picture(area, collision),
        (Illustration::Tracks { rutherford, angles }, _) => {
            tracks_picture(area, rutherford, *angles)
        }
        (Illustration::Nothing, _) => return None,
    })
}

/// Draws the question's picture, if there is one.
pub fn draw_question(
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
    question: &Question,
    input: Option<&AnswerInput>,
) {
    if let Some(picture) = question_picture(area, question, input) {
        sheet::next_picture_shows(|| shows(question));
        picture.draw(buf, look);
    }
}

/// Describes what the picture shows beyond the text of the question. The text already describes the
/// whole collision unless it gives no numbers; in that case the picture contains all the
/// information.
fn shows(question: &Question) -> Vec<String> {
    match &question.picture {
        Illustration::Before { collision, shown } if !shown.figures => seen(collision, shown.angle),
        _ => Vec::new(),
    }
}

/// Describes a collision as far as it can be estimated by eye.
fn seen(collision: &Collision, line: bool) -> Vec<String> {
    let share = collision.offset / collision.contact_distance();
    let percent = (100.0 * share.abs()).round();
    let side = if share < 0.0 { "left" } else { "right" };
    let place = format!(
        "Seen along the striker's path, the target's centre lies to the {side} of the path, by \
         about {percent:.0} percent of the sum of the radii."
    );
    let alpha = collision.alpha().filter(|_| line).map(|alpha| {
        let alpha = (alpha.abs().to_degrees() / 5.0).round() * 5.0;
        format!("The line of impact is drawn, at about {alpha:.0}° to the path.")
    });
    [place].into_iter().chain(alpha).collect()
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::physics::Disc;
    use crate::physics::rutherford::Rutherford;
    use crate::quiz::{AimTask, Code, Markings, Measure, Ray, Round};
    use crate::widgets::cells::text;
    use crate::widgets::{Charset, Depth, Palette, Theme};

    const AREA: Rect = Rect::new(0, 0, 48, 20);

    fn drawn(picture: Illustration, form: Form) -> String {
        let round = Round::of(Code::hits(7));
        let question = Question {
            picture,
            form,
            ..round.questions()[0].clone()
        };
        let look = Look {
            charset: Charset::Ascii,
            theme: Theme::new(Palette::Dark, Depth::None),
            ..Look::default()
        };
        let mut buf = Buffer::empty(AREA);
        draw_question(AREA, &mut buf, &look, &question, None);
        text(&buf)
    }

    fn number() -> Form {
        Form::Number {
            quantity: Measure::Mass,
            truth: 10.0,
        }
    }

    fn hit(alpha_deg: f64) -> Collision {
        let (striker, coin) = (Disc::from_g_mm(15.0, 20.0), Disc::from_g_mm(5.5, 15.0));
        let u = DVec2::new(4.0, 0.0);
        Collision::at_angle(striker, coin, u, f64::to_radians(alpha_deg))
    }

    /// The picture gives the angles, but neither masses nor speeds.
    #[test]
    fn an_observed_collision_shows_only_its_angles() {
        let collision = hit(30.0);
        let outcome = collision.outcome();
        let picture = drawn(Illustration::After { collision }, number());
        for angle in [outcome.theta1, outcome.theta2] {
            let shown = format!("{:.1}", angle.unwrap().to_degrees());
            assert!(picture.contains(&shown), "{shown}\n{picture}");
        }
        assert!(
            !picture.contains("m/s") && !picture.contains(" g"),
            "{picture}"
        );
        // At twice the speed the picture looks the same.
        let faster = Collision {
            u1: 2.0 * collision.u1,
            ..collision
        };
        assert_eq!(
            drawn(Illustration::After { collision: faster }, number()),
            picture
        );
    }

    #[test]
    fn two_paths_past_a_nucleus_show_their_angles() {
        for angles in [[60.0, 120.0], [15.0, 90.0], [5.0, 10.0], [180.0, 0.0]] {
            let picture = drawn(
                Illustration::Tracks {
                    rutherford: Rutherford::radium_c_on_gold(),
                    angles: angles.map(f64::to_radians),
                },
                number(),
            );
            for angle in angles.into_iter().filter(|angle| *angle > 1.0) {
                assert!(picture.contains(&format!("{angle:.1}")), "{picture}");
            }
        }
    }

    #[test]
    fn a_shot_shows_its_target_mark() {
        let aim = AimTask {
            collision: hit(0.0),
            ray: Ray::Target,
            wanted: 0.7,
            offset: 0.01,
        };
        let picture = Illustration::Before {
            collision: aim.collision,
            shown: Markings::default(),
        };
        let picture = drawn(picture, Form::Shot(aim));
        assert!(
            picture.contains("mark") && picture.contains('*'),
            "{picture}"
        );
    }
}
