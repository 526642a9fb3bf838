//! Questions, grading, misconceptions.
//!
//! A [`Round`] is a list of [`Question`]s fixed by a [`Code`]. Each belongs to a
//! [`Family`], which draws its figures and knows the true answer and what each
//! [`Misconception`] would answer. The player gives an [`Answer`]: what is [`Response`] in
//! the [`Form`] the question asks for, and how sure they are. [`Grade`] says how good it
//! is, [`Question::diagnose`] which known misconception it fits, [`explain()`] why the
//! truth is true, and [`Summary`] looks back over the round.
//!
//! The [`concepts`] are questions in words, written by hand.
//!
//! Nothing here draws, and nothing is random but what follows from the seed.

mod answer;
pub mod concepts;
mod confidence;
mod course;
mod dice;
mod difficulty;
mod explain;
mod families;
mod form;
mod grade;
mod hit;
pub mod misconceptions;
mod picture;
mod pieces;
mod quantity;
mod question;
mod rays;
mod reasoning;
mod review;
mod round;
mod summary;
mod topic;

pub use answer::{Answer, Response};
pub use confidence::Confidence;
pub use course::{Code, Course, CourseKind};
pub use dice::Dice;
pub use difficulty::Difficulty;
pub use explain::{Explanation, explain};
pub use families::Family;
pub use families::where_to::hits;
pub use form::{AimTask, Form, letter};
pub use grade::{Grade, RIGHT_DEG, RayGrade, RaysGrade};
pub use hit::{Hit, Placement};
pub use misconceptions::Misconception;
pub use picture::{Illustration, Markings};
pub use pieces::Pieces;
pub use quantity::Measure;
pub use question::{Diagnosis, Fit, MIN_SEPARATION, Question, WrongAnswer};
pub use rays::{Ray, Rays};
pub use reasoning::reasoning;
pub use round::Round;
pub use summary::{ENOUGH_ANGLES, Summary, SummaryLine};
pub use topic::Topic;
