//! Properties of the terminal that are known before anything is drawn.

use std::io::{self, IsTerminal};

use supports_color::Stream;

use crate::widgets::{Charset, Depth};

/// Checks that carrom can be played in this terminal. `env` reads an environment variable.
///
/// # Errors
/// The reason why it cannot be played here.
pub fn check(env: impl Fn(&str) -> Option<String>) -> Result<(), String> {
    let not_one = |name| format!("a terminal is needed, but {name} is not one");
    if !io::stdin().is_terminal() {
        return Err(not_one("standard input"));
    }
    if !io::stdout().is_terminal() {
        return Err(not_one("standard output"));
    }
    dumb(env).map_or(Ok(()), |term| {
        Err(format!(
            "a terminal that can position text is needed, but TERM is {term}"
        ))
    })
}

/// The value of `TERM`, or "not set", if carrom cannot be played with it. Windows neither sets nor
/// needs `TERM`.
fn dumb(env: impl Fn(&str) -> Option<String>) -> Option<String> {
    match env("TERM").filter(|term| !term.is_empty()) {
        None => cfg!(unix).then(|| "not set".into()),
        Some(term) => matches!(term.as_str(), "dumb" | "unknown").then_some(term),
    }
}

/// The richest charset that will display correctly: Unicode if the locale is UTF-8. Windows has no
/// such locale. Its newer terminal, which sets `WT_SESSION`, and editors that set
/// `TERM_PROGRAM` find a font for every glyph, but the old console has no braille. `env` reads an
/// environment variable.
pub fn charset(env: impl Fn(&str) -> Option<String>) -> Charset {
    // POSIX: the first of these variables that is set and not empty decides.
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"]
        .iter()
        .find_map(|name| env(name).filter(|value| !value.is_empty()));
    let is_set = |name| env(name).is_some();
    let has_unicode = match locale.map(|it| it.to_ascii_lowercase()) {
        Some(locale) => locale.contains("utf-8") || locale.contains("utf8"),
        None => cfg!(windows) && (is_set("WT_SESSION") || is_set("TERM_PROGRAM")),
    };
    match has_unicode {
        true => Charset::Unicode,
        false => Charset::Ascii,
    }
}

/// How many colours standard output shows; none if `NO_COLOR` is set and not empty (see
/// no-color.org). `env` reads an environment variable.
pub fn depth(env: impl Fn(&str) -> Option<String>) -> Depth {
    match env("NO_COLOR") {
        Some(set) if !set.is_empty() => return Depth::None,
        // The library that detects colours would take an empty value as a request for no colours.
        Some(_) => return depth_by_name(env),
        None => {}
    }
    match supports_color::on(Stream::Stdout) {
        Some(level) if level.has_16m => Depth::True,
        Some(level) if level.has_256 => Depth::Indexed256,
        Some(_) => Depth::Ansi16,
        None => Depth::None,
    }
}

/// How many colours this terminal shows, judged by `COLORTERM` and `TERM`.
fn depth_by_name(env: impl Fn(&str) -> Option<String>) -> Depth {
    let named = |name| env(name).unwrap_or_default();
    if matches!(named("COLORTERM").as_str(), "truecolor" | "24bit") {
        Depth::True
    } else if named("TERM").contains("256") {
        Depth::Indexed256
    } else {
        Depth::Ansi16
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn from(pairs: &'static [(&'static str, &'static str)]) -> impl Fn(&str) -> Option<String> {
        move |wanted| {
            let found = pairs.iter().find(|(name, _)| *name == wanted);
            found.map(|(_, value)| (*value).to_owned())
        }
    }

    #[test]
    fn only_an_empty_no_color_is_ignored() {
        for set in ["1", "0", "no"] {
            let with = |name: &str| (name == "NO_COLOR").then(|| set.to_owned());
            assert_eq!(depth(with), Depth::None);
        }
        let empty = from(&[("NO_COLOR", ""), ("TERM", "xterm-256color")]);
        assert_eq!(depth(empty), Depth::Indexed256);
        let empty = from(&[("NO_COLOR", ""), ("TERM", "linux")]);
        assert_eq!(depth(empty), Depth::Ansi16);
    }

    #[test]
    fn the_first_locale_variable_that_is_set_decides() {
        assert_eq!(charset(from(&[("LANG", "de_DE.UTF-8")])), Charset::Unicode);
        assert_eq!(charset(from(&[("LC_CTYPE", "C.utf8")])), Charset::Unicode);
        let overruled = from(&[("LANG", "de_DE.UTF-8"), ("LC_ALL", "C")]);
        assert_eq!(charset(overruled), Charset::Ascii);
        let empty = from(&[("LANG", "de_DE.UTF-8"), ("LC_ALL", "")]);
        assert_eq!(charset(empty), Charset::Unicode);
    }

    #[cfg(unix)]
    #[test]
    fn a_terminal_must_be_able_to_position_text() {
        assert_eq!(dumb(from(&[("TERM", "xterm-256color")])), None);
        assert_eq!(dumb(from(&[("TERM", "dumb")])).as_deref(), Some("dumb"));
        assert_eq!(dumb(from(&[])).as_deref(), Some("not set"));
        assert_eq!(charset(from(&[])), Charset::Ascii);
    }
}
