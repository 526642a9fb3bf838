//! A question's picture, and the answer being entered.

mod answer_input;
mod asking;
mod question_picture;

pub(crate) use answer_input::{AnswerAction, AnswerInput};
pub(crate) use asking::{Asking, AskingAction, lettered, write_beside_truth};
pub use question_picture::draw_question;
pub(crate) use question_picture::question_picture;
