//! The impacts of a shot, each as an isolated collision that can be enlarged and examined.

use glam::DVec2;

use crate::physics::{Collision, Disc, EventKind, Shot};

/// A collision of two discs during a shot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ShotImpact {
    /// The time, in seconds since the start of the shot.
    pub time: f64,
    /// The two discs. Body 1 comes first: this is the disc that was shot, if it took part,
    /// otherwise the faster disc.
    pub discs: [usize; 2],
    /// The impact as an isolated collision.
    pub collision: Collision,
}

/// All impacts of a shot, in order; `set_off` is the index of the disc that was shot.
pub(crate) fn impacts(shot: &Shot, set_off: usize) -> impl Iterator<Item = ShotImpact> + '_ {
    shot.events().iter().filter_map(move |event| {
        let EventKind::Impact {
            mut discs,
            mut normal,
            mut before,
            ..
        } = event.kind
        else {
            return None;
        };
        let [first, second] = discs;
        let faster = before[1].length_squared() > before[0].length_squared();
        if first != set_off && (second == set_off || faster) {
            discs.reverse();
            before.reverse();
            normal = -normal;
        }
        let bodies = [*shot.discs().get(discs[0])?, *shot.discs().get(discs[1])?];
        Some(ShotImpact {
            time: event.time,
            discs,
            collision: collision(bodies, before, normal, shot.board().restitution),
        })
    })
}

/// The collision of two discs that touch along `normal`, from body 1 to body 2.
///
/// The impact parameter follows from the angle between the relative velocity w and the line of
/// impact n: n = cos α ŵ − sin α ŵ⊥, and b = (r₁ + r₂) sin α.
fn collision(bodies: [Disc; 2], before: [DVec2; 2], normal: DVec2, restitution: f64) -> Collision {
    let along = (before[0] - before[1]).normalize_or_zero();
    let reach = bodies[0].radius + bodies[1].radius;
    let offset = -reach * along.perp_dot(normal);
    Collision {
        u2: before[1],
        restitution,
        ..Collision::at_offset(bodies[0], bodies[1], before[0], offset)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Board, Limits, Motion, play};

    /// A disc is shot into a loose row; in some of the resulting collisions, both discs are moving.
    fn row() -> Shot {
        let disc = Disc::from_g_mm(15.0, 20.0);
        let places = [
            (-0.2, 0.012),
            (0.0, 0.0),
            (0.05, 0.011),
            (0.11, -0.004),
            (0.04, -0.05),
        ];
        let mut start = places.map(|(x, y)| Motion::at_rest(DVec2::new(x, y)));
        start[0].velocity = DVec2::new(3.0, 0.0);
        play(&Board::default(), &[disc; 5], &start, Limits::default()).unwrap()
    }

    #[test]
    fn each_isolated_impact_has_the_same_outcome_as_in_the_shot() {
        let shot = row();
        let recorded = shot.events().iter().filter_map(|event| match event.kind {
            EventKind::Impact { discs, after, .. } => Some((discs, after)),
            _ => None,
        });
        let mut both_moved = 0;
        for (impact, (discs, after)) in impacts(&shot, 0).zip(recorded) {
            let outcome = impact.collision.outcome();
            let [v1, v2] = if discs == impact.discs {
                after
            } else {
                [after[1], after[0]]
            };
            assert!(outcome.v1.distance(v1) < 1e-9, "{impact:?} {v1}");
            assert!(outcome.v2.distance(v2) < 1e-9, "{impact:?} {v2}");
            both_moved += usize::from(impact.collision.u2 != DVec2::ZERO);
        }
        assert!(both_moved > 0);
    }

    #[test]
    fn the_disc_set_in_motion_is_body_1_for_any_index() {
        let disc = Disc::from_g_mm(15.0, 20.0);
        let start = [
            Motion::at_rest(DVec2::ZERO),
            Motion {
                position: DVec2::new(0.2, 0.01),
                velocity: DVec2::new(-2.0, 0.0),
            },
        ];
        let shot = play(&Board::default(), &[disc; 2], &start, Limits::default()).unwrap();
        let first = impacts(&shot, 1).next().unwrap();
        assert_eq!(first.discs, [1, 0]);
        assert!(first.collision.u1.x < 0.0);
    }
}
