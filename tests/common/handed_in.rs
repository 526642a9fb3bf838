//! Invented hand-ins of pupils.

use carrom::gradebook::HandIn;
use carrom::progress::Attempt;
use carrom::quiz::{Answer, Code, Confidence, Question, Round};

/// An answer to a question of mixed-7 at a given time: the right answer, or the answer of the first
/// misconception that the question can reveal.
fn answer(player: &str, time_s: i64, number: usize, question: &Question, right: bool) -> Attempt {
    let code = Code::parse("mixed-7").unwrap();
    let said = match right {
        true => question.form.truth(),
        false => question.beliefs[0].said,
    };
    let answer = Answer::new(said, Confidence::Sure);
    let number = u32::try_from(number + 1).unwrap();
    Attempt {
        time_s: Some(time_s),
        ..Attempt::of_quiz(player, &code, number, question, &answer)
    }
}

/// The hand-in of pupil `index`, who has answered the first `count` questions, the first `right` of
/// them correctly.
pub(crate) fn hand_in(index: i64, name: &str, count: usize, right: usize) -> HandIn {
    let round = Round::of(Code::parse("mixed-7").unwrap());
    let asked = round.questions().iter().enumerate().take(count);
    let answers = asked.map(|(i, question)| {
        let time = 1_770_000_000 + 10_000 * index + 60 * i as i64;
        answer(name, time, i, question, i < right)
    });
    HandIn::new(name, "10b", answers.collect())
}
