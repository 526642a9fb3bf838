//! When the break counts (17, 18).

use super::case::{Case, Verdict, in_words};
use super::ruling::Law;

/// The number of strokes in which a player may try to touch the pack: one and "two more chances"
/// (18a).
const TRIES: u8 = 3;

/// The verdict on a stroke at the unbroken pack that touched nothing; `None`
/// once the striker has touched a coin, even slightly (17).
pub(super) fn judge(case: &Case) -> Option<Verdict> {
    let tries = case
        .break_tries
        .filter(|_| !case.touched)?
        .saturating_add(1);
    let player = case.colour;
    Some(if case.striker_fell {
        Verdict::passes(
            Law::clause(18, 'c'),
            format!(
                "{player} pocketed the striker without touching a coin, so the turn passes, but before the break nothing is owed."
            ),
        )
    } else if tries < TRIES {
        let left = match TRIES - tries {
            1 => "one more chance".to_owned(),
            more => format!("{} more chances", in_words(more)),
        };
        Verdict::continues(
            Law::clause(18, 'a'),
            format!(
                "The striker touched no coin, so the break does not count yet and {player} has {left}."
            ),
        )
    } else {
        Verdict::passes(
            Law::clause(18, 'b'),
            format!(
                "{player} touched no coin in three strokes, so the break passes to {} and the colours do not change.",
                player.other()
            ),
        )
    })
}
