//! How well a level was won.

use std::collections::BTreeMap;

/// The most stars a level gives.
pub const MOST_STARS: u8 = 3;

/// Up to this many shots a win has the star for few shots.
pub const FEW_SHOTS: u32 = 3;

/// A level won.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Win {
    /// Shots it took since the level was opened, the winning one included.
    pub shots: u32,
    /// Whether what the player said before the winning shot was right; `None` where
    /// there was nothing to say.
    pub said_right: Option<bool>,
}

impl Win {
    /// One star for winning, one for few shots, and one for saying first what would
    /// come about; where there is nothing to say, for winning with the first shot.
    pub fn stars(&self) -> u8 {
        1 + u8::from(self.has_few_shots()) + u8::from(self.is_accurate())
    }

    /// Whether it has the star for few shots.
    pub fn has_few_shots(&self) -> bool {
        self.shots <= FEW_SHOTS
    }

    /// Whether it has the star for accuracy.
    pub fn is_accurate(&self) -> bool {
        self.said_right.unwrap_or(self.shots <= 1)
    }
}

/// A level that was won, with the most stars it was ever won with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Starred {
    /// The name of its pack.
    pub pack: String,
    /// Its id.
    pub level: String,
    /// How many, from 1.
    pub stars: u8,
}

/// The best that was done in each level.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Best(BTreeMap<(String, String), u8>);

impl Best {
    /// Stars of a level, by the name of its pack and its id; 0 if it was never won.
    pub fn stars(&self, pack: &str, id: &str) -> u8 {
        let key = (pack.to_owned(), id.to_owned());
        self.0.get(&key).copied().unwrap_or(0)
    }

    /// Keeps these stars of a level unless there were as many already; says whether
    /// they are more.
    pub fn keep(&mut self, pack: &str, id: &str, stars: u8) -> bool {
        let best = self.0.entry((pack.into(), id.into())).or_default();
        let more = stars > *best;
        *best = stars.max(*best);
        more
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_star_is_earned_by_itself() {
        let stars = |shots, said_right| Win { shots, said_right }.stars();
        assert_eq!(stars(1, Some(true)), MOST_STARS);
        assert_eq!(stars(1, Some(false)), 2);
        assert_eq!(stars(FEW_SHOTS + 1, Some(true)), 2);
        assert_eq!(stars(FEW_SHOTS + 1, Some(false)), 1);
        assert_eq!(stars(1, None), MOST_STARS);
        assert_eq!(stars(2, None), 2);
    }

    #[test]
    fn a_worse_win_takes_nothing_away() {
        let mut best = Best::default();
        assert_eq!(best.stars("pack", "a"), 0);
        for (stars, more, most) in [(1, true, 1), (3, true, 3), (2, false, 3), (3, false, 3)] {
            assert_eq!(best.keep("pack", "a", stars), more);
            assert_eq!(best.stars("pack", "a"), most);
        }
        assert_eq!(best.stars("other", "a"), 0);
    }
}
