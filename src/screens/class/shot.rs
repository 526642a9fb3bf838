//! The real outcome, and its explanation.

use super::ClassAction;
use super::question;
use super::stage::Stage;
use crate::class::{ClassRound, Vote, feedback};
use crate::quiz::{Question, Response, evidence, letter};
use crate::screens::View;
use crate::widgets::hit::{HitPace, Reveal, Watch};
use crate::widgets::panel::{Beside, Panel};
use crate::widgets::panels::Heading;
use crate::widgets::{Role, draw_question, lettered, text};

/// The real outcome, and its explanation.
#[derive(Debug, Clone)]
pub(super) struct ClassReveal {
    /// The collision, if the question is about one.
    pub(super) reveal: Reveal,
    /// The most frequent wrong answer (the misconception that it fits, or else the letter of the
    /// choice), and its number of votes.
    pub(super) held: Option<(String, usize)>,
    pub(super) why: String,
}

impl ClassReveal {
    /// The explanation of a question, starting from the class's answers.
    pub(super) fn new(round: &ClassRound, number: usize, pace: HitPace) -> Option<Self> {
        let question = round.questions().get(number)?;
        // The wrong votes after the discussion or, if there are none, those before it.
        let held = commonest(round, number, Vote::Second)
            .or_else(|| commonest(round, number, Vote::First));
        let said = held.as_ref().map(|shared| shared.said);
        Some(Self {
            reveal: Reveal::new(Watch::of_question(question, said, pace)),
            held: held.map(|shared| (shared.name, shared.count)),
            why: feedback(question, said),
        })
    }
}

/// The text beside the shot.
pub(super) fn view<'s>(
    play: &'s Stage,
    shown: &'s ClassReveal,
    question: &'s Question,
) -> View<'s, ClassAction> {
    let heading = match shown.reveal.is_explaining() {
        true => Heading::new(&["The shot"], ""),
        false => Heading::new(&["And why"], right_in_words(play)),
    };
    let mut words = play.words();
    write(play, question, shown, &mut words);
    let watch = shown.reveal.watch();
    let beside = watch.map_or_else(|| question::beside(question), |_| Beside::Needed);
    let draw = move |area, buf: &mut _, look: &_| match watch {
        Some(watch) => watch.picture(area).draw(buf, look),
        None => draw_question(area, buf, look, question, None),
    };
    play.step_view(Some(heading), beside, draw, words)
}

/// "Right at first: 1 of 3, after talking: 2 of 3"
fn right_in_words(play: &Stage) -> String {
    let [first, second] = Vote::BOTH.map(|vote| {
        let results = play.round().results(play.number(), vote);
        format!("{} of {}", results.right, results.attempts)
    });
    format!("Right at first: {first}, after talking: {second}")
}

/// Writes the text of the shot: the steps of the explanation; then the right answer, the most
/// frequent wrong one, the first sentence of the feedback and, on further pages, the rest of it.
fn write(play: &Stage, question: &Question, shown: &ClassReveal, panel: &mut Panel<ClassAction>) {
    if let Some(watch) = shown.reveal.watch()
        && shown.reveal.is_explaining()
    {
        let (heading, words) = watch.explanation();
        if let Some(heading) = heading {
            panel.large_text(heading, Role::Title);
        }
        return panel.large_text(words, Role::Text);
    }
    panel.large_text(
        lettered(&question.form, &question.form.truth()),
        Role::Title,
    );
    if let Some((name, count)) = &shown.held {
        let words = format!("{}: {name}.", play.round().way().voters(*count));
        panel.large_text(words, Role::Title);
    }
    let (sentence, rest) = first_sentence(&shown.why);
    panel.large_text(sentence, Role::Text);
    if !rest.is_empty() {
        panel.page_break();
        panel.large_text(rest, Role::Text);
    }
}

/// The first sentence of a text, and what comes after it.
fn first_sentence(text: &str) -> (&str, &str) {
    let end = text::sentence_ends(text).next();
    let (first, rest) = text.split_at(end.unwrap_or(text.len()));
    (first, rest.trim_start())
}

/// A group of wrong votes that fit one misconception or are for one choice.
struct SharedAnswer {
    name: String,
    count: usize,
    /// One of the votes.
    said: Response,
}

/// The most frequent group of wrong votes; in a tie, one that fits a misconception.
fn commonest(round: &ClassRound, question: usize, vote: Vote) -> Option<SharedAnswer> {
    let shared = [
        commonest_reply(round, question, vote),
        commonest_belief(round, question, vote),
    ];
    shared.into_iter().flatten().max_by_key(|it| it.count)
}

/// The misconception for which the votes are the strongest evidence.
fn commonest_belief(round: &ClassRound, question: usize, vote: Vote) -> Option<SharedAnswer> {
    let all = evidence(&round.clues(question, vote));
    let most = all.into_iter().find(|it| it.times > 0)?;
    let mut held = round.held(question, vote);
    let (misconception, said) = held.find(|(held, _)| *held == most.misconception)?;
    Some(SharedAnswer {
        name: misconception.name().into(),
        count: most.times,
        said,
    })
}

/// The most frequent wrong choice that fits no misconception but has feedback. In a tie, the first.
fn commonest_reply(round: &ClassRound, question: usize, vote: Vote) -> Option<SharedAnswer> {
    let replies = &round.questions().get(question)?.replies;
    let count = |choice| round.votes_for(question, vote, Response::Choice(choice));
    let counts = replies.keys().rev().map(|choice| (*choice, count(*choice)));
    let (choice, count) = counts.max_by_key(|(_, count)| *count)?;
    (count > 0).then(|| SharedAnswer {
        name: format!("answer {}", letter(choice)),
        count,
        said: Response::Choice(choice),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::Code;

    /// If a wrong choice fits no known misconception, the question's own feedback on that choice is
    /// shown.
    #[test]
    fn a_choice_without_a_misconception_has_feedback_too() {
        let teams = || ["Ants", "Bees", "Cats"].map(Into::into).to_vec();
        let mut rounds = (0..200).filter_map(|seed| {
            let code = Code::parse(&format!("concept1-{seed}"))?;
            Some(ClassRound::new(code, teams()))
        });
        let found = rounds.find(|round| !round.questions()[0].replies.is_empty());
        let mut round = found.unwrap();
        let question = round.questions()[0].clone();
        let (choice, reply) = question.replies.iter().next().unwrap();
        let votes = [
            Response::Choice(*choice),
            Response::Choice(*choice),
            question.form.truth(),
        ];
        for (team, vote) in votes.into_iter().enumerate() {
            round.vote(0, team, Vote::First, Some(vote));
        }
        let shown = ClassReveal::new(&round, 0, HitPace::default()).unwrap();
        assert_eq!(shown.held, Some((format!("answer {}", letter(*choice)), 2)));
        assert!(shown.why.contains(reply), "{}", shown.why);
    }

    #[test]
    fn the_first_sentence_ends_where_another_begins() {
        let parts = |text| first_sentence(text);
        assert_eq!(parts("At 4.00 m/s. Then?"), ("At 4.00 m/s.", "Then?"));
        assert_eq!(parts("One, e. g. this one"), ("One, e. g. this one", ""));
        assert_eq!(parts(""), ("", ""));
    }
}
