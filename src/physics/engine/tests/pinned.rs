//! Checks that a shot is the same to the last bit on every machine and in every build.

use super::tables::{closed_board, rack};
use crate::physics::{Board, EventKind, Shot};

/// The FNV-1a hash of the event times, impacts and final positions of a shot, with all their bits.
fn fingerprint(shot: &Shot) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut add = |value: f64| {
        for byte in value.to_bits().to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    };
    for event in shot.events() {
        add(event.time);
        if let EventKind::Impact { normal, after, .. } = event.kind {
            for v in [normal, after[0], after[1]] {
                add(v.x);
                add(v.y);
            }
        }
    }
    for end in shot.final_states() {
        add(end.position.x);
        add(end.position.y);
    }
    hash
}

/// Pinning a number is the right kind of test only here: a break is chaotic, so a different number
/// results if a compiler or a processor rounds a single bit differently. If the arithmetic is
/// deliberately changed, the number must be pinned again.
#[test]
fn whole_breaks_are_the_same_to_the_last_bit() {
    let inelastic = Board {
        restitution: 0.9,
        ..Board::default()
    };
    let breaks = [
        (closed_board(), (0.3, 4.0)),
        (Board::default(), (-0.45, 3.5)),
        (inelastic, (0.05, 5.0)),
    ];
    let found = breaks.map(|(board, velocity)| fingerprint(&rack(1e-4, velocity).play(&board)));
    let found = found.map(|hash| format!("{hash:016x}"));
    let pinned = ["d6392f77d8b8918d", "bbbe708c7b0ec288", "19cad25b74a9bf48"];
    assert_eq!(found, pinned);
}
