//! A question, its answer and its grade: the lowest layer of the quiz.

mod answer;
mod confidence;
mod dice;
mod difficulty;
mod family;
mod figures;
mod form;
mod grade;
mod hit;
mod illustration;
mod kept;
mod measure;
mod misconception;
mod passage;
mod pieces;
#[expect(
    clippy::module_inception,
    reason = "a question is the subject of this module"
)]
mod question;
mod rays;
mod tolerance;
mod topic;

pub use answer::{Answer, Response};
pub use confidence::Confidence;
pub use dice::Dice;
pub use difficulty::Difficulty;
pub use family::Family;
pub use figures::Figures;
pub(crate) use figures::figures;
pub(crate) use form::AimTask;
pub use form::{Form, letter};
pub use grade::Grade;
pub(crate) use grade::{RayGrade, RaysGrade};
pub use hit::Hit;
pub use illustration::Illustration;
pub(crate) use illustration::Markings;
pub use measure::Measure;
pub use misconception::Misconception;
pub(crate) use passage::Passage;
pub use pieces::Pieces;
pub(super) use question::nearest;
pub use question::{Fit, MIN_SEPARATION, Question, WrongAnswer};
pub use rays::{Ray, Rays};
pub use tolerance::RIGHT_DEG;
pub use topic::Topic;
pub(in crate::quiz) use topic::case;
