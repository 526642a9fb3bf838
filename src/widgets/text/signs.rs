//! Symbols used in physics that are spelt out on ASCII screens and in plain mode.

use crate::numbers::RAISED_DIGITS;

/// The digit or sign that corresponds to a superscript character.
pub(crate) fn superscript(letter: char) -> Option<char> {
    let digit = |letter| (0..10).zip(RAISED_DIGITS).find(|(_, it)| *it == letter);
    match letter {
        '⁻' => Some('-'),
        _ => char::from_digit(digit(letter)?.0, 10),
    }
}

/// The name of a Greek letter, capitalized like the letter: "delta", "Delta".
pub(crate) const fn greek(letter: char) -> Option<&'static str> {
    Some(match letter {
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'δ' => "delta",
        'ε' | 'ϵ' => "epsilon",
        'η' => "eta",
        'θ' | 'ϑ' => "theta",
        'λ' => "lambda",
        'μ' => "mu",
        'ν' => "nu",
        'π' => "pi",
        'ρ' => "rho",
        'σ' => "sigma",
        'τ' => "tau",
        'φ' | 'ϕ' => "phi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'Γ' => "Gamma",
        'Δ' => "Delta ",
        'Θ' => "Theta",
        'Λ' => "Lambda",
        'Σ' => "Sigma",
        'Φ' => "Phi",
        'Ω' => "Omega",
        _ => return None,
    })
}
