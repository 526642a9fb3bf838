//! Symbols as words.

use super::functions;
use crate::numbers::greek;
use crate::widgets::signs::superscript;

/// Replaces symbols with words, and adds the spaces that these need.
pub(super) fn spell(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let mut plain = String::with_capacity(2 * text.len());
    let mut i = 0;
    while let Some((before, [letter, after @ ..])) = letters.split_at_checked(i) {
        if let Some((words, taken)) = functions::at(&letters, i) {
            plain += &words;
            i += taken;
        } else if let Some((words, taken)) = power(&letters[i..]) {
            plain += &words;
            i += taken;
            separate(&mut plain, letters.get(i));
        } else {
            plain += &one(*letter, before, after);
            i += 1;
            let ends_quantity = matches!(letter, '₀'..='₉') || is_greek(*letter);
            let begins_sign =
                letter.is_ascii_alphabetic() && after.first().is_some_and(|c| is_greek(*c));
            if ends_quantity || begins_sign {
                separate(&mut plain, after.first());
            }
            // A component times its direction: "v₁ₙ n".
            if matches!(letter, 'ₙ' | 'ₜ') && is_direction(after) {
                plain += " times";
            }
        }
    }
    plain
}

/// Inserts a space before a letter, because another quantity begins there.
fn separate(plain: &mut String, next: Option<&char>) {
    if next.is_some_and(|c| c.is_alphabetic()) {
        plain.push(' ');
    }
}

/// The power at the start of the text, in words, and the number of characters that it replaces.
pub(super) fn power(letters: &[char]) -> Option<(String, usize)> {
    let power: String = letters.iter().map_while(|c| superscript(*c)).collect();
    let words = match power.as_str() {
        "" => return None,
        "2" => " squared".into(),
        "3" => " cubed".into(),
        power => format!(" to the power {}", power.replace('-', "minus ")),
    };
    Some((words, power.chars().count()))
}

/// A single symbol in words, which depend on the characters before and after it.
fn one(letter: char, before: &[char], after: &[char]) -> String {
    let (last, next) = (before.last().copied(), after.first().copied());
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let name = |c: Option<char>| {
        c.is_some_and(|c| c.is_alphanumeric() || matches!(c, '(' | ')' | '₁' | '₂'))
    };
    let apart = last == Some(' ') && next == Some(' ');
    let words = match letter {
        '-' | '−' if apart => "minus",
        '-' | '−' if digit(next) && !name(last) => " minus ",
        '−' => " minus ",
        '=' => " equals ",
        '+' => " plus ",
        '<' => " below ",
        '>' => " above ",
        ':' if apart => "to",
        'e' if digit(last) && is_exponent(after) => " times 10 to the power ",
        '/' if apart => "over",
        '/' if last == Some('m') && next == Some('s') => "/",
        '/' if is_word(before.iter().rev()) && is_word(after.iter()) => "/",
        '/' if name(last) && name(next) => " over ",
        '*' if name(last) && name(next) => " times ",
        '·' | '∙' if begins_function(after) => " times ",
        '·' | '∙' if is_quantity(before.iter().rev()) && is_quantity(after.iter()) => " dot ",
        '√' if digit(last) => " times the square root of ",
        '°' if is_one(before) => " degree",
        'Ω' => "omega",
        'Δ' => "delta",
        c => match (spelling(c), greek(c)) {
            (Some(words), _) => words,
            (None, Some(name)) if c.is_uppercase() => {
                return format!("capital {}", name.to_lowercase());
            }
            (None, Some(name)) => name,
            (None, None) => return c.into(),
        },
    };
    words.into()
}

fn is_greek(letter: char) -> bool {
    spelling(letter).is_none() && greek(letter).is_some()
}

/// Whether the text starts with the name of a function, after any spaces.
fn begins_function(letters: &[char]) -> bool {
    let word = letters.iter().skip_while(|c| **c == ' ');
    let word: String = word.take_while(|c| c.is_ascii_alphabetic()).collect();
    functions::is_function(&word)
}

/// Whether the text starts with the letter of a direction or of one of its components.
fn is_direction(letters: &[char]) -> bool {
    match letters {
        [' ', 'n' | 't', 'ₓ' | 'ᵧ', ..] => true,
        [' ', 'n' | 't', after @ ..] => !after.first().is_some_and(|c| c.is_alphanumeric()),
        _ => false,
    }
}

/// Whether the text starts with two letters, and therefore with a word rather than a quantity.
fn is_word<'a>(letters: impl Iterator<Item = &'a char>) -> bool {
    letters.take(2).filter(|c| c.is_ascii_alphabetic()).count() == 2
}

/// Whether the text starts with a letter, after any spaces or subscripts.
fn is_quantity<'a>(letters: impl Iterator<Item = &'a char>) -> bool {
    let mut letters = letters.skip_while(|c| matches!(**c, ' ' | '₀'..='₉' | 'ₙ' | 'ₜ'));
    letters.next().is_some_and(|c| c.is_alphabetic())
}

/// Whether the text ends in the number 1.
fn is_one(letters: &[char]) -> bool {
    let part = |c: &&char| c.is_ascii_digit() || matches!(**c, '.' | ',');
    let number: String = letters.iter().rev().take_while(part).collect();
    number == "1"
}

/// Whether the exponent of a power of ten begins here: "7", "-5".
fn is_exponent(letters: &[char]) -> bool {
    matches!(letters, ['-' | '−' | '+', c, ..] | [c, ..] if c.is_ascii_digit())
}

/// The spoken form of a symbol; `None` for other characters, including most Greek letters.
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
        'ᵣ' => " r",
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
        '∝' => " is proportional to ",
        '∞' => "infinity",
        '→' => " to ",
        '⇒' => " so ",
        '°' => " degrees",
        '%' => " percent",
        '…' => "...",
        '′' | '‘' | '’' => "'",
        '″' | '“' | '”' => "\"",
        '–' => " to ",
        '—' => ", ",
        '[' => "(",
        ']' => ")",
        '*' | '`' => "",
        '\u{a0}' => " ",
        '\u{0}'..='\u{1f}' | '\u{7f}'..='\u{9f}' => " ",
        _ => return None,
    })
}
