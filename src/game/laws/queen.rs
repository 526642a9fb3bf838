//! The queen and her cover (65 to 74).

use super::case::{Case, QueenBefore, QueenFate, Verdict, coins};
use super::ruling::Law;

/// The verdict on a stroke in which the queen fell or was to be covered; `None`
/// for any other.
pub(super) fn judge(case: &Case) -> Option<Verdict> {
    match case.queen {
        QueenBefore::ToCover => Some(covering(case)),
        QueenBefore::OnBoard if case.queen_fell => Some(pocketed(case)),
        _ => None,
    }
}

/// The stroke that has to cover the queen.
fn covering(case: &Case) -> Verdict {
    let player = case.colour;
    match (case.own.fell, case.striker_fell) {
        (0, false) => Verdict::passes(
            Law::new(69),
            format!(
                "None of {player}'s coins fell to cover the queen, so she goes back to the centre \
                 and the turn passes."
            ),
        )
        .queen(QueenFate::GoesBack),
        (0, true) => Verdict::passes(
            Law::clause(73, 'a'),
            format!(
                "{player} pocketed the striker instead of a cover, so the queen goes back, one \
                 coin is due and the turn passes."
            ),
        )
        .one_due()
        .queen(QueenFate::GoesBack),
        (own, true) => Verdict::continues(
            Law::clause(74, 'a'),
            format!(
                "The striker fell along with the cover, so {} and one due are put back, and {player}'s \
                 next stroke must cover the queen.",
                coins(own, player)
            ),
        )
        .own_back(own)
        .one_due(),
        (_, false) => Verdict::continues(
            Law::new(65),
            format!(
                "{player} pocketed one of its coins after the queen, so she is covered and the \
                 turn continues."
            ),
        )
        .queen(QueenFate::Covered),
    }
}

/// The stroke in which the queen fell.
fn pocketed(case: &Case) -> Verdict {
    let player = case.colour;
    if case.owes {
        return pocketed_in_debt(case);
    }
    match (case.own.fell, case.striker_fell) {
        (0, true) if case.own.had_all() => Verdict::passes(
            Law::clause(68, 'd'),
            format!(
                "The striker fell with the queen while all nine of {player}'s coins were on the \
                 board, so she goes back, one coin is due and the turn passes."
            ),
        )
        .one_due()
        .queen(QueenFate::GoesBack),
        (0, true) => Verdict::continues(
            Law::clause(72, 'a'),
            format!(
                "The striker fell with the queen, so she goes back and one coin is due, but \
                 {player}'s turn continues."
            ),
        )
        .one_due()
        .queen(QueenFate::GoesBack),
        (own, true) => Verdict::continues(
            Law::clause(71, 'a'),
            format!(
                "The striker fell with the queen and {}, so all come back and one coin is due, but \
                 {player}'s turn continues.",
                coins(own, player)
            ),
        )
        .own_back(own)
        .one_due()
        .queen(QueenFate::GoesBack),
        (0, false) if !case.may_take_queen => Verdict::passes(
            Law::clause(68, 'a'),
            format!(
                "{player} had not pocketed a coin of its own before the queen, so she goes \
                 back and the turn passes."
            ),
        )
        .queen(QueenFate::GoesBack),
        (0, false) => {
            let number = if case.own.had_all() {
                Law::clause(68, 'c')
            } else {
                Law::new(65)
            };
            Verdict::continues(
                number,
                format!(
                    "{player} pocketed the queen and must cover her with one of its coins in \
                     the next stroke."
                ),
            )
        }
        (1, false) if case.own.had_all() => Verdict::continues(
            Law::clause(70, 'b'),
            format!(
                "With all nine of {player}'s coins on the board, one coin falling with the queen \
                 does not cover her: the next stroke must."
            ),
        ),
        (own, false) => {
            let law = Law::clause(70, if case.own.had_all() { 'b' } else { 'a' });
            Verdict::continues(
                law,
                format!(
                    "{player} pocketed {} with the queen, so she is covered and the turn \
                     continues.",
                    coins(own, player)
                ),
            )
            .queen(QueenFate::Covered)
        }
    }
}

/// The queen fell while the player owed a coin: she goes back, no matter what fell with her, and
/// the turn passes.
fn pocketed_in_debt(case: &Case) -> Verdict {
    let player = case.colour;
    let verdict = Verdict::passes(
        Law::clause(68, 'b'),
        format!(
            "{player} still owed a coin when the queen fell, so she goes back and the turn passes."
        ),
    )
    .queen(QueenFate::GoesBack);
    if case.striker_fell {
        verdict.own_back(case.own.fell).one_due()
    } else {
        verdict
    }
}
