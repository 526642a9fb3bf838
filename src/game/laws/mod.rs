//! The referee: the verdict of the rules on a stroke.
//!
//! A [`Case`] contains the facts that the rules use, as numbers of coins; a [`Verdict`] is the
//! decision. Neither contains positions. Each of these files contains one topic of the Laws of
//! Carrom of the International Carrom Federation, or one set of other rules:
//!
//! | file | laws |
//! |---|---|
//! | `opening` | 17, 18: when the break counts |
//! | `ending` | 25 to 28, 75 to 85: last coins, who wins the board and by how much |
//! | `queen` | 65 to 74: the queen and her cover |
//! | `coins` | 21, 45 to 48: the player's coins, the opponent's, the striker |
//! | `friendly` | the rules of most families |
//! | `points` | point carrom |
//! | `practice` | no rules at all |
//! | `solo` | a board for one player |
//!
//! Cases that cannot happen on a screen are left out: pushing, touching coins, the hand beyond the
//! arrows, jumping coins (38, 39), coins on edge or on top of each other (40 to 43), playing out of
//! turn (24), and so every law that begins "by an improper stroke" (49, 50 and the second half of
//! 71 to 85). The striker cannot be struck from an illegal position because it cannot be placed
//! there, and strokes are not timed (23), so there are no fouls (36, 37). If the Laws grant a point
//! "if demanded", it is always demanded, and a due is never forgone (53, 60). Sides are not changed
//! (31 to 34): on a screen they are all the same.
//!
//! The modules `play`, `free_place` and `seat` carry a verdict out: dues that wait (45b, 51), the
//! position of a piece that is put back (62b, 66, 67) and the order of turns (22).

mod case;
mod coins;
mod ending;
mod friendly;
mod opening;
mod page;
mod points;
mod practice;
mod queen;
mod ruling;
mod solo;
#[cfg(test)]
mod tests;

pub(crate) use case::{Case, QueenBefore, QueenFate, Side, TurnFate, Verdict};
pub(crate) use page::RuleLine;
pub(crate) use points::{POINTS_TO_WIN, Taken};
pub(crate) use ruling::Law;
pub use ruling::{BoardWon, Ruling, RulingEffect};

use serde::{Deserialize, Serialize};

/// The rules of a game; as text, their name for players, such as "friendly".
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, strum::IntoStaticStr,
)]
#[strum(serialize_all = "lowercase")]
#[serde(rename_all = "snake_case")]
pub enum Rules {
    /// The Laws of Carrom, in singles or doubles, as a match of three games.
    #[default]
    Tournament,
    /// The simple rules of most families: the first player to clear their coins wins the board.
    Friendly,
    /// Point carrom: either colour counts for both sides, and the first side with more than half of
    /// the points wins.
    Points,
    /// There are no turns and no dues: the striker may be placed anywhere, and every stroke may be
    /// taken back.
    Practice,
    /// A board for one player, from a code: six coins to clear in the fewest strokes.
    #[strum(serialize = "board of the day")]
    Solo,
}

impl Rules {
    /// Whether there is only one player.
    pub(crate) const fn is_alone(self) -> bool {
        matches!(self, Self::Practice | Self::Solo)
    }
}

/// The verdict of the rules on a stroke.
pub(crate) fn judge(rules: Rules, case: &Case) -> Verdict {
    match rules {
        Rules::Tournament => opening::judge(case)
            .or_else(|| ending::judge(case))
            .or_else(|| queen::judge(case).map(|verdict| verdict.with_others(case)))
            .unwrap_or_else(|| coins::judge(case)),
        Rules::Friendly => friendly::judge(case),
        Rules::Points => points::judge(case),
        Rules::Practice => practice::judge(case),
        Rules::Solo => solo::judge(case),
    }
}

/// The verdict if coins block every position of the striker. The Laws do not cover this case: the
/// turn passes without a penalty, but a board for one player is lost.
pub(crate) fn no_place(rules: Rules, to_cover: bool) -> Verdict {
    if rules == Rules::Solo {
        let text = "Coins block every position of the striker, so the board is lost.";
        return Verdict::ends(None, text.to_owned(), false, 1);
    }
    let text = "Coins block every position of the striker, so the turn passes.".to_owned();
    Verdict::passes(None, text).queen_if(to_cover, QueenFate::GoesBack)
}
