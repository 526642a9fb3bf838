//! Numbers as the foil writes them.

/// A count with commas, as in 1,234,567.
pub(super) fn count(number: u64) -> String {
    let digits: Vec<char> = number.to_string().chars().collect();
    let groups = digits.rchunks(3).rev().map(String::from_iter);
    groups.collect::<Vec<_>>().join(",")
}

/// A fraction: as a percentage or, if it is below 0.1, as in "1 in 117,000".
pub(super) fn share(share: f64) -> String {
    if share >= 0.1 {
        return format!("{:.1} %", 100.0 * share);
    }
    let one_in = 1.0 / share;
    if one_in.is_nan() || one_in >= 1e15 {
        return "none".into();
    }
    format!("1 in {}", count(rounded(one_in) as u64))
}

/// A positive number, rounded to an integer and to three significant figures.
pub(super) fn rounded(number: f64) -> f64 {
    to_figures(number, 3)
}

/// A positive number, rounded to an integer and to `figures` significant figures.
pub(super) fn to_figures(number: f64, figures: u8) -> f64 {
    let beyond = number.log10().floor() + 1.0 - f64::from(figures);
    let unit = 10_f64.powf(beyond.max(0.0));
    (number / unit).round() * unit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_easy_to_read() {
        assert_eq!(count(0), "0");
        assert_eq!(count(999), "999");
        assert_eq!(count(1_000), "1,000");
        assert_eq!(count(1_234_567), "1,234,567");
        assert_eq!(share(0.5), "50.0 %");
        assert_eq!(share(0.01), "1 in 100");
        assert_eq!(share(8.54e-6), "1 in 117,000");
        assert_eq!(share(0.0), "none");
    }
}
