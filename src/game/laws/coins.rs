//! The player's own coins, the opponent's, and the striker (21, 45 to 48).

use super::case::{Case, Verdict, coins};
use super::ruling::Law;

/// The verdict on a stroke that does not concern the break, the queen or the end.
pub(super) fn judge(case: &Case) -> Verdict {
    if case.striker_fell {
        striker_fell(case)
    } else {
        proper(case)
    }
}

fn proper(case: &Case) -> Verdict {
    let law = Law::new(21);
    let player = case.colour;
    let own = coins(case.own.fell, player);
    let others = coins(case.other.fell, player.other());
    match (case.own.fell, case.other.fell) {
        (0, 0) => Verdict::passes(law, format!("Nothing fell, so {player}'s turn passes.")),
        (0, _) => Verdict::passes(
            law,
            format!(
                "{player} pocketed {others} and none of its own: what fell stays down and the turn \
                 passes."
            ),
        ),
        (_, 0) => Verdict::continues(
            law,
            format!("{player} pocketed {own}, so the turn continues."),
        ),
        _ => Verdict::continues(
            law,
            format!("{player} pocketed {own} as well as {others}, so the turn continues."),
        ),
    }
}

fn striker_fell(case: &Case) -> Verdict {
    let player = case.colour;
    let own = coins(case.own.fell, player);
    let others = coins(case.other.fell, player.other());
    match (case.own.fell, case.other.fell) {
        (0, 0) => Verdict::passes(
            Law::clause(45, 'a'),
            format!("The striker fell alone, so {player} owes one coin and the turn passes."),
        ),
        (0, _) => Verdict::passes(
            Law::new(47),
            format!(
                "The striker fell with {others}: what fell stays down, {player} owes one coin \
                 and the turn passes."
            ),
        ),
        (_, 0) => Verdict::continues(
            Law::new(46),
            format!(
                "The striker fell with {own}: what fell comes back and one more is due, but \
                 {player}'s turn continues."
            ),
        ),
        _ => Verdict::continues(
            Law::new(48),
            format!(
                "The striker fell with {own} and {others}: only {player}'s come back, one more \
                 is due, and the turn continues."
            ),
        ),
    }
    .own_back(case.own.fell)
    .one_due()
}
