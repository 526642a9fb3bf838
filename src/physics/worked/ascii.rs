//! Formulas for a terminal that knows only ASCII.

/// The text with every sign of a worked solution spelt in ASCII; a sign that has no
/// spelling becomes `?`.
#[cfg_attr(
    target_family = "wasm",
    expect(dead_code, reason = "the command line's")
)]
pub(crate) fn ascii(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for sign in text.chars() {
        match sign {
            'α' => plain.push_str("alpha"),
            'θ' => plain.push_str("theta"),
            'ω' => plain.push_str("omega"),
            'μ' => plain.push_str("mu"),
            '₁' => plain.push('1'),
            '₂' => plain.push('2'),
            'ₙ' => plain.push('n'),
            'ₜ' => plain.push('t'),
            '²' => plain.push_str("^2"),
            '½' => plain.push_str("1/2"),
            '√' => plain.push_str("sqrt"),
            '°' => plain.push_str(" deg"),
            '−' => plain.push('-'),
            '×' => plain.push('*'),
            '·' => plain.push('.'),
            _ if sign.is_ascii() => plain.push(sign),
            _ => plain.push('?'),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_stay_readable() {
        let text = "v₁ₙ = −√(½ × 4) m/s, θ₁ = 45°, u² · n";
        let plain = "v1n = -sqrt(1/2 * 4) m/s, theta1 = 45 deg, u^2 . n";
        assert_eq!(ascii(text), plain);
        assert_eq!(ascii("naïve"), "na?ve");
    }
}
