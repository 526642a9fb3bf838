//! Reads a typed number.

use super::spoken::{means_unit, unit_name};

/// Reads a number from `least` to `most`. Its `unit` may follow; the unit of a pure number is
/// empty.
///
/// # Errors
/// A line that explains what was expected. carrom does not guess: it does not accept 1/2, 1 000, or
/// 5 cm for a length in millimetres.
pub(super) fn number(heard: &str, unit: &str, least: f64, most: f64) -> Result<f64, String> {
    let typed = heard.replace('−', "-");
    let (number, behind) = split(&typed).ok_or("Please type a number, such as 2.5.")?;
    let behind = behind.trim_start();
    if !(behind.is_empty() || means_unit(behind, unit)) {
        return Err(match unit {
            "" => "Please type a number alone, such as 2.5.".to_owned(),
            unit => format!("Please type a number in {}, such as 2.5.", unit_name(unit)),
        });
    }
    if !(least..=most).contains(&number) {
        return Err(format!("Please type a number from {least} to {most}."));
    }
    // This turns −0 into 0.
    Ok(number + 0.0)
}

/// The number at the start of a text, and the rest; `None` if there is no number, or if it is
/// ambiguous or out of range.
fn split(text: &str) -> Option<(f64, &str)> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    // Rust also reads "inf" and "nan".
    if !unsigned.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | ',')) {
        return None;
    }
    // It is unclear whether 1,500 means 1.5 or 1500.
    let whole = digits(unsigned);
    let fraction = unsigned[whole..].strip_prefix(',').map(digits);
    if fraction == Some(3) && (1..=3).contains(&whole) && !unsigned.starts_with('0') {
        return None;
    }
    let plain = text.replacen(',', ".", 1);
    let mut ends = (1..=text.len())
        .rev()
        .filter(|end| text.is_char_boundary(*end));
    let (number, end) = ends.find_map(|end| Some((plain[..end].parse::<f64>().ok()?, end)))?;
    let mantissa = plain[..end].split(['e', 'E']).next().unwrap_or_default();
    let is_nought = !mantissa.contains(|c| matches!(c, '1'..='9'));
    let is_held = number.is_finite() && (is_nought || number != 0.0);
    is_held.then_some((number, &text[end..]))
}

/// How many digits a text starts with.
fn digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_with_or_without_their_unit() {
        for (heard, unit, read) in [
            ("60", "°", 60.0),
            ("60.5°", "°", 60.5),
            ("-30 degrees", "°", -30.0),
            ("−30", "°", -30.0),
            ("-0", "°", 0.0),
            ("+2,5 m/s", "m/s", 2.5),
            ("2 meters per second", "m/s", 2.0),
            ("0,125", "m/s", 0.125),
            ("1500,125", "g", 1500.125),
            ("1e3", "g", 1000.0),
            ("2.5E-1g", "g", 0.25),
            (".5", "", 0.5),
            ("5.", "", 5.0),
            ("0e-999", "", 0.0),
            ("25 percent", "%", 25.0),
            ("3 times", "times", 3.0),
        ] {
            assert_eq!(number(heard, unit, -1e9, 1e9), Ok(read), "{heard}");
        }
    }

    #[test]
    fn an_invalid_number_is_refused_rather_than_truncated() {
        for heard in [
            "",
            "sixty",
            "NaN",
            "inf",
            "--3",
            "++1",
            "+-1",
            "1.2.3",
            ".",
            ",",
            "1/2",
            "1 000",
            "1,000",
            "1,234.5",
            "2*3",
            "0x1",
            "1_0",
            "1e999",
            "1e-400",
            "1e",
            "1e+",
            "e3",
            "1 e3",
            "5 cm",
            "5 kg",
            "60 m/s",
            "30 left",
            "½",
            "٣",
            "1²",
            "1-2",
            "1 2",
            "\u{fffd}",
            "1\u{a0}000",
        ] {
            let read = number(heard, "mm", -1e9, 1e9);
            assert!(
                read.is_err_and(|line| line.starts_with("Please type a number")),
                "{heard}"
            );
        }
        assert!(number("5 mm", "", 0.0, 9.0).is_err());
        assert_eq!(
            number("181", "°", -180.0, 180.0),
            Err("Please type a number from -180 to 180.".into())
        );
    }
}
