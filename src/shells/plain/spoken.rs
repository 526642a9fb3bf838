//! A text as it is read aloud.

use std::fmt::Write;

use crate::widgets::signs::{greek, superscript};

/// A text with its signs and units spelt as they are read aloud, in one line without
/// blanks at its ends; what is spelt is ASCII, and letters of names stay as they are.
///
/// ```
/// use carrom::shells::plain::spoken;
/// assert_eq!(spoken("θ₁ = 63.4°, v₂ = 2.12 m/s"), "theta 1 equals 63.4 degrees, v 2 equals 2.12 metres per second");
/// ```
pub fn spoken(text: &str) -> String {
    let signs = spell_signs(text);
    let mut words: Vec<String> = Vec::new();
    let mut tokens = signs.split_whitespace().peekable();
    while let Some(token) = tokens.next() {
        let after_number = words.last().is_some_and(|word| ends_in_number(word));
        let (bare, stop) = without_stop(token);
        let word = match bare {
            "g" if after_number && tokens.peek().is_some_and(|next| next.starts_with("m/s")) => {
                "gram".to_owned()
            }
            unit if after_number || words.last().is_some_and(|word| word == "gram") => {
                named_unit(unit).map_or_else(|| token.to_owned(), |name| format!("{name}{stop}"))
            }
            "m/s" => format!("metres per second{stop}"),
            _ => token.to_owned(),
        };
        words.push(word);
    }
    words
        .join(" ")
        .replace("( ", "(")
        .replace(" )", ")")
        .replace(" ,", ",")
}

/// Signs as words, with blanks around them.
fn spell_signs(text: &str) -> String {
    let mut plain = String::with_capacity(2 * text.len());
    let letters: Vec<char> = text.chars().collect();
    let mut i = 0;
    while let Some(&letter) = letters.get(i) {
        let before = i
            .checked_sub(1)
            .and_then(|before| letters.get(before))
            .copied();
        let after = letters.get(i + 1).copied();
        let power: String = letters[i..].iter().map_while(|c| superscript(*c)).collect();
        if !power.is_empty() {
            let _ = match power.as_str() {
                "2" => write!(plain, " squared"),
                "3" => write!(plain, " cubed"),
                power => write!(plain, " to the power {}", power.replace('-', "minus ")),
            };
            i += power.chars().count();
            continue;
        }
        let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        let name = |c: Option<char>| {
            c.is_some_and(|c| c.is_alphanumeric() || matches!(c, '(' | ')' | '₁' | '₂'))
        };
        match letter {
            '-' | '−' if before == Some(' ') && after == Some(' ') => plain.push_str("minus"),
            '-' | '−' if digit(after) && !name(before) => plain.push_str(" minus "),
            '−' => plain.push_str(" minus "),
            '=' => plain.push_str(" equals "),
            '+' => plain.push_str(" plus "),
            '<' => plain.push_str(" below "),
            '>' => plain.push_str(" above "),
            '/' if before == Some(' ') && after == Some(' ') => plain.push_str("over"),
            '/' if before == Some('m') && after == Some('s') => plain.push('/'),
            '/' if name(before) && name(after) => plain.push_str(" over "),
            c => match (spelling(c), greek(c)) {
                (Some(words), _) => plain.push_str(words),
                (None, Some(name)) => {
                    if c.is_uppercase() {
                        plain.push_str("capital ");
                    }
                    plain.push_str(&name.to_lowercase());
                }
                (None, None) => plain.push(c),
            },
        }
        // A letter after a subscript is another quantity.
        if matches!(letter, '₀'..='₉') && after.is_some_and(|c| c.is_ascii_alphabetic()) {
            plain.push(' ');
        }
        i += 1;
    }
    for (function, name) in [
        ("arcsin ", "the arc sine of "),
        ("sin ", "the sine of "),
        ("cos ", "the cosine of "),
        ("tan ", "the tangent of "),
        ("cot ", "the cotangent of "),
    ] {
        plain = spell_function(&plain, function, name);
    }
    plain
}

/// Puts the name of a function in its place, with "times" after a number.
fn spell_function(text: &str, function: &str, name: &str) -> String {
    let mut spelt = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(function) {
        let (before, found) = rest.split_at(at);
        spelt.push_str(before);
        let starts_a_word = !spelt.ends_with(|c: char| c.is_alphanumeric());
        if starts_a_word {
            let last = spelt.trim_end().chars().next_back();
            let factor =
                last.is_some_and(|c| c.is_ascii_digit() || c == ')') || ends_in_sign(&spelt);
            if factor {
                spelt.push_str("times ");
            }
            let power = ["squared", "cubed", "to the power"];
            let raised = power
                .iter()
                .any(|word| found[function.len()..].starts_with(word));
            spelt.push_str(if raised {
                name.trim_end_matches("of ")
            } else {
                name
            });
        } else {
            spelt.push_str(function);
        }
        rest = &found[function.len()..];
    }
    spelt + rest
}

/// Whether a text ends in a sign of a quantity, such as u or "v 1".
fn ends_in_sign(text: &str) -> bool {
    let last = text.split_whitespace().next_back().unwrap_or_default();
    matches!(last, "u" | "v" | "p" | "m" | "n" | "t")
}

/// Whether the last thing said is a number, so that a unit may follow.
fn ends_in_number(word: &str) -> bool {
    let bare = word.trim_start_matches('(');
    bare.parse::<f64>().is_ok()
}

/// A word and the stops after it.
fn without_stop(word: &str) -> (&str, &str) {
    let bare = word.trim_end_matches([',', '.', ';', ':', ')', '?', '!']);
    (bare, &word[bare.len()..])
}

/// A unit as it is read aloud: "m/s" as "metres per second", "g m/s" as "gram metres per
/// second".
pub(super) fn unit_name(unit: &str) -> String {
    let read = spoken(&format!("1 {unit}"));
    read.strip_prefix("1 ").unwrap_or(unit).to_owned()
}

fn named_unit(unit: &str) -> Option<&'static str> {
    Some(match unit {
        "m/s" => "metres per second",
        "mm" => "millimetres",
        "cm" => "centimetres",
        "m" => "metres",
        "g" => "grams",
        "kg" => "kilograms",
        "mJ" => "millijoules",
        "J" => "joules",
        "MeV" => "mega electron volts",
        "fm" => "femtometres",
        "s" => "seconds",
        "deg" => "degrees",
        "%" => "percent",
        _ => return None,
    })
}

/// How a sign is read; `None` for a letter, Greek ones too.
const fn spelling(letter: char) -> Option<&'static str> {
    Some(match letter {
        'µ' => "mu",
        'Σ' => "the sum of",
        '₀' => " 0",
        '₁' => " 1",
        '₂' => " 2",
        '₃' => " 3",
        'ₙ' => " n",
        'ₜ' => " t",
        'ₓ' => " x",
        'ᵧ' => " y",
        'ₛ' => " s",
        '⟂' | '⊥' => " perpendicular",
        '½' => "one half ",
        '¼' => "one quarter ",
        '¾' => "three quarters ",
        '√' => " the square root of ",
        '×' | '·' | '∙' => " times ",
        '≈' => " is about ",
        '≠' => " is not ",
        '≤' => " at most ",
        '≥' => " at least ",
        '±' => " plus or minus ",
        '∝' => " goes with ",
        '∞' => "infinity",
        '→' => " to ",
        '°' => " degrees",
        '%' => " percent",
        '…' => "...",
        '′' | '‘' | '’' => "'",
        '″' | '“' | '”' => "\"",
        '–' => " to ",
        '—' => ", ",
        '*' | '`' => "",
        '\u{a0}' => " ",
        '\u{0}'..='\u{1f}' | '\u{7f}'..='\u{9f}' => " ",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_and_units_are_read_aloud() {
        for (text, read) in [
            ("60.0°", "60.0 degrees"),
            ("90 - 30.0 = 60.0°", "90 minus 30.0 equals 60.0 degrees"),
            ("-12.5°", "minus 12.5 degrees"),
            ("25.0 %", "25.0 percent"),
            (
                "15.0 g at 4.00 m/s.",
                "15.0 grams at 4.00 metres per second.",
            ),
            ("60.0 g m/s", "60.0 gram metres per second"),
            (
                "4.00 cos 30.0 = 3.46 m/s",
                "4.00 times the cosine of 30.0 equals 3.46 metres per second",
            ),
            ("v₁² + v₂²", "v 1 squared plus v 2 squared"),
            ("m₁/(m₁ + m₂)", "m 1 over (m 1 plus m 2)"),
            ("1/sin⁴", "1 over the sine to the power 4"),
            ("3.2×10⁻⁷", "3.2 times 10 to the power minus 7"),
            ("well-known and off-centre", "well-known and off-centre"),
            ("m₁u₁", "m 1 u 1"),
            ("Ada Łoś", "Ada Łoś"),
            ("  ", ""),
        ] {
            assert_eq!(spoken(text), read, "{text}");
        }
    }

    #[test]
    fn nothing_that_moves_a_cursor_is_left() {
        let all: String = (0..0x3000).filter_map(char::from_u32).collect();
        assert!(spoken(&all).chars().all(|c| !c.is_control()));
    }
}
