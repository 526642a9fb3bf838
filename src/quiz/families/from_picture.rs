//! Both rays from the picture alone: no figure is given, only what can be seen.

use super::hit_kinds::Kind;
use super::where_to::of_kinds;
use crate::quiz::dice::Dice;
use crate::quiz::{Difficulty, Family, Illustration, Markings, Question};

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let question = of_kinds(Family::FromPicture, difficulty, &[Kind::EqualAngle], dice)?;
    let (line, eye) = match difficulty {
        Difficulty::Easy => (
            true,
            "The dashed line is the line of impact. Look at the picture:",
        ),
        Difficulty::Middle | Difficulty::Hard => (
            false,
            "Find the line of impact in the picture, where the two will touch:",
        ),
    };
    let collision = *question.picture.collision()?;
    Some(Question {
        topic: "from-the-picture".into(),
        text: format!(
            "Two alike, one at rest, no energy lost, and no figures. {eye} where will they go?"
        ),
        picture: Illustration::Before {
            collision,
            shown: Markings {
                offset: false,
                angle: line,
                figures: false,
            },
        },
        ..question
    })
}
