//! The impacts of a shot, each as a collision of two discs that the lab could show.

use glam::DVec2;

use crate::physics::{Collision, Disc, EventKind, Shot};

/// Two discs that met during a shot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Impact {
    /// When, in seconds since the start of the shot.
    pub(super) time: f64,
    /// Which, body 1 first: the striker if it took part, else the faster.
    pub(super) discs: [usize; 2],
    /// The same hit by itself.
    pub(super) collision: Collision,
}

/// All impacts of a shot, in order.
pub(super) fn impacts(shot: &Shot) -> impl Iterator<Item = Impact> + '_ {
    shot.events().iter().filter_map(|event| match event.kind {
        EventKind::Impact {
            discs,
            normal,
            before,
            ..
        } => {
            let [first, second] = discs;
            let turned = first != 0
                && (second == 0 || before[1].length_squared() > before[0].length_squared());
            let (discs, before, normal) = if turned {
                ([second, first], [before[1], before[0]], -normal)
            } else {
                (discs, before, normal)
            };
            let bodies = [*shot.discs().get(discs[0])?, *shot.discs().get(discs[1])?];
            Some(Impact {
                time: event.time,
                discs,
                collision: collision(bodies, before, normal, shot.board().restitution),
            })
        }
        _ => None,
    })
}

/// The collision of two discs that touch along `normal`, from body 1 to body 2.
///
/// The impact parameter follows from the angle between the relative velocity w and
/// the line of impact n: n = cos α ŵ − sin α ŵ⊥, and b = (r₁ + r₂) sin α.
fn collision(bodies: [Disc; 2], before: [DVec2; 2], normal: DVec2, restitution: f64) -> Collision {
    let along = (before[0] - before[1]).normalize_or_zero();
    let reach = bodies[0].radius + bodies[1].radius;
    Collision {
        u2: before[1],
        restitution,
        ..Collision::at_offset(
            bodies[0],
            bodies[1],
            before[0],
            -reach * along.perp_dot(normal),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{Game, Setup, Strike};

    /// Every impact of a break, taken by itself, gives what the engine gave.
    #[test]
    fn each_impact_by_itself_ends_as_it_did_in_the_shot() {
        let game = Game::new(Setup {
            seed: Some(5),
            ..Setup::default()
        });
        let shot = Strike {
            place: DVec2::new(0.01, -0.2526),
            velocity: DVec2::new(0.05, 4.0),
            call: None,
        }
        .shot(&game)
        .unwrap();
        let mut both_moved = 0;
        for impact in impacts(&shot) {
            let outcome = impact.collision.outcome();
            let after = shot.events().iter().find_map(|event| match event.kind {
                EventKind::Impact { discs, after, .. }
                    if event.time == impact.time
                        && discs.contains(&impact.discs[0])
                        && discs.contains(&impact.discs[1]) =>
                {
                    Some(if discs == impact.discs {
                        after
                    } else {
                        [after[1], after[0]]
                    })
                }
                _ => None,
            });
            let [v1, v2] = after.unwrap();
            assert!(outcome.v1.distance(v1) < 1e-9, "{impact:?} {v1}");
            assert!(outcome.v2.distance(v2) < 1e-9, "{impact:?} {v2}");
            both_moved += usize::from(impact.collision.u2 != DVec2::ZERO);
        }
        assert!(both_moved > 5);
    }
}
