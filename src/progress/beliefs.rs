//! Which misconceptions were held, and whether they fade.

use super::Attempt;
use crate::quiz::Misconception;

/// A misconception that answers fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Belief {
    /// Which.
    pub misconception: &'static Misconception,
    /// How many answers fitted it in the first half of all attempts.
    pub before: usize,
    /// How many in the second half, which is the larger one by one where there is an
    /// odd number of attempts.
    pub since: usize,
}

/// Where a belief is going.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trend {
    /// It was there and is not any more.
    Gone,
    /// It is there half as often as before, or less.
    Fading,
    /// It is there about as often as before, or more often, or only now.
    Held,
}

impl Trend {
    /// As shown.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Gone => "gone",
            Self::Fading => "fading",
            Self::Held => "still there",
        }
    }
}

impl Belief {
    /// How many answers fitted it.
    pub fn count(&self) -> usize {
        self.before + self.since
    }

    /// Where it is going.
    pub fn trend(&self) -> Trend {
        match self.since {
            0 => Trend::Gone,
            since if 2 * since <= self.before => Trend::Fading,
            _ => Trend::Held,
        }
    }
}

/// All misconceptions that were held, the one held most since the middle first. Those
/// that this carrom does not know are left out.
pub fn beliefs(attempts: &[Attempt]) -> Vec<Belief> {
    let (before, since) = attempts.split_at(attempts.len() / 2);
    let count = |id: &str, part: &[Attempt]| {
        let fits = |it: &&Attempt| it.misconception.as_deref() == Some(id);
        part.iter().filter(fits).count()
    };
    let mut beliefs: Vec<_> = crate::quiz::misconceptions::all()
        .map(|misconception| Belief {
            misconception,
            before: count(misconception.id, before),
            since: count(misconception.id, since),
        })
        .filter(|belief| belief.count() > 0)
        .collect();
    beliefs.sort_by_key(|belief| std::cmp::Reverse((belief.since, belief.before)));
    beliefs
}

#[cfg(test)]
mod tests {
    use super::super::tally::tests::attempt;
    use super::*;

    fn held(ids: &[&str]) -> Vec<Belief> {
        let attempts: Vec<_> = ids
            .iter()
            .map(|id| Attempt {
                misconception: (!id.is_empty()).then(|| (*id).to_owned()),
                ..attempt("a", 20.0)
            })
            .collect();
        beliefs(&attempts)
    }

    #[test]
    fn beliefs_fade_go_or_stay() {
        let [c, h, s] = ["copied-angle", "half-and-half", "swapped"];
        let found = held(&[c, c, h, "unheard-of", s, c, "", s, "", ""]);
        let trends: Vec<_> = found
            .iter()
            .map(|belief| (belief.misconception.id, belief.count(), belief.trend()))
            .collect();
        assert_eq!(
            trends,
            [
                (c, 3, Trend::Fading),
                (s, 2, Trend::Held),
                (h, 1, Trend::Gone)
            ]
        );
        assert!(held(&["", ""]).is_empty() && held(&[]).is_empty());
    }
}
