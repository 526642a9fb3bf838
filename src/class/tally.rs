//! Votes that were counted: hands, fingers or printed cards.

use super::ballot::Vote;
use super::names::MOST_PEOPLE;
use super::round::ClassRound;
use super::way::WayOfVoting;
use crate::quiz::{Form, Response};

/// The largest number of choices for a question that has no list of choices: the number of cards on
/// a sheet.
const MOST_CHOICES: usize = 4;

impl ClassRound {
    /// The choices for a class without devices: those of the question if it has any; otherwise the
    /// right answer and up to three answers that misconceptions lead to, so each choice shows what
    /// its voters believe. Their order does not reveal the right one: rays, numbers and offsets are
    /// sorted. Empty if there is no such question.
    pub fn choices(&self, question: usize) -> Vec<Response> {
        let Some(asked) = self.questions().get(question) else {
            return Vec::new();
        };
        if let Form::Choice { options, .. } = &asked.form {
            return (0..options.len()).map(Response::Choice).collect();
        }
        let beliefs = asked.beliefs.iter().map(|belief| belief.said);
        let all = std::iter::once(asked.form.truth()).chain(beliefs);
        let mut choices: Vec<Response> = all.take(MOST_CHOICES).collect();
        choices.sort_by(|a, b| {
            let [a, b] = [a, b].map(size);
            a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
        });
        choices
    }

    /// The choices that everyone has to choose from: those of the question or, if hands or cards are
    /// counted, its [`choices`](Self::choices); empty if voters give answers of their own.
    pub fn offered(&self, question: usize) -> Vec<Response> {
        let form = self.questions().get(question).map(|it| &it.form);
        match (self.way(), form) {
            (WayOfVoting::Tally, _) | (_, Some(Form::Choice { .. })) => self.choices(question),
            _ => Vec::new(),
        }
    }

    /// The number of votes for each of the [`choices`](Self::choices); `None` if nothing was
    /// counted.
    pub fn tally(&self, question: usize, vote: Vote) -> Option<&[u32]> {
        let counts = self.tallies.get(question)?[vote as usize].as_slice();
        (!counts.is_empty()).then_some(counts)
    }

    /// Sets the counts for a vote, replacing earlier ones; `None` withdraws them. Returns whether
    /// they were accepted: there must be one count per choice, and at most [`MOST_PEOPLE`] votes in
    /// all.
    pub fn count(&mut self, question: usize, vote: Vote, counts: Option<&[u32]>) -> bool {
        let choices = self.choices(question).len();
        let fits = counts.is_none_or(|counts| {
            let all: u64 = counts.iter().map(|count| u64::from(*count)).sum();
            counts.len() == choices && all <= MOST_PEOPLE as u64
        });
        let is_counted = fits && self.way() == WayOfVoting::Tally;
        let row = self.tallies.get_mut(question).filter(|_| is_counted);
        row.map(|row| row[vote as usize] = counts.unwrap_or_default().to_vec())
            .is_some()
    }

    /// The counted votes, one per hand; for the second vote, if nothing was counted again, those of
    /// the first.
    pub(super) fn counted(&self, question: usize, vote: Vote) -> impl Iterator<Item = Response> {
        let counts = match (vote, self.tally(question, vote)) {
            (Vote::Second, None) => self.tally(question, Vote::First),
            (_, counts) => counts,
        };
        let counts = counts.unwrap_or_default().to_vec();
        let each = self.choices(question).into_iter().zip(counts);
        each.flat_map(|(choice, count)| std::iter::repeat_n(choice, count as usize))
    }
}

/// The sort key of choices: for rays the size of the target's angle, then that of the striker's.
fn size(said: &Response) -> [f64; 2] {
    match said {
        Response::Rays(rays) => {
            [rays.target, rays.striker].map(|angle| angle.map_or(f64::INFINITY, f64::abs))
        }
        Response::Number(x) | Response::Shot(x) => [*x, 0.0],
        Response::Choice(i) => [*i as f64, 0.0],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::Code;

    fn round(code: &str) -> ClassRound {
        ClassRound::with_tally(Code::parse(code).unwrap())
    }

    #[test]
    fn the_choices_of_every_question_include_the_right_answer() {
        for code in ["mixed-1", "mixed-2", "concept-1", "quick-3"] {
            let round = round(code);
            for (i, question) in round.questions().iter().enumerate() {
                let choices = round.choices(i);
                let truth = question.form.truth();
                let near = |said: &&Response| question.form.distance(said, &truth) <= 1.0;
                assert_eq!(choices.iter().filter(near).count(), 1, "{}", question.text);
                assert!((2..=5).contains(&choices.len()), "{}", question.text);
            }
        }
    }

    #[test]
    fn the_right_answer_is_not_always_the_same_choice() {
        let mut places = [0; 5];
        for seed in 0..12 {
            let round = round(&format!("mixed-{seed}"));
            for (i, question) in round.questions().iter().enumerate() {
                let truth = question.form.truth();
                let choices = round.choices(i);
                let place = choices.iter().position(|it| *it == truth).unwrap();
                places[place] += 1;
            }
        }
        assert!(places[..4].iter().all(|times| *times >= 5), "{places:?}");
    }

    #[test]
    fn counts_are_votes() {
        let mut round = round("concept-1");
        let choices = round.choices(0).len();
        let mut counts = vec![0; choices];
        counts[1] = 30;
        counts[0] = 2;
        assert!(!round.count(0, Vote::First, Some(&counts[1..])));
        assert!(!round.count(0, Vote::First, Some(&vec![200; choices])));
        assert!(round.count(0, Vote::First, Some(&counts)));
        assert_eq!(round.voted(0, Vote::First), 32);
        assert_eq!(round.said(0, Vote::Second).count(), 32);
        assert_eq!(round.results(0, Vote::First).attempts, 32);
        assert_eq!((round.begun(), round.voted(0, Vote::Second)), (1, 0));
        assert!(round.count(0, Vote::First, None));
        assert!(!round.is_begun());
    }
}
