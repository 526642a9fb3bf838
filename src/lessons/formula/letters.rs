//! The names of letters and signs, and the superscript and subscript characters of Unicode.

use crate::numbers::RAISED_DIGITS;

/// The letter or sign that a word stands for in a formula; `None` for any other word.
pub(super) fn letter(word: &str) -> Option<&'static str> {
    Some(match word {
        "alpha" => "α",
        "beta" => "β",
        "gamma" => "γ",
        "delta" => "δ",
        "epsilon" => "ε",
        "eta" => "η",
        "theta" => "θ",
        "lambda" => "λ",
        "mu" => "μ",
        "nu" => "ν",
        "pi" => "π",
        "rho" => "ρ",
        "sigma" => "σ",
        "tau" => "τ",
        "phi" => "φ",
        "psi" => "ψ",
        "omega" => "ω",
        "Delta" => "Δ",
        "Theta" => "Θ",
        "Sigma" => "Σ",
        "Phi" => "Φ",
        "Omega" => "Ω",
        "times" => "×",
        "dot" => "·",
        "approx" => "≈",
        "perp" => "⟂",
        "infinity" => "∞",
        "deg" => "°",
        _ => return None,
    })
}

/// The subscript form of a letter.
pub(super) fn lowered(letter: char) -> Option<char> {
    Some(match letter {
        '0'..='9' => char::from_u32('₀' as u32 + (letter as u32 - '0' as u32))?,
        'n' => 'ₙ',
        't' => 'ₜ',
        'x' => 'ₓ',
        'y' => 'ᵧ',
        's' => 'ₛ',
        'r' => 'ᵣ',
        '⟂' => '⟂',
        _ => return None,
    })
}

/// The superscript form of a letter.
pub(super) fn raised(letter: char) -> Option<char> {
    Some(match letter {
        '-' | '−' => '⁻',
        _ => RAISED_DIGITS[letter.to_digit(10)? as usize],
    })
}
