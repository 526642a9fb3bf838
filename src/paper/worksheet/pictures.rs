//! The pictures of the questions and of the answers.

use ratatui::layout::Rect;

use super::Worksheet;
use crate::paper::svg;
use crate::physics::Collision;
use crate::quiz::{Form, Illustration, Question};
use crate::widgets::hit::{Overlay, Overlays, Watch, protractor_picture, scale_picture};
use crate::widgets::question_picture;
use crate::widgets::svg::Svg;

/// A picture with the name of its file.
#[derive(Debug)]
pub struct WorksheetPicture {
    /// The name of the file: "question-01.svg".
    pub name: String,
    /// The picture as a vector drawing.
    pub svg: Svg,
}

impl WorksheetPicture {
    /// The picture of the [`QUESTION`] or the [`ANSWER`] with this number, counted from 1.
    pub(super) fn new(of: &str, number: usize, svg: Option<Svg>) -> Option<Self> {
        let name = format!("{of}{number:02}.svg");
        svg.map(|svg| Self { name, svg })
    }

    /// Whether a file with this name is a picture of a worksheet: `answer-07.svg`.
    pub(crate) fn is_file_name(name: &str) -> bool {
        let name = name.strip_suffix(".svg");
        let number = name.and_then(|it| it.strip_prefix(QUESTION).or(it.strip_prefix(ANSWER)));
        number.is_some_and(|it| it.len() >= 2 && it.bytes().all(|byte| byte.is_ascii_digit()))
    }
}

/// The beginnings of the names of files.
pub(super) const QUESTION: &str = "question-";
pub(super) const ANSWER: &str = "answer-";

/// The size, in columns and rows, of a picture that students do not draw in.
const AREA: Rect = Rect::new(0, 0, 44, 18);

impl Worksheet<'_> {
    /// All pictures in the Markdown documents.
    pub fn pictures(&self) -> Vec<WorksheetPicture> {
        let questions = (1..).zip(self.round.questions());
        let pictures = questions.flat_map(|(number, question)| {
            let asked = WorksheetPicture::new(QUESTION, number, of_question(question));
            let solved = WorksheetPicture::new(ANSWER, number, of_answer(question));
            [asked, solved]
        });
        pictures.flatten().collect()
    }
}

/// The picture of a question, without the answer. It has a protractor if the answer is two
/// directions, and a scale if it is an offset.
pub(super) fn of_question(question: &Question) -> Option<Svg> {
    picture(question, true)
}

/// Like [`of_question`], but without a protractor, for a screen.
pub(crate) fn on_screen(question: &Question) -> Option<Svg> {
    picture(question, false)
}

fn picture(question: &Question, with_protractor: bool) -> Option<Svg> {
    let drawn = || question_picture(AREA, question, None);
    let (picture, words) = match (&question.picture, &question.form) {
        (Illustration::Before { .. }, Form::Shot(aim)) => {
            let words = "A striker on its way to a disc at rest, a scale of offsets across its \
                         path, and the required direction of one disc, seen from above";
            (scale_picture(aim), words.into())
        }
        (Illustration::Before { collision, shown }, Form::Rays { .. }) if with_protractor => {
            let words = words(collision, ", with an empty protractor for both directions");
            (protractor_picture(collision, *shown), words)
        }
        (Illustration::Before { collision, .. }, _) => (drawn()?, words(collision, "")),
        (Illustration::After { collision }, _) => {
            (drawn()?, words(collision, ", with both final paths"))
        }
        (Illustration::Tracks { .. }, _) => {
            let words = "Two particles pass a nucleus, each deflected by an angle";
            (drawn()?, words.into())
        }
        (Illustration::Nothing, _) => return None,
    };
    Some(svg(&words, &picture))
}

/// The true collision of a question, with all its values.
pub(crate) fn of_answer(question: &Question) -> Option<Svg> {
    let collision = match &question.form {
        Form::Shot(aim) => aim.with(aim.offset),
        _ => *question.picture.collision()?,
    };
    let mut layers = Overlays::default();
    for layer in [Overlay::Triangle, Overlay::Trails] {
        layers.toggle(layer);
    }
    let watch = Watch::revealed(collision)
        .with_layers(layers)
        .with_measures();
    let words = words(&collision, ", with both final paths");
    Some(svg(&words, &watch.picture(AREA)))
}

/// The text alternative of a picture, without anything that the picture does not show.
fn words(collision: &Collision, after: &str) -> String {
    let meets = match collision.alpha() {
        Some(_) => "A striker meets",
        None => "A striker passes",
    };
    let target = if collision.u2.length() > 0.0 {
        "another moving disc"
    } else {
        "a disc at rest"
    };
    format!("{meets} {target}{after}, seen from above")
}
