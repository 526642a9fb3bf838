//! Random play.

use carrom::game::{Call, Game, Move, Rules, Strike};
use glam::DVec2;
use rand::RngExt;
use rand_pcg::Pcg64;

/// Makes a random legal move, usually a stroke, and returns it.
pub(crate) fn random_move(game: &mut Game, chance: &mut Pcg64) -> Move {
    loop {
        let lines = game.base_lines();
        let wanted = lines.at(chance.random_range(-0.2..0.2));
        let made = match lines.nearest(wanted) {
            _ if game.play().won.is_some() => Move::NextBoard,
            _ if game.setup().rules == Rules::Practice && chance.random_bool(0.1) => {
                Move::LayOut(game.coins().to_vec())
            }
            None => Move::NoPlace,
            Some(place) => {
                let way = DVec2::from_angle(chance.random_range(0.0..3.1));
                Move::Strike(Strike {
                    place,
                    velocity: game.seat().turn(way) * chance.random_range(0.5..5.0),
                    call: chance.random_bool(0.3).then_some(Call {
                        striker_deg: None,
                        coin_deg: Some(12.3),
                    }),
                })
            }
        };
        if made.make(game).is_ok() {
            return made;
        }
    }
}
