//! Names of letters and signs, and the superscripts and subscripts that Unicode has.

use crate::numbers::RAISED_DIGITS;

/// The letter or sign for a word in a formula; `None` for other words.
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

/// A letter as a subscript.
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

/// A letter as a superscript.
pub(super) fn raised(letter: char) -> Option<char> {
    Some(match letter {
        '-' | '−' => '⁻',
        _ => RAISED_DIGITS[letter.to_digit(10)? as usize],
    })
}
