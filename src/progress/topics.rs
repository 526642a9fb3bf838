//! How well each topic is known.

use indexmap::IndexMap;

use super::{Attempt, Tally};

/// The number of most recent attempts that determine how well a topic is known.
pub(crate) const LATELY: usize = 5;

/// A topic and the attempts at this topic.
#[derive(Debug, Clone, PartialEq)]
pub struct TopicStanding {
    /// The name of the topic: "equal masses, by offset".
    pub name: String,
    /// The counts for all attempts at the topic.
    pub all: Tally,
    /// The counts for the last [`LATELY`] attempts.
    pub(crate) lately: Tally,
}

/// How well a topic is known, judged by the last [`LATELY`] answers, or by all answers if there are
/// fewer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Mastery {
    /// No question on the topic has been answered yet.
    New,
    /// Fewer than half the answers were right.
    NotYet,
    /// At least half the answers were right.
    Growing,
    /// There are [`LATELY`] answers, of which at least four in five were right.
    Solid,
}

impl Mastery {
    /// The name of the state, as shown.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::New => "new",
            Self::NotYet => "not yet",
            Self::Growing => "growing",
            Self::Solid => "solid",
        }
    }

    /// The mark of the state in a list.
    pub(crate) const fn mark(self) -> char {
        match self {
            Self::New => ' ',
            Self::NotYet => '-',
            Self::Growing => '~',
            Self::Solid => '*',
        }
    }

    /// The text that explains the names, for use without marks.
    pub(crate) const MEANING: &str =
        "Solid: four of the last five right; growing: half or more; not yet: fewer.";

    /// The text that explains the marks.
    pub(crate) fn legend() -> String {
        format!(
            "{} solid: four of the last five right; {} growing: half or more; {} not yet: fewer.",
            Self::Solid.mark(),
            Self::Growing.mark(),
            Self::NotYet.mark()
        )
    }
}

impl TopicStanding {
    /// The topic with this name and these attempts.
    pub(crate) fn of<'a>(
        name: impl Into<String>,
        attempts: impl IntoIterator<Item = &'a Attempt>,
    ) -> Self {
        let all: Vec<_> = attempts.into_iter().collect();
        let lately = &all[all.len().saturating_sub(LATELY)..];
        Self {
            name: name.into(),
            lately: Tally::of(lately.iter().copied()),
            all: Tally::of(all),
        }
    }

    /// How well the topic is known.
    pub(crate) fn mastery(&self) -> Mastery {
        let (attempts, right) = (self.lately.attempts, self.lately.right);
        match attempts {
            0 => Mastery::New,
            _ if attempts >= LATELY && 5 * right >= 4 * attempts => Mastery::Solid,
            _ if 2 * right >= attempts => Mastery::Growing,
            _ => Mastery::NotYet,
        }
    }
}

/// All topics that have come up in questions, in the order of their first questions.
pub fn topics<'a>(attempts: impl IntoIterator<Item = &'a Attempt>) -> Vec<TopicStanding> {
    let mut met: IndexMap<&str, Vec<&Attempt>> = IndexMap::new();
    for attempt in attempts {
        met.entry(&attempt.topic).or_default().push(attempt);
    }
    let met = met.into_values();
    met.filter_map(|of_it| Some(TopicStanding::of(of_it.first()?.topic_name(), of_it)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::tally::tests::attempt;
    use super::*;

    #[test]
    fn topics_are_in_order_of_appearance_with_their_recent_state() {
        let mut all = vec![attempt("b", 20.0), attempt("a", 1.0)];
        all.extend((0..3).map(|_| attempt("b", 20.0)));
        assert_eq!(topics(&all)[0].mastery(), Mastery::NotYet);
        all.extend((0..4).map(|_| attempt("b", 1.0)));
        let topics = topics(&all);
        assert_eq!(topics.len(), 2);
        assert_eq!(
            (topics[0].name.as_str(), topics[1].name.as_str()),
            ("b", "a")
        );
        assert_eq!((topics[0].all.attempts, topics[0].lately.right), (8, 4));
        assert_eq!(topics[0].mastery(), Mastery::Solid);
        assert_eq!(topics[1].mastery(), Mastery::Growing);
    }

    #[test]
    fn the_mastery_of_a_topic_depends_on_right_answers() {
        for (right, wrong, mastery) in [
            (0, 0, Mastery::New),
            (0, 1, Mastery::NotYet),
            (1, 0, Mastery::Growing),
            (0, 3, Mastery::NotYet),
            (1, 1, Mastery::Growing),
            (2, 3, Mastery::NotYet),
            (3, 2, Mastery::Growing),
            (4, 0, Mastery::Growing),
            (4, 1, Mastery::Solid),
        ] {
            let errors = std::iter::repeat_n(0.0, right).chain(std::iter::repeat_n(20.0, wrong));
            let attempts: Vec<_> = errors.map(|error| attempt("a", error)).collect();
            let found = TopicStanding::of("a", &attempts).mastery();
            assert_eq!(found, mastery, "{right} right, {wrong} wrong");
        }
    }
}
