//! The report of a class round for the teacher: the questions with the votes before and after the
//! discussion, what each wrong answer suggests, and what to teach next.

use jiff::civil::Date;
use maud::{Markup, html};

use super::worksheet::{of_answer, on_screen, said};
use super::{Paper, clean, html_page};
use crate::class::{
    Advice, ClassBelief, ClassRound, ItemAnalysis, Vote, WayOfVoting, beliefs, items, standings,
};
use crate::lessons::Book;
use crate::numbers::{self, counted, fixed};
use crate::progress::long_day;
use crate::progress::words::percent;
use crate::quiz::{Form, Misconception, Question, Response};
use crate::widgets::text::unbroken;

const STYLE: &str = include_str!("class_report.css");
/// The maximum number of columns in a name.
const NAME: usize = 44;
/// The number of misconceptions for which the report gives the next step in full.
const NEXT: usize = 3;

/// What a report contains in addition to the results of the round.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct About {
    /// The day of the lesson, if it is known.
    pub day: Option<Date>,
    /// Whether the results of each participant are listed by name.
    pub with_names: bool,
}

/// The report as an HTML document.
pub fn html(round: &ClassRound, about: &About) -> String {
    let all = items(round, round.questions().len());
    let voted: Vec<&ItemAnalysis> = all.iter().filter(|it| it.votes[0].attempts > 0).collect();
    let held = beliefs(round);
    let book = Book::default();
    let title = match round.class() {
        "" => "A round with a class".to_owned(),
        class => format!("A round with {}", clean(class, NAME)),
    };
    let first = html! {
        div.class-report data-class=(round.class()) {
            header {
                p.dim { "carrom · glancing collisions · report of a class round" }
                h1 { bdi { (title) } }
                p { (facts(round, about, voted.len())) }
            }
            (glance(round, &voted))
            (next(round, &held, &book))
            @if about.with_names { (by_name(round)) }
        }
    };
    let questions = html! {
        div.class-report {
            h1 { "The questions" }
            p.dim {
                "Each bar is a share of the votes. \"Before\" is the vote in silence, \"after\" the "
                "vote after the discussion; if someone did not vote again, the first vote counts."
            }
            @for item in &voted { (question(round, item, &book)) }
        }
    };
    let questions = Some(questions).filter(|_| !voted.is_empty());
    let sheets = std::iter::once(first).chain(questions);
    html_page(&title, STYLE, Paper::A4, sheets)
}

/// "26 November 2026 · code quick-7 · 27 pupils on their own devices · votes on 5 of 5 questions".
fn facts(round: &ClassRound, about: &About, voted: usize) -> String {
    let people = round.participants().len();
    let largest = (0..round.questions().len()).map(|it| round.voted(it, Vote::First));
    let voters = match round.way() {
        WayOfVoting::Devices => format!("{} on their own devices", counted(people, "pupil")),
        WayOfVoting::Teams => counted(people, "team"),
        WayOfVoting::Tally => {
            let most = largest.max().unwrap_or(0);
            format!("up to {} counted in one vote", counted(most, "hand"))
        }
    };
    let all = round.questions().len();
    let mut facts: Vec<String> = about.day.map(long_day).into_iter().collect();
    facts.push(format!("code {}", round.code()));
    facts.push(voters);
    facts.push(format!("votes on {voted} of {}", counted(all, "question")));
    facts.join(" · ")
}

/// A table with the results of all questions that were voted on.
fn glance(round: &ClassRound, voted: &[&ItemAnalysis]) -> Markup {
    let note = |item: &ItemAnalysis| match Advice::of(round, item.question) {
        _ if needs_more(item) => "come back to this question",
        Some(Advice::GoOn) => "already known",
        _ => "",
    };
    let has_notes = voted.iter().any(|it| !note(it).is_empty());
    html! {
        h2 { "At a glance" }
        @if voted.is_empty() { p { "Nobody has voted yet." } }
        @else {
            table {
                thead {
                    tr {
                        th scope="col" { "question" }
                        th.n scope="col" { "votes" }
                        th.n scope="col" { "right before" }
                        th.n scope="col" { "right after" }
                        th scope="col" { "most common mistake" }
                        @if has_notes { th scope="col" { "note" } }
                    }
                }
                tbody {
                    @for item in voted {
                        tr {
                            th scope="row" {
                                (item.question + 1) " "
                                @if let Some(it) = round.questions().get(item.question) { (it.topic.name()) }
                            }
                            td.n { (item.votes[0].attempts) }
                            @for tally in item.votes { td.n { (percent(tally.share_right())) } }
                            td { @if let Some((it, count)) = item.commonest { (it.name()) ": " (count) } }
                            @if has_notes { td { (note(item)) } }
                        }
                    }
                }
            }
        }
    }
}

/// Whether the discussion did not help and, at the end, fewer than four in five answers were right.
fn needs_more(item: &ItemAnalysis) -> bool {
    match item.votes.map(|it| it.share_right()) {
        [Some(first), Some(second)] => second <= first && second < 0.8,
        _ => false,
    }
}

/// What to teach next: the misconceptions that the class believes most, each with its remedy.
fn next(round: &ClassRound, held: &[ClassBelief], book: &Book) -> Markup {
    let who = match round.way() {
        WayOfVoting::Teams => "Teams that show it in two questions or more",
        WayOfVoting::Tally | WayOfVoting::Devices => "Pupils who show it in two questions or more",
    };
    let counts = |it: &ClassBelief| {
        let [before, after] = it.votes;
        let votes = format!("Votes that fit it: {before} before, {after} after");
        match (round.way(), it.teams) {
            (WayOfVoting::Tally, _) | (_, [0, 0]) => format!("{votes} the discussion."),
            (_, [first, second]) => {
                format!("{who}: {first} before, {second} after the discussion. {votes}.")
            }
        }
    };
    html! {
        h2 { "What to teach next" }
        @if held.is_empty() {
            p { "No vote fits a known misconception." }
        }
        @for (at, it) in held.iter().take(NEXT).enumerate() {
            section.belief {
                h3 { (at + 1) ". " (it.misconception.name()) }
                p { (counts(it)) }
                p { (it.misconception.advice()) }
                @if let Some(page) = book.named(it.page(round)) { p { "Read with the class: " (page) } }
                p { "Ask again: " code { "carrom class --code " (it.misconception.id()) "-1" } }
            }
        }
        @if held.len() > NEXT {
            p.dim {
                "Votes also fit: "
                @for (at, it) in held.iter().skip(NEXT).enumerate() {
                    @if at > 0 { "; " }
                    (it.misconception.name()) " (" (it.votes[0]) ", then " (it.votes[1]) ")"
                }
                "."
            }
        }
    }
}

/// The results of each participant.
fn by_name(round: &ClassRound) -> Markup {
    let asked = round.questions().len();
    let all = standings(round, asked);
    html! {
        h2 { "Results by name" }
        table {
            thead {
                tr {
                    th scope="col" { "name" }
                    @for number in 1..=asked { th.n scope="col" { (number) } }
                    th.n scope="col" { "points" }
                }
            }
            tbody {
                @for it in &all {
                    tr {
                        th scope="row" { bdi { (clean(round.name_of(it.team), NAME)) } }
                        @for question in 0..asked {
                            td.n {
                                @if round.ballot(question, it.team).counts().is_some() {
                                    (numbers::points(round.points(question, it.team)))
                                } @else { "–" }
                            }
                        }
                        td.n { (numbers::points(it.points)) }
                    }
                }
            }
        }
    }
}

/// An answer to a question, and the votes for it.
#[derive(Default)]
struct AnswerRow {
    words: String,
    right: bool,
    misconception: Option<Misconception>,
    says: String,
    votes: [usize; 2],
}

/// The answers that a question can get: its choices, or else the right answer, the answers that
/// misconceptions lead to, and all others together.
fn answers(round: &ClassRound, item: &ItemAnalysis, question: &Question) -> Vec<AnswerRow> {
    let wrong = question.wrong_answers();
    let row = |answer: &Response| {
        let found = wrong.iter().find(|(it, ..)| it == answer);
        AnswerRow {
            words: said(question, answer),
            right: *answer == question.form.truth(),
            misconception: found.and_then(|it| it.1),
            says: found.map(|it| it.2.to_owned()).unwrap_or_default(),
            votes: [0, 0],
        }
    };
    let all: Vec<Response> = match &question.form {
        Form::Choice { options, .. } => (0..options.len()).map(Response::Choice).collect(),
        _ => { std::iter::once(question.form.truth()) }
            .chain(wrong.iter().map(|(it, ..)| *it))
            .collect(),
    };
    let mut rows: Vec<AnswerRow> = all.iter().map(row).collect();
    let is_choice = matches!(question.form, Form::Choice { .. });
    let mut other = AnswerRow {
        words: "other answers".into(),
        ..AnswerRow::default()
    };
    for (answer, votes) in &item.counts {
        let at = match answer {
            Response::Choice(choice) => Some(*choice),
            _ if question.form.is_right(answer) => Some(0),
            _ => round
                .diagnose(item.question, Some(*answer))
                .and_then(|held| rows.iter().position(|it| it.misconception == Some(held))),
        };
        let row = at.and_then(|at| rows.get_mut(at)).unwrap_or(&mut other);
        row.votes = [0, 1].map(|vote| row.votes[vote] + votes[vote]);
    }
    if !is_choice {
        // Answers that nobody gave would only fill the page.
        rows.retain(|it| it.right || it.votes != [0, 0]);
    }
    if other.votes != [0, 0] {
        rows.push(other);
    }
    rows
}

fn question(round: &ClassRound, item: &ItemAnalysis, book: &Book) -> Markup {
    let number = item.question;
    let Some(question) = round.questions().get(number) else {
        return html! {};
    };
    let rows = answers(round, item, question);
    let all = item.votes.map(|it| it.attempts);
    let picture = match question.form {
        // Only the true collision shows where a shot goes.
        Form::Shot(_) => of_answer(question),
        _ => on_screen(question),
    };
    let page = |misconception: Misconception| {
        book.named(misconception.settled_in(&question.topic, &question.figures))
    };
    html! {
        article.asked {
            h2 { (number + 1) ". " (question.topic.name()) }
            div.beside {
                p { (unbroken(&question.text)) }
                @if let Some(picture) = picture { figure { (picture) } }
            }
            table.votes {
                thead {
                    tr {
                        th scope="col" { "answer" }
                        th scope="col" { "before (" (counted(all[0], "vote")) ")" }
                        th scope="col" { "after (" (counted(all[1], "vote")) ")" }
                        th scope="col" { "what it suggests, and a reply" }
                    }
                }
                tbody {
                    @for row in &rows {
                        tr.right[row.right] {
                            th scope="row" {
                                (row.words) @if row.right { " " strong { "✓\u{a0}right" } }
                            }
                            @for (vote, all) in row.votes.into_iter().zip(all) { td { (bar(vote, all)) } }
                            td {
                                @if let Some(it) = row.misconception { strong { (it.name()) } ". " }
                                @if !row.right && row.votes != [0, 0] { (unbroken(&row.says)) " " }
                                @if let Some(it) = row.misconception.filter(|_| row.votes != [0, 0]) {
                                    "Remedy: " (it.advice())
                                    @if let Some(page) = page(it) { " (" (page) ")" }
                                }
                            }
                        }
                    }
                }
            }
            p { (change(item)) }
            p.why { strong { "Why. " } (unbroken(&question.why)) }
        }
    }
}

/// `votes` as a share of `all`: a bar, the number of votes and the percentage.
fn bar(votes: usize, all: usize) -> Markup {
    let share = 100.0 * votes as f64 / all.max(1) as f64;
    html! {
        span.bar aria-hidden="true" { span style=(format!("width:{share:.1}%")) {} }
        span.count { (votes) " (" (format!("{share:.0}")) "\u{a0}%)" }
    }
}

/// What the discussion changed.
fn change(item: &ItemAnalysis) -> String {
    let [first, second] = item.votes.map(|it| percent(it.share_right()));
    let mut words = format!("Right: {first} before, {second} after.");
    if let Some([right, wrong]) = item.changed {
        words += &format!(" Changed from wrong to right: {right}, from right to wrong: {wrong}.");
    }
    if let Some(gain) = item.gain {
        let gain = fixed(gain, 2);
        words += &format!(" Gain from the discussion: {gain} of the possible gain.");
    }
    if needs_more(item) {
        words += " The discussion did not help: come back to this question.";
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::Code;

    #[test]
    fn every_vote_is_in_one_row_of_its_question() {
        for code in ["mixed20-3", "quick-7", "concept-2", "make-it-so3-4"] {
            let teams = ["Ants", "Bees", "Cats", "Dogs"].map(str::to_owned).to_vec();
            let mut round = ClassRound::new(Code::parse(code).unwrap(), teams);
            for number in 0..round.questions().len() {
                let question = &round.questions()[number];
                let truth = question.form.truth();
                let wrong = question.wrong_answers().first().map(|it| it.0);
                let odd = match truth {
                    Response::Number(x) => Response::Number(17.0 * x + 3.0),
                    other => other,
                };
                for (team, said) in [Some(truth), wrong, Some(odd), None]
                    .into_iter()
                    .enumerate()
                {
                    round.vote(number, team, Vote::First, said);
                }
                round.vote(number, 1, Vote::Second, Some(truth));
                let item = &items(&round, number + 1)[number];
                let rows = answers(&round, item, &round.questions()[number]);
                let votes = round.voted(number, Vote::First);
                for (vote, at) in [(0, Vote::First), (1, Vote::Second)] {
                    let all: usize = rows.iter().map(|it| it.votes[vote]).sum();
                    assert_eq!(all, round.said(number, at).count(), "{code} {number}");
                }
                assert!(votes > 0);
                assert_eq!(rows.iter().filter(|it| it.right).count(), 1);
            }
        }
    }
}
