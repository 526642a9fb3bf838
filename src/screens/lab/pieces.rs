//! The sets of pieces of the lab.

use crate::physics::{CollisionSpec, ImpactPoint};

/// The sets that a key cycles through: mass and radius of the striker and of the target, in g and
/// mm.
const PIECE_SETS: [(&str, [(f64, f64); 2]); 3] = [
    ("equal masses", [(15.0, 15.0), (15.0, 15.0)]),
    ("tournament set", [(15.0, 20.65), (5.5, 15.9)]),
    ("marbles", [(20.0, 12.4), (40.0, 15.6)]),
];

/// The index of the set with these pieces, if there is one.
fn piece_set(setup: &CollisionSpec) -> Option<usize> {
    let pieces = [(setup.m1_g, setup.r1_mm), (setup.m2_g, setup.r2_mm)];
    PIECE_SETS.iter().position(|(_, set)| *set == pieces)
}

/// The name of these pieces.
pub(super) fn pieces_name(setup: &CollisionSpec) -> &'static str {
    piece_set(setup).map_or("custom pieces", |at| PIECE_SETS[at].0)
}

/// Changes to the next set of pieces, and keeps the ratio b/(r₁+r₂).
pub(super) fn put_out_next(setup: &mut CollisionSpec) {
    let ratio = setup.offset_mm() / setup.contact_distance_mm();
    let next = piece_set(setup).map_or(0, |at| (at + 1) % PIECE_SETS.len());
    let [striker, target] = PIECE_SETS[next].1;
    (setup.m1_g, setup.r1_mm) = striker;
    (setup.m2_g, setup.r2_mm) = target;
    let offset_mm = ratio * setup.contact_distance_mm();
    setup.point = ImpactPoint::Offset { offset_mm };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changing_pieces_keeps_the_geometry_of_the_collision() {
        let mut setup = CollisionSpec::default();
        let alpha = setup.collision().alpha();
        for expected in [1, 2, 0] {
            put_out_next(&mut setup);
            assert_eq!(piece_set(&setup), Some(expected));
            let now = setup.collision().alpha();
            assert!((now.unwrap() - alpha.unwrap()).abs() < 1e-12);
        }
    }
}
