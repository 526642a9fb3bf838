//! Last coins: who wins the board, and by how much (25 to 28, 75 to 85).

use super::case::{Case, QueenBefore, QueenFate, Verdict, points};
use super::ruling::Law;

/// The maximum number of points for a board (law 28).
pub(crate) const MOST_POINTS: u8 = 12;

/// The verdict on a stroke that ends the board; `None` if the board continues.
///
/// Cases that the Laws do not cover follow the nearest law:
///
/// - If both last coins fall properly after the queen was covered, the player wins by the value of
///   the queen, or by 1 if she is worth nothing or was covered by the opponent (as in 75a).
/// - If the striker falls with both last coins while the queen is to be covered, the board is lost
///   as in 82a; if the queen is on the board, it is lost as in 78a, but by one more point.
/// - If the striker falls with the opponent's last coin while the queen is to be covered, the board
///   is lost by one more point than in 76a, just as 84a adds one to 79a.
/// - If the queen falls with the opponent's last coin, nobody has covered her, so her points are
///   awarded as in 79a.
pub(super) fn judge(case: &Case) -> Option<Verdict> {
    match (case.own.left(), case.other.left()) {
        (0, 0) => Some(both_finished(case)),
        (own_left, 0) => Some(opponent_finished(case, own_left)),
        (0, other_left) => player_finished(case, other_left),
        _ => None,
    }
}

/// The player's last coin and the opponent's fell together.
fn both_finished(case: &Case) -> Verdict {
    use QueenBefore::{Covered, OnBoard, ToCover};
    let player = case.colour;
    let striker = u8::from(case.striker_fell);
    let win = worth_at_least_one(case.own.queen_worth());
    let loss = worth_at_least_one(case.other.queen_worth());
    match (case.queen, case.striker_fell) {
        (Covered(by), false) => {
            let by_queen = if by == player { win } else { 1 };
            let why = format!("{player} pocketed both last coins together");
            won(case, 25, by_queen, why)
        }
        (Covered(by), true) => {
            let (number, loss) = if by == player { (83, 1) } else { (85, loss) };
            let why =
                format!("Both last coins fell, and the striker with them, and {by} had the queen");
            lost(case, number, loss + striker, why)
        }
        (ToCover, false) => {
            let why = format!("{player} covered the queen with both last coins");
            won(case, 75, win, why).queen(QueenFate::Covered)
        }
        (OnBoard, false) if case.queen_fell => {
            let why = format!("{player} pocketed the queen and both last coins in one stroke");
            won(case, 77, win, why).queen(QueenFate::Covered)
        }
        (OnBoard, _) if !case.queen_fell => {
            let why =
                format!("{player} pocketed both last coins with the queen still on the board");
            lost(case, 78, loss + striker, why)
        }
        (ToCover | OnBoard, _) => {
            let why =
                "The queen and both last coins fell, but the striker fell with them".to_owned();
            lost(case, 82, loss + striker, why)
        }
    }
}

/// The player pocketed the opponent's last coin and has `own_left` coins left.
fn opponent_finished(case: &Case, own_left: u8) -> Verdict {
    let player = case.colour;
    let other = player.other();
    let striker = u8::from(case.striker_fell);
    let with_queen = own_left + case.other.queen_worth() + striker;
    let fell = format!("{player} pocketed {other}'s last coin");
    match case.queen {
        QueenBefore::Covered(by) => {
            let queen = u8::from(by == other) * case.other.queen_worth();
            lost(case, 25, own_left + queen, fell)
        }
        QueenBefore::ToCover => {
            let why = format!("{fell} while the queen was to be covered");
            lost(case, 76, with_queen, why)
        }
        QueenBefore::OnBoard => {
            let number = if case.striker_fell { 84 } else { 79 };
            let why = format!("{fell} before the queen was covered");
            lost(case, number, with_queen, why)
        }
    }
}

/// The player's own last coin fell. With the queen still on the board, the board is lost;
/// otherwise, if the striker fell too, the coin is put back and the board continues: `None`.
fn player_finished(case: &Case, other_left: u8) -> Option<Verdict> {
    let player = case.colour;
    let (covered_by, fate) = match case.queen {
        QueenBefore::OnBoard if !case.queen_fell => {
            let loss = worth_at_least_one(case.other.queen_worth()) + u8::from(case.striker_fell);
            let number = if case.striker_fell { 81 } else { 80 };
            let why = format!("{player}'s last coin fell with the queen still on the board");
            return Some(lost(case, number, loss, why));
        }
        _ if case.striker_fell => return None,
        QueenBefore::Covered(by) => (by, QueenFate::Stays),
        QueenBefore::OnBoard | QueenBefore::ToCover => (player, QueenFate::Covered),
    };
    let queen = u8::from(covered_by == player) * case.own.queen_worth();
    let why = format!("{player} has pocketed all nine coins");
    Some(won(case, 25, other_left + queen, why).queen(fate))
}

/// The points for a board that the queen alone decides: her value, or 1 if she no longer has any
/// (75 to 82).
const fn worth_at_least_one(queen: u8) -> u8 {
    if queen == 0 { 1 } else { queen }
}

/// The player wins by clause a of the law with this number.
fn won(case: &Case, law: u8, by: u8, why: String) -> Verdict {
    ends(case, law, by, why, true)
}

/// The player loses by clause a of the law with this number.
fn lost(case: &Case, law: u8, by: u8, why: String) -> Verdict {
    ends(case, law, by, why, false)
}

fn ends(case: &Case, law: u8, by: u8, why: String, won: bool) -> Verdict {
    let winner = if won {
        case.colour
    } else {
        case.colour.other()
    };
    let by = by.min(MOST_POINTS);
    let text = why + &format!(", so {winner} wins the board by {}.", points(by));
    Verdict::ends(Law::clause(law, 'a'), text, won, by)
}
