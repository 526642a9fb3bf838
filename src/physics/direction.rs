//! The unit vector at an angle, bit for bit the same on every machine.
//!
//! Math libraries round sines differently, and after many collisions on a board a difference in the
//! last bit gives a different result. So sines are computed here from their series to twice the
//! precision and then rounded once.

use glam::DVec2;

/// A number stored as the sum of two; the second is below the last bit of the first.
#[derive(Clone, Copy)]
struct Twofold(f64, f64);

/// π/2 to twice the precision.
const QUARTER: Twofold = Twofold(std::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17);
/// The number of terms of a series after the first. For angles up to an eighth of a turn, the next
/// term is below the last digit.
const TERMS: u32 = 14;

impl Twofold {
    fn plus(self, other: Self) -> Self {
        let sum = self.0 + other.0;
        let own = sum - other.0;
        let lost = (self.0 - own) + (other.0 - (sum - own));
        Self(sum, 0.0).with(lost + self.1 + other.1)
    }

    fn times(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let lost = self.0.mul_add(other.0, -product);
        Self(product, 0.0).with(lost + self.0 * other.1 + self.1 * other.0)
    }

    fn over(self, number: f64) -> Self {
        let quotient = self.0 / number;
        let left = quotient.mul_add(-number, self.0) + self.1;
        Self(quotient, 0.0).with(left / number)
    }

    /// The sum of this number and a much smaller one.
    fn with(self, small: f64) -> Self {
        let sum = self.0 + small;
        Self(sum, small - (sum - self.0))
    }

    /// `first` − `first` x²/((n+1)(n+2)) + …: the series of a cosine or a sine of x.
    fn series(self, first: Self, n: u32) -> f64 {
        let square = self.times(self);
        let (mut term, mut sum) = (first, first);
        for k in 0..TERMS {
            let n = f64::from(n + 2 * k);
            term = term.times(square).over(-(n + 1.0) * (n + 2.0));
            sum = sum.plus(term);
        }
        sum.0 + sum.1
    }
}

/// The unit vector at an angle in radians from +x, anticlockwise. The angle must be no more than a
/// few turns.
pub(crate) fn direction(angle: f64) -> DVec2 {
    let quarters = (angle / QUARTER.0).round();
    let turned = QUARTER.times(Twofold(-quarters, 0.0));
    let within = Twofold(angle, 0.0).plus(turned);
    let cosine = within.series(Twofold(1.0, 0.0), 0);
    let sine = within.series(within, 1);
    let vector = DVec2::new(cosine, sine);
    match quarters.rem_euclid(4.0) as u8 {
        0 => vector,
        1 => vector.perp(),
        2 => -vector,
        _ => -vector.perp(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_vectors_agree_with_the_library_except_for_the_last_bit() {
        for step in -20_000..20_000 {
            let angle = f64::from(step) * 7.313e-4;
            let (sine, cosine) = angle.sin_cos();
            let found = direction(angle);
            assert!((found.x - cosine).abs() <= 2e-16, "{angle}");
            assert!((found.y - sine).abs() <= 2e-16, "{angle}");
        }
    }

    /// Known digits: sines and cosines to thirty places, rounded once.
    #[test]
    fn sines_and_cosines_are_rounded_once() {
        assert_eq!(direction(0.0), DVec2::X);
        assert_eq!(direction(0.5).y, 0.479_425_538_604_203);
        assert_eq!(direction(0.5).x, 0.877_582_561_890_372_8);
        assert_eq!(direction(1.0).y, 0.841_470_984_807_896_5);
        assert_eq!(direction(1.0).x, 0.540_302_305_868_139_8);
        assert_eq!(direction(3.0).y, 0.141_120_008_059_867_2);
        assert_eq!(direction(-2.0).x, -0.416_146_836_547_142_4);
    }
}
