//! How well a level was won.

/// The maximum number of stars in a level.
pub(crate) const MOST_STARS: u8 = 3;

/// The maximum number of shots for the second star, which must be won without a hint.
pub(crate) const FEW_SHOTS: u32 = 3;

/// How a level was won.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Win {
    /// The number of shots since the level was opened, including the winning shot.
    pub shots: u32,
    /// The number of hints that were shown before the level was won.
    pub hints: usize,
    /// Whether the prediction for the winning shot was right; `None` if there was nothing to
    /// predict.
    pub(crate) said_right: Option<bool>,
}

impl Win {
    /// The number of stars: one for winning, one for few shots without a hint, and one for a right
    /// prediction or, if there is nothing to predict, for winning with the first shot.
    pub(crate) fn stars(&self) -> u8 {
        1 + u8::from(self.has_few_shots()) + u8::from(self.is_accurate())
    }

    /// Whether the win earns the star for winning with few shots and without a hint.
    pub(crate) fn has_few_shots(&self) -> bool {
        self.shots <= FEW_SHOTS && self.hints == 0
    }

    /// Whether the win earns the star for accuracy.
    pub(crate) fn is_accurate(&self) -> bool {
        self.said_right.unwrap_or(self.shots <= 1)
    }
}

/// A level that was won, with the largest number of stars ever won in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Starred {
    /// The name of the pack to which the level belongs.
    pub pack: String,
    /// The id of the level.
    pub level: String,
    /// The number of stars, from 1.
    pub stars: u8,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_star_is_earned_independently() {
        let stars = |shots, said_right| {
            let hints = 0;
            let win = Win {
                shots,
                hints,
                said_right,
            };
            let hinted = Win { hints: 12, ..win };
            // A hint costs the star for few shots, but no other star.
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
