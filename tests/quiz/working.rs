//! The working in explanations, calculated again: the printed steps must give the printed results.

use std::collections::BTreeMap;

use carrom::quiz::Family;

use crate::questions;

/// How many seeds are tried at each difficulty.
const SEEDS: u64 = 400;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Token {
    /// A number, and how many decimal places it has.
    Number(f64, i32),
    Function(char),
    Root(f64),
    Power(i32),
    Sign(char),
    Degrees,
    Percent,
    /// A quantity whose value is unknown here.
    Symbol,
    /// A word, or a mark that ends the working.
    End,
}

/// The tokens of a text, each with its position; `readings` are the values of θ₁ and θ₂.
fn tokens(text: &str, readings: [Option<f64>; 2]) -> Vec<(usize, Token)> {
    const FIXED: [(&str, Option<Token>); 31] = [
        ("g m/s", None),
        ("m/s", None),
        ("mm", None),
        ("MeV", None),
        ("sin", Some(Token::Function('s'))),
        ("cos", Some(Token::Function('c'))),
        ("tan", Some(Token::Function('t'))),
        ("⁴√", Some(Token::Root(4.0))),
        ("√", Some(Token::Root(2.0))),
        ("²", Some(Token::Power(2))),
        ("⁴", Some(Token::Power(4))),
        ("°", Some(Token::Degrees)),
        ("%", Some(Token::Percent)),
        ("×", Some(Token::Sign('*'))),
        ("·", Some(Token::Sign('*'))),
        ("/", Some(Token::Sign('/'))),
        ("−", Some(Token::Sign('-'))),
        ("+", Some(Token::Sign('+'))),
        ("(", Some(Token::Sign('('))),
        (")", Some(Token::Sign(')'))),
        ("=", Some(Token::Sign('='))),
        ("m₁", Some(Token::Symbol)),
        ("m₂", Some(Token::Symbol)),
        ("v₁", Some(Token::Symbol)),
        ("v₂", Some(Token::Symbol)),
        ("r₁", Some(Token::Symbol)),
        ("r₂", Some(Token::Symbol)),
        ("θ₁", None),
        ("θ₂", None),
        ("α", Some(Token::Symbol)),
        ("Θ", Some(Token::Symbol)),
    ];
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        if c.is_ascii_digit() {
            let length = rest
                .find(|c: char| !c.is_ascii_digit() && c != '.')
                .unwrap_or(rest.len());
            let number = rest[..length].trim_end_matches('.');
            let decimals = number.split_once('.').map_or(0, |(_, it)| it.len());
            found.push((at, Token::Number(number.parse().unwrap(), decimals as i32)));
            at += number.len();
        } else if let Some((name, token)) = FIXED.iter().find(|it| rest.starts_with(it.0)) {
            let reading = ["θ₁", "θ₂"].iter().position(|it| it == name);
            let reading = reading.map(|i| match readings[i] {
                Some(deg) => Token::Number(deg, 1),
                None => Token::Symbol,
            });
            found.extend(reading.or(*token).map(|token| (at, token)));
            at += name.len();
        } else if c.is_alphabetic() {
            let length = rest
                .find(|c: char| !c.is_alphanumeric())
                .unwrap_or(rest.len());
            let token = match &rest[..length] {
                "g" => None,
                "k" | "e" | "b" | "u" | "E" | "m₁v₁" | "m₂v₂" => Some(Token::Symbol),
                _ => Some(Token::End),
            };
            found.extend(token.map(|token| (at, token)));
            at += length;
        } else {
            if c != ' ' {
                found.push((at, Token::End));
            }
            at += c.len_utf8();
        }
    }
    found
}

/// Reads expressions; angles are in degrees.
struct Reader<'a> {
    tokens: &'a [Token],
}

impl Reader<'_> {
    fn next_is(&mut self, token: Token) -> bool {
        let is = self.tokens.first() == Some(&token);
        self.tokens = &self.tokens[usize::from(is)..];
        is
    }

    fn sum(&mut self) -> Option<f64> {
        let mut sum = self.product()?;
        loop {
            if self.next_is(Token::Sign('+')) {
                sum += self.product()?;
            } else if self.next_is(Token::Sign('-')) {
                sum -= self.product()?;
            } else {
                return Some(sum);
            }
        }
    }

    fn product(&mut self) -> Option<f64> {
        let mut product = self.factor()?;
        loop {
            if self.next_is(Token::Sign('*')) {
                product *= self.factor()?;
            } else if self.next_is(Token::Sign('/')) {
                product /= self.factor()?;
            } else if matches!(
                self.tokens.first(),
                Some(Token::Number(..) | Token::Function(_) | Token::Root(_) | Token::Sign('('))
            ) {
                product *= self.factor()?;
            } else {
                return Some(product);
            }
        }
    }

    fn factor(&mut self) -> Option<f64> {
        let (first, rest) = self.tokens.split_first()?;
        self.tokens = rest;
        let mut value = match *first {
            Token::Number(x, _) => x,
            Token::Sign('-') => -self.factor()?,
            Token::Sign('(') => {
                let sum = self.sum()?;
                self.next_is(Token::Sign(')')).then_some(sum)?
            }
            Token::Root(root) => self.factor()?.powf(root.recip()),
            Token::Function(name) => {
                let power = [2, 4].into_iter().find(|n| self.next_is(Token::Power(*n)));
                let angle = self.factor()?.to_radians();
                let value = match name {
                    's' => angle.sin(),
                    'c' => angle.cos(),
                    _ => angle.tan(),
                };
                value.powi(power.unwrap_or(1))
            }
            _ => return None,
        };
        loop {
            if self.next_is(Token::Power(2)) {
                value = value.powi(2);
            } else if self.next_is(Token::Power(4)) {
                value = value.powi(4);
            } else if self.next_is(Token::Percent) {
                value /= 100.0;
            } else if !self.next_is(Token::Degrees) {
                return Some(value);
            }
        }
    }
}

/// The value of a whole expression.
fn value(tokens: &[Token]) -> Option<f64> {
    let mut reader = Reader { tokens };
    let sum = reader.sum()?;
    reader.tokens.is_empty().then_some(sum)
}

/// A printed number, and half a unit of its last digit.
fn printed(tokens: &[Token]) -> Option<(f64, f64)> {
    let (sign, rest) = match tokens {
        [Token::Sign('-'), rest @ ..] => (-1.0, rest),
        rest => (1.0, rest),
    };
    let (x, decimals, scale) = match *rest {
        [Token::Number(x, decimals)] | [Token::Number(x, decimals), Token::Degrees] => {
            (x, decimals, 1.0)
        }
        [Token::Number(x, decimals), Token::Percent] => (x, decimals, 100.0),
        _ => return None,
    };
    Some((sign * x / scale, 0.5 * 10.0_f64.powi(-decimals) / scale))
}

fn bare(tokens: &[(usize, Token)]) -> Vec<Token> {
    tokens.iter().map(|(_, token)| *token).collect()
}

fn agree(value: f64, (x, half): (f64, f64)) -> bool {
    (value - x).abs() <= half * (1.0 + 1e-9) + 1e-12
}

/// The number of equations between numbers in a text, or a message about the first wrong one.
fn check_equations(text: &str, readings: [Option<f64>; 2]) -> Result<usize, String> {
    let tokens = tokens(text, readings);
    let mut checked = 0;
    for chain in tokens.split(|(_, token)| *token == Token::End) {
        let sides: Vec<&[(usize, Token)]> = chain
            .split(|(_, token)| *token == Token::Sign('='))
            .collect();
        for pair in sides.windows(2) {
            let (left, right) = (value(&bare(pair[0])), printed(&bare(pair[1])));
            if let (Some(left), Some(right)) = (left, right) {
                if !agree(left, right) {
                    return Err(format!("{left} is not {}: {text}", right.0));
                }
                checked += 1;
            }
        }
    }
    Ok(checked)
}

/// The value of the last side of the equation that follows a mark in a text.
fn last_side(text: &str, mark: &str, readings: [Option<f64>; 2]) -> Option<f64> {
    let (_, after) = text.split_once(mark)?;
    let tokens = tokens(after, readings);
    let chain = tokens.split(|(_, token)| *token == Token::End).next()?;
    let sides = chain.split(|(_, token)| *token == Token::Sign('='));
    sides.map(bare).rev().find_map(|side| value(&side))
}

/// Like [`check_equations`], for angles that are found from a sine, cosine or tangent.
fn check_inverses(text: &str) -> Result<usize, String> {
    type Inverse = fn(f64) -> f64;
    const INVERSES: [(&str, Inverse, &str); 8] = [
        ("sin θ₁ = ", f64::asin, "So θ₁ = "),
        ("tan θ₁ = ", f64::atan, "and θ₁ = "),
        ("tangent of the angle is ", f64::atan, "the angle is "),
        ("tan φ = ", f64::atan, ", φ = "),
        ("cosine of the angle is ", f64::acos, "the angle is "),
        (
            "sine of half the angle is ",
            f64::asin,
            "Half the angle is ",
        ),
        ("sin α = ", f64::asin, "so α = "),
        ("leaves along n: sin α = ", f64::asin, ", α = "),
    ];
    let mut checked = 0;
    for (mark, inverse, answer) in INVERSES {
        let Some((_, after)) = text.split_once(mark) else {
            continue;
        };
        let Some((_, angle)) = after.split_once(answer) else {
            continue;
        };
        let side = last_side(text, mark, [None; 2]).ok_or_else(|| format!("{mark}{text}"))?;
        let tokens = tokens(angle, [None; 2]);
        let chain = tokens.split(|(_, token)| *token == Token::End).next();
        // The angle may be the result of a calculation: "180° − 71.6° = 108.4°".
        let mut sides = chain
            .ok_or(text)?
            .rsplit(|(_, token)| *token == Token::Sign('='));
        let angle = sides.next().and_then(|it| printed(&bare(it))).ok_or(text)?;
        // An angle with a negative tangent is obtuse.
        let found = match inverse(side).to_degrees() {
            below if below < 0.0 => below + 180.0,
            found => found,
        };
        if !agree(found, angle) {
            return Err(format!("{mark}{side} gives {found}: {text}"));
        }
        checked += 1;
    }
    if let Some((_, after)) = text.split_once("sin(Θ − ") {
        let theta = after
            .split_once('°')
            .and_then(|it| it.0.parse::<f64>().ok());
        let sine = last_side(after, " = ", [None; 2]);
        let (theta, sine) = theta.zip(sine).ok_or(text)?;
        let (_, turn) = after.split_once("Θ = ").ok_or(text)?;
        let tokens = tokens(turn, [None; 2]);
        let turn = tokens.split(|(_, token)| *token == Token::End).next();
        let turn = turn.and_then(|it| printed(&bare(it))).ok_or(text)?;
        let found = theta + sine.asin().to_degrees();
        if !agree(found, turn) {
            return Err(format!("{sine} gives {found}: {text}"));
        }
        checked += 1;
    }
    Ok(checked)
}

/// The angles that a text gives: "θ₁ = 18.0°".
fn readings(text: &str) -> [Option<f64>; 2] {
    ["θ₁ = ", "θ₂ = "].map(|mark| {
        let (_, after) = text.split_once(mark)?;
        after.split_once('°')?.0.parse().ok()
    })
}

#[test]
fn printed_steps_give_the_printed_result() {
    let mut checked: BTreeMap<&str, usize> = BTreeMap::new();
    let mut wrong = Vec::new();
    for (family, seed, question) in questions(SEEDS) {
        let readings = readings(&question.text);
        let mut texts = vec![question.why.as_str()];
        texts.extend(question.beliefs.iter().map(|it| it.says.as_str()));
        texts.extend(question.replies.values().map(String::as_str));
        for text in texts {
            assert!(!text.contains(" - "), "{text}");
            for function in ["sin ", "cos ", "tan "] {
                for (at, _) in text.match_indices(function) {
                    let number = text[at + function.len()..]
                        .trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
                    let is_number = number.len() < text.len() - at - function.len();
                    assert!(!is_number || number.starts_with('°'), "{text}");
                }
            }
            let found =
                check_equations(text, readings).and_then(|found| Ok(found + check_inverses(text)?));
            match found {
                Ok(found) => *checked.entry(family.id()).or_default() += found,
                Err(message) => wrong.push(format!("{} {seed}: {message}", family.id())),
            }
        }
    }
    wrong.sort();
    wrong.dedup();
    let first: Vec<&String> = wrong.iter().take(40).collect();
    assert!(wrong.is_empty(), "{}: {first:#?}", wrong.len());
    for family in Family::ALL {
        let found = checked.get(family.id()).copied().unwrap_or(0);
        assert!(
            found >= 50,
            "{}: only {found} equations checked",
            family.id()
        );
    }
}

#[test]
fn the_checker_finds_wrong_equations() {
    let none = [None; 2];
    for (good, equations) in [
        ("So 90° − 35.0° = 55.0°.", 1),
        ("sin 60.0° / sin 30.0° = 1.732, and 1.732⁴ = 9.00.", 2),
        ("b = 30.0 mm × sin 30.0° = 15.0 mm.", 1),
        (
            "V is (20.0 × 3.00 − 40.0 × 2.00) g m/s / 60.0 g = −0.333 m/s.",
            1,
        ),
        ("The share is 0.367 × 0.634² = 14.8 %.", 1),
        ("Together: √(3.00² + 4.00²) = 5.00 m/s.", 1),
        ("It is ⁴√16 × sin 15.0° = 0.518.", 1),
        ("(1 + e) m₁ cos 30.0° / (m₁ + m₂) = 0.634 of it.", 0),
    ] {
        assert_eq!(check_equations(good, none), Ok(equations), "{good}");
    }
    for bad in [
        "1.14⁴ = 1.72.",
        "So 90° − 35.0° = 54.9°.",
        "2.00 m/s × cos 60.0° = 1.01 m/s.",
        "0.367 × 0.634² = 14.7 %.",
    ] {
        assert!(check_equations(bad, none).is_err(), "{bad}");
    }
    let read = [Some(60.0), Some(30.0)];
    let k = "k = sin θ₁ / (cos θ₂ sin(θ₁ + θ₂)) = 1.00 of it";
    assert_eq!(check_equations(k, read), Ok(1));
    assert_eq!(
        check_inverses("sin θ₁ = m₂ / m₁ = 0.500. So θ₁ = 30.0°."),
        Ok(1)
    );
    assert!(check_inverses("sin θ₁ = m₂ / m₁ = 0.500. So θ₁ = 31.0°.").is_err());
    let sum = "tan φ = 2.12 / (−0.707), φ = 108.4° to n.";
    assert_eq!(check_inverses(sum), Ok(1));
    assert!(check_inverses("tan φ = 2.12 / (−0.707), φ = 71.6° to n.").is_err());
    let tangent = "the tangent of the angle is 1.00 / 2.00, and the angle is 26.6°.";
    assert_eq!(check_inverses(tangent), Ok(1));
}
