//! A question's picture, and the answer that is being given to it.

mod answer_input;
mod question_picture;

pub use answer_input::{AnswerAction, AnswerInput};
pub use question_picture::{draw_question, question_picture};
