//! Names of letters and signs, and which of them Unicode can raise or lower.

/// The letter or sign that a word in a formula stands for; words without one stand
/// for themselves.
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
        '⟂' => '⟂',
        _ => return None,
    })
}

/// A letter as a superscript.
pub(super) fn raised(letter: char) -> Option<char> {
    Some(match letter {
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        '-' | '−' => '⁻',
        _ => return None,
    })
}
