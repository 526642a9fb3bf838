//! Student's t and Fisher's F, for intervals and tests with few points.

/// The probability that the magnitude of Student's t with `dof` degrees of freedom is at least `t`.
pub(super) fn beyond_t(t: f64, dof: f64) -> f64 {
    regularized_beta(dof / (dof + t * t), 0.5 * dof, 0.5)
}

/// The probability that Fisher's F with `k` and `dof` degrees of freedom is at least `f`.
pub(super) fn beyond_f(f: f64, k: f64, dof: f64) -> f64 {
    regularized_beta(dof / (dof + k * f.max(0.0)), 0.5 * dof, 0.5 * k)
}

/// The value that the magnitude of Student's t with `dof` degrees of freedom exceeds with this
/// probability.
pub(crate) fn t_beyond(probability: f64, dof: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while beyond_t(high, dof) > probability && high < 1e9 {
        (low, high) = (high, 2.0 * high);
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if beyond_t(middle, dof) > probability {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// The regularized incomplete beta function Iₓ(a, b), by its continued fraction (modified Lentz).
fn regularized_beta(x: f64, a: f64, b: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return 1.0;
    }
    // The fraction converges quickly only for smaller x.
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - regularized_beta(1.0 - x, b, a);
    }
    let front =
        (ln_gamma(a + b) - ln_gamma(a) - ln_gamma(b) + a * x.ln() + b * (1.0 - x).ln()).exp() / a;
    const TINY: f64 = 1e-300;
    let apart = |y: f64| if y.abs() < TINY { TINY } else { y };
    let (mut c, mut d) = (1.0, 1.0 / apart(1.0 - (a + b) * x / (a + 1.0)));
    let mut fraction = d;
    for m in 1..500 {
        let m = f64::from(m);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut factor = 1.0;
        for step in [even, odd] {
            d = 1.0 / apart(1.0 + step * d);
            c = apart(1.0 + step / c);
            factor = c * d;
            fraction *= factor;
        }
        if (factor - 1.0).abs() < 1e-14 {
            break;
        }
    }
    front * fraction
}

/// ln Γ(x) for x > 0, by the recurrence and Stirling's series.
fn ln_gamma(x: f64) -> f64 {
    let (mut x, mut below) = (x, 0.0);
    while x < 12.0 {
        below += x.ln();
        x += 1.0;
    }
    let inverse = 1.0 / x;
    let square = inverse * inverse;
    let series = inverse * (1.0 / 12.0 - square * (1.0 / 360.0 - square * (1.0 / 1260.0)));
    (x - 0.5) * x.ln() - x + 0.5 * std::f64::consts::TAU.ln() + series - below
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares the results with printed tables of both distributions.
    #[test]
    fn quantiles_agree_with_the_tables() {
        for (dof, t) in [(1.0, 12.706), (5.0, 2.571), (10.0, 2.228), (120.0, 1.980)] {
            assert!((t_beyond(0.05, dof) - t).abs() < 6e-4, "{dof}");
        }
        assert!((t_beyond(0.317_310_5, 1e7) - 1.0).abs() < 1e-5);
        for (f, k, dof) in [(10.04, 1.0, 10.0), (5.85, 2.0, 20.0), (4.61, 2.0, 1e6)] {
            assert!((beyond_f(f, k, dof) - 0.01).abs() < 1e-4, "{f}");
        }
        assert_eq!(beyond_f(0.0, 2.0, 9.0), 1.0);
    }
}
