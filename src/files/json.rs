//! Writes JSON.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::Formatter;

use super::is_invisible;

/// Writes one JSON object. Its strings may come from anyone and may be shown in a terminal, so
/// invisible and control characters are written as escapes, which any JSON parser decodes.
///
/// # Errors
/// Returns an error if the object cannot be written.
pub(crate) fn write_json(out: &mut impl Write, object: &impl Serialize) -> io::Result<()> {
    let mut serializer = Serializer::with_formatter(out, SafeFormatter);
    Ok(object.serialize(&mut serializer)?)
}

struct SafeFormatter;

impl Formatter for SafeFormatter {
    fn write_string_fragment<W: Write + ?Sized>(
        &mut self,
        out: &mut W,
        mut fragment: &str,
    ) -> io::Result<()> {
        while let Some((at, letter)) = { fragment.char_indices() }.find(|it| is_invisible(it.1)) {
            let (before, rest) = fragment.split_at(at);
            out.write_all(before.as_bytes())?;
            for unit in letter.encode_utf16(&mut [0; 2]) {
                write!(out, "\\u{unit:04x}")?;
            }
            fragment = rest.get(letter.len_utf8()..).unwrap_or_default();
        }
        out.write_all(fragment.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_cannot_control_a_terminal_and_is_read_back_unchanged() {
        let text = "a\u{1b}[2J\u{9b}31m \u{202e}\u{0}\u{1fffe}\"\\ 球";
        let mut written = Vec::new();
        write_json(&mut written, &text).unwrap();
        let written = String::from_utf8(written).unwrap();
        assert!(!written.chars().any(is_invisible), "{written:?}");
        assert_eq!(serde_json::from_str::<String>(&written).unwrap(), text);
    }
}
