//! Rewrites serde's messages about invalid values for people who write files.

/// A message from serde in plain words, with what was expected first: "expected a whole number, not
/// below 0, found NaN" for "invalid type: floating point `NaN`, expected usize".
pub(super) fn expectation(message: &str) -> String {
    let said = ["invalid type: ", "invalid value: "];
    let rest = said.iter().find_map(|start| message.strip_prefix(start));
    match rest.and_then(|rest| rest.rsplit_once(", expected ")) {
        Some((found, expected)) => format!("expected {}, found {}", wanted(expected), plain(found)),
        None => message.to_owned(),
    }
}

fn wanted(expected: &str) -> &str {
    match expected {
        "usize" | "u8" | "u16" | "u32" | "u64" => "a whole number, not below 0",
        "isize" | "i8" | "i16" | "i32" | "i64" => "a whole number",
        "f32" | "f64" => "a number",
        "a boolean" => "true or false",
        "a sequence" => "a list",
        "a map" => "a table",
        "a string" => "text in quotes",
        other => other,
    }
}

/// What was found, without the name of its type if that is obvious.
fn plain(found: &str) -> String {
    match found {
        "map" => "a table".into(),
        "sequence" => "a list".into(),
        other => {
            let types = ["floating point ", "integer ", "boolean ", "string "];
            let value = types.iter().find_map(|name| other.strip_prefix(name));
            value.unwrap_or(other).replace('`', "")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn serde_messages_become_plain_words() {
        for (said, shown) in [
            (
                "invalid type: floating point `NaN`, expected usize",
                "expected a whole number, not below 0, found NaN",
            ),
            (
                "invalid value: integer `-3`, expected u8",
                "expected a whole number, not below 0, found -3",
            ),
            (
                "invalid type: string \"x, expected y\", expected f64",
                "expected a number, found \"x, expected y\"",
            ),
            (
                "invalid type: map, expected a sequence",
                "expected a list, found a table",
            ),
            ("missing field `mass_g`", "missing field `mass_g`"),
        ] {
            assert_eq!(expectation(said), shown);
        }
    }
}
