//! Where a coin is put back.
//!
//! The coin goes to the free position nearest to the required point. The free positions are bounded
//! by circles around the other coins and around the centre of the board, so this position is found
//! exactly: it is the required point itself, the point of a circle nearest to it, or an
//! intersection of two circles.

use glam::DVec2;

use super::pieces::{CENTRE_CIRCLE_RADIUS, Coin, GAP, OUTER_CIRCLE_RADIUS, PieceSet};
use super::seat::Seat;

/// The tolerance for rounding when a position is checked, in metres: far less than the gap between
/// coins.
const SLACK: f64 = 1e-9;

/// A circle that a coin's centre may touch but not cross.
struct Circle {
    centre: DVec2,
    radius: f64,
}

/// The position of a coin that the player at `seat` gives back: inside the outer circle, off the
/// centre circle (62b), as near as possible to the point of the outer circle that is farthest from
/// that player, where an opponent would put it.
///
/// If the outer circle is full, the coin goes to the nearest free position instead of waiting for
/// room (52a).
pub(crate) fn for_a_due(set: PieceSet, coins: &[Coin], seat: Seat) -> DVec2 {
    let radius = set.coin_radius();
    let rim = OUTER_CIRCLE_RADIUS - radius;
    let wanted = seat.turn(DVec2::new(0.0, rim));
    let hole = CENTRE_CIRCLE_RADIUS + radius;
    nearest(set, coins, wanted, hole, rim)
        .or_else(|| nearest(set, coins, wanted, hole, f64::INFINITY))
        .unwrap_or(wanted)
}

/// The position of the queen when she is put back: the centre (66), or the free position nearest to
/// it (67).
pub(crate) fn for_the_queen(set: PieceSet, coins: &[Coin]) -> DVec2 {
    nearest(set, coins, DVec2::ZERO, 0.0, f64::INFINITY).unwrap_or(DVec2::ZERO)
}

/// Of the free positions at a distance between `hole` and `rim` from the centre of the board, the
/// one nearest to `wanted`; `None` if there are none.
fn nearest(set: PieceSet, coins: &[Coin], wanted: DVec2, hole: f64, rim: f64) -> Option<DVec2> {
    let spacing = 2.0 * set.coin_radius() + GAP;
    let circle = |centre, radius| Circle { centre, radius };
    let around_coins = coins.iter().map(|coin| circle(coin.at, spacing));
    let bounds = [hole, rim].into_iter();
    let bounds = bounds.filter(|radius| *radius > 0.0 && radius.is_finite());
    let bounds = bounds.map(|radius| circle(DVec2::ZERO, radius));
    let circles: Vec<Circle> = around_coins.chain(bounds).collect();

    let free = |at: &DVec2| {
        (hole - SLACK..=rim + SLACK).contains(&at.length())
            && coins
                .iter()
                .all(|coin| coin.at.distance(*at) >= spacing - SLACK)
    };
    let mut places = vec![wanted];
    for (i, circle) in circles.iter().enumerate() {
        places.push(closest_on(circle, wanted));
        for other in circles.iter().skip(i + 1) {
            places.extend(crossings(circle, other).into_iter().flatten());
        }
    }
    places.into_iter().filter(free).min_by(|a, b| {
        a.distance_squared(wanted)
            .total_cmp(&b.distance_squared(wanted))
    })
}

/// The point of a circle that is nearest to `to`; if all points are equally near, the one straight
/// above the centre.
fn closest_on(circle: &Circle, to: DVec2) -> DVec2 {
    let way = (to - circle.centre).try_normalize().unwrap_or(DVec2::Y);
    circle.centre + way * circle.radius
}

/// The two points at which two circles intersect, if they do.
fn crossings(a: &Circle, b: &Circle) -> Option<[DVec2; 2]> {
    let between = b.centre - a.centre;
    let distance_squared = between.length_squared();
    if distance_squared <= 0.0 {
        return None;
    }
    // The fraction of the line of centres at which the common chord crosses it.
    let share = 0.5 * (1.0 + (a.radius * a.radius - b.radius * b.radius) / distance_squared);
    let half_chord_squared = a.radius * a.radius / distance_squared - share * share;
    if half_chord_squared < 0.0 {
        return None;
    }
    let foot = a.centre + between * share;
    let half_chord = between.perp() * half_chord_squared.sqrt();
    Some([foot + half_chord, foot - half_chord])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::pack::pack;
    use super::super::pieces::Piece;
    use super::*;

    const SET: PieceSet = PieceSet::Tournament;

    fn coin(x_mm: f64, y_mm: f64) -> Coin {
        Coin {
            piece: Piece::White,
            at: DVec2::new(x_mm, y_mm) / 1000.0,
        }
    }

    fn least_distance(coins: &[Coin], at: DVec2) -> f64 {
        coins
            .iter()
            .map(|coin| coin.at.distance(at))
            .fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn law_66_the_queen_goes_to_the_centre_when_it_is_free() {
        assert_eq!(for_the_queen(SET, &[]), DVec2::ZERO);
        assert_eq!(for_the_queen(SET, &[coin(32.0, 0.0)]), DVec2::ZERO);
    }

    #[test]
    fn law_67_the_queen_goes_as_near_the_centre_as_the_coins_allow() {
        let coins = [coin(10.0, 0.0)];
        let at = for_the_queen(SET, &coins);
        let spacing = 2.0 * SET.coin_radius() + GAP;
        assert!(at.distance(DVec2::new(0.010 - spacing, 0.0)) < 1e-12);

        let pair = [coin(10.0, 0.0), coin(-25.0, 0.0)];
        let at = for_the_queen(SET, &pair);
        for coin in &pair {
            assert!((coin.at.distance(at) - spacing).abs() < 1e-12);
        }
    }

    #[test]
    fn a_due_is_placed_at_the_far_edge_of_the_outer_circle() {
        let rim = OUTER_CIRCLE_RADIUS - SET.coin_radius();
        assert_eq!(for_a_due(SET, &[], Seat::South), DVec2::new(0.0, rim));
        assert_eq!(for_a_due(SET, &[], Seat::East), DVec2::new(-rim, 0.0));
    }

    #[test]
    fn law_52a_a_full_outer_circle_sends_the_coin_to_the_nearest_place_outside() {
        let coins = pack(SET, Seat::South);
        let at = for_a_due(SET, &coins, Seat::South);
        let spacing = 2.0 * SET.coin_radius() + GAP;
        assert!((least_distance(&coins, at) - spacing).abs() < 2.0 * SLACK);
        assert!(at.length() < OUTER_CIRCLE_RADIUS + 2.0 * SET.coin_radius());
    }

    proptest! {
        #[test]
        fn a_place_is_free_and_none_on_a_fine_grid_is_nearer(
            spots in prop::collection::vec((-110.0..110.0_f64, -110.0..110.0_f64), 0..18)
        ) {
            let coins: Vec<Coin> = spots.iter().map(|(x, y)| coin(*x, *y)).collect();
            let spacing = 2.0 * SET.coin_radius() + GAP;
            let at = for_the_queen(SET, &coins);
            prop_assert!(least_distance(&coins, at) >= spacing - SLACK);
            let reach = (at.length() - 1e-6).max(0.0);
            // Points in a sunflower pattern, which covers the whole area that is nearer to the
            // required point than `at` is.
            for step in 1..2000_i32 {
                let turn = f64::from(step) * 2.399_963;
                let out = reach * (f64::from(step) / 2000.0).sqrt();
                let grid = DVec2::from_angle(turn) * out;
                prop_assert!(reach == 0.0 || least_distance(&coins, grid) < spacing);
            }

            let due = for_a_due(SET, &coins, Seat::West);
            prop_assert!(least_distance(&coins, due) >= spacing - SLACK);
            prop_assert!(due.length() >= CENTRE_CIRCLE_RADIUS + SET.coin_radius() - SLACK);
        }
    }
}
