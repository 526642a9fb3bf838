//! How each topic stands.

use super::{Attempt, Tally};

/// How many of the last attempts at a topic say how it stands now.
pub const LATELY: usize = 5;

/// A topic, and what was done with it.
#[derive(Debug, Clone, PartialEq)]
pub struct Topic {
    /// Its name: "equal masses, by offset".
    pub name: String,
    /// All attempts at it.
    pub all: Tally,
    /// The last [`LATELY`] of them.
    pub lately: Tally,
}

/// How well a topic is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mastery {
    /// Met less than three times: nobody can say yet.
    New,
    /// On the way.
    Growing,
    /// Met [`LATELY`] times at least, and four of the last five were right.
    Solid,
}

impl Mastery {
    /// As shown.
    pub const fn name(self) -> &'static str {
        match self {
            Self::New => "new",
            Self::Growing => "growing",
            Self::Solid => "solid",
        }
    }
}

impl Topic {
    /// What was done with these attempts, under this name.
    pub fn of<'a>(name: &str, attempts: impl IntoIterator<Item = &'a Attempt>) -> Self {
        let all: Vec<_> = attempts.into_iter().collect();
        let lately = &all[all.len().saturating_sub(LATELY)..];
        Self {
            name: name.to_owned(),
            lately: Tally::of(lately.iter().copied()),
            all: Tally::of(all),
        }
    }

    /// How well it is known.
    pub fn mastery(&self) -> Mastery {
        match self.all.attempts {
            0..3 => Mastery::New,
            _ if self.lately.attempts >= LATELY && 5 * self.lately.right >= 4 * LATELY => {
                Mastery::Solid
            }
            _ => Mastery::Growing,
        }
    }
}

/// All topics that were ever met, in the order in which they first were.
pub fn topics(attempts: &[Attempt]) -> Vec<Topic> {
    let mut names: Vec<&str> = Vec::new();
    for attempt in attempts {
        if !names.contains(&attempt.topic.as_str()) {
            names.push(&attempt.topic);
        }
    }
    let topic = |name: &str| Topic::of(name, attempts.iter().filter(|it| it.topic == name));
    names.into_iter().map(topic).collect()
}

#[cfg(test)]
mod tests {
    use super::super::tally::tests::attempt;
    use super::*;

    #[test]
    fn topics_come_as_they_were_met_and_stand_as_they_do_lately() {
        let mut all = vec![attempt("b", 20.0), attempt("a", 1.0)];
        assert!(
            topics(&all)
                .iter()
                .all(|topic| topic.mastery() == Mastery::New)
        );
        all.extend((0..3).map(|_| attempt("b", 20.0)));
        assert_eq!(topics(&all)[0].mastery(), Mastery::Growing);
        all.extend((0..4).map(|_| attempt("b", 1.0)));
        let topics = topics(&all);
        assert_eq!(topics.len(), 2);
        assert_eq!(
            (topics[0].name.as_str(), topics[1].name.as_str()),
            ("b", "a")
        );
        assert_eq!((topics[0].all.attempts, topics[0].lately.right), (8, 4));
        assert_eq!(topics[0].mastery(), Mastery::Solid);
        assert_eq!(topics[1].mastery(), Mastery::New);
    }
}
