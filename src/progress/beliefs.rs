//! Which misconceptions were held, and whether they fade.

use std::fmt;

use super::Attempt;
use crate::quiz::Misconception;

/// A misconception that answers fitted, in the first half of all attempts and in the
/// second, which is the larger one by one where there is an odd number of attempts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HeldBelief {
    /// Which.
    pub misconception: Misconception,
    /// In the first half.
    pub before: Occurrence,
    /// In the second.
    pub since: Occurrence,
}

/// How often a misconception showed itself, of how often it could have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Occurrence {
    /// How many answers fitted it.
    pub times: usize,
    /// How many questions could have shown it.
    pub asked: usize,
}

/// "2 of 5"; "-" where it was never asked.
impl fmt::Display for Occurrence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self { asked: 0, .. } => f.pad("-"),
            Self { times, asked } => f.pad(&format!("{times} of {asked}")),
        }
    }
}

/// Where a belief is going.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trend {
    /// It was not there before.
    New,
    /// It is there about as often as before, or more often.
    Held,
    /// Of the questions that could show it, at most half as many do as before; or it was
    /// not there the one time that one was asked since.
    Fading,
    /// It was there, and questions that could show it, two or more, did not any more.
    Gone,
    /// It was there, and nothing that could show it has been asked since.
    NotMet,
}

impl Trend {
    /// As shown.
    pub const fn name(self) -> &'static str {
        match self {
            Self::New => "new",
            Self::Held => "still there",
            Self::Fading => "fading",
            Self::Gone => "gone",
            Self::NotMet => "not met since",
        }
    }

    /// Whether it goes the right way.
    pub const fn is_good(self) -> bool {
        matches!(self, Self::Fading | Self::Gone)
    }
}

impl HeldBelief {
    /// How many answers fitted it.
    pub fn count(&self) -> usize {
        self.before.times + self.since.times
    }

    /// Where it is going.
    pub fn trend(&self) -> Trend {
        let Self { before, since, .. } = self;
        match (before.times, since.times) {
            (_, 0) => match since.asked {
                0 => Trend::NotMet,
                1 => Trend::Fading,
                _ => Trend::Gone,
            },
            (0, _) => Trend::New,
            _ if 2 * since.times * before.asked <= before.times * since.asked => Trend::Fading,
            _ => Trend::Held,
        }
    }
}

/// All misconceptions that were held, the one held most since the middle first. Those
/// that this carrom does not know are left out.
pub fn beliefs(attempts: &[Attempt]) -> Vec<HeldBelief> {
    let held: Vec<_> = attempts.iter().map(Attempt::held).collect();
    let mut beliefs: Vec<_> = Misconception::ALL
        .iter()
        .filter(|it| held.contains(&Some(**it)))
        .map(|&misconception| HeldBelief {
            misconception,
            before: Occurrence::default(),
            since: Occurrence::default(),
        })
        .collect();
    if beliefs.is_empty() {
        return beliefs;
    }
    let middle = attempts.len() / 2;
    for (i, (attempt, held)) in attempts.iter().zip(held).enumerate() {
        let could_show = attempt.could_show();
        for belief in &mut beliefs {
            let shows = held == Some(belief.misconception);
            // Where it was not noted what could show itself, what did is known.
            if shows || could_show.contains(&belief.misconception) {
                let occurrence = match i < middle {
                    true => &mut belief.before,
                    false => &mut belief.since,
                };
                occurrence.asked += 1;
                occurrence.times += usize::from(shows);
            }
        }
    }
    beliefs.sort_by_key(|belief| std::cmp::Reverse((belief.since.times, belief.before.times)));
    beliefs
}

#[cfg(test)]
mod tests {
    use super::super::tally::tests::attempt;
    use super::*;

    /// What follows from answers, each of which could show these, and shows the first if
    /// it is marked so.
    fn trend(answers: &[(&[&str], bool)]) -> Vec<(&'static str, [usize; 4], Trend)> {
        let attempts: Vec<_> = answers
            .iter()
            .map(|(could_show, shows)| Attempt {
                question: serde_json::json!({ "misconceptions": could_show }).to_string(),
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
    fn beliefs_come_fade_go_or_stay() {
        const C: &[&str] = &["copied-angle", "swapped"];
        const OTHER: &[&str] = &["half-and-half"];
        for (answers, counts, expected) in [
            (vec![(C, true)], [0, 0, 1, 1], Trend::New),
            (vec![(C, true), (C, true)], [1, 1, 1, 1], Trend::Held),
            (
                vec![(OTHER, false), (OTHER, false), (C, true), (C, true)],
                [0, 0, 2, 2],
                Trend::New,
            ),
            (
                vec![(C, true), (C, true), (OTHER, false), (OTHER, false)],
                [2, 2, 0, 0],
                Trend::NotMet,
            ),
            (
                vec![(C, true), (C, true), (C, false), (OTHER, false)],
                [2, 2, 0, 1],
                Trend::Fading,
            ),
            (
                vec![(C, true), (OTHER, false), (C, false), (C, false)],
                [1, 1, 0, 2],
                Trend::Gone,
            ),
            (
                vec![(C, true), (C, true), (C, true), (C, false)],
                [2, 2, 1, 2],
                Trend::Fading,
            ),
            // Once of once is no less often than twice of four times.
            (
                vec![
                    (C, true),
                    (C, false),
                    (C, false),
                    (C, true),
                    (C, true),
                    (OTHER, false),
                    (OTHER, false),
                    (OTHER, false),
                ],
                [2, 4, 1, 1],
                Trend::Held,
            ),
        ] {
            let found = trend(&answers);
            assert_eq!(found, [("copied-angle", counts, expected)]);
        }
        assert!(trend(&[(C, false)]).is_empty() && trend(&[]).is_empty());
    }

    #[test]
    fn what_is_unknown_is_left_out_and_what_was_not_noted_counts_where_it_shows() {
        assert!(trend(&[(&["unheard-of"], true)]).is_empty());
        let old = Attempt {
            misconception: Some("swapped".into()),
            ..attempt("a", 20.0)
        };
        let found = beliefs(&[old, attempt("a", 1.0)]);
        assert_eq!(found[0].before, Occurrence { times: 1, asked: 1 });
        assert_eq!(found[0].trend(), Trend::NotMet);
    }
}
