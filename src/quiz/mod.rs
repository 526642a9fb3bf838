//! Questions, grading, misconceptions.
//!
//! A [`Round`] is a list of [`Question`]s fixed by a [`Code`]. Each question belongs to a
//! [`Family`], which draws the figures and knows the true answer and the answer that each
//! [`Misconception`] leads to. The player gives an [`Answer`]: a [`Response`] in the question's
//! [`Form`], and how sure they are. [`Grade`] rates the answer, [`Question::belief_of`] finds the
//! known misconception that it fits, and [`explain()`] explains the right answer.
//!
//! The [`concepts`] are questions in words, written by hand.
//!
//! ```text
//!    rounds          courses, codes, reviews
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    families        what each family of questions draws and asks
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    concepts        questions in words, read from files
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    misconceptions  what students believe, and the feedback
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    question        a question, its answer, its grade
//! ```
//!
//! Nothing here draws on a screen, and all random choices follow from the seed.

pub mod concepts;
mod families;
pub mod misconceptions;
mod question;
mod rounds;

pub use families::where_to::hits;
pub use misconceptions::{Clue, Origin, explain, named, why};
pub(crate) use misconceptions::{Evidence, NAMED_ODDS, evidence, why_of_hit};
pub(crate) use question::{AimTask, Markings, Passage, RayGrade, RaysGrade, figures};
pub use question::{
    Answer, Confidence, Dice, Difficulty, Family, Figures, Fit, Form, Grade, Hit, Illustration,
    MIN_SEPARATION, Measure, Misconception, Pieces, Question, RIGHT_DEG, Ray, Rays, Response,
    Topic, WrongAnswer, letter,
};
pub(crate) use rounds::ChaptersRead;
pub use rounds::{Code, Course, CourseKind, Round};
