//! Boards for one player: there are no turns, and pocketed coins stay down unless the striker falls
//! with them.

use super::case::{Case, Verdict, in_words};
use crate::numbers::capital;

/// The verdict on a stroke on a board for one player.
pub(super) fn judge(case: &Case) -> Verdict {
    let (fell, before) = (case.own.fell, case.own.before);
    if case.striker_fell {
        let text = match fell {
            0 => "The striker fell.".to_owned(),
            1 => "The striker fell too, so the coin comes back.".to_owned(),
            more => format!(
                "The striker fell too, so the {} coins come back.",
                in_words(more)
            ),
        };
        return Verdict::continues(None, text).own_back(fell);
    }
    match before.saturating_sub(fell) {
        0 => Verdict::ends(None, "The board is cleared.".to_owned(), true, 1),
        left => {
            let fell = match fell {
                0 => "Nothing fell".to_owned(),
                1 => "One coin is down".to_owned(),
                more => format!("{} coins are down", capital(&in_words(more))),
            };
            let plural = if left == 1 { "" } else { "s" };
            let left = format!("{} coin{plural}", in_words(left));
            Verdict::continues(None, format!("{fell}, {left} to go."))
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use crate::game::{BoardCode, Coin, Game, GameStage, Piece, Stroke, Team};

    /// A game after a stroke that pockets `fell` coins (and the striker if `fouls` is set), and
    /// what the referee says.
    fn after(fell: usize, fouls: bool) -> (Game, String) {
        let mut game = Game::new(BoardCode::from_number(4711).unwrap().setup());
        let coins = game.coins().to_vec();
        let mut pocketed = vec![Piece::White; fell];
        pocketed.extend(fouls.then_some(Piece::Striker));
        let stroke = Stroke {
            touched: true,
            pocketed,
            left: coins[fell..].to_vec(),
        };
        let rulings = game.apply(&stroke).unwrap();
        (game, rulings[0].text.clone())
    }

    #[test]
    fn pocketed_coins_stay_down_unless_the_striker_falls_too() {
        for (fell, fouls, left, words) in [
            (0, false, 6, "Nothing fell, six coins to go."),
            (1, false, 5, "One coin is down, five coins to go."),
            (5, false, 1, "Five coins are down, one coin to go."),
            (0, true, 6, "The striker fell."),
            (1, true, 6, "The striker fell too, so the coin comes back."),
            (
                6,
                true,
                6,
                "The striker fell too, so the six coins come back.",
            ),
        ] {
            let (game, said) = after(fell, fouls);
            assert_eq!(said, words);
            assert_eq!(game.coins().len(), left);
            assert!(game.coins().iter().all(|coin| coin.piece == Piece::White));
            assert_eq!(game.stage(), GameStage::Playing);
            assert_eq!(game.seat(), crate::game::Seat::South);
        }
        let (game, said) = after(6, false);
        assert_eq!(said, "The board is cleared.");
        assert_eq!(game.stage(), GameStage::MatchOver(Team::First));
    }

    #[test]
    fn a_board_is_lost_if_coins_block_every_position_of_the_striker() {
        let mut game = Game::new(BoardCode::from_number(4711).unwrap().setup());
        let lines = game.base_lines();
        let along = [-0.21, -0.14, -0.07, 0.0, 0.07, 0.14];
        let at: Vec<DVec2> = along.map(|along| lines.at(along)).to_vec();
        let left = at.into_iter().map(|at| Coin {
            piece: Piece::White,
            at,
        });
        let stroke = Stroke {
            touched: true,
            pocketed: Vec::new(),
            left: left.collect(),
        };
        game.apply(&stroke).unwrap();
        let rulings = game.no_place().unwrap();
        assert!(rulings[0].text.contains("the board is lost"));
        assert_eq!(game.stage(), GameStage::MatchOver(Team::Second));
    }
}
