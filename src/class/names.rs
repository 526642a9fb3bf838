//! The names of teams.

use thiserror::Error;
use unicode_segmentation::UnicodeSegmentation;

use crate::files::tidy_name;

/// Most teams that play.
pub const MOST_TEAMS: usize = 8;

/// Most letters of a team's name.
pub const LONGEST_NAME: usize = 24;

/// Why these cannot be the names of the teams.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum NameTrouble {
    /// There is none.
    #[error("expected the names of 1 to {MOST_TEAMS} teams, found none")]
    None,
    /// There are too many.
    #[error("expected the names of 1 to {MOST_TEAMS} teams, found {0}")]
    TooMany(usize),
    /// Two are alike.
    #[error("expected names that differ, found \"{0}\" twice")]
    Twice(String),
}

/// Names as they are shown and kept: visible letters alone, no blanks at the ends, no more
/// than [`LONGEST_NAME`] letters; empty ones are left out.
///
/// # Errors
/// If no team is left, if there are more than [`MOST_TEAMS`], or if two are alike but
/// for their case.
pub fn team_names<'a>(
    names: impl IntoIterator<Item = &'a str>,
) -> Result<Vec<String>, NameTrouble> {
    let names: Vec<String> = names
        .into_iter()
        .map(tidy)
        .filter(|name| !name.is_empty())
        .collect();
    if names.is_empty() {
        return Err(NameTrouble::None);
    }
    if names.len() > MOST_TEAMS {
        return Err(NameTrouble::TooMany(names.len()));
    }
    for (i, name) in names.iter().enumerate() {
        let alike = |other: &String| other.to_lowercase() == name.to_lowercase();
        if names.iter().take(i).any(alike) {
            return Err(NameTrouble::Twice(name.clone()));
        }
    }
    Ok(names)
}

/// A name of at most so many letters.
fn tidy(name: &str) -> String {
    let name = tidy_name(name);
    let short: String = name.graphemes(true).take(LONGEST_NAME).collect();
    short.trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_tidied_and_told_apart() {
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
        let nine = ["a", "b", "c", "d", "e", "f", "g", "h", "i"];
        assert_eq!(team_names(nine), Err(NameTrouble::TooMany(9)));
    }
}
