//! The player's misconceptions, and whether they fade.

use super::Attempt;
use crate::quiz::{ChaptersRead, Clue, CourseKind, Evidence, Misconception, Passage, Topic};

/// A misconception is settled once this many answers could have shown it but did not, counted after
/// the last answer that showed it.
const SETTLED: usize = 2;

/// A misconception that the answers show, with the evidence from the first half and from the second
/// half of all attempts. If the number of attempts is odd, the second half has one attempt more
/// than the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeldBelief {
    /// The misconception that the answers show.
    pub misconception: Misconception,
    /// The evidence in the first half.
    pub before: Evidence,
    /// The evidence in the second half.
    pub since: Evidence,
}

/// How a misconception develops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Trend {
    /// In the first half the answers are not evidence for the misconception.
    New,
    /// The misconception still shows in the second half.
    Held,
    /// In the second half the answers are evidence against the misconception.
    Fading,
    /// In the second half the evidence against the misconception is as strong as the evidence
    /// required to name a misconception.
    Gone,
    /// No question in the second half could show the misconception.
    NotMet,
}

impl Trend {
    /// The name of the trend, as shown.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::New => "new",
            Self::Held => "still there",
            Self::Fading => "fading",
            Self::Gone => "gone",
            Self::NotMet => "not met since",
        }
    }

    /// Whether the trend is an improvement.
    pub(crate) const fn is_good(self) -> bool {
        matches!(self, Self::Fading | Self::Gone)
    }
}

impl HeldBelief {
    /// How the misconception develops.
    pub(crate) fn trend(&self) -> Trend {
        let Self { before, since, .. } = self;
        match since {
            Evidence { asked: 0, .. } => Trend::NotMet,
            since if since.denies() => Trend::Gone,
            since if since.weight < 0.0 => Trend::Fading,
            _ if before.weight > 0.0 => Trend::Held,
            _ => Trend::New,
        }
    }
}

/// A named misconception that is not settled. A misconception is settled once enough later answers
/// could have shown it but did not.
#[derive(Debug, Clone)]
pub(crate) struct UnsettledBelief<'a> {
    pub(crate) misconception: Misconception,
    /// The answers that showed the misconception; there is at least one.
    pub(crate) shown: Vec<&'a Attempt>,
    /// The last of these answers.
    pub(crate) last: &'a Attempt,
}

impl UnsettledBelief<'_> {
    /// Whether the last answer that showed the misconception was given in a check for this
    /// misconception.
    pub(crate) fn failed_check(&self) -> bool {
        let check = CourseKind::Check(self.misconception);
        let round = self.last.round();
        round.trim_end_matches(|c: char| c.is_ascii_digit() || c == '-') == check.id()
    }
}

/// The page about the simplest case in which these answers showed a misconception: the first
/// such page in the order of the chapters.
pub(crate) fn page_about<'a>(
    misconception: Misconception,
    shown: impl IntoIterator<Item = &'a Attempt>,
) -> Option<Passage> {
    let page = |it: &Attempt| {
        let topic = Topic::with_id(it.quiz_topic()?.to_owned());
        Some(misconception.settled_in(&topic, &it.question))
    };
    let pages = shown.into_iter().filter_map(page);
    pages.min_by_key(|page| ChaptersRead::order_of(page.chapter))
}

/// The named misconceptions that are not settled, and the number of all named misconceptions.
pub(crate) fn unsettled(attempts: &[Attempt]) -> (Vec<UnsettledBelief<'_>>, usize) {
    let clues: Vec<Clue> = attempts.iter().map(Attempt::clue).collect();
    let named = beliefs(attempts);
    let unsettled = named.iter().filter_map(|held| {
        let misconception = held.misconception;
        // If this misconception was split later, newer answers can show one of the resulting
        // misconceptions instead.
        let is_it = |it: &Misconception| it.is_part_of(misconception);
        let shows = |clue: &&Clue| clue.shows.as_ref().is_some_and(is_it);
        let last = clues.iter().rposition(|clue| shows(&clue))?;
        let could_show = |clue: &&Clue| clue.could_show.iter().any(is_it);
        let showing = clues.iter().zip(attempts).filter(|(clue, _)| shows(clue));
        (clues[last + 1..].iter().filter(could_show).count() < SETTLED).then(|| UnsettledBelief {
            misconception,
            shown: showing.map(|(_, attempt)| attempt).collect(),
            last: &attempts[last],
        })
    });
    (unsettled.collect(), named.len())
}

/// The misconceptions named by the answers as a whole or by those of one half, sorted by their
/// evidence in the second half. Unknown misconceptions are left out.
pub fn beliefs(attempts: &[Attempt]) -> Vec<HeldBelief> {
    let clues: Vec<Clue> = attempts.iter().map(Attempt::clue).collect();
    let (before, since) = clues.split_at(clues.len() / 2);
    let held = |misconception: &Misconception| {
        let evidence = [&clues, before, since].map(|it| Evidence::of(*misconception, it));
        let [_, before, since] = evidence;
        evidence.iter().any(Evidence::names).then_some(HeldBelief {
            misconception: *misconception,
            before,
            since,
        })
    };
    let mut beliefs: Vec<_> = Misconception::ALL.iter().filter_map(held).collect();
    beliefs.sort_by(|a, b| {
        let since = a.since.stronger_first(&b.since);
        since.then_with(|| a.before.stronger_first(&b.before))
    });
    beliefs
}

#[cfg(test)]
mod tests {
    use super::super::tally::tests::attempt;
    use super::*;
    use crate::quiz::figures;
    use serde_json::json;

    /// The misconceptions found from answers about two rays. Each answer could have shown the given
    /// misconceptions, and an answer marked `true` shows the first of them. The numbers are, for
    /// each half, how often the misconception was shown and how often it could have been shown.
    fn trend(answers: &[(&[&str], bool)]) -> Vec<(&'static str, [usize; 4], Trend)> {
        let attempts: Vec<_> = (0..)
            .zip(answers)
            .map(|(number, (could_show, shows))| Attempt {
                question: figures(json!({
                    "number": number,
                    "misconceptions": could_show,
                    "by_chance": 0.01,
                })),
                misconception: could_show.first().filter(|_| *shows).map(|id| (*id).into()),
                ..attempt("a", 20.0)
            })
            .collect();
        beliefs(&attempts)
            .iter()
            .map(|it| {
                let (before, since) = (it.before, it.since);
                let counts = [before.times, before.asked, since.times, since.asked];
                (it.misconception.id(), counts, it.trend())
            })
            .collect()
    }

    #[test]
    fn misconceptions_appear_fade_vanish_or_stay() {
        const C: &[&str] = &["copied-angle", "swapped"];
        const OTHER: &[&str] = &["half-and-half"];
        const YES: (&[&str], bool) = (C, true);
        const NO: (&[&str], bool) = (C, false);
        const ELSE: (&[&str], bool) = (OTHER, false);
        for (answers, counts, expected) in [
            (vec![YES, YES], [1, 1, 1, 1], Trend::Held),
            (vec![ELSE, ELSE, YES, YES], [0, 0, 2, 2], Trend::New),
            (vec![NO, NO, YES, YES], [0, 2, 2, 2], Trend::New),
            (vec![YES, YES, ELSE, ELSE], [2, 2, 0, 0], Trend::NotMet),
            (vec![YES, YES, NO, ELSE], [2, 2, 0, 1], Trend::Fading),
            (vec![YES, YES, ELSE, NO, NO, NO], [2, 2, 0, 3], Trend::Gone),
            (vec![YES, YES, YES, NO], [2, 2, 1, 2], Trend::Held),
            (
                vec![YES, YES, YES, ELSE, YES, NO, NO, NO],
                [3, 3, 1, 4],
                Trend::Fading,
            ),
        ] {
            assert_eq!(trend(&answers), [("copied-angle", counts, expected)]);
        }
        assert!(trend(&[NO]).is_empty() && trend(&[]).is_empty());
    }

    #[test]
    fn repeating_one_answer_names_no_misconception() {
        const C: &[&str] = &["copied-angle"];
        assert!(trend(&[(C, true)]).is_empty());
        let again = Attempt {
            question: figures(json!({ "misconceptions": C, "by_chance": 0.01 })),
            misconception: Some("copied-angle".into()),
            ..attempt("a", 20.0)
        };
        assert!(beliefs(&vec![again; 5]).is_empty());
    }

    #[test]
    fn unknown_misconceptions_are_left_out_and_old_answers_that_name_one_are_used() {
        assert!(trend(&[(&["unheard-of"], true), (&["unheard-of"], true)]).is_empty());
        let old = |number: u32| Attempt {
            question: figures(json!({ "number": number })),
            misconception: Some("swapped".into()),
            ..attempt("a", 20.0)
        };
        let found = beliefs(&[old(1), old(2), attempt("a", 1.0), attempt("a", 1.0)]);
        assert_eq!((found[0].before.times, found[0].before.asked), (2, 2));
        assert_eq!(found[0].trend(), Trend::NotMet);
    }
}
