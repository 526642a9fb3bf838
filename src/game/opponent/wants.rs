//! Which pieces a player wants to pocket.

use crate::game::laws::Rules;
use crate::game::{Game, Piece, Seat};

/// Whether the player whose turn it is wants to pocket `piece`.
pub(super) fn wants(game: &Game, piece: Piece) -> bool {
    wants_from(game, game.seat(), piece)
}

/// Whether the player at `seat` wants to pocket `piece`.
///
/// The wanted pieces are the player's own coins and the queen, once the rules allow it (65, 68).
/// In a tournament the player's last coin is not wanted while the queen is on the board, because
/// pocketing it then loses the board (80). In point carrom and without an opponent, every piece but
/// the striker is wanted.
pub(super) fn wants_from(game: &Game, seat: Seat, piece: Piece) -> bool {
    let rules = game.setup().rules;
    let team = game.team(seat);
    let play = game.play();
    match piece {
        Piece::Striker => false,
        _ if rules == Rules::Points || rules.is_alone() => true,
        Piece::Queen => {
            rules == Rules::Friendly || (play.pocketed_before[team] && play.owed[team] == 0)
        }
        Piece::White | Piece::Black => {
            let own = game.colour(team);
            let loses =
                rules == Rules::Tournament && play.queen_on_board() && play.on_board(own) == 1;
            piece == own.piece() && !loses
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{GameSetup, Team};

    #[test]
    fn a_players_own_coins_are_wanted_except_the_last_before_the_queen() {
        let mut game = Game::new(GameSetup::default());
        assert!(wants(&game, Piece::White));
        assert!(!wants(&game, Piece::Black));
        assert!(
            !wants(&game, Piece::Queen),
            "one of the player's coins first (65)"
        );
        assert!(wants_from(&game, Seat::North, Piece::Black));

        game.play.pocketed_before[Team::First] = true;
        assert!(wants(&game, Piece::Queen));
        game.play.owed[Team::First] = 1;
        assert!(!wants(&game, Piece::Queen), "not in debt (68b)");

        let mut whites = 0;
        game.play.coins.retain(|coin| {
            whites += u8::from(coin.piece == Piece::White);
            coin.piece != Piece::White || whites == 1
        });
        assert!(!wants(&game, Piece::White), "the queen first (80)");
        game.play.coins.retain(|coin| coin.piece != Piece::Queen);
        assert!(wants(&game, Piece::White));
    }
}
