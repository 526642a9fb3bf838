//! A set of questions that a teacher has put together.

use super::Concept;
use crate::quiz::question::Question;

/// Questions that a teacher has put together, in the order in which they are asked.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct QuestionSet {
    /// The title of the set.
    pub title: String,
    /// The questions, no two of which are the same.
    pub questions: Vec<ChosenQuestion>,
    /// The number at the end of the set's code. It follows from the choice and the order of the
    /// questions, so that a round can tell whether its set is still the same.
    pub seed: u64,
}

/// A question of a set.
#[derive(Debug, Clone, PartialEq)]
pub struct ChosenQuestion {
    /// The question.
    pub question: Question,
    /// Where the question comes from: "speeds-7, question 3", or the id of a question in words.
    pub source: String,
    /// The reason why the question is in the set.
    pub reason: Option<String>,
    /// The question in words, if the question was chosen by its id.
    pub(in crate::quiz) concept: Option<Concept>,
}
