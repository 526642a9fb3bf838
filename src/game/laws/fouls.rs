//! Fouls (36, 37): on a screen, letting the stroke clock run out (23).

use super::Rules;
use super::case::{QueenFate, Verdict};
use super::ruling::Law;
use crate::game::pieces::Colour;

/// The verdict on a foul by `player`, who may have struck in this turn already
/// (`struck`) and may have the queen to cover.
///
/// Only the tournament game knows fouls; elsewhere the turn just passes. A queen that was
/// to be covered goes back when the turn is lost (69).
pub(crate) fn foul(rules: Rules, player: Colour, struck: bool, to_cover: bool) -> Verdict {
    match (rules, struck) {
        (Rules::Practice, _) => Verdict::continues(None, "In practice there are no fouls.".to_owned()),
        (Rules::Friendly, _) => {
            Verdict::passes(None, format!("{player} took too long, so the turn passes."))
                .queen_if(to_cover, QueenFate::GoesBack)
        }
        (Rules::Tournament, false) => Verdict::continues(
            Law::clause(36, 'a'),
            format!("A foul before the first stroke of the turn costs {player} one coin, but not the turn."),
        )
        .one_due(),
        (Rules::Tournament, true) => Verdict::passes(
            Law::clause(37, 'a'),
            format!("A foul during the turn costs {player} one coin and the turn."),
        )
        .one_due()
        .queen_if(to_cover, QueenFate::GoesBack),
    }
}

/// The verdict when coins bar every place for the striker. The Laws do not
/// foresee it; the turn passes without a penalty.
pub(crate) fn no_place(player: Colour, to_cover: bool) -> Verdict {
    let text = format!("Coins bar every place for the striker, so {player}'s turn passes.");
    Verdict::passes(None, text).queen_if(to_cover, QueenFate::GoesBack)
}
