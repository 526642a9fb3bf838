//! The opening pack (14): nineteen pieces in a hexagon around the centre.
//!
//! The queen is in the centre, with six coins of alternating colour around her and twelve around
//! those. The second ring has six corners, straight behind the coins of the first, and six
//! positions between the corners. Three white corners make a Y with the whites of the first ring;
//! alternating the rest makes every corner white and every position between corners black: 3 + 6 =
//! 9 white and 3 + 6 = 9 black.

use std::iter::zip;

use glam::DVec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::pieces::{Coin, GAP, Piece, PieceSet};
use super::seat::Seat;

/// The pack with the stem of the Y towards the player at `breaker`, mirror-symmetric about that
/// player's line of sight, with [`GAP`] between neighbours.
///
/// The queen comes first, then the first ring, then the second.
pub(crate) fn pack(set: PieceSet, breaker: Seat) -> Vec<Coin> {
    let spacing = 2.0 * set.coin_radius() + GAP;
    let place = |piece, at: DVec2| Coin {
        piece,
        at: breaker.turn(at * spacing),
    };
    let half_root = 3.0_f64.sqrt() / 2.0;
    // Unit vectors to the corners, every 60° from 30°, so that one points
    // straight at the breaker.
    let corners = [
        DVec2::new(half_root, 0.5),
        DVec2::new(0.0, 1.0),
        DVec2::new(-half_root, 0.5),
        DVec2::new(-half_root, -0.5),
        DVec2::new(0.0, -1.0),
        DVec2::new(half_root, -0.5),
    ];
    let colours = [Piece::White, Piece::Black].into_iter().cycle();
    let neighbours = corners.into_iter().cycle().skip(1);

    let mut coins = vec![place(Piece::Queen, DVec2::ZERO)];
    coins.extend(zip(corners, colours).map(|(corner, piece)| place(piece, corner)));
    for (corner, next) in zip(corners, neighbours) {
        coins.push(place(Piece::White, 2.0 * corner));
        coins.push(place(Piece::Black, corner + next));
    }
    coins
}

/// The pack with every piece shifted by less than half a gap, so that breaks differ. The same seed
/// gives the same pack.
///
/// Neighbours may come closer, but never touch.
pub(crate) fn jittered_pack(set: PieceSet, breaker: Seat, seed: u64) -> Vec<Coin> {
    // Two neighbours shifted along both axes approach by at most 2√2 × 0.3 gaps.
    const SHIFT: f64 = 0.3 * GAP;
    let mut hand = Pcg64::seed_from_u64(seed);
    let mut coins = pack(set, breaker);
    for coin in &mut coins {
        coin.at.x += hand.random_range(-SHIFT..SHIFT);
        coin.at.y += hand.random_range(-SHIFT..SHIFT);
    }
    coins
}

#[cfg(test)]
mod tests {
    use super::super::pieces::{OUTER_CIRCLE_RADIUS, count};
    use super::*;

    fn closest(coins: &[Coin]) -> f64 {
        let mut least = f64::INFINITY;
        for (i, a) in coins.iter().enumerate() {
            for b in &coins[i + 1..] {
                least = least.min(a.at.distance(b.at));
            }
        }
        least
    }

    #[test]
    fn law_14_nine_white_coins_nine_black_coins_and_the_queen_lie_within_the_outer_circle() {
        let coins = pack(PieceSet::Tournament, Seat::South);
        assert_eq!(count(&coins, Piece::White), 9);
        assert_eq!(count(&coins, Piece::Black), 9);
        assert_eq!(count(&coins, Piece::Queen), 1);
        assert_eq!(coins[0].piece, Piece::Queen);
        assert_eq!(coins[0].at, DVec2::ZERO);
        let radius = PieceSet::Tournament.coin_radius();
        assert!(
            coins
                .iter()
                .all(|c| c.at.length() + radius < OUTER_CIRCLE_RADIUS)
        );
        let spacing = 2.0 * radius + GAP;
        assert!((closest(&coins) - spacing).abs() < 1e-15);
    }

    #[test]
    fn law_14_colours_alternate_in_both_rings_and_three_whites_make_a_y() {
        let coins = pack(PieceSet::Tournament, Seat::South);
        let (first, second) = (&coins[1..7], &coins[7..19]);
        for row in [first, second] {
            for pair in row.windows(2) {
                assert_ne!(pair[0].piece, pair[1].piece);
            }
        }
        let whites = first.iter().filter(|c| c.piece == Piece::White);
        let mut stems = 0;
        for white in whites {
            let behind = second
                .iter()
                .find(|c| c.at.distance(2.0 * white.at) < 1e-12)
                .unwrap();
            assert_eq!(behind.piece, Piece::White);
            stems += usize::from(behind.at.x == 0.0 && behind.at.y < 0.0);
        }
        assert_eq!(stems, 1, "the stem of the Y points at the breaker");
    }

    #[test]
    fn the_pack_is_its_own_mirror_image_to_the_last_bit() {
        let coins = pack(PieceSet::Tournament, Seat::South);
        for coin in &coins {
            let mirrored = DVec2::new(-coin.at.x, coin.at.y);
            assert!(
                coins
                    .iter()
                    .any(|c| c.piece == coin.piece && c.at == mirrored)
            );
        }
    }

    #[test]
    fn the_pack_is_turned_towards_the_breaker() {
        let south = pack(PieceSet::Tournament, Seat::South);
        for (a, b) in south.iter().zip(pack(PieceSet::Tournament, Seat::West)) {
            assert_eq!(Seat::West.turn(a.at), b.at);
        }
    }

    #[test]
    fn a_jittered_pack_never_touches_and_repeats_with_its_seed() {
        for seed in 0..50 {
            let coins = jittered_pack(PieceSet::Tournament, Seat::South, seed);
            assert!(closest(&coins) > 2.0 * PieceSet::Tournament.coin_radius());
            assert_eq!(
                coins,
                jittered_pack(PieceSet::Tournament, Seat::South, seed)
            );
        }
        assert_ne!(
            jittered_pack(PieceSet::Tournament, Seat::South, 1),
            jittered_pack(PieceSet::Tournament, Seat::South, 2)
        );
    }
}
