//! The misconceptions in words, which stand in `assets/misconceptions.toml`.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

use crate::quiz::question::{Misconception, Passage};

/// What is said of a misconception.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Description {
    name: String,
    advice: String,
    chapter: String,
    page: String,
}

impl Misconception {
    /// Its name as shown: "always 90°".
    pub fn name(self) -> &'static str {
        &self.description().name
    }

    /// What to try next against it.
    pub fn advice(self) -> &'static str {
        &self.description().advice
    }

    /// The page of a chapter that settles it.
    pub(crate) fn settled_by(self) -> Passage {
        let Description { chapter, page, .. } = self.description();
        Passage { chapter, page }
    }

    fn description(self) -> &'static Description {
        static ALL: LazyLock<BTreeMap<String, Description>> = LazyLock::new(|| {
            let text = include_str!("../../../assets/misconceptions.toml");
            toml::from_str(text).unwrap_or_default()
        });
        static NONE: LazyLock<Description> = LazyLock::new(Description::default);
        ALL.get(self.id()).unwrap_or(&NONE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_misconception_is_described_and_nothing_else_is() {
        let text = include_str!("../../../assets/misconceptions.toml");
        let described: BTreeMap<String, toml::Table> = toml::from_str(text).unwrap();
        let described: Vec<&str> = described.keys().map(String::as_str).collect();
        let mut known: Vec<&str> = Misconception::ALL.iter().map(|it| it.id()).collect();
        known.sort_unstable();
        assert_eq!(described, known);
        for it in Misconception::ALL {
            let Description {
                name,
                advice,
                chapter,
                page,
            } = it.description();
            assert!(
                [name, advice, chapter, page]
                    .iter()
                    .all(|text| !text.is_empty()),
                "{name}"
            );
        }
    }
}
