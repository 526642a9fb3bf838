//! How well a level was won.

/// The most stars a level gives.
pub(crate) const MOST_STARS: u8 = 3;

/// The most shots, without a hint, for the second star.
pub(crate) const FEW_SHOTS: u32 = 3;

/// A level won.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Win {
    /// Shots it took since the level was opened, the winning one included.
    pub shots: u32,
    /// Hints that were asked for by then.
    pub hints: usize,
    /// Whether the prediction before the winning shot was right; `None` if there was nothing to
    /// predict.
    pub(crate) said_right: Option<bool>,
}

impl Win {
    /// One star for winning, one for few shots without a hint, and one for a right prediction; if
    /// there is nothing to predict, for winning with the first shot.
    pub(crate) fn stars(&self) -> u8 {
        1 + u8::from(self.has_few_shots()) + u8::from(self.is_accurate())
    }

    /// Whether it has the star for few shots without a hint.
    pub(crate) fn has_few_shots(&self) -> bool {
        self.shots <= FEW_SHOTS && self.hints == 0
    }

    /// Whether it has the star for accuracy.
    pub(crate) fn is_accurate(&self) -> bool {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_star_is_earned_by_itself() {
        let stars = |shots, said_right| {
            let hints = 0;
            let win = Win {
                shots,
                hints,
                said_right,
            };
            let hinted = Win { hints: 12, ..win };
            // A hint costs the star for few shots and no other.
            assert_eq!(hinted.stars(), win.stars() - u8::from(shots <= FEW_SHOTS));
            win.stars()
        };
        assert_eq!(stars(1, Some(true)), MOST_STARS);
        assert_eq!(stars(1, Some(false)), 2);
        assert_eq!(stars(FEW_SHOTS + 1, Some(true)), 2);
        assert_eq!(stars(FEW_SHOTS + 1, Some(false)), 1);
        assert_eq!(stars(1, None), MOST_STARS);
        assert_eq!(stars(2, None), 2);
    }
}
