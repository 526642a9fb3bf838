//! The simple rules of most families.
//!
//! - Pocket one of your coins, or the queen, and you play on.
//! - An opponent's coin stays down and helps the opponent.
//! - Pocket the striker and one of your coins goes back, if you have one to give; the turn passes.
//!   No debt remains.
//! - The queen may be taken at any time and must be covered: with one of your coins in the same
//!   stroke or the next. Otherwise, or if the striker falls, she goes back to the centre.
//! - The first player to clear their coins wins the board: a point for each coin the other has left
//!   and 3 for the queen if they covered her, but at least 1 in all. If you clear your coins while
//!   the queen is on the board, she is worth no points.
//! - A break that touches nothing passes the turn like any other miss.

use crate::game::pieces::COINS_EACH;

use super::case::{Case, QUEEN_POINTS, QueenBefore, QueenFate, Verdict, coins, points};

/// The verdict on a stroke in a friendly game.
pub(super) fn judge(case: &Case) -> Verdict {
    ending(case).unwrap_or_else(|| {
        let verdict = match case.striker_fell {
            true => striker_fell(case),
            false => proper(case),
        };
        verdict.with_others(case)
    })
}

/// The end of the board, if a colour is cleared. If the striker falls too, one of the player's
/// coins is put back, so the player cannot have cleared the board.
fn ending(case: &Case) -> Option<Verdict> {
    let won = case.own.left() == 0 && !case.striker_fell;
    if !won && case.other.left() > 0 {
        return None;
    }
    let (winner, left) = if won {
        (case.colour, case.other.left())
    } else {
        (case.colour.other(), case.own.left())
    };
    let covers = won && (case.queen == QueenBefore::ToCover || case.queen_fell);
    let queen = if covers || case.queen == QueenBefore::Covered(winner) {
        QUEEN_POINTS
    } else {
        0
    };
    // Both colours may be cleared at once; even then the winner gets at least one point.
    let by = (left + queen).max(1);
    let text = format!(
        "All {} coins are down, so {winner} wins the board by {}.",
        winner.adjective(),
        points(by)
    );
    Some(Verdict::ends(None, text, won, by).queen_if(covers, QueenFate::Covered))
}

fn striker_fell(case: &Case) -> Verdict {
    let player = case.colour;
    let queen_open = case.queen_fell || case.queen == QueenBefore::ToCover;
    let has_coin = case.own.left() < COINS_EACH;
    let back = match (has_coin, queen_open) {
        (true, true) => format!(", so the queen and one of {player}'s coins go back"),
        (true, false) => format!(", so one of {player}'s coins goes back"),
        (false, true) => ", so the queen goes back".to_owned(),
        (false, false) => format!(" and {player} has no coin to put back"),
    };
    let text = format!("The striker fell{back}. The turn passes.");
    Verdict::passes(None, text)
        .own_back(u8::from(has_coin))
        .queen_if(queen_open, QueenFate::GoesBack)
}

fn proper(case: &Case) -> Verdict {
    let player = case.colour;
    let own = coins(case.own.fell, player);
    let queen_open = case.queen_fell || case.queen == QueenBefore::ToCover;
    match (case.own.fell, queen_open) {
        (0, true) if case.queen_fell => Verdict::continues(
            None,
            format!(
                "{player} pocketed the queen and must cover her with one of its coins in the next \
                 stroke."
            ),
        ),
        (0, true) => Verdict::passes(
            None,
            format!(
                "None of {player}'s coins fell to cover the queen, so she goes back and the turn \
                 passes."
            ),
        )
        .queen(QueenFate::GoesBack),
        (0, false) => Verdict::passes(
            None,
            format!("{player} pocketed none of its coins, so the turn passes."),
        ),
        (_, true) => Verdict::continues(
            None,
            format!("{player} pocketed {own}: the queen is covered and the turn continues."),
        )
        .queen(QueenFate::Covered),
        (_, false) => Verdict::continues(
            None,
            format!("{player} pocketed {own}, so the turn continues."),
        ),
    }
}
