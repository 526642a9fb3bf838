//! The names of teams and of people.

use std::collections::BTreeSet;

use thiserror::Error;
use unicode_segmentation::UnicodeSegmentation;

use super::way::WayOfVoting;
use crate::files::{NO_NAME, is_blank_name, short_name};

/// The largest number of teams at one keyboard.
pub const MOST_TEAMS: usize = 8;

/// The largest number of people who can join on their own devices.
pub const MOST_PEOPLE: usize = 250;

/// The largest number of letters in a name.
pub const LONGEST_NAME: usize = 24;

/// Why a list of team names is invalid.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum NameTrouble {
    /// The list has no name.
    #[error("expected the names of 1 to {MOST_TEAMS} teams, found none")]
    None,
    /// The list has too many names: the number found, and the limit.
    #[error("expected at most {1} names, found {0}")]
    TooMany(usize, usize),
    /// Two names are the same, ignoring case.
    #[error("expected names that differ, found \"{0}\" twice")]
    Twice(String),
}

/// Tidies the names of teams for display and storage, and leaves out empty ones.
///
/// # Errors
/// If no team is left, if there are more than [`MOST_TEAMS`], or if two names are the same,
/// ignoring case.
pub fn team_names<'a>(
    names: impl IntoIterator<Item = &'a str>,
) -> Result<Vec<String>, NameTrouble> {
    match names_for(WayOfVoting::Teams, names)? {
        names if names.is_empty() => Err(NameTrouble::None),
        names => Ok(names),
    }
}

/// Tidies names for display and storage, for this way of voting; the list may be empty.
///
/// # Errors
/// If there are too many, or if two are the same, ignoring case.
pub(super) fn names_for<'a>(
    way: WayOfVoting,
    names: impl IntoIterator<Item = &'a str>,
) -> Result<Vec<String>, NameTrouble> {
    let names: Vec<String> = names
        .into_iter()
        .map(tidy)
        .filter(|name| !name.is_empty())
        .collect();
    if names.len() > way.most() {
        return Err(NameTrouble::TooMany(names.len(), way.most()));
    }
    let mut known = BTreeSet::new();
    match names.iter().find(|name| !known.insert(folded(name))) {
        Some(twice) => Err(NameTrouble::Twice(twice.clone())),
        None => Ok(names),
    }
}

/// A name, case-folded for comparison.
pub(super) fn folded(name: &str) -> String {
    name.to_lowercase()
}

/// Whether two names refer to the same class. Case is ignored, as in `carrom gather --class`.
pub(crate) fn is_same_class(one: &str, other: &str) -> bool {
    folded(&tidy(one)) == folded(&tidy(other))
}

/// Tidies a name for display and storage: removes invisible characters and surplus spaces, and
/// keeps at most [`LONGEST_NAME`] letters.
pub(super) fn tidy(name: &str) -> String {
    short_name(name, LONGEST_NAME)
}

/// A name from a file. A name without a visible letter, which earlier versions accepted, is
/// replaced by one that is not `taken`.
pub(super) fn kept_name(name: &str, taken: &[&str]) -> String {
    match is_blank_name(name) {
        true => free_name(NO_NAME, taken),
        false => name.to_owned(),
    }
}

/// The name, with a number if it is `taken`: "Ada 2".
pub(super) fn free_name(name: &str, taken: &[&str]) -> String {
    let taken: BTreeSet<String> = taken.iter().map(|it| folded(it)).collect();
    let numbered = |number: usize| {
        let number = format!(" {number}");
        let room = LONGEST_NAME - number.len();
        let start: String = name.graphemes(true).take(room).collect();
        format!("{}{number}", start.trim_end())
    };
    let mut all = std::iter::once(name.to_owned()).chain((2..).map(numbered));
    let free = all.find(|name| !taken.contains(&folded(name)));
    free.unwrap_or_else(|| name.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_tidied_and_duplicates_are_refused() {
        let names = team_names(["  Ada\n\x1b[31m ", "", "Bó\u{202e}b", "蟻"]);
        assert_eq!(names.unwrap(), ["Ada [31m", "Bób", "蟻"]);
        let long = "x".repeat(10_000);
        let names = team_names([long.as_str()]).unwrap();
        assert_eq!(names[0].chars().count(), LONGEST_NAME);
        assert_eq!(
            team_names(["Ada", "ADA"]),
            Err(NameTrouble::Twice("ADA".into()))
        );
        assert_eq!(team_names([" ", "\u{200b}"]), Err(NameTrouble::None));
        assert_eq!(team_names(["\u{2800}", "\u{3164}"]), Err(NameTrouble::None));
        let nine = ["a", "b", "c", "d", "e", "f", "g", "h", "i"];
        assert_eq!(team_names(nine), Err(NameTrouble::TooMany(9, 8)));
        assert_eq!(names_for(WayOfVoting::Devices, nine).unwrap().len(), 9);
    }

    #[test]
    fn the_second_ada_is_ada_2() {
        let taken = ["Ada", "ADA 2", "Bo"];
        assert_eq!(free_name("ada", &taken), "ada 3");
        assert_eq!(free_name("Cy", &taken), "Cy");
        let long = "x".repeat(LONGEST_NAME);
        let other = free_name(&long, &[&long]);
        assert_eq!(other.chars().count(), LONGEST_NAME);
        assert!(other.ends_with(" 2"));
    }

    #[test]
    fn names_with_unusual_characters_are_shortened() {
        let family = "👩‍👩‍👧‍👦".repeat(100);
        let zalgo = "Z\u{300}\u{301}\u{302}\u{303}".repeat(100);
        for name in [family, zalgo, "ﷺ".repeat(500)] {
            let tidy = tidy(&name);
            assert!(!tidy.is_empty() && tidy.len() <= 8 * LONGEST_NAME, "{tidy}");
            assert!(tidy.graphemes(true).count() <= LONGEST_NAME);
            assert_eq!(super::tidy(&tidy), tidy);
        }
    }
}
