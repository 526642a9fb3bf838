//! Fouls (36, 37): on a screen, letting the stroke clock run out (23).

use super::Rules;
use super::case::{QueenFate, Verdict};
use super::ruling::Law;
use crate::game::pieces::Colour;

/// The verdict on a foul by `player`, who may have struck in this turn already
/// (`struck`) and may have the queen to cover.
///
/// Only the tournament game knows fouls; elsewhere the turn just passes.
pub(crate) fn foul(rules: Rules, player: Colour, struck: bool, to_cover: bool) -> Verdict {
    match (rules, struck) {
        (Rules::Practice, _) => Verdict::continues(None, "In practice there are no fouls.".to_owned()),
        (Rules::Friendly, _) => uncover(
            Verdict::passes(None, format!("{player} took too long, so the turn passes.")),
            to_cover,
        ),
        (Rules::Tournament, false) => Verdict::continues(
            Law::clause(36, 'a'),
            format!("A foul before the first stroke of the turn costs {player} one coin, but not the turn."),
        )
        .one_due(),
        (Rules::Tournament, true) => uncover(
            Verdict::passes(
                Law::clause(37, 'a'),
                format!("A foul during the turn costs {player} one coin and the turn."),
            )
            .one_due(),
            to_cover,
        ),
    }
}

/// The verdict when coins bar every place for the striker. The Laws do not
/// foresee it; the turn passes without a penalty.
pub(crate) fn no_place(player: Colour, to_cover: bool) -> Verdict {
    let text = format!("Coins bar every place for the striker, so {player}'s turn passes.");
    uncover(Verdict::passes(None, text), to_cover)
}

/// A queen that was to be covered goes back when the turn is lost (69).
fn uncover(verdict: Verdict, to_cover: bool) -> Verdict {
    if to_cover {
        verdict.queen(QueenFate::GoesBack)
    } else {
        verdict
    }
}
