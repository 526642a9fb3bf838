//! The directions in which a player can pocket a coin, for aiming with one key.

use glam::DVec2;

use super::shots::{ghost, straight, strike};
use super::sight::{Sight, Way};
use super::wants::wants;
use crate::game::Game;

/// The directions in which a striker at `from` sends a coin straight into a pocket. There is at
/// most one direction for each coin that the current player wants to pocket; the coin goes to the
/// nearest pocket for which both discs have a clear path.
///
/// If there is no such direction, returns the directions of full hits on the wanted coins.
pub fn open_shots(game: &Game, from: DVec2) -> Vec<DVec2> {
    let sight = Sight::of(game);
    let coins = game.coins().iter().enumerate();
    let wanted: Vec<_> = coins.filter(|(_, coin)| wants(game, coin.piece)).collect();
    let pocketed = wanted.iter().filter_map(|&(i, _)| {
        let open = straight(&sight, i).filter_map(|course| {
            let stroke = strike(&sight, &course, from, ghost(&sight, &course)?)?;
            Some((course.allowance, stroke.if_clear(&sight)?.toward))
        });
        // The nearer the pocket, the larger the tolerance of the coin's direction.
        let nearest = open.max_by(|(a, _), (b, _)| a.total_cmp(b));
        nearest.map(|(_, toward)| toward)
    });
    let pocketed: Vec<DVec2> = pocketed.collect();
    if !pocketed.is_empty() {
        return pocketed;
    }
    let full = wanted.iter().filter_map(|&(i, coin)| {
        let toward = (coin.at - from).try_normalize()?;
        let contact = coin.at - toward * (sight.striker() + sight.coin());
        let way = Way::straight(from, contact)?;
        way.is_clear(&sight, sight.striker(), [None, Some(i)])
            .then_some(way.toward)
    });
    full.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{Coin, GameSetup, Piece, Strike, Stroke};

    fn coin(piece: Piece, x: f64, y: f64) -> Coin {
        Coin {
            piece,
            at: DVec2::new(x, y),
        }
    }

    fn game(coins: &[Coin]) -> Game {
        let mut game = Game::new(GameSetup::default());
        game.play.coins = coins.to_vec();
        game
    }

    #[test]
    fn each_direction_pockets_a_coin_of_the_player() {
        let coins = [
            coin(Piece::White, 0.15, 0.1),
            coin(Piece::White, -0.2, 0.05),
            coin(Piece::Black, 0.0, 0.1),
            coin(Piece::Queen, 0.05, 0.2),
        ];
        let game = game(&coins);
        let place = game.base_lines().at(0.0);
        let open = open_shots(&game, place);
        assert_eq!(open.len(), 2, "neither the black coin nor the queen (65)");
        for way in open {
            let strike = Strike {
                place,
                velocity: 3.0 * way,
                call: None,
            };
            let shot = strike.shot(&game).unwrap();
            let stroke = Stroke::from_shot(game.coins(), &shot).unwrap();
            assert_eq!(stroke.pocketed.first(), Some(&Piece::White));
        }
    }

    #[test]
    fn without_an_open_pocket_the_hits_are_full() {
        // The black coins block every path from the white coin to a pocket.
        let mut coins = vec![coin(Piece::White, 0.0, 0.0)];
        let corners = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
        coins.extend(corners.map(|(x, y)| coin(Piece::Black, 0.1 * x, 0.1 * y)));
        let game = game(&coins);
        let place = game.base_lines().at(0.0);
        assert_eq!(open_shots(&game, place), [DVec2::Y]);
        // At the break, too, the coins in front can be hit.
        let game = Game::new(GameSetup::default());
        assert!(!open_shots(&game, place).is_empty());
    }
}
