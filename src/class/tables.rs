//! The tables for the teacher, as comma-separated values.

use super::ballot::Vote;
use super::items::{ItemAnalysis, answer_name, items};
use super::round::ClassRound;
use crate::files::csv_table;
use crate::numbers::{self, bare_degrees};
use crate::quiz::{Form, Grade, Question, Response};

/// The first columns of both tables, which describe the question.
const ASKED: &str = "code,number,family,difficulty,question,truth";

/// The cells of [`ASKED`] for a question, counted from 0.
fn asked(round: &ClassRound, number: usize, question: &Question) -> Vec<String> {
    vec![
        round.code().to_string(),
        (number + 1).to_string(),
        question.family.id().into(),
        question.difficulty.id().into(),
        question.text.clone(),
        question.form.words(&question.form.truth()),
    ]
}

/// One row per team and question: both votes, the right answer, the grades; `date` is the date of
/// the lesson, such as 2026-11-22.
///
/// # Errors
/// The reason if a row cannot be written, which does not happen in practice.
pub fn answers_csv(round: &ClassRound, date: &str) -> Result<String, String> {
    let heads = [
        ASKED,
        "team,first_vote,first_right,first_credit,first_error_deg,first_misconception",
        "second_vote,second_right,second_credit,second_error_deg,second_misconception",
        "points,first_points,gain,date,class",
    ];
    let mut rows = Vec::new();
    for (i, question) in round.questions().iter().enumerate() {
        for (team, participant) in round.participants().iter().enumerate() {
            let ballot = participant.ballot(i);
            let mut row = asked(round, i, question);
            row.push(participant.name().to_owned());
            for vote in Vote::BOTH {
                row.extend(judged(round, i, ballot.vote(vote)));
            }
            let points = |_| numbers::points(round.points(i, team));
            row.push(cell(ballot.counts(), points));
            // The gain from the discussion.
            let [first, last] = [ballot.vote(Vote::First), ballot.counts()]
                .map(|said| round.grade(i, said).map(|grade| Grade::MOST * grade.credit));
            row.push(cell(first, numbers::points));
            let gain = first.zip(last).map(|(first, last)| last - first);
            row.push(cell(gain, |gain| numbers::fixed(gain, 1)));
            row.extend([date, round.class()].map(str::to_owned));
            rows.push(row);
        }
    }
    let heads = heads.join(",");
    csv_table(heads.split(','), &rows)
}

/// A vote, whether it was right, its credit, its error, the misconception; five empty cells if
/// there is no vote.
fn judged(round: &ClassRound, question: usize, said: Option<Response>) -> [String; 5] {
    let words = said.and_then(|said| Some(round.questions().get(question)?.form.words(&said)));
    let grade = round.grade(question, said);
    let diagnosis = round.diagnose(question, said);
    [
        words.unwrap_or_default(),
        cell(grade, |it| if it.right { "yes" } else { "no" }.into()),
        cell(grade, |it| format!("{:.3}", it.credit)),
        cell(grade.and_then(|it| it.angle_error), bare_degrees),
        cell(diagnosis, |it| it.id().into()),
    ]
}

/// The text of a cell; empty if there is no value.
fn cell<T>(of: Option<T>, text: impl Fn(T) -> String) -> String {
    of.map(text).unwrap_or_default()
}

/// One row per question with its results; `date` is the date of the lesson.
///
/// # Errors
/// The reason if a row cannot be written, which does not happen in practice.
pub fn items_csv(round: &ClassRound, date: &str) -> Result<String, String> {
    let heads = [
        ASKED,
        "first_votes,first_share_right,first_error_mean_deg,first_error_deviation_deg",
        "second_votes,second_share_right,second_error_mean_deg,second_error_deviation_deg",
        "discrimination,commonest_misconception,commonest_votes,gain",
        "changed_to_right,changed_to_wrong,first_counts,second_counts,date,class",
    ];
    let share = |share: Option<f64>| cell(share, |it| format!("{it:.3}"));
    let rows: Vec<Vec<String>> = items(round, round.questions().len())
        .iter()
        .filter_map(|item| {
            let question = round.questions().get(item.question)?;
            let mut row = asked(round, item.question, question);
            for tally in item.votes {
                let [mean, deviation] = [0, 1].map(|i| tally.spread_deg().map(|it| it[i]));
                row.extend([
                    tally.attempts.to_string(),
                    share(tally.share_right()),
                    cell(mean, |it| numbers::fixed(it, 1)),
                    cell(deviation, |it| numbers::fixed(it, 1)),
                ]);
            }
            row.push(share(item.discrimination));
            row.push(cell(item.commonest, |(held, _)| held.id().into()));
            row.push(cell(item.commonest, |(_, count)| count.to_string()));
            row.push(share(item.gain));
            for way in 0..2 {
                row.push(cell(item.changed, |changed| changed[way].to_string()));
            }
            row.extend(Vote::BOTH.map(|vote| counted(question, item, vote)));
            row.extend([date, round.class()].map(str::to_owned));
            Some(row)
        })
        .collect();
    let heads = heads.join(",");
    csv_table(heads.split(','), &rows)
}

/// The answers in a vote, with their counts: "A: 4; B: 17; C: 9; D: 2".
fn counted(question: &Question, item: &ItemAnalysis, vote: Vote) -> String {
    let is_choice = matches!(question.form, Form::Choice { .. });
    let each = { item.counts.iter() }.map(|(said, counts)| (said, counts[vote as usize]));
    let said = each.filter(|(_, count)| is_choice || *count > 0);
    let said = said.map(|(said, count)| format!("{}: {count}", answer_name(question, said)));
    said.collect::<Vec<_>>().join("; ")
}
