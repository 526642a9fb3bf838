//! Properties of the terminal that are known before anything is drawn.

use std::io::{self, IsTerminal};

use supports_color::Stream;
use thiserror::Error;

use crate::widgets::{Charset, Depth};

/// Why carrom cannot be played here.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Unusable {
    /// Standard input or output is a file, a pipe or nothing.
    #[error("a terminal is needed, and {0} is not one")]
    NoTerminal(&'static str),
    /// The terminal cannot place text.
    #[error("a terminal that can place text is needed, and TERM is {0}")]
    Dumb(String),
}

/// Makes sure that there is a terminal to play in. `env` reads a variable of the
/// environment.
///
/// # Errors
/// Why not, with what to use instead.
pub fn check(env: impl Fn(&str) -> Option<String>) -> Result<(), Unusable> {
    if !io::stdin().is_terminal() {
        return Err(Unusable::NoTerminal("standard input"));
    }
    if !io::stdout().is_terminal() {
        return Err(Unusable::NoTerminal("standard output"));
    }
    match dumb(env) {
        Some(term) => Err(Unusable::Dumb(term)),
        None => Ok(()),
    }
}

/// What `TERM` says, if that rules a game out. Windows sets none and needs none.
fn dumb(env: impl Fn(&str) -> Option<String>) -> Option<String> {
    match env("TERM").filter(|term| !term.is_empty()) {
        None => cfg!(unix).then(|| "not set".into()),
        Some(term) => matches!(term.as_str(), "dumb" | "unknown").then_some(term),
    }
}

/// The richest glyphs to be trusted: Unicode where the locale is UTF-8. Windows has no
/// such locale; there its newer terminal, which says so by `WT_SESSION`, and editors that
/// name themselves find a font for every glyph, but its old console has no braille. `env`
/// reads a variable of the environment.
pub fn charset(env: impl Fn(&str) -> Option<String>) -> Charset {
    // The first that is set decides, as POSIX has it.
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"]
        .iter()
        .find_map(|name| env(name).filter(|value| !value.is_empty()));
    let utf8 = match locale {
        Some(locale) => {
            let locale = locale.to_ascii_lowercase();
            locale.contains("utf-8") || locale.contains("utf8")
        }
        None => {
            cfg!(windows)
                && ["WT_SESSION", "TERM_PROGRAM"]
                    .iter()
                    .any(|it| env(it).is_some())
        }
    };
    if utf8 {
        Charset::Unicode
    } else {
        Charset::Ascii
    }
}

/// How many colours standard output shows; none if the player wants none: if `NO_COLOR`
/// is set to anything at all, as no-color.org has it. `env` reads a variable of the
/// environment.
pub fn depth(env: impl Fn(&str) -> Option<String>) -> Depth {
    match env("NO_COLOR") {
        Some(set) if !set.is_empty() => return Depth::None,
        // What detects colours would take it for a wish.
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

/// How many colours a terminal shows that is named as this one is.
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
    fn only_an_empty_no_color_is_none() {
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
    fn the_first_locale_that_is_set_decides() {
        assert_eq!(charset(from(&[("LANG", "de_DE.UTF-8")])), Charset::Unicode);
        assert_eq!(charset(from(&[("LC_CTYPE", "C.utf8")])), Charset::Unicode);
        let overruled = from(&[("LANG", "de_DE.UTF-8"), ("LC_ALL", "C")]);
        assert_eq!(charset(overruled), Charset::Ascii);
        let empty = from(&[("LANG", "de_DE.UTF-8"), ("LC_ALL", "")]);
        assert_eq!(charset(empty), Charset::Unicode);
    }

    #[cfg(unix)]
    #[test]
    fn a_terminal_must_be_able_to_place_text() {
        assert_eq!(dumb(from(&[("TERM", "xterm-256color")])), None);
        assert_eq!(dumb(from(&[("TERM", "dumb")])).as_deref(), Some("dumb"));
        assert_eq!(dumb(from(&[])).as_deref(), Some("not set"));
        assert_eq!(charset(from(&[])), Charset::Ascii);
    }
}
