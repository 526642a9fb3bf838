//! The block elements that the terminal draws, judged by the name and version that it reports.
//!
//! tmux answers for itself, because it decides what reaches the terminal around it. Variables such
//! as `TERM_PROGRAM`, `VTE_VERSION` and `KITTY_WINDOW_ID` are not used: a terminal that is started
//! within another one inherits them.

use crate::widgets::Blocks;

/// The request for the name and version (XTVERSION). Most terminals that do not know it ignore it.
pub(super) const REQUEST: &str = "\x1b[>q";

/// The first two numbers of a version.
type Version = [u32; 2];

/// Terminals that draw sextants and octants themselves, whatever the font, each with the first
/// version that is known to draw sextants, and the first that is known to draw octants.
///
/// Terminals that draw these characters only if the font has them, such as Konsole, are not listed.
/// Nor is Windows Terminal, which has drawn sextants itself only since July 2026
/// (microsoft/terminal, pull request 20424).
const TERMINALS: [(&str, Version, Version); 5] = [
    // Sextants: notcurses, src/lib/termdesc.c. Octants: the changelog of kitty 0.40.0.
    ("kitty", [0, 20], [0, 40]),
    // ghostty-org/ghostty, pull request 5433 of January 2025, adds octants to the existing
    // sextants; for the version, see breferrari/vigia, issue 324.
    ("ghostty", [1, 1], [1, 2]),
    // Sextants: foot's author in pull request 1403 of notcurses. Octants: breferrari/vigia, issue
    // 324.
    ("foot", [1, 7], [1, 20]),
    // VTE reports one number: 8002 is 0.80.2. Sextants: notcurses in 2021. Octants:
    // breferrari/vigia, issue 324, names 0.78. VTE itself does not confirm this, so the version
    // after 0.78 is listed here.
    ("VTE", [6600, 0], [8000, 0]),
    // WezTerm's version begins with the day of its commit. Sextants: notcurses. Octants:
    // wezterm/wezterm, pull request 6502 of December 2024, which the changelog lists after the
    // release of 2024. The day of the merge is not known, so a day about a year later is listed
    // here.
    ("WezTerm", [20_210_610, 0], [20_260_101, 0]),
];

/// The finest block elements drawn by the terminal with this name and version, such as
/// `kitty(0.40.0)` or `ghostty 1.2.0`; quadrants if they are not known.
pub(super) fn blocks(reported: &str) -> Blocks {
    let known = || {
        let (name, numbers) = reported.split_once(['(', ' '])?;
        let (_, sextants, octants) = TERMINALS.iter().find(|(known, ..)| *known == name)?;
        let mut numbers = numbers.split(|letter: char| !letter.is_ascii_digit());
        let first = numbers.next()?.parse().ok()?;
        let second = numbers.next().and_then(|it| it.parse().ok());
        let version = [first, second.unwrap_or(0)];
        let drawn = [(octants, Blocks::Octants), (sextants, Blocks::Sextants)];
        let drawn = drawn.into_iter().find(|(since, _)| version >= **since);
        drawn.map(|(_, blocks)| blocks)
    };
    known().unwrap_or(Blocks::Quadrants)
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
            ("ghostty 1.0.1", Quadrants),
            ("foot(1.20.2)", Octants),
            ("foot(1.9.0)", Sextants),
            ("VTE(8002)", Octants),
            ("VTE(7802)", Sextants),
            ("WezTerm 20240203-110809-5046fc22", Sextants),
            ("WezTerm 20260301-000000-abcdef01", Octants),
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
