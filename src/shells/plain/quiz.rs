//! A round of the quiz in lines.

use std::sync::Arc;

use super::answering::{answer, confidence};
use super::by_words::by_words;
use super::picture::describe;
use super::recorder::AnswerRecorder;
use super::spoken::{sentence, verbatim};
use super::talk::{Leave, Talk};
use crate::lessons::Book;
use crate::messages::{StoreReply, StoreRequest};
use crate::progress::{Attempt, Due};
use crate::quiz::concepts::Library;
use crate::quiz::{
    Answer, Code, Course, CourseKind, Grade, Misconception, Passage, Question, Round, Summary,
    Topic, explain,
};

/// Plays the round of a code, or asks which round it shall be; `seed` fixes what is left
/// to chance then.
///
/// # Errors
/// If the player quits, or nothing more is to be heard: what was answered is kept.
pub fn quiz(
    recorder: &mut AnswerRecorder,
    code: Option<Code>,
    seed: u64,
    own: &Arc<Library>,
) -> Result<(), Leave> {
    let greeting = "carrom, the quiz. Type help at any question, and quit to leave.";
    recorder.talk.say(greeting)?;
    let round = match code {
        Some(code) => Round::of(code),
        None => choose(recorder, seed, own)?,
    };
    let seed = round.code().seed;
    let found = play(recorder, round)?;
    let Some(misconception) = found else {
        return Ok(());
    };
    let asked = "Two questions to check it? Type yes or no.";
    let help = "They ask what could show it once more, and you hear at once how it is.";
    let checks = recorder.talk.ask_for(&[], asked, help, |heard| {
        match heard.to_lowercase().as_str() {
            "yes" | "y" => Ok(true),
            "no" | "n" => Ok(false),
            _ => Err("Please type yes or no.".to_owned()),
        }
    })?;
    if checks {
        let course = Course::new(CourseKind::Check(misconception));
        play(recorder, Round::new(course, seed))?;
    }
    Ok(())
}

/// Asks which round it shall be.
fn choose(recorder: &mut AnswerRecorder, seed: u64, own: &Arc<Library>) -> Result<Round, Leave> {
    let due = due(recorder)?;
    let always = CourseKind::ALWAYS.map(|kind| {
        let most = match Course::new(kind.clone()).follows_answers() {
            true => "up to ",
            false => "",
        };
        let about = format!("{}, {most}{} questions", kind.name(), kind.length());
        (about, kind)
    });
    let mut kinds = always.to_vec();
    if let Some(review) = due.course() {
        let first: Vec<_> = due.first().iter().map(Topic::name).collect();
        let all = due.now.len();
        let about = match all - first.len() {
            0 => format!("review what is due: {}", first.join("; ")),
            _ => format!("review {} of {all} due: {}", first.len(), first.join("; ")),
        };
        kinds.push((about, review));
    }
    if !own.concepts.is_empty() {
        let about = format!("your own questions, of {}", own.concepts.len());
        kinds.push((about, CourseKind::Own(Arc::clone(own))));
    }
    for family in CourseKind::topics() {
        let about = format!("topic: {}", family.name());
        kinds.push((about, CourseKind::Topic(family)));
    }
    let mut lead = vec!["Which round?".to_owned()];
    let each = (1..).zip(&kinds);
    lead.extend(each.map(|(number, (about, _))| format!("{number}: {}", sentence(about))));
    lead.extend(own.problems.iter().map(|problem| {
        let problem = verbatim(&problem.to_string());
        format!("Left out of your own questions: {problem}.")
    }));
    let asked = "Type its number, or the code of a round, such as mixed-7.";
    let help = "Mixing the kinds of question feels harder than one kind at a time, and it is what \
                makes them stay.";
    recorder.talk.ask_for(&lead, asked, help, |heard| {
        let number: Option<usize> = heard.parse().ok();
        let chosen = number.and_then(|number| kinds.get(number.checked_sub(1)?));
        if let Some((_, kind)) = chosen {
            return Ok(Round::new(Course::new(kind.clone()), seed));
        }
        match Code::parse(heard).and_then(|code| code.with_own(own).ok()) {
            Some(code) if number.is_none() => Ok(Round::of(code)),
            _ => Err(format!(
                "Please type a number from 1 to {}, or a code such as mixed-7.",
                kinds.len()
            )),
        }
    })
}

/// What is due for this player.
fn due(recorder: &mut AnswerRecorder) -> Result<Due, Leave> {
    let player = recorder.player.to_owned();
    match recorder.wish(StoreRequest::Recall(Some(player)))? {
        StoreReply::Recalled(Ok(history)) => Ok(Due::of(&history.attempts, &history.calendar)),
        _ => Ok(Due::default()),
    }
}

/// Plays a round to its end; gives the misconception that was found out, where that was asked
/// for.
fn play(recorder: &mut AnswerRecorder, mut round: Round) -> Result<Option<Misconception>, Leave> {
    let at_end = round.course().tells_at_end();
    let mut answered: Vec<(Question, Answer)> = Vec::new();
    let outcome = ask_all(recorder, &mut round, &mut answered);
    let round = &round;
    let talk = &mut *recorder.talk;
    // Whoever leaves an exam hears of what was answered, too.
    if at_end && !matches!(outcome, Err(Leave::Failed(_))) {
        for (number, (question, answer)) in (1..).zip(&answered) {
            talk.say(&format!("Answer {number}. {}", by_words(&question.text)))?;
            tell(talk, question, answer)?;
        }
    }
    match outcome {
        Err(Leave::Quit) if answered.is_empty() => talk.say("Goodbye.")?,
        Err(Leave::Failed(error)) => return Err(Leave::Failed(error)),
        Err(Leave::Ended) if answered.is_empty() => {}
        _ => sum_up(talk, round, &answered)?,
    }
    outcome?;
    let follows = round.course().follows_answers();
    let named = follows.then(|| look_back(&answered).most_held()).flatten();
    Ok(named.map(|(misconception, _)| misconception))
}

/// Asks all questions of a round, and notes what was answered.
fn ask_all(
    recorder: &mut AnswerRecorder,
    round: &mut Round,
    answered: &mut Vec<(Question, Answer)>,
) -> Result<(), Leave> {
    let (at_end, follows) = {
        let course = round.course();
        (course.tells_at_end(), course.follows_answers())
    };
    let mut number: u32 = 0;
    while let Some(question) = round.questions().get(number as usize).cloned() {
        number += 1;
        let lines = asking(round, number, &question);
        let Some(said) = answer(recorder.talk, &lines, &question.form)? else {
            // What comes next may follow from what is said.
            let (open, asked) = match follows {
                true => (
                    "Here every question needs an answer: a guess will do.",
                    number - 1,
                ),
                false => ("Left open.", number),
            };
            recorder.talk.say(open)?;
            number = asked;
            continue;
        };
        let answer = Answer::new(said, confidence(recorder.talk)?);
        let attempt = Attempt::of_quiz(recorder.player, round.code(), number, &question, &answer);
        recorder.record(attempt)?;
        match at_end {
            true => recorder.talk.say("Noted.")?,
            false => tell(recorder.talk, &question, &answer)?,
        }
        answered.push((question, answer));
        let answers: Vec<Answer> = answered.iter().map(|(_, answer)| *answer).collect();
        round.go_on(&answers);
    }
    Ok(())
}

/// A look back over these answers.
fn look_back(answered: &[(Question, Answer)]) -> Summary {
    Summary::new(answered.iter().map(|(question, answer)| (question, answer)))
}

/// What is said to ask a question, a line each.
fn asking(round: &Round, number: u32, question: &Question) -> Vec<String> {
    let course = round.course();
    let count = match course.follows_answers() {
        true => format!("at most {}", course.count),
        false => round.questions().len().to_string(),
    };
    let mut lines = vec![
        format!(
            "Question {number} of {count}: {}",
            sentence(question.family.name())
        ),
        by_words(&question.text),
    ];
    lines.extend(Some(describe(question)).filter(|seen| !seen.is_empty()));
    lines
}

/// Says how an answer was, and why.
fn tell(talk: &mut Talk, question: &Question, answer: &Answer) -> Result<(), Leave> {
    let grade = Grade::new(question, answer);
    let explanation = explain(question, answer);
    let form = &question.form;
    let title = sentence(explanation.title);
    let verdict = match explanation.diagnosis {
        None if grade.right => "Right.".to_owned(),
        Some(_) => format!("Not quite. It looks like this: {title}"),
        None => format!("Not quite: {title}"),
    };
    talk.say_all([
        verdict,
        format!("You said: {}", sentence(&form.words(&answer.said))),
        format!("It is: {}", sentence(&form.words(&form.truth()))),
        explanation.text,
        format!("{}.", grade.score()),
    ])?;
    talk.say_all(explanation.passage.and_then(read_up))
}

/// Where to read about it.
fn read_up(passage: Passage) -> Option<String> {
    let page = Book::default().named(passage)?;
    Some(format!("More about it in Learn: {}", sentence(&page)))
}

/// Looks back over what was answered.
fn sum_up(talk: &mut Talk, round: &Round, answered: &[(Question, Answer)]) -> Result<(), Leave> {
    let summary = look_back(answered);
    match &round.course().kind {
        CourseKind::FindOut => talk.say_all(summary.finding())?,
        kind => {
            talk.say(&format!("Your round: {}.", summary.score()))?;
            talk.say(&summary.calibration_words())?;
            if let CourseKind::Check(misconception) = kind {
                talk.say(&summary.checked(*misconception))?;
            } else {
                talk.say_all(summary.held_words())?;
                talk.say(&summary.advice())?;
            }
        }
    }
    talk.say_all(summary.passage().and_then(read_up))?;
    match round.course().kind {
        CourseKind::Review(_) | CourseKind::Own(_) => Ok(()),
        _ => talk.say(&format!(
            "The same round for a friend: the code {}.",
            verbatim(&round.code().to_string())
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_spoken, spoken};
    use super::*;
    use crate::quiz::{Family, Form, concepts};

    #[test]
    fn every_question_is_spoken_whole() {
        for &family in Family::ALL {
            for seed in 0..20 {
                let round = Round::new(Course::new(CourseKind::Topic(family)), seed);
                for (number, question) in (1..).zip(round.questions()) {
                    let mut lines = asking(&round, number, question);
                    if let Form::Choice { options, .. } = &question.form {
                        lines.extend(options.iter().map(ToString::to_string));
                    }
                    for said in question.beliefs.iter().map(|belief| belief.said) {
                        let answer = Answer::new(said, crate::quiz::Confidence::Sure);
                        let explained = explain(question, &answer);
                        lines.extend([sentence(explained.title), explained.text.to_string()]);
                        lines.push(question.form.words(&said).to_string());
                    }
                    lines.iter().for_each(|line| assert_spoken(&spoken(line)));
                }
            }
        }
        for concept in concepts::all() {
            let wrongs = concept.wrongs.iter();
            let choices = wrongs.flat_map(|wrong| [&wrong.choice, &wrong.says]);
            for text in [&concept.ask, &concept.right, &concept.why]
                .into_iter()
                .chain(choices)
            {
                assert_spoken(&spoken(text));
            }
        }
    }
}
