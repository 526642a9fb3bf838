//! Units as they are read aloud and as they are typed.

/// The written units, with their singular and plural names in speech.
const UNITS: [(&str, &str, &str); 20] = [
    ("m/s", "metre per second", "metres per second"),
    ("rad/s", "radian per second", "radians per second"),
    ("mm", "millimetre", "millimetres"),
    ("mm²", "square millimetre", "square millimetres"),
    ("cm", "centimetre", "centimetres"),
    ("m", "metre", "metres"),
    ("g", "gram", "grams"),
    ("kg", "kilogram", "kilograms"),
    ("mJ", "millijoule", "millijoules"),
    ("J", "joule", "joules"),
    ("MeV", "mega electron volt", "mega electron volts"),
    ("fm", "femtometre", "femtometres"),
    ("µm", "micrometre", "micrometres"),
    ("s", "second", "seconds"),
    ("ms", "millisecond", "milliseconds"),
    ("N", "newton", "newtons"),
    ("°", "degree", "degrees"),
    ("deg", "degree", "degrees"),
    ("%", "percent", "percent"),
    ("times", "time", "times"),
];

/// The nouns that can follow a mass: "a 15 gram coin".
const DISCS: [&str; 6] = ["disc", "discs", "coin", "marble", "striker", "target"];

/// Whether a unit is in the singular or the plural.
#[derive(Clone, Copy, PartialEq)]
enum Count {
    One,
    Many,
}

/// Replaces the units after numbers in a text with words.
pub(super) fn spell(text: &str) -> String {
    let mut words: Vec<String> = Vec::new();
    let mut tokens = text.split_whitespace().peekable();
    let mut count = None;
    while let Some(token) = tokens.next() {
        let (bare, stop) = without_stop(token);
        let next = tokens.peek().map(|next| without_stop(next).0);
        let is_factor = match bare {
            "g" | "kg" => next == Some("m/s"),
            "N" => next == Some("s"),
            _ => false,
        };
        let name = match (count, bare) {
            _ if is_factor && stop.is_empty() => {
                // Only the last part of the unit can be plural: "gram metres per second".
                words.extend(name(bare, Count::One).map(str::to_owned));
                continue;
            }
            (Some(_), unit) if next.is_some_and(|next| DISCS.contains(&next)) => {
                name(unit, Count::One)
            }
            (Some(count), unit) => name(unit, count),
            // A unit that cannot be a symbol in a formula: "in mm".
            (None, unit @ ("m/s" | "mm" | "cm" | "kg")) => name(unit, Count::Many),
            (None, _) => None,
        };
        count = counted(token);
        words.push(match name {
            Some(name) => format!("{name}{stop}"),
            None => token.to_owned(),
        });
    }
    super::with_ends(text, &words.join(" "))
}

/// A unit as it is read aloud: "m/s" as "metres per second", "g m/s" as "gram metres per
/// second".
pub(in crate::shells::plain) fn unit_name(unit: &str) -> String {
    let counted = spell(&format!("2 {unit}"));
    counted.strip_prefix("2 ").unwrap_or(unit).to_owned()
}

/// Whether the typed text is this unit, as a symbol or as a name.
pub(in crate::shells::plain) fn means_unit(typed: &str, unit: &str) -> bool {
    let usual = |text: &str| {
        let words: Vec<String> = text.split_whitespace().map(str::to_lowercase).collect();
        let text = words.join(" ").replace("meter", "metre");
        match text.as_str() {
            "°" | "deg" | "degree" => "degrees".to_owned(),
            "per cent" | "%" => "percent".to_owned(),
            "x" | "×" | "time" => "times".to_owned(),
            _ => text,
        }
    };
    let one = spell(&format!("1 {unit}"));
    let names = [unit, &unit_name(unit), one.trim_start_matches("1 ")];
    names.iter().any(|name| usual(name) == usual(typed))
}

/// Whether a unit after this token is singular or plural; `None` if the token is not a number.
fn counted(token: &str) -> Option<Count> {
    // The last number in a pair also counts: "(60, 0) g m/s".
    let number = token
        .trim_start_matches(['(', '"', '“'])
        .trim_end_matches(')');
    let part = |c: char| c.is_ascii_digit() || "+-−±√×·/.,≈=⁰¹²³⁴⁵⁶⁷⁸⁹⁻e".contains(c);
    let is_number = number.chars().all(part)
        && number.contains(|c: char| c.is_ascii_digit())
        && !number.starts_with('e')
        && !number.ends_with(['.', ',']);
    let is_pair = token.ends_with(')') && !token.starts_with('(');
    is_number.then(|| match number.trim_start_matches(['-', '−']) {
        "1" if !is_pair => Count::One,
        _ => Count::Many,
    })
}

/// A word and the punctuation after it.
fn without_stop(word: &str) -> (&str, &str) {
    let bare = word.trim_end_matches([',', '.', ';', ':', ')', '?', '!', '"', '”']);
    (bare, &word[bare.len()..])
}

fn name(unit: &str, count: Count) -> Option<&'static str> {
    let (_, one, many) = UNITS.iter().find(|(sign, ..)| *sign == unit)?;
    Some(match count {
        Count::One => one,
        Count::Many => many,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_names() {
        assert_eq!(unit_name("m/s"), "metres per second");
        assert_eq!(unit_name("g m/s"), "gram metres per second");
        assert_eq!(unit_name("°"), "degrees");
        assert_eq!(unit_name("u"), "u");
    }

    #[test]
    fn units_can_be_typed_in_many_ways() {
        for (typed, unit) in [
            ("m/s", "m/s"),
            ("M/S", "m/s"),
            ("meters  per second", "m/s"),
            ("metre per second", "m/s"),
            ("deg", "°"),
            ("Degrees", "°"),
            ("gram", "g"),
            ("gram metres per second", "g m/s"),
            ("per cent", "%"),
            ("×", "times"),
        ] {
            assert!(means_unit(typed, unit), "{typed}");
        }
        for (typed, unit) in [
            ("cm", "mm"),
            ("kg", "g"),
            ("m", ""),
            ("/2", "°"),
            ("°", "%"),
        ] {
            assert!(!means_unit(typed, unit), "{typed}");
        }
    }
}
