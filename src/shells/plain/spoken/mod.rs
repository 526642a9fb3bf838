//! Text as it is read aloud.

mod functions;
mod signs;
mod units;

pub(super) use functions::is_function;
pub(super) use units::{means_unit, unit_name};

/// The marks around text that stays unchanged: Unicode's isolates.
const BEGIN: char = '\u{2068}';
const END: char = '\u{2069}';

/// The text on one line, trimmed, with its symbols and units as they are read aloud. The words for
/// them are ASCII; letters in names stay unchanged.
///
/// ```
/// use carrom::shells::plain::spoken;
/// assert_eq!(spoken("θ₁ = 63.4°, v₂ = 2.12 m/s"), "theta 1 equals 63.4 degrees, v 2 equals 2.12 metres per second");
/// ```
pub fn spoken(text: &str) -> String {
    let mut line = String::with_capacity(2 * text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(BEGIN) {
        let (kept, behind) = after.split_once(END).unwrap_or((after, ""));
        line += &spelt(before);
        line += &without_controls(kept);
        rest = behind;
    }
    line += &spelt(rest);
    line.trim().to_owned()
}

/// Marks a text that [`spoken`] leaves unchanged: a file name, an error, a code to type, or a text
/// that is already in words.
pub(super) fn verbatim(text: &str) -> String {
    format!("{BEGIN}{}{END}", without_controls(text))
}

/// A formula in words, which [`spoken`] then leaves unchanged: in a formula, m is a mass and not a
/// metre.
pub(super) fn spoken_formula(text: &str) -> String {
    verbatim(tidy(&signs::spell(text)).trim())
}

/// A name as a sentence.
pub(super) fn sentence(name: &str) -> String {
    match name.ends_with(['?', '.', '!']) {
        true => name.into(),
        false => format!("{name}."),
    }
}

/// Removes characters that could move a cursor, or that would end an unchanged part too early.
fn without_controls(text: &str) -> String {
    let marks = |c: &char| !matches!(*c, BEGIN | END);
    let blanked = |c: char| if c.is_control() { ' ' } else { c };
    text.chars().filter(marks).map(blanked).collect()
}

fn spelt(text: &str) -> String {
    tidy(&signs::spell(&units::spell(text)))
}

/// Leaves one space between two words, and none just inside brackets or before a comma or a full
/// stop. A space at either end stays, because more text may follow there.
fn tidy(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    let mut line = words.join(" ");
    for (apart, together) in [("( ", "("), (" )", ")"), (" ,", ",")] {
        line = line.replace(apart, together);
    }
    // The sentence may end in a symbol, as in "Forward is +."
    line = line.replace(" . ", ". ");
    if let Some(stopped) = line.strip_suffix(" .") {
        line = format!("{stopped}.");
    }
    with_ends(text, &line)
}

/// `line`, which was made from `text`, with a space at each end where `text` has one.
fn with_ends(text: &str, line: &str) -> String {
    let blank = |is_there: bool| if is_there { " " } else { "" };
    let before = blank(text.starts_with(char::is_whitespace));
    let after = blank(text.ends_with(char::is_whitespace) && !line.is_empty());
    format!("{before}{line}{after}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_and_units_are_read_aloud() {
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
            ("(60, 0) g m/s", "(60, 0) gram metres per second"),
            ("0.060 N s", "0.060 newton seconds"),
            ("in 0.6 ms: 100 N", "in 0.6 milliseconds: 100 newtons"),
            ("in g m/s?", "in gram metres per second?"),
            ("(1, −1) m/s", "(1, minus 1) metres per second"),
            ("44.4 rad/s", "44.4 radians per second"),
            (
                "30 mm · sin 45°",
                "30 millimetres times the sine of 45 degrees",
            ),
            ("Forward is +.", "Forward is plus."),
            (
                "v₁ = v₁ₙ n + v₁ₜ t",
                "v 1 equals v 1 n times n plus v 1 t times t",
            ),
            (
                "1 m/s, 1 g m/s, −1 mm, 1°, 21°, (1 g)",
                "1 metre per second, 1 gram metre per second, minus 1 millimetre, 1 degree, \
                 21 degrees, (1 gram)",
            ),
            (
                "4.00 cos 30.0 = 3.46 m/s",
                "4.00 times the cosine of 30.0 equals 3.46 metres per second",
            ),
            ("v₁² + v₂²", "v 1 squared plus v 2 squared"),
            ("m₁/(m₁ + m₂)", "m 1 over (m 1 plus m 2)"),
            ("2 m₁ / (m₁ + m₂)", "2 m 1 over (m 1 plus m 2)"),
            (
                "½ m₁u₁² = 1.23e−5 J",
                "one half m 1 u 1 squared equals 1.23 times 10 to the power minus 5 joules",
            ),
            ("1/sin⁴", "1 over the sine to the power 4"),
            (
                "1/sin⁴ (Θ/2)",
                "1 over the sine to the power 4 of (capital theta over 2)",
            ),
            (
                "cos² 30° and cot(Θ/2)",
                "the cosine squared of 30 degrees and the cotangent of (capital theta over 2)",
            ),
            ("sin α cos α", "the sine of alpha times the cosine of alpha"),
            (
                "using a tan, its sine is 2√3",
                "using a tan, its sine is 2 times the square root of 3",
            ),
            ("the 30 g disc, of 30 g", "the 30 gram disc, of 30 grams"),
            ("v₁·v₂ = u₁ · u₂", "v 1 dot v 2 equals u 1 dot u 2"),
            (
                "3m·√2 and 2·3",
                "3m times the square root of 2 and 2 times 3",
            ),
            ("dσ/dΩ", "d sigma over d omega"),
            ("E₁ : E₂", "E 1 to E 2"),
            ("yes and/or no: 3 m/s", "yes and/or no: 3 metres per second"),
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
    fn isolated_text_stays_unchanged() {
        let path = "/home/p/run-1=a_2*b/my  files/progress.db: found -1, +++ 2 m";
        let said = spoken(&format!("θ at {}: v = 2 m/s", verbatim(path)));
        assert_eq!(
            said,
            format!("theta at {path}: v equals 2 metres per second")
        );
        let twice = verbatim(&format!("a/{}\n/c", verbatim("b=1")));
        assert_eq!(spoken(&twice), "a/b=1 /c");
        assert_eq!(spoken(&format!("x{BEGIN}a=b")), "xa=b");
    }

    #[test]
    fn characters_that_move_a_cursor_are_removed() {
        let all: String = (0..0x3000).filter_map(char::from_u32).collect();
        for text in [spoken(&all), spoken(&verbatim(&all))] {
            assert!(text.chars().all(|c| !c.is_control()));
        }
    }

    #[test]
    fn a_name_gets_one_full_stop() {
        let said = ["Why?", "Stop!", "So.", "So"].map(sentence);
        assert_eq!(said, ["Why?", "Stop!", "So.", "So."]);
    }
}
