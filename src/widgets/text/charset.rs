//! The glyphs that a screen may use, and the spelling of text in them.

use std::borrow::Cow;

use strum::{EnumString, VariantNames};

use super::signs::superscript;
use crate::numbers::greek;

/// The glyphs that a screen may use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, EnumString, VariantNames)]
#[strum(serialize_all = "lowercase")]
pub enum Charset {
    /// Printable ASCII only.
    Ascii,
    /// Also braille, block elements, box lines and the symbols used in physics.
    #[default]
    Unicode,
}

impl Charset {
    /// The other charset, for the key that switches between the two.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Ascii => Self::Unicode,
            Self::Unicode => Self::Ascii,
        }
    }

    /// `text` in this charset.
    ///
    /// In Unicode that is the text itself, with minus signs instead of hyphens before and between
    /// numbers. In ASCII each symbol used in physics is spelt out, and characters without a
    /// spelling become `?`, so the result is printable ASCII. Line breaks are kept.
    ///
    /// ```
    /// use carrom::widgets::Charset;
    /// assert_eq!(Charset::Ascii.text("θ₁ = 60°"), "theta1 = 60 deg");
    /// assert_eq!(Charset::Unicode.text("θ₁ = 60°"), "θ₁ = 60°");
    /// ```
    pub fn text(self, text: &str) -> Cow<'_, str> {
        if self == Self::Unicode {
            return with_minus_signs(text);
        }
        if text.bytes().all(is_plain) {
            return Cow::Borrowed(text);
        }
        let mut plain = String::with_capacity(text.len());
        let mut raised = false;
        for letter in text.chars() {
            let was_raised = std::mem::replace(&mut raised, false);
            if let Some(digit) = superscript(letter) {
                // One `^` introduces the whole exponent: 10^-27.
                if !was_raised {
                    plain.push('^');
                }
                plain.push(digit);
                raised = true;
            } else if letter.is_ascii() {
                plain.push(if is_plain(letter as u8) { letter } else { '?' });
            } else if letter == '°' {
                // A unit is separated from its number by a space: 60 deg, but (deg).
                let after_number = plain.ends_with(|c: char| c.is_ascii_alphanumeric());
                plain.push_str(if after_number { " deg" } else { "deg" });
            } else {
                if letter == '√' && plain.ends_with(|c: char| c.is_ascii_alphanumeric()) {
                    plain.push(' ');
                }
                // A subscript after a letter is preceded by an underscore: n_x, but v2x.
                if matches!(letter, 'ₓ' | 'ᵧ') && plain.ends_with(|c: char| c.is_ascii_alphabetic())
                {
                    plain.push('_');
                }
                plain.push_str(spelling(letter));
            }
        }
        Cow::Owned(plain)
    }
}

/// `text` with minus signs instead of hyphens that mean minus: before a number, as in `-2`, and
/// alone between two terms, as in `90 - 30`. Ranges, names and dates keep their hyphens.
fn with_minus_signs(text: &str) -> Cow<'_, str> {
    if !text.contains('-') {
        return Cow::Borrowed(text);
    }
    let mut written = String::with_capacity(text.len() + 4);
    for (at, letter) in text.char_indices() {
        let before = text.get(..at).unwrap_or_default();
        let after = text.get(at + letter.len_utf8()..).unwrap_or_default();
        let minus = letter == '-' && (is_sign(before, after) || is_difference(before, after));
        written.push(if minus { '−' } else { letter });
    }
    Cow::Owned(written)
}

/// Whether a hyphen at this position is the sign of a number.
fn is_sign(before: &str, after: &str) -> bool {
    let opens = before.is_empty() || before.ends_with([' ', '(', '[', '=', '\n', '\u{a0}']);
    opens && after.starts_with(|first: char| first.is_ascii_digit())
}

/// Whether a hyphen at this position is a minus between two terms.
fn is_difference(before: &str, after: &str) -> bool {
    let term = |last: char| last.is_numeric() || matches!(last, '°' | ')' | ']');
    let next = |first: char| first.is_numeric() || matches!(first, '(' | '[' | '√' | 'α'..='ω');
    let blank = [' ', '\u{a0}'];
    let ends = |before: &str| before.ends_with(term);
    let begins = |after: &str| after.starts_with(next);
    before.strip_suffix(blank).is_some_and(ends) && after.strip_prefix(blank).is_some_and(begins)
}

/// Whether a byte is allowed in ASCII text: a printable character or a line break.
const fn is_plain(byte: u8) -> bool {
    matches!(byte, b' '..=b'~' | b'\n')
}

/// The ASCII spelling of a character that is not ASCII.
fn spelling(letter: char) -> &'static str {
    match letter {
        // The prefix micro.
        'µ' => "u",
        '₀'..='₉' => {
            let digit = letter as usize - '₀' as usize;
            &"0123456789"[digit..=digit]
        }
        'ₙ' => "_n",
        'ₜ' => "_t",
        'ₓ' => "x",
        'ᵧ' => "y",
        'ₛ' => "s",
        'ᵣ' => "_r",
        '∥' => "_par",
        '⊥' | '⟂' => "_perp",
        '′' | '‘' | '’' | '‛' => "'",
        '″' | '“' | '”' | '„' | '«' | '»' => "\"",
        '−' | '–' | '‐' | '‑' | '─' | '━' => "-",
        '—' => "--",
        '│' | '┃' | '▏' | '▎' => "|",
        '·' | '∙' | '⋅' => ".",
        '•' | '●' | '∗' => "*",
        '○' | '◯' => "o",
        '…' => "...",
        '×' => "x",
        '÷' => "/",
        '±' => "+-",
        '√' => "sqrt ",
        '≤' => "<=",
        '≥' => ">=",
        '≠' => "!=",
        '≈' | '∼' => "~",
        '≡' => "==",
        '∝' => "~",
        '∞' => "inf",
        '∠' => "angle ",
        '∑' => "sum",
        '∂' => "d",
        '→' | '▶' | '▸' | '►' => "->",
        '←' | '◀' | '◂' => "<-",
        '↔' => "<->",
        '↑' | '▲' => "^",
        '↓' | '▼' => "v",
        '⇒' => "=>",
        '⇔' => "<=>",
        '½' => "1/2",
        '¼' => "1/4",
        '¾' => "3/4",
        '⅓' => "1/3",
        '⅔' => "2/3",
        '✓' | '✔' => "+",
        '✗' | '✘' => "x",
        '★' => "*",
        '☆' => ".",
        '█' | '▓' => "#",
        '▒' | '░' => ".",
        '\u{a0}' | '\u{2009}' | '\u{202f}' | '\u{2002}' | '\u{2003}' => " ",
        'à' | 'á' | 'â' | 'ã' | 'ä' | 'å' => "a",
        'ç' => "c",
        'è' | 'é' | 'ê' | 'ë' => "e",
        'ì' | 'í' | 'î' | 'ï' => "i",
        'ñ' => "n",
        'ò' | 'ó' | 'ô' | 'õ' | 'ö' | 'ø' => "o",
        'ù' | 'ú' | 'û' | 'ü' => "u",
        'ß' => "ss",
        other => greek(other).unwrap_or("?"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn physics_is_spelt_out_in_ascii() {
        for (written, spelt) in [
            ("θ₁ = 60°", "theta1 = 60 deg"),
            ("α (°)", "alpha (deg)"),
            ("u·cos α", "u.cos alpha"),
            ("m₁ × v₁ − 2", "m1 x v1 - 2"),
            ("½ μ u² ≤ √3 → …", "1/2 mu u^2 <= sqrt 3 -> ..."),
            ("m⁴, 3.7·10⁻²⁷ m⁻²", "m^4, 3.7.10^-27 m^-2"),
            ("2√3 or √(a + b)", "2 sqrt 3 or sqrt (a + b)"),
            ("“far” — it’s", "\"far\" -- it's"),
            ("0.21 µm", "0.21 um"),
            ("nₓ and v₂ₓ", "n_x and v2x"),
            ("plain", "plain"),
        ] {
            assert_eq!(Charset::Ascii.text(written), spelt);
            assert_eq!(Charset::Unicode.text(written), written);
        }
    }

    #[test]
    fn a_hyphen_that_means_minus_is_written_as_a_minus_sign() {
        for (written, shown) in [
            ("90 - 25.0 = 65.0", "90 − 25.0 = 65.0"),
            ("-2.0 of 10", "−2.0 of 10"),
            ("(-1, 180° - 2α)", "(−1, 180° − 2α)"),
            (
                "1e-5, 0-9, mixed-7, 2026-01-05",
                "1e-5, 0-9, mixed-7, 2026-01-05",
            ),
            ("0-9 . -", "0-9 . -"),
            ("--code a-1 - yes", "--code a-1 - yes"),
        ] {
            assert_eq!(Charset::Unicode.text(written), shown);
            assert_eq!(Charset::Ascii.text(shown), Charset::Ascii.text(written));
        }
    }

    #[test]
    fn any_text_becomes_printable_ascii() {
        let all: String = ('\0'..='\u{2fff}')
            .chain('\u{1f300}'..='\u{1f6ff}')
            .collect();
        let spelt = Charset::Ascii.text(&all);
        assert!(spelt.bytes().all(is_plain));
        assert!(spelt.contains('?'));
    }
}
