//! Splits a line of a tape into its parts.

use std::fmt;

use crate::files::{LONGEST_QUOTE, escape_control, quoted};

/// A part of a line: a bare word or a string in quotes. `Display` writes it as it is quoted in
/// messages.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Token {
    /// A run of characters without a space.
    Word(String),
    /// A string in double quotes, with its escapes resolved.
    Text(String),
}

impl Token {
    /// The word; `None` for a string in quotes.
    pub(super) fn word(&self) -> Option<&str> {
        match self {
            Self::Word(word) => Some(word),
            Self::Text(_) => None,
        }
    }
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(word) => f.write_str(&escape_control(word, LONGEST_QUOTE)),
            Self::Text(text) => f.write_str(&quoted(text)),
        }
    }
}

/// The parts of a line; a `#` at the start of a part begins a comment.
///
/// # Errors
/// What is wrong with the line.
pub(super) fn parts(line: &str) -> Result<Vec<Token>, String> {
    let mut parts = Vec::new();
    let mut rest = line.trim_start();
    while !rest.is_empty() && !rest.starts_with('#') {
        let part;
        (part, rest) = match rest.strip_prefix('"') {
            Some(inner) => {
                let (text, after) = text(inner)?;
                if !after.is_empty() && !after.starts_with(char::is_whitespace) {
                    return Err("expected a space after the closing quote".into());
                }
                (Token::Text(text), after)
            }
            None => {
                let end = rest.find(char::is_whitespace).unwrap_or(rest.len());
                (Token::Word(rest[..end].to_owned()), &rest[end..])
            }
        };
        parts.push(part);
        rest = rest.trim_start();
    }
    Ok(parts)
}

/// The string up to the closing quote, and what comes after it.
fn text(inner: &str) -> Result<(String, &str), String> {
    let mut text = String::new();
    let mut letters = inner.chars();
    while let Some(letter) = letters.next() {
        text.push(match letter {
            '"' => return Ok((text, letters.as_str())),
            '\\' => match letters.next() {
                Some(same @ ('"' | '\\')) => same,
                Some('n') => '\n',
                Some('t') => '\t',
                Some(other) => {
                    return Err(format!(
                        "unknown escape \\{}; expected \\\", \\\\, \\n or \\t",
                        other.escape_debug()
                    ));
                }
                None => break,
            },
            other => other,
        });
    }
    Err("expected a closing double quote".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn word(word: &str) -> Token {
        Token::Word(word.into())
    }

    #[test]
    fn words_strings_and_comments_are_distinguished() {
        let expected = vec![word("Expect"), Token::Text("a # \"b\"\n\\".into())];
        assert_eq!(parts(r#" Expect  "a # \"b\"\n\\" # c "d"#), Ok(expected));
        assert_eq!(parts("   # all of it"), Ok(vec![]));
        assert_eq!(parts("F1#2 #3"), Ok(vec![word("F1#2")]));
    }

    #[test]
    fn invalid_strings_are_refused() {
        for (line, message) in [
            ("Type \"60", "expected a closing double quote"),
            ("Type \"60\\", "expected a closing double quote"),
            ("Type \"6\\0\"", "unknown escape \\0; expected"),
            ("Type \"6\"0", "expected a space after the closing quote"),
        ] {
            let error = parts(line).unwrap_err();
            assert!(error.starts_with(message), "{line}: {error}");
        }
    }
}
