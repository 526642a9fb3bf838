//! The positions at which a row of text can break without splitting a formula or a number.

use std::ops::Range;

use strum::VariantArray;

use super::wrap::width;

/// Units, as written in both charsets.
const UNITS: [&str; 23] = [
    "g", "kg", "m", "mm", "cm", "fm", "nm", "µm", "um", "mm²", "mm^2", "m/s", "s", "ms", "N", "J",
    "mJ", "eV", "keV", "MeV", "deg", "%", "turns",
];

/// Functions of an angle or of a number.
const FUNCTIONS: [&str; 5] = ["sin", "cos", "tan", "sqrt", "√"];

/// Words followed by a number, as in "law 21" and "chapter 7".
const NUMBERED: [&str; 8] = [
    "law", "laws", "chapter", "page", "level", "question", "step", "board",
];

/// How strongly a space keeps the words on its two sides together. A formula that is too long for a
/// row can be broken at its weakest spaces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, VariantArray)]
enum Hold {
    /// Not at all: between words of a sentence.
    Free,
    /// Before an equals sign.
    Equality,
    /// Between two terms: before a plus or a minus outside all brackets.
    Term,
    /// Between the two numbers of a vector.
    Vector,
    /// Between two factors of a term, or before a division sign.
    Factor,
    /// Before a plus or a minus in brackets.
    Inner,
    /// Between two factors in brackets.
    InnerFactor,
    /// Between an operator and its operand, a function and its angle, or a number and its unit.
    Fast,
}

/// Groups of words that belong together, as ranges of `words`, each short enough for a row of
/// `columns` columns unless it is a single word.
pub fn held<S: AsRef<str>>(words: &[S], columns: usize) -> Vec<Range<usize>> {
    let holds = holds(words);
    let mut held = Vec::new();
    let mut start = 0;
    for end in 1..=words.len() {
        if holds.get(end).is_none_or(|hold| *hold == Hold::Free) {
            let fits = |range: Range<usize>| {
                let words = words.get(range).unwrap_or_default().iter();
                words.map(|word| width(word.as_ref()) + 1).sum::<usize>() <= columns + 1
            };
            // `Free`, which comes first, holds nothing together.
            let weakest = &Hold::VARIANTS[1..];
            split(start..end, &holds, weakest, &mut held, &fits);
            start = end;
        }
    }
    held
}

/// The text with no-break spaces inside groups of words such as "5 g" and "e = 1.00".
pub(crate) fn unbroken(text: &str) -> String {
    let words: Vec<&str> = text.split(' ').collect();
    let parts = held(&words, UNBROKEN).into_iter();
    let parts = parts.map(|range| words.get(range).unwrap_or_default().join("\u{a0}"));
    parts.collect::<Vec<_>>().join(" ")
}

/// The maximum width, in columns, of a group of words that [`unbroken`] holds together.
const UNBROKEN: usize = 24;

/// Splits a range of words until each part fits, starting with the weakest spaces.
fn split(
    range: Range<usize>,
    holds: &[Hold],
    weakest: &[Hold],
    parts: &mut Vec<Range<usize>>,
    fits: &impl Fn(Range<usize>) -> bool,
) {
    let Some((weak, firmer)) = weakest.split_first().filter(|_| !fits(range.clone())) else {
        return parts.push(range);
    };
    let mut start = range.start;
    for at in range.start + 1..=range.end {
        if at == range.end || holds.get(at) == Some(weak) {
            split(start..at, holds, firmer, parts, fits);
            start = at;
        }
    }
}

/// For each word, how strongly it is bound to the word before it.
fn holds<S: AsRef<str>>(words: &[S]) -> Vec<Hold> {
    let mut depth = 0_usize;
    let mut before = "";
    let mut holds = Vec::with_capacity(words.len());
    for word in words {
        let word = word.as_ref();
        let hold = hold(before, word, depth > 0);
        if hold == Hold::Free {
            depth = 0;
        }
        for letter in word.chars() {
            match letter {
                '(' | '[' => depth += 1,
                ')' | ']' => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
        before = word;
        holds.push(hold);
    }
    holds
}

/// How strongly two words are held together, inside or outside brackets.
fn hold(before: &str, after: &str, in_brackets: bool) -> Hold {
    match is_prose(before) && is_prose(after) {
        true => Hold::Free,
        false => by_rules(before, after, in_brackets),
    }
}

/// How strongly two words are held together, without the quick test for ordinary words.
fn by_rules(before: &str, after: &str, in_brackets: bool) -> Hold {
    let sign = |word: &str| ["-", "−", "+", "±"].contains(&word);
    let unit = after.trim_end_matches(['.', ',', ';', ':', '?', '!', ')', ']']);
    let number = before
        .trim_end_matches([')', ']'])
        .ends_with(char::is_numeric);
    let measured = number && UNITS.contains(&unit) || before.ends_with('g') && unit == "m/s";
    let follows = sign(before) || ["=", "/", "·", "×"].contains(&before);
    // In ASCII the multiplication sign is a full stop or the letter x, which is also a coordinate.
    let times = |word| ["·", "×", "/", "."].contains(&word);
    let times_x = after == "x" && before.ends_with(|last: char| last.is_ascii_digit());
    let after_x = before == "x" && after.trim_start_matches(['(', '-']).starts_with(digit);
    let operand = is_operand(before);
    let reference = is_numbered(before) && after.starts_with(digit);
    let applied = is_function(before) && is_operand(after);
    if measured || follows || after_x || before == "." || applied || reference {
        Hold::Fast
    } else if after == "=" && is_sign(before) {
        Hold::Equality
    } else if before.starts_with('(') && before.ends_with(',') && after.contains(')') {
        Hold::Vector
    } else if sign(after) && operand {
        if in_brackets { Hold::Inner } else { Hold::Term }
    } else if times(after) && operand || times_x || is_product(before, after) {
        match in_brackets {
            true => Hold::InnerFactor,
            false => Hold::Factor,
        }
    } else {
        Hold::Free
    }
}

/// Whether a word, such as "law" or "chapter", can be followed by its number.
fn is_numbered(word: &str) -> bool {
    let name = word.trim_start_matches(['(', '[']);
    NUMBERED.iter().any(|it| it.eq_ignore_ascii_case(name))
}

fn digit(letter: char) -> bool {
    letter.is_ascii_digit()
}

/// A word of a formula, without brackets, signs and punctuation.
fn bare(word: &str) -> &str {
    let word = word.trim_start_matches(['(', '[', '-', '−']);
    word.trim_end_matches([')', ']', ',', ';', ':', '.'])
}

/// Whether a word is a function of an angle or a number, such as `sin`, `cos²`, `√`.
fn is_function(word: &str) -> bool {
    let bare = bare(word).trim_end_matches(['²', '⁴', '^', '2', '4']);
    FUNCTIONS.contains(&bare)
}

/// A quick test for ordinary words, which are the majority: two ordinary words are never held
/// together.
fn is_prose(word: &str) -> bool {
    let letters = word.trim_end_matches(['.', ',', ';', ':', '?', '!']);
    letters.len() > 1
        && letters.bytes().all(|letter| letter.is_ascii_alphabetic())
        && !FUNCTIONS.contains(&letters)
}

/// Whether a word is a symbol for a quantity, such as `α`, that stays with its value.
fn is_sign(word: &str) -> bool {
    const LONGEST: usize = 6;
    word.starts_with(char::is_alphabetic)
        && word.ends_with(char::is_alphanumeric)
        && word.chars().count() <= LONGEST
}

/// Whether a word has a subscript, such as `m₂` and `v1`.
fn is_indexed(word: &str) -> bool {
    word.starts_with(char::is_alphabetic) && word.ends_with(char::is_numeric)
        || word.contains(['₁', '₂', '_'])
}

/// Whether a word can be an operand, such as a number, a letter, a symbol with a subscript, or a
/// term in brackets.
fn is_operand(word: &str) -> bool {
    let bare = bare(word);
    let one_letter = bare.chars().count() == 1 && bare.starts_with(char::is_alphabetic);
    let ends = bare.ends_with(char::is_numeric) || bare.ends_with(['°', '²', '⁴']);
    one_letter
        || bare.starts_with(digit)
        || bare.starts_with(['√', '½'])
        || ends
        || is_indexed(bare)
        || word.ends_with([')', ']']) && word.contains(['(', '['])
        || is_function_of(bare)
        || is_greek(bare)
        || UNITS.contains(&bare)
}

/// Whether a word is a Greek letter in a formula, in either charset.
fn is_greek(word: &str) -> bool {
    let names = ["alpha", "delta", "theta", "Theta", "mu", "phi", "omega"];
    let is_letter = |letter| ('Α'..='ω').contains(&letter);
    names.contains(&word) || word.chars().count() == 1 && word.starts_with(is_letter)
}

/// Whether a word is a function directly followed by its angle, such as `sin(Θ`.
fn is_function_of(word: &str) -> bool {
    let Some((function, _)) = word.split_once('(') else {
        return false;
    };
    is_function(function)
}

/// Whether two words are adjacent factors of a product.
fn is_product(before: &str, after: &str) -> bool {
    if before.ends_with([',', ';', ':', '.']) {
        return false;
    }
    let brackets = ['(', '[', ')', ']'];
    let factor = before.trim_start_matches(brackets);
    let is_letter = |word: &str| word.chars().count() == 1 && word.starts_with(char::is_alphabetic);
    let closed = before.ends_with([')', ']']) && is_operand(before);
    let first = is_indexed(factor) || is_letter(factor) || closed;
    let after_function = is_function(after) || is_function_of(after);
    let number = before.ends_with(char::is_numeric);
    first && is_indexed(bare(after))
        || number && (is_greek(bare(after)) || is_indexed(bare(after)))
        || (first || number) && after_function
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(text: &str, columns: usize) -> Vec<String> {
        let words: Vec<&str> = text.split(' ').collect();
        let join = |range: Range<usize>| words[range].join(" ");
        held(&words, columns).into_iter().map(join).collect()
    }

    #[test]
    fn a_term_is_not_broken() {
        assert_eq!(
            parts("with sin(Θ − 30.0) = m₁ / m₂ sin 30.0: Θ = 50.0", 24),
            ["with", "sin(Θ − 30.0)", "= m₁ / m₂ sin 30.0:", "Θ = 50.0"]
        );
        assert_eq!(
            parts("so tan θ₁ = sin Θ / (cos Θ + m₁ / m₂) here", 27),
            ["so", "tan θ₁", "= sin Θ / (cos Θ + m₁ / m₂)", "here"]
        );
    }

    #[test]
    fn a_number_stays_with_its_factor() {
        for text in [
            "m₁ / m₂ = sin(θ₁ + 2 θ₂) / sin θ₁.",
            "m1 / m2 = sin(theta1 + 2 theta2) / sin theta1.",
        ] {
            for columns in 12..40 {
                let parts = parts(text, columns);
                assert!(!parts.iter().any(|it| it.ends_with(" 2")), "{parts:?}");
            }
        }
    }

    #[test]
    fn a_formula_that_is_too_long_breaks_at_its_weakest_blank() {
        let long = "v = (1 + e) m₁ / (m₁ + m₂) u₁ − e u₂ + 3";
        assert_eq!(parts(long, 60), [long]);
        assert_eq!(
            parts(long, 30),
            ["v", "= (1 + e) m₁ / (m₁ + m₂) u₁", "− e u₂", "+ 3"]
        );
    }

    /// Two ordinary words are never held together by the other rules either, so the quick test
    /// changes nothing.
    #[test]
    fn no_other_rule_holds_words_of_prose_together() {
        let words = [
            "The", "striker,", "kg", "turns", "alpha", "mm.", "g", "sin", "Theta;", "x",
        ];
        for before in words.iter().filter(|word| is_prose(word)) {
            for after in words.iter().filter(|word| is_prose(word)) {
                for in_brackets in [false, true] {
                    assert_eq!(by_rules(before, after, in_brackets), Hold::Free);
                }
            }
        }
        assert_eq!(words.iter().filter(|word| is_prose(word)).count(), 7);
    }

    #[test]
    fn no_product_continues_after_a_colon() {
        assert_eq!(
            parts("all of u_n: v2 = 1.85 m/s", 30),
            ["all", "of", "u_n:", "v2 = 1.85 m/s"]
        );
    }

    /// A number stays with a word such as "law" before it; the rest of the sentence can be broken.
    #[test]
    fn a_reference_is_not_broken() {
        assert_eq!(
            parts("foul (law 21): see Chapter 7, page 2", 30),
            ["foul", "(law 21):", "see", "Chapter 7,", "page 2"]
        );
    }

    #[test]
    fn ordinary_words_are_not_held_together() {
        let text = "The striker keeps a part of it - and the coin the rest";
        let free = text.replace(" - ", " ");
        assert_eq!(parts(&free, 80).len(), free.split(' ').count());
    }
}
