//! The page of rules for players, in `docs/rules.md`.

use super::Rules;

/// A line of the page of rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RuleLine {
    /// The heading of the rules that follow.
    Heading(&'static str),
    /// One rule, with the numbers of its laws.
    Rule(&'static str),
}

impl Rules {
    /// All sets of rules, in the order of the page.
    pub(crate) const ALL: [Self; 5] = [
        Self::Tournament,
        Self::Friendly,
        Self::Points,
        Self::Practice,
        Self::Solo,
    ];

    /// The rules, written for players who read them for the first time.
    pub(crate) fn page(self) -> impl Iterator<Item = RuleLine> {
        let all = include_str!("../../../docs/rules.md")
            .split("\n## ")
            .skip(1);
        let own = all.into_iter().nth(self as usize).unwrap_or_default();
        own.lines().filter_map(|line| {
            let heading = line.strip_prefix("### ").map(RuleLine::Heading);
            heading.or_else(|| line.strip_prefix("- ").map(RuleLine::Rule))
        })
    }
}
