//! Rounds: their questions, and the codes that fix them.

mod chapters_read;
mod course;
mod even;
mod find_out;
mod forms;
mod review;
mod round;
mod set;

pub(crate) use chapters_read::ChaptersRead;
pub use course::{Code, Course, CourseKind};
pub use round::Round;
