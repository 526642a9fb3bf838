//! The first root of a quartic in an interval.

/// The maximum number of times that the interval is halved; what is then left, 2⁻⁵⁰ of the
/// interval, counts as a graze without contact.
const DEPTH: u32 = 50;

/// The first t in [0, `end`] at which c₀ + c₁t + c₂t² + c₃t³ + c₄t⁴ falls to zero, for c₀ > 0
/// and a finite `end`.
///
/// In Bernstein form on an interval, the polynomial lies within the hull of its coefficients. If
/// all coefficients are positive, there is no root in the interval; if they change sign once, there
/// is exactly one root (J. M. Lane and R. F. Riesenfeld, "Bounds on a polynomial", BIT 21 (1981)
/// 112). Otherwise the interval is halved and the left half is searched first, so the first root is
/// found. A double root (a graze) does not count as a root.
#[inline]
pub(super) fn first_root(c: [f64; 5], end: f64) -> Option<f64> {
    // These are the coefficients after rescaling the interval to length 1.
    let e2 = end * end;
    let c = [c[0], c[1] * end, c[2] * e2, c[3] * e2 * end, c[4] * e2 * e2];
    let b = [
        c[0],
        c[0] + c[1] * 0.25,
        c[0] + c[1] * 0.5 + c[2] * (1.0 / 6.0),
        c[0] + c[1] * 0.75 + c[2] * 0.5 + c[3] * 0.25,
        c[0] + c[1] + c[2] + c[3] + c[4],
    ];
    search(&c, b, 0.0, 1.0, DEPTH).map(|x| x * end)
}

fn search(c: &[f64; 5], b: [f64; 5], low: f64, high: f64, depth: u32) -> Option<f64> {
    let [b0, b1, b2, b3, b4] = b;
    let (p0, p1, p2, p3, p4) = (b0 > 0.0, b1 > 0.0, b2 > 0.0, b3 > 0.0, b4 > 0.0);
    if p0 & p1 & p2 & p3 & p4 {
        return None;
    }
    let change = |a: bool, b: bool| u8::from(a ^ b);
    if change(p0, p1) + change(p1, p2) + change(p2, p3) + change(p3, p4) == 1 {
        return Some(polish(c, low, high));
    }
    if depth == 0 {
        return None;
    }
    let (left, right) = halve(b);
    let middle = 0.5 * (low + high);
    search(c, left, low, middle, depth - 1).or_else(|| search(c, right, middle, high, depth - 1))
}

/// Halves the interval by de Casteljau's construction.
fn halve(b: [f64; 5]) -> ([f64; 5], [f64; 5]) {
    let mid = |a: f64, b: f64| 0.5 * (a + b);
    let [b0, b1, b2, b3, b4] = b;
    let (l1, m1, m2, r1) = (mid(b0, b1), mid(b1, b2), mid(b2, b3), mid(b3, b4));
    let (l2, m3, r2) = (mid(l1, m1), mid(m1, m2), mid(m2, r1));
    let (l3, r3) = (mid(l2, m3), mid(m3, r2));
    let top = mid(l3, r3);
    ([b0, l1, l2, l3, top], [top, r3, r2, r1, b4])
}

/// Finds the root in an interval that contains exactly one root; the polynomial is positive before
/// the root. This uses Newton's method, and halves the bracket if a step would leave the bracket.
/// The first guess is the root of the quadratic part, which is a good approximation if friction
/// bends the path only slightly.
fn polish(c: &[f64; 5], mut low: f64, mut high: f64) -> f64 {
    let quadratic = 2.0 * c[0] / ((c[1] * c[1] - 4.0 * c[2] * c[0]).max(0.0).sqrt() - c[1]);
    let mut x = if quadratic > low && quadratic < high {
        quadratic
    } else {
        0.5 * (low + high)
    };
    for _ in 0..100 {
        let f = (((c[4] * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0];
        let slope = ((4.0 * c[4] * x + 3.0 * c[3]) * x + 2.0 * c[2]) * x + c[1];
        if f > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = x - f / slope;
        let inside = newton >= low && newton <= high;
        let next = if inside { newton } else { 0.5 * (low + high) };
        let step = (next - x).abs();
        x = next;
        // The error of Newton's method is proportional to the square of the step, so it is
        // negligible.
        if step <= 1e-11 * x && inside || high - low <= f64::EPSILON * high {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use aberth::aberth;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;

    fn value(c: &[f64; 5], x: f64) -> f64 {
        c.iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// A bound on the rounding error of the polynomial's value at x.
    fn noise(c: &[f64; 5], x: f64) -> f64 {
        1e-14 * c.iter().rev().fold(0.0, |sum, c| sum * x + c.abs())
    }

    #[test]
    fn known_roots_are_found() {
        // The polynomial (x−1)(x−2)(x−3)(x−4) is searched on three intervals.
        let c = [24.0, -50.0, 35.0, -10.0, 1.0];
        assert!((first_root(c, 10.0).unwrap() - 1.0).abs() < 1e-14);
        assert!((first_root(c, 1.5).unwrap() - 1.0).abs() < 1e-14);
        assert_eq!(first_root(c, 0.9), None);
        // These polynomials have two roots close together, or only a double root.
        let close = [1.0 - 1e-12, -2.0, 1.0, 0.0, 0.0];
        assert!((first_root(close, 3.0).unwrap() - (1.0 - 1e-6)).abs() < 1e-9);
        assert_eq!(first_root([1.0, -2.0, 1.0, 0.0, 0.0], 3.0), None);
        // These polynomials have a lower degree, or a root very close to zero.
        assert!((first_root([3.0, -2.0, 0.0, 0.0, 0.0], 2.0).unwrap() - 1.5).abs() < 1e-15);
        let near = first_root([1e-30, -1.0, 1.0, 1.0, 1.0], 0.5).unwrap();
        assert!((near / 1e-30 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn random_pairs_agree_with_an_independent_root_finder() {
        compare(100_000);
    }

    #[test]
    #[ignore = "takes seconds; CI runs it"]
    fn a_million_random_pairs_agree_with_an_independent_root_finder() {
        compare(1_000_000);
    }

    /// Compares the results for random pairs of sliding discs with those of Aberth's simultaneous
    /// iteration, which finds all four complex roots at once and shares no code with the search in
    /// this file.
    fn compare(pairs: u32) {
        let mut rng = Pcg64::seed_from_u64(3);
        let mut meetings = 0;
        for _ in 0..pairs {
            let c = pair(&mut rng);
            let end = rng.random_range(0.05..2.0);
            let first = aberth(&c, 100, 1e-14)
                .iter()
                // The limit is low, so that complex pairs near the real axis do not count.
                .filter(|root| root.im.abs() <= 1e-9 * root.re.abs())
                .map(|root| root.re)
                .filter(|&x| x > 0.0 && x < end)
                .fold(f64::INFINITY, f64::min);
            match first_root(c, end) {
                Some(x) => {
                    meetings += 1;
                    assert!((0.0..=end).contains(&x));
                    assert!(value(&c, x).abs() <= noise(&c, x), "{c:?} at {x}");
                    let near = first.is_infinite() || (first - x).abs() <= 1e-6 * x;
                    assert!(near, "{c:?}: {x}, but {first} comes first");
                }
                None => {
                    // A root may be left out only if it is at the very end or is a graze.
                    let left_out = first.is_infinite()
                        || value(&c, end) > -noise(&c, end)
                            && value(&c, first * (1.0 + 1e-7)) >= -noise(&c, first);
                    assert!(left_out, "{c:?} up to {end}: {first} was missed");
                }
            }
        }
        assert!(meetings > pairs / 20, "{meetings}");
    }

    /// The polynomial |Δ(t)|² − R² for two coins that are both sliding on a board.
    fn pair(rng: &mut Pcg64) -> [f64; 5] {
        let mut vector = |least: f64, most: f64| {
            let angle: f64 = rng.random_range(0.0..std::f64::consts::TAU);
            let size = rng.random_range(least..most);
            (size * angle.cos(), size * angle.sin())
        };
        let contact_distance = 0.0318;
        let d = vector(contact_distance, 0.4);
        let (u, v) = (vector(0.01, 4.0), vector(0.01, 4.0));
        let slowed = |(x, y): (f64, f64)| {
            let relative_deceleration = -1.1768 / (x * x + y * y).sqrt();
            (relative_deceleration * x, relative_deceleration * y)
        };
        let minus = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0, a.1 - b.1);
        let dot = |a: (f64, f64), b: (f64, f64)| a.0 * b.0 + a.1 * b.1;
        let (w, a) = (minus(v, u), minus(slowed(v), slowed(u)));
        [
            dot(d, d) - contact_distance * contact_distance,
            2.0 * dot(d, w),
            dot(w, w) + dot(d, a),
            dot(w, a),
            0.25 * dot(a, a),
        ]
    }
}
