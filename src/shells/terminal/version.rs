//! Which block elements the terminal draws, judged by the name and version that it reports.
//!
//! Terminals report only those of the innermost terminal: tmux and Zellij answer themselves, and
//! GNU Screen does not answer. Variables such as `TERM_PROGRAM`, `VTE_VERSION` and
//! `KITTY_WINDOW_ID` are not used, because programs started in such a terminal inherit them,
//! including other terminals. Windows Terminal does not report a version, and its glyphs are those
//! of the font.

use crate::widgets::Blocks;

/// The request for the name and version (XTVERSION). Terminals that do not know it ignore it.
pub(super) const REQUEST: &str = "\x1b[>q";

/// Two leading numbers of a version.
type Version = [u32; 2];

/// A terminal that draws sextants and octants itself, whatever the font.
struct Drawing {
    name: &'static str,
    /// The first version with sextants.
    sextants: Version,
    /// The first version with octants; `None` if there is none for certain.
    octants: Option<Version>,
}

/// The sources: for sextants src/lib/termdesc.c of notcurses, unless given below.
const DRAWINGS: [Drawing; 6] = [
    // Octants: kitty's changelog, 0.40.0: "Add support for the octant box-drawing characters".
    Drawing {
        name: "kitty",
        sextants: [0, 20],
        octants: Some([0, 40]),
    },
    // Sextants since the first release. Octants: pull request 5433, opened on the day of 1.1.0.
    Drawing {
        name: "ghostty",
        sextants: [1, 0],
        octants: Some([1, 2]),
    },
    // Sextants: the author of foot in pull request 1403 of notcurses. Octants: vigia, issue 324,
    // which tried it.
    Drawing {
        name: "foot",
        sextants: [1, 7],
        octants: Some([1, 20]),
    },
    // The version is one number: 8002 is 0.80.2. Octants: vigia, issue 324, names 0.78; its source
    // is not known, so one version later.
    Drawing {
        name: "VTE",
        sextants: [6200, 0],
        octants: Some([8000, 0]),
    },
    // The version is a day. Octants: pull request 6502 of December 2024, listed in the changelog
    // for builds after the release 20240203; the day of the merge is not known, so later.
    Drawing {
        name: "WezTerm",
        sextants: [20_210_610, 0],
        octants: Some([20_260_101, 0]),
    },
    // Sextants were corrected in pull request 482 of October 2021.
    Drawing {
        name: "contour",
        sextants: [0, 3],
        octants: None,
    },
];

/// The finest block elements that a terminal with this name and version draws in every font, such
/// as `kitty(0.40.0)` or `ghostty 1.2.0`.
pub(super) fn blocks(reported: &str) -> Blocks {
    let Some((name, numbers)) = reported.split_once(['(', ' ']) else {
        return Blocks::default();
    };
    let mut numbers = numbers
        .split(|letter: char| !letter.is_ascii_digit())
        .map(|number| number.parse().ok());
    let Some(first) = numbers.next().flatten() else {
        return Blocks::default();
    };
    let version = [first, numbers.next().flatten().unwrap_or(0)];
    let drawing = DRAWINGS.iter().find(|drawing| drawing.name == name);
    match drawing {
        Some(Drawing {
            octants: Some(from),
            ..
        }) if version >= *from => Blocks::Octants,
        Some(drawing) if version >= drawing.sextants => Blocks::Sextants,
        _ => Blocks::Quadrants,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_known_versions_get_finer_blocks() {
        use Blocks::{Octants, Quadrants, Sextants};
        for (reported, expected) in [
            ("kitty(0.40.0)", Octants),
            ("kitty(0.39.1)", Sextants),
            ("kitty(1.0)", Octants),
            ("kitty(0.19.2)", Quadrants),
            ("ghostty 1.2.0-main+abc", Octants),
            ("ghostty 1.1.3", Sextants),
            ("foot(1.20.2)", Octants),
            ("foot(1.9.0)", Sextants),
            ("VTE(8002)", Octants),
            ("VTE(7802)", Sextants),
            ("WezTerm 20240203-110809-5046fc22", Sextants),
            ("WezTerm 20260301-000000-abcdef01", Octants),
            ("contour 0.4.3", Sextants),
            ("tmux 3.5a", Quadrants),
            ("XTerm(390)", Quadrants),
            ("Konsole 24.08.0", Quadrants),
            ("iTerm2 3.5.0", Quadrants),
            // Not a version.
            ("", Quadrants),
            ("kitty", Quadrants),
            ("kitty(", Quadrants),
            ("kitty()", Quadrants),
            ("kitty(x)", Quadrants),
            ("kitty(-1.40)", Quadrants),
            ("kitty(99999999999999999999.40)", Quadrants),
            ("kitty(0.99999999999999999999)", Quadrants),
            (" kitty(0.40.0)", Quadrants),
            ("Kitty(0.40.0)", Quadrants),
        ] {
            assert_eq!(blocks(reported), expected, "{reported}");
        }
    }
}
