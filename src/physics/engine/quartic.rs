//! The first root of a quartic on an interval.

/// How often an interval is halved before what is left is taken for a touch without
/// contact: 2⁻⁵⁰ of the interval.
const DEPTH: u32 = 50;

/// The first t in [0, `end`] at which c₀ + c₁t + c₂t² + c₃t³ + c₄t⁴ comes down to
/// zero, for c₀ > 0 and a finite `end`.
///
/// In Bernstein form on an interval the polynomial lies within the hull of its
/// coefficients: all positive means no root there, one change of sign means exactly
/// one root. Otherwise the interval is halved and the left half searched first, so
/// no root is passed over. A double root (a graze) counts as no root.
pub(super) fn first_root(c: [f64; 5], end: f64) -> Option<f64> {
    // On the unit interval.
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
    let [p0, p1, p2, p3, p4] = b.map(|b| b > 0.0);
    if p0 & p1 & p2 & p3 & p4 {
        return None;
    }
    let changes = [p0 != p1, p1 != p2, p2 != p3, p3 != p4];
    if changes.map(u8::from).iter().sum::<u8>() == 1 {
        return Some(polish(c, low, high));
    }
    if depth == 0 {
        return None;
    }
    let (left, right) = halve(b);
    let middle = 0.5 * (low + high);
    search(c, left, low, middle, depth - 1).or_else(|| search(c, right, middle, high, depth - 1))
}

/// de Casteljau's construction at one half.
fn halve(b: [f64; 5]) -> ([f64; 5], [f64; 5]) {
    let mid = |a: f64, b: f64| 0.5 * (a + b);
    let [b0, b1, b2, b3, b4] = b;
    let (l1, m1, m2, r1) = (mid(b0, b1), mid(b1, b2), mid(b2, b3), mid(b3, b4));
    let (l2, m3, r2) = (mid(l1, m1), mid(m1, m2), mid(m2, r1));
    let (l3, r3) = (mid(l2, m3), mid(m3, r2));
    let top = mid(l3, r3);
    ([b0, l1, l2, l3, top], [top, r3, r2, r1, b4])
}

/// The root in an interval that holds exactly one, positive before it: Newton's
/// steps, each kept inside the bracket by halving it where a step would leave. The
/// first guess is the root of the quadratic part, most of the truth where friction
/// bends the path little.
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
        // Newton's error goes with the square of the step: nothing is left of it.
        if step <= 1e-11 * x && inside || high - low <= f64::EPSILON * high {
            break;
        }
    }
    x
}
