//! One disc that slides until friction stops it, in closed form.
//!
//! Friction μ reduces the speed at the constant rate a = μ g, so the path is straight and s(t) = v
//! t − ½ a t² until t = v/a.

use glam::DVec2;

use super::Motion;

/// Time in seconds until a disc of this speed (m/s) stops: v / a.
///
/// The time is 0 for a disc at rest, and infinite for a moving disc without friction.
pub(crate) fn stopping_time(speed: f64, deceleration: f64) -> f64 {
    if speed <= 0.0 {
        0.0
    } else {
        speed / deceleration
    }
}

/// Distance in metres that a disc of this speed (m/s) covers before it stops: v² / 2a.
///
/// The distance is 0 for a disc at rest, and infinite for a moving disc without friction.
pub(crate) fn stopping_distance(speed: f64, deceleration: f64) -> f64 {
    if speed <= 0.0 {
        0.0
    } else {
        speed * speed / (2.0 * deceleration)
    }
}

/// The fraction of its initial speed that a disc loses per second, a/v; 0 for a disc at rest.
#[inline]
pub(super) fn relative_deceleration(speed: f64, deceleration: f64) -> f64 {
    if speed > 0.0 {
        deceleration / speed
    } else {
        0.0
    }
}

/// The time in seconds in which a disc covers a distance that it would cover in `time` seconds at
/// its initial speed, if it loses the fraction `relative_deceleration` = a/v of that speed per
/// second; `None` if the disc stops first. This form of the root of s = v t − ½ a t² loses no
/// digits even for a short distance, and holds at a = 0.
#[inline]
pub(super) fn slowed(time: f64, relative_deceleration: f64) -> Option<f64> {
    let left = 1.0 - 2.0 * relative_deceleration * time;
    (left >= 0.0).then(|| 2.0 * time / (1.0 + left.sqrt()))
}

/// The time at which |d + w t| first falls to `distance`, if |d|² − `distance`² = `gap` > 0: the
/// smaller root of the quadratic, in the form that loses no digits. `None` if the distance never
/// falls that far.
#[inline]
pub(super) fn time_to_distance(d: DVec2, w: DVec2, distance: f64, gap: f64) -> Option<f64> {
    let ahead = -d.dot(w);
    if ahead <= 0.0 {
        return None;
    }
    // All lengths are multiplied by the speed, which saves a square root.
    let offset = d.perp_dot(w);
    let room = distance * distance * w.length_squared() - offset * offset;
    (room > 0.0).then(|| gap / (ahead + room.sqrt()))
}

/// Position and velocity after `time` seconds of constant acceleration.
#[inline(always)]
pub(super) fn parabola(start: Motion, acceleration: DVec2, time: f64) -> Motion {
    let Motion { position, velocity } = start;
    Motion::new(
        position + (velocity + acceleration * (0.5 * time)) * time,
        velocity + acceleration * time,
    )
}

/// A disc without contacts: its start and its deceleration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slide {
    start: Motion,
    acceleration: DVec2,
    stopping_time: f64,
}

impl Slide {
    /// The slide that begins with `start` under a deceleration in m/s², at least 0.
    pub(crate) fn new(start: Motion, deceleration: f64) -> Self {
        let speed = start.velocity.length();
        Self {
            start,
            acceleration: -relative_deceleration(speed, deceleration) * start.velocity,
            stopping_time: stopping_time(speed, deceleration),
        }
    }

    /// Position and velocity `time` seconds after the start: a parabola in time
    /// until the disc stops, rest from then on. Times before 0 count as 0.
    pub(crate) fn at(&self, time: f64) -> Motion {
        let Motion { position, velocity } = self.start;
        if self.stopping_time == 0.0 || time <= 0.0 {
            self.start
        } else if time >= self.stopping_time {
            Motion::at_rest(position + velocity * (0.5 * self.stopping_time))
        } else {
            parabola(self.start, self.acceleration, time)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: f64 = 0.12 * crate::physics::G;

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-13 * (1.0 + a.abs()), "{a} and {b}");
    }

    #[test]
    fn the_closed_forms_agree() {
        for v in [1e-3, 0.5, 2.5, 4.0] {
            close(stopping_distance(v, A), 0.5 * v * stopping_time(v, A));
            for part in [0.0, 1e-9, 0.3, 0.75, 0.999_999] {
                let s = part * stopping_distance(v, A);
                let t = slowed(s / v, A / v).expect("the disc gets there");
                close(v * t - 0.5 * A * t * t, s);
                close((v * v - 2.0 * A * s).sqrt(), v - A * t);
            }
            let beyond = stopping_distance(v, A) * 1.000_001;
            assert_eq!(slowed(beyond / v, A / v), None);
        }
    }

    #[test]
    fn a_slide_is_a_straight_parabola_and_then_rest() {
        let start = Motion {
            position: DVec2::new(0.1, -0.2),
            velocity: DVec2::new(3.0, -4.0),
        };
        let slide = Slide::new(start, A);
        close(slide.stopping_time, 5.0 / A);
        let along = DVec2::new(0.6, -0.8);
        for t in [0.0, 0.1, 1.0, 4.0] {
            let s = 5.0 * t - 0.5 * A * t * t;
            assert!(slide.at(t).position.distance(start.position + along * s) < 1e-12);
            assert!(slide.at(t).velocity.distance(along * (5.0 - A * t)) < 1e-12);
        }
        let end = slide.at(100.0);
        assert_eq!(end.velocity, DVec2::ZERO);
        let way = along * stopping_distance(5.0, A);
        assert!(end.position.distance(start.position + way) < 1e-12);
    }

    #[test]
    fn without_friction_nothing_stops() {
        let slide = Slide::new(
            Motion {
                position: DVec2::ZERO,
                velocity: DVec2::X,
            },
            0.0,
        );
        assert!(slide.stopping_time.is_infinite());
        assert_eq!(slide.at(1e6).position, DVec2::new(1e6, 0.0));
        assert_eq!(slowed(2.0, 0.0), Some(2.0));
    }
}
