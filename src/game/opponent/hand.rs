//! How unsteady a player's hand is: random errors in direction and speed.

use glam::DVec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use crate::numbers::fixed;
use crate::physics::Motion;

/// The fastest stroke the opponent plays, in m/s: a hard break.
pub const FASTEST: f64 = 4.0;

/// How unsteady a hand is: the standard deviations of its normally distributed errors.
///
/// The striker is placed without error, because a player can check its position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hand {
    /// Error in direction, as the tangent of the angle (practically equal to the angle in radians).
    pub direction: f64,
    /// Error in speed, as a fraction of the speed.
    pub speed: f64,
}

/// The error of one stroke.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Slip {
    /// Tangent of the error in direction, positive to the left.
    pub turn: f64,
    /// Change in the speed, as a fraction of the speed.
    pub push: f64,
}

impl Hand {
    pub(super) const fn new(direction: f64, speed: f64) -> Self {
        Self { direction, speed }
    }

    /// The error that follows from the seed of a stroke. The search uses a different generator, so
    /// no hint and no plan can know the error in advance.
    pub fn slip_of(self, seed: u64) -> Slip {
        self.slip(&mut Pcg64::seed_from_u64(!seed))
    }

    /// The errors in figures: the direction in degrees, and the speed in per cent.
    pub(crate) fn in_figures(self) -> [String; 2] {
        let degrees = self.direction.atan().to_degrees();
        [fixed(degrees, 1), fixed(100.0 * self.speed, 0)]
    }

    /// A random error of this hand.
    pub(super) fn slip(self, chance: &mut Pcg64) -> Slip {
        Slip {
            turn: self.direction * normal(chance),
            push: self.speed * normal(chance),
        }
    }
}

impl Slip {
    /// The stroke that results from `meant`. The speed is at least a fifth of the intended speed,
    /// and at most [`FASTEST`] or the intended speed, whichever is greater.
    pub fn applied_to(self, meant: Motion) -> Motion {
        let speed = meant.velocity.length();
        let pushed = (speed * (1.0 + self.push).max(0.2)).min(FASTEST.max(speed));
        let turned = meant.velocity + meant.velocity.perp() * self.turn;
        Motion {
            velocity: turned.try_normalize().unwrap_or(DVec2::ZERO) * pushed,
            ..meant
        }
    }

    /// The intended direction, as a unit vector, if the error led to the velocity `struck`.
    pub(crate) fn meant_direction(self, struck: DVec2) -> DVec2 {
        (struck - struck.perp() * self.turn).normalize_or_zero()
    }
}

/// A number with approximately the standard normal distribution: the sum of twelve uniform numbers,
/// minus 6 (Irwin and Hall). It is within ±6 and requires no logarithm, which different machines
/// round differently.
fn normal(chance: &mut Pcg64) -> f64 {
    (0..12).map(|_| chance.random::<f64>()).sum::<f64>() - 6.0
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;

    use super::*;
    use crate::game::opponent::PlayerHand;

    #[test]
    fn slips_have_the_mean_and_spread_of_the_hand() {
        let hand = Hand {
            direction: 0.02,
            speed: 0.1,
        };
        let mut chance = Pcg64::seed_from_u64(5);
        let count = 20_000;
        let slips: Vec<Slip> = (0..count).map(|_| hand.slip(&mut chance)).collect();
        let of = |part: fn(&Slip) -> f64| {
            let mean = slips.iter().map(part).sum::<f64>() / f64::from(count);
            let square = slips.iter().map(|s| part(s) * part(s)).sum::<f64>() / f64::from(count);
            (mean, (square - mean * mean).sqrt())
        };
        // The limits are four standard errors: for the mean, 4/√n standard deviations; for the
        // spread, 4/√(2n).
        for ((mean, spread), wanted) in [(of(|s| s.turn), 0.02), (of(|s| s.push), 0.1)] {
            assert!(mean.abs() < 0.029 * wanted, "{mean}");
            assert!((spread / wanted - 1.0).abs() < 0.02, "{spread}");
        }
    }

    #[test]
    fn a_slip_turns_by_its_angle_and_changes_nothing_else() {
        let meant = Motion {
            position: DVec2::new(0.1, -0.2),
            velocity: DVec2::new(0.0, 2.0),
        };
        let slip = Slip {
            turn: 0.75,
            push: 0.1,
        };
        let struck = slip.applied_to(meant);
        assert_eq!(struck.position, meant.position);
        // tan φ = 3/4 gives a triangle with sides 3, 4 and 5.
        assert!((struck.velocity - DVec2::new(-0.6, 0.8) * 2.2).length() < 1e-15);
        assert_eq!(Slip::default().applied_to(meant), meant);
        let back = slip.meant_direction(struck.velocity);
        assert!((back - DVec2::Y).length() < 1e-15);
    }

    #[test]
    fn a_players_hand_makes_the_same_error_for_the_same_seed() {
        assert_eq!(PlayerHand::default().errors(), None);
        let [steady, club] = [PlayerHand::Steady, PlayerHand::Club].map(|it| it.errors().unwrap());
        assert!(steady.direction < club.direction && steady.speed < club.speed);
        assert_eq!(club.slip_of(7), club.slip_of(7));
        assert_ne!(club.slip_of(7), club.slip_of(8));
        // Pinned to the last bit: saved games and every machine must agree.
        let slip = club.slip_of(7);
        assert_eq!(
            [slip.turn, slip.push].map(f64::to_bits),
            [13_804_998_022_507_484_612, 4_591_262_019_179_417_620]
        );
    }
}
